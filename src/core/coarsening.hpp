// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "lattice.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace funicular {

/// Members along the lines of a lattice of quads or ribs, by where they stand.
class LineMembers {
public:
    explicit LineMembers(const Lattice &lattice);
    /// The member from (i, j) to (i + 1, j), or -1 along a pole and across ribs.
    [[nodiscard]] Index along_u(Index i, Index j) const { return along_u_[j * cells_u_ + i]; }
    /// The member from (i, j) to (i, j + 1), or -1 along a pole and across ribs.
    [[nodiscard]] Index along_v(Index i, Index j) const { return along_v_[j * lines_u_ + i]; }

private:
    Index cells_u_, lines_u_;
    std::vector<Index> along_u_, along_v_;
};

/// A lattice with every second line left out, and how the two belong together. Ribs are all kept: each is a
/// member of its own, of which only the length is divided otherwise.
class Coarsening {
public:
    /// A node of the coarse lattice and its part in a node of the fine one.
    struct Parent {
        Index node;
        double part;
    };
    /// Fine members in a row, one or two, and the part of them that one coarse member stands for: the lines
    /// between two coarse ones count half for each.
    struct Strand {
        Index coarse_member;
        Index first;
        Index second; ///< -1 if there is none
        double part;
    };

    /// None for a lattice of another pattern, or one too small to leave lines out of.
    [[nodiscard]] static std::optional<Coarsening> of(const std::shared_ptr<const Lattice> &fine);

    [[nodiscard]] const std::shared_ptr<const Lattice> &fine() const { return fine_; }
    [[nodiscard]] const std::shared_ptr<const Lattice> &coarse() const { return coarse_; }
    /// The fine node in the place of each coarse one.
    [[nodiscard]] const std::vector<Index> &fine_nodes() const { return fine_nodes_; }
    /// Coarse nodes between which a fine node lies, one, two or four; their parts add up to one.
    [[nodiscard]] std::span<const Parent> parents(Index fine_node) const {
        return {parents_.data() + offsets_[fine_node],
                static_cast<std::size_t>(offsets_[fine_node + 1] - offsets_[fine_node])};
    }
    [[nodiscard]] const std::vector<Strand> &strands() const { return strands_; }

    /// Coarse positions carried over to the fine lattice by cubic interpolation along its lines.
    void interpolate(const Points &coarse, Points &fine) const;

private:
    /// How one direction is thinned out.
    struct Direction {
        Index cells, coarse_cells;
        bool closed, halved;
        [[nodiscard]] Index lines() const { return closed ? cells : cells + 1; }
        [[nodiscard]] Index coarse_lines() const { return closed ? coarse_cells : coarse_cells + 1; }
        /// Coarse lines on either side of a fine line; only the first has a part where the line was kept.
        [[nodiscard]] std::array<Parent, 2> parents(Index line) const;
        /// Coarse lines from which a fine line is interpolated to third order.
        [[nodiscard]] std::array<Parent, 4> interpolation(Index line) const;
        /// The fine line in the place of a coarse one.
        [[nodiscard]] Index fine_line(Index coarse_line) const {
            return halved ? std::min(2 * coarse_line, cells) : coarse_line;
        }
    };

    Coarsening(std::shared_ptr<const Lattice> fine, Direction u, Direction v);
    void find_parents();
    void find_strands();

    Direction u_, v_;
    std::shared_ptr<const Lattice> fine_, coarse_;
    std::vector<Index> fine_nodes_, offsets_;
    std::vector<Parent> parents_;
    std::vector<Strand> strands_;
};

} // namespace funicular
