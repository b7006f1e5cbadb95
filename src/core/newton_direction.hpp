// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_matrix.hpp"
#include "equilibrium.hpp"

#include <Eigen/SparseCholesky>

namespace funicular {

/// The Newton step d of K d = r, K the tangent stiffness with the loads' own dependence on the shape.
///
/// K is not symmetric, because heavier follows from longer and larger. Its part from the members, made
/// positive definite by a notional pull, is factorised (LDLᵀ); the rest is a small disturbance that an
/// iteration preconditioned by that factor (BiCGSTAB) takes care of in a few steps.
class NewtonDirection {
public:
    explicit NewtonDirection(const Equilibrium &equilibrium);

    /// Computes d at x, where the equilibrium was evaluated. With d, r·d > 0: the residual does work along
    /// it.
    void compute(const Points &x, Equilibrium &equilibrium);

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
    bool factorise(const Points &x, Equilibrium &equilibrium, double floor);
    bool solve_full_tangent(const Points &x, Equilibrium &equilibrium, double floor);

    BlockMatrix member_blocks_, full_blocks_;
    Eigen::SparseMatrix<double> member_tangent_;
    Eigen::SparseMatrix<double, Eigen::RowMajor> full_tangent_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    bool analysed_ = false;
    Eigen::VectorXd direction_;
    Points motion_;
    double largest_motion_ = 0;
    bool is_newton_step_ = false;
};

} // namespace funicular
