// SPDX-License-Identifier: LGPL-2.1-or-later
#include "lattice.hpp"

#include "errors.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace funicular {

namespace {

constexpr std::array<std::pair<Pattern, const char *>, 1> pattern_names{{{Pattern::quad, "quad"}}};
constexpr std::array<std::pair<Side, const char *>, 4> side_names{
    {{Side::u_min, "u_min"}, {Side::u_max, "u_max"}, {Side::v_min, "v_min"}, {Side::v_max, "v_max"}}};

template <class Names>
auto value_from_name(const Names &names, const std::string &name, const char *argument) {
    std::string known;
    for (const auto &[value, text] : names) {
        if (name == text)
            return value;
        known += (known.empty() ? "" : ", ") + std::string(text);
    }
    throw InvalidInput(std::string(argument) + " '" + name + "' is not known; choose one of: " + known);
}

template <class Names, class Value>
std::string name_from_value(const Names &names, Value value) {
    return std::find_if(names.begin(), names.end(),
                        [value](const auto &entry) { return entry.first == value; })
        ->second;
}

/// The lattice points and what a pattern lays on them: closed directions wrap and poles are one node, so that
/// a pattern never has to know.
class Grid {
public:
    explicit Grid(const LatticeRecipe &recipe) : recipe_(recipe) {
        points_.resize(static_cast<std::size_t>(recipe.cells_u + 1) * (recipe.cells_v + 1), -1);
        for (Index j = 0; j <= recipe.cells_v; ++j)
            for (Index i = 0; i <= recipe.cells_u; ++i)
                point(i, j) = existing_node(i, j);
    }

    [[nodiscard]] Index cells_u() const { return recipe_.cells_u; }
    [[nodiscard]] Index cells_v() const { return recipe_.cells_v; }
    /// Distinct lattice lines across u and across v: a closed direction has no last one.
    [[nodiscard]] Index lines_u() const { return recipe_.closed_u ? cells_u() : cells_u() + 1; }
    [[nodiscard]] Index lines_v() const { return recipe_.closed_v ? cells_v() : cells_v() + 1; }
    /// Node at lattice point (i, j), 0 <= i <= cells_u, 0 <= j <= cells_v.
    [[nodiscard]] Index node(Index i, Index j) const { return points_[j * (recipe_.cells_u + 1) + i]; }

    /// The seam of a closed direction and the rim of a pole are left out: they would be members twice or of
    /// no length.
    void add_member(Index a, Index b) {
        if (a != b)
            members.push_back({a, b});
    }
    /// A panel that touches a pole loses the corner that has no extent.
    void add_panel(std::initializer_list<Index> around) {
        std::vector<Index> corners;
        for (const Index node : around)
            if (std::find(corners.begin(), corners.end(), node) == corners.end())
                corners.push_back(node);
        if (corners.size() >= 3)
            panels.add(corners);
    }

    [[nodiscard]] std::vector<Index> take_points() { return std::move(points_); }

    std::vector<std::array<double, 2>> uv;
    std::vector<Member> members;
    Panels panels;

private:
    Index &point(Index i, Index j) { return points_[j * (recipe_.cells_u + 1) + i]; }

    [[nodiscard]] bool is_pole(Side side) const {
        return std::find(recipe_.poles.begin(), recipe_.poles.end(), side) != recipe_.poles.end();
    }

    Index existing_node(Index i, Index j) {
        if (recipe_.closed_u && i == recipe_.cells_u)
            return node(0, j);
        if (recipe_.closed_v && j == recipe_.cells_v)
            return node(i, 0);
        if (i > 0 && ((j == 0 && is_pole(Side::v_min)) || (j == recipe_.cells_v && is_pole(Side::v_max))))
            return node(0, j);
        if (j > 0 && ((i == 0 && is_pole(Side::u_min)) || (i == recipe_.cells_u && is_pole(Side::u_max))))
            return node(i, 0);
        uv.push_back({static_cast<double>(i) / recipe_.cells_u, static_cast<double>(j) / recipe_.cells_v});
        return static_cast<Index>(uv.size()) - 1;
    }

    const LatticeRecipe &recipe_;
    std::vector<Index> points_;
};

/// One member along each lattice line between neighbours, one panel in each cell.
void lay_quads(Grid &grid) {
    for (Index j = 0; j < grid.lines_v(); ++j)
        for (Index i = 0; i < grid.cells_u(); ++i)
            grid.add_member(grid.node(i, j), grid.node(i + 1, j));
    for (Index j = 0; j < grid.cells_v(); ++j)
        for (Index i = 0; i < grid.lines_u(); ++i)
            grid.add_member(grid.node(i, j), grid.node(i, j + 1));
    for (Index j = 0; j < grid.cells_v(); ++j)
        for (Index i = 0; i < grid.cells_u(); ++i)
            grid.add_panel(
                {grid.node(i, j), grid.node(i + 1, j), grid.node(i + 1, j + 1), grid.node(i, j + 1)});
}

void lay(Pattern pattern, Grid &grid) {
    switch (pattern) {
    case Pattern::quad:
        return lay_quads(grid);
    }
}

/// Checks the cells, closure and poles of one direction, 'u' or 'v'.
void check_direction(const LatticeRecipe &recipe, char direction) {
    const bool is_u = direction == 'u';
    const Index cells = is_u ? recipe.cells_u : recipe.cells_v;
    const bool closed = is_u ? recipe.closed_u : recipe.closed_v;
    const auto poles = std::count_if(recipe.poles.begin(), recipe.poles.end(), [is_u](Side side) {
        return (side == Side::u_min || side == Side::u_max) == is_u;
    });
    const std::string name = std::string("cells_") + direction;
    if (closed && poles > 0)
        throw InvalidInput(std::string("poles: a side of the closed direction ") + direction +
                           " cannot be a pole");
    const Index least = closed ? 3 : poles > 1 ? 2 : 1;
    if (cells < least)
        throw InvalidInput(name + " must be at least " + std::to_string(least) +
                           (closed      ? " in a closed direction"
                            : poles > 1 ? " between two poles"
                                        : ""));
    if (cells > max_lattice_cells)
        throw InvalidInput(name + " must not exceed " + std::to_string(max_lattice_cells) +
                           ": choose a larger step");
}

} // namespace

Pattern pattern_from_name(const std::string &name) {
    return value_from_name(pattern_names, name, "pattern");
}
std::string pattern_name(Pattern pattern) {
    return name_from_value(pattern_names, pattern);
}
Side side_from_name(const std::string &name) {
    return value_from_name(side_names, name, "poles");
}
std::string side_name(Side side) {
    return name_from_value(side_names, side);
}

Lattice::Lattice(LatticeRecipe recipe) : recipe_(std::move(recipe)) {
    auto &poles = recipe_.poles;
    std::sort(poles.begin(), poles.end());
    poles.erase(std::unique(poles.begin(), poles.end()), poles.end());
    check_direction(recipe_, 'u');
    check_direction(recipe_, 'v');
    if (static_cast<double>(recipe_.cells_u) * recipe_.cells_v > max_lattice_cells)
        throw InvalidInput("cells_u x cells_v must not exceed " + std::to_string(max_lattice_cells) +
                           ": choose a larger step");
    const auto has = [&poles](Side side) {
        return std::find(poles.begin(), poles.end(), side) != poles.end();
    };
    if ((has(Side::u_min) || has(Side::u_max)) && (has(Side::v_min) || has(Side::v_max)))
        throw InvalidInput("poles: sides of u and of v cannot both be poles, as they would be one point");

    Grid grid(recipe_);
    lay(recipe_.pattern, grid);

    uv_.resize(static_cast<Index>(grid.uv.size()), 2);
    for (Index i = 0; i < uv_.rows(); ++i)
        uv_.row(i) << grid.uv[i][0], grid.uv[i][1];
    members_ = std::move(grid.members);
    panels_ = std::move(grid.panels);

    const Index m = recipe_.cells_u;
    const Index n = recipe_.cells_v;
    const auto along = [](Index count, bool closed, const auto &node_at) {
        std::vector<Index> nodes(closed ? count : count + 1);
        for (std::size_t k = 0; k < nodes.size(); ++k)
            nodes[k] = node_at(static_cast<Index>(k));
        return nodes;
    };
    if (!recipe_.closed_u)
        for (const auto &[side, i] : {std::pair{Side::u_min, 0}, std::pair{Side::u_max, m}})
            if (!has(side))
                sides_[side] =
                    along(n, recipe_.closed_v, [&grid, i = i](Index j) { return grid.node(i, j); });
    if (!recipe_.closed_v)
        for (const auto &[side, j] : {std::pair{Side::v_min, 0}, std::pair{Side::v_max, n}})
            if (!has(side))
                sides_[side] =
                    along(m, recipe_.closed_u, [&grid, j = j](Index i) { return grid.node(i, j); });
    if (!recipe_.closed_u && !recipe_.closed_v) {
        corners_ = {grid.node(0, 0), grid.node(m, 0), grid.node(m, n), grid.node(0, n)};
        std::sort(corners_.begin(), corners_.end());
        corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    }
    points_ = grid.take_points();
}

Lattice Lattice::renumbered(const std::vector<Index> &nodes, std::vector<Index> members) const {
    Lattice result(*this);
    const auto rename = [&nodes](std::vector<Index> &numbers) {
        for (Index &node : numbers)
            node = nodes[node];
    };
    rename(result.points_);
    rename(result.corners_);
    std::sort(result.corners_.begin(), result.corners_.end());
    for (auto &[side, along] : result.sides_)
        rename(along);
    for (Index node = 0; node < uv_.rows(); ++node)
        result.uv_.row(nodes[node]) = uv_.row(node);
    for (std::size_t e = 0; e < members_.size(); ++e)
        result.members_[members[e]] = {nodes[members_[e][0]], nodes[members_[e][1]]};
    result.panels_ = Panels();
    for (Index f = 0; f < panels_.size(); ++f) {
        const auto corners = panels_[f];
        std::vector<Index> renamed(corners.begin(), corners.end());
        rename(renamed);
        result.panels_.add(renamed);
    }
    result.laid_.resize(members.size());
    for (std::size_t k = 0; k < members.size(); ++k)
        result.laid_[k] = members[laid(static_cast<Index>(k))];
    return result;
}

std::shared_ptr<const Net> make_net(std::shared_ptr<const Lattice> lattice, Points nodes) {
    if (nodes.rows() != lattice->uv().rows())
        throw InvalidInput("nodes has " + std::to_string(nodes.rows()) + " rows, but the lattice has " +
                           std::to_string(lattice->uv().rows()) + " nodes");
    auto members = lattice->members();
    auto panels = lattice->panels();
    return std::make_shared<const Net>(std::move(nodes), std::move(members), std::move(panels),
                                       std::move(lattice));
}

} // namespace funicular
