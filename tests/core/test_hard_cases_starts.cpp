// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Hard cases of where a solve begins: flat, without prestress, in the wrong sign, upright or overhanging,
/// with straight edges and along a line (1, 2, 3, 11, 12, 13).
#include "certificate.hpp"
#include "scenes.hpp"

#include <cmath>
#include <numbers>

namespace funicular::test {

namespace {

AxialStiffness axial(double ea, bool compression_only = true) {
    return {Eigen::VectorXd::Constant(1, ea), compression_only};
}

ScenePtr sheet(Index cells, bool on_corners, bool compression_only = true) {
    const auto net = flat_sheet(10, 10, 10.0 / cells);
    return std::make_shared<const Scene>(
        net,
        std::vector<Support>{
            {.kind = SupportKind::fixed, .nodes = on_corners ? net->lattice()->corners() : net->border()}},
        std::vector<EffectDescription>{axial(1e5, compression_only), MemberWeight{500 / standard_gravity}});
}

Result solved_from(const ScenePtr &scene, const Points &start) {
    SolveOptions options;
    options.tolerance = 1e-12;
    options.accuracy = 1e-11;
    options.start = start;
    return solve(scene, options);
}

// The rises of flat starts are oracles of test_oracles.cpp; here no start may lead anywhere else.
TEST(HardCase01_FlatStart, AnyStartWithoutHeightOrExtentLeadsToTheSameShape) {
    for (const bool on_corners : {false, true}) {
        const auto scene = sheet(12, on_corners);
        const Points &flat = scene->net().nodes();
        const auto reference = solved_in_any_numbering(scene);
        Points in_one_point = Points::Zero(flat.rows(), 3);
        in_one_point.rowwise() = scene->net().centre().transpose();
        Points on_one_line = flat;
        on_one_line.col(1).setConstant(5);
        Points upright = flat;
        upright.col(2) = flat.col(1);
        upright.col(1).setConstant(5);
        for (const Points &start : {in_one_point, on_one_line, upright}) {
            const auto result = solved_from(scene, start);
            expect_certified(scene, result);
            EXPECT_LT(distance(result.nodes, reference.nodes), 1e-9);
        }
    }
}

TEST(HardCase02_NoPrestress, TwoStraightMembersRiseByTheCubeRootOfTheirLoad) {
    // 2 k (l - r) z / l = P, with no stiffness at all where it begins.
    constexpr double k = 1000;
    for (const double load : {1e-9, 1e-6, 1e-3, 1.0, 1e3}) {
        const auto scene = std::make_shared<const Scene>(
            straight_chain(2, 2), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 2}}},
            std::vector<EffectDescription>{axial(k), PointLoad{{1}, {0, 0, -load}}});
        const auto result = solved(scene);
        expect_certified(scene, result);
        double low = 0;
        double high = 10;
        for (int step = 0; step < 200; ++step) {
            const double z = (low + high) / 2;
            const double stretch = z * z / (std::hypot(1, z) + 1);
            (2 * k * stretch * z / std::hypot(1, z) < load ? low : high) = z;
        }
        // The stretch z² / 2 is a difference of numbers near one.
        EXPECT_NEAR(result.nodes(1, 2), low, (1e-9 + 1e-15 / (low * low)) * low) << load;
    }
}

TEST(HardCase02_NoPrestress, AQuadNetFullOfMechanismsFindsItsForm) {
    // Free in its plane to first order: no member is taut, no panel braces it, and loads push sideways.
    const auto net = flat_sheet(6, 6, 0.75);
    std::vector<EffectDescription> effects{axial(1e6), MemberWeight{3}};
    effects.emplace_back(PointLoad{{30, 41, 52}, {40, -25, 0}});
    solved_in_any_numbering(std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}},
        effects));
}

TEST(HardCase02_NoPrestress, LooseEndsStandUpright) {
    // Branches that end in the air: each carries only itself, and the formula of a strand holds.
    Points nodes = Points::Zero(11, 3);
    std::vector<Member> members;
    for (Index i = 0; i <= 4; ++i) {
        nodes(i, 0) = i;
        if (i > 0)
            members.push_back({i - 1, i});
    }
    for (Index i = 5; i < 11; ++i) {
        nodes.row(i) << 2, i - 4, 0;
        members.push_back({i == 5 ? 2 : i - 1, i});
    }
    const auto scene =
        std::make_shared<const Scene>(std::make_shared<const Net>(nodes, members),
                                      std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 4}}},
                                      std::vector<EffectDescription>{axial(1000), MemberWeight{1}});
    const auto result = solved_in_any_numbering(scene);
    for (Index i = 5; i < 11; ++i) {
        EXPECT_NEAR(result.nodes(i, 0), 2, 1e-9);
        EXPECT_NEAR(result.nodes(i, 1), 0, 1e-9);
        EXPECT_GT(result.nodes(i, 2), result.nodes(i == 5 ? 2 : i - 1, 2) + 1);
    }
}

class HardCase03_WrongSign : public testing::TestWithParam<double> {};

TEST_P(HardCase03_WrongSign, AHangingStartLeadsToTheStandingDome) {
    for (const bool compression_only : {true, false}) {
        const auto scene = hemisphere(16, 8, 5, GetParam(), compression_only, 20, 30);
        const auto standing = solved(scene);
        expect_certified(scene, standing);
        Points hanging = scene->net().nodes();
        hanging.col(2) *= -1;
        const auto result = solved_from(scene, hanging);
        if (compression_only) {
            expect_certified(scene, result);
            EXPECT_LT(distance(result.nodes, standing.nodes), 1e-8);
        } else {
            // Two-way springs may rest hanging: that is in equilibrium, but must not be called compressed.
            expect_certified(scene, result);
            const auto certificate = certify(*scene, result.centred_nodes, nullptr, 1e-9);
            EXPECT_TRUE(distance(result.nodes, standing.nodes) < 1e-8 || !certificate.compression_only)
                << certificate.summary();
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Stiffness, HardCase03_WrongSign, testing::Values(1e5, 1e7, 1e9),
                         [](const auto &each) {
                             return "EA1e" + std::to_string(static_cast<int>(std::log10(each.param)));
                         });

TEST(HardCase03_WrongSign, ANetDrawnHangingIsFoundStanding) {
    auto parts = parts_of(*hemisphere(16, 8, 5, 1e6, true, 20, 30));
    const auto standing = solved(parts.scene());
    parts.nodes.col(2) *= -1;
    const auto result = solved_in_any_numbering(parts.scene());
    EXPECT_LT(distance(result.nodes, standing.nodes), 1e-9);
}

/// Upright walls that lean out, and a dome on them.
ScenePtr mushroom(bool with_snow) {
    constexpr Index around = 16;
    const std::vector<std::array<double, 2>> profile{{3, 0},   {3, 1},     {3, 2},    {3.4, 2.6},
                                                     {3.9, 3}, {3.6, 3.8}, {2.4, 4.5}};
    LatticeRecipe recipe;
    recipe.cells_u = around;
    recipe.cells_v = static_cast<Index>(profile.size());
    recipe.closed_u = true;
    recipe.poles = {Side::v_max};
    auto lattice = std::make_shared<const Lattice>(recipe);
    Points nodes(lattice->uv().rows(), 3);
    for (Index i = 0; i < nodes.rows(); ++i) {
        const auto ring = static_cast<std::size_t>(std::lround(lattice->uv()(i, 1) * recipe.cells_v));
        const auto [radius, height] = ring < profile.size() ? profile[ring] : std::array{0.0, 5.0};
        const double azimuth = 2 * std::numbers::pi * lattice->uv()(i, 0);
        nodes.row(i) << radius * std::cos(azimuth), radius * std::sin(azimuth), height;
    }
    const auto base = lattice->sides().at(Side::v_min);
    std::vector<EffectDescription> effects{axial(1e6), MemberWeight{10}, CoveringWeight{25}};
    if (with_snow)
        effects.emplace_back(Snow{900});
    return std::make_shared<const Scene>(
        make_net(lattice, nodes), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = base}}, effects);
}

TEST(HardCase11_WallsAndOverhangs, AreFoundInEquilibriumUnderCompression) {
    for (const bool with_snow : {false, true}) {
        const auto scene = mushroom(with_snow);
        const auto result = solved_in_any_numbering(scene);
        EXPECT_TRUE(certify(*scene, result.centred_nodes, nullptr, 1e-9).compression_only);
        // What turns about the axis comes back to itself.
        const double step = 2 * std::numbers::pi / 16;
        const Matrix3 turn = Eigen::AngleAxisd(step, Vector3::UnitZ()).toRotationMatrix();
        const auto base = scene->net().lattice()->sides().at(Side::v_min);
        EXPECT_NEAR(
            (turn * result.reactions.row(base[0]).transpose() - result.reactions.row(base[1]).transpose())
                .norm(),
            0, 1e-6 * result.reactions.row(base[0]).norm());
    }
}

TEST(HardCase12_StraightFreeEdges, TwoOppositeSidesHeldAndTheOthersFree) {
    const auto net = flat_sheet(8, 6, 0.75);
    auto held = net->lattice()->sides().at(Side::u_min);
    for (const Index node : net->lattice()->sides().at(Side::u_max))
        held.push_back(node);
    const auto scene = std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = held}},
        std::vector<EffectDescription>{axial(1e5), MemberWeight{8}, CoveringWeight{20}});
    const auto result = solved_in_any_numbering(scene);
    EXPECT_TRUE(certify(*scene, result.centred_nodes, nullptr, 1e-9).compression_only);
    // Mirror images of one another, though the numbering is not.
    const auto low = net->lattice()->sides().at(Side::v_min);
    const auto high = net->lattice()->sides().at(Side::v_max);
    for (std::size_t k = 0; k < low.size(); ++k) {
        EXPECT_NEAR(result.nodes(low[k], 2), result.nodes(high[k], 2), 1e-9);
        EXPECT_NEAR(result.nodes(low[k], 1), 6 - result.nodes(high[k], 1), 1e-9);
    }
}

TEST(HardCase12_StraightFreeEdges, AnEdgeThatCarriesNothingButItselfHangsAsAChainAlone) {
    // Two strands side by side, with panels that bear nothing and no member between them.
    const auto chain = catenary(12, 10, 11, 1e4, 5);
    const auto alone = solved(chain);
    auto parts = parts_of(*chain);
    const Index n = static_cast<Index>(parts.nodes.rows());
    parts.nodes.conservativeResize(2 * n, 3);
    parts.nodes.bottomRows(n) = parts.nodes.topRows(n);
    parts.nodes.col(1).tail(n).setConstant(1);
    for (Index e = 0; e + 1 < n; ++e) {
        parts.members.push_back({n + e, n + e + 1});
        parts.panels.add(std::vector<Index>{e, e + 1, n + e + 1, n + e});
    }
    parts.rest_lengths.conservativeResize(2 * (n - 1));
    parts.rest_lengths.tail(n - 1) = parts.rest_lengths.head(n - 1);
    parts.supports[0].nodes = {0, n - 1, n, 2 * n - 1};
    const auto result = solved_in_any_numbering(parts.scene());
    EXPECT_LT(distance(result.nodes.topRows(n), alone.nodes), 1e-10);
}

TEST(HardCase13_CollinearCables, WithoutLoadTheNodesSpreadSoThatOneForceRunsThrough) {
    // Taut by design, of members unlike one another: T = (span - sum of r) / (sum of 1 / k) in each.
    constexpr Index n = 9;
    Eigen::VectorXd rest(n);
    Eigen::VectorXd stiffness(n);
    double compliance = 0;
    for (Index e = 0; e < n; ++e) {
        rest[e] = 0.3 + 0.05 * e;
        stiffness[e] = 1000.0 * (1 + e * e);
        compliance += rest[e] / stiffness[e];
    }
    const double force = (9 - rest.sum()) / compliance;
    const auto scene = std::make_shared<const Scene>(
        straight_chain(n, 9), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, n}}},
        std::vector<EffectDescription>{AxialStiffness{stiffness}}, rest);
    const auto result = solved_in_any_numbering(scene);
    for (Index e = 0; e < n; ++e)
        EXPECT_NEAR(result.member_forces[e], -force, 1e-9 * force);
    EXPECT_EQ(result.nodes.rightCols(2).cwiseAbs().maxCoeff(), 0);
}

TEST(HardCase13_CollinearCables, CrossingAndHardlyLoaded) {
    // Two stressed cables that cross: T = EA (l / r - 1) is far above the load, which lifts the crossing by
    // P / (sum of T / l over the four arms).
    Points nodes(9, 3);
    nodes << 0, 0, 0, -2, 0, 0, -1, 0, 0, 1, 0, 0, 2, 0, 0, 0, -2, 0, 0, -1, 0, 0, 1, 0, 0, 2, 0;
    const std::vector<Member> members{{1, 2}, {2, 0}, {0, 3}, {3, 4}, {5, 6}, {6, 0}, {0, 7}, {7, 8}};
    const auto net = std::make_shared<const Net>(nodes, members);
    for (const double load : {1e-3, 1.0}) {
        const auto scene = std::make_shared<const Scene>(
            net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {1, 4, 5, 8}}},
            std::vector<EffectDescription>{axial(1e6), PointLoad{{0}, {0, 0, -load}}},
            Eigen::VectorXd::Constant(8, 0.5));
        const auto result = solved_in_any_numbering(scene);
        const double lift = load / (4 * 1e6 / 2);
        EXPECT_NEAR(result.nodes(0, 2), lift, 1e-5 * lift);
    }
}

TEST(HardCase13_CollinearCables, PushedTogetherTheyAreNotCalledAStructure) {
    // Longer at rest than the line they lie on: balanced and unstable. As ties they carry nothing; as struts
    // they push, which is tension where it is built, and the certificate says so.
    const auto net = straight_chain(4, 4);
    const std::vector<Support> ends{{.kind = SupportKind::fixed, .nodes = {0, 4}}};
    const auto with = [&](bool compression_only, double weight) {
        return std::make_shared<const Scene>(
            net, ends, std::vector<EffectDescription>{axial(1000, compression_only), MemberWeight{weight}},
            Eigen::VectorXd::Constant(4, 1.2));
    };
    const auto of_ties = with(true, 0);
    const auto ties = solved(of_ties);
    expect_certified(of_ties, ties);
    EXPECT_EQ(certify(*of_ties, ties.centred_nodes, nullptr, 1e-9).slack_members.size(), 4);

    const auto of_struts = with(false, 0);
    const auto struts = solved(of_struts);
    EXPECT_FALSE(certify(*of_struts, struts.centred_nodes, nullptr, 1e-9).compression_only);

    // With any weight the straight line is no equilibrium, and the chain stands.
    const auto heavy = with(false, 0.1);
    const auto result = solved(heavy);
    expect_certified(heavy, result);
    EXPECT_TRUE(certify(*heavy, result.centred_nodes, nullptr, 1e-9).compression_only);
    EXPECT_LT(distance(result.nodes, solved(with(true, 0.1)).nodes), 1e-9);
}

TEST(HardCase13_CollinearCables, ABalancedButUnstableLineIsLeftOrSaid) {
    // Struts in a straight line, pushed together: nothing moves them, and the least touch buckles them.
    const auto scene = std::make_shared<const Scene>(
        straight_chain(4, 4), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 4}}},
        std::vector<EffectDescription>{axial(1000, false)}, Eigen::VectorXd::Constant(4, 1.2));
    const auto result = solve(scene);
    const bool is_left = (result.nodes - scene->net().nodes()).rightCols(2).cwiseAbs().maxCoeff() > 0.1;
    if (!is_left) {
        expect_words(result.message, {"unstable"});
    }
}

} // namespace
} // namespace funicular::test
