// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coarser_scene.hpp"

#include "errors.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace funicular {

namespace {

PointLoad at_nodes(std::vector<Index> nodes, const Vector3 &force) {
    return {.nodes = std::move(nodes), .force = force};
}

/// Loads on nodes that are left out pass to those beside them.
void pass_on(const std::vector<PointLoad> &loads, const Coarsening &coarsening,
             std::vector<EffectDescription> &effects) {
    std::map<Index, Vector3> forces;
    for (const PointLoad &load : loads)
        for (const Index node : load.nodes)
            for (const auto &[parent, part] : coarsening.parents(node))
                forces.try_emplace(parent, Vector3::Zero()).first->second += part * load.force;
    std::map<std::array<double, 3>, std::vector<Index>> nodes_by_force;
    for (const auto &[node, force] : forces)
        nodes_by_force[{force[0], force[1], force[2]}].push_back(node);
    for (auto &[force, nodes] : nodes_by_force)
        effects.emplace_back(at_nodes(std::move(nodes), Vector3(force.data())));
}

} // namespace

std::vector<EffectDescription> effects_on(const LatticeLevel &level,
                                          const std::vector<EffectDescription> &effects) {
    std::vector<EffectDescription> passed;
    std::vector<PointLoad> point_loads;
    for (const auto &effect : effects) {
        if (std::holds_alternative<AxialStiffness>(effect))
            passed.emplace_back(level.stiffness);
        else if (const auto *members = std::get_if<MemberWeight>(&effect))
            passed.emplace_back(MemberWeight{.per_length = members->per_length, .lines = level.lines});
        else if (const auto *load = std::get_if<PointLoad>(&effect))
            point_loads.push_back(*load);
        else
            passed.push_back(effect);
    }
    pass_on(point_loads, level.coarsening, passed);
    return passed;
}

namespace {

/// \throws InvalidInput for a support that none of the kept nodes stands for.
void check_supports_are_kept(const Scene &scene, const Coarsening &coarsening) {
    const Index count = scene.net().node_count();
    std::vector<bool> is_kept(count, false);
    for (const Index node : coarsening.fine_nodes())
        is_kept[node] = true;
    for (const Support &support : scene.supports()) {
        // By this one and by others of its kind: a border may be held by several.
        std::vector<bool> is_held(count, false);
        for (const Support &like : scene.supports())
            if (like.kind == support.kind && like.direction == support.direction)
                for (const Index node : like.nodes)
                    is_held[node] = true;
        for (const Index node : support.nodes) {
            const auto parents = coarsening.parents(node);
            const bool between_held = std::all_of(parents.begin(), parents.end(), [&](const auto &parent) {
                return is_held[coarsening.fine_nodes()[parent.node]];
            });
            if (!is_kept[node] && !between_held)
                throw InvalidInput(
                    "scene: node " + std::to_string(node) +
                    " is supported, lies on a line that a net of twice the step does not have, "
                    "and its neighbours are not supported alike: choose a step that puts a kept "
                    "node there (every second one, counted from the corner)");
        }
    }
}

/// \throws InvalidInput where panels that bear loads are missing: a coarser net has all of them.
void check_panels_are_whole(const Scene &scene, const Coarsening &coarsening) {
    const bool bears_loads =
        std::any_of(scene.effects().begin(), scene.effects().end(), [](const EffectDescription &effect) {
            return std::holds_alternative<CoveringWeight>(effect) || std::holds_alternative<Snow>(effect);
        });
    if (bears_loads && scene.net().panels().size() != coarsening.fine()->panels().size())
        throw InvalidInput("scene: its net has openings, which nets of larger steps would cover");
}

} // namespace

CoarserScene coarser_scene(const Scene &scene) {
    const auto level = coarser_level(scene);
    if (!level)
        throw InvalidInput(
            "scene: its net is no lattice of quads or ribs with four cells or more in a direction "
            "(eight around a closed one), so that no net of twice the step says how far it is "
            "from a smooth surface");
    check_panels_are_whole(scene, level->coarsening);
    check_supports_are_kept(scene, level->coarsening);
    // As long as they would be on the source with twice the step: chords of chords.
    const Eigen::VectorXd in_rows = summed_in_rows(scene, *level, scene.net().source_lengths());
    Eigen::VectorXd rest =
        level->rest_lengths.cwiseProduct(level->net->source_lengths().cwiseQuotient(in_rows));
    return {std::make_shared<const Scene>(level->net, level->supports, effects_on(*level, scene.effects()),
                                          std::move(rest)),
            level->coarsening.fine_nodes()};
}

} // namespace funicular
