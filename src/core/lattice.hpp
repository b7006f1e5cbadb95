// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "net.hpp"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace funicular {

/// How members and panels are laid on a (u, v) lattice (paper section 5.1 and figure 2).
enum class Pattern {
    quad,
    diagonal,       ///< quads split from their first corner
    other_diagonal, ///< and from their second
    alternating,    ///< by turns
    crossed,        ///< both diagonals, which pass each other without a joint
    centred,        ///< both diagonals with a joint in the middle
    diagrid,        ///< the diagonals alone
    triangle,       ///< rows that stand half a cell apart
    hexagon,
    kagome, ///< triangles between hexagons
    ribs_u, ///< members along u alone
    ribs_v,
    zigzag, ///< quads split from their first corner and from their second, row by row
    brick   ///< rows whose cross members stand half a cell apart
};

/// \throws InvalidInput that lists the patterns there are.
[[nodiscard]] Pattern pattern_from_name(const std::string &name);
[[nodiscard]] std::string pattern_name(Pattern pattern);
[[nodiscard]] std::vector<std::string> pattern_names();

/// (along u, along v) of a cell, where all members, diagonals of quads apart, are one unit long.
[[nodiscard]] std::array<double, 2> cell_extent(Pattern pattern);

/// A side of the unit (u, v) square.
enum class Side { u_min, u_max, v_min, v_max };
[[nodiscard]] Side side_from_name(const std::string &name);
[[nodiscard]] std::string side_name(Side side);

/// More would not fit into the memory of an ordinary machine.
inline constexpr Index max_lattice_cells = 10'000'000;

/// What a lattice is made from.
struct LatticeRecipe {
    Pattern pattern = Pattern::quad;
    Index cells_u = 1;
    Index cells_v = 1;
    /// The last cell joins the first: u = 1 is u = 0. The number of cells then becomes a multiple of those
    /// after which the pattern repeats.
    bool closed_u = false;
    bool closed_v = false;
    /// Sides that are a single point of the surface (the apex of a dome).
    std::vector<Side> poles;
};

/// Connectivity on the unit (u, v) square, without positions in space.
class Lattice {
public:
    /// \throws InvalidInput unless there is at least one cell each way (three where closed, two between two
    /// poles), and
    ///         poles lie on open sides of one direction only.
    explicit Lattice(LatticeRecipe recipe);

    [[nodiscard]] const LatticeRecipe &recipe() const { return recipe_; }
    /// (u, v) of each node, in [0, 1]; closed directions never reach 1.
    [[nodiscard]] const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> &uv() const { return uv_; }
    [[nodiscard]] const std::vector<Member> &members() const { return members_; }
    [[nodiscard]] const Panels &panels() const { return panels_; }
    /// The nodes at the corners of the (u, v) square; none where a direction is closed.
    [[nodiscard]] const std::vector<Index> &corners() const { return corners_; }
    /// Nodes along each side that is neither closed nor a pole, in order of the other coordinate.
    [[nodiscard]] const std::map<Side, std::vector<Index>> &sides() const { return sides_; }

    /// Node at lattice point (i, j) of a pattern that has one at each corner of its cells alone, 0 <= i <=
    /// cells_u, 0 <= j <= cells_v; closed directions wrap and a pole is the same node all along.
    [[nodiscard]] Index node_at(Index i, Index j) const { return points_[j * (recipe_.cells_u + 1) + i]; }
    /// Distinct lattice lines across u and across v: a closed direction has no last one.
    [[nodiscard]] Index lines_u() const { return recipe_.cells_u + (recipe_.closed_u ? 0 : 1); }
    [[nodiscard]] Index lines_v() const { return recipe_.cells_v + (recipe_.closed_v ? 0 : 1); }

    /// The same lattice for a net of another numbering.
    /// \param nodes   the net's number of each node
    /// \param members the net's number of each member
    [[nodiscard]] Lattice renumbered(const std::vector<Index> &nodes, std::vector<Index> members) const;
    /// The number of the k-th member in the order in which the pattern lays them.
    [[nodiscard]] Index laid(Index k) const { return laid_.empty() ? k : laid_[k]; }

private:
    LatticeRecipe recipe_;
    std::vector<Index> points_;
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> uv_;
    std::vector<Member> members_;
    /// Empty where members are numbered as they were laid.
    std::vector<Index> laid_;
    Panels panels_;
    std::vector<Index> corners_;
    std::map<Side, std::vector<Index>> sides_;
};

/// A net on a lattice, which it remembers.
/// \throws InvalidInput unless there is one position for each lattice node.
[[nodiscard]] std::shared_ptr<const Net> make_net(std::shared_ptr<const Lattice> lattice, Points nodes);

} // namespace funicular
