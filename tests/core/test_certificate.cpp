// SPDX-License-Identifier: LGPL-2.1-or-later
#include "certificate.hpp"
#include "certificate_loads.hpp"
#include "equilibrium.hpp"
#include "scenes.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace funicular::test {

namespace {

Certificate certificate_of(const ScenePtr &scene, const Result &result) {
    return certify(*scene, result.centred_nodes, &result.reactions, 1e-9);
}

/// Angle from the apex, in degrees, of a member's middle in the source net.
double from_apex(const Net &net, Index member) {
    const Vector3 middle =
        (net.nodes().row(net.members()[member][0]) + net.nodes().row(net.members()[member][1])).transpose() /
        2;
    return std::atan2(middle.head<2>().norm(), middle.z()) * 180 / std::numbers::pi;
}

const std::vector<EffectDescription> &every_panel_load() {
    static const std::vector<EffectDescription> loads{CoveringWeight{30, CornerShare::angle},
                                                      CoveringWeight{30, CornerShare::equal},
                                                      CoveringWeight{30, CornerShare::voronoi}, Snow{700}};
    return loads;
}

/// Largest difference of the solver's and the certificate's loads [N], one effect alone.
double difference_of_loads(const NetPtr &net, const EffectDescription &load) {
    const auto scene = std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e5)}, load});
    const Points centred = net->nodes().rowwise() - net->centre().transpose();
    Equilibrium equilibrium(scene);
    equilibrium.evaluate(scene->scale().to_local(net->nodes()));
    return (equilibrium.loads() * scene->scale().force + certificate_loads(*net, scene->effects(), centred))
        .cwiseAbs()
        .maxCoeff();
}

bool is_hoop(const Net &net, Index member) {
    const auto [i, j] = net.members()[member];
    return std::abs(net.nodes()(i, 2) - net.nodes()(j, 2)) < 1e-9;
}

TEST(Certificate, FindsTheTensionInAHemisphereOfTwoWaySprings) {
    // Membrane theory: under self weight the hoops change sign at 51.83 degrees from the apex.
    const auto scene = hemisphere(48, 36, 10, 1e9, false, 0, 50);
    const auto result = solved(scene);
    ASSERT_EQ(result.status, Status::converged);
    const auto certificate = certificate_of(scene, result);
    EXPECT_TRUE(certificate.in_equilibrium);
    EXPECT_FALSE(certificate.compression_only);
    EXPECT_GT(certificate.worst_tension, 0);
    EXPECT_GT(certificate.tension_members.size(), 48 * 10);
    double highest = 90;
    for (const Index member : certificate.tension_members) {
        EXPECT_TRUE(is_hoop(scene->net(), member));
        highest = std::min(highest, from_apex(scene->net(), member));
    }
    EXPECT_NEAR(highest, 51.83, 2.5) << "to one ring of members";
    EXPECT_NE(certificate.summary().find("in tension"), std::string::npos);
}

TEST(Certificate, IsCleanForAHemisphereOfCompressionOnlyMembers) {
    const auto scene = hemisphere(48, 36, 10, 1e9, true, 0, 50);
    const auto result = solved(scene);
    ASSERT_EQ(result.status, Status::converged) << result.message;
    const auto certificate = certificate_of(scene, result);
    EXPECT_TRUE(certificate.compression_only);
    EXPECT_TRUE(certificate.tension_members.empty());
    EXPECT_EQ(certificate.worst_tension, 0);
    EXPECT_FALSE(certificate.slack_members.empty()) << "the lower hoops have nothing to carry";
    for (const Index member : certificate.slack_members)
        EXPECT_TRUE(is_hoop(scene->net(), member));
    EXPECT_NE(certificate.summary().find("Compression only; "), std::string::npos);
}

TEST(Certificate, SeesAShapeThatIsNotInEquilibrium) {
    const auto scene = warped_roof();
    auto result = solved(scene);
    EXPECT_TRUE(certificate_of(scene, result).compression_only);
    result.centred_nodes(20, 2) += 1e-4;
    const auto moved = certificate_of(scene, result);
    EXPECT_FALSE(moved.in_equilibrium);
    EXPECT_FALSE(moved.compression_only);
    EXPECT_GT(moved.max_residual, 1e-3);
    EXPECT_NE(moved.summary().find("Not in equilibrium"), std::string::npos);
}

TEST(Certificate, SeesReactionsThatDoNotBalance) {
    const auto scene = warped_roof();
    auto result = solved(scene);
    EXPECT_LT(certificate_of(scene, result).balance, 1e-11);
    result.reactions *= 1.001;
    EXPECT_NEAR(certificate_of(scene, result).balance, 1e-3, 1e-4);
}

TEST(Certificate, OneStiffMemberExcusesNoOtherNode) {
    auto stiffness = Eigen::VectorXd::Constant(10, 1e4).eval();
    stiffness[0] = 1e16;
    const Scene scene(straight_chain(10, 10), {{.kind = SupportKind::fixed, .nodes = {0, 10}}},
                      {AxialStiffness{stiffness}, MemberWeight{1}});
    const Points flat = scene.net().nodes().rowwise() - scene.net().centre().transpose();
    const auto certificate = certify(scene, flat, nullptr, 1e-6);
    EXPECT_FALSE(certificate.in_equilibrium);
    EXPECT_FALSE(certificate.compression_only);
    EXPECT_GT(certificate.max_residual, 0.5);
}

TEST(Certificate, SeesNodesOffTheirSupports) {
    const auto scene = warped_roof();
    auto result = solved(scene);
    Points lifted = result.centred_nodes;
    lifted.col(2).array() += 10;
    const auto certificate = certify(*scene, lifted, nullptr, 1e-9);
    EXPECT_FALSE(certificate.in_equilibrium);
    EXPECT_NEAR(certificate.support_error, 10, 1e-9);
    EXPECT_NE(certificate.summary().find("off its support"), std::string::npos);
}

TEST(Certificate, WhatIsNotANumberIsNoEquilibrium) {
    const auto scene = warped_roof();
    const Points wild = 1e200 * Points::Random(scene->net().node_count(), 3);
    const auto certificate = certify(*scene, wild, nullptr, 1e-6);
    EXPECT_FALSE(certificate.in_equilibrium);
    EXPECT_FALSE(certificate.compression_only);
    EXPECT_GT(certificate.max_residual, 1);
}

TEST(Certificate, ANetThatCarriesNothingIsNotCalledCompressed) {
    const Scene scene(flat_sheet(3, 3, 1), {{.kind = SupportKind::fixed, .nodes = {0, 3, 12, 15}}},
                      {AxialStiffness{Eigen::VectorXd::Constant(1, 1e4)}});
    const auto certificate =
        certify(scene, scene.net().nodes().rowwise() - scene.net().centre().transpose(), nullptr, 1e-6);
    EXPECT_TRUE(certificate.in_equilibrium);
    EXPECT_FALSE(certificate.compression_only);
    EXPECT_NE(certificate.summary().find("Nothing carries"), std::string::npos);
}

TEST(Certificate, RecomputesReactionsOfABareShape) {
    const auto scene = warped_roof();
    const auto result = solved(scene);
    const auto certificate = certify(*scene, result.centred_nodes, nullptr, 1e-9);
    EXPECT_TRUE(certificate.compression_only);
    EXPECT_LT(certificate.balance, 1e-10);
    expect_invalid([&] { (void)certify(*scene, result.centred_nodes.topRows(5), nullptr, 1e-9); },
                   {"5 nodes", "63"});
}

TEST(Certificate, CatchesAFalseEquilibriumInTheWrongSign) {
    // Two-way springs balance in a shape that hangs where the structure should stand: every member is a tie.
    const auto scene = std::make_shared<const Scene>(
        straight_chain(2, 2), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 2}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1000), false},
                                       PointLoad{{1}, {0, 0, -0.2}}},
        Eigen::VectorXd::Constant(2, 1.1));
    const auto standing = solved(scene);
    ASSERT_EQ(standing.status, Status::converged);
    EXPECT_TRUE(certificate_of(scene, standing).compression_only);

    // Hanging: 2 k (r - l) h / l = P, solved for the height of the middle node.
    double h = -0.4582;
    for (int k = 0; k < 50; ++k) {
        const double l = std::hypot(1, h);
        const double force = 2 * (1000 / 1.1) * (l - 1.1) * h / l - 0.2;
        const double slope = 2 * (1000 / 1.1) * (1 - 1.1 / l + 1.1 * h * h / (l * l * l));
        h -= force / slope;
    }
    Points hanging = scene->net().nodes();
    hanging(1, 2) = h;
    const auto certificate =
        certify(*scene, hanging.rowwise() - scene->net().centre().transpose(), nullptr, 1e-9);
    EXPECT_LT(h, -0.4);
    EXPECT_TRUE(certificate.in_equilibrium);
    EXPECT_EQ(certificate.tension_members.size(), 2);
    EXPECT_FALSE(certificate.compression_only);
}

TEST(Certificate, ItsLoadsAreTheSolversByOtherFormulas) {
    // Agreement of two codes that share nothing: each effect alone, each share, on a warped roof.
    const auto roof = warped_roof();
    const std::vector<EffectDescription> loads{
        MemberWeight{12},
        MemberWeight{12, Eigen::VectorXd::LinSpaced(roof->net().member_count(), 1, 7)},
        CoveringWeight{30, CornerShare::angle},
        CoveringWeight{30, CornerShare::equal},
        CoveringWeight{30, CornerShare::voronoi},
        PointLoad{{4, 9}, {1, 2, 3}},
        Snow{700}};
    for (const auto &load : loads) {
        const auto scene = std::make_shared<const Scene>(
            roof->shared_net(), roof->supports(),
            std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e5)}, load});
        const Points &nodes = scene->net().nodes();
        Equilibrium equilibrium(scene);
        equilibrium.evaluate(scene->scale().to_local(nodes));
        const Points expected = certificate_loads(scene->net(), scene->effects(), nodes);
        EXPECT_GT(expected.norm(), 1);
        EXPECT_LT((equilibrium.loads() * scene->scale().force + expected).norm(), 1e-12 * expected.norm())
            << load.index();
    }
}

TEST(Certificate, ItsPanelLoadsAreTheSolversOnPanelsOfAnyShape) {
    // Folded on themselves, seen from below, upright, without area, with corners that coincide.
    std::mt19937 random(4);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    std::uniform_int_distribution<int> on_grid(-1, 1);
    for (int trial = 0; trial < 600; ++trial) {
        const Index corners = 3 + trial % 4;
        // The last node stands apart, so that the members, all of them there, have lengths.
        Points nodes(corners + 1, 3);
        for (Index k = 0; k < corners; ++k)
            for (int axis = 0; axis < 3; ++axis)
                nodes(k, axis) = trial % 3 == 0 ? on_grid(random) : anywhere(random);
        if (trial % 5 == 0)
            nodes.col(1).setZero();
        if (trial % 7 == 0)
            nodes.col(2) = nodes.col(0);
        nodes.row(corners).setConstant(2);
        std::vector<Member> members;
        std::vector<Index> panel;
        for (Index k = 0; k < corners; ++k) {
            members.push_back({k, corners});
            panel.push_back(k);
        }
        Panels panels;
        panels.add(panel);
        const auto net = std::make_shared<const Net>(nodes, members, panels);
        bool has_edges = true;
        for (Index k = 0; k < corners; ++k)
            has_edges = has_edges && nodes.row(k) != nodes.row((k + 1) % corners);
        if (!has_edges)
            continue; // see below
        for (const auto &load : every_panel_load())
            EXPECT_LT(difference_of_loads(net, load), 1e-11)
                << "trial " << trial << ", effect " << load.index() << "\n"
                << nodes;
    }
}

TEST(Certificate, ItsAnglesAreTheSolversWhereNeighbouringCornersCoincide) {
    // An edge without length makes no angle, whichever way the one beside it runs.
    for (const double way : {1.0, -1.0}) {
        Points nodes(5, 3);
        nodes << 0, 0, 0, way, 0, 0, way, way, way, 0, 0, 0, 2, 2, 2;
        Panels panels;
        panels.add(std::vector<Index>{0, 1, 2, 3});
        const auto net =
            std::make_shared<const Net>(nodes, std::vector<Member>{{0, 4}, {1, 4}, {2, 4}, {3, 4}}, panels);
        EXPECT_LT(difference_of_loads(net, CoveringWeight{30, CornerShare::angle}), 1e-11) << way;
    }
}

TEST(Certificate, AStiffElasticSupportIsExcusedItsRounding) {
    // At half a kilometre from the centre, a unit in the last place of the position is a part of its load.
    for (const double stiffness : {1e8, 1e10, 1e11, 1e12}) {
        const auto scene = std::make_shared<const Scene>(
            straight_chain(6, 1000),
            std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 6}},
                                 {.kind = SupportKind::fixed, .nodes = {3}, .stiffness = stiffness}},
            std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e5)},
                                           MemberWeight{1}});
        const auto result = solved(scene);
        if (result.status == Status::converged) {
            EXPECT_TRUE(certificate_of(scene, result).in_equilibrium)
                << stiffness << ": " << certificate_of(scene, result).summary();
        }
    }
}

TEST(Certificate, ANetWithoutLoadsIsMeasuredByWhatPullCanBeTold) {
    const Scene scene(flat_sheet(3, 3, 1), {{.kind = SupportKind::fixed, .nodes = {0, 3, 12, 15}}},
                      {AxialStiffness{Eigen::VectorXd::Constant(1, 1e4), false}});
    Points nodes = scene.net().nodes().rowwise() - scene.net().centre().transpose();
    nodes *= 1 + 4e-16; // as far as a shape comes from its rest lengths by rounding
    const auto rounded = certify(scene, nodes, nullptr, 1e-6);
    EXPECT_TRUE(rounded.in_equilibrium) << rounded.summary();
    nodes(5, 0) += 1e-6;
    const auto pushed = certify(scene, nodes, nullptr, 1e-6);
    EXPECT_FALSE(pushed.in_equilibrium);
    EXPECT_GT(pushed.unexcused_residual, 0.1);
}

TEST(Certificate, MomentsOfAShapeFarLargerThanItsNetAreMeasuredByTheShape) {
    // A soft strand a hundred times as long as its net; the same residual at each end of it.
    const Scene scene(straight_chain(2, 1), {{.kind = SupportKind::fixed, .nodes = {0}}},
                      {AxialStiffness{Eigen::VectorXd::Constant(1, 0.1)}, PointLoad{{2}, {0, 0, -10}}});
    Points nodes(3, 3);
    nodes << -0.5, 0, 0, -0.5, 0, 50.5, -0.5, 0, 101;
    const auto exact = certify(scene, nodes, nullptr, 1e-4);
    EXPECT_TRUE(exact.in_equilibrium) << exact.summary();
    nodes(2, 0) += 101 * 0.8e-4;
    nodes(1, 0) += 50.5 * 0.8e-4;
    const auto leaning = certify(scene, nodes, nullptr, 1e-4);
    EXPECT_NEAR(leaning.max_residual, 1.6e-4, 0.2e-4) << "of the mean of a load on one of two nodes";
    EXPECT_LT(leaning.moment_balance, 1e-4);
}

} // namespace
} // namespace funicular::test
