// SPDX-License-Identifier: LGPL-2.1-or-later
#include "equilibrium.hpp"
#include "scenes.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace funicular::test {

namespace {

/// What a scene on a lattice is made of, for a test to change one thing after the other.
struct Roof {
    NetPtr net = flat_sheet(8, 8, 8.0 / 18); // more nodes than are factorised at once
    Eigen::VectorXd stiffness = Eigen::VectorXd::Constant(1, 5e4);
    bool compression_only = true;
    double weights = 1;
    double rest = 1;
    double spring = 800;
    std::vector<Support> more = {};

    [[nodiscard]] ScenePtr scene() const {
        const auto &lattice = *net->lattice();
        auto supports = more;
        supports.push_back({.kind = SupportKind::fixed, .nodes = lattice.corners()});
        supports.push_back(
            {.kind = SupportKind::on_line, .nodes = {lattice.node_at(3, 0)}, .direction = {1, 0, 0.2}});
        supports.push_back(
            {.kind = SupportKind::fixed, .nodes = {lattice.node_at(7, 11)}, .stiffness = spring});
        return std::make_shared<const Scene>(
            net, supports,
            std::vector<EffectDescription>{
                AxialStiffness{stiffness, compression_only}, MemberWeight{12 * weights},
                CoveringWeight{30 * weights},
                PointLoad{{lattice.node_at(2, 2), lattice.node_at(9, 9)}, weights * Vector3(100, -50, -400)},
                Snow{700 * weights}},
            Eigen::VectorXd(rest * net->source_lengths()));
    }
};

SolveOptions to_rounding(const ScenePtr &scene, Method method = Method::automatic) {
    SolveOptions options;
    options.tolerance = 1e-11;
    options.accuracy = 1e-11 * scene->net().size();
    options.method = method;
    return options;
}

void expect_as_fresh(const Solver &solver, const ScenePtr &scene, const char *what) {
    SCOPED_TRACE(what);
    const Result result = solver.result();
    const Result fresh = solve(scene, to_rounding(scene));
    EXPECT_EQ(result.status, Status::converged) << result.message;
    EXPECT_EQ(fresh.status, Status::converged) << fresh.message;
    EXPECT_LE(distance(result.nodes, fresh.nodes), 1e-9 * scene->net().size());
    expect_certified(scene, result);
}

TEST(Automatic, AgreesWithNewtonAndRelaxationUnderEveryEffect) {
    for (const double stiffness : {5e4, 5e3}) {
        Roof roof;
        // Of a smaller one under sanitizers: relaxation there takes minutes.
        roof.net = flat_sheet(8, 8, 8.0 / sized(18, 12));
        roof.stiffness *= stiffness / 5e4;
        const auto scene = roof.scene();
        const Result automatic = solve(scene, to_rounding(scene));
        expect_certified(scene, automatic);
        for (const Method method : {Method::newton, Method::relaxation}) {
            const Result other = solve(scene, to_rounding(scene, method));
            EXPECT_EQ(other.status, Status::converged) << other.message;
            EXPECT_EQ(other.method, method);
            EXPECT_LE(distance(automatic.nodes, other.nodes), 1e-8 * scene->net().size());
        }
    }
}

TEST(Automatic, GivesTheSameBitsEachTime) {
    const auto scene = Roof{}.scene();
    const Result first = solve(scene);
    const Result second = solve(scene);
    EXPECT_EQ(first.nodes, second.nodes);
    EXPECT_EQ(first.member_forces, second.member_forces);
    EXPECT_EQ(first.iterations, second.iterations);
    EXPECT_EQ(first.position_error, second.position_error);
}

/// Iterations on the scene's own net: only there is the position error known.
long steps_on_own_net(const Result &result) {
    return std::count_if(result.history.begin(), result.history.end(),
                         [](const Report &report) { return std::isfinite(report.position_error); });
}

TEST(Automatic, MovesALargeNetSeldom) {
    Roof roof;
    roof.net = flat_sheet(8, 8, 8.0 / 64);
    const auto scene = roof.scene();
    SolveOptions options;
    const Result automatic = solve(scene, options);
    options.method = Method::newton;
    const Result newton = solve(scene, options);
    EXPECT_EQ(automatic.status, Status::converged) << automatic.message;
    EXPECT_EQ(newton.status, Status::converged) << newton.message;
    EXPECT_LE(steps_on_own_net(automatic), 7);
    EXPECT_LT(steps_on_own_net(automatic), newton.iterations);
    // All nets together, most of which cost next to nothing.
    EXPECT_LE(automatic.costs.at("covering_weight").evaluations,
              2 * newton.costs.at("covering_weight").evaluations);
}

TEST(Automatic, DoesNotLeaveAPushingShapeThatItFoundFromTheStartItself) {
    // Two corners in one place: what the coarser nets lead to comes to nothing, and the scene's own net is
    // solved from its start shape. That again would be the same way, and beyond the limit of iterations.
    const Index cells_u = 17;
    const Index cells_v = 34;
    LatticeRecipe recipe;
    recipe.cells_u = cells_u;
    recipe.cells_v = cells_v;
    const auto lattice = std::make_shared<const Lattice>(recipe);
    Points nodes = Points::Zero(lattice->uv().rows(), 3);
    nodes.leftCols(2) = 10 * lattice->uv();
    for (const Index corner : {lattice->node_at(0, 0), lattice->node_at(cells_u, cells_v)})
        nodes.row(corner) << 0, 0, 3;
    const auto net = make_net(lattice, nodes);
    std::vector<Index> held = lattice->sides().at(Side::u_min);
    const auto &other = lattice->sides().at(Side::u_max);
    held.insert(held.end(), other.begin(), other.end());
    const double load = 10 * standard_gravity * net->source_lengths().sum();
    const std::vector<EffectDescription> effects{
        AxialStiffness{.stiffness = Eigen::VectorXd::Constant(1, 500 * load), .compression_only = false},
        MemberWeight{10}};
    const auto scene =
        std::make_shared<const Scene>(net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = held}},
                                      effects, Eigen::VectorXd(1.1 * net->source_lengths()));
    const auto result = solve(scene);
    EXPECT_EQ(result.status, Status::converged) << result.message;
}

TEST(PositionError, IsThatOfADenseSolution) {
    for (const Index cells : {12, 18}) { // factorised, and by multigrid
        Roof roof;
        roof.net = flat_sheet(8, 8, 8.0 / cells);
        const auto scene = roof.scene();
        int visible = 0;
        for (const Method method : {Method::newton, Method::automatic})
            for (long steps = 1; steps < 60; ++steps) {
                auto options = to_rounding(scene, method);
                options.max_iterations = steps;
                const Result result = solve(scene, options);
                if (result.status == Status::converged)
                    break;
                if (!(result.position_error < 0.1) || result.residual > 0.1 || result.residual < 1e-8)
                    continue;
                ++visible;
                Equilibrium equilibrium(scene);
                const Points x = result.centred_nodes / scene->scale().length;
                equilibrium.evaluate(x);
                BlockMatrix blocks(equilibrium.coupling());
                equilibrium.tangent(x, {.floor = 0, .convex = false}, blocks);
                Eigen::SparseMatrix<double, Eigen::RowMajor> tangent;
                blocks.reduce(scene->freedoms(), tangent);
                const Eigen::VectorXd step =
                    Eigen::MatrixXd(tangent).partialPivLu().solve(equilibrium.residual());
                Points motion(x.rows(), 3);
                scene->freedoms().expand(step, motion);
                const double error = motion.rowwise().norm().maxCoeff() * scene->scale().length;
                EXPECT_NEAR(result.position_error, error, 0.2 * error)
                    << "after " << steps << " steps, residual " << result.residual;
            }
        EXPECT_GE(visible, 2);
    }
}

TEST(Replace, GivesWhatAFreshSolveDoes) {
    Roof roof;
    Solver solver(roof.scene(), to_rounding(roof.scene()));
    solver.advance();
    expect_as_fresh(solver, roof.scene(), "as it was");
    const auto replaced = [&](const Roof &by, const char *what) {
        const auto scene = by.scene();
        solver.replace(scene);
        EXPECT_TRUE(solver.advance());
        expect_as_fresh(solver, scene, what);
    };
    const Roof as_it_was = roof;
    roof.weights = 1.3;
    replaced(roof, "a little heavier");
    roof.weights = 1e-3;
    replaced(roof, "a thousand times lighter");
    replaced(as_it_was, "back");
    roof = as_it_was;
    roof.rest = 0.9;
    replaced(roof, "shorter");
    roof.rest = 1.05;
    replaced(roof, "longer");
    roof = as_it_was;
    roof.stiffness *= 1000;
    replaced(roof, "1000 times as stiff");
    roof.stiffness /= 1e4;
    replaced(roof, "10 times as soft");
    roof.stiffness = Eigen::VectorXd::LinSpaced(roof.net->member_count(), 2e4, 8e4);
    replaced(roof, "a stiffness for each member");
    roof.spring = 80000;
    replaced(roof, "a stiffer spring");
    roof.spring = 8;
    replaced(roof, "a softer spring");
    roof.weights = 500;
    roof.stiffness *= 500;
    replaced(roof, "everything else in other units of force than the spring");
    roof = as_it_was;
    roof.more = {{.kind = SupportKind::fixed, .nodes = {roof.net->lattice()->node_at(13, 5)}}};
    replaced(roof, "one more support");
    replaced(as_it_was, "and one less");
}

TEST(Replace, GoesOnFromTheShapeAndWhatWasMadeForIt) {
    Roof roof;
    Solver solver(roof.scene());
    solver.advance();
    const long fresh = solver.result().iterations;
    const Points shape = solver.nodes();
    roof.weights = 1.01;
    solver.replace(roof.scene());
    EXPECT_LE(distance(solver.nodes(), shape), 1e-14);
    solver.advance();
    EXPECT_EQ(solver.result().status, Status::converged);
    EXPECT_LT(solver.result().iterations, fresh);
    EXPECT_LE(solver.result().iterations, 4);
}

TEST(Replace, ByWhatIsFarAwayBeginsOnCoarserNets) {
    Roof roof;
    const auto begins_on_coarser_nets = [&roof](const Roof &other) {
        Solver solver(roof.scene());
        solver.advance();
        const auto scene = other.scene();
        solver.replace(scene);
        solver.advance();
        EXPECT_EQ(solver.result().status, Status::converged);
        EXPECT_LE(distance(solver.result().nodes, solve(scene).nodes), 2e-3);
        // While they are solved, nothing is known of how far the scene's own net is from rest.
        return std::isinf(solver.result().history.front().position_error);
    };
    Roof other = roof;
    other.weights = 1.05;
    EXPECT_FALSE(begins_on_coarser_nets(other));
    other.weights = 3;
    EXPECT_TRUE(begins_on_coarser_nets(other));
    other = roof;
    other.stiffness /= 10;
    EXPECT_TRUE(begins_on_coarser_nets(other));
}

TEST(Replace, ManyTimesInARowFinishedOrNot) {
    Roof roof;
    Solver solver(roof.scene(), to_rounding(roof.scene()));
    for (int k = 0; k < 40; ++k) {
        roof.weights = 1 + 0.5 * std::sin(0.7 * k);
        roof.rest = 1 + 0.05 * std::cos(0.9 * k);
        roof.stiffness[0] = 5e4 * std::pow(10, std::sin(1.3 * k));
        solver.replace(roof.scene());
        if (k % 3 == 0)
            solver.advance();
        else
            solver.advance(0); // an iteration
    }
    solver.advance();
    expect_as_fresh(solver, roof.scene(), "after all");
}

TEST(Replace, WhileACoarserNetIsSolved) {
    Roof roof;
    roof.net = flat_sheet(8, 8, 8.0 / 40);
    for (const int steps : {0, 1, 3}) {
        Solver solver(roof.scene(), to_rounding(roof.scene()));
        for (int k = 0; k < steps; ++k)
            ASSERT_FALSE(solver.advance(0));
        EXPECT_TRUE(std::isinf(solver.result().position_error) || steps == 0);
        Roof other = roof;
        other.weights = 1.5;
        solver.replace(other.scene());
        solver.advance();
        expect_as_fresh(solver, other.scene(), std::to_string(steps).c_str());
    }
}

TEST(Replace, AfterNoEquilibrium) {
    Roof roof;
    Roof heavy = roof;
    heavy.weights = 1000;
    Solver solver(heavy.scene(), to_rounding(roof.scene()));
    solver.advance();
    ASSERT_EQ(solver.result().status, Status::no_equilibrium) << solver.result().message;
    solver.replace(roof.scene());
    solver.advance();
    expect_as_fresh(solver, roof.scene(), "bearable");
    solver.replace(heavy.scene());
    solver.advance();
    EXPECT_EQ(solver.result().status, Status::no_equilibrium) << solver.result().message;
    solver.replace(roof.scene());
    solver.advance();
    expect_as_fresh(solver, roof.scene(), "bearable again");
}

TEST(Replace, OfATwoWayNetThatHasPushed) {
    Roof roof;
    roof.compression_only = false;
    roof.rest = 1.02;
    Solver solver(roof.scene(), to_rounding(roof.scene()));
    solver.advance();
    expect_certified(roof.scene(), solver.result());
    Roof pulling = roof;
    pulling.compression_only = true;
    solver.replace(pulling.scene());
    solver.advance();
    expect_as_fresh(solver, pulling.scene(), "compression-only");
}

} // namespace
} // namespace funicular::test
