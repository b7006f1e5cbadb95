// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coarsening.hpp"
#include "lattice_levels.hpp"
#include "scenes.hpp"

#include <cmath>
#include <map>
#include <numeric>

namespace funicular::test {

namespace {

std::shared_ptr<const Lattice> lattice(Index cells_u, Index cells_v, bool closed_u = false,
                                       bool closed_v = false, std::vector<Side> poles = {}) {
    LatticeRecipe recipe;
    recipe.cells_u = cells_u;
    recipe.cells_v = cells_v;
    recipe.closed_u = closed_u;
    recipe.closed_v = closed_v;
    recipe.poles = std::move(poles);
    return std::make_shared<const Lattice>(std::move(recipe));
}

/// Open and closed, even and odd, with a pole on each side and on two.
std::vector<std::shared_ptr<const Lattice>> many_lattices() {
    std::vector<std::shared_ptr<const Lattice>> lattices;
    for (const Index m : {4, 5, 8, 11, 16})
        for (const Index n : {1, 4, 7, 9, 12})
            lattices.push_back(lattice(m, n));
    for (const Index m : {8, 9, 11, 14})
        for (const Index n : {3, 4, 5, 8}) {
            lattices.push_back(lattice(m, n, true));
            lattices.push_back(lattice(n, m, false, true));
            lattices.push_back(lattice(m, n, true, false, {Side::v_max}));
            lattices.push_back(lattice(m, n, true, false, {Side::v_min, Side::v_max}));
            lattices.push_back(lattice(n, m, false, true, {Side::u_min}));
            lattices.push_back(lattice(m, n, false, false, {Side::u_min, Side::u_max}));
        }
    for (const Index m : {8, 13})
        lattices.push_back(lattice(m, 9, true, true));
    return lattices;
}

std::string name_of(const Lattice &lattice) {
    const auto &recipe = lattice.recipe();
    std::string name = std::to_string(recipe.cells_u) + (recipe.closed_u ? " closed x " : " x ") +
                       std::to_string(recipe.cells_v) + (recipe.closed_v ? " closed" : "");
    for (const Side pole : recipe.poles)
        name += " pole " + side_name(pole);
    return name;
}

/// A function of the place (i, j) on each node of an open lattice.
template <class Function>
Points on_lines(const Lattice &lattice, const Function &function) {
    Points values(lattice.uv().rows(), 3);
    for (Index j = 0; j < lattice.lines_v(); ++j)
        for (Index i = 0; i < lattice.lines_u(); ++i)
            values.row(lattice.node_at(i, j)) = function(i, j).transpose();
    return values;
}

/// What of a fine lattice the coarse one keeps.
Points kept(const Coarsening &coarsening, const Points &fine) {
    const auto &nodes = coarsening.fine_nodes();
    Points coarse(static_cast<Eigen::Index>(nodes.size()), 3);
    for (std::size_t k = 0; k < nodes.size(); ++k)
        coarse.row(static_cast<Index>(k)) = fine.row(nodes[k]);
    return coarse;
}

TEST(Coarsening, LeavesOutNoLinesOfSmallLattices) {
    EXPECT_FALSE(Coarsening::of(nullptr));
    EXPECT_FALSE(Coarsening::of(lattice(3, 3)));
    EXPECT_FALSE(Coarsening::of(lattice(7, 3, true)));
    const auto only_u = Coarsening::of(lattice(4, 3));
    ASSERT_TRUE(only_u);
    EXPECT_EQ(only_u->coarse()->recipe().cells_u, 2);
    EXPECT_EQ(only_u->coarse()->recipe().cells_v, 3);
    const auto odd = Coarsening::of(lattice(9, 5, true));
    ASSERT_TRUE(odd);
    EXPECT_EQ(odd->coarse()->recipe().cells_u, 5);
    EXPECT_EQ(odd->coarse()->recipe().cells_v, 3);
}

TEST(Coarsening, PartsOfParentsAddUpToOne) {
    for (const auto &fine : many_lattices()) {
        SCOPED_TRACE(name_of(*fine));
        const auto coarsening = Coarsening::of(fine);
        ASSERT_TRUE(coarsening);
        const auto coarse_count = static_cast<Index>(coarsening->coarse()->uv().rows());
        ASSERT_EQ(coarsening->fine_nodes().size(), static_cast<std::size_t>(coarse_count));
        for (Index node = 0; node < fine->uv().rows(); ++node) {
            double sum = 0;
            std::map<Index, int> times;
            for (const auto &[parent, part] : coarsening->parents(node)) {
                ASSERT_GE(parent, 0);
                ASSERT_LT(parent, coarse_count);
                EXPECT_GT(part, 0);
                EXPECT_EQ(++times[parent], 1) << "a parent twice of node " << node;
                sum += part;
            }
            EXPECT_DOUBLE_EQ(sum, 1) << "node " << node;
        }
        for (Index coarse = 0; coarse < coarse_count; ++coarse) {
            const auto parents = coarsening->parents(coarsening->fine_nodes()[coarse]);
            ASSERT_EQ(parents.size(), 1U);
            EXPECT_EQ(parents[0].node, coarse);
        }
    }
}

TEST(Coarsening, NodesLieInTheMiddleOfTheirParents) {
    for (const auto &fine : {lattice(8, 8), lattice(9, 6), lattice(4, 11), lattice(5, 3)}) {
        SCOPED_TRACE(name_of(*fine));
        const auto coarsening = Coarsening::of(fine);
        ASSERT_TRUE(coarsening);
        const Points places = on_lines(*fine, [](Index i, Index j) { return Vector3(i, j, 1); });
        for (Index node = 0; node < places.rows(); ++node) {
            Vector3 middle = Vector3::Zero();
            for (const auto &[parent, part] : coarsening->parents(node))
                middle += part * places.row(coarsening->fine_nodes()[parent]).transpose();
            EXPECT_EQ(middle, Vector3(places.row(node).transpose())) << "node " << node;
        }
    }
}

TEST(Coarsening, InterpolatesConstantsEverywhere) {
    for (const auto &fine : many_lattices()) {
        SCOPED_TRACE(name_of(*fine));
        const auto coarsening = Coarsening::of(fine);
        const Points same = Points::Constant(coarsening->coarse()->uv().rows(), 3, 7.25);
        Points found;
        coarsening->interpolate(same, found);
        ASSERT_EQ(found.rows(), fine->uv().rows());
        EXPECT_LT((found.array() - 7.25).abs().maxCoeff(), 1e-14);
    }
}

TEST(Coarsening, InterpolatesQuadraticsOnOpenLattices) {
    for (const auto &fine : {lattice(8, 8), lattice(6, 10), lattice(4, 4), lattice(5, 9), lattice(7, 12)}) {
        SCOPED_TRACE(name_of(*fine));
        const Points wanted = on_lines(*fine, [](double i, double j) {
            return Vector3(i * i - 3 * j, j * j + i * j, i * i * j * j - 2 * i + 1);
        });
        const auto coarsening = Coarsening::of(fine);
        Points found;
        coarsening->interpolate(kept(*coarsening, wanted), found);
        EXPECT_LT(distance(found, wanted), 1e-12 * wanted.cwiseAbs().maxCoeff());
    }
}

TEST(Coarsening, InterpolatesCubicsInside) {
    const Index cells = 12;
    const auto fine = lattice(cells, cells);
    const Points wanted = on_lines(
        *fine, [](double i, double j) { return Vector3(i * i * i - j * j * j, i * i * i * j * j * j, i); });
    const auto coarsening = Coarsening::of(fine);
    Points found;
    coarsening->interpolate(kept(*coarsening, wanted), found);
    const auto is_inside = [](Index line) { return line % 2 == 0 || (line >= 3 && line <= cells - 3); };
    for (Index j = 0; j <= cells; ++j)
        for (Index i = 0; i <= cells; ++i)
            if (const Index node = fine->node_at(i, j); is_inside(i) && is_inside(j)) {
                EXPECT_LT((found.row(node) - wanted.row(node)).norm(), 1e-9) << i << ", " << j;
            }
}

TEST(Coarsening, InterpolatesAcrossTheSeamAsAnywhere) {
    const auto fine = lattice(12, 4, true);
    const auto coarsening = Coarsening::of(fine);
    const auto &coarse = *coarsening->coarse();
    const Points values = Points::Random(coarse.uv().rows(), 3);
    Points turned(values.rows(), 3);
    for (Index j = 0; j < coarse.lines_v(); ++j)
        for (Index i = 0; i < coarse.lines_u(); ++i)
            turned.row(coarse.node_at((i + 1) % coarse.lines_u(), j)) = values.row(coarse.node_at(i, j));
    Points found;
    Points found_turned;
    coarsening->interpolate(values, found);
    coarsening->interpolate(turned, found_turned);
    for (Index j = 0; j < fine->lines_v(); ++j)
        for (Index i = 0; i < fine->lines_u(); ++i)
            EXPECT_LT(
                (found_turned.row(fine->node_at((i + 2) % 12, j)) - found.row(fine->node_at(i, j))).norm(),
                1e-14);
}

/// Of coarse members side by side across the lattice, and of the fine strands in their place.
struct Sums {
    double coarse = 0, fine = 0;
};

TEST(Coarsening, StiffnessOfParallelLinesIsKept) {
    for (const auto &fine : {lattice(8, 8), lattice(9, 6), lattice(5, 11), lattice(8, 5, true),
                             lattice(11, 4, true), lattice(9, 13, true, true)}) {
        SCOPED_TRACE(name_of(*fine));
        const auto coarsening = Coarsening::of(fine);
        const LineMembers fine_members(*fine);
        const LineMembers coarse_members(*coarsening->coarse());
        const auto count = static_cast<Index>(fine->members().size());
        const Eigen::VectorXd stiffness = 2 + Eigen::VectorXd::Random(count).array();
        Eigen::VectorXd coarse_stiffness = Eigen::VectorXd::Zero(coarsening->coarse()->members().size());
        for (const auto &[member, first, second, part] : coarsening->strands()) {
            ASSERT_TRUE(first >= 0 && first < count && second < count);
            coarse_stiffness[member] +=
                part * (second < 0 ? stiffness[first] : 1 / (1 / stiffness[first] + 1 / stiffness[second]));
        }
        const Index coarse_cells = coarsening->coarse()->recipe().cells_u;
        for (Index cell = 0; cell < coarse_cells; ++cell) {
            Sums sums;
            for (Index j = 0; j < coarsening->coarse()->lines_v(); ++j)
                sums.coarse += coarse_stiffness[coarse_members.along_u(cell, j)];
            for (Index j = 0; j < fine->lines_v(); ++j) {
                const double k = stiffness[fine_members.along_u(2 * cell, j)];
                const bool is_single = 2 * cell + 1 >= fine->recipe().cells_u;
                sums.fine +=
                    is_single ? k : 1 / (1 / k + 1 / stiffness[fine_members.along_u(2 * cell + 1, j)]);
            }
            EXPECT_NEAR(sums.coarse, sums.fine, 1e-12 * sums.fine) << "cell " << cell;
        }
    }
}

ScenePtr sheet_scene(const NetPtr &net, std::vector<Support> supports,
                     std::optional<Eigen::VectorXd> rest = std::nullopt) {
    return std::make_shared<const Scene>(
        net, std::move(supports),
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e5)}, MemberWeight{10}},
        std::move(rest));
}

TEST(LatticeLevels, RestLengthsAndLinesAddUp) {
    for (const double step : {0.5, 8.0 / 13}) {
        const auto net = flat_sheet(8, 8, step);
        const LineMembers members(*net->lattice());
        // A line along u is the same everywhere, but no two members of it are.
        const Index cells = net->lattice()->recipe().cells_u;
        Eigen::VectorXd rest = net->source_lengths();
        double along = 0;
        for (Index i = 0; i < cells; ++i) {
            const double length = 0.1 + 0.01 * i;
            along += length;
            for (Index j = 0; j <= cells; ++j)
                rest[members.along_u(i, j)] = length;
        }
        const auto scene =
            sheet_scene(net, {{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}}, rest);
        const auto levels = coarser_levels(*scene);
        ASSERT_GE(levels.size(), 3U);
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const auto &coarse = *levels[k].net->lattice();
            const LineMembers coarse_members(coarse);
            for (Index j = 0; j < coarse.lines_v(); ++j) {
                double whole = 0;
                for (Index i = 0; i < coarse.recipe().cells_u; ++i)
                    whole += levels[k].rest_lengths[coarse_members.along_u(i, j)];
                EXPECT_NEAR(whole, along, 1e-12 * along) << "level " << k << ", line " << j;
            }
            // The weight on the present length is that of the scene's own net.
            EXPECT_NEAR(levels[k].lines.dot(levels[k].net->source_lengths()), net->source_lengths().sum(),
                        1e-12 * net->source_lengths().sum());
            for (Index i = 0; i < coarse.recipe().cells_u; ++i) {
                double lines = 0;
                for (Index j = 0; j < coarse.lines_v(); ++j)
                    lines += levels[k].lines[coarse_members.along_u(i, j)];
                EXPECT_NEAR(lines, cells + 1, 1e-12 * cells) << "level " << k << ", cell " << i;
            }
        }
    }
}

std::vector<Index> all_nodes(const Net &net) {
    std::vector<Index> nodes(net.node_count());
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
}

std::size_t places(const std::vector<Support> &supports) {
    std::size_t count = 0;
    for (const Support &support : supports)
        count += support.nodes.size();
    return count;
}

TEST(LatticeLevels, StiffnessOfYieldingSupportsIsPassedOnWhole) {
    const auto net = flat_sheet(8, 8, 1);
    const auto scene = sheet_scene(net, {{.kind = SupportKind::fixed, .nodes = {8}, .stiffness = 300},
                                         {.kind = SupportKind::on_line, .nodes = {0, 1, 17}, .stiffness = 7},
                                         {.kind = SupportKind::fixed, .nodes = {10}}});
    const auto levels = coarser_levels(*scene);
    ASSERT_GE(levels.size(), 2U);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        double fixed = 0;
        double on_line = 0;
        Index rigid = 0;
        for (const Support &support : levels[k].supports) {
            const auto count = static_cast<double>(support.nodes.size());
            if (std::isinf(support.stiffness))
                rigid += static_cast<Index>(support.nodes.size());
            else
                (support.kind == SupportKind::fixed ? fixed : on_line) += count * support.stiffness;
        }
        EXPECT_NEAR(fixed, 300, 1e-9);
        EXPECT_NEAR(on_line, 21, 1e-9);
        EXPECT_GE(rigid, 1);
    }
}

TEST(LatticeLevels, SupportsDoNotMultiplyFromNetToNet) {
    // Each node passes its support to up to four; a net on an elastic bed must not end with more of them than
    // nodes, however many levels there are.
    for (const double stiffness : {100.0, std::numeric_limits<double>::infinity()}) {
        const auto net = flat_sheet(32, 32, 1);
        const auto scene = sheet_scene(
            net, {{.kind = SupportKind::on_plane, .nodes = all_nodes(*net), .stiffness = stiffness}});
        const auto levels = coarser_levels(*scene);
        ASSERT_GE(levels.size(), 4U);
        for (std::size_t k = 0; k < levels.size(); ++k)
            EXPECT_LE(places(levels[k].supports), static_cast<std::size_t>(levels[k].net->node_count()))
                << "level " << k << " of " << levels[k].supports.size() << " supports";
    }
}

TEST(LatticeLevels, EndInANetOfFewNodesOrAreNone) {
    // A coil of four cells a turn: every fourth line lies on the first. The coarsest net is solved with a
    // dense factor, and must not be what was left of a large one.
    auto nodes = flat_sheet(64, 64, 1)->nodes();
    for (Index node = 0; node < nodes.rows(); ++node) {
        const auto quarter = static_cast<Index>(std::lround(nodes(node, 0))) % 4;
        nodes(node, 0) = quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
        nodes(node, 2) = quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
    }
    const auto net = make_net(lattice(64, 64), nodes);
    const auto scene = sheet_scene(net, {{.kind = SupportKind::fixed, .nodes = {0}}});
    const auto levels = coarser_levels(*scene);
    EXPECT_TRUE(levels.empty() || levels[levels.size() - 1].net->node_count() < 400)
        << levels[levels.size() - 1].net->node_count();
}

} // namespace
} // namespace funicular::test
