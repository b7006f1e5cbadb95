// SPDX-License-Identifier: LGPL-2.1-or-later
#include "relaxation.hpp"

#include <algorithm>

namespace funicular {

namespace {

// Below one, as the loads' dependence on the shape adds a little to the eigenvalues.
constexpr double part_of_stable_step = 0.9;
// At the level of rounding the residual falls no further, and the error is looked at all the same.
constexpr long most_between_checks = 1000;

} // namespace

Relaxation::Relaxation(const Equilibrium &equilibrium) : motion_(equilibrium.scene().net().node_count(), 3) {
    const Eigen::VectorXd &stiffness = equilibrium.nodal_stiffness();
    // A node without members is held in every direction, and does not move.
    mobility_ = (stiffness.array() > 0).select(part_of_stable_step / stiffness.array(), 0.0);
}

double Relaxation::position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    ++since_check_;
    if (equilibrium.significant_residual() > goal.tolerance ||
        (equilibrium.relative_residual() > next_check_ && since_check_ < most_between_checks))
        return unknown;
    since_check_ = 0;
    if (!direction_)
        direction_ = std::make_unique<NewtonDirection>(equilibrium);
    direction_->compute(x, equilibrium, goal);
    next_check_ = equilibrium.relative_residual() / 2;
    return direction_->is_newton_step() ? direction_->largest_motion() : unknown;
}

Iteration::Move Relaxation::move(Points &x, Equilibrium &equilibrium) {
    equilibrium.scene().freedoms().expand(equilibrium.residual(), motion_);
    x += mobility_.asDiagonal() * motion_;
    equilibrium.evaluate(x);
    return Move::made;
}

} // namespace funicular
