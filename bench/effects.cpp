// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_matrix.hpp"
#include "effects/effect.hpp"
#include "equilibrium.hpp"
#include "lattice.hpp"
#include "measure.hpp"
#include "scenes.hpp"
#include "solve.hpp"
#include "solves.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace funicular::bench {

namespace {

using Effects = std::vector<EffectDescription>;

constexpr double stretch = 1.05;

/// A gently warped sheet of quads, so that no panel is plane.
NetPtr warped_sheet(Index side) {
    const auto flat = flat_sheet(10, 10, 10.0 / (side - 1));
    Points nodes = flat->nodes();
    for (Index i = 0; i < nodes.rows(); ++i)
        nodes(i, 2) = 0.3 * std::sin(nodes(i, 0)) + 0.2 * std::cos(1.3 * nodes(i, 1) + 0.4 * nodes(i, 0));
    return funicular::make_net(flat->lattice(), nodes);
}

ScenePtr scene_of(const NetPtr &net, const Effects &effects) {
    return std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->border()}}, effects);
}

std::vector<Index> every_node(const NetPtr &net) {
    std::vector<Index> nodes(net->node_count());
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
}

/// The members' pull, which every scene has, and loads, without which there is nothing to solve. They are at
/// every node: under a single one the net is solved in another way, whose memory is none of the effects'.
Effects least_effects(const NetPtr &net) {
    return {AxialStiffness{Eigen::VectorXd::Constant(1, 1e5)}, PointLoad{every_node(net), {0, 0, -1}}};
}

std::vector<std::pair<std::string, EffectDescription>> loads(const NetPtr &net) {
    return {{"member_weight", MemberWeight{12}},
            {"covering_weight_angle", CoveringWeight{30, CornerShare::angle}},
            {"covering_weight_equal", CoveringWeight{30, CornerShare::equal}},
            {"covering_weight_voronoi", CoveringWeight{30, CornerShare::voronoi}},
            {"snow", Snow{700}},
            {"point_load", PointLoad{every_node(net), {0, 0, -100}}}};
}

/// Bytes of the heap that a scene and its solver hold after a step.
double bytes_held(const NetPtr &net, const Effects &effects) {
    SolveOptions options;
    options.start = net->nodes() * stretch;
    const std::size_t before = live_heap();
    Solver solver(scene_of(net, effects), options);
    solver.advance(0);
    return static_cast<double>(live_heap()) - static_cast<double>(before);
}

/// Bytes of the heap that a load's presence adds, after a step.
double bytes_added(const NetPtr &net, const EffectDescription &load) {
    Effects effects = least_effects(net);
    // What is allocated once and for all is not the effect's.
    static_cast<void>(bytes_held(net, effects));
    const double without = bytes_held(net, effects);
    effects.push_back(load);
    return bytes_held(net, effects) - without;
}

/// An effect of a scene, and how many bytes it adds to one; found when it is asked for, and remembered.
struct Subject {
    ScenePtr scene;
    std::shared_ptr<const Effect> effect;
    std::function<double()> count_bytes;
    double bytes = -1;
};

using Work = std::function<void(const Effect &, const Points &, Points &forces, BlockMatrix &tangent)>;

void add(const std::string &name, const std::shared_ptr<Subject> &subject, const Work &work) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State &state) {
        const Scene &scene = *subject->scene;
        const Index nodes = scene.net().node_count();
        if (subject->count_bytes)
            subject->bytes = std::exchange(subject->count_bytes, nullptr)();
        const Points x = scene.scale().to_local(scene.net().nodes() * stretch);
        Points forces = Points::Zero(nodes, 3);
        BlockMatrix tangent(Equilibrium(subject->scene).coupling());
        for ([[maybe_unused]] auto once : state) {
            work(*subject->effect, x, forces, tangent);
            benchmark::ClobberMemory();
        }
        state.SetLabel("measured");
        state.counters["nodes"] = nodes;
        state.counters["ns_per_node"] = benchmark::Counter(
            1e-9 * nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
        state.counters["bytes_per_node"] = subject->bytes / nodes;
    });
}

void add_forces_and_tangent(const std::string &name, const Subject &of) {
    const auto subject = std::make_shared<Subject>(of);
    const std::string place = name + "/" + std::to_string(of.scene->net().node_count());
    add("forces/" + place, subject,
        [](const Effect &effect, const Points &x, Points &forces, BlockMatrix & /*tangent*/) {
            effect.add_forces(x, forces);
        });
    add("tangent/" + place, subject,
        [](const Effect &effect, const Points &x, Points & /*forces*/, BlockMatrix &tangent) {
            effect.add_tangent(x, tangent);
        });
}

} // namespace

void register_effects(Extent extent) {
    const NetPtr net = warped_sheet(extent == Extent::tiny ? 11 : 101);
    const ScenePtr bare = scene_of(net, least_effects(net));
    // Nothing is solved without the members' pull: theirs is all that such a scene holds.
    add_forces_and_tangent("axial", {.scene = bare, .effect = bare->acting().front(), .count_bytes = [net] {
                                         return bytes_held(net, least_effects(net));
                                     }});
    for (const auto &[name, load] : loads(net)) {
        Effects effects = least_effects(net);
        effects.push_back(load);
        const ScenePtr scene = scene_of(net, effects);
        add_forces_and_tangent(name, {.scene = scene,
                                      .effect = scene->acting().back(),
                                      .count_bytes = [net, load = load] { return bytes_added(net, load); }});
    }
}

} // namespace funicular::bench
