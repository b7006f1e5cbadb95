// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Hard cases of use: lengths that cannot be had (17), supports dragged, snap-through and back (18), edits in
/// the middle of a solve, cancelling and resuming (20).
#include "certificate.hpp"
#include "length_matching.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace funicular::test {

namespace {

AxialStiffness axial(double ea, bool compression_only = true) {
    return {Eigen::VectorXd::Constant(1, ea), compression_only};
}

/// Goes on to the end, which must come.
Result finished(Solver &solver) {
    EXPECT_TRUE(solver.advance());
    return solver.result();
}

TEST(HardCase17_LengthTargets, AHundredRoundsOfTargetsShorterThanTheSpan) {
    // Every member shall be as long as in a straight line between the supports, and the chain cannot be
    // straight.
    const auto scene = catenary(10, 10, 10, 1000, 20);
    const auto matching = solve_matching_lengths(scene, 100);
    EXPECT_EQ(matching.status, Status::converged);
    expect_certified(matching.scene, matching.result, 1e-6);
    EXPECT_TRUE((matching.scene->rest_lengths().array() > 0).all());
    EXPECT_TRUE((matching.result.member_lengths.array() > 1).any()) << "no chain is straight under load";
    for (const double deviation : matching.deviations) {
        EXPECT_TRUE(std::isfinite(deviation));
        EXPECT_GE(deviation, matching.deviations[matching.best_round]);
    }
    EXPECT_LT(matching.deviations[matching.best_round], matching.deviations.front() / 2);
}

TEST(HardCase17_LengthTargets, AHundredRoundsByHandStayInEquilibriumOrSayWhyNot) {
    // What a script does that knows no better: match without end, keep nothing.
    ScenePtr scene = hemisphere(12, 6, 5, 1e5, true, 20, 30);
    Result result = solve(scene);
    for (int round = 0; round < 100; ++round) {
        scene = match_lengths(*scene, result);
        ASSERT_TRUE((scene->rest_lengths().array() > 0).all() && scene->rest_lengths().allFinite()) << round;
        SolveOptions options;
        options.start = result.nodes;
        result = solve(scene, options);
        ASSERT_TRUE(result.nodes.allFinite()) << round;
        if (result.status != Status::converged) {
            EXPECT_FALSE(result.message.empty());
            return;
        }
        expect_certified(scene, result, 1e-6);
    }
}

TEST(HardCase17_LengthTargets, MembersFarTooShortForTheSpanAreStretchedToIt) {
    // A tenth or a ten-thousandth of what they have to bridge: T = EA (l / r - 1), almost straight.
    for (const double part : {0.1, 1e-4}) {
        const auto scene = catenary(8, 10, 10 * part, 100, 1);
        const auto result = solved_in_any_numbering(scene);
        for (const double force : result.member_forces)
            EXPECT_NEAR(-force, 100 * (1 / part - 1), 0.02 * 100 / part);
        // w s² / 8 H, shallow.
        const double rise = 1.0 * 100 / (8 * 100 * (1 / part - 1));
        EXPECT_NEAR(result.nodes.col(2).maxCoeff(), rise, 0.05 * rise);
    }
}

/// A sheet whose corner `dragged` stands elsewhere; rest lengths are those of the flat sheet.
ScenePtr dragged_sheet(const Vector3 &by) {
    const auto flat = flat_sheet(6, 6, 1);
    Points nodes = flat->nodes();
    nodes.row(48) += by.transpose();
    return std::make_shared<const Scene>(
        make_net(flat->lattice(), nodes),
        std::vector<Support>{{.kind = SupportKind::fixed, .nodes = flat->lattice()->corners()}},
        std::vector<EffectDescription>{axial(1e5), MemberWeight{5}, CoveringWeight{15}},
        flat->source_lengths());
}

TEST(HardCase18_Dragging, ASupportDraggedDuringASolveLeadsWhereItStopped) {
    Solver solver(dragged_sheet(Vector3::Zero()));
    for (int step = 1; step <= 40; ++step) {
        const double part = step / 40.0;
        // Out of the plane, out of the net, and through where others stand.
        solver.replace(dragged_sheet({2 * std::sin(7 * part), -3 * part, 4 * part}));
        solver.advance(0);
        ASSERT_TRUE(solver.nodes().allFinite());
    }
    const auto last = dragged_sheet({2 * std::sin(7.0), -3, 4});
    const auto result = finished(solver);
    expect_certified(last, result, 1e-6);
    EXPECT_LT(distance(result.nodes, solved(last).nodes), 2e-3);
    EXPECT_EQ(result.nodes.row(48), last->net().nodes().row(48));
    // And back, in one jump.
    const auto first = dragged_sheet(Vector3::Zero());
    solver.replace(first);
    EXPECT_LT(distance(finished(solver).nodes, solved(first).nodes), 2e-3);
}

/// Two struts to a node between fixed ends (von Mises): half span 1, height 0.1, EA 1 MN, pushed by `load`
/// [N] in the sense of form finding, upwards. Drawn hanging, so that the load is against its rise.
ScenePtr von_mises(double load, bool compression_only = false) {
    Points nodes(3, 3);
    nodes << -1, 0, 0, 0, 0, -0.1, 1, 0, 0;
    return std::make_shared<const Scene>(
        chain_net(nodes),
        std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 2}},
                             // Without it two struts fall over sideways under any load.
                             {.kind = SupportKind::on_plane, .nodes = {1}, .direction = Vector3::UnitY()}},
        std::vector<EffectDescription>{axial(1e6, compression_only), PointLoad{{1}, {0, 0, -load}}});
}

/// The force that holds the middle at height z, and how it grows with z.
double von_mises_force(double z) {
    const double rest = std::hypot(1, 0.1);
    return 2 * 1e6 / rest * (std::hypot(1, z) - rest) * z / std::hypot(1, z);
}

constexpr double limit_load = 381.087190;
constexpr double limit_height = 0.05763925;

TEST(HardCase18_SnapThrough, TheLimitOfTheOracleIsThatOfTheLaw) {
    EXPECT_NEAR(von_mises_force(-limit_height), limit_load, 1e-6);
    EXPECT_GT(von_mises_force(-limit_height), von_mises_force(-limit_height - 1e-4));
    EXPECT_GT(von_mises_force(-limit_height), von_mises_force(-limit_height + 1e-4));
}

TEST(HardCase18_SnapThrough, GoesThroughPastTheLimitAndBackPastTheOther) {
    // Below the limit either branch is an equilibrium, past it one: never the unstable middle between the
    // limits.
    Solver solver(von_mises(0));
    (void)finished(solver);
    const auto step_to = [&](double load) {
        const auto scene = von_mises(load);
        solver.replace(scene);
        const auto result = finished(solver);
        EXPECT_EQ(result.status, Status::converged) << load << " N: " << result.message;
        const double z = result.nodes(1, 2);
        EXPECT_NEAR(von_mises_force(z), load, 1e-2) << load;
        EXPECT_GT(std::abs(z), limit_height) << "an unstable equilibrium at " << load << " N";
        EXPECT_LT(result.nodes.row(1).head<2>().norm(), 1e-9);
        return z;
    };
    for (int cycle = 0; cycle < 3; ++cycle) {
        for (const double part : {0.0, 0.5, 0.9, 0.99})
            step_to(part * limit_load);
        EXPECT_GT(step_to(1.001 * limit_load), 0.1) << "snapped through";
        EXPECT_GT(step_to(10 * limit_load), 0.1);
        for (const double part : {0.99, 0.5, 0.0, -0.5, -0.9})
            step_to(part * limit_load);
        EXPECT_LT(step_to(-1.001 * limit_load), -0.1) << "snapped back";
        EXPECT_LT(step_to(-10 * limit_load), -0.1);
    }
}

TEST(HardCase18_SnapThrough, SmallStepsStayOnTheirBranchUntilItEnds) {
    Solver solver(von_mises(0));
    (void)finished(solver);
    for (double load = 0; load < 0.999 * limit_load; load += 0.02 * limit_load) {
        solver.replace(von_mises(load));
        const auto result = finished(solver);
        ASSERT_EQ(result.status, Status::converged) << result.message;
        EXPECT_LT(result.nodes(1, 2), -limit_height) << "left its branch at " << load / limit_load;
    }
    solver.replace(von_mises(1.02 * limit_load));
    EXPECT_GT(finished(solver).nodes(1, 2), 0.1);
}

TEST(HardCase18_SnapThrough, AStateInTheWrongSignIsNotCalledCompressed) {
    // Hanging under half the limit load its struts push, which is tension where it is built.
    for (const double part : {0.1, 0.5, 0.9}) {
        const auto two_way = von_mises(part * limit_load);
        const auto result = solved(two_way);
        expect_certified(two_way, result);
        const auto certificate = certify(*two_way, result.centred_nodes, nullptr, 1e-9);
        EXPECT_EQ(certificate.compression_only, result.nodes(1, 2) > 0) << certificate.summary();
        // Members that cannot push are not held there: they stand at once.
        const auto one_way = von_mises(part * limit_load, true);
        const auto standing = solved(one_way);
        expect_certified(one_way, standing);
        EXPECT_GT(standing.nodes(1, 2), 0.1);
        EXPECT_TRUE(certify(*one_way, standing.centred_nodes, nullptr, 1e-9).compression_only);
    }
}

SceneParts editable() {
    const auto net = flat_sheet(6, 5, 1);
    SceneParts parts{net->nodes(), net->members(), net->panels(), {}, {}, net->source_lengths()};
    parts.supports = {{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}};
    parts.effects = {axial(1e5), MemberWeight{5}, CoveringWeight{20}};
    return parts;
}

/// The roof after a random edit of each of its parameters.
ScenePtr edited(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> exponent(-1, 1);
    const auto factor = [&] { return std::pow(10, exponent(random)); };
    auto parts = editable();
    parts.effects = {axial(1e5 * factor(), random() % 2 == 0), MemberWeight{5 * factor()}};
    if (random() % 2 == 0)
        parts.effects.emplace_back(CoveringWeight{20 * factor()});
    if (random() % 2 == 0)
        parts.effects.emplace_back(PointLoad{{17}, {200, 100, -300}});
    if (random() % 2 == 0)
        parts.supports.push_back({.kind = SupportKind::on_line, .nodes = {3, 38}, .direction = {0, 1, 0.2}});
    if (random() % 2 == 0)
        parts.supports.push_back({.kind = SupportKind::fixed, .nodes = {17}, .stiffness = 1000 * factor()});
    if (random() % 2 == 0)
        parts.rest_lengths *= 0.9 + 0.01 * static_cast<double>(random() % 20);
    return parts.scene();
}

TEST(HardCase20_EditsMidSolve, TheLastSceneDecidesWhateverCameBefore) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        Solver solver(edited(100 * seed));
        for (unsigned edit = 1; edit < 6; ++edit) {
            for (unsigned step = 0; step < edit % 4; ++step)
                solver.advance(0);
            solver.replace(edited(100 * seed + edit));
            ASSERT_TRUE(solver.nodes().allFinite());
        }
        const auto last = edited(100 * seed + 5);
        const auto result = finished(solver);
        expect_certified(last, result, 1e-6);
        const auto &effects = last->effects();
        if (std::get<AxialStiffness>(effects[0]).compression_only) {
            EXPECT_LT(distance(result.nodes, solved(last).nodes), 2e-3) << seed;
        }
    }
}

TEST(HardCase20_EditsMidSolve, ARefusedEditChangesNothing) {
    const auto scene = editable().scene();
    Solver solver(scene);
    solver.advance(0);
    const Points before = solver.nodes();
    expect_invalid([&] { solver.replace(nullptr); }, {"scene is missing"});
    expect_invalid([&] { solver.replace(catenary(4, 10, 12, 100, 1)); }, {"5 nodes", "42"});
    EXPECT_EQ(solver.nodes(), before);
    const auto result = finished(solver);
    EXPECT_EQ(result.nodes, solve(scene).nodes);
}

TEST(HardCase20_EditsMidSolve, CancelledAfterAnyStepItResumes) {
    const auto scene = editable().scene();
    const auto whole = solve(scene);
    for (const Method method : {Method::automatic, Method::newton, Method::relaxation})
        for (long after = 0; after < std::min<long>(whole.iterations, sized(12, 2)); ++after) {
            SolveOptions options;
            options.method = method;
            bool is_cancelling = true;
            options.on_progress = [&](const Report &report) {
                return !is_cancelling || report.iteration < after;
            };
            Solver solver(scene, options);
            EXPECT_EQ(finished(solver).status, Status::cancelled);
            expect_words(solver.result().message, {"Cancelled", "not an equilibrium"});
            EXPECT_TRUE(solver.nodes().allFinite());
            // The same scene again goes on from the shape it was left in, by replace or from a new start.
            const Points left = solver.nodes();
            is_cancelling = false;
            solver.replace(scene);
            EXPECT_LT(distance(solver.nodes(), left), 1e-12);
            expect_certified(scene, finished(solver), 1e-6);
            EXPECT_LT(distance(solver.nodes(), whole.nodes), 2e-3);
            options.start = left;
            expect_certified(scene, solve(scene, options), 1e-6);
        }
}

} // namespace
} // namespace funicular::test
