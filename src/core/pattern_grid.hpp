// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "lattice.hpp"

#include <array>
#include <initializer_list>
#include <vector>

namespace funicular {

/// The points of the unit (u, v) square that a pattern may place nodes on, a whole number of them to a cell,
/// and what it lays between them. Closed directions wrap and poles are one node, so that a pattern never has
/// to know.
class PatternGrid {
public:
    PatternGrid(const LatticeRecipe &recipe, Index points_per_cell_u, Index points_per_cell_v);

    /// The last point of a row or column; in a closed direction it is the first one again.
    [[nodiscard]] Index last_u() const { return last_u_; }
    [[nodiscard]] Index last_v() const { return last_v_; }
    /// How many rows and columns are distinct: a closed direction has no last one.
    [[nodiscard]] Index columns() const { return closed_u() ? last_u_ : last_u_ + 1; }
    [[nodiscard]] Index rows() const { return closed_v() ? last_v_ : last_v_ + 1; }
    [[nodiscard]] bool closed_u() const { return recipe_.closed_u; }
    [[nodiscard]] bool closed_v() const { return recipe_.closed_v; }
    [[nodiscard]] bool is_pole(Index p, Index q) const { return is_pole_of_v(q) || is_pole_of_u(p); }

    /// Places a node at a point, unless there is one: once at a pole.
    /// \param shift_v how far off the point, in rows
    void place(Index p, Index q, double shift_v = 0);
    /// The node at a point; -1 where none was placed and outside the square.
    [[nodiscard]] Index node(Index p, Index q) const;

    struct Point {
        Index p, q;
    };
    /// Nothing where one of the two does not exist or both are one pole.
    void add_member(Point a, Point b);
    /// Corners that do not exist, and those that a pole makes one, are left out; nothing of fewer than three.
    void add_panel(std::initializer_list<Point> around) { add_panel(around.begin(), around.end()); }
    void add_panel(const std::vector<Point> &around) {
        add_panel(around.data(), around.data() + around.size());
    }

    /// Nodes in a row or column, in order.
    [[nodiscard]] std::vector<Index> row(Index q) const;
    [[nodiscard]] std::vector<Index> column(Index p) const;

    /// Members that meet in a pole from two sides may be one: each is kept once.
    void remove_doubles();

    std::vector<std::array<double, 2>> uv;
    std::vector<Member> members;
    Panels panels;

private:
    void add_panel(const Point *first, const Point *last);
    [[nodiscard]] bool has_pole(Side side) const;
    [[nodiscard]] bool is_pole_of_u(Index p) const {
        return (p == 0 && has_pole(Side::u_min)) || (p == last_u_ && has_pole(Side::u_max));
    }
    [[nodiscard]] bool is_pole_of_v(Index q) const {
        return (q == 0 && has_pole(Side::v_min)) || (q == last_v_ && has_pole(Side::v_max));
    }
    /// The point that stands for this one where directions close and in a pole.
    [[nodiscard]] Point canonical(Index p, Index q) const;

    /// Node of each point, row by row; -1 where there is none, and where another point stands for this one.
    std::vector<Index> points_;
    const LatticeRecipe &recipe_;
    Index last_u_, last_v_;
};

} // namespace funicular
