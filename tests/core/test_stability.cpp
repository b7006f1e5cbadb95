// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// False equilibria: struts in the wrong sign, and equilibria that a disturbance ends.
#include "scenes.hpp"
#include "stability.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <optional>

namespace funicular::test {

namespace {

/// Two bars from (-1, 0, 0) and (1, 0, 0) to an apex at `height`, pushed up by `load` in form finding. In its
/// plane, or free to swing about the line between its supports.
ScenePtr truss(double height, double load, bool in_plane) {
    Points nodes(3, 3);
    nodes << -1, 0, 0, 0, 0, height, 1, 0, 0;
    std::vector<Support> supports{{.kind = SupportKind::fixed, .nodes = {0, 2}}};
    if (in_plane)
        supports.push_back({.kind = SupportKind::on_plane, .nodes = {1}, .direction = Vector3::UnitY()});
    return std::make_shared<const Scene>(
        chain_net(nodes), supports,
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e6), false},
                                       PointLoad{{1}, {0, 0, -load}}});
}

/// A two-way chain of n members that hangs 4 m deep between supports 10 m apart, where it should stand;
/// `uneven` metres off a parabola at every other node.
ScenePtr hanging_chain(Index n, double ea, double uneven = 0) {
    Points nodes = Points::Zero(n + 1, 3);
    nodes.col(0).setLinSpaced(0, 10);
    for (Index i = 1; i < n; ++i)
        nodes(i, 2) = -4 * nodes(i, 0) * (10 - nodes(i, 0)) / 25 + (i % 2 == 0 ? uneven : -uneven);
    return std::make_shared<const Scene>(
        chain_net(nodes), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, n}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, ea), false},
                                       MemberWeight{10}});
}

/// Smallest eigenvalue of the members' tangent, densely.
double least_curvature(const ScenePtr &scene, const Points &nodes) {
    Equilibrium equilibrium(scene);
    const Points x = scene->scale().to_local(nodes);
    equilibrium.evaluate(x);
    BlockMatrix blocks(equilibrium.member_coupling());
    equilibrium.member_tangent(x, {.floor = 0, .convex = false}, blocks);
    Eigen::SparseMatrix<double> tangent;
    blocks.reduce(scene->freedoms(), tangent);
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(tangent)).eigenvalues()[0];
}

std::optional<Instability> instability_at(const ScenePtr &scene, const Points &nodes) {
    Equilibrium equilibrium(scene);
    const Points x = scene->scale().to_local(nodes);
    equilibrium.evaluate(x);
    return find_instability(x, equilibrium);
}

TEST(Stability, ATrussBelowItsLimitLoadStaysOnItsBranch) {
    // z is measured from the line of supports, the truss stands on the other side of it.
    for (const double load : {100.0, 300.0, 380.0, 381.0, 381.087}) {
        const auto scene = truss(-0.1, load, true);
        const auto result = solved(scene);
        ASSERT_EQ(result.status, Status::converged) << load << ": " << result.message;
        const double z = -result.nodes(1, 2);
        EXPECT_GT(z, 0.05763925) << load;
        EXPECT_LT(z, 0.1) << load;
        const double rest = std::hypot(1, 0.1);
        const double length = std::hypot(1, z);
        EXPECT_NEAR(2 * 1e6 / rest * (rest - length) * z / length, load, 1e-6 * load);
        EXPECT_EQ(result.message, "In equilibrium.");
        EXPECT_GT(least_curvature(scene, result.nodes), 0) << load;
    }
}

TEST(Stability, ATrussPastItsLimitLoadSnapsThrough) {
    for (const double load : {381.0872, 381.2, 385.0, 400.0, 1000.0, 1e5}) {
        const auto scene = truss(-0.1, load, true);
        const auto result = solved(scene);
        ASSERT_EQ(result.status, Status::converged) << load << ": " << result.message;
        const double z = result.nodes(1, 2);
        EXPECT_GT(z, 0.1) << load << ": on the other branch";
        const double rest = std::hypot(1, 0.1);
        const double length = std::hypot(1, z);
        EXPECT_NEAR(2 * 1e6 / rest * (length - rest) * z / length, load, 1e-6 * load);
        EXPECT_LT(result.member_forces.maxCoeff(), 0);
    }
}

TEST(Stability, ATrussSnapsThroughAndBackAsItIsLoaded) {
    SolveOptions options;
    options.accuracy = options.tolerance = 1e-9;
    Solver solver(truss(-0.1, 100, true), options);
    const auto height_under = [&solver](double load) {
        solver.replace(truss(-0.1, load, true));
        while (!solver.advance())
            ;
        EXPECT_EQ(solver.result().status, Status::converged) << load;
        return solver.nodes()(1, 2);
    };
    EXPECT_LT(height_under(300), -0.0576);
    EXPECT_LT(height_under(380), -0.0576);
    EXPECT_GT(height_under(390), 0.1);
    EXPECT_GT(height_under(100), 0.1) << "it stays through as the load falls";
    EXPECT_GT(height_under(-380), 0.0576);
    EXPECT_LT(height_under(-390), -0.1) << "and back under the opposite load";
}

TEST(Stability, BarsThatMaySwingAreNoProps) {
    // Free to swing about its supports, a truss under any load stands on the other side.
    for (const double load : {1.0, 100.0, 380.0, 1000.0}) {
        const auto result = solved(truss(-0.1, load, false));
        ASSERT_EQ(result.status, Status::converged) << load << ": " << result.message;
        EXPECT_GT(result.nodes(1, 2), 0.1) << load;
        EXPECT_LT(result.member_forces.maxCoeff(), 0) << load;
        EXPECT_LT(distance(result.nodes, solved(truss(0.1, load, false)).nodes), 1e-9) << load;
    }
}

TEST(Stability, AHangingStartOfTwoWayMembersStands) {
    for (const Index n : {2, 3, 4, 10, 20, 21})
        for (const double ea : {1e3, 1e4, 1e6})
            for (const double uneven : {0.0, 0.1}) {
                const auto scene = hanging_chain(n, ea, uneven);
                const auto result = solve(scene);
                ASSERT_EQ(result.status, Status::converged)
                    << n << " " << ea << " " << uneven << ": " << result.message;
                EXPECT_GT(result.nodes.col(2).maxCoeff(), 3) << n << " " << ea;
                EXPECT_EQ(result.nodes.col(2).minCoeff(), 0) << n << " " << ea;
                EXPECT_LT(result.member_forces.maxCoeff(), 0) << n << " " << ea;
                EXPECT_EQ(result.message, "In equilibrium.");
            }
}

TEST(Stability, RelaxationLeavesPropsToo) {
    SolveOptions options;
    options.method = Method::relaxation;
    const auto result = solve(truss(-0.1, 100, false), options);
    ASSERT_EQ(result.status, Status::converged) << result.message;
    EXPECT_GT(result.nodes(1, 2), 0.1);
}

TEST(Stability, APushedStraightColumnBuckles) {
    // Loaded along its axis: balanced where it is straight, and not for long.
    Points nodes = Points::Zero(5, 3);
    nodes.col(2).setLinSpaced(0, 4);
    const auto scene = std::make_shared<const Scene>(
        chain_net(nodes), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e4), false},
                                       PointLoad{{4}, {0, 0, 100}}});
    const auto result = solve(scene);
    ASSERT_EQ(result.status, Status::converged) << result.message;
    for (Index e = 0; e < 4; ++e)
        EXPECT_NEAR(result.member_forces[e], -100, 1e-3) << "it hangs";
    EXPECT_NEAR(result.nodes(4, 2), -4.04, 1e-3);
}

TEST(Stability, AStraightChainWithoutLoadsThatIsTooLongBuckles) {
    const auto scene = std::make_shared<const Scene>(
        straight_chain(2, 2), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 2}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e4), false}},
        Eigen::VectorXd::Constant(2, 1.1));
    const auto found = instability_at(scene, scene->net().nodes());
    ASSERT_TRUE(found && found->way_out);
    const auto result = solve(scene);
    ASSERT_EQ(result.status, Status::converged) << result.message;
    EXPECT_NEAR(std::hypot(result.nodes(1, 1), result.nodes(1, 2)), std::sqrt(1.1 * 1.1 - 1), 1e-3);
}

TEST(Stability, ADomeThatStartsUpsideDownStands) {
    const auto scene = hemisphere(16, 8, 10, 1e6, false, 20);
    const auto standing = solve(scene);
    ASSERT_EQ(standing.status, Status::converged);
    SolveOptions options;
    options.start = scene->net().nodes();
    options.start->col(2) *= -1;
    const auto result = solve(scene, options);
    ASSERT_EQ(result.status, Status::converged) << result.message;
    EXPECT_LT(distance(result.nodes, standing.nodes), 2e-3);
}

TEST(Stability, HoopsThatPushStayAndAreReportedIfTheyWouldBuckle) {
    // With ribs that pull at every node, the form is the one that was asked for.
    const auto few = hemisphere(16, 16, 10, 1e9, false, 20);
    const auto stable = solve(few);
    ASSERT_EQ(stable.status, Status::converged);
    EXPECT_EQ((stable.member_forces.array() > 0).count(), 128);
    EXPECT_GT(least_curvature(few, stable.nodes), 0);
    EXPECT_EQ(stable.message, "In equilibrium.");

    const auto many = hemisphere(32, 16, 10, 1e9, false, 20);
    const auto slender = solve(many);
    ASSERT_EQ(slender.status, Status::converged);
    EXPECT_EQ((slender.member_forces.array() > 0).count(), 288);
    EXPECT_LT(least_curvature(many, slender.nodes), 0);
    EXPECT_NE(slender.message.find("unstable"), std::string::npos) << slender.message;
    EXPECT_NE(slender.message.find("288 two-way members"), std::string::npos) << slender.message;
}

TEST(Stability, TheWayOutCurvesDownwardsAndLetsTheLoadsWork) {
    for (const Index n : {2, 3, 6}) {
        // Balanced as an arch of struts: the standing form in tension, turned round.
        const auto scene = hanging_chain(n, 1e9);
        Points props = solved(scene).nodes;
        props.col(2) *= -1;
        Equilibrium equilibrium(scene);
        const Points x = scene->scale().to_local(props);
        equilibrium.evaluate(x);
        BlockMatrix blocks(equilibrium.member_coupling());
        // So stiff a chain has nearly the same shape in compression; its forces are set by its lengths.
        std::optional<Instability> found;
        Eigen::VectorXd rest = scene->rest_lengths();
        const auto lengths = solved(scene).member_lengths;
        const auto pushed = std::make_shared<const Scene>(
            scene->with_rest_lengths(lengths + (lengths - scene->rest_lengths())));
        Equilibrium balance(pushed);
        balance.evaluate(x);
        EXPECT_LT(balance.relative_residual(), 1e-4) << n;
        found = find_instability(x, balance);
        ASSERT_TRUE(found && found->way_out) << n;
        balance.member_tangent(x, {.floor = 0, .convex = false}, blocks);
        Eigen::SparseMatrix<double> tangent;
        blocks.reduce(pushed->freedoms(), tangent);
        const Eigen::VectorXd &way = *found->way_out;
        EXPECT_LT(way.dot(tangent * way), 0) << n;
        Eigen::VectorXd loads;
        pushed->freedoms().reduce(balance.loads(), loads);
        EXPECT_GE(loads.dot(way), -1e-6 * loads.norm() * way.norm()) << n;
    }
}

TEST(Stability, NothingIsFactorisedWhereNoMemberPushes) {
    for (const auto &scene :
         {warped_roof(), catenary(20, 10, 12, 100, 1), hemisphere(12, 6, 5, 2e5, true, 20)}) {
        const auto result = solved(scene);
        ASSERT_EQ(result.status, Status::converged);
        Equilibrium equilibrium(scene);
        const Points x = scene->scale().to_local(result.nodes);
        equilibrium.evaluate(x);
        const long before = equilibrium.costs().at("axial").evaluations;
        EXPECT_FALSE(find_instability(x, equilibrium));
        EXPECT_EQ(equilibrium.costs().at("axial").evaluations, before) << "no tangent was asked for";
    }
}

TEST(Stability, SaysWhereEveryMemberIsSlack) {
    // A load in the middle of a cross; the arm beyond it that leads nowhere carries nothing.
    Points nodes(4, 3);
    nodes << 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0;
    const auto net = std::make_shared<const Net>(nodes, std::vector<Member>{{0, 1}, {1, 2}, {1, 3}});
    const auto scene = std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 2}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)},
                                       PointLoad{{1}, {0, 0, -100}}},
        Eigen::Vector3d(1, 1, 3));
    const auto result = solve(scene);
    ASSERT_EQ(result.status, Status::converged) << result.message;
    EXPECT_EQ(result.member_forces[2], 0);
    EXPECT_NE(result.message.find("At 1 node every member is slack"), std::string::npos) << result.message;
}

} // namespace
} // namespace funicular::test
