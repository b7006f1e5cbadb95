// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "method.hpp"
#include "tangent_equations.hpp"

#include <limits>
#include <memory>

namespace funicular {

/// The Newton step d of K d = r, K the tangent stiffness with the loads' own dependence on the shape.
///
/// K is not symmetric, because heavier follows from longer and larger. Its part from the members, made
/// positive definite by a notional pull, is what the preconditioner is made for; conjugate residuals on K
/// itself do the rest.
class NewtonDirection {
public:
    /// Factorises.
    explicit NewtonDirection(const Equilibrium &equilibrium);
    /// Uses this preconditioner for as long as it serves, and factorises then.
    explicit NewtonDirection(std::unique_ptr<Preconditioner> preconditioner);

    /// Computes d at x, where the equilibrium was evaluated, as exactly as the goal calls for. With d, r·d >
    /// 0: the residual does work along it.
    void compute(const Points &x, Equilibrium &equilibrium, const Goal &goal);

    /// The notional pull per length that members were under at least.
    [[nodiscard]] double floor() const { return floor_; }
    /// Along the free directions.
    [[nodiscard]] const Eigen::VectorXd &unknowns() const { return direction_; }
    /// As motion of the nodes.
    [[nodiscard]] const Points &motion() const { return motion_; }
    /// Largest motion of a node.
    [[nodiscard]] double largest_motion() const { return largest_motion_; }
    /// Whether K d = r was solved. If not, d is the step of the members' part alone, and says nothing of the
    /// position error.
    [[nodiscard]] bool is_newton_step() const { return is_newton_step_; }

private:
    bool prepare_factor(const Points &x, Equilibrium &equilibrium, double floor);
    bool iterate(const Points &x, Equilibrium &equilibrium, double floor, double accuracy,
                 int most_iterations);
    bool solve_directly(const Points &x, Equilibrium &equilibrium, double floor);

    std::unique_ptr<Preconditioner> preconditioner_;
    bool is_factor_;
    /// Whether a factor has served its time.
    bool is_stale_ = true;
    double prepared_at_ = std::numeric_limits<double>::infinity();
    TangentEquations equations_;
    LinearProgress progress_;
    Eigen::VectorXd direction_;
    Points motion_;
    double floor_ = 0;
    double largest_motion_ = 0;
    bool is_newton_step_ = false;
};

} // namespace funicular
