// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"

#include <vector>

namespace funicular {

/// Brings the few nodes that are far more out of balance than the rest to rest among their neighbours.
///
/// Where a net is flat or members are about to go slack, as in the corners of a sheet, the tangent holds for
/// short steps only, and those few nodes would make every step of the whole net a short one. Node by node
/// they are settled at little cost (nonlinear elimination: Cai and Keyes, "Nonlinearly preconditioned inexact
/// Newton algorithms", 2002, and Lanzkron, Rose and Wilkes, 1996).
class LocalSettling {
public:
    explicit LocalSettling(const Net &net);

    /// Moves x, and evaluates there if it did. The residual is no larger after it.
    void settle(Points &x, Equilibrium &equilibrium, double floor);

private:
    void sweep(Points &x, const Equilibrium &equilibrium, double floor);

    std::vector<Index> first_;
    std::vector<Index> members_;
    std::vector<Index> restless_;
    Points kept_;
};

} // namespace funicular
