// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "method.hpp"
#include "newton_direction.hpp"

#include <memory>

namespace funicular {

/// The paper's relaxation (section 2.2): no inertia, forces displace nodes directly, and the loads are those
/// of the present shape in every iteration.
///
/// Each node moves by r_i / (stiffness at the node). With D_i = sum of k_e over its members, the tangent's
/// eigenvalues relative to D are at most 2 (Gershgorin), whichever members are taut, so that a step below r_i
/// / D_i is stable.
class Relaxation final : public Iteration {
public:
    explicit Relaxation(const Equilibrium &equilibrium);

    /// Known only where the residual is small, as it takes a factorisation.
    [[nodiscard]] double position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) override;
    Move move(Points &x, Equilibrium &equilibrium) override;

private:
    Eigen::VectorXd mobility_; ///< one for each node
    Points motion_;
    std::unique_ptr<NewtonDirection> direction_;
    long since_check_ = 0;
    double next_check_ =
        std::numeric_limits<double>::infinity(); ///< residual below which the error is looked at again
};

} // namespace funicular
