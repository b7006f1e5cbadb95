// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Hard cases of members that go slack and taut (7) and of X-diagonals (16).
#include "certificate.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace funicular::test {

namespace {

AxialStiffness axial(double ea) {
    return {Eigen::VectorXd::Constant(1, ea)};
}

std::set<Index> slack_members(const ScenePtr &scene, const Result &result) {
    const auto certificate = certify(*scene, result.centred_nodes, nullptr, 1e-9);
    return {certificate.slack_members.begin(), certificate.slack_members.end()};
}

/// Every member that carries is longer than at rest, and every other one is not.
void expect_the_law(const ScenePtr &scene, const Result &result) {
    for (Index e = 0; e < scene->net().member_count(); ++e) {
        const double stretch = result.member_lengths[e] - scene->rest_lengths()[e];
        EXPECT_LE(result.member_forces[e], 0) << "member " << e;
        if (stretch > 1e-9) {
            EXPECT_LT(result.member_forces[e], 0) << "member " << e;
        }
        if (stretch < -1e-9) {
            EXPECT_EQ(result.member_forces[e], 0) << "member " << e;
        }
    }
}

/// A sheet with X-diagonals on its corners under a sideways load [N] on every free node.
ScenePtr braced_under(const NetPtr &net, Index cells_u, const Vector3 &load, double ea = 1e5) {
    const Index last = net->node_count() - 1;
    std::vector<Index> free;
    for (Index i = 1; i < last; ++i)
        if (i != cells_u && i != last - cells_u)
            free.push_back(i);
    return std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, cells_u, last - cells_u, last}}},
        std::vector<EffectDescription>{axial(ea), MemberWeight{2}, CoveringWeight{5}, PointLoad{free, load}});
}

TEST(HardCase07_SlackAndTaut, LoadsThatTurnRoundFlipTheMembersAndBack) {
    constexpr Index cells = 6;
    const auto net = braced_sheet(6, 6, cells, cells);
    for (const double push : {1.0, 100.0, 1000.0}) {
        const auto towards = braced_under(net, cells, {push, 0.3 * push, 0});
        const auto away = braced_under(net, cells, {-push, 0.3 * push, 0});
        const auto one = solved_in_any_numbering(towards);
        const auto other = solved_in_any_numbering(away);
        expect_the_law(towards, one);
        expect_the_law(away, other);
        EXPECT_FALSE(slack_members(towards, one).empty());
        // The mirror image of the net and of the load: the shape is its mirror image too.
        for (Index i = 0; i < net->node_count(); ++i) {
            const Index mirrored = i + cells - 2 * (i % (cells + 1));
            const Vector3 image(6 - other.nodes(mirrored, 0), other.nodes(mirrored, 1),
                                other.nodes(mirrored, 2));
            EXPECT_LT((one.nodes.row(i).transpose() - image).norm(), 1e-8) << push << ", node " << i;
        }
        // To and fro from the shape before: the way there leaves no trace.
        Solver solver(towards);
        for (int turn = 0; turn < 6; ++turn) {
            solver.replace(turn % 2 == 0 ? away : towards);
            EXPECT_TRUE(solver.advance());
            const auto result = solver.result();
            EXPECT_EQ(result.status, Status::converged) << push << ": " << result.message;
            EXPECT_LT(distance(result.nodes, turn % 2 == 0 ? other.nodes : one.nodes), 2e-3) << push;
        }
    }
}

TEST(HardCase07_SlackAndTaut, RandomRestLengthsAndLoads) {
    // Half of the members too long to carry where they start, which of them changes on the way.
    constexpr Index cells = 5;
    const auto net = braced_sheet(5, 5, cells, cells);
    for (unsigned seed = 0; seed < static_cast<unsigned>(sized(20, 3)); ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> rest_part(0.8, 1.2);
        std::uniform_real_distribution<double> force(-300, 300);
        auto parts = parts_of(*braced_under(net, cells, {0, 0, -1}));
        for (Index e = 0; e < parts.rest_lengths.size(); ++e)
            parts.rest_lengths[e] *= rest_part(random);
        for (int k = 0; k < 5; ++k) {
            const auto node = static_cast<Index>(7 + random() % 20);
            parts.effects.emplace_back(PointLoad{{node}, {force(random), force(random), force(random)}});
        }
        const auto scene = parts.scene();
        const auto result = solved(scene);
        expect_certified(scene, result);
        expect_the_law(scene, result);
        EXPECT_LT(result.iterations, 300) << seed;
    }
}

TEST(HardCase07_SlackAndTaut, AMemberExactlyAtItsRestLength) {
    // Straight at rest: taut to one side of where it is, slack to the other, at the start and at the end.
    const auto net = straight_chain(4, 4);
    for (const double load : {0.0, 1e-12, 1e-6, 1.0}) {
        const auto scene = std::make_shared<const Scene>(
            net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 4}}},
            std::vector<EffectDescription>{axial(1e4), PointLoad{{2}, {load, 0, 0}}});
        const auto result = solved(scene);
        // Two members pull, k / 2 between them.
        EXPECT_NEAR(result.nodes(2, 0), 2 - load / (1e4 / 2), 1e-12);
        EXPECT_LT(distance(result.nodes, net->nodes()), 1e-3);
        expect_the_law(scene, result);
        if (load == 1e-12)
            // A hundredth of what a unit in the last place of a position makes.
            expect_words(result.message, {"rounding", "Lower the stiffness"});
        else
            expect_certified(scene, result);
    }
}

TEST(HardCase07_SlackAndTaut, EveryMethodFindsTheSameSlackMembers) {
    const auto scene = braced_under(braced_sheet(4, 4, 4, 4), 4, {50, 20, -100}, 1e4);
    const auto newton = solved(scene, Method::newton);
    expect_certified(scene, newton);
    const auto automatic = solved(scene, Method::automatic);
    const auto relaxation = solved(scene, Method::relaxation);
    EXPECT_LT(distance(newton.nodes, automatic.nodes), 1e-9);
    EXPECT_LT(distance(newton.nodes, relaxation.nodes), 1e-8);
    EXPECT_EQ(slack_members(scene, newton), slack_members(scene, automatic));
    EXPECT_EQ(slack_members(scene, newton), slack_members(scene, relaxation));
}

/// Two columns, a beam and an X between them, pushed at one head: statics alone gives every force.
ScenePtr braced_bay(double push) {
    Points nodes(4, 3);
    nodes << 0, 0, 0, 4, 0, 0, 0, 0, 3, 4, 0, 3;
    std::vector<Member> members{{0, 2}, {1, 3}, {2, 3}, {0, 3}, {1, 2}};
    return std::make_shared<const Scene>(
        std::make_shared<const Net>(nodes, members),
        std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 1}}},
        std::vector<EffectDescription>{axial(1e9), PointLoad{{2, 3}, {0, 0, -1000}},
                                       PointLoad{{push > 0 ? 2 : 3}, {push, 0, 0}}});
}

TEST(HardCase16_XDiagonals, OnlyTheOneInCompressionCarries) {
    for (const double push : {100.0, -100.0, 800.0, -800.0}) {
        const auto scene = braced_bay(push);
        const auto result = solved_in_any_numbering(scene);
        const double h = std::abs(push);
        const Index carries = push > 0 ? 4 : 3;
        EXPECT_NEAR(result.member_forces[carries], -1.25 * h, 1e-3 * h);
        // It but pulls the head that it ends in along by as much as the columns shorten.
        EXPECT_NEAR(result.member_forces[7 - carries], 0, 0.01);
        EXPECT_NEAR(result.member_forces[push > 0 ? 0 : 1], -(1000 - 0.75 * h), 1);
        EXPECT_NEAR(result.member_forces[push > 0 ? 1 : 0], -1000, 1);
    }
}

TEST(HardCase16_XDiagonals, AHundredReversalsNeverCycle) {
    Solver solver(braced_bay(100));
    EXPECT_TRUE(solver.advance());
    for (int turn = 1; turn <= 100; ++turn) {
        const double push = (turn % 2 == 0 ? 1 : -1) * (10.0 + 7 * turn);
        solver.replace(braced_bay(push));
        EXPECT_TRUE(solver.advance());
        const auto result = solver.result();
        ASSERT_EQ(result.status, Status::converged) << turn << ": " << result.message;
        ASSERT_LT(result.iterations, 50) << turn;
        EXPECT_NEAR(result.member_forces[push > 0 ? 4 : 3], -1.25 * std::abs(push), 1) << turn;
        EXPECT_NEAR(result.member_forces[push > 0 ? 3 : 4], 0, 0.01) << turn;
    }
}

TEST(HardCase16_XDiagonals, OnADomeAsStiffAsSteel) {
    // Diagonals in every quad, the upper half of the covering snowed on at one side.
    auto parts = parts_of(*hemisphere(16, 8, 6, 1e8, true, 20, 40));
    const Panels panels = parts.panels;
    for (Index f = 0; f < panels.size(); ++f)
        if (panels[f].size() == 4) {
            parts.members.push_back({panels[f][0], panels[f][2]});
            parts.members.push_back({panels[f][1], panels[f][3]});
        }
    const Net net(parts.nodes, parts.members, panels);
    parts.rest_lengths = net.source_lengths();
    std::vector<Index> snowed;
    for (Index i = 0; i < parts.nodes.rows(); ++i)
        if (parts.nodes(i, 2) > 2 && parts.nodes(i, 0) > 0.5)
            snowed.push_back(i);
    parts.effects.emplace_back(PointLoad{snowed, {0, 0, -1500}});
    const auto scene = parts.scene();
    const auto result = solved_in_any_numbering(scene, 1e-9);
    expect_the_law(scene, result);
    EXPECT_FALSE(slack_members(scene, result).empty());
}

} // namespace
} // namespace funicular::test
