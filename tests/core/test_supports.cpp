// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scenes.hpp"

namespace funicular::test {

namespace {

Support fixed(std::vector<Index> nodes) {
    return {.kind = SupportKind::fixed, .nodes = std::move(nodes)};
}
Support line(std::vector<Index> nodes, const Vector3 &direction) {
    return {.kind = SupportKind::on_line, .nodes = std::move(nodes), .direction = direction};
}
Support plane(std::vector<Index> nodes, const Vector3 &normal) {
    return {.kind = SupportKind::on_plane, .nodes = std::move(nodes), .direction = normal};
}

void check_held(const Net &net, const std::vector<Support> &supports) {
    check_every_component_is_held(net, supports, Freedoms(net, supports));
}

Vector3 free_part(const Freedoms &freedoms, Index node, const Vector3 &vector) {
    const auto basis = freedoms.basis(node).leftCols(freedoms.count(node));
    return basis * (basis.transpose() * vector);
}

TEST(Freedoms, OfEachKindOfSupport) {
    const auto net = straight_chain(4, 4);
    const Freedoms freedoms(*net, {fixed({0}), line({1}, {0, 0, 3}), plane({2}, {1, 1, 0})});
    EXPECT_EQ(freedoms.count(0), 0);
    EXPECT_EQ(freedoms.count(1), 1);
    EXPECT_EQ(freedoms.count(2), 2);
    EXPECT_EQ(freedoms.count(3), 3);
    EXPECT_EQ(freedoms.size(), 9);
    EXPECT_TRUE(free_part(freedoms, 1, {1, 2, 3}).isApprox(Vector3(0, 0, 3)));
    EXPECT_TRUE(free_part(freedoms, 2, {1, 0, 5}).isApprox(Vector3(0.5, -0.5, 5)));
}

TEST(Freedoms, SupportsOnOneNodeAddUp) {
    const auto net = straight_chain(5, 5);
    const Freedoms freedoms(*net, {plane({1, 2, 3}, Vector3::UnitX()), plane({1}, Vector3::UnitY()),
                                   plane({2}, {-2, 0, 0}), line({3}, Vector3::UnitX()), fixed({0}),
                                   plane({0}, Vector3::UnitX())});
    EXPECT_EQ(freedoms.count(1), 1) << "two planes leave the line where they meet";
    EXPECT_TRUE(free_part(freedoms, 1, {1, 2, 3}).isApprox(Vector3(0, 0, 3)));
    EXPECT_EQ(freedoms.count(2), 2) << "the same plane twice is one plane";
    EXPECT_EQ(freedoms.count(3), 0) << "a line across a plane leaves a point";
    EXPECT_EQ(freedoms.count(0), 0);
}

TEST(Freedoms, ReduceAndExpandAreTransposes) {
    const auto net = straight_chain(4, 4);
    const Freedoms freedoms(*net, {fixed({0}), line({1}, {1, 2, 2}), plane({2}, {1, 1, 0})});
    const Points vectors = Points::Random(5, 3);
    const Eigen::VectorXd unknowns = Eigen::VectorXd::Random(freedoms.size());
    Eigen::VectorXd reduced;
    freedoms.reduce(vectors, reduced);
    Points expanded(5, 3);
    freedoms.expand(unknowns, expanded);
    EXPECT_NEAR(reduced.dot(unknowns), (vectors.array() * expanded.array()).sum(), 1e-14);
}

TEST(Supports, NameWhatIsWrong) {
    const auto net = straight_chain(4, 4);
    expect_invalid(
        [&] {
            Freedoms(*net, {fixed({0}), fixed({1, 5})});
        },
        {"supports[1]", "ids[1] is 5", "0 to 4"});
    expect_invalid([&] { Freedoms(*net, {line({0}, {0, 0, 0})}); }, {"supports[0]", "direction"});
    expect_invalid([&] { Freedoms(*net, {plane({0}, {0, std::nan(""), 0})}); }, {"supports[0]", "normal"});
    auto weak = fixed({0});
    weak.stiffness = -1;
    expect_invalid([&] { Freedoms(*net, {weak}); }, {"supports[0]", "stiffness"});
}

TEST(Supports, EveryComponentMustBeHeld) {
    const Points nodes = (Points(5, 3) << 0, 0, 0, 1, 0, 0, 5, 0, 0, 6, 0, 0, 7, 0, 0).finished();
    const Net net(nodes, {{0, 1}, {2, 3}, {3, 4}});
    expect_invalid([&] { check_held(net, {fixed({0})}); },
                   {"component of 3 nodes has no support", "nodes 2, 3, 4;"});
    expect_invalid(
        [&] {
            check_held(net, {fixed({0}), line({2, 3}, Vector3::UnitZ())});
        },
        {"component of 3 nodes vertically", "nodes 2, 3, 4;"});
    auto lifted = fixed({2});
    lifted.stiffness = 0;
    expect_invalid([&] { check_held(net, {fixed({0}), lifted}); }, {"component of 3 nodes", "no support"});
    EXPECT_NO_THROW(check_held(net, {fixed({0}), line({4}, {1, 0, 1})}));
}

TEST(Supports, ANodeWithoutMembersMustBeHeldWhole) {
    const Net net((Points(3, 3) << 0, 0, 0, 1, 0, 0, 5, 0, 0).finished(), {{0, 1}});
    expect_invalid(
        [&] {
            check_held(net, {fixed({0}), plane({2}, Vector3::UnitZ())});
        },
        {"node 2", "no members"});
    EXPECT_NO_THROW(check_held(net, {fixed({0, 2})}));
}

TEST(Supports, ATiltedSpringIsAsStableForTheRelaxation) {
    auto spring = plane({1}, {1, 1, 1});
    spring.stiffness = 1e6;
    const auto scene = std::make_shared<const Scene>(
        straight_chain(2, 2), std::vector<Support>{fixed({0, 2}), spring},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e3)}, MemberWeight{1}});
    const auto newton = solved(scene, Method::newton);
    SolveOptions options;
    options.method = Method::relaxation;
    const auto relaxation = solve(scene, options);
    ASSERT_EQ(newton.status, Status::converged) << newton.message;
    ASSERT_EQ(relaxation.status, Status::converged) << relaxation.message;
    EXPECT_LT(distance(newton.nodes, relaxation.nodes), 1e-3);
}

TEST(Supports, ANetFreeToSlideStaysWhereItIs) {
    // Planes that leave every horizontal direction free, and no horizontal load.
    const auto net = flat_sheet(4, 4, 1);
    const auto scene = std::make_shared<const Scene>(
        net, std::vector<Support>{plane(net->border(), Vector3::UnitZ())},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)}, MemberWeight{5}});
    for (const Method method : {Method::newton, Method::automatic}) {
        SolveOptions options;
        options.method = method;
        const auto result = solve(scene, options);
        if (result.status == Status::converged) {
            EXPECT_LT((result.nodes.colwise().mean() - net->nodes().colwise().mean()).head<2>().norm(), 1e-3);
        } else {
            EXPECT_NE(result.message, "");
        }
    }
}

TEST(Supports, AWeakSupportYieldsByItsReaction) {
    // A single member between a fixed node and one on a spring, pulled along by a point load.
    const auto net = straight_chain(1, 2);
    Support spring = fixed({1});
    spring.stiffness = 50;
    const auto scene = std::make_shared<const Scene>(
        net, std::vector<Support>{fixed({0}), spring},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 300)},
                                       PointLoad{{1}, {-10, 0, 0}}});
    const auto result = solved(scene);
    ASSERT_EQ(result.status, Status::converged);
    // k = EA / r = 150 and 50 share the 10 N.
    EXPECT_NEAR(result.nodes(1, 0), 2 + 10.0 / 200, 1e-12);
    EXPECT_NEAR(result.reactions(1, 0), 2.5, 1e-9);
    EXPECT_NEAR(result.reactions(0, 0), 7.5, 1e-9);
    EXPECT_NEAR(result.member_forces[0], -7.5, 1e-9);
}

TEST(Supports, WeakeningOneGoesFromHeldToFree) {
    const auto rise_of_end = [](double stiffness) {
        Support end = fixed({4});
        end.stiffness = stiffness;
        const auto scene = std::make_shared<const Scene>(
            straight_chain(4, 4), std::vector<Support>{fixed({0}), end},
            std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)},
                                           MemberWeight{10}});
        const auto result = solved(scene);
        EXPECT_EQ(result.status, Status::converged)
            << stiffness << ": " << result.message << " " << result.position_error;
        return result.nodes(4, 2);
    };
    EXPECT_NEAR(rise_of_end(1e12), 0, 1e-6);
    double before = 0;
    for (const double stiffness : {1e4, 1e3, 1e2, 1e1, 0.0}) {
        const double rise = rise_of_end(stiffness);
        EXPECT_GT(rise, before);
        before = rise;
    }
    EXPECT_GT(before, 3.9) << "let go, the chain stands on its other end";
}

} // namespace
} // namespace funicular::test
