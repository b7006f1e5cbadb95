// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"
#include "krylov.hpp"
#include "preconditioner.hpp"

namespace funicular {

/// The equations K u = r along the free directions, K the tangent that an equilibrium keeps, solved by
/// conjugate residuals without a matrix of K. Keeps its memory from one solve to the next.
class TangentEquations {
public:
    /// Whether K has the loads' own dependence on the shape.
    enum class Loads { as_they_are, following };

    /// \param accuracy of |r - K u| / |r|
    /// \param unknowns u: zero, or what is known of it
    /// \pre the equilibrium was linearised at x, and its loads too if they follow
    LinearProgress solve(const Points &x, Equilibrium &equilibrium, Loads loads,
                         Preconditioner &preconditioner, const Eigen::VectorXd &right, double accuracy,
                         int most_iterations, Eigen::VectorXd &unknowns);

private:
    ConjugateResiduals conjugate_residuals_;
    Points motion_, product_;
};

} // namespace funicular
