// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patterns.hpp"

#include "errors.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>

namespace funicular {

namespace {

using Point = PatternGrid::Point;

void place_every_point(PatternGrid &grid) {
    for (Index q = 0; q < grid.rows(); ++q)
        for (Index p = 0; p < grid.columns(); ++p)
            grid.place(p, q);
}

/// Members between points along u, and along v, that stand `apart` points from each other.
void lay_lines_along_u(PatternGrid &grid, Index apart = 1) {
    for (Index q = 0; q < grid.rows(); q += apart)
        for (Index p = 0; p < grid.last_u(); p += apart)
            grid.add_member({p, q}, {p + apart, q});
}
void lay_lines_along_v(PatternGrid &grid, Index apart = 1) {
    for (Index q = 0; q < grid.last_v(); q += apart)
        for (Index p = 0; p < grid.columns(); p += apart)
            grid.add_member({p, q}, {p, q + apart});
}

/// A cell between two points and two of the next row; at a pole it has three corners.
void add_cell(PatternGrid &grid, Index p, Index q, Index apart = 1) {
    grid.add_panel({{p, q}, {p + apart, q}, {p + apart, q + apart}, {p, q + apart}});
}
bool touches_pole(const PatternGrid &grid, Index p, Index q, Index apart = 1) {
    return grid.is_pole(p, q) || grid.is_pole(p + apart, q) || grid.is_pole(p, q + apart) ||
           grid.is_pole(p + apart, q + apart);
}

void lay_cells(PatternGrid &grid) {
    for (Index q = 0; q < grid.last_v(); ++q)
        for (Index p = 0; p < grid.last_u(); ++p)
            add_cell(grid, p, q);
}

void lay_quads(PatternGrid &grid) {
    place_every_point(grid);
    lay_lines_along_u(grid);
    lay_lines_along_v(grid);
    lay_cells(grid);
}

/// Quads whose cells are split from their first corner, or from their second. A triangle at a pole stays
/// whole.
template <class IsOther>
void lay_split_quads(PatternGrid &grid, IsOther is_other) {
    place_every_point(grid);
    lay_lines_along_u(grid);
    lay_lines_along_v(grid);
    for (Index q = 0; q < grid.last_v(); ++q)
        for (Index p = 0; p < grid.last_u(); ++p) {
            const Point first{p, q}, second{p + 1, q}, third{p + 1, q + 1}, fourth{p, q + 1};
            if (touches_pole(grid, p, q)) {
                add_cell(grid, p, q);
            } else if (is_other(p, q)) {
                grid.add_member(second, fourth);
                grid.add_panel({first, second, fourth});
                grid.add_panel({second, third, fourth});
            } else {
                grid.add_member(first, third);
                grid.add_panel({first, second, third});
                grid.add_panel({first, third, fourth});
            }
        }
}
void lay_diagonal(PatternGrid &grid) {
    lay_split_quads(grid, [](Index, Index) { return false; });
}
void lay_other_diagonal(PatternGrid &grid) {
    lay_split_quads(grid, [](Index, Index) { return true; });
}
void lay_alternating(PatternGrid &grid) {
    lay_split_quads(grid, [](Index p, Index q) { return (p + q) % 2 != 0; });
}
void lay_zigzag(PatternGrid &grid) {
    lay_split_quads(grid, [](Index, Index q) { return q % 2 != 0; });
}

/// Both diagonals, which pass each other without a joint.
void lay_crossed(PatternGrid &grid) {
    lay_quads(grid);
    for (Index q = 0; q < grid.last_v(); ++q)
        for (Index p = 0; p < grid.last_u(); ++p)
            if (!touches_pole(grid, p, q)) {
                grid.add_member({p, q}, {p + 1, q + 1});
                grid.add_member({p + 1, q}, {p, q + 1});
            }
}

/// Both diagonals, joined in the middle of the cell.
void lay_centred(PatternGrid &grid) {
    for (Index q = 0; q < grid.rows(); ++q)
        for (Index p = q % 2; p < grid.columns(); p += 2)
            if (q % 2 == 0 || !touches_pole(grid, p - 1, q - 1, 2))
                grid.place(p, q);
    lay_lines_along_u(grid, 2);
    lay_lines_along_v(grid, 2);
    for (Index q = 1; q < grid.last_v(); q += 2)
        for (Index p = 1; p < grid.last_u(); p += 2) {
            if (grid.node(p, q) < 0) {
                add_cell(grid, p - 1, q - 1, 2);
                continue;
            }
            const Point around[] = {{p - 1, q - 1}, {p + 1, q - 1}, {p + 1, q + 1}, {p - 1, q + 1}};
            for (std::size_t k = 0; k < 4; ++k) {
                grid.add_member({p, q}, around[k]);
                grid.add_panel({{p, q}, around[k], around[(k + 1) % 4]});
            }
        }
}

/// Members along both diagonals only, and along the border.
void lay_diagrid(PatternGrid &grid) {
    for (Index q = 0; q < grid.rows(); ++q)
        for (Index p = q % 2; p < grid.columns(); p += 2)
            grid.place(p, q);
    for (Index q = 0; q < grid.last_v(); ++q)
        for (Index p = 0; p < grid.last_u(); ++p) {
            if ((p + q) % 2 == 0)
                grid.add_member({p, q}, {p + 1, q + 1});
            else
                grid.add_member({p + 1, q}, {p, q + 1});
        }
    if (!grid.closed_v())
        for (const Index q : {0, grid.last_v()})
            for (Index p = 0; p < grid.last_u(); p += 2)
                grid.add_member({p, q}, {p + 2, q});
    if (!grid.closed_u())
        for (const Index p : {0, grid.last_u()})
            for (Index q = 0; q < grid.last_v(); q += 2)
                grid.add_member({p, q}, {p, q + 2});
    for (Index q = 0; q < grid.rows(); ++q)
        for (Index p = 1 - q % 2; p < grid.columns(); p += 2)
            grid.add_panel({{p - 1, q}, {p, q - 1}, {p + 1, q}, {p, q + 1}});
}

/// Rows that stand half a cell apart from each other; on a side every row has a node.
void lay_triangles(PatternGrid &grid) {
    const auto is_placed = [&grid](Index p, Index q) {
        return p % 2 == q % 2 || (!grid.closed_u() && (p == 0 || p == grid.last_u()));
    };
    for (Index q = 0; q < grid.rows(); ++q)
        for (Index p = 0; p < grid.columns(); ++p)
            if (is_placed(p, q))
                grid.place(p, q);
    for (Index q = 0; q < grid.rows(); ++q)
        for (Index p = 0, before = -1; p < grid.columns(); ++p)
            if (is_placed(p, q)) {
                if (before >= 0)
                    grid.add_member({before, q}, {p, q});
                else if (grid.closed_u())
                    grid.add_member({p - 2, q}, {p, q});
                before = p;
            }
    const bool open = !grid.closed_u();
    for (Index q = 0; q < grid.last_v(); ++q) {
        // Each node of the row without nodes of its own on the sides leads to the two beside it in the other
        // row.
        const Index even = q % 2 == 0 ? q : q + 1;
        const Index odd = q % 2 == 0 ? q + 1 : q;
        const auto add = [&grid, even, odd](Point apex, Index base, Index base_end) {
            const Index other = apex.q == even ? odd : even;
            if (other < apex.q)
                grid.add_panel({{base, other}, {base_end, other}, apex});
            else
                grid.add_panel({{base_end, other}, {base, other}, apex});
        };
        for (Index p = 0; p <= grid.last_u(); p += 2) {
            const bool first = open && p == 0;
            const bool last = open && p == grid.last_u();
            if (!grid.closed_u() || p < grid.last_u()) {
                const Index before = first ? p : p - 1;
                const Index after = last ? p : p + 1;
                grid.add_member({p, even}, {before, odd});
                grid.add_member({p, even}, {after, odd});
                add({p, even}, before, after);
            }
            if (p < grid.last_u())
                add({p + 1, odd}, p, p + 2);
        }
    }
}

/// Rows with posts between them that are joined by turns, half a cell apart from row to row. Each point of a
/// row stands off it by `rise`, to the side of its post; rows along the border are straight.
void lay_rows_and_posts(PatternGrid &grid, double rise) {
    const auto rises = [](Index p, Index q) { return (p + q) % 2 == 0; };
    for (Index q = 0; q < grid.rows(); ++q)
        for (Index p = 0; p < grid.columns(); ++p) {
            const bool straight = !grid.closed_v() && (q == 0 || q == grid.last_v());
            grid.place(p, q, straight ? 0 : rises(p, q) ? rise : -rise);
        }
    lay_lines_along_u(grid);
    for (Index q = 0; q < grid.last_v(); ++q) {
        std::vector<Index> posts;
        for (Index p = 0; p <= grid.last_u(); ++p)
            if (rises(p, q) || (!grid.closed_u() && (p == 0 || p == grid.last_u())))
                posts.push_back(p);
        if (grid.closed_u() && !rises(0, q))
            posts.push_back(posts.front() + grid.last_u());
        for (std::size_t k = 0; k < posts.size(); ++k) {
            if (!grid.closed_u() || k > 0)
                grid.add_member({posts[k], q}, {posts[k], q + 1});
            if (k == 0)
                continue;
            std::vector<Point> around;
            for (Index p = posts[k - 1]; p <= posts[k]; ++p)
                around.push_back({p, q});
            for (Index p = posts[k]; p >= posts[k - 1]; --p)
                around.push_back({p, q + 1});
            grid.add_panel(around);
        }
    }
}

/// Honeycomb; members all have one length if a zigzag is a third of the distance of two rows.
void lay_hexagons(PatternGrid &grid) {
    lay_rows_and_posts(grid, 1.0 / 6);
}

void lay_bricks(PatternGrid &grid) {
    lay_rows_and_posts(grid, 0);
}

/// Triangles between hexagons: every second row is full, of those between every second node stands, by turns.
void lay_kagome(PatternGrid &grid) {
    const auto first_apex = [](Index q) { return q % 4 == 1 ? 1 : 3; };
    for (Index q = 0; q < grid.rows(); ++q) {
        if (q % 2 == 0)
            for (Index p = 0; p < grid.columns(); p += 2)
                grid.place(p, q);
        else
            for (Index p = first_apex(q); p < grid.last_u(); p += 4)
                grid.place(p, q);
    }
    for (Index q = 0; q < grid.rows(); q += 2)
        for (Index p = 0; p < grid.last_u(); p += 2)
            grid.add_member({p, q}, {p + 2, q});
    for (Index q = 1; q < grid.last_v(); q += 2) {
        for (Index p = first_apex(q); p < grid.last_u(); p += 4) {
            for (const Index side : {-1, 1})
                for (const Index row : {-1, 1})
                    grid.add_member({p, q}, {p + side, q + row});
            grid.add_panel({{p - 1, q - 1}, {p + 1, q - 1}, {p, q}});
            grid.add_panel({{p + 1, q + 1}, {p - 1, q + 1}, {p, q}});
        }
        // Of a hexagon that reaches over a side only what is inside is left.
        const Index first = first_apex(q) - 2;
        for (Index p = first; grid.closed_u() ? p < first + grid.last_u() : p <= grid.last_u() + 1; p += 4)
            grid.add_panel(
                {{p - 1, q - 1}, {p + 1, q - 1}, {p + 2, q}, {p + 1, q + 1}, {p - 1, q + 1}, {p - 2, q}});
        if (!grid.closed_u())
            for (const Index p : {0, grid.last_u()})
                grid.add_member({p, q - 1}, {p, q + 1});
    }
}

void lay_ribs_u(PatternGrid &grid) {
    place_every_point(grid);
    lay_lines_along_u(grid);
    lay_cells(grid);
}
void lay_ribs_v(PatternGrid &grid) {
    place_every_point(grid);
    lay_lines_along_v(grid);
    lay_cells(grid);
}

constexpr double root2 = std::numbers::sqrt2;
constexpr double root3 = std::numbers::sqrt3;

constexpr PatternRule rules[] = {
    {Pattern::quad, "quad", 1, 1, 1, 1, 1, 1, lay_quads},
    {Pattern::diagonal, "diagonal", 1, 1, 1, 1, 1, 1, lay_diagonal},
    {Pattern::other_diagonal, "other_diagonal", 1, 1, 1, 1, 1, 1, lay_other_diagonal},
    {Pattern::alternating, "alternating", 1, 1, 1, 1, 2, 2, lay_alternating},
    {Pattern::crossed, "crossed", 1, 1, 1, 1, 1, 1, lay_crossed},
    {Pattern::centred, "centred", 2, 2, 1, 1, 1, 1, lay_centred},
    {Pattern::diagrid, "diagrid", 2, 2, root2, root2, 1, 1, lay_diagrid},
    {Pattern::triangle, "triangle", 2, 1, 1, root3 / 2, 1, 2, lay_triangles},
    {Pattern::hexagon, "hexagon", 2, 1, root3, 1.5, 1, 2, lay_hexagons},
    {Pattern::kagome, "kagome", 4, 2, 2, root3, 1, 2, lay_kagome},
    {Pattern::ribs_u, "ribs_u", 1, 1, 1, 1, 1, 1, lay_ribs_u},
    {Pattern::ribs_v, "ribs_v", 1, 1, 1, 1, 1, 1, lay_ribs_v},
    {Pattern::zigzag, "zigzag", 1, 1, 1, 1, 1, 2, lay_zigzag},
    {Pattern::brick, "brick", 2, 1, 2, 1, 1, 2, lay_bricks},
};

} // namespace

const PatternRule &rule_of(Pattern pattern) {
    return *std::find_if(std::begin(rules), std::end(rules),
                         [pattern](const PatternRule &rule) { return rule.pattern == pattern; });
}

std::span<const PatternRule> pattern_rules() {
    return rules;
}

} // namespace funicular
