// SPDX-License-Identifier: LGPL-2.1-or-later
#include "lattice_levels.hpp"

#include "effects/axial.hpp"
#include "errors.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace funicular {

namespace {

/// Null if two neighbours of the coarse lattice coincide in space.
std::shared_ptr<const Net> thinned(const Net &fine, const Coarsening &coarsening) {
    const auto &kept = coarsening.fine_nodes();
    Points nodes(static_cast<Eigen::Index>(kept.size()), 3);
    for (std::size_t node = 0; node < kept.size(); ++node)
        nodes.row(static_cast<Eigen::Index>(node)) = fine.nodes().row(kept[node]);
    try {
        return make_net(coarsening.coarse(), std::move(nodes));
    } catch (const InvalidInput &) {
        return nullptr;
    }
}

std::vector<Support> passed_on(const std::vector<Support> &supports, const Coarsening &coarsening) {
    std::vector<Support> passed;
    for (const Support &support : supports) {
        // A rigid support stays one however small a part of it a node has.
        std::map<double, std::vector<Index>> nodes_by_part;
        for (const Index node : support.nodes)
            for (const auto &parent : coarsening.parents(node))
                nodes_by_part[std::isinf(support.stiffness) ? 1.0 : parent.part].push_back(parent.node);
        for (auto &[part, nodes] : nodes_by_part) {
            passed.push_back(support);
            passed.back().stiffness *= part;
            passed.back().nodes = std::move(nodes);
        }
    }
    return passed;
}

} // namespace

CoarserLevels coarser_levels(const Scene &scene) {
    std::vector<LatticeLevel> levels;
    const Net *fine = &scene.net();
    Eigen::VectorXd stiffness = scene.axial().stiffness() * (scene.scale().force / scene.scale().length);
    Eigen::VectorXd rest = scene.rest_lengths();
    Eigen::VectorXd lines = Eigen::VectorXd::Ones(rest.size());
    std::vector<Support> supports = scene.supports();
    while (auto coarsening = Coarsening::of(fine->lattice())) {
        auto net = thinned(*fine, *coarsening);
        if (!net)
            break;
        Eigen::VectorXd coarse_stiffness = Eigen::VectorXd::Zero(net->member_count());
        Eigen::VectorXd coarse_rest = coarse_stiffness;
        Eigen::VectorXd coarse_lines = coarse_stiffness;
        for (const auto &[member, first, second, part] : coarsening->strands()) {
            const bool single = second < 0;
            const double k =
                part * (single ? stiffness[first] : 1 / (1 / stiffness[first] + 1 / stiffness[second]));
            coarse_stiffness[member] += k;
            coarse_rest[member] += k * (rest[first] + (single ? 0 : rest[second]));
            coarse_lines[member] += part * (single ? lines[first] : (lines[first] + lines[second]) / 2);
        }
        rest = coarse_rest.cwiseQuotient(coarse_stiffness);
        stiffness = std::move(coarse_stiffness);
        lines = std::move(coarse_lines);
        supports = passed_on(supports, *coarsening);
        fine = net.get();
        levels.push_back({.coarsening = *std::move(coarsening),
                          .net = std::move(net),
                          .stiffness = {.stiffness = stiffness,
                                        .compression_only = scene.axial().is_compression_only(),
                                        .per_spring = true},
                          .rest_lengths = rest,
                          .supports = supports,
                          .lines = lines});
    }
    return CoarserLevels(std::make_shared<const std::vector<LatticeLevel>>(std::move(levels)));
}

} // namespace funicular
