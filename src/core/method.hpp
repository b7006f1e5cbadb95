// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"

#include <limits>

namespace funicular {

/// When a shape is good enough.
struct Goal {
    double tolerance = 1e-6; ///< relative residual
    double accuracy = 1e-3;  ///< position error, in the scene's own units
};

/// One way of moving a shape towards equilibrium. The loop in Solver measures, decides, and moves; a method
/// does the rest.
class Iteration {
public:
    Iteration() = default;
    Iteration(const Iteration &) = delete;
    Iteration &operator=(const Iteration &) = delete;
    virtual ~Iteration() = default;

    /// How far x still is from equilibrium: the largest node's |K⁻¹ r|. Infinite while the method need not
    /// know.
    ///
    /// \pre equilibrium was evaluated at x
    [[nodiscard]] virtual double position_error(const Points &x, Equilibrium &equilibrium,
                                                const Goal &goal) = 0;

    enum class Move { made, impossible };
    /// Moves x and evaluates there.
    ///
    /// \pre position_error was asked at x
    virtual Move move(Points &x, Equilibrium &equilibrium) = 0;
    /// Begins anew, with another scene on the same net and supports, and keeps what is still of use.
    /// \returns whether it can
    [[nodiscard]] virtual bool restart() { return false; }
    /// Whether it went back to the start shape after what came of it at first led to nothing.
    [[nodiscard]] virtual bool has_begun_anew() const { return false; }
};

} // namespace funicular
