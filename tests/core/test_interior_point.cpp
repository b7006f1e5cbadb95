// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Stiff compression-only nets, which are solved along a path of force densities and slacks.
#include "certificate.hpp"
#include "interior_point.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace funicular::test {

namespace {

AxialStiffness axial(double ea) {
    return {Eigen::VectorXd::Constant(1, ea)};
}

/// A wavy roof of triangles, 10 m wide, held along its border.
ScenePtr roof_of_triangles(Index side, double ea, std::vector<Support> supports = {}) {
    const auto sheet = flat_sheet(10, 10, 10.0 / (side - 1));
    Points nodes = sheet->nodes();
    for (Index node = 0; node < nodes.rows(); ++node) {
        const double x = nodes(node, 0);
        const double y = nodes(node, 1);
        nodes(node, 2) =
            1.5 + std::sin(0.21 * x + 0.4) * std::cos(0.17 * y - 0.3) + 0.4 * std::sin(0.53 * x + 0.31 * y);
    }
    auto members = sheet->members();
    Panels panels;
    for (Index f = 0; f < sheet->panels().size(); ++f) {
        const auto corners = sheet->panels()[f];
        members.push_back({corners[0], corners[2]});
        panels.add(std::array{corners[0], corners[1], corners[2]});
        panels.add(std::array{corners[0], corners[2], corners[3]});
    }
    const auto net = std::make_shared<const Net>(nodes, members, panels);
    if (supports.empty())
        supports.push_back({.kind = SupportKind::fixed, .nodes = net->border()});
    return std::make_shared<const Scene>(
        net, supports, std::vector<EffectDescription>{axial(ea), MemberWeight{25}, CoveringWeight{50}});
}

SolveOptions goal(double accuracy, double tolerance = 1e-6) {
    SolveOptions options;
    options.accuracy = accuracy;
    options.tolerance = tolerance;
    return options;
}

bool is_on_path(const ScenePtr &scene) {
    Equilibrium equilibrium(scene);
    equilibrium.evaluate(scene->on_supports(scene->scale().to_local(scene->net().nodes())));
    return InteriorPoint::is_for(equilibrium);
}

TEST(InteriorPoint, IsForStiffCompressionOnlyMembersThatBearLoads) {
    EXPECT_TRUE(is_on_path(hemisphere(16, 8, 10, 1e8, true, 25, 50)));
    EXPECT_FALSE(is_on_path(hemisphere(16, 8, 10, 1e8, false, 25, 50)));
    EXPECT_FALSE(is_on_path(hemisphere(16, 8, 10, 1e4, true, 25, 50)));
    EXPECT_FALSE(is_on_path(hemisphere(16, 8, 10, 1e8, true, 0, 0)));
}

TEST(InteriorPoint, AStiffRoofOfTrianglesIsCertified) {
    const auto scene = roof_of_triangles(sized(21, 9), 1e8);
    const Result result = solve(scene);
    expect_certified(scene, result, 1e-6);
    const auto certificate = certify(*scene, result.centred_nodes, nullptr, 1e-6);
    EXPECT_TRUE(certificate.tension_members.empty());
    EXPECT_FALSE(certificate.slack_members.empty());
}

TEST(InteriorPoint, FindsTheShapeOfNewtonsMethod) {
    for (const double ea : {1e8, 1e10}) {
        const auto scene = hemisphere(16, 8, 10, ea, true, 25, 50);
        ASSERT_TRUE(is_on_path(scene));
        EXPECT_LT(distance(solved(scene, Method::automatic).nodes, solved(scene).nodes), 1e-8);
    }
}

TEST(InteriorPoint, StepsDoNotGrowWithTheStiffness) {
    // The path of Newton's method alone takes stages of ever stiffer members.
    long most = 0;
    for (const double ea : {1e7, 1e8, 1e9, 1e10}) {
        const auto scene = roof_of_triangles(11, ea);
        const Result result = solve(scene, goal(1e-3, 1e-4));
        ASSERT_EQ(result.status, Status::converged) << ea << ": " << result.message;
        most = std::max(most, result.iterations);
    }
    EXPECT_LE(most, 40);
}

TEST(InteriorPoint, AFlatSheetOnItsCornersRisesInFewSteps) {
    // Begun too near its end, the path from here is crept along; 71 nodes a side are solved by multigrid.
    for (const Index cells : {20, 49, static_cast<int>(sized(70, 30))})
        for (const double ea : {1e7, 1e8, 1e10}) {
            const auto sheet = flat_sheet(10, 10, 10.0 / cells);
            const auto scene = std::make_shared<const Scene>(
                sheet,
                std::vector<Support>{{.kind = SupportKind::fixed, .nodes = sheet->lattice()->corners()}},
                std::vector<EffectDescription>{axial(ea), MemberWeight{12}, CoveringWeight{30}});
            const Result result = solve(scene);
            expect_certified(scene, result, 1e-6);
            EXPECT_LT(result.iterations, 40) << cells << " cells, EA " << ea;
        }
}

TEST(InteriorPoint, TheDistanceToldIsAboutTheTrueOne) {
    const auto scene = roof_of_triangles(11, 1e8);
    const Result exact = solve(scene, goal(1e-10, 1e-9));
    ASSERT_EQ(exact.status, Status::converged) << exact.message;
    for (const double accuracy : {1e-3, 1e-4, 1e-5, 1e-6}) {
        const Result result = solve(scene, goal(accuracy, 1e6));
        ASSERT_EQ(result.status, Status::converged) << result.message;
        EXPECT_LE(result.position_error, accuracy);
        EXPECT_LE(distance(result.nodes, exact.nodes), 2 * accuracy);
    }
}

TEST(InteriorPoint, SupportsThatYieldAndSlideAreFollowed) {
    auto scene = roof_of_triangles(9, 1e8);
    const auto border = scene->net().border();
    scene = roof_of_triangles(9, 1e8,
                              {{.kind = SupportKind::fixed, .nodes = {0, 8, 72, 80}},
                               {.kind = SupportKind::fixed, .nodes = border, .stiffness = 1e5},
                               {.kind = SupportKind::on_plane, .nodes = {40}, .direction = {1, 0, 0}}});
    const Result result = solve(scene, goal(1e-8, 1e-7));
    expect_certified(scene, result, 1e-6);
}

TEST(InteriorPoint, AnotherNumberingGivesTheSameShape) {
    const auto scene = roof_of_triangles(11, 1e8);
    const Result result = solve(scene, goal(1e-8));
    std::vector<Index> number;
    const auto other = renumbered(*scene, 7, number);
    const Result again = solve(other, goal(1e-8));
    ASSERT_EQ(again.status, Status::converged) << again.message;
    for (Index node = 0; node < scene->net().node_count(); ++node)
        EXPECT_LT((again.nodes.row(number[node]) - result.nodes.row(node)).norm(), 1e-7);
}

TEST(InteriorPoint, ReplacedScenesGoOnFromTheShape) {
    const auto scene = roof_of_triangles(11, 1e8);
    const auto heavier = std::make_shared<const Scene>(
        scene->shared_net(), scene->supports(),
        std::vector<EffectDescription>{axial(1e8), MemberWeight{26}, CoveringWeight{52}});
    Solver solver(scene);
    solver.advance();
    const long cold = solver.result().iterations;
    solver.replace(heavier);
    solver.advance();
    const Result warm = solver.result();
    expect_certified(heavier, warm, 1e-6);
    EXPECT_LT(warm.iterations, cold);
    EXPECT_LT(distance(warm.nodes, solve(heavier).nodes), 1e-3);
}

TEST(InteriorPoint, ScenesThatAreNotForItMayFollowAndPrecede) {
    const auto stiff = roof_of_triangles(9, 1e8);
    const auto with = [&stiff](const AxialStiffness &stiffness) {
        return std::make_shared<const Scene>(
            stiff->shared_net(), stiff->supports(),
            std::vector<EffectDescription>{stiffness, MemberWeight{25}, CoveringWeight{50}});
    };
    AxialStiffness two_way = axial(1e8);
    two_way.compression_only = false;
    const auto soft = with(axial(1e5));
    Solver solver(soft, goal(1e-8));
    for (const auto &scene : {stiff, with(two_way), stiff, soft}) {
        solver.replace(scene);
        solver.advance();
        expect_certified(scene, solver.result(), 1e-6);
    }
    EXPECT_LT(distance(solver.result().nodes, solve(soft, goal(1e-8)).nodes), 1e-6);
}

TEST(InteriorPoint, ANetThatNothingHoldsUpHasNoEquilibrium) {
    // Its border may slide upwards, and does.
    auto scene = roof_of_triangles(7, 1e8);
    const auto border = scene->net().border();
    scene = roof_of_triangles(7, 1e8, {{.kind = SupportKind::fixed, .nodes = border, .stiffness = 1e-3}});
    const Result result = solve(scene);
    EXPECT_EQ(result.status, Status::no_equilibrium) << result.message;
    EXPECT_TRUE(result.nodes.allFinite());
}

TEST(InteriorPoint, CanBeLeftAndEnteredAtEveryStep) {
    const auto scene = roof_of_triangles(9, 1e8);
    const Result whole = solve(scene);
    Solver solver(scene);
    while (!solver.advance(0))
        EXPECT_TRUE(solver.nodes().allFinite());
    EXPECT_EQ(solver.result().iterations, whole.iterations);
    EXPECT_EQ(distance(solver.result().nodes, whole.nodes), 0);
}

} // namespace

} // namespace funicular::test
