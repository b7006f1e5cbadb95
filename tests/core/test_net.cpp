// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scenes.hpp"

#include <limits>

namespace funicular::test {

namespace {

const Points triangle = (Points(3, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0).finished();
const std::vector<Member> round_triangle{{0, 1}, {1, 2}, {2, 0}};

Panels panels(std::vector<std::vector<Index>> all) {
    Panels result;
    for (const auto &corners : all)
        result.add(corners);
    return result;
}

TEST(Net, KeepsWhatItIsGiven) {
    const Net net(triangle, round_triangle, panels({{0, 1, 2}}));
    EXPECT_EQ(net.node_count(), 3);
    EXPECT_EQ(net.member_count(), 3);
    EXPECT_EQ(net.panels().size(), 1);
    EXPECT_DOUBLE_EQ(net.source_lengths()[1], std::sqrt(2));
    EXPECT_DOUBLE_EQ(net.size(), std::sqrt(2));
    EXPECT_EQ(net.border(), (std::vector<Index>{0, 1, 2}));
}

TEST(Net, BorderLeavesOutEdgesBetweenTwoPanels) {
    const auto sheet = flat_sheet(3, 2, 1);
    EXPECT_EQ(sheet->border(), (std::vector<Index>{0, 1, 2, 3, 4, 7, 8, 9, 10, 11}));
}

TEST(Net, NamesTheFirstOffendingIndex) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    Points broken = triangle;
    broken(1, 2) = nan;
    expect_invalid([&] { Net(broken, round_triangle); }, {"nodes[1]", "finite"});
    broken(1, 2) = infinite;
    expect_invalid([&] { Net(broken, round_triangle); }, {"nodes[1]", "finite"});
    expect_invalid([] { Net(Points(0, 3), {}); }, {"nodes is empty"});
    expect_invalid([] { Net(triangle, {}); }, {"members is empty"});
    expect_invalid([] { Net(triangle.topRows(1), {{0, 1}}); }, {"members[0]", "node 1"});
    expect_invalid([] { Net(triangle, {{0, 1}, {1, 3}}); }, {"members[1]", "node 3", "0 to 2"});
    expect_invalid([] { Net(triangle, {{0, 1}, {-1, 2}}); }, {"members[1]", "node -1"});
    expect_invalid([] { Net(triangle, {{0, 1}, {2, 2}}); }, {"members[1]", "itself"});
    expect_invalid([] { Net(triangle, {{0, 1}, {1, 2}, {1, 0}}); }, {"members[2]", "members[0]"});
    expect_invalid(
        [] {
            Net(triangle, round_triangle, panels({{0, 1, 2}, {0, 1}}));
        },
        {"panels[1]", "three"});
    expect_invalid([] { Net(triangle, round_triangle, panels({{0, 1, 7}})); }, {"panels[0]", "node 7"});
    expect_invalid(
        [] {
            Net(triangle, round_triangle, panels({{0, 1, 2, 1}}));
        },
        {"panels[0]", "node 1", "twice"});
    broken = triangle;
    broken.row(2) = broken.row(0);
    expect_invalid([&] { Net(broken, round_triangle); }, {"members[2]", "nodes 2 and 0", "coincide"});
}

TEST(Net, FlatSheetRoundsTheStepToWholeCells) {
    const auto sheet = flat_sheet(8, 6, 0.55);
    EXPECT_EQ(sheet->lattice()->recipe().cells_u, 15);
    EXPECT_EQ(sheet->lattice()->recipe().cells_v, 11);
    EXPECT_DOUBLE_EQ(sheet->nodes().col(0).maxCoeff(), 8);
    EXPECT_DOUBLE_EQ(sheet->nodes().col(1).maxCoeff(), 6);
    EXPECT_DOUBLE_EQ(sheet->nodes().col(2).cwiseAbs().maxCoeff(), 0);
    expect_invalid([] { (void)flat_sheet(8, 6, 0); }, {"step", "positive"});
    expect_invalid([] { (void)flat_sheet(8, 6, 7); }, {"step", "larger than depth"});
    expect_invalid([] { (void)flat_sheet(-8, 6, 1); }, {"width", "positive"});
    expect_invalid([] { (void)flat_sheet(8, 6, 1e-9); }, {"step", "too small"});
    expect_invalid([] { (void)flat_sheet(8, 6, 1, "penrose"); }, {"pattern", "penrose", "quad"});
}

} // namespace
} // namespace funicular::test
