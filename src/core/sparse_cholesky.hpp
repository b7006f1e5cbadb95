// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "types.hpp"

#include <Eigen/SparseCore>

#include <memory>
#include <span>

namespace funicular {

/// Factorises symmetric positive definite matrices of one structure, again and again.
///
/// By CHOLMOD's supernodal method on OpenBLAS where the core was built with them, by Eigen otherwise. Both
/// give the same solution but for rounding; each gives the same bits for the same matrix, whatever the number
/// of threads that the machine or the user allows OpenBLAS (Chen, Davis, Hager and Rajamanickam, "Algorithm
/// 887: CHOLMOD", 2008).
class SparseCholesky {
public:
    using Matrix = Eigen::SparseMatrix<double>;

    SparseCholesky();
    SparseCholesky(const SparseCholesky &) = delete;
    SparseCholesky &operator=(const SparseCholesky &) = delete;
    ~SparseCholesky();

    /// \param lower         the lower triangle; values above the diagonal are not read
    /// \param first_unknown of each node, and their number at the end: a node's unknowns are eliminated
    /// together \pre `lower` has the structure of the first call's \returns whether it is positive definite
    bool factorise(const Matrix &lower, std::span<const Index> first_unknown);
    /// \pre the last factorise returned true
    void solve(const Eigen::VectorXd &right, Eigen::VectorXd &solution);

private:
    struct Backend;
    std::unique_ptr<Backend> backend_;
};

} // namespace funicular
