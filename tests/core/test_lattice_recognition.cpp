// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Grids that do not say so.
#include "lattice_recognition.hpp"

#include "lattice_levels.hpp"
#include "scenes.hpp"

#include <algorithm>

namespace funicular::test {

namespace {

/// A sheet of 12 x 7 cells, warped so that no two corners stand alike.
NetPtr sheet() {
    const auto flat = flat_sheet(6, 3.5, 0.5);
    Points nodes = flat->nodes();
    nodes.col(2) = 0.1 * nodes.col(0).array() + 0.02 * nodes.col(1).array().square();
    return make_net(flat->lattice(), nodes);
}

/// A net's parts, to be changed before they are one again.
struct Parts {
    Points nodes;
    std::vector<Member> members;
    std::vector<std::vector<Index>> panels;

    explicit Parts(const Net &net) : nodes(net.nodes()), members(net.members()) {
        for (Index f = 0; f < net.panels().size(); ++f)
            panels.emplace_back(net.panels()[f].begin(), net.panels()[f].end());
    }
    [[nodiscard]] Net net() const {
        Panels laid;
        for (const auto &panel : panels)
            laid.add(panel);
        return {nodes, members, laid};
    }
};

/// The same net in another order, without its lattice.
NetPtr shuffled(const NetPtr &net, unsigned seed) {
    std::vector<Index> number;
    const std::vector<Support> held{{.kind = SupportKind::fixed, .nodes = {0, 1}}};
    const std::vector<EffectDescription> pull{
        AxialStiffness{.stiffness = Eigen::VectorXd::Constant(net->member_count(), 1e5)}};
    return renumbered(Scene(net, held, pull), seed, number)->shared_net();
}

Member sorted(Member member) {
    std::sort(member.begin(), member.end());
    return member;
}

} // namespace

TEST(RecognisedLattice, OfANetThatLostItsOwnIsThatOne) {
    const auto net = sheet();
    const auto found = recognised_lattice(Parts(*net).net());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->members(), net->lattice()->members());
    EXPECT_EQ(found->uv(), net->lattice()->uv());
    EXPECT_EQ(found->sides(), net->lattice()->sides());
    EXPECT_EQ(found->corners(), net->lattice()->corners());
}

TEST(RecognisedLattice, StandsInTheNumberingOfTheNet) {
    const auto net = sheet();
    for (const unsigned seed : {1U, 2U, 3U}) {
        const NetPtr shuffled_net = shuffled(net, seed);
        const Net &other = *shuffled_net;
        const auto found = recognised_lattice(other);
        ASSERT_TRUE(found);
        for (Index j = 0; j < net->lattice()->lines_v(); ++j)
            for (Index i = 0; i < net->lattice()->lines_u(); ++i)
                EXPECT_EQ(other.nodes().row(found->node_at(i, j)),
                          net->nodes().row(net->lattice()->node_at(i, j)));
        ASSERT_EQ(found->members().size(), other.members().size());
        for (std::size_t e = 0; e < other.members().size(); ++e)
            EXPECT_EQ(sorted(found->members()[e]), sorted(other.members()[e]));
        EXPECT_EQ(found->panels().size(), other.panels().size());
        // Every member is found where it stands.
        const LineMembers lines(*found);
        for (Index j = 0; j < found->lines_v(); ++j)
            for (Index i = 0; i + 1 < found->lines_u(); ++i)
                EXPECT_EQ(sorted(other.members()[lines.along_u(i, j)]),
                          sorted({found->node_at(i, j), found->node_at(i + 1, j)}));
        for (Index j = 0; j + 1 < found->lines_v(); ++j)
            for (Index i = 0; i < found->lines_u(); ++i)
                EXPECT_EQ(sorted(other.members()[lines.along_v(i, j)]),
                          sorted({found->node_at(i, j), found->node_at(i, j + 1)}));
    }
}

TEST(RecognisedLattice, OfAStripOfOneCellInAnyNumbering) {
    for (const auto &strip : {flat_sheet(10, 0.5, 0.5), flat_sheet(0.5, 10, 0.5)})
        for (const unsigned seed : {1U, 2U, 3U, 4U})
            EXPECT_TRUE(recognised_lattice(*shuffled(strip, seed)));
}

TEST(RecognisedLattice, DoesNotLookAtPanels) {
    Parts parts(*shuffled(sheet(), 4));
    parts.panels.erase(parts.panels.begin() + 20);
    EXPECT_TRUE(recognised_lattice(parts.net())) << "an opening";
    parts.panels.clear();
    EXPECT_TRUE(recognised_lattice(parts.net())) << "no panels";
}

TEST(RecognisedLattice, IsNoneOfWhatIsNearlyAGrid) {
    const Parts grid(*sheet());
    ASSERT_TRUE(recognised_lattice(grid.net()));

    Parts changed = grid;
    changed.members.erase(changed.members.begin() + 40);
    EXPECT_FALSE(recognised_lattice(changed.net())) << "a member less";

    changed = grid;
    changed.members.push_back({0, 14});
    EXPECT_FALSE(recognised_lattice(changed.net())) << "a diagonal at a corner";

    changed = grid;
    changed.members.push_back({30, 44});
    EXPECT_FALSE(recognised_lattice(changed.net())) << "a diagonal inside";

    changed = grid;
    for (auto &member : changed.members)
        if (member == Member{30, 31})
            member = {30, 44};
    EXPECT_FALSE(recognised_lattice(changed.net())) << "a member that is a diagonal instead";

    changed = grid;
    changed.nodes.conservativeResize(changed.nodes.rows() + 1, 3);
    changed.nodes.bottomRows(1) << 1, 1, 9;
    changed.members.push_back({5, static_cast<Index>(changed.nodes.rows()) - 1});
    EXPECT_FALSE(recognised_lattice(changed.net())) << "a member that sticks out";

    EXPECT_FALSE(recognised_lattice(hemisphere(12, 4, 5, 1e5, true, 100)->net())) << "a pole";
    EXPECT_FALSE(recognised_lattice(Net(Parts(*sheet()).nodes.topRows(4), {{0, 1}, {1, 2}, {2, 3}})))
        << "a chain";
}

TEST(RecognisedLattice, GivesABareNetTheShapeOfItsLattice) {
    const auto net = flat_sheet(10, 10, 10.0 / 24);
    const std::vector<EffectDescription> effects{
        AxialStiffness{.stiffness = Eigen::VectorXd::Constant(1, 1e5)}, MemberWeight{.per_length = 50},
        CoveringWeight{30}};
    const auto border = net->border();
    const auto with =
        solved(std::make_shared<const Scene>(
                   net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = border}}, effects),
               Method::automatic);

    const auto other = shuffled(net, 5);
    const auto scene = std::make_shared<const Scene>(
        other, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = other->border()}}, effects);
    EXPECT_FALSE(coarser_levels(*scene).empty());
    const auto without = solved(scene, Method::automatic);
    ASSERT_EQ(with.status, Status::converged) << with.message;
    ASSERT_EQ(without.status, Status::converged) << without.message;
    const auto lattice = recognised_lattice(*other);
    for (Index j = 0; j < 25; ++j)
        for (Index i = 0; i < 25; ++i)
            EXPECT_LT(
                (without.nodes.row(lattice->node_at(i, j)) - with.nodes.row(net->lattice()->node_at(i, j)))
                    .norm(),
                1e-9);
}

} // namespace funicular::test
