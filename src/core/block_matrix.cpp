// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_matrix.hpp"

#include <algorithm>
#include <cassert>

namespace funicular {

void Coupling::add(std::span<const Index> nodes) {
    for (const Index row : nodes)
        for (const Index column : nodes)
            neighbours_[row].push_back(column);
}

BlockMatrix::BlockMatrix(Coupling coupling) {
    offsets_.reserve(coupling.neighbours_.size() + 1);
    offsets_.push_back(0);
    for (std::size_t row = 0; row < coupling.neighbours_.size(); ++row) {
        auto &neighbours = coupling.neighbours_[row];
        neighbours.push_back(static_cast<Index>(row));
        std::sort(neighbours.begin(), neighbours.end());
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
        columns_.insert(columns_.end(), neighbours.begin(), neighbours.end());
        offsets_.push_back(columns_.size());
    }
    values_.assign(columns_.size(), Matrix3::Zero());
}

std::span<const Index> BlockMatrix::columns(Index row) const {
    return {columns_.data() + offsets_[row], offsets_[row + 1] - offsets_[row]};
}

std::size_t BlockMatrix::find(Index row, Index column) const {
    // Rows are short, so walking along one beats a search.
    std::size_t at = offsets_[row];
    while (columns_[at] != column) {
        ++at;
        assert(at < offsets_[row + 1]);
    }
    return at;
}

} // namespace funicular
