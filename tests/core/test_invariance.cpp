// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// What must not change the shape: place, direction, units, numbering, method.
#include "certificate.hpp"
#include "scenes.hpp"

#include <Eigen/Geometry>
#include <numeric>
#include <random>

namespace funicular::test {

namespace {

constexpr double agreed = 1e-10;

/// The roof of the tests, with its net, supports and effects changed by `change`.
struct Parts {
    Points nodes;
    std::vector<Member> members;
    Panels panels;
    std::vector<Support> supports;
    std::vector<EffectDescription> effects;

    [[nodiscard]] ScenePtr scene() const {
        return std::make_shared<const Scene>(std::make_shared<const Net>(nodes, members, panels), supports,
                                             effects);
    }
};

Parts roof() {
    const auto scene = warped_roof();
    Parts parts{scene->net().nodes(), scene->net().members(), scene->net().panels(), scene->supports(),
                scene->effects()};
    parts.supports.push_back({.kind = SupportKind::on_plane, .nodes = {1, 2, 3, 4}, .direction = {0, 1, 0}});
    parts.supports.push_back({.kind = SupportKind::on_line, .nodes = {30}, .direction = {0.2, 0.1, 1}});
    parts.supports.push_back({.kind = SupportKind::fixed, .nodes = {40}, .stiffness = 2000});
    return parts;
}

Result solved_well(const Parts &parts) {
    auto result = solved(parts.scene());
    EXPECT_EQ(result.status, Status::converged) << result.message;
    return result;
}

/// Turns and shifts everything in the scene that has a place or a direction.
Parts moved(Parts parts, const Matrix3 &turn, const Vector3 &shift) {
    parts.nodes = (parts.nodes * turn.transpose()).rowwise() + shift.transpose();
    for (auto &support : parts.supports)
        support.direction = turn * support.direction;
    for (auto &effect : parts.effects)
        if (auto *load = std::get_if<PointLoad>(&effect))
            load->force = turn * load->force;
    return parts;
}

TEST(Invariance, PlaceFarFromTheOrigin) {
    const auto here = solved_well(roof());
    const Vector3 shift(1e6, -1e6, 5e5);
    const auto there = solved_well(moved(roof(), Matrix3::Identity(), shift));
    // The given coordinates themselves are rounded to 1e-10 m there.
    EXPECT_LT(distance(there.nodes.rowwise() - shift.transpose(), here.nodes), 1e-8);
    EXPECT_LT((there.member_forces - here.member_forces).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Invariance, RotationAboutTheVertical) {
    const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3::UnitZ()).toRotationMatrix();
    const auto turned = solved_well(moved(roof(), turn, Vector3::Zero()));
    EXPECT_LT(distance(turned.nodes * turn, solved_well(roof()).nodes), agreed);
}

TEST(Invariance, Mirror) {
    const Matrix3 mirror = Vector3(-1, 1, 1).asDiagonal();
    const auto mirrored = solved_well(moved(roof(), mirror, Vector3::Zero()));
    EXPECT_LT(distance(mirrored.nodes * mirror, solved_well(roof()).nodes), agreed);
}

TEST(Invariance, MillimetresAndKilometres) {
    const auto reference = solved_well(roof());
    for (const double scale : {1e-3, 1e3, 1e-6}) {
        // EA / (wL s) and EA / (wA s²) stay, and so the shape does.
        Parts parts = roof();
        parts.nodes *= scale;
        for (auto &effect : parts.effects) {
            if (auto *members = std::get_if<MemberWeight>(&effect))
                members->per_length /= scale;
            if (auto *covering = std::get_if<CoveringWeight>(&effect))
                covering->per_area /= scale * scale;
            if (auto *snow = std::get_if<Snow>(&effect))
                snow->pressure /= scale * scale;
        }
        for (auto &support : parts.supports)
            support.stiffness /= scale;
        const auto scaled = solved_well(parts);
        EXPECT_LT(distance(scaled.nodes / scale, reference.nodes), agreed) << scale;
        EXPECT_NEAR(static_cast<double>(scaled.iterations), static_cast<double>(reference.iterations), 3)
            << scale;
    }
}

TEST(Invariance, Numbering) {
    const Parts parts = roof();
    std::vector<Index> number(parts.nodes.rows());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), std::mt19937(7));

    Parts renumbered = parts;
    for (Index i = 0; i < parts.nodes.rows(); ++i)
        renumbered.nodes.row(number[i]) = parts.nodes.row(i);
    for (auto &[i, j] : renumbered.members)
        std::tie(i, j) = std::pair(number[j], number[i]);
    std::reverse(renumbered.members.begin(), renumbered.members.end());
    renumbered.panels = {};
    for (Index f = 0; f < parts.panels.size(); ++f) {
        std::vector<Index> corners;
        for (const Index node : parts.panels[f])
            corners.push_back(number[node]);
        std::rotate(corners.begin(), corners.begin() + f % 4, corners.end());
        renumbered.panels.add(corners);
    }
    for (auto &support : renumbered.supports)
        for (Index &node : support.nodes)
            node = number[node];
    for (auto &effect : renumbered.effects)
        if (auto *load = std::get_if<PointLoad>(&effect))
            for (Index &node : load->nodes)
                node = number[node];

    const auto reference = solved_well(parts);
    const auto result = solved_well(renumbered);
    for (Index i = 0; i < parts.nodes.rows(); ++i)
        EXPECT_LT((result.nodes.row(number[i]) - reference.nodes.row(i)).norm(), agreed);
}

TEST(Invariance, StartShape) {
    const auto scene = roof().scene();
    const auto reference = solved(scene);
    SolveOptions options;
    options.tolerance = 1e-12;
    options.accuracy = 1e-12;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-3, 3);
    for (int k = 0; k < 5; ++k) {
        options.start = scene->net().nodes() +
                        Points::NullaryExpr(scene->net().node_count(), 3, [&] { return anywhere(random); });
        const auto result = solve(scene, options);
        ASSERT_EQ(result.status, Status::converged) << result.message;
        EXPECT_LT(distance(result.nodes, reference.nodes), agreed);
    }
}

class Methods : public testing::TestWithParam<const char *> {};

TEST_P(Methods, AgreeOnTheShape) {
    const std::string which = GetParam();
    ScenePtr scene;
    if (which == "roof")
        scene = roof().scene();
    else if (which == "two_way_roof")
        scene = warped_roof(false);
    else if (which == "catenary")
        scene = catenary(20, 10, 12, 100, 1);
    else if (which == "dome")
        scene = hemisphere(12, 6, 5, 2e5, true, 20, 30);
    const auto newton = solved(scene, Method::newton);
    const auto relaxation = solved(scene, Method::relaxation);
    ASSERT_EQ(newton.status, Status::converged) << newton.message;
    ASSERT_EQ(relaxation.status, Status::converged) << relaxation.message;
    EXPECT_EQ(newton.method, Method::newton);
    EXPECT_EQ(relaxation.method, Method::relaxation);
    EXPECT_LT(distance(newton.nodes, relaxation.nodes), 1e-8 * scene->net().size());
}
INSTANTIATE_TEST_SUITE_P(Scenes, Methods, testing::Values("roof", "two_way_roof", "catenary", "dome"),
                         [](const auto &each) { return each.param; });

TEST(Balance, ReactionsCarryTheWholeLoad) {
    for (const auto &scene : {roof().scene(), warped_roof(false), hemisphere(16, 8, 5, 1e6, true, 20, 30)}) {
        const auto result = solved(scene);
        const auto certificate = certify(*scene, result.centred_nodes, &result.reactions, 1e-9);
        EXPECT_LT(certificate.balance, 1e-10);
        EXPECT_LT(certificate.moment_balance, 1e-10);
        EXPECT_GT(certificate.reaction_sum.z(), 0) << "supports push up";
    }
}

} // namespace
} // namespace funicular::test
