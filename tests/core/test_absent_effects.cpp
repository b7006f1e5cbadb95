// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// A scene computes and holds what its effects need, and nothing for those it does not have.
#include "equilibrium.hpp"
#include "scenes.hpp"

#include <atomic>
#include <cstdlib>
#include <new>
#include <set>

namespace {
std::atomic<std::size_t> allocated_bytes{0};
std::atomic<std::size_t> allocations{0};
} // namespace

// The pair below matches; inlined into its callers, GCC no longer sees that.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

// Counting every allocation of this program is what makes "holds no memory" something a test can see.
void *operator new(std::size_t size) {
    allocated_bytes += size;
    ++allocations;
    if (void *memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}
void operator delete(void *memory) noexcept {
    std::free(memory);
}
void operator delete(void *memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}

namespace funicular::test {

namespace {

std::set<std::string> evaluated(const std::vector<EffectDescription> &loads) {
    auto net = flat_sheet(4, 4, 1);
    const auto corners = net->lattice()->corners();
    std::vector<EffectDescription> effects{AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)}};
    effects.insert(effects.end(), loads.begin(), loads.end());
    const auto result = solve(std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = corners}}, effects));
    EXPECT_EQ(result.status, Status::converged) << result.message;
    std::set<std::string> names;
    for (const auto &[name, cost] : result.costs) {
        EXPECT_GT(cost.evaluations, 0) << name;
        names.insert(name);
    }
    return names;
}

TEST(AbsentEffects, AreNeverEvaluated) {
    using Names = std::set<std::string>;
    EXPECT_EQ(evaluated({MemberWeight{10}}), (Names{"axial", "member_weight"}));
    EXPECT_EQ(evaluated({CoveringWeight{10}}), (Names{"axial", "covering_weight"}));
    EXPECT_EQ(evaluated({Snow{100}}), (Names{"axial", "snow"}));
    EXPECT_EQ(evaluated({PointLoad{{12}, {0, 0, -50}}}), (Names{"axial", "point_load"}));
    EXPECT_EQ(evaluated({MemberWeight{10}, CoveringWeight{0}, Snow{0}}), (Names{"axial", "member_weight"}));
    EXPECT_EQ(evaluated({MemberWeight{10}, CoveringWeight{5}, Snow{50}, PointLoad{{12}, {0, 0, -50}}}),
              (Names{"axial", "covering_weight", "member_weight", "point_load", "snow"}));
}

struct Memory {
    std::size_t bytes, count;
    bool operator==(const Memory &) const = default;
};

Memory memory_for(const NetPtr &net, const std::vector<EffectDescription> &effects) {
    const std::vector<Support> supports{{.kind = SupportKind::fixed, .nodes = {0, 4, 20, 24}}};
    const std::size_t bytes_before = allocated_bytes;
    const std::size_t count_before = allocations;
    const auto scene = std::make_shared<const Scene>(net, supports, effects);
    const auto result = solve(scene);
    EXPECT_EQ(result.status, Status::converged);
    return {allocated_bytes - bytes_before, allocations - count_before};
}

TEST(AbsentEffects, HoldNoMemory) {
    // Panels that no effect looks at cost a scene and its solution not one allocation.
    const auto sheet = flat_sheet(4, 4, 1);
    const auto with_panels = std::make_shared<const Net>(sheet->nodes(), sheet->members(), sheet->panels());
    const auto without_panels = std::make_shared<const Net>(sheet->nodes(), sheet->members());
    const EffectDescription axial = AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)};
    const EffectDescription weight = MemberWeight{10};
    const auto bare = memory_for(without_panels, {axial, weight});
    EXPECT_EQ(memory_for(with_panels, {axial, weight}), bare);
    EXPECT_GT(memory_for(with_panels, {axial, weight, CoveringWeight{10}}).bytes, bare.bytes);
}

TEST(AbsentEffects, AddNothingToTheTangent) {
    const auto net = flat_sheet(4, 4, 1);
    const std::vector<Support> supports{{.kind = SupportKind::fixed, .nodes = {0}}};
    const EffectDescription axial = AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)};
    const auto blocks = [&](const std::vector<EffectDescription> &effects) {
        const Equilibrium equilibrium(std::make_shared<const Scene>(net, supports, effects));
        return BlockMatrix(equilibrium.coupling()).block_count();
    };
    const std::size_t members_only = net->node_count() + 2 * net->member_count();
    EXPECT_EQ(blocks({axial, MemberWeight{10}, PointLoad{{3}, {0, 0, -1}}}), members_only);
    EXPECT_EQ(blocks({axial, CoveringWeight{10}}), members_only + 4 * net->panels().size())
        << "each panel's two diagonals";
}

TEST(Relaxation, AllocatesNothingPerIteration) {
    const auto scene = warped_roof();
    const auto allocations_of = [&scene](long iterations) {
        SolveOptions options;
        options.method = Method::relaxation;
        options.max_iterations = iterations;
        options.tolerance = 1e-15;
        Solver solver(scene, options);
        const std::size_t before = allocations;
        while (!solver.advance())
            ;
        return allocations - before;
    };
    // The history grows by doubling, and each load effect has one work space an evaluation.
    const auto per_iteration = static_cast<double>(allocations_of(2000) - allocations_of(1000)) / 1000;
    EXPECT_LT(per_iteration, 12);
}

} // namespace
} // namespace funicular::test
