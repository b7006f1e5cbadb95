// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Hard cases of size: poles of high valence and graded nets (14), all mass in one node and no mass (15), far
/// from the origin and in any unit (19), many nodes (23), and that the same input gives the same answer.
#include "certificate.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

namespace funicular::test {

namespace {

AxialStiffness axial(double ea) {
    return {Eigen::VectorXd::Constant(1, ea)};
}

ScenePtr on(const NetPtr &net, const std::vector<Index> &held, std::vector<EffectDescription> effects) {
    effects.insert(effects.begin(), axial(1e5));
    return std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = held}}, effects);
}

TEST(HardCase14_PolesAndGrading, ADomeOfTwoHundredMeridians) {
    const Index around = sized(200, 60);
    const auto scene = hemisphere(around, 10, 10, 1e6, true, 5, 30);
    const auto result = solved(scene);
    expect_certified(scene, result);
    // Every meridian is the same: nodes of one ring are level, and as far from the axis as one another.
    const Points &uv_order = result.nodes;
    const auto &uv = scene->net().lattice()->uv();
    Eigen::Index apex = 0;
    uv_order.col(2).maxCoeff(&apex);
    EXPECT_NEAR(uv(apex, 1), 1, 1e-12) << "the apex is the pole";
    EXPECT_LT(uv_order.row(apex).head<2>().norm(), 1e-9);
    for (Index i = 0; i < scene->net().node_count(); ++i)
        for (const Index other : {(i / around) * around}) {
            if (i == apex || other == apex)
                continue;
            EXPECT_NEAR(uv_order(i, 2), uv_order(other, 2), 1e-8);
            EXPECT_NEAR(uv_order.row(i).head<2>().norm(), uv_order.row(other).head<2>().norm(), 1e-8);
        }
}

TEST(HardCase14_PolesAndGrading, ANetGradedOneToAThousand) {
    // Cells from 1 to 1000 times the smallest, each way.
    constexpr Index cells = 20;
    LatticeRecipe recipe;
    recipe.cells_u = recipe.cells_v = cells;
    auto lattice = std::make_shared<const Lattice>(recipe);
    const auto place = [](double u) { return 10 * std::expm1(u * std::log(1500.0)) / 1499; };
    Points nodes = Points::Zero(lattice->uv().rows(), 3);
    for (Index i = 0; i < nodes.rows(); ++i)
        nodes.row(i) << place(lattice->uv()(i, 0)), place(lattice->uv()(i, 1)), 0;
    const auto net = make_net(lattice, nodes);
    EXPECT_GT(net->source_lengths().maxCoeff() / net->source_lengths().minCoeff(), 1000);
    for (const auto &held : {lattice->corners(), net->border()}) {
        const auto scene = on(net, held, {MemberWeight{5}, CoveringWeight{20}});
        const auto result = solved_in_any_numbering(scene, 1e-8);
        EXPECT_TRUE(certify(*scene, result.centred_nodes, nullptr, 1e-9).tension_members.empty());
    }
}

TEST(HardCase14_PolesAndGrading, TheUnevennessOfAChainDoesNotChangeItsCurve) {
    // Nodes crowd a thousandfold at one end: the curve is that of even members, but for the discretisation.
    constexpr Index n = 400;
    Points nodes = Points::Zero(n + 1, 3);
    for (Index i = 0; i <= n; ++i)
        nodes(i, 0) = 10 * std::expm1(std::log(1000.0) * i / n) / 999;
    const auto net = chain_net(nodes);
    const auto scene = std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, n}}},
        std::vector<EffectDescription>{axial(1e5), MemberWeight{1 / standard_gravity}},
        1.05 * net->source_lengths());
    const auto result = solved(scene);
    expect_certified(scene, result, 1e-8);
    const auto even = solved(catenary(n, 10, 10.5, 1e5, 1));
    EXPECT_NEAR(result.nodes.col(2).maxCoeff(), even.nodes.col(2).maxCoeff(), 5e-4);
}

TEST(HardCase15_MassInOneNode, AllOfItOnOneNodeOfASheet) {
    const auto net = flat_sheet(6, 6, 1);
    for (const double force : {1.0, 1e3}) {
        const auto scene = on(net, net->lattice()->corners(), {PointLoad{{24}, {0, 0, -force}}});
        const auto result = solved(scene);
        expect_certified(scene, result, 1e-8);
        EXPECT_NEAR(result.reactions.col(2).sum(), force, 1e-9 * force);
        Eigen::Index highest = 0;
        result.nodes.col(2).maxCoeff(&highest);
        EXPECT_EQ(highest, 24);
    }
}

TEST(HardCase15_MassInOneNode, ACableUnderOneLoadIsTwoStraightLines) {
    constexpr Index n = 10;
    const auto net = straight_chain(n, 10);
    for (const double force : {1e-2, 1.0, 1e4}) {
        const auto scene = on(net, {0, n}, {PointLoad{{3}, {0, 0, -force}}});
        const auto result = solved_in_any_numbering(scene, 1e-9);
        // Nodes without load lie on straight lines to the loaded one, at equal distances.
        const Points &at = result.nodes;
        for (Index i = 1; i < 3; ++i)
            EXPECT_LT((at.row(i) - at.row(0) - i / 3.0 * (at.row(3) - at.row(0))).norm(), 1e-9);
        for (Index i = 4; i < n; ++i)
            EXPECT_LT((at.row(i) - at.row(3) - (i - 3) / 7.0 * (at.row(n) - at.row(3))).norm(), 1e-9);
        // One thrust from end to end, and the moments about the ends.
        const double rounding = 1e-14 * 1e5; // of a position, times the stiffness
        EXPECT_NEAR(result.reactions(0, 0), -result.reactions(n, 0), 1e-9 * force + rounding);
        EXPECT_NEAR(result.reactions(n, 2), force * at(3, 0) / 10, 1e-8 * force + rounding);
    }
}

TEST(HardCase15_MassInOneNode, NoWeightAtAllLeavesASlackNetWhereItIs) {
    // WithoutLoadsATautNetIsAtRest in test_solve.cpp has the flat one; here none of its forms is flat.
    auto parts = parts_of(*warped_roof());
    parts.effects = {axial(1e5), MemberWeight{0}, CoveringWeight{0}, PointLoad{{3}, Vector3::Zero()}};
    const auto result = solved_in_any_numbering(parts.scene());
    EXPECT_LT(distance(result.nodes, parts.nodes), 1e-12);
    // Taut, it is a minimal net: no reaction in sum, every member pulls.
    parts.rest_lengths *= 0.3;
    const auto taut = solved_in_any_numbering(parts.scene());
    EXPECT_LT(taut.member_forces.maxCoeff(), 0);
    EXPECT_LT(taut.reactions.colwise().sum().norm(), 1e-9 * taut.member_forces.cwiseAbs().maxCoeff());
}

/// The same roof drawn in another unit and place: EA / (wL s), EA / (wA s²) kept.
ScenePtr drawn(double scale, const Vector3 &place) {
    auto parts = parts_of(*warped_roof());
    parts.nodes = (parts.nodes * scale).rowwise() + place.transpose();
    parts.rest_lengths *= scale;
    parts.effects = {axial(1e5), MemberWeight{12 / scale}, CoveringWeight{30 / scale / scale},
                     PointLoad{{20, 31}, {100, -50, -400}}, Snow{700 / scale / scale}};
    return parts.scene();
}

TEST(HardCase19_UnitsAndPlace, FromMicrometresToKilometresAndAMillionMetresOff) {
    const auto reference = solved(drawn(1, Vector3::Zero()));
    expect_certified(drawn(1, Vector3::Zero()), reference);
    for (const double scale : {1e-6, 1e-3, 1e3})
        for (const double offset : {0.0, 1e6}) {
            if (offset > 0 && scale < 1e-3)
                continue; // coordinates themselves hold 1e-10 m there, a hundred-thousandth of that net's
                          // size
            const Vector3 place = offset * Vector3(1, -1, 0.5);
            const auto scene = drawn(scale, place);
            const auto result = solved(scene);
            expect_certified(scene, result, 1e-8);
            const double rounding = 1e-15 * offset / scale;
            const Points shape = (result.centred_nodes.rowwise() - result.centred_nodes.row(0)) / scale;
            const Points expected = reference.centred_nodes.rowwise() - reference.centred_nodes.row(0);
            EXPECT_LT(distance(shape, expected), 1e-9 + 10 * rounding) << scale << " m, " << offset;
        }
}

TEST(HardCase19_UnitsAndPlace, AMicrometreNetAMillionMetresOffIsRefusedOrInEquilibrium) {
    // 8 µm wide where neighbouring numbers are 0.1 nm apart: what was drawn is lost, but nothing else goes
    // wrong.
    try {
        const auto scene = drawn(1e-6, Vector3(1e6, -1e6, 5e5));
        const auto result = solve(scene);
        EXPECT_TRUE(result.nodes.allFinite());
        if (result.status == Status::converged) {
            EXPECT_TRUE(certify(*scene, result.centred_nodes, nullptr, 1e-6).in_equilibrium);
        }
    } catch (const InvalidInput &error) {
        expect_words(error.what(), {"has no length"});
    }
}

// A million nodes are a matter for the benchmark; here as many as a few seconds allow.
TEST(HardCase23_ManyNodes, AChainOfAHundredThousandIsTheCatenary) {
    const Index n = sized(100'000, 2'000);
    // From the shape of a coarse chain, as Newton's method takes dozens of steps from a flat one. Rounding
    // alone makes a residual of about ε EA n² / (w L): 3e-6.
    const Index coarse_n = n / 100;
    const auto coarse = solve(catenary(coarse_n, 10, 12, 10, 1));
    SolveOptions options;
    options.tolerance = 1e-5;
    options.start = Points(n + 1, 3);
    for (Index i = 0; i <= n; ++i) {
        const Index from = std::min(i / 100, coarse_n - 1);
        const double part = i / 100.0 - from;
        options.start->row(i) = (1 - part) * coarse.nodes.row(from) + part * coarse.nodes.row(from + 1);
    }
    const auto scene = catenary(n, 10, 12, 10, 1);
    const auto result = solve(scene, options);
    expect_certified(scene, result, options.tolerance);
    EXPECT_NEAR(result.nodes.col(2).maxCoeff(), 6.896612043, 1e-4);
}

TEST(HardCase23_ManyNodes, AStripOfAHundredThousandIsAsHighAllAlong) {
    // A vault 4 cells wide: far from its ends each cross section is the same arch.
    const Index along = sized(20'000, 400);
    const auto net = flat_sheet(along * 0.5, 2, 0.5);
    std::vector<Index> held = net->lattice()->sides().at(Side::v_min);
    for (const Index node : net->lattice()->sides().at(Side::v_max))
        held.push_back(node);
    SolveOptions options;
    options.accuracy = 1e-5;
    const auto scene = on(net, held, {MemberWeight{5}, CoveringWeight{20}});
    const auto result = solve(scene, options);
    expect_certified(scene, result, 1e-6);
    const Index crown = 2 * (along + 1);
    for (const Index at : {along / 4, along / 2, 3 * along / 4})
        EXPECT_NEAR(result.nodes(crown + at, 2), result.nodes(crown + along / 3, 2), 1e-4);
}

TEST(HardCase23_ManyNodes, ASheetOfAHundredThousandRisesAsItsRefinementsDo) {
    // The rises of coarser ones (test_oracles.cpp) go to 1.4870884 m with the square of the step.
    const Index cells = sized(316, 20);
    const auto net = flat_sheet(10, 10, 10.0 / cells);
    const auto scene = on(net, net->border(), {MemberWeight{500 / standard_gravity}});
    SolveOptions options;
    options.accuracy = 1e-7;
    const auto result = solve(scene, options);
    expect_certified(scene, result, 1e-6);
    EXPECT_NEAR(result.nodes.col(2).maxCoeff(), cells == 316 ? 1.4870878 : 1.486945, 1e-6);
}

TEST(Determinism, TheSameInputTwiceIsTheSameBitForBit) {
    for (const auto &make :
         {+[] { return warped_roof(); }, +[] { return hemisphere(16, 8, 5, 1e7, true, 20, 30); },
          +[] { return catenary(40, 10, 12, 100, 1); }}) {
        const auto first = solve(make());
        std::array<Result, 2> at_once;
        std::thread other([&] { at_once[0] = solve(make()); });
        at_once[1] = solve(make());
        other.join();
        for (const auto &result : at_once) {
            EXPECT_EQ(result.nodes, first.nodes);
            EXPECT_EQ(result.member_forces, first.member_forces);
            EXPECT_EQ(result.reactions, first.reactions);
            EXPECT_EQ(result.iterations, first.iterations);
            EXPECT_EQ(result.residual, first.residual);
            EXPECT_EQ(result.position_error, first.position_error);
        }
    }
}

} // namespace
} // namespace funicular::test
