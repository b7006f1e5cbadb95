// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Beyond the limit of existence: the figure that is named is the right one.
#include "existence.hpp"
#include "scenes.hpp"

#include <cmath>
#include <limits>

namespace funicular::test {

namespace {

/// The number after these words.
double figure_after(const std::string &message, const std::string &words) {
    const auto at = message.find(words);
    if (at == std::string::npos) {
        ADD_FAILURE() << "no '" << words << "' in: " << message;
        return 0;
    }
    return std::stod(message.substr(at + words.size()));
}

/// A square sheet of 10 m on its corners, EA 5 kN.
ScenePtr sheet(Index cells, double covering, double ea = 5000) {
    const auto net = flat_sheet(10, 10, 10.0 / cells);
    return std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, ea)},
                                       CoveringWeight{covering}});
}

/// Height of a strand over its length at rest, in closed form: l_i = (k r + w sum of l_j above) / (k - w /
/// 2).
double growth_of_strand(Index n, double length, double ea, double weight) {
    const double k = ea * n / length;
    double above = 0;
    for (Index e = 0; e < n; ++e)
        above += (k * length / n + weight * above) / (k - weight / 2);
    return above / length;
}

/// The largest weight under which a growth that rises with it is no more than `most_growth`.
template <typename Growth>
double limit_of(Growth &&growth, double above) {
    double low = 0;
    double high = above;
    for (int halving = 0; halving < 100; ++halving) {
        const double middle = (low + high) / 2;
        (growth(middle) < most_growth ? low : high) = middle;
    }
    return low;
}

double limit_of_strand(Index n, double length, double ea) {
    return limit_of([&](double weight) { return growth_of_strand(n, length, ea, weight); },
                    2 * ea * n / length);
}

/// Under which weight the two equal members over a span of 10 m have risen so far that the diagonal is
/// `most_growth` times as long: 2 k (l - r) h / l², in closed form.
double limit_of_two_members(double ea) {
    const double rise = 10 * std::sqrt(most_growth * most_growth - 1);
    const double length = std::hypot(5, rise);
    return 2 * (ea / 5) * (length - 5) * rise / (length * length);
}

/// How many times the span the diagonal of a shape is.
double growth(const Result &result, double diagonal) {
    return (result.nodes.colwise().maxCoeff() - result.nodes.colwise().minCoeff()).norm() / diagonal;
}

/// What is 5 % above a figure is carried by no net that anyone would build, and what is 5 % below it is.
void expect_limit_at(const ScenePtr &below, const ScenePtr &above, double diagonal) {
    const auto carried = solve(below);
    EXPECT_EQ(carried.status, Status::converged) << carried.message;
    EXPECT_LT(growth(carried, diagonal), most_growth);
    const auto beyond = solve(above);
    if (beyond.status == Status::converged)
        EXPECT_GT(growth(beyond, diagonal), most_growth);
    else
        EXPECT_EQ(beyond.status, Status::no_equilibrium) << beyond.message;
}

TEST(Existence, TheLimitOfAStrandIsTheOneInClosedForm) {
    EXPECT_NEAR(limit_of_strand(1, 10, 10), 1.8, 1e-12) << "2 k (1 - 1 / growth)";
    for (const Index n : {1, 2, 3, 5})
        for (const double times : {4.0, 30.0, 1e5}) {
            const double limit = limit_of_strand(n, 10, 10);
            const auto result = solve(strand(n, 10, 10, times * limit));
            ASSERT_EQ(result.status, Status::no_equilibrium) << n << " " << times;
            const double most = standard_gravity * figure_after(result.message, "at most about ");
            EXPECT_NEAR(most, limit, 0.05 * limit) << n << " " << times << ": " << result.message;
            // The same figure, as the stiffness that would do.
            EXPECT_NE(result.message.find("member weight"), std::string::npos) << result.message;
            EXPECT_NE(result.message.find("stiffness EA = 10 N"), std::string::npos) << result.message;
        }
    for (const Index n : {1, 5, 40}) {
        const double limit = limit_of_strand(n, 10, 10);
        expect_limit_at(strand(n, 10, 10, 0.95 * limit), strand(n, 10, 10, 1.05 * limit), 10);
    }
    const auto stiffer = solve(strand(1, 10, 10, 3)).message;
    EXPECT_NEAR(figure_after(stiffer, "at least about EA = "), 30 / 1.8, 0.05 * 30 / 1.8) << stiffer;
}

TEST(Existence, TheLimitOfTwoMembersIsTheOneInClosedForm) {
    const double limit = limit_of_two_members(100);
    for (const double times : {1.2, 4.0, 1e3}) {
        const auto result = solve(catenary(2, 10, 10, 100, times * limit));
        ASSERT_EQ(result.status, Status::no_equilibrium) << times;
        EXPECT_NEAR(standard_gravity * figure_after(result.message, "at most about "), limit, 0.05 * limit)
            << result.message;
        EXPECT_NE(result.message.find("there the net has already grown to 10 times its size"),
                  std::string::npos)
            << result.message;
    }
    expect_limit_at(catenary(2, 10, 10, 100, 0.95 * limit), catenary(2, 10, 10, 100, 1.05 * limit), 10);
}

TEST(Existence, TheFigureOfASheetIsTheLargestWeightThatItCarries) {
    const double diagonal = std::sqrt(200);
    for (const Index cells : {4, 6, 20}) {
        const auto result = solve(sheet(cells, 1e4));
        ASSERT_EQ(result.status, Status::no_equilibrium);
        const double most = figure_after(result.message, "at most about ");
        EXPECT_GT(most, 0);

        // By brute force: heavier and heavier by steps of 1 %, each from the shape before.
        SolveOptions options;
        options.method = Method::newton;
        double carried = 0;
        for (double weight = 0.5 * most; weight < 2 * most; weight *= 1.01) {
            Solver solver(sheet(cells, weight), options);
            bool ended = false;
            for (int step = 0; step < 100 && !ended; ++step)
                ended = solver.advance(0);
            const auto next = solver.result();
            if (next.status != Status::converged || growth(next, diagonal) > most_growth)
                break;
            options.start = next.nodes;
            carried = weight;
        }
        EXPECT_NEAR(most, carried, 0.05 * carried) << result.message;
        expect_limit_at(sheet(cells, 0.95 * most), sheet(cells, 1.05 * most), diagonal);
        const double ea = 1000 * figure_after(result.message, "at least about EA = ");
        EXPECT_NEAR(ea, 5000 * 1e4 / most, 0.01 * ea) << "weights and stiffness scale together";
    }
}

TEST(Existence, SeveralLoadsAreNamedWithTheirShare) {
    const auto net = flat_sheet(10, 10, 2.5);
    const auto with = [&net](double times) {
        return std::make_shared<const Scene>(
            net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}},
            std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 5000)},
                                           MemberWeight{30 * times}, CoveringWeight{1000 * times},
                                           Snow{500 * times}, PointLoad{{12}, {0, 0, -200 * times}}});
    };
    const auto result = solve(with(1));
    ASSERT_EQ(result.status, Status::no_equilibrium);
    const double part = figure_after(result.message, "at most about ") / 100;
    EXPECT_NEAR(figure_after(result.message, "the loads are "), 1 / part, 0.02 / part) << result.message;
    EXPECT_NEAR(figure_after(result.message, "member weight "), 30 * part, 0.02 * 30 * part);
    EXPECT_NEAR(figure_after(result.message, "covering weight "), 1000 * part, 0.02 * 1000 * part);
    EXPECT_NEAR(figure_after(result.message, "snow "), 500 * part, 0.02 * 500 * part);
    EXPECT_NEAR(figure_after(result.message, "point load "), 200 * part, 0.02 * 200 * part);
    expect_limit_at(with(0.95 * part), with(1.05 * part), std::sqrt(200));
}

TEST(Existence, StiffnessOfEachMemberAndPerSpring) {
    Points nodes = Points::Zero(3, 3);
    nodes.col(2).setLinSpaced(0, 2);
    const auto with = [&nodes](const AxialStiffness &axial, double support) {
        return solve(
                   std::make_shared<const Scene>(
                       chain_net(nodes),
                       std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0}, .stiffness = support}},
                       std::vector<EffectDescription>{axial, MemberWeight{10}}))
            .message;
    };
    const double rigid = std::numeric_limits<double>::infinity();
    const auto each = with({Eigen::Vector2d(10, 20)}, rigid);
    EXPECT_NE(each.find("the members' stiffness"), std::string::npos) << each;
    EXPECT_GT(figure_after(each, "to at least about "), 1) << each;
    const auto springs = with({Eigen::VectorXd::Constant(1, 10), true, true}, rigid);
    EXPECT_NE(springs.find("k = 10 N/m"), std::string::npos) << springs;
    EXPECT_NEAR(figure_after(springs, "at least about k = "),
                10 * standard_gravity * 10 / limit_of_strand(2, 2, 10), 0.05 * 50);
    // Where a support yields, stiffer members alone need not have the shape of lighter loads.
    const auto yielding = with({Eigen::VectorXd::Constant(1, 10)}, 1e4);
    EXPECT_EQ(yielding.find("at least about"), std::string::npos) << yielding;
}

TEST(Existence, JustBelowTheLimitIsSolvedThoughNewtonRanAway) {
    // A limit refuses nothing that it carries: whatever ends without equilibrium is beyond the figure named.
    for (const double weight : {300.0, 320.0, 330.0, 340.0, 400.0, 500.0}) {
        const auto result = solve(sheet(4, weight));
        if (result.status == Status::converged)
            continue;
        ASSERT_EQ(result.status, Status::no_equilibrium) << result.message;
        EXPECT_GT(weight, figure_after(result.message, "at most about ")) << result.message;
    }
}

TEST(Existence, TheSearchIsBoundedCancelledAndLeft) {
    const auto scene = sheet(10, 1e5);
    long last = 0;
    SolveOptions options;
    options.on_progress = [&last](const Report &report) {
        EXPECT_TRUE(report.iteration == last || report.iteration == last + 1);
        last = report.iteration;
        return true;
    };
    const auto whole = solve(scene, options);
    ASSERT_EQ(whole.status, Status::no_equilibrium);
    EXPECT_EQ(whole.iterations, last);
    EXPECT_LE(whole.iterations, 60 + LoadLimitSearch::most_steps);

    // Cancelled in the middle of the search.
    options.on_progress = [&whole](const Report &report) { return report.iteration < whole.iterations / 2; };
    const auto cancelled = solve(scene, options);
    EXPECT_EQ(cancelled.status, Status::cancelled);
    EXPECT_EQ(cancelled.iterations, whole.iterations / 2);

    // Left between any two steps, it comes to the same.
    Solver solver(scene);
    long calls = 1;
    while (!solver.advance(0))
        ++calls;
    EXPECT_EQ(calls, whole.iterations);
    EXPECT_EQ(solver.result().message, whole.message);

    // At its own limit, the solver says what is known by then.
    options = {};
    options.max_iterations = whole.iterations - 20;
    const auto stopped = solve(scene, options);
    EXPECT_EQ(stopped.status, Status::no_equilibrium);
    EXPECT_EQ(stopped.iterations, whole.iterations - 20);
    EXPECT_EQ(stopped.message.find("No equilibrium"), 0) << stopped.message;
    options.max_iterations.reset();
    options.max_seconds = 0;
    EXPECT_EQ(solve(scene, options).status, Status::time_limit);
}

TEST(Existence, ASceneReplacedDuringTheSearchStartsFromItsNet) {
    Solver solver(strand(2, 10, 10, 50));
    const auto has_run_away = [&solver] { return solver.nodes().col(2).maxCoeff() > 10 * runaway_growth; };
    for (int step = 0; step < 60 && !has_run_away(); ++step)
        solver.advance(0);
    for (int step = 0; step < 5; ++step)
        solver.advance(0);
    ASSERT_EQ(solver.result().message, "Not finished: call advance again.");
    solver.replace(strand(2, 10, 10, 1));
    EXPECT_EQ(distance(solver.nodes(), strand(2, 10, 10, 1)->net().nodes()), 0);
    while (!solver.advance())
        ;
    EXPECT_EQ(solver.result().status, Status::converged);
    EXPECT_NEAR(solver.nodes().col(2).maxCoeff(), 17.777778, 1e-3);
}

TEST(Scene, LoadsTimesAFactor) {
    const auto scene = warped_roof();
    const auto half = scene->with_loads_times(0.5);
    Equilibrium whole(scene);
    Equilibrium part(std::make_shared<const Scene>(half));
    const Points x = scene->scale().to_local(scene->net().nodes());
    whole.evaluate(x);
    part.evaluate(x);
    EXPECT_EQ(half.scale().length, scene->scale().length);
    const Points expected = 0.5 * scene->scale().force * whole.loads();
    EXPECT_LT(distance(half.scale().force * part.loads(), expected), 1e-12 * expected.norm());
    EXPECT_EQ(scene->with_loads_times(0).acting().size(), 1) << "a load of zero is an absent effect";
    expect_invalid([&] { (void)scene->with_loads_times(-1); }, {"factor"});
    expect_invalid([&] { (void)scene->with_loads_times(1e308); }, {"finite"});
}

} // namespace
} // namespace funicular::test
