// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scenes.hpp"

#include <algorithm>
#include <set>

namespace funicular::test {

namespace {

int euler_characteristic(const Lattice &lattice) {
    return static_cast<int>(lattice.uv().rows()) - static_cast<int>(lattice.members().size()) +
           lattice.panels().size();
}

std::set<std::pair<Index, Index>> distinct_edges(const std::vector<Member> &members) {
    std::set<std::pair<Index, Index>> edges;
    for (const auto &[i, j] : members) {
        EXPECT_NE(i, j);
        edges.insert(std::minmax(i, j));
    }
    return edges;
}

struct Shape {
    const char *name;
    LatticeRecipe recipe;
    Index nodes, members, panels;
    int characteristic;
    std::size_t corners, sides;
};

class QuadLattice : public testing::TestWithParam<Shape> {};

TEST_P(QuadLattice, HasTheCountsOfItsTopology) {
    const Shape &shape = GetParam();
    const Lattice lattice(shape.recipe);
    EXPECT_EQ(lattice.uv().rows(), shape.nodes);
    EXPECT_EQ(static_cast<Index>(lattice.members().size()), shape.members);
    EXPECT_EQ(lattice.panels().size(), shape.panels);
    EXPECT_EQ(euler_characteristic(lattice), shape.characteristic);
    EXPECT_EQ(distinct_edges(lattice.members()).size(), lattice.members().size());
    EXPECT_EQ(lattice.corners().size(), shape.corners);
    EXPECT_EQ(lattice.sides().size(), shape.sides);
    EXPECT_GE(lattice.uv().minCoeff(), 0);
    EXPECT_LE(lattice.uv().maxCoeff(), 1);
}

TEST_P(QuadLattice, EveryPanelEdgeIsAMemberOfTwoPanelsAtMostRunInOppositeSenses) {
    const Lattice lattice(GetParam().recipe);
    const auto edges = distinct_edges(lattice.members());
    std::set<std::pair<Index, Index>> directed;
    for (Index f = 0; f < lattice.panels().size(); ++f) {
        const auto corners = lattice.panels()[f];
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Index from = corners[k];
            const Index to = corners[(k + 1) % corners.size()];
            EXPECT_TRUE(edges.contains(std::minmax(from, to)));
            EXPECT_TRUE(directed.insert({from, to}).second)
                << "panels disagree on which side is up at " << from;
        }
    }
}

LatticeRecipe recipe(Index u, Index v, bool closed_u = false, bool closed_v = false,
                     std::vector<Side> poles = {}) {
    return {Pattern::quad, u, v, closed_u, closed_v, std::move(poles)};
}

INSTANTIATE_TEST_SUITE_P(
    Topologies, QuadLattice,
    testing::Values(Shape{"sheet", recipe(4, 3), 20, 31, 12, 1, 4, 4},
                    Shape{"one_cell", recipe(1, 1), 4, 4, 1, 1, 4, 4},
                    Shape{"cylinder", recipe(5, 3, true), 20, 35, 15, 0, 0, 2},
                    Shape{"cylinder_other_way", recipe(3, 5, false, true), 20, 35, 15, 0, 0, 2},
                    Shape{"torus", recipe(5, 4, true, true), 20, 40, 20, 0, 0, 0},
                    Shape{"dome", recipe(6, 3, true, false, {Side::v_max}), 19, 36, 18, 1, 0, 1},
                    Shape{"dome_other_way", recipe(3, 6, false, true, {Side::u_min}), 19, 36, 18, 1, 0, 1},
                    Shape{"sphere", recipe(6, 3, true, false, {Side::v_min, Side::v_max}), 14, 30, 18, 2, 0,
                          0},
                    Shape{"triangle", recipe(4, 3, false, false, {Side::v_max}), 16, 27, 12, 1, 3, 3}),
    [](const auto &each) { return each.param.name; });

TEST(Lattice, RefusesWhatCannotBeLaid) {
    expect_invalid([] { Lattice(recipe(0, 3)); }, {"cells_u", "at least 1"});
    expect_invalid([] { Lattice(recipe(3, 2, false, true)); }, {"cells_v", "at least 3", "closed"});
    expect_invalid(
        [] {
            Lattice(recipe(3, 1, true, false, {Side::v_min, Side::v_max}));
        },
        {"cells_v", "at least 2"});
    expect_invalid([] { Lattice(recipe(3, 3, true, false, {Side::u_min})); },
                   {"poles", "closed direction u"});
    expect_invalid([] { Lattice(recipe(3, 3, false, false, {Side::u_min, Side::v_min})); }, {"poles"});
    expect_invalid([] { Lattice(recipe(max_lattice_cells + 1, 3)); }, {"cells_u", "larger step"});
    expect_invalid([] { (void)side_from_name("left"); }, {"left", "u_min"});
}

TEST(Lattice, NetNeedsAPositionForEachNode) {
    const auto lattice = std::make_shared<const Lattice>(recipe(2, 2));
    expect_invalid([&] { (void)make_net(lattice, Points::Zero(8, 3)); }, {"nodes has 8 rows", "9 nodes"});
}

} // namespace
} // namespace funicular::test
