// SPDX-License-Identifier: LGPL-2.1-or-later
#include "kept_factor.hpp"
#include "krylov.hpp"
#include "multigrid.hpp"
#include "newton_direction.hpp"
#include "scenes.hpp"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace funicular::test {

namespace {

constexpr double small_floor = 1e-6;

/// The members' tangent of a scene at a shape, as it stands and as a product.
struct MembersSystem {
    MembersSystem(const ScenePtr &of, const Points &at, double pull)
        : scene(of), x(at), floor(pull), equilibrium(of), motion(x.rows(), 3) {
        equilibrium.evaluate(x);
        equilibrium.linearise(x, {.floor = floor, .convex = true});
    }

    void multiply(const Eigen::VectorXd &unknowns, Eigen::VectorXd &image) {
        scene->freedoms().expand(unknowns, motion);
        Points forces = Points::Zero(x.rows(), 3);
        const auto &members = scene->net().members();
        for (std::size_t e = 0; e < members.size(); ++e) {
            const auto [i, j] = members[e];
            const Vector3 force =
                equilibrium.member_tangents()[e] * (motion.row(i) - motion.row(j)).transpose();
            forces.row(i) += force.transpose();
            forces.row(j) -= force.transpose();
        }
        for (const auto &support : scene->elastic_supports())
            forces.row(support.node) +=
                (support.stiffness * motion.row(support.node).transpose()).transpose();
        scene->freedoms().reduce(forces, image);
    }

    /// Conjugate residuals to 1e-6 on a load that holds every wavelength.
    LinearProgress solve(Preconditioner &preconditioner, int most_iterations = 40) {
        std::srand(1);
        const Eigen::VectorXd load = Eigen::VectorXd::Random(scene->freedoms().size());
        Eigen::VectorXd solution = Eigen::VectorXd::Zero(load.size());
        return ConjugateResiduals().solve(
            [this](const Eigen::VectorXd &v, Eigen::VectorXd &image) { multiply(v, image); },
            [&](const Eigen::VectorXd &v, Eigen::VectorXd &image) { preconditioner.apply(v, image); }, load,
            1e-6, most_iterations, solution);
    }

    ScenePtr scene;
    Points x;
    double floor;
    Equilibrium equilibrium;
    Points motion;
};

/// A sheet of `cells` whose lines weigh 500 N/m, held along its border or at its corners, and elsewhere if so
/// asked.
struct Sheet {
    Index cells = 32;
    double stiffness = 1e5;
    bool compression_only = true;
    bool by_corners = false;
    std::vector<Support> more = {};

    [[nodiscard]] ScenePtr scene() const {
        const auto net = flat_sheet(10, 10, 10.0 / cells);
        auto supports = more;
        supports.push_back(
            {.kind = SupportKind::fixed, .nodes = by_corners ? net->lattice()->corners() : net->border()});
        return std::make_shared<const Scene>(
            net, std::move(supports),
            std::vector<EffectDescription>{
                AxialStiffness{Eigen::VectorXd::Constant(1, stiffness), compression_only},
                MemberWeight{500 / standard_gravity}});
    }
};

/// A ring of lines between two circles, both held: closed, flat to begin with.
ScenePtr ring(Index around, Index across) {
    LatticeRecipe recipe;
    recipe.cells_u = around;
    recipe.cells_v = across;
    recipe.closed_u = true;
    auto lattice = std::make_shared<const Lattice>(recipe);
    Points nodes(lattice->uv().rows(), 3);
    for (Index i = 0; i < nodes.rows(); ++i) {
        const double azimuth = 2 * std::numbers::pi * lattice->uv()(i, 0);
        const double radius = 2 + 4 * lattice->uv()(i, 1);
        nodes.row(i) << radius * std::cos(azimuth), radius * std::sin(azimuth), 0;
    }
    const auto inner = lattice->sides().at(Side::v_min);
    const auto outer = lattice->sides().at(Side::v_max);
    return std::make_shared<const Scene>(
        make_net(lattice, nodes),
        std::vector<Support>{{.kind = SupportKind::fixed, .nodes = inner},
                             {.kind = SupportKind::fixed, .nodes = outer}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e5)},
                                       MemberWeight{500 / standard_gravity}});
}

/// Ten metres high; lines weigh 250 N/m.
ScenePtr dome(Index around, Index up) {
    return hemisphere(around, up, 10, 1e5, true, 250 / standard_gravity);
}

Points shape_of(const ScenePtr &scene) {
    const Result result = solve(scene);
    EXPECT_EQ(result.status, Status::converged) << result.message;
    return scene->scale().to_local(result.nodes);
}

/// Iterations that multigrid needs to lower the residual by 1e6 in the shape of equilibrium.
int iterations(const ScenePtr &scene, double floor = small_floor) {
    MembersSystem system(scene, shape_of(scene), floor);
    const auto levels = coarser_levels(*scene);
    EXPECT_FALSE(levels.empty());
    Multigrid multigrid(*scene, levels);
    EXPECT_TRUE(multigrid.prepare(system.x, system.equilibrium, floor));
    const auto progress = system.solve(multigrid);
    EXPECT_LE(progress.residual, 1e-6);
    return progress.iterations;
}

TEST(LineSmoother, SolvesALineBesideNodesAtRest) {
    LatticeRecipe recipe;
    recipe.cells_u = 12;
    recipe.cells_v = 1;
    auto lattice = std::make_shared<const Lattice>(recipe);
    Points nodes(lattice->uv().rows(), 3);
    for (Index i = 0; i < nodes.rows(); ++i) {
        const double u = lattice->uv()(i, 0);
        nodes.row(i) << 4 * u, lattice->uv()(i, 1), std::sin(3 * u) + 0.2 * std::cos(9 * u);
    }
    std::vector<Index> held;
    for (Index i = 0; i <= 12; ++i)
        held.push_back(lattice->node_at(i, 1));
    const auto net = make_net(lattice, nodes);
    const auto scene = std::make_shared<const Scene>(
        net,
        std::vector<Support>{{.kind = SupportKind::fixed, .nodes = held},
                             {.kind = SupportKind::on_line, .nodes = {3}, .direction = {1, 2, 1}},
                             {.kind = SupportKind::on_plane, .nodes = {7}, .direction = {0, 1, 2}},
                             {.kind = SupportKind::fixed, .nodes = {9}, .stiffness = 50}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e3)}, MemberWeight{10}},
        Eigen::VectorXd(0.95 * net->source_lengths()));
    const MembersSystem system(scene, scene->scale().to_local(nodes), 1e-3);
    const auto &tangents = system.equilibrium.member_tangents();

    std::vector<SymmetricBlock<double>> diagonals(net->node_count(), SymmetricBlock<double>{});
    std::vector<ShortMemberTangent> short_tangents;
    for (std::size_t e = 0; e < tangents.size(); ++e) {
        for (const Index end : net->members()[e])
            diagonals[end].add(tangents[e].around, tangents[e].along, tangents[e].direction);
        short_tangents.push_back({.direction = tangents[e].direction.cast<Real>(),
                                  .along = static_cast<Real>(tangents[e].along),
                                  .around = static_cast<Real>(tangents[e].around)});
    }
    for (const auto &support : scene->elastic_supports())
        diagonals[support.node].add(support.stiffness(0, 0), 0, Vector3::UnitX());

    const auto &freedoms = scene->freedoms();
    const Eigen::VectorXd load = Eigen::VectorXd::Random(freedoms.size());
    Points load_on_nodes(nodes.rows(), 3);
    freedoms.expand(load, load_on_nodes);
    Vectors3r forces(nodes.rows());
    for (Index node = 0; node < nodes.rows(); ++node)
        forces[node] = load_on_nodes.row(node).transpose().cast<Real>();

    LineSmoother smoother(*lattice, net->members(), LineSmoother::Direction::u);
    ASSERT_TRUE(smoother.prepare(tangents, diagonals, freedoms));
    for (const auto order : {LineSmoother::Order::forward, LineSmoother::Order::backward}) {
        Vectors3r motion(nodes.rows(), Vector3r::Zero());
        smoother.sweep(short_tangents, forces, order, motion);

        KeptFactor factor(system.equilibrium);
        ASSERT_TRUE(factor.prepare(system.x, system.equilibrium, 0));
        Eigen::VectorXd exact;
        factor.apply(load, exact);
        Points exact_motion(nodes.rows(), 3);
        freedoms.expand(exact, exact_motion);
        for (Index node = 0; node < nodes.rows(); ++node)
            EXPECT_LT((motion[node].cast<double>() - exact_motion.row(node).transpose()).norm(),
                      1e-4 * exact_motion.cwiseAbs().maxCoeff())
                << "node " << node;
    }
}

TEST(Multigrid, FallsFiveTimesWithEachIterationOnSheets) {
    EXPECT_LE(iterations(Sheet{}.scene()), 8);
    EXPECT_LE(iterations(Sheet{.stiffness = 1e7}.scene()), 8) << "a hundred times as stiff";
    EXPECT_LE(iterations(Sheet{.cells = 27}.scene()), 8) << "odd cells";
    EXPECT_LE(iterations(Sheet{.compression_only = false}.scene()), 8) << "two-way";
}

TEST(Multigrid, FallsFiveTimesWithEachIterationOnClosedLattices) {
    EXPECT_LE(iterations(ring(48, 16)), 8);
    EXPECT_LE(iterations(ring(43, 13)), 8) << "odd cells";
    EXPECT_LE(iterations(dome(32, 8)), 8) << "with a pole";
    EXPECT_LE(iterations(dome(27, 9)), 8) << "odd cells and a pole";
}

TEST(Multigrid, FallsFiveTimesWithEachIterationOnSupportsOfEveryKind) {
    const Index inside = 33 * 11 + 17; // on no coarser line
    EXPECT_LE(iterations(Sheet{.more = {{.kind = SupportKind::fixed, .nodes = {inside}}}}.scene()), 8);
    EXPECT_LE(
        iterations(
            Sheet{.more = {{.kind = SupportKind::fixed, .nodes = {inside, 500}, .stiffness = 2e3}}}.scene()),
        8);
    std::vector<Index> edge;
    std::vector<Index> middle;
    for (Index i = 0; i <= 32; ++i) {
        edge.push_back(i);
        middle.push_back(33 * 11 + i);
    }
    const Support on_line{.kind = SupportKind::on_line, .nodes = middle, .direction = {1, 0, 0}};
    const Support on_plane{.kind = SupportKind::on_plane, .nodes = edge, .direction = {0, 1, 0}};
    EXPECT_LE(iterations(Sheet{.more = {on_line}}.scene()), 8);
    EXPECT_LE(iterations(Sheet{.by_corners = true, .more = {on_plane}}.scene()), 8);
}

TEST(Multigrid, IterationsHardlyGrowWithTheNet) {
    for (const bool by_corners : {false, true}) {
        const int few = iterations(Sheet{.cells = 16, .by_corners = by_corners}.scene());
        EXPECT_LE(iterations(Sheet{.cells = 32, .by_corners = by_corners}.scene()), few + 1);
        EXPECT_LE(iterations(Sheet{.cells = 64, .by_corners = by_corners}.scene()), few + 1);
    }
}

TEST(Multigrid, SolvesWhereEveryNodeIsHeld) {
    const auto net = flat_sheet(8, 8, 1);
    std::vector<Index> all(net->node_count());
    for (Index node = 0; node < net->node_count(); ++node)
        all[node] = node;
    for (const bool leave_one : {false, true}) {
        if (leave_one)
            all.erase(all.begin() + 30);
        const auto scene = std::make_shared<const Scene>(
            net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = all}},
            std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)},
                                           MemberWeight{1}});
        MembersSystem system(scene, scene->scale().to_local(net->nodes()), 1e-3);
        Multigrid multigrid(*scene, coarser_levels(*scene));
        EXPECT_TRUE(multigrid.prepare(system.x, system.equilibrium, system.floor));
        EXPECT_LE(system.solve(multigrid).residual, 1e-6);
        EXPECT_EQ(solve(scene).status, Status::converged);
    }
}

/// A sheet with every effect, on a lattice, with supports of every kind.
ScenePtr everything(Index cells, bool compression_only) {
    const auto net = flat_sheet(8, 8, 8.0 / cells);
    const auto &lattice = *net->lattice();
    return std::make_shared<const Scene>(
        net,
        std::vector<Support>{
            {.kind = SupportKind::fixed, .nodes = lattice.corners()},
            {.kind = SupportKind::on_line, .nodes = {lattice.node_at(3, 0)}, .direction = {1, 0, 0.2}},
            {.kind = SupportKind::on_plane, .nodes = {lattice.node_at(cells, 5)}, .direction = {1, 0, 0}},
            {.kind = SupportKind::fixed, .nodes = {lattice.node_at(5, 5)}, .stiffness = 800}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 5e4), compression_only},
                                       MemberWeight{12}, CoveringWeight{30},
                                       PointLoad{{lattice.node_at(2, 2)}, {100, -50, -400}}, Snow{700}});
}

Eigen::MatrixXd dense_tangent(const ScenePtr &scene, const Points &x, double floor, bool convex) {
    Equilibrium equilibrium(scene);
    BlockMatrix blocks(equilibrium.coupling());
    equilibrium.tangent(x, {.floor = floor, .convex = convex}, blocks);
    Eigen::SparseMatrix<double, Eigen::RowMajor> tangent;
    blocks.reduce(scene->freedoms(), tangent);
    return tangent;
}

TEST(NewtonDirection, IsThatOfTheFullTangentOnBothPaths) {
    for (const bool compression_only : {true, false}) {
        const auto scene = everything(8, compression_only);
        const Points rest = shape_of(scene);
        for (const double disturbance : {1e-6, 1e-3, 3e-2}) {
            std::srand(5);
            Points x = scene->on_supports(rest + disturbance * Points::Random(rest.rows(), 3));
            Equilibrium equilibrium(scene);
            equilibrium.evaluate(x);
            const Eigen::VectorXd residual = equilibrium.residual();
            for (const bool by_multigrid : {false, true}) {
                SCOPED_TRACE((by_multigrid ? "multigrid, residual " : "factor, residual ") +
                             std::to_string(equilibrium.relative_residual()));
                NewtonDirection direction =
                    by_multigrid
                        ? NewtonDirection(std::make_unique<Multigrid>(*scene, coarser_levels(*scene)))
                        : NewtonDirection(equilibrium);
                direction.compute(x, equilibrium, {.tolerance = 1e-12});
                ASSERT_TRUE(direction.is_newton_step());
                const Eigen::MatrixXd tangent =
                    dense_tangent(scene, x, direction.floor(), equilibrium.relative_residual() > 0.1);
                // What is asked for is a tenth of the relative residual, and a tenth at least.
                const double accuracy = std::min(0.1, std::max(1e-6, 0.1 * equilibrium.relative_residual()));
                EXPECT_LE((residual - tangent * direction.unknowns()).norm(),
                          1.01 * accuracy * residual.norm());
                const Eigen::PartialPivLU<Eigen::MatrixXd> dense(tangent);
                EXPECT_LE((direction.unknowns() - dense.solve(residual)).norm(),
                          1.01 * accuracy * dense.inverse().norm() * residual.norm());
                EXPECT_GT(residual.dot(direction.unknowns()), 0);
                EXPECT_NEAR(direction.largest_motion(), direction.motion().rowwise().norm().maxCoeff(), 0);
            }
        }
    }
}

/// Tells how often another was prepared, and when it was given up.
class Observed final : public Preconditioner {
public:
    struct Log {
        int preparations = 0;
        bool is_given_up = false;
    };
    Observed(std::unique_ptr<Preconditioner> of, Log &log) : observed_(std::move(of)), log_(log) {}
    ~Observed() override { log_.is_given_up = true; }
    bool prepare(const Points &x, const Equilibrium &equilibrium, double floor) override {
        ++log_.preparations;
        return observed_->prepare(x, equilibrium, floor);
    }
    void apply(const Eigen::VectorXd &residual, Eigen::VectorXd &motion) override {
        observed_->apply(residual, motion);
    }

private:
    std::unique_ptr<Preconditioner> observed_;
    Log &log_;
};

TEST(NewtonDirection, KeepsMultigridNearEquilibrium) {
    const auto scene = Sheet{.cells = 16}.scene();
    const Points x = shape_of(scene);
    Observed::Log log;
    NewtonDirection direction(
        std::make_unique<Observed>(std::make_unique<Multigrid>(*scene, coarser_levels(*scene)), log));
    Equilibrium equilibrium(scene);
    for (const double away : {1e-4, 1e-5}) {
        equilibrium.evaluate(x * (1 + away));
        direction.compute(x * (1 + away), equilibrium, {});
        EXPECT_TRUE(direction.is_newton_step());
    }
    EXPECT_EQ(log.preparations, 1);
    EXPECT_FALSE(log.is_given_up);
}

TEST(NewtonDirection, PreparesMultigridAnewBeforeItIsGivenUp) {
    // As after Solver::replace: what was made for other members no longer serves, and is not to blame.
    for (const double times : {1e3, 0.3}) {
        const auto scene = Sheet{.cells = 16}.scene();
        Observed::Log log;
        NewtonDirection direction(
            std::make_unique<Observed>(std::make_unique<Multigrid>(*scene, coarser_levels(*scene)), log));
        for (const auto &now : {scene, Sheet{.cells = 16, .stiffness = times * 1e5}.scene()}) {
            const Points x = shape_of(now) * (1 + 1e-6);
            Equilibrium equilibrium(now);
            equilibrium.evaluate(x);
            direction.compute(x, equilibrium, {});
            EXPECT_TRUE(direction.is_newton_step());
        }
        EXPECT_FALSE(log.is_given_up) << "stiffness times " << times;
    }
}

} // namespace
} // namespace funicular::test
