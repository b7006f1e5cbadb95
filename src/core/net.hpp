// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "types.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace funicular {

class Lattice;

/// A straight member between two nodes.
using Member = std::array<Index, 2>;

/// Polygons of three or more nodes each, stored one after another.
class Panels {
public:
    void add(std::span<const Index> corners);
    [[nodiscard]] Index size() const { return static_cast<Index>(offsets_.size()) - 1; }
    [[nodiscard]] bool empty() const { return size() == 0; }
    [[nodiscard]] std::span<const Index> operator[](Index panel) const;

private:
    std::vector<Index> offsets_{0};
    std::vector<Index> corners_;
};

/// Nodes joined by straight members, with panels (the covering) between them. Checked once, then immutable.
class Net {
public:
    /// \param nodes   positions [m]
    /// \param members pairs of node numbers
    /// \param panels  node numbers around each panel, in order
    /// \param lattice the lattice that the net was made on, if any
    /// \throws InvalidInput for an empty or non-finite input, a node number out of range, a member from a
    /// node to
    ///         itself or of no length, a member given twice, a panel with fewer than three corners or a
    ///         repeated one.
    Net(Points nodes, std::vector<Member> members, Panels panels = {},
        std::shared_ptr<const Lattice> lattice = nullptr);

    [[nodiscard]] Index node_count() const { return static_cast<Index>(nodes_.rows()); }
    [[nodiscard]] Index member_count() const { return static_cast<Index>(members_.size()); }
    /// Positions [m], as given.
    [[nodiscard]] const Points &nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Member> &members() const { return members_; }
    [[nodiscard]] const Panels &panels() const { return panels_; }
    /// Null for a net that was not made on a lattice.
    [[nodiscard]] const std::shared_ptr<const Lattice> &lattice() const { return lattice_; }

    /// Centre of the net's bounding box [m]: computing relative to it keeps the digits of a net far from the
    /// origin.
    [[nodiscard]] const Vector3 &centre() const { return centre_; }
    /// Diagonal of the bounding box [m], positive.
    [[nodiscard]] double size() const { return size_; }
    /// Length of each member as given [m], positive.
    [[nodiscard]] const Eigen::VectorXd &source_lengths() const { return source_lengths_; }

    /// Nodes on panel edges that belong to one panel only, ascending.
    [[nodiscard]] std::vector<Index> border() const;

private:
    Points nodes_;
    std::vector<Member> members_;
    Panels panels_;
    std::shared_ptr<const Lattice> lattice_;
    Vector3 centre_;
    double size_ = 0;
    Eigen::VectorXd source_lengths_;
};

/// A flat sheet in the plane z = 0 with one corner at the origin, as a start shape (paper section 5.1).
/// \param width,depth extents in x and y [m]
/// \param step        wished member length [m]; rounded so that whole cells fit
/// \throws InvalidInput unless 0 < step <= width, depth.
[[nodiscard]] std::shared_ptr<const Net> flat_sheet(double width, double depth, double step,
                                                    const char *pattern = "quad");

} // namespace funicular
