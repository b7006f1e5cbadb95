// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pattern_grid.hpp"

#include <algorithm>
#include <set>

namespace funicular {

PatternGrid::PatternGrid(const LatticeRecipe &recipe, Index points_per_cell_u, Index points_per_cell_v)
    : points_(static_cast<std::size_t>(recipe.cells_u * points_per_cell_u + 1) *
                  (recipe.cells_v * points_per_cell_v + 1),
              -1),
      recipe_(recipe), last_u_(recipe.cells_u * points_per_cell_u),
      last_v_(recipe.cells_v * points_per_cell_v) {}

bool PatternGrid::has_pole(Side side) const {
    return std::find(recipe_.poles.begin(), recipe_.poles.end(), side) != recipe_.poles.end();
}

PatternGrid::Point PatternGrid::canonical(Index p, Index q) const {
    if (closed_u())
        p = (p % last_u_ + last_u_) % last_u_;
    if (closed_v())
        q = (q % last_v_ + last_v_) % last_v_;
    if (p < 0 || p > last_u_ || q < 0 || q > last_v_)
        return {-1, -1};
    if (is_pole_of_v(q))
        p = 0;
    if (is_pole_of_u(p))
        q = 0;
    return {p, q};
}

void PatternGrid::place(Index p, Index q, double shift_v) {
    const auto [at_p, at_q] = canonical(p, q);
    Index &node = points_[at_q * (last_u_ + 1) + at_p];
    if (node >= 0)
        return;
    node = static_cast<Index>(uv.size());
    const double v = (at_q + shift_v) / last_v_;
    uv.push_back({static_cast<double>(at_p) / last_u_, v < 0 ? v + 1 : v});
}

Index PatternGrid::node(Index p, Index q) const {
    const auto [at_p, at_q] = canonical(p, q);
    return at_p < 0 ? -1 : points_[at_q * (last_u_ + 1) + at_p];
}

void PatternGrid::add_member(Point a, Point b) {
    const Index first = node(a.p, a.q);
    const Index second = node(b.p, b.q);
    if (first >= 0 && second >= 0 && first != second)
        members.push_back({first, second});
}

void PatternGrid::add_panel(const Point *first, const Point *last) {
    std::vector<Index> corners;
    for (; first != last; ++first) {
        const Index corner = node(first->p, first->q);
        if (corner >= 0 && std::find(corners.begin(), corners.end(), corner) == corners.end())
            corners.push_back(corner);
    }
    if (corners.size() >= 3)
        panels.add(corners);
}

std::vector<Index> PatternGrid::row(Index q) const {
    std::vector<Index> nodes;
    for (Index p = 0; p < columns(); ++p)
        if (const Index at = node(p, q); at >= 0)
            nodes.push_back(at);
    return nodes;
}

std::vector<Index> PatternGrid::column(Index p) const {
    std::vector<Index> nodes;
    for (Index q = 0; q < rows(); ++q)
        if (const Index at = node(p, q); at >= 0)
            nodes.push_back(at);
    return nodes;
}

void PatternGrid::remove_doubles() {
    if (recipe_.poles.empty())
        return;
    std::set<Member> seen;
    std::erase_if(members, [&seen](const Member &member) {
        return !seen.insert({std::min(member[0], member[1]), std::max(member[0], member[1])}).second;
    });
}

} // namespace funicular
