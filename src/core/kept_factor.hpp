// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_matrix.hpp"
#include "preconditioner.hpp"
#include "sparse_cholesky.hpp"

#include <vector>

namespace funicular {

/// A factorisation of the members' tangent: exact where it was made, and of use for as long as the shape has
/// not changed much.
class KeptFactor final : public Preconditioner {
public:
    explicit KeptFactor(const Equilibrium &equilibrium);

    bool prepare(const Points &x, const Equilibrium &equilibrium, double floor) override;
    void apply(const Eigen::VectorXd &residual, Eigen::VectorXd &motion) override {
        factor_.solve(residual, motion);
    }

private:
    BlockMatrix blocks_;
    SparseCholesky::Matrix tangent_;
    std::vector<Index> first_unknown_;
    SparseCholesky factor_;
};

} // namespace funicular
