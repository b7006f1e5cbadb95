// SPDX-License-Identifier: LGPL-2.1-or-later
#include "lattice_levels.hpp"

#include "effects/axial.hpp"
#include "errors.hpp"
#include "lattice_recognition.hpp"

#include <map>
#include <tuple>
#include <utility>

namespace funicular {

namespace {

// The coarsest net is factorised as a dense matrix.
constexpr Index most_nodes_of_coarsest = 400;

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

/// Supports of the same kind on the same coarse node become one, so that they do not multiply from net to
/// net.
std::vector<Support> passed_on(const std::vector<Support> &supports, const Coarsening &coarsening) {
    using Sense = std::tuple<SupportKind, double, double, double>;
    std::map<Sense, std::map<Index, double>> stiffness;
    for (const Support &support : supports) {
        auto &nodes =
            stiffness[{support.kind, support.direction.x(), support.direction.y(), support.direction.z()}];
        // A rigid support stays one however small a part of it a node has.
        for (const Index node : support.nodes)
            for (const auto &parent : coarsening.parents(node))
                nodes[parent.node] += support.stiffness * parent.part;
    }
    std::vector<Support> passed;
    for (const auto &[sense, nodes] : stiffness) {
        const auto &[kind, x, y, z] = sense;
        std::map<double, std::vector<Index>> alike;
        for (const auto &[node, sum] : nodes)
            alike[sum].push_back(node);
        for (auto &[sum, of] : alike)
            passed.push_back(
                {.kind = kind, .nodes = std::move(of), .direction = Vector3(x, y, z), .stiffness = sum});
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
    auto lattice = fine->lattice() ? fine->lattice() : recognised_lattice(*fine);
    while (auto coarsening = Coarsening::of(lattice)) {
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
        lattice = net->lattice();
        AxialStiffness springs{.stiffness = stiffness,
                               .compression_only = scene.axial().is_compression_only(),
                               .per_spring = true};
        levels.push_back({.coarsening = *std::move(coarsening),
                          .net = std::move(net),
                          .stiffness = std::move(springs),
                          .rest_lengths = rest,
                          .supports = supports,
                          .lines = lines});
    }
    if (!levels.empty() && levels.back().net->node_count() > most_nodes_of_coarsest)
        levels.clear();
    return CoarserLevels(std::make_shared<const std::vector<LatticeLevel>>(std::move(levels)));
}

} // namespace funicular
