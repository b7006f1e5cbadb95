// SPDX-License-Identifier: LGPL-2.1-or-later
#include "certificate.hpp"
#include "equilibrium.hpp"
#include "scenes.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <thread>

namespace funicular::test {

namespace {

TEST(Solve, ConvergedMeansBothGoals) {
    for (const Method method : {Method::newton, Method::relaxation, Method::automatic}) {
        SolveOptions options;
        options.method = method;
        options.tolerance = 1e-4;
        options.accuracy = 1e-6;
        const auto scene = catenary(20, 10, 12, 100, 1);
        const auto result = solve(scene, options);
        ASSERT_EQ(result.status, Status::converged);
        EXPECT_LE(result.residual, options.tolerance);
        EXPECT_LE(result.position_error, options.accuracy);
        // The estimate is of the true distance to equilibrium.
        EXPECT_LE(distance(result.nodes, solved(scene).nodes), 2 * std::max(result.position_error, 1e-13));
    }
}

TEST(Solve, LimitsAreNeitherSuccessNorFailure) {
    const auto scene = catenary(40, 10, 12, 100, 1);
    SolveOptions options;
    options.max_iterations = 3;
    for (const Method method : {Method::newton, Method::relaxation}) {
        options.method = method;
        const auto result = solve(scene, options);
        EXPECT_EQ(result.status, Status::iteration_limit);
        EXPECT_EQ(result.iterations, 3);
        EXPECT_GT(result.residual, options.tolerance);
        EXPECT_NE(result.message.find("not an equilibrium"), std::string::npos);
        EXPECT_TRUE(result.nodes.allFinite());
    }
    options = {};
    options.max_seconds = 0;
    EXPECT_EQ(solve(scene, options).status, Status::time_limit);
}

TEST(Solve, CancelKeepsTheLastShape) {
    SolveOptions options;
    long told = 0;
    options.on_progress = [&told](const Report &report) {
        EXPECT_EQ(report.iteration, told);
        return ++told < 4;
    };
    const auto result = solve(catenary(40, 10, 12, 100, 1), options);
    EXPECT_EQ(result.status, Status::cancelled);
    EXPECT_EQ(result.iterations, 3);
    EXPECT_EQ(result.history.size(), 4);
    EXPECT_TRUE(result.nodes.allFinite());
    EXPECT_GT(result.nodes.col(2).maxCoeff(), 0);
}

TEST(Solve, AnExceptionOfTheCallbackGoesThrough) {
    SolveOptions options;
    options.on_progress = [](const Report & /*report*/) -> bool { throw std::runtime_error("stop"); };
    EXPECT_THROW((void)solve(catenary(10, 10, 12, 100, 1), options), std::runtime_error);
}

TEST(Solve, SaysWhenTheWeightIsBeyondWhatTheStiffnessCarries) {
    // A strand has no equilibrium for w >= 2 k; close below, it has a very long one.
    const auto just_below = solved(strand(1, 10, 10, 1.99));
    ASSERT_EQ(just_below.status, Status::converged);
    EXPECT_NEAR(just_below.nodes(1, 2), 10 / (1 - 1.99 / 2), 1e-6);
    for (const Method method : {Method::newton, Method::automatic, Method::relaxation})
        for (const double weight : {2.0, 3.0, 50.0}) {
            SolveOptions options;
            options.method = method;
            options.max_iterations = 200'000;
            const auto result = solve(strand(1, 10, 10, weight), options);
            EXPECT_EQ(result.status, Status::no_equilibrium) << weight;
            EXPECT_NE(result.message.find("stiffness"), std::string::npos);
            EXPECT_TRUE(result.nodes.allFinite());
        }
}

TEST(Solve, EveryStiffnessFromSoftToRigid) {
    for (const double ea : {1e1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12}) {
        SolveOptions options;
        options.accuracy = 1e-6;
        const auto result = solve(catenary(40, 10, 10.5, ea, ea < 1e10 ? 1 : 100), options);
        ASSERT_EQ(result.status, Status::converged) << ea << ": " << result.message;
        EXPECT_LT(result.iterations, 60) << ea;
        if (ea >= 1e8) {
            EXPECT_NEAR(result.nodes.col(2).maxCoeff(), 1.393042066, 1e-3) << ea;
        }
    }
}

TEST(Solve, SaysWhereRoundingHidesTheForces) {
    // One unit in the last place of a position is a force of many nodal loads here.
    const auto result = solve(catenary(40, 10, 10.5, 1e15, 1));
    EXPECT_NE(result.status, Status::converged);
    EXPECT_NE(result.message.find("rounding"), std::string::npos) << result.message;
}

TEST(Solve, OneStiffMemberElsewhereExcusesNothing) {
    // A chain, and apart from it a bar between fixed nodes: what rounding makes of the bar is not the
    // chain's.
    Points nodes = Points::Zero(13, 3);
    nodes.col(0).head(11).setLinSpaced(0, 10);
    nodes.row(11) << 0, 5, 0;
    nodes.row(12) << 1, 5, 0;
    std::vector<Member> members{{11, 12}};
    for (Index i = 0; i < 10; ++i)
        members.push_back({i, i + 1});
    Eigen::VectorXd stiffness = Eigen::VectorXd::Constant(11, 1e4);
    const auto with_bar = [&](double bar) {
        stiffness[0] = bar;
        return std::make_shared<const Scene>(
            std::make_shared<const Net>(nodes, members),
            std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 10, 11, 12}}},
            std::vector<EffectDescription>{AxialStiffness{stiffness}, MemberWeight{10}});
    };
    const auto plain = solved(with_bar(1e4));
    for (const double bar : {1e8, 1e12, 1e18}) {
        const auto result = solved(with_bar(bar));
        ASSERT_EQ(result.status, Status::converged) << bar << ": " << result.message;
        EXPECT_LT(distance(result.nodes, plain.nodes), 1e-10) << bar;
    }
}

TEST(Solve, UnevenStiffness) {
    // Every other member far stiffer than the rest: an equilibrium exists, and is found from the source.
    const auto net = flat_sheet(4, 4, 1);
    for (const double ratio : {1e2, 1e4, 1e6}) {
        Eigen::VectorXd stiffness = Eigen::VectorXd::Constant(net->member_count(), 1e4);
        for (Index e = 0; e < stiffness.size(); e += 2)
            stiffness[e] *= ratio;
        const auto result = solve(std::make_shared<const Scene>(
            net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}},
            std::vector<EffectDescription>{AxialStiffness{stiffness}, CoveringWeight{10}}));
        EXPECT_EQ(result.status, Status::converged) << ratio << ": " << result.message;
    }
    for (const double ratio : {1e5, 1e7, 1e9}) {
        Eigen::VectorXd stiffness = Eigen::VectorXd::Constant(net->member_count(), 1e4);
        stiffness[17] *= ratio;
        const auto result = solve(std::make_shared<const Scene>(
            net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}},
            std::vector<EffectDescription>{AxialStiffness{stiffness}, CoveringWeight{10}}));
        EXPECT_EQ(result.status, Status::converged) << "one member, " << ratio << ": " << result.message;
        EXPECT_LT(result.iterations, 100) << ratio;
    }
}

TEST(Solve, HexagonsOnAWheelOfSixFindTheirForm) {
    // Its rim, held at every other node, warps: shares by angle must not jump there.
    Points nodes(7, 3);
    std::vector<Member> members;
    std::vector<Index> rim;
    nodes.row(6).setZero();
    for (Index k = 0; k < 6; ++k) {
        nodes.row(k) << 5 * std::cos(k * std::numbers::pi / 3), 5 * std::sin(k * std::numbers::pi / 3), 0;
        members.push_back({k, (k + 1) % 6});
        members.push_back({k, 6});
        rim.push_back(k);
    }
    Panels panels;
    panels.add(rim);
    const auto result = solve(std::make_shared<const Scene>(
        std::make_shared<const Net>(nodes, members, panels),
        std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 2, 4}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)},
                                       CoveringWeight{10}}));
    EXPECT_EQ(result.status, Status::converged) << result.message;
}

TEST(Solve, ForcesBeyondNumbersAreNeverAnEquilibrium) {
    const auto net = straight_chain(2, 2);
    const std::vector<Support> ends{{.kind = SupportKind::fixed, .nodes = {0, 2}}};
    const auto with = [&](const EffectDescription &load, double ea) {
        return solve(std::make_shared<const Scene>(
            net, ends,
            std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, ea)}, load}));
    };
    SolveOptions options;
    options.start = net->nodes() * 1e200;
    options.max_iterations = 50;
    const auto far = solve(std::make_shared<const Scene>(
                               net, ends,
                               std::vector<EffectDescription>{
                                   AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)}, MemberWeight{1}}),
                           options);
    if (far.status != Status::converged) {
        EXPECT_GT(far.residual, 0);
    }
    expect_invalid([&] { (void)with(MemberWeight{1e-300}, 1e200); },
                   {"AxialStiffness", "beyond what numbers hold"});
}

TEST(Solve, WithoutLoadsATautNetIsAtRest) {
    const auto scene = std::make_shared<const Scene>(
        flat_sheet(4, 4, 1),
        std::vector<Support>{
            {.kind = SupportKind::fixed, .nodes = flat_sheet(4, 4, 1)->lattice()->corners()}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1000)}});
    const auto slack = solve(scene);
    EXPECT_EQ(slack.status, Status::converged);
    EXPECT_EQ(slack.residual, 0);
    EXPECT_EQ(distance(slack.nodes, scene->net().nodes()), 0);

    const auto taut = std::make_shared<const Scene>(scene->with_rest_lengths(0.5 * scene->rest_lengths()));
    const auto result = solved(taut);
    ASSERT_EQ(result.status, Status::converged) << result.message;
    EXPECT_LT(result.member_forces.maxCoeff(), 0);
}

TEST(Solve, ANetWhoseLastLoadIsTakenOffLiesDownOnItsSource) {
    const auto sheet = flat_sheet(10, 10, 0.5);
    const auto with = [&sheet](double weight, const std::vector<Index> &held, double ea) {
        return std::make_shared<const Scene>(
            sheet, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = held}},
            std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, ea)},
                                           MemberWeight{weight}});
    };
    for (const double ea : {1e4, 1e7})
        for (const auto &held : {sheet->lattice()->corners(), sheet->border()})
            for (const Method method : {Method::automatic, Method::newton, Method::relaxation}) {
                SolveOptions options;
                options.start = solve(with(25, held, ea)).nodes;
                options.method = method;
                const auto unloaded = with(0, held, ea);
                const auto result = solve(unloaded, options);
                EXPECT_EQ(result.status, Status::converged) << result.message;
                EXPECT_LT(distance(result.nodes, sheet->nodes()), 1e-12);
                const auto certificate = certify(*unloaded, result.centred_nodes, nullptr, 1e-6);
                EXPECT_TRUE(certificate.in_equilibrium) << certificate.summary();
                Solver solver(with(25, held, ea));
                solver.advance();
                solver.replace(unloaded);
                EXPECT_TRUE(solver.advance());
                EXPECT_EQ(solver.result().status, Status::converged);
            }
}

TEST(Solve, StartsFromAGivenShapeBroughtOntoTheSupports) {
    const auto scene = catenary(20, 10, 12, 100, 1);
    const auto cold = solve(scene);
    SolveOptions options;
    options.start = cold.nodes;
    EXPECT_LE(solve(scene, options).iterations, 1);
    options.start->array() += 0.5;
    const auto result = solve(scene, options);
    EXPECT_EQ(result.status, Status::converged);
    EXPECT_EQ(result.nodes.row(0), scene->net().nodes().row(0));

    options.start = Points::Zero(3, 3);
    expect_invalid([&] { (void)solve(scene, options); }, {"start has 3 nodes", "21"});
    options.start = scene->net().nodes();
    (*options.start)(4, 1) = std::numeric_limits<double>::quiet_NaN();
    expect_invalid([&] { (void)solve(scene, options); }, {"start[4]"});
}

TEST(Solve, RefusesGoalsThatCannotBeMeant) {
    const auto scene = catenary(4, 10, 12, 100, 1);
    const auto with = [&scene](const std::function<void(SolveOptions &)> &change) {
        return [&scene, change] {
            SolveOptions options;
            change(options);
            (void)solve(scene, options);
        };
    };
    expect_invalid(with([](auto &o) { o.accuracy = 0; }), {"accuracy"});
    expect_invalid(with([](auto &o) { o.accuracy = std::nan(""); }), {"accuracy"});
    expect_invalid(with([](auto &o) { o.tolerance = -1; }), {"tolerance"});
    expect_invalid(with([](auto &o) { o.max_seconds = -1; }), {"max_seconds"});
    expect_invalid(with([](auto &o) { o.max_iterations = -1; }), {"max_iterations"});
    expect_invalid([] { (void)solve(nullptr); }, {"scene is missing"});
}

TEST(Solve, HistoryOfAVeryLongRunStaysShortAndEven) {
    SolveOptions options;
    options.method = Method::relaxation;
    options.tolerance = 1e-13;
    options.accuracy = 1e-13;
    options.max_iterations = 20'000;
    const auto result = solve(catenary(60, 10, 12, 1000, 1), options);
    EXPECT_EQ(result.iterations, 20'000);
    ASSERT_GT(result.history.size(), 1000);
    ASSERT_LT(result.history.size(), 5000);
    const long stride = result.history[1].iteration;
    for (std::size_t k = 0; k < result.history.size(); ++k)
        EXPECT_EQ(result.history[k].iteration, static_cast<long>(k) * stride);
}

TEST(Solver, CanBeLeftAndEnteredAgain) {
    const auto scene = catenary(20, 10, 12, 100, 1);
    Solver solver(scene);
    int calls = 1;
    while (!solver.advance(0))
        ++calls;
    const auto piecewise = solver.result();
    const auto whole = solve(scene);
    EXPECT_EQ(piecewise.status, Status::converged);
    EXPECT_EQ(piecewise.iterations, whole.iterations);
    EXPECT_EQ(piecewise.nodes, whole.nodes);
    EXPECT_EQ(calls, whole.iterations) << "each call makes one step at least";
    EXPECT_TRUE(solver.advance(0));
}

TEST(Solver, RecoversFromARunaway) {
    Solver solver(strand(2, 10, 10, 50));
    while (!solver.advance())
        ;
    EXPECT_EQ(solver.result().status, Status::no_equilibrium);
    solver.replace(strand(2, 10, 10, 1));
    while (!solver.advance())
        ;
    EXPECT_EQ(solver.result().status, Status::converged);
    EXPECT_NEAR(solver.nodes().col(2).maxCoeff(), 17.777778, 1e-3);
}

TEST(Solver, ServesSeveralThreads) {
    Solver solver(catenary(60, 10, 12, 1000, 1));
    std::atomic<bool> stop = false;
    std::vector<std::thread> threads;
    for (int k = 0; k < 2; ++k)
        threads.emplace_back([&] {
            while (!stop)
                solver.advance(0);
        });
    threads.emplace_back([&] {
        while (!stop) {
            const auto result = solver.result();
            const auto &nodes = result.nodes;
            const double first = (nodes.row(1) - nodes.row(0)).norm();
            if (std::abs(first - result.member_lengths[0]) > 1e-9)
                ADD_FAILURE() << "a result of two shapes";
        }
    });
    for (int k = 0; k < 60; ++k) {
        solver.replace(catenary(60, 10, 12, 1000, 1 + 0.01 * k));
        EXPECT_TRUE(solver.nodes().allFinite());
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    stop = true;
    for (auto &thread : threads)
        thread.join();
}

TEST(Solver, ReplaceKeepsTheShape) {
    Solver solver(catenary(20, 10, 12, 100, 1));
    EXPECT_EQ(solver.result().status, Status::iteration_limit) << "not success before it has begun";
    while (!solver.advance())
        ;
    const Points before = solver.nodes();
    const auto heavier = catenary(20, 10, 12, 100, 1.05);
    solver.replace(heavier);
    EXPECT_LT(distance(solver.nodes(), before), 1e-12);
    while (!solver.advance())
        ;
    const auto warm = solver.result();
    const auto cold = solve(heavier);
    EXPECT_EQ(warm.status, Status::converged);
    EXPECT_LT(warm.iterations, cold.iterations);
    EXPECT_LT(distance(warm.nodes, cold.nodes), 1e-3);
    expect_invalid([&] { solver.replace(catenary(10, 10, 12, 100, 1)); }, {"11 nodes", "21"});
}

TEST(Weights, AreConservedInEveryIteration) {
    const auto scene = std::make_shared<const Scene>(
        flat_sheet(6, 4, 1),
        std::vector<Support>{
            {.kind = SupportKind::fixed, .nodes = flat_sheet(6, 4, 1)->lattice()->corners()}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 2e4)}, MemberWeight{12},
                                       CoveringWeight{30}});
    for (const Method method : {Method::newton, Method::relaxation}) {
        SolveOptions options;
        options.method = method;
        options.max_iterations = 40;
        Solver solver(scene, options);
        Equilibrium equilibrium(scene);
        bool ended = false;
        int checked = 0;
        while (!ended) {
            ended = solver.advance(0);
            const Points nodes = solver.result().nodes;
            equilibrium.evaluate(scene->scale().to_local(nodes));
            double length = 0;
            for (const auto &[i, j] : scene->net().members())
                length += (nodes.row(i) - nodes.row(j)).norm();
            double area = 0;
            for (Index f = 0; f < scene->net().panels().size(); ++f) {
                const auto corners = scene->net().panels()[f];
                Vector3 middle = Vector3::Zero();
                for (const Index corner : corners)
                    middle += nodes.row(corner).transpose() / 4;
                for (int k = 0; k < 4; ++k) {
                    const Vector3 a = nodes.row(corners[k]).transpose() - middle;
                    const Vector3 b = nodes.row(corners[(k + 1) % 4]).transpose() - middle;
                    area += a.cross(b).norm() / 2;
                }
            }
            const double mass = equilibrium.loads().col(2).sum() * scene->scale().force / standard_gravity;
            EXPECT_NEAR(mass, 12 * length + 30 * area, 1e-11 * mass);
            ++checked;
        }
        EXPECT_GT(checked, 5);
    }
}

} // namespace
} // namespace funicular::test
