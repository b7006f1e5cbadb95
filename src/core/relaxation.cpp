// SPDX-License-Identifier: LGPL-2.1-or-later
#include "relaxation.hpp"

#include <algorithm>

namespace funicular {

namespace {

// Below one, as the loads' dependence on the shape adds a little to the eigenvalues.
constexpr double part_of_stable_step = 0.9;

} // namespace

Relaxation::Relaxation(const Equilibrium &equilibrium) : motion_(equilibrium.scene().net().node_count(), 3) {
    const Scene &scene = equilibrium.scene();
    Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(scene.net().node_count());
    for (Index e = 0; e < scene.net().member_count(); ++e)
        for (const Index end : scene.net().members()[e])
            stiffness[end] += scene.axial().stiffness()[e];
    for (const auto &support : scene.elastic_supports())
        stiffness[support.node] += support.stiffness.diagonal().maxCoeff();
    // A node without members or springs is held, and does not move.
    mobility_ = (stiffness.array() > 0).select(part_of_stable_step / stiffness.array(), 0.0);
}

double Relaxation::position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    if (!residual_is_small(equilibrium, goal) || equilibrium.relative_residual() > next_check_)
        return unknown;
    if (!direction_)
        direction_ = std::make_unique<NewtonDirection>(equilibrium);
    direction_->compute(x, equilibrium);
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
