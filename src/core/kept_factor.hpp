// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_matrix.hpp"
#include "preconditioner.hpp"

#include <Eigen/SparseCholesky>

namespace funicular {

/// A factorisation (LDLᵀ) of the members' tangent: exact where it was made, and of use for as long as the
/// shape has not changed much.
class KeptFactor final : public Preconditioner {
public:
    explicit KeptFactor(const Equilibrium &equilibrium) : blocks_(equilibrium.member_coupling()) {}

    bool prepare(const Points &x, const Equilibrium &equilibrium, double floor) override;
    void apply(const Eigen::VectorXd &residual, Eigen::VectorXd &motion) override {
        motion = factor_.solve(residual);
    }

private:
    BlockMatrix blocks_;
    Eigen::SparseMatrix<double> tangent_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    bool is_analysed_ = false;
};

} // namespace funicular
