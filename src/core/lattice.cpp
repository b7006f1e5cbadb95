// SPDX-License-Identifier: LGPL-2.1-or-later
#include "lattice.hpp"

#include "errors.hpp"
#include "patterns.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace funicular {

namespace {

constexpr std::array<std::pair<Side, const char *>, 4> side_names{
    {{Side::u_min, "u_min"}, {Side::u_max, "u_max"}, {Side::v_min, "v_min"}, {Side::v_max, "v_max"}}};

std::vector<std::pair<Pattern, const char *>> names_of_patterns() {
    std::vector<std::pair<Pattern, const char *>> names;
    for (const PatternRule &rule : pattern_rules())
        names.emplace_back(rule.pattern, rule.name);
    return names;
}

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

/// Lines along one direction alone never reach a pole of the other.
void check_every_node_has_a_member(const PatternGrid &grid) {
    std::vector<bool> has_member(grid.uv.size(), false);
    for (const auto &[a, b] : grid.members)
        has_member[a] = has_member[b] = true;
    if (std::find(has_member.begin(), has_member.end(), false) != has_member.end())
        throw InvalidInput("pattern: no rib reaches the pole; choose the ribs of the other direction");
}

} // namespace

Pattern pattern_from_name(const std::string &name) {
    return value_from_name(names_of_patterns(), name, "pattern");
}
std::string pattern_name(Pattern pattern) {
    return rule_of(pattern).name;
}
std::vector<std::string> pattern_names() {
    std::vector<std::string> names;
    for (const PatternRule &rule : pattern_rules())
        names.emplace_back(rule.name);
    return names;
}

std::array<double, 2> cell_extent(Pattern pattern) {
    const PatternRule &rule = rule_of(pattern);
    return {rule.cell_u, rule.cell_v};
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

    const PatternRule &rule = rule_of(recipe_.pattern);
    const auto to_multiple = [](Index cells, bool closed, Index period) {
        return closed ? (cells + period - 1) / period * period : cells;
    };
    recipe_.cells_u = to_multiple(recipe_.cells_u, recipe_.closed_u, rule.period_u);
    recipe_.cells_v = to_multiple(recipe_.cells_v, recipe_.closed_v, rule.period_v);

    PatternGrid grid(recipe_, rule.points_u, rule.points_v);
    rule.lay(grid);
    grid.remove_doubles();
    check_every_node_has_a_member(grid);

    uv_.resize(static_cast<Index>(grid.uv.size()), 2);
    for (Index i = 0; i < uv_.rows(); ++i)
        uv_.row(i) << grid.uv[i][0], grid.uv[i][1];
    members_ = std::move(grid.members);
    panels_ = std::move(grid.panels);

    if (!recipe_.closed_u)
        for (const auto &[side, p] : {std::pair{Side::u_min, 0}, std::pair{Side::u_max, grid.last_u()}})
            if (!has(side))
                sides_[side] = grid.column(p);
    if (!recipe_.closed_v)
        for (const auto &[side, q] : {std::pair{Side::v_min, 0}, std::pair{Side::v_max, grid.last_v()}})
            if (!has(side))
                sides_[side] = grid.row(q);
    if (!recipe_.closed_u && !recipe_.closed_v) {
        corners_ = {grid.node(0, 0), grid.node(grid.last_u(), 0), grid.node(grid.last_u(), grid.last_v()),
                    grid.node(0, grid.last_v())};
        std::sort(corners_.begin(), corners_.end());
        corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    }
    points_.reserve(static_cast<std::size_t>(recipe_.cells_u + 1) * (recipe_.cells_v + 1));
    for (Index j = 0; j <= recipe_.cells_v; ++j)
        for (Index i = 0; i <= recipe_.cells_u; ++i)
            points_.push_back(grid.node(i * rule.points_u, j * rule.points_v));
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
