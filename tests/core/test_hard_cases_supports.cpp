// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Hard cases of supports: none, one, vertical lines only, a component adrift (9); planes that leave a slide,
/// and several supports on a node (10).
#include "certificate.hpp"
#include "scenes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace funicular::test {

namespace {

AxialStiffness axial(double ea) {
    return {Eigen::VectorXd::Constant(1, ea)};
}
Support fixed(std::vector<Index> nodes) {
    return {.kind = SupportKind::fixed, .nodes = std::move(nodes)};
}
Support line(std::vector<Index> nodes, const Vector3 &direction) {
    return {.kind = SupportKind::on_line, .nodes = std::move(nodes), .direction = direction};
}
Support plane(std::vector<Index> nodes, const Vector3 &normal) {
    return {.kind = SupportKind::on_plane, .nodes = std::move(nodes), .direction = normal};
}

ScenePtr covered(const NetPtr &net, std::vector<Support> supports) {
    return std::make_shared<const Scene>(
        net, std::move(supports),
        std::vector<EffectDescription>{axial(1e5), MemberWeight{8}, CoveringWeight{20}});
}

/// Two sheets in one net that no member joins: nodes 0 to 39 and 40 to 51.
NetPtr two_sheets() {
    const auto large = flat_sheet(7, 4, 1);
    const auto small = flat_sheet(3, 2, 1);
    Points nodes(52, 3);
    nodes << large->nodes(), small->nodes().rowwise() + Vector3(20, 0, 0).transpose();
    auto members = large->members();
    for (const auto &[i, j] : small->members())
        members.push_back({40 + i, 40 + j});
    Panels panels = large->panels();
    for (Index f = 0; f < small->panels().size(); ++f) {
        std::vector<Index> corners;
        for (const Index node : small->panels()[f])
            corners.push_back(40 + node);
        panels.add(corners);
    }
    return std::make_shared<const Net>(nodes, members, panels);
}

TEST(HardCase09_Unsupported, AComponentAdriftIsNamedByItsNodes) {
    const auto net = two_sheets();
    expect_invalid(
        [&] {
            covered(net, {fixed({0, 7, 32, 39})});
        },
        {"component of 12 nodes has no support", "nodes 40, 41, 42, 43, 44, …", "fix at least one"});
    expect_invalid([&] { covered(net, {}); },
                   {"component of 40 nodes has no support", "nodes 0, 1, 2, 3, 4, …"});
    expect_invalid(
        [&] {
            covered(net, {fixed({0, 7}), line({40, 43, 51}, Vector3::UnitZ())});
        },
        {"nothing holds the component of 12 nodes vertically", "nodes 40, 41", "fix at least one"});
    // Held each by itself, they stand together as they stand alone.
    const auto both = solved_in_any_numbering(covered(net, {fixed({0, 7, 32, 39}), fixed({40, 43, 48, 51})}));
    const auto alone = flat_sheet(7, 4, 1);
    EXPECT_LT(
        distance(both.nodes.topRows(40), solved(covered(alone, {fixed(alone->lattice()->corners())})).nodes),
        1e-9);
}

TEST(HardCase09_Unsupported, OnlyVerticalLinesCannotCarry) {
    const auto net = flat_sheet(4, 4, 1);
    expect_invalid([&] { covered(net, {line(net->border(), Vector3::UnitZ())}); },
                   {"nothing holds the component of 25 nodes vertically"});
    // Upright planes on two sides neither.
    expect_invalid(
        [&] {
            covered(net, {plane({0, 1, 2}, Vector3::UnitX()), plane({20}, Vector3::UnitY())});
        },
        {"vertically"});
}

TEST(HardCase09_Unsupported, OneSupportCarriesAllThatHangsOnIt) {
    // In the sense of form finding everything is pulled up from that one node: a chain stands as a strand.
    const auto standing = strand(6, 6, 1e4, 10);
    auto lying = parts_of(*standing);
    lying.nodes.col(0) = lying.nodes.col(2).eval();
    lying.nodes.col(2).setZero();
    const auto result = solved_in_any_numbering(lying.scene());
    const auto upright = solved(standing);
    EXPECT_LT((result.nodes.col(2) - upright.nodes.col(2)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(result.nodes.leftCols(2).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(HardCase09_Unsupported, ASheetOnOneCornerStandsOrSaysWhyNot) {
    // Where members go slack the place of a node may not be unique; what is found must be in equilibrium.
    for (const auto &start : {0, 12}) {
        const auto scene = covered(flat_sheet(4, 4, 1), {fixed({start})});
        const auto result = solve(scene);
        expect_certified(scene, result, 1e-6);
        EXPECT_NEAR(result.reactions.col(2).sum(), result.reactions(start, 2), 1e-9);
    }
}

TEST(HardCase09_Unsupported, OneEndHeldAndTheOtherOnAVerticalLine) {
    // The end on the line may rise until no force along it is left: its member is level there.
    const auto scene = std::make_shared<const Scene>(
        straight_chain(12, 6), std::vector<Support>{fixed({0}), line({12}, Vector3::UnitZ())},
        std::vector<EffectDescription>{axial(1e5),
                                       PointLoad{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, {0, 0, -5}}},
        Eigen::VectorXd::Constant(12, 0.7));
    const auto result = solved_in_any_numbering(scene);
    EXPECT_NEAR(result.reactions(12, 2), 0, 1e-9);
    EXPECT_NEAR(result.nodes(12, 2), result.nodes(11, 2), 1e-9);
    EXPECT_NEAR(result.reactions(0, 2), 55, 1e-9);
}

TEST(HardCase10_Slides, NoLoadAlongASlideNoSlide) {
    // Two sides on upright planes x = const, free along y; one node each held vertically too.
    const auto net = flat_sheet(6, 4, 1);
    auto sides = net->lattice()->sides().at(Side::u_min);
    for (const Index node : net->lattice()->sides().at(Side::u_max))
        sides.push_back(node);
    const auto scene = covered(net, {line(sides, Vector3::UnitY())});
    const auto result = solved(scene);
    expect_certified(scene, result);
    EXPECT_NEAR(result.nodes.col(1).mean(), 2, 1e-6) << "nothing pushes it along y";
    const auto again = solved(scene);
    EXPECT_EQ(again.nodes, result.nodes);
}

TEST(HardCase10_Slides, ALoadAlongASlideIsNoEquilibriumAndSaysWhereToHold) {
    const auto net = flat_sheet(6, 4, 1);
    auto sides = net->lattice()->sides().at(Side::u_min);
    for (const Index node : net->lattice()->sides().at(Side::u_max))
        sides.push_back(node);
    const auto pushed = [&](std::vector<Support> supports) {
        return std::make_shared<const Scene>(
            net, std::move(supports),
            std::vector<EffectDescription>{axial(1e5), MemberWeight{8}, PointLoad{{16, 17}, {0, 3, 0}}});
    };
    expect_no_equilibrium(pushed({line(sides, Vector3::UnitY())}),
                          {"moves away as a whole", "hold it there"});
    // Held there at one node, or by a weak spring, it rests, and that takes the push.
    auto springs = line(sides, Vector3::UnitY());
    auto weak = fixed({sides[0]});
    weak.stiffness = 500;
    // Nineteen slack members let the lines shift against one another by millimetres: that it rests, and what
    // the holder takes, is the same in every numbering; where each line rests is not.
    for (const auto &holder : {fixed({sides[0]}), weak}) {
        const auto scene = pushed({springs, holder});
        const auto held = solved(scene);
        expect_certified(scene, held);
        EXPECT_NEAR(held.reactions(sides[0], 1), -6, 1e-6);
        for (const unsigned seed : {1U, 2U, 3U}) {
            std::vector<Index> number;
            const auto other = renumbered(*scene, seed, number);
            const auto again = solved(other);
            expect_certified(other, again);
            EXPECT_NEAR(again.reactions(number[sides[0]], 1), -6, 1e-6) << "numbering " << seed;
        }
    }
}

TEST(HardCase10_Slides, APlaneThatLeansCarriesAndSlides) {
    // On one leaning plane each, four corners: what the planes leave free, the net's own pull settles.
    const auto net = flat_sheet(4, 4, 0.5);
    std::vector<Support> supports;
    for (const Index corner : net->lattice()->corners()) {
        const Vector3 out = net->nodes().row(corner).transpose() - Vector3(2, 2, 0);
        supports.push_back(plane({corner}, out.normalized() + 0.5 * Vector3::UnitZ()));
    }
    const auto scene = covered(net, supports);
    const auto result = solved_in_any_numbering(scene, 1e-9);
    for (std::size_t k = 0; k < supports.size(); ++k) {
        const Index corner = supports[k].nodes[0];
        const Vector3 reaction = result.reactions.row(corner).transpose();
        EXPECT_LT(reaction.cross(supports[k].direction.normalized()).norm(), 1e-9 * reaction.norm())
            << "a plane pushes along its normal";
    }
}

TEST(HardCase10_SeveralSupports, HoldWhatEachOfThemHolds) {
    // A support holds a node at its own place in the net, so that several never contradict one another: what
    // one leaves free, another may hold, and the order they come in means nothing.
    const auto net = flat_sheet(4, 4, 1);
    const auto corners = net->lattice()->corners();
    const auto reference = solved(covered(net, {fixed(corners)}));
    const std::vector<std::vector<Support>> same{
        {fixed(corners), fixed(corners), line(corners, {1, 2, 3}), plane(corners, {3, -1, 0})},
        {line(corners, {1, 2, 3}), line(corners, {3, 2, 1})},
        {plane(corners, Vector3::UnitX()), plane(corners, {1, 1, 0}), plane(corners, {1, 1, 1})},
        {plane(corners, {0, 1e-200, 0}), line(corners, {0, 1e200, 0})},
        {line(corners, {1, 0, 0}), line(corners, {1, 2e-3, 0})},
    };
    for (auto supports : same)
        for (int order = 0; order < 2; ++order) {
            const auto scene = covered(net, supports);
            const auto result = solved(scene);
            expect_certified(scene, result);
            EXPECT_LT(distance(result.nodes, reference.nodes), 1e-10);
            EXPECT_LT((result.reactions - reference.reactions).norm(), 1e-8);
            std::reverse(supports.begin(), supports.end());
        }
}

TEST(HardCase10_SeveralSupports, ARigidAndAYieldingOneAddUp) {
    // The spring acts along what the rigid one leaves free only.
    const auto net = flat_sheet(4, 4, 1);
    const auto corners = net->lattice()->corners();
    auto spring = fixed(corners);
    spring.stiffness = 2000;
    auto upward = line(corners, Vector3::UnitX());
    upward.stiffness = 1e9;
    for (const auto &rigid : {plane(corners, Vector3::UnitZ()), line(corners, {1, 1, 0})}) {
        const auto scene = covered(net, {spring, rigid, upward});
        solved_in_any_numbering(scene, 1e-9);
    }
    const auto all = solved(covered(net, {spring, fixed(corners)}));
    EXPECT_EQ(all.nodes, solved(covered(net, {fixed(corners)})).nodes);
}

TEST(HardCase10_SeveralSupports, PlanesAlmostTheSameAreOneOrTwoButNeverNoise) {
    // Two planes through a node at an angle: they leave a line, or where rounding could not tell it, the
    // plane.
    const auto net = flat_sheet(4, 4, 1);
    auto corners = net->lattice()->corners();
    const Index free_corner = corners.back();
    corners.pop_back();
    for (const double angle : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 0.0}) {
        const Vector3 other(std::sin(angle), 0, std::cos(angle));
        const auto scene = covered(
            net, {fixed(corners), plane({free_corner}, Vector3::UnitZ()), plane({free_corner}, other)});
        const auto result = solved_in_any_numbering(scene, 1e-9);
        const double leaves_a_plane =
            solved(covered(net, {fixed(corners), plane({free_corner}, {0, 0, 1})})).nodes(free_corner, 0);
        EXPECT_NEAR(result.nodes(free_corner, 0), angle > 2e-4 ? 4 : leaves_a_plane, 1e-9) << angle;
    }
}

TEST(HardCase10_SeveralSupports, EverythingHeldLeavesNothingToFind) {
    const auto net = flat_sheet(3, 3, 1);
    std::vector<Index> all(net->node_count());
    for (Index i = 0; i < net->node_count(); ++i)
        all[i] = i;
    const auto scene = covered(net, {fixed(all)});
    for (const Method method : {Method::automatic, Method::newton, Method::relaxation}) {
        const auto result = solved(scene, method);
        EXPECT_EQ(result.status, Status::converged) << result.message;
        EXPECT_EQ(result.nodes, net->nodes());
        EXPECT_NEAR(result.reactions.col(2).sum(), (24 * 8 + 9 * 20) * standard_gravity, 1e-6);
    }
}

} // namespace
} // namespace funicular::test
