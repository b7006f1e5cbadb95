// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "supports.hpp"
#include "types.hpp"

#include <Eigen/SparseCore>

#include <cstddef>
#include <span>
#include <vector>

namespace funicular {

/// Pairs of nodes that act on one another: the places of a sparse matrix of 3 x 3 blocks.
class Coupling {
public:
    explicit Coupling(Index node_count) : neighbours_(node_count) {}
    /// Every node acts on every other of the group.
    void add(std::span<const Index> nodes);

private:
    friend class BlockMatrix;
    std::vector<std::vector<Index>> neighbours_;
};

/// A sparse matrix of 3 x 3 blocks, one row of blocks for each node.
class BlockMatrix {
public:
    explicit BlockMatrix(Coupling coupling);

    void set_zero() { values_.assign(values_.size(), Matrix3::Zero()); }
    /// \pre (row, column) was coupled.
    void add(Index row, Index column, const Matrix3 &block) { values_[find(row, column)] += block; }

    /// Adds to the third row of a block: what moves a vertical force.
    /// \pre (row, column) was coupled.
    void add_vertical(Index row, Index column, const Vector3 &entries) {
        values_[find(row, column)].row(2) += entries.transpose();
    }

    [[nodiscard]] std::size_t block_count() const { return columns_.size(); }
    [[nodiscard]] std::span<const Index> columns(Index row) const;
    [[nodiscard]] const Matrix3 &block(Index row, Index column) const { return values_[find(row, column)]; }

    /// The matrix between the free directions. A row-major result is this matrix, a column-major one its
    /// transpose.
    template <class Sparse>
    void reduce(const Freedoms &freedoms, Sparse &reduced) const {
        reduced.resize(freedoms.size(), freedoms.size());
        reduced.reserve(static_cast<Index>(9 * block_count()));
        const auto node_count = static_cast<Index>(offsets_.size()) - 1;
        for (Index row = 0; row < node_count; ++row)
            for (Index a = 0; a < freedoms.count(row); ++a) {
                const Index outer = freedoms.offset(row) + a;
                reduced.startVec(outer);
                for (std::size_t at = offsets_[row]; at < offsets_[row + 1]; ++at) {
                    const Index column = columns_[at];
                    const Eigen::RowVector3d line = freedoms.basis(row).col(a).transpose() * values_[at];
                    for (Index b = 0; b < freedoms.count(column); ++b)
                        reduced.insertBackByOuterInner(outer, freedoms.offset(column) + b) =
                            line.dot(freedoms.basis(column).col(b));
                }
            }
        reduced.finalize();
    }

private:
    [[nodiscard]] std::size_t find(Index row, Index column) const;

    std::vector<std::size_t> offsets_;
    std::vector<Index> columns_;
    std::vector<Matrix3> values_;
};

} // namespace funicular
