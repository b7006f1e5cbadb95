// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"

namespace funicular {

/// What holds a net that its supports let slide or turn as a whole, as part of the notional pull of members.
/// Small enough not to bend the smooth modes of a net of a thousand members across.
inline constexpr double notional_ground = 1e-6;

/// Something that comes near to the inverse of the tangent stiffness and is cheap to apply.
class Preconditioner {
public:
    Preconditioner() = default;
    Preconditioner(const Preconditioner &) = delete;
    Preconditioner &operator=(const Preconditioner &) = delete;
    virtual ~Preconditioner() = default;

    /// Makes it for the members' tangent at x, each member under a pull of `floor` per length at least.
    /// \pre equilibrium was linearised at x
    /// \returns whether rounding left it positive definite
    virtual bool prepare(const Points &x, const Equilibrium &equilibrium, double floor) = 0;
    /// The motion that it gives for a residual, both along the free directions.
    virtual void apply(const Eigen::VectorXd &residual, Eigen::VectorXd &motion) = 0;
};

} // namespace funicular
