// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tangent_equations.hpp"

namespace funicular {

LinearProgress TangentEquations::solve(const Points &x, Equilibrium &equilibrium, Loads loads,
                                       Preconditioner &preconditioner, const Eigen::VectorXd &right,
                                       double accuracy, int most_iterations, Eigen::VectorXd &unknowns) {
    const Freedoms &freedoms = equilibrium.scene().freedoms();
    motion_.resize(x.rows(), 3);
    return conjugate_residuals_.solve(
        [&](const Eigen::VectorXd &moved, Eigen::VectorXd &image) {
            freedoms.expand(moved, motion_);
            if (loads == Loads::following)
                equilibrium.tangent_product(x, motion_, product_);
            else
                equilibrium.member_product(motion_, product_);
            freedoms.reduce(product_, image);
        },
        [&](const Eigen::VectorXd &unbalanced, Eigen::VectorXd &moved) {
            preconditioner.apply(unbalanced, moved);
        },
        right, accuracy, most_iterations, unknowns);
}

} // namespace funicular
