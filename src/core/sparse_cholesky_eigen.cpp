// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sparse_cholesky.hpp"

#include <Eigen/SparseCholesky>

namespace funicular {

struct SparseCholesky::Backend {
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> factor;
    bool is_analysed = false;
};

SparseCholesky::SparseCholesky() : backend_(std::make_unique<Backend>()) {}
SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::factorise(const Matrix &lower, std::span<const Index> /*first_unknown*/) {
    auto &factor = backend_->factor;
    if (!backend_->is_analysed) {
        factor.analyzePattern(lower);
        backend_->is_analysed = true;
    }
    factor.factorize(lower);
    return factor.info() == Eigen::Success && (factor.vectorD().array() > 0).all();
}

void SparseCholesky::solve(const Eigen::VectorXd &right, Eigen::VectorXd &solution) {
    solution = backend_->factor.solve(right);
}

} // namespace funicular
