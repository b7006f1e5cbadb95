// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Hard cases of degenerate nets, bad numbers and panels that make no surface (8, 21, 22). What the
/// constructor of a net refuses by itself is tested in test_net.cpp.
#include "certificate.hpp"
#include "equilibrium.hpp"
#include "scenes.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace funicular::test {

namespace {

constexpr std::array every_share{CornerShare::angle, CornerShare::equal, CornerShare::voronoi};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

AxialStiffness axial(double ea) {
    return {Eigen::VectorXd::Constant(1, ea)};
}

Points loads_at_start(const ScenePtr &scene) {
    Equilibrium equilibrium(scene);
    equilibrium.evaluate(scene->scale().to_local(scene->net().nodes()));
    return equilibrium.loads() * scene->scale().force;
}

/// A roof on its corners to which panels are added or of which they are changed.
SceneParts roof(CornerShare share, double snow = 0) {
    const auto net = flat_sheet(6, 5, 1);
    SceneParts parts{net->nodes(), net->members(), net->panels(), {}, {}, net->source_lengths()};
    parts.supports = {{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}};
    parts.effects = {axial(1e5), MemberWeight{5}, CoveringWeight{20, share}, Snow{snow}};
    return parts;
}

TEST(HardCase08_Degenerate, MembersAMillionthOfTheNetAreMembers) {
    // Two nodes 6 µm apart on a chain of 6 m: as good as one node, and the shape is that of a chain with one.
    for (const double gap : {1e-3, 6e-6}) {
        Points nodes = Points::Zero(8, 3);
        nodes.col(0) << 0, 1, 2, 3 - gap / 2, 3 + gap / 2, 4, 5, 6;
        const auto make = [](const NetPtr &net, Index last) {
            return std::make_shared<const Scene>(
                net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, last}}},
                std::vector<EffectDescription>{axial(1e4), MemberWeight{5}});
        };
        const auto scene = make(chain_net(nodes), 7);
        const auto result = solved(scene);
        expect_certified(scene, result, 1e-6);
        const auto merged = solved(make(straight_chain(6, 6), 6));
        EXPECT_LT((result.nodes.row(3) - merged.nodes.row(3)).norm(), 3 * gap);
        EXPECT_LT((result.nodes.row(5) - merged.nodes.row(4)).norm(), 3 * gap);
    }
}

TEST(HardCase08_Degenerate, CoincidentNodesThatNothingJoinsDoNotMeet) {
    // Two chains through the same places: each hangs as if alone.
    const auto alone = solved(catenary(10, 10, 11, 1e4, 5));
    auto parts = parts_of(*catenary(10, 10, 11, 1e4, 5));
    parts.nodes.conservativeResize(22, 3);
    parts.nodes.bottomRows(11) = parts.nodes.topRows(11).eval();
    for (Index e = 0; e < 10; ++e)
        parts.members.push_back({11 + e, 12 + e});
    parts.rest_lengths.conservativeResize(20);
    parts.rest_lengths.tail(10) = parts.rest_lengths.head(10).eval();
    parts.supports[0].nodes = {0, 10, 11, 21};
    const auto result = solved_in_any_numbering(parts.scene());
    EXPECT_LT(distance(result.nodes.topRows(11), alone.nodes), 1e-10);
    EXPECT_LT(distance(result.nodes.bottomRows(11), alone.nodes), 1e-10);
}

TEST(HardCase08_Degenerate, NodesThatMeetWhileSolvingAreSolved) {
    // A start in which all but the supports coincide: members of no length have no direction to pull in.
    const auto scene = roof(CornerShare::angle).scene();
    const auto reference = solved(scene);
    SolveOptions options;
    options.tolerance = 1e-12;
    options.accuracy = 1e-12;
    options.start = scene->net().nodes();
    for (Index i = 0; i < options.start->rows(); ++i)
        options.start->row(i) << 3, 2.5, 1;
    const auto result = solve(scene, options);
    expect_certified(scene, result);
    EXPECT_LT(distance(result.nodes, reference.nodes), 1e-9);
}

TEST(HardCase08_Degenerate, PanelsWithoutAreaWeighNothing) {
    // A triangle of three nodes in line along a strand that its symmetry keeps straight in plan.
    for (const auto share : every_share) {
        const auto plain = parts_of(*catenary(8, 8, 9, 1e4, 20));
        auto with_needle = plain;
        with_needle.nodes.conservativeResize(11, 3);
        with_needle.nodes.row(9) << 0, 3, 0;
        with_needle.nodes.row(10) << 1, 3, 0;
        with_needle.members.push_back({9, 10});
        with_needle.rest_lengths.conservativeResize(9);
        with_needle.rest_lengths[8] = 1;
        with_needle.supports.push_back({.kind = SupportKind::fixed, .nodes = {9, 10}});
        auto without = with_needle;
        // On fixed nodes, a triangle whose area is known; along them, one of none.
        with_needle.panels.add(std::vector<Index>{0, 9, 10});
        without.panels.add(std::vector<Index>{0, 9, 10});
        with_needle.nodes.conservativeResize(12, 3);
        with_needle.nodes.row(11) << 0.5, 3, 0;
        without.nodes = with_needle.nodes;
        for (auto *parts : {&with_needle, &without}) {
            parts->supports.push_back({.kind = SupportKind::fixed, .nodes = {11}});
            parts->effects.emplace_back(CoveringWeight{30, share});
            parts->effects.emplace_back(Snow{100});
        }
        with_needle.panels.add(std::vector<Index>{9, 11, 10});
        const auto result = solved_in_any_numbering(with_needle.scene());
        const auto reference = solved(without.scene());
        EXPECT_LT(distance(result.nodes, reference.nodes), 1e-12);
        EXPECT_LT((result.reactions - reference.reactions).norm(), 1e-9);
    }
}

TEST(HardCase08_Degenerate, SliversFoldsAndDoublesAreSolvedForEveryShare) {
    for (const auto share : every_share) {
        auto parts = roof(share);
        // A sliver of 7 nodes of one row and one of the next, a bow-tie, a panel there and back, and a
        // double.
        parts.panels.add(std::vector<Index>{14, 15, 16, 17, 18, 19, 20, 27});
        parts.panels.add(std::vector<Index>{8, 16, 9, 15});
        parts.panels.add(std::vector<Index>{22, 23, 24, 30, 23 + 8, 29});
        const auto first = parts.panels[0];
        parts.panels.add(std::vector<Index>(first.begin(), first.end()));
        const auto scene = parts.scene();
        const Points loads = loads_at_start(scene);
        EXPECT_GE(loads.col(2).minCoeff(), 0) << "no panel, however folded, weighs less than nothing";
        const auto result = solved_in_any_numbering(scene);
        EXPECT_TRUE(certify(*scene, result.centred_nodes, nullptr, 1e-9).compression_only);
    }
}

TEST(HardCase08_Degenerate, APanelTwiceWeighsTwice) {
    for (const auto share : every_share) {
        auto once = roof(share);
        std::get<CoveringWeight>(once.effects[2]).per_area = 40;
        auto twice = roof(share);
        for (Index f = 0; f < once.panels.size(); ++f)
            twice.panels.add(std::vector<Index>(once.panels[f].begin(), once.panels[f].end()));
        EXPECT_LT(distance(solved(once.scene()).nodes, solved(twice.scene()).nodes), 1e-10);
    }
}

TEST(HardCase21_BadNumbers, EachNumberOfASceneIsCheckedAndNamed) {
    const auto net = flat_sheet(3, 3, 1);
    const auto with = [&](const std::vector<EffectDescription> &effects, double stiffness = infinite,
                          const Vector3 &direction = Vector3::UnitZ()) {
        return [=] {
            (void)Scene(net,
                        {{.kind = SupportKind::fixed, .nodes = {0, 3, 12, 15}},
                         {.kind = SupportKind::on_plane,
                          .nodes = {1},
                          .direction = direction,
                          .stiffness = stiffness}},
                        effects);
        };
    };
    const auto good = axial(1e4);
    for (const double bad : {nan, -infinite, -1.0}) {
        expect_invalid(with({axial(bad)}), {"AxialStiffness", "stiffness must be positive"});
        expect_invalid(with({good}, bad), {"supports[1]", "stiffness"});
    }
    for (const double bad : {nan, infinite, -infinite, -1.0}) {
        expect_invalid(with({good, MemberWeight{bad}}), {"MemberWeight", "kg/m"});
        expect_invalid(with({good, CoveringWeight{bad}}), {"CoveringWeight", "kg/m²"});
        expect_invalid(with({good, Snow{bad}}), {"Snow", "N/m²"});
    }
    expect_invalid(with({axial(infinite)}), {"AxialStiffness", "stiffness must be positive and finite"});
    expect_invalid(with({axial(0)}), {"AxialStiffness", "stiffness must be positive"});
    for (const double bad : {nan, infinite, -infinite})
        for (int axis = 0; axis < 3; ++axis) {
            expect_invalid(with({good, PointLoad{{5}, bad * Vector3::Unit(axis)}}), {"PointLoad", "force"});
            expect_invalid(with({good}, infinite, bad * Vector3::Unit(axis)), {"supports[1]", "normal"});
        }
    for (const Index bad : {-1, 16, std::numeric_limits<Index>::max(), std::numeric_limits<Index>::min()})
        expect_invalid(with({good, PointLoad{{5, bad}, {0, 0, -1}}}), {"PointLoad", "ids[1]", "0 to 15"});
    expect_invalid(with({}), {"AxialStiffness is missing"});
}

TEST(HardCase21_BadNumbers, NumbersAtTheEndsOfTheirRangeGiveAStatusOrAnError) {
    // Whatever finite numbers come, what comes back is a refusal by name, or a finite shape with a status.
    const std::array extremes{5e-324, 1e-308, 1e-150, 1e-12, 1e12, 1e150, 1e308};
    int refused = 0;
    int answered = 0;
    for (const double size : extremes)
        for (const double ea : extremes)
            for (const double weight : extremes) {
                try {
                    const auto net = flat_sheet(size, size, size / 2);
                    SolveOptions options;
                    options.max_iterations = 50;
                    const auto scene = std::make_shared<const Scene>(
                        net,
                        std::vector<Support>{
                            {.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}},
                        std::vector<EffectDescription>{axial(ea), MemberWeight{weight},
                                                       CoveringWeight{weight}, Snow{weight}});
                    const auto result = solve(scene, options);
                    EXPECT_TRUE(result.nodes.allFinite()) << size << ", " << ea << ", " << weight;
                    EXPECT_FALSE(result.message.empty());
                    if (result.status == Status::converged) {
                        const auto certificate = certify(*scene, result.centred_nodes, nullptr, 1e-6);
                        EXPECT_TRUE(certificate.in_equilibrium)
                            << size << ", " << ea << ", " << weight << ": " << certificate.summary();
                    }
                    ++answered;
                } catch (const InvalidInput &error) {
                    EXPECT_GT(std::string(error.what()).size(), 20);
                    ++refused;
                }
            }
    EXPECT_GT(refused, 0);
    EXPECT_GT(answered, 0);
}

TEST(HardCase21_BadNumbers, NetsOfOneAndOfTwoNodes) {
    expect_invalid([] { Net(Points::Zero(1, 3), {}); }, {"members is empty"});
    const auto pair = straight_chain(1, 2);
    const std::vector<EffectDescription> effects{axial(1e4), MemberWeight{1}};
    // Both held: nothing to find, and the reactions carry the weight.
    const auto held = std::make_shared<const Scene>(
        pair, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 1}}}, effects);
    const auto result = solved_in_any_numbering(held);
    EXPECT_EQ(result.nodes, pair->nodes());
    EXPECT_NEAR(result.reactions.col(2).sum(), 2 * standard_gravity, 1e-9);
    // One held: the member stands on it.
    const auto standing = std::make_shared<const Scene>(
        pair, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0}}}, effects);
    EXPECT_NEAR(solved_in_any_numbering(standing).nodes(1, 2), 1e4 / 2 * 2 / (1e4 / 2 - standard_gravity / 2),
                1e-9);
}

/// A band of quads, twisted by half a turn or not at all, that stands on its lower rim.
SceneParts band(bool twisted) {
    constexpr Index around = 24;
    SceneParts parts;
    parts.nodes.resize(2 * around, 3);
    for (Index k = 0; k < around; ++k) {
        const double azimuth = 2 * std::numbers::pi * k / around;
        const double tilt = twisted ? azimuth / 2 : 0;
        for (Index side = 0; side < 2; ++side) {
            const double across = (side == 0 ? -0.8 : 0.8);
            const double radius = 4 + across * std::cos(tilt);
            parts.nodes.row(2 * k + side) << radius * std::cos(azimuth), radius * std::sin(azimuth),
                across * std::sin(tilt);
        }
        const Index next = (k + 1) % around;
        const bool crosses = twisted && next == 0;
        const std::vector<Index> corners{2 * k, 2 * next + (crosses ? 1 : 0), 2 * next + (crosses ? 0 : 1),
                                         2 * k + 1};
        parts.members.push_back({2 * k, 2 * k + 1});
        parts.members.push_back({corners[0], corners[1]});
        parts.members.push_back({corners[3], corners[2]});
        parts.panels.add(corners);
        if (k % 4 == 0)
            parts.supports.push_back({.kind = SupportKind::fixed, .nodes = {2 * k, 2 * k + 1}});
    }
    parts.effects = {axial(1e5), MemberWeight{5}, CoveringWeight{20}, Snow{300}};
    parts.rest_lengths = Net(parts.nodes, parts.members).source_lengths();
    return parts;
}

TEST(HardCase22_NoSurface, AMobiusBandIsWeighedAndSolved) {
    const auto parts = band(true);
    const Net net(parts.nodes, parts.members, parts.panels);
    EXPECT_EQ(net.border().size(), 48) << "one rim, through every node";
    const auto scene = parts.scene();
    const auto result = solved_in_any_numbering(scene);
    EXPECT_TRUE(certify(*scene, result.centred_nodes, nullptr, 1e-9).compression_only);
}

TEST(HardCase22_NoSurface, FlippedPanelsWeighAndBearTheSame) {
    for (const auto share : every_share) {
        auto parts = parts_of(*warped_roof());
        parts.effects = {axial(1e5), MemberWeight{12}, CoveringWeight{30, share}, Snow{700}};
        const auto reference = solved(parts.scene());
        const Points loads = loads_at_start(parts.scene());
        std::mt19937 random(5);
        Panels flipped;
        for (Index f = 0; f < parts.panels.size(); ++f) {
            std::vector<Index> corners(parts.panels[f].begin(), parts.panels[f].end());
            if (random() % 2 == 0)
                std::reverse(corners.begin(), corners.end());
            flipped.add(corners);
        }
        parts.panels = flipped;
        EXPECT_LT((loads_at_start(parts.scene()) - loads).norm(), 1e-12 * loads.norm());
        EXPECT_LT(distance(solved(parts.scene()).nodes, reference.nodes), 1e-10);
    }
}

TEST(HardCase22_NoSurface, ThreePanelsOnAnEdge) {
    // A fin stands along the middle row of a roof: every edge below it has three panels, and is no border.
    for (const auto share : every_share) {
        auto parts = roof(share, 300);
        const Index base = static_cast<Index>(parts.nodes.rows());
        parts.nodes.conservativeResize(base + 7, 3);
        for (Index k = 0; k < 7; ++k) {
            parts.nodes.row(base + k) << k, 2, 1;
            parts.members.push_back({14 + k, base + k});
            if (k > 0) {
                parts.members.push_back({base + k - 1, base + k});
                parts.panels.add(std::vector<Index>{14 + k - 1, 14 + k, base + k, base + k - 1});
            }
        }
        const Net net(parts.nodes, parts.members, parts.panels);
        parts.rest_lengths = net.source_lengths();
        const auto border = net.border();
        EXPECT_EQ(std::count(border.begin(), border.end(), 17), 0);
        EXPECT_EQ(std::count(border.begin(), border.end(), base + 3), 1);
        solved_in_any_numbering(parts.scene());
    }
}

TEST(HardCase22_NoSurface, SnowOnAWallThatTipsOverNeverJumps) {
    // A warped panel passes through the upright: seen from above it is folded on itself, and its load must go
    // through small values of the same sign on every corner.
    Points before;
    constexpr int steps = 2000;
    for (int k = 0; k <= steps; ++k) {
        const double lean = 0.2 * (2.0 * k / steps - 1);
        Points nodes(4, 3);
        nodes << 0, 0, 0, 4, 0.3, 0, 4, lean, 3, 0, lean + 0.3, 3;
        Panels panels;
        panels.add(std::vector<Index>{0, 1, 2, 3});
        const std::vector<Member> members{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
        const auto scene =
            std::make_shared<const Scene>(std::make_shared<const Net>(nodes, members, panels),
                                          std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 1}}},
                                          std::vector<EffectDescription>{axial(1e5), Snow{1000}});
        const Points loads = loads_at_start(scene);
        EXPECT_GE(loads.col(2).minCoeff(), -1e-9) << "snow lifts a corner at a lean of " << lean;
        if (k > 0) {
            EXPECT_LT((loads - before).norm(), 50 * 1000 * 0.4 / steps) << "at a lean of " << lean;
        }
        before = loads;
    }
}

} // namespace
} // namespace funicular::test
