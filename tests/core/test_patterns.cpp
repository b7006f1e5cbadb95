// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Every pattern on every way in which a face may close.
#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace funicular::test {

namespace {

using Edge = std::pair<Index, Index>;

Edge edge(Index a, Index b) {
    return std::minmax(a, b);
}

std::set<Edge> edges_of(const std::vector<Member> &members) {
    std::set<Edge> edges;
    for (const auto &[a, b] : members) {
        EXPECT_NE(a, b);
        EXPECT_TRUE(edges.insert(edge(a, b)).second) << "a member twice: " << a << ", " << b;
    }
    return edges;
}

struct Topology {
    const char *name;
    bool closed_u, closed_v;
    std::vector<Side> poles;
    int characteristic;
    std::size_t border_loops;
};

const Topology topologies[] = {
    {"sheet", false, false, {}, 1, 1},
    {"cylinder", true, false, {}, 0, 2},
    {"cylinder_other_way", false, true, {}, 0, 2},
    {"torus", true, true, {}, 0, 0},
    {"dome", true, false, {Side::v_max}, 1, 1},
    {"dome_from_above", true, false, {Side::v_min}, 1, 1},
    {"dome_other_way", false, true, {Side::u_min}, 1, 1},
    {"sphere", true, false, {Side::v_min, Side::v_max}, 2, 0},
    {"sphere_other_way", false, true, {Side::u_min, Side::u_max}, 2, 0},
    {"triangle", false, false, {Side::v_max}, 1, 1},
    {"triangle_other_way", false, false, {Side::u_max}, 1, 1},
    {"leaf", false, false, {Side::u_min, Side::u_max}, 1, 1},
};

bool is_ribs(const std::string &pattern) {
    return pattern == "ribs_u" || pattern == "ribs_v";
}

class Patterns : public testing::TestWithParam<std::string> {
protected:
    /// Calls `check` with lattices of odd and of even counts on every topology that the pattern can be laid
    /// on.
    template <class Check>
    void on_every_topology(const Check &check) const {
        for (const Topology &topology : topologies)
            for (const auto &[u, v] : {std::pair{6, 4}, std::pair{5, 3}, std::pair{3, 7}}) {
                LatticeRecipe recipe{pattern_from_name(GetParam()),
                                     u,
                                     v,
                                     topology.closed_u,
                                     topology.closed_v,
                                     topology.poles};
                SCOPED_TRACE(testing::Message() << topology.name << ' ' << u << " x " << v);
                if (is_ribs(GetParam()) && !topology.poles.empty() &&
                    (GetParam() == "ribs_u") == (topology.poles[0] >= Side::v_min)) {
                    expect_invalid([&] { Lattice{recipe}; }, {"pattern", "pole", "other direction"});
                    continue;
                }
                check(Lattice(recipe), topology);
            }
    }
};

std::map<Edge, int> panel_edges(const Lattice &lattice) {
    std::map<Edge, int> edges;
    for (Index f = 0; f < lattice.panels().size(); ++f) {
        const auto corners = lattice.panels()[f];
        for (std::size_t k = 0; k < corners.size(); ++k)
            ++edges[edge(corners[k], corners[(k + 1) % corners.size()])];
    }
    return edges;
}

TEST_P(Patterns, CloseAsTheFaceDoes) {
    on_every_topology([](const Lattice &lattice, const Topology &topology) {
        EXPECT_GE(lattice.uv().minCoeff(), 0);
        EXPECT_LE(lattice.uv().maxCoeff(), 1);
        const auto edges = panel_edges(lattice);
        EXPECT_EQ(lattice.uv().rows() - static_cast<Index>(edges.size()) + lattice.panels().size(),
                  topology.characteristic);
        std::map<Index, std::vector<Index>> border;
        for (const auto &[edge, panels] : edges) {
            EXPECT_LE(panels, 2);
            if (panels == 1) {
                border[edge.first].push_back(edge.second);
                border[edge.second].push_back(edge.first);
            }
        }
        std::set<Index> on_sides;
        for (const auto &[side, nodes] : lattice.sides())
            on_sides.insert(nodes.begin(), nodes.end());
        std::size_t loops = 0;
        while (!border.empty()) {
            ++loops;
            Index at = border.begin()->first;
            for (auto found = border.find(at); found != border.end(); found = border.find(at)) {
                ASSERT_EQ(found->second.size(), 2U);
                const auto [one, other] = std::pair{found->second[0], found->second[1]};
                border.erase(found);
                at = border.contains(one) ? one : other;
                // A pole at the end of two sides is on the border and on neither side.
                if (topology.poles.empty()) {
                    EXPECT_TRUE(on_sides.contains(one) && on_sides.contains(other));
                }
            }
        }
        EXPECT_EQ(loops, topology.border_loops);
    });
}

TEST_P(Patterns, LayEachMemberOnceAndPanelsBetweenThem) {
    on_every_topology([](const Lattice &lattice, const Topology &) {
        const auto members = edges_of(lattice.members());
        const auto edges = panel_edges(lattice);
        for (const auto &[edge, panels] : edges)
            EXPECT_TRUE(is_ribs(GetParam()) || members.contains(edge)) << edge.first << ", " << edge.second;
        for (const Edge &member : members)
            EXPECT_TRUE(GetParam() == "crossed" || edges.contains(member));
    });
}

TEST_P(Patterns, TurnAllPanelsTheSameWay) {
    on_every_topology([](const Lattice &lattice, const Topology &) {
        std::set<Edge> directed;
        for (Index f = 0; f < lattice.panels().size(); ++f) {
            const auto corners = lattice.panels()[f];
            for (std::size_t k = 0; k < corners.size(); ++k)
                EXPECT_TRUE(directed.insert({corners[k], corners[(k + 1) % corners.size()]}).second);
        }
    });
}

TEST_P(Patterns, HaveANameThatLeadsBack) {
    EXPECT_EQ(pattern_name(pattern_from_name(GetParam())), GetParam());
}

TEST_P(Patterns, CoverTheSheetOnce) {
    for (const auto &[u, v] : {std::pair{1, 1}, std::pair{1, 4}, std::pair{5, 3}, std::pair{6, 8}}) {
        const Lattice lattice({pattern_from_name(GetParam()), u, v, false, false, {}});
        double whole = 0;
        for (Index f = 0; f < lattice.panels().size(); ++f) {
            const auto corners = lattice.panels()[f];
            double area = 0;
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const auto a = lattice.uv().row(corners[k]);
                const auto b = lattice.uv().row(corners[(k + 1) % corners.size()]);
                area += (a[0] * b[1] - a[1] * b[0]) / 2;
            }
            EXPECT_GT(area, 0) << "panel " << f;
            whole += area;
        }
        EXPECT_NEAR(whole, 1, 1e-12);
        EXPECT_EQ(lattice.corners().size(), 4U);
        EXPECT_EQ(lattice.sides().size(), 4U);
    }
}

TEST_P(Patterns, HaveTheirValencesInside) {
    const std::map<std::string, std::set<int>> valences{
        {"quad", {4}},    {"diagonal", {6}},   {"other_diagonal", {6}}, {"alternating", {4, 8}},
        {"crossed", {8}}, {"centred", {4, 8}}, {"diagrid", {4}},        {"triangle", {6}},
        {"hexagon", {3}}, {"kagome", {4}},     {"ribs_u", {2}},         {"ribs_v", {2}},
        {"zigzag", {6}},  {"brick", {3}}};
    const Lattice lattice({pattern_from_name(GetParam()), 6, 8, false, false, {}});
    std::map<Index, int> valence;
    for (const auto &[a, b] : lattice.members()) {
        ++valence[a];
        ++valence[b];
    }
    for (const auto &[side, nodes] : lattice.sides())
        for (const Index node : nodes)
            valence.erase(node);
    std::set<int> found;
    for (const auto &[node, count] : valence)
        found.insert(count);
    EXPECT_EQ(found, valences.at(GetParam()));
}

TEST_P(Patterns, AreLaidOnASheetWithMembersOfTheStep) {
    // The sheet is a whole number of cells.
    const auto [along_u, along_v] = cell_extent(pattern_from_name(GetParam()));
    const auto net = flat_sheet(6 * along_u, 8 * along_v, 1, GetParam().c_str());
    EXPECT_EQ(net->lattice()->recipe().cells_u, 6);
    EXPECT_EQ(net->lattice()->recipe().cells_v, 8);
    const bool has_diagonals =
        std::set<std::string>{"diagonal", "other_diagonal", "alternating", "zigzag", "crossed", "centred"}
            .contains(GetParam());
    const std::vector<Index> border = net->border();
    const auto is_inside = [&border](Index node) {
        return !std::binary_search(border.begin(), border.end(), node);
    };
    for (Index e = 0; e < net->member_count(); ++e) {
        const auto [a, b] = net->members()[e];
        const double dx = std::abs(net->nodes()(a, 0) - net->nodes()(b, 0));
        const double dy = std::abs(net->nodes()(a, 1) - net->nodes()(b, 1));
        if (has_diagonals && dx > 1e-9 && dy > 1e-9)
            continue;
        if (is_inside(a) && is_inside(b)) {
            EXPECT_NEAR(net->source_lengths()[e], 1, 1e-9);
        }
    }
}

TEST_P(Patterns, AreSolvedToACleanCertificate) {
    const auto net = flat_sheet(6, 5, 0.5, GetParam().c_str());
    const auto scene = std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->border()}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e5)}, MemberWeight{10},
                                       CoveringWeight{30}});
    const auto result = solved(scene, Method::automatic);
    ASSERT_EQ(result.status, Status::converged) << result.message;
    expect_certified(scene, result);
}

INSTANTIATE_TEST_SUITE_P(All, Patterns, testing::ValuesIn(pattern_names()),
                         [](const auto &each) { return each.param; });

TEST(Pattern, RepeatsWholeInAClosedDirection) {
    EXPECT_EQ(Lattice({Pattern::triangle, 5, 5, true, true, {}}).recipe().cells_v, 6);
    EXPECT_EQ(Lattice({Pattern::triangle, 5, 5, true, true, {}}).recipe().cells_u, 5);
    EXPECT_EQ(Lattice({Pattern::alternating, 5, 4, true, false, {}}).recipe().cells_u, 6);
    EXPECT_EQ(Lattice({Pattern::kagome, 5, 5, false, false, {}}).recipe().cells_v, 5);
    EXPECT_EQ(Lattice({Pattern::brick, 5, 5, false, true, {}}).recipe().cells_v, 6);
    EXPECT_EQ(Lattice({Pattern::zigzag, 5, 5, false, true, {}}).recipe().cells_v, 6);
}

TEST(Pattern, IsNamedInTheListOfThoseThereAre) {
    expect_invalid([] { (void)pattern_from_name("spiral"); }, {"spiral", "quad", "kagome", "ribs_v"});
}

} // namespace
} // namespace funicular::test
