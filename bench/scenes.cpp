// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scenes.hpp"

#include "errors.hpp"
#include "lattice.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace funicular::bench {

namespace {

constexpr double sheet_side = 10;     // [m]
constexpr double dome_radius = 10;    // [m]
constexpr double roof_height = 3;     // [m]
constexpr double soft_ea = 100e3;     // [N]
constexpr double stiff_ea = 100e6;    // [N]
constexpr double sheet_load = 500;    // [N/m]
constexpr double rib_load = 250;      // [N/m]
constexpr double covering_load = 500; // [N/m²]

[[noreturn]] void refuse(const std::string &scene) {
    throw InvalidInput("scene '" + scene + "' is not known; choose one of: S, S100, S_bare, S_gap, C, D, T");
}

Index nodes_a_side(Index node_count) {
    return static_cast<Index>(std::lround(std::sqrt(static_cast<double>(node_count))));
}

NetPtr sheet(Index side) {
    return flat_sheet(sheet_side, sheet_side, sheet_side / (side - 1));
}

NetPtr without_lattice(const Net &net) {
    return std::make_shared<const Net>(net.nodes(), net.members(), net.panels());
}

/// Without the member in the middle, so that it is no lattice.
NetPtr with_gap(const Net &net) {
    auto members = net.members();
    members.erase(members.begin() + net.member_count() / 4);
    return std::make_shared<const Net>(net.nodes(), std::move(members), net.panels());
}

NetPtr dome(Index node_count) {
    // Four times as many meridians as hoops make cells about square at the base.
    const auto up = static_cast<Index>(std::lround(std::sqrt((node_count - 1) / 4.0)));
    LatticeRecipe recipe;
    recipe.cells_u = 4 * up;
    recipe.cells_v = up;
    recipe.closed_u = true;
    recipe.poles = {Side::v_max};
    auto lattice = std::make_shared<const Lattice>(recipe);
    Points nodes(lattice->uv().rows(), 3);
    for (Index i = 0; i < nodes.rows(); ++i) {
        const double azimuth = 2 * std::numbers::pi * lattice->uv()(i, 0);
        const double height = std::numbers::pi / 2 * lattice->uv()(i, 1);
        nodes.row(i) << dome_radius * std::cos(height) * std::cos(azimuth),
            dome_radius * std::cos(height) * std::sin(azimuth), dome_radius * std::sin(height);
    }
    return funicular::make_net(lattice, nodes);
}

/// Smooth, without symmetry, between 0 and the roof's height.
double free_form_height(double x, double y) {
    const double waves = std::sin(2.1 * x / sheet_side + 0.4) * std::cos(1.7 * y / sheet_side - 0.3) +
                         0.35 * std::sin(5.3 * x / sheet_side + 3.1 * y / sheet_side) +
                         0.25 * std::cos(7.7 * y / sheet_side - 4.3 * x / sheet_side + 1.0);
    return roof_height * 0.5 * (1 + waves / 1.6);
}

NetPtr free_form_roof(Index side) {
    const auto at = [side](Index i, Index j) { return j * side + i; };
    const double step = sheet_side / (side - 1);
    Points nodes(side * side, 3);
    for (Index j = 0; j < side; ++j)
        for (Index i = 0; i < side; ++i)
            nodes.row(at(i, j)) << i * step, j * step, free_form_height(i * step, j * step);

    std::vector<Member> members;
    Panels panels;
    for (Index j = 0; j < side; ++j)
        for (Index i = 0; i < side; ++i) {
            if (i + 1 < side)
                members.push_back({at(i, j), at(i + 1, j)});
            if (j + 1 < side)
                members.push_back({at(i, j), at(i, j + 1)});
            if (i + 1 == side || j + 1 == side)
                continue;
            members.push_back({at(i, j), at(i + 1, j + 1)});
            panels.add(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            panels.add(std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return std::make_shared<const Net>(std::move(nodes), std::move(members), std::move(panels));
}

} // namespace

NetPtr make_net(const std::string &scene, Index node_count) {
    if (scene == "S" || scene == "S100" || scene == "C")
        return sheet(nodes_a_side(node_count));
    if (scene == "S_bare")
        return without_lattice(*sheet(nodes_a_side(node_count)));
    if (scene == "S_gap")
        return with_gap(*sheet(nodes_a_side(node_count)));
    if (scene == "D")
        return dome(node_count);
    if (scene == "T")
        return free_form_roof(nodes_a_side(node_count));
    refuse(scene);
}

ScenePtr make_scene(const std::string &scene, const NetPtr &net, double weight_factor) {
    std::vector<Index> held;
    if (scene == "C")
        held = net->lattice()->corners();
    else if (scene == "D")
        held = net->lattice()->sides().at(Side::v_min);
    else
        held = net->border();

    std::vector<EffectDescription> effects;
    if (scene == "D" || scene == "T")
        effects = {AxialStiffness{Eigen::VectorXd::Constant(1, stiff_ea)},
                   MemberWeight{weight_factor * rib_load / standard_gravity},
                   CoveringWeight{weight_factor * covering_load / standard_gravity}};
    else if (scene == "S" || scene == "S100" || scene == "S_bare" || scene == "S_gap" || scene == "C")
        effects = {AxialStiffness{Eigen::VectorXd::Constant(1, scene == "S100" ? 100 * soft_ea : soft_ea)},
                   MemberWeight{weight_factor * sheet_load / standard_gravity}};
    else
        refuse(scene);
    return std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = held}}, effects);
}

double rise(const Points &nodes) {
    return nodes.col(2).maxCoeff() - nodes.col(2).minCoeff();
}

} // namespace funicular::bench
