// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scenes.hpp"

namespace funicular::test {

namespace {

const std::vector<Support> ends{{.kind = SupportKind::fixed, .nodes = {0, 4}}};
EffectDescription axial() {
    return AxialStiffness{Eigen::VectorXd::Constant(1, 1000)};
}

TEST(Scene, LeavesOutEffectsOfNoWeight) {
    const Scene scene(flat_sheet(2, 2, 1), {{.kind = SupportKind::fixed, .nodes = {0}}},
                      {MemberWeight{0}, CoveringWeight{0}, Snow{0}, PointLoad{{}, {0, 0, 1}},
                       PointLoad{{1}, {0, 0, 0}}, axial()});
    EXPECT_EQ(scene.effects().size(), 1);
    EXPECT_EQ(scene.acting().size(), 1);
}

TEST(Scene, RefusesWhatContradictsTheNet) {
    const auto net = straight_chain(4, 4);
    expect_invalid([] { Scene(nullptr, ends, {axial()}); }, {"net is missing"});
    expect_invalid([&] { Scene(net, ends, {MemberWeight{1}}); }, {"AxialStiffness is missing"});
    expect_invalid([&] { Scene(net, ends, {axial(), axial()}); }, {"AxialStiffness is given twice"});
    expect_invalid([&] { Scene(net, {}, {axial()}); }, {"supports", "no support"});
    expect_invalid([&] { Scene(net, ends, {axial()}, Eigen::VectorXd::Ones(3)); },
                   {"rest_lengths", "3 values", "4 members"});
    Eigen::VectorXd rest = Eigen::VectorXd::Ones(4);
    rest[2] = -1;
    expect_invalid([&] { Scene(net, ends, {axial()}, rest); }, {"rest_lengths[2]"});
    rest[2] = std::nan("");
    expect_invalid([&] { Scene(net, ends, {axial()}, rest); }, {"rest_lengths[2]"});
}

TEST(Scene, ScaleIsExactBothWays) {
    const auto scene = warped_roof();
    const Points &nodes = scene->net().nodes();
    const Points local = scene->scale().to_local(nodes);
    EXPECT_LE(local.cwiseAbs().maxCoeff(), 1);
    EXPECT_GE(local.cwiseAbs().maxCoeff(), 0.1);
    EXPECT_LT(distance(scene->scale().to_metres(local), nodes), 1e-14);
}

} // namespace
} // namespace funicular::test
