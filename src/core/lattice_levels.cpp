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

/// A net on its way from the scene's own to the coarsest.
struct Thinning {
    std::shared_ptr<const Lattice> lattice;
    const Net *net;
    Eigen::VectorXd stiffness; ///< [N/m]
    Eigen::VectorXd rest;      ///< [m]
    Eigen::VectorXd lines;
    std::vector<Support> supports;
    bool compression_only;
};

Eigen::VectorXd spring_stiffness(const Scene &scene) {
    return scene.axial().stiffness() * (scene.scale().force / scene.scale().length);
}

/// How many lines members stand for: more than one each where the scene is itself the coarser one of another.
Eigen::VectorXd lines_of(const Scene &scene) {
    for (const auto &effect : scene.effects())
        if (const auto *weight = std::get_if<MemberWeight>(&effect); weight && weight->lines.size() > 0)
            return weight->lines;
    return Eigen::VectorXd::Ones(scene.net().member_count());
}

Thinning begun(const Scene &scene) {
    const Net &net = scene.net();
    return {.lattice = net.lattice() ? net.lattice() : recognised_lattice(net),
            .net = &net,
            .stiffness = spring_stiffness(scene),
            .rest = scene.rest_lengths(),
            .lines = lines_of(scene),
            .supports = scene.supports(),
            .compression_only = scene.axial().is_compression_only()};
}

double in_series(const Coarsening::Strand &strand, const Eigen::VectorXd &stiffness) {
    return strand.part * (strand.second < 0
                              ? stiffness[strand.first]
                              : 1 / (1 / stiffness[strand.first] + 1 / stiffness[strand.second]));
}

/// The next coarser net, to which `thinning` then has come; none if there is none.
std::optional<LatticeLevel> next_level(Thinning &thinning) {
    auto coarsening = Coarsening::of(thinning.lattice);
    auto net = coarsening ? thinned(*thinning.net, *coarsening) : nullptr;
    if (!net)
        return std::nullopt;
    Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(net->member_count());
    Eigen::VectorXd rest = stiffness;
    Eigen::VectorXd lines = stiffness;
    for (const auto &strand : coarsening->strands()) {
        const auto &[member, first, second, part] = strand;
        const bool single = second < 0;
        const double k = in_series(strand, thinning.stiffness);
        stiffness[member] += k;
        rest[member] += k * (thinning.rest[first] + (single ? 0 : thinning.rest[second]));
        lines[member] +=
            part * (single ? thinning.lines[first] : (thinning.lines[first] + thinning.lines[second]) / 2);
    }
    thinning.rest = rest.cwiseQuotient(stiffness);
    thinning.stiffness = std::move(stiffness);
    thinning.lines = std::move(lines);
    thinning.supports = passed_on(thinning.supports, *coarsening);
    thinning.net = net.get();
    thinning.lattice = net->lattice();
    AxialStiffness springs{
        .stiffness = thinning.stiffness, .compression_only = thinning.compression_only, .per_spring = true};
    return LatticeLevel{.coarsening = *std::move(coarsening),
                        .net = std::move(net),
                        .stiffness = std::move(springs),
                        .rest_lengths = thinning.rest,
                        .supports = thinning.supports,
                        .lines = thinning.lines};
}

} // namespace

std::optional<LatticeLevel> coarser_level(const Scene &scene) {
    Thinning thinning = begun(scene);
    return next_level(thinning);
}

Eigen::VectorXd summed_in_rows(const Scene &scene, const LatticeLevel &level, const Eigen::VectorXd &values) {
    const Eigen::VectorXd stiffness = spring_stiffness(scene);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(level.net->member_count());
    Eigen::VectorXd weights = sums;
    for (const auto &strand : level.coarsening.strands()) {
        const double k = in_series(strand, stiffness);
        weights[strand.coarse_member] += k;
        sums[strand.coarse_member] +=
            k * (values[strand.first] + (strand.second < 0 ? 0 : values[strand.second]));
    }
    return sums.cwiseQuotient(weights);
}

CoarserLevels coarser_levels(const Scene &scene) {
    std::vector<LatticeLevel> levels;
    Thinning thinning = begun(scene);
    // Multigrid sweeps along the lines both ways.
    if (thinning.lattice && thinning.lattice->recipe().pattern == Pattern::quad)
        while (auto level = next_level(thinning))
            levels.push_back(*std::move(level));
    if (!levels.empty() && levels.back().net->node_count() > most_nodes_of_coarsest)
        levels.clear();
    return CoarserLevels(std::make_shared<const std::vector<LatticeLevel>>(std::move(levels)));
}

} // namespace funicular
