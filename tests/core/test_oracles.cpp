// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Shapes that are known in closed form or from an ordinary differential equation.
#include "scenes.hpp"

#include <cmath>
#include <numbers>

namespace funicular::test {

namespace {

double rise(const ScenePtr &scene) {
    const auto result = solved(scene);
    EXPECT_EQ(result.status, Status::converged) << result.message;
    return result.nodes.col(2).maxCoeff();
}

/// Values at h, h/2 and h/4 of a quantity with an error of even powers of h.
double extrapolated(double coarse, double middle, double fine) {
    const double first = (4 * middle - coarse) / 3;
    const double second = (4 * fine - middle) / 3;
    return (16 * second - first) / 15;
}

double observed_order(double coarse, double middle, double fine) {
    return std::log2((coarse - middle) / (middle - fine));
}

TEST(Oracle, InextensibleCatenaryIsTheLimitOfGreatStiffness) {
    const auto limit = [](double span, double rest) {
        const auto at_stiffness = [&](double ea) {
            return extrapolated(rise(catenary(40, span, rest, ea, 1)), rise(catenary(80, span, rest, ea, 1)),
                                rise(catenary(160, span, rest, ea, 1)));
        };
        // The error falls with 1 / EA.
        return 2 * at_stiffness(2e7) - at_stiffness(1e7);
    };
    EXPECT_NEAR(limit(10, 10.5), 1.393042066, 2e-9);
    EXPECT_NEAR(limit(10, 15), 5.026332616, 2e-9);
}

struct ElasticCatenary {
    double ea, sag;
};
class PaperLaw : public testing::TestWithParam<ElasticCatenary> {};

TEST_P(PaperLaw, ElasticCatenaryWithWeightOnItsPresentLength) {
    const auto [ea, sag] = GetParam();
    const double coarse = rise(catenary(80, 10, 12, ea, 1));
    const double middle = rise(catenary(160, 10, 12, ea, 1));
    const double fine = rise(catenary(320, 10, 12, ea, 1));
    EXPECT_NEAR(extrapolated(coarse, middle, fine), sag, 1e-9);
    EXPECT_NEAR(observed_order(coarse, middle, fine), 2, 0.01);
}
INSTANTIATE_TEST_SUITE_P(Stiffnesses, PaperLaw,
                         testing::Values(ElasticCatenary{10, 6.896612043}, ElasticCatenary{100, 3.428745739},
                                         ElasticCatenary{1000, 2.979343367}),
                         [](const auto &each) {
                             return "EA" + std::to_string(static_cast<int>(each.param.ea));
                         });

TEST(Oracle, ElasticCatenaryErrorsAreThoseOfTheDiscretisation) {
    EXPECT_NEAR(rise(catenary(10, 10, 12, 1000, 1)) - 2.979343367, 1.54e-2, 5e-5);
    EXPECT_NEAR(rise(catenary(80, 10, 12, 1000, 1)) - 2.979343367, 2.38e-4, 5e-7);
}

TEST(Oracle, EqualNodalLoadsOnSpringsOfNoRestLengthMakeAParabola) {
    constexpr Index n = 16;
    constexpr double load = 3;
    constexpr double force_density = 5;
    std::vector<Index> all;
    for (Index i = 0; i <= n; ++i)
        all.push_back(i);
    const auto scene = std::make_shared<const Scene>(
        straight_chain(n, 10), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, n}}},
        std::vector<EffectDescription>{
            AxialStiffness{Eigen::VectorXd::Constant(1, force_density), true, true},
            PointLoad{all, {0, 0, -load}}},
        Eigen::VectorXd::Zero(n));
    for (const Method method : {Method::newton, Method::relaxation}) {
        const auto result = solved(scene, method);
        ASSERT_EQ(result.status, Status::converged) << result.message;
        for (Index i = 0; i <= n; ++i)
            EXPECT_NEAR(result.nodes(i, 2), load * i * (n - i) / (2 * force_density), 1e-10);
    }
}

TEST(Oracle, StrandStretchesUnderTheWeightAboveEachMember) {
    EXPECT_NEAR(rise(strand(1, 10, 10, 1)), 20, 1e-6);
    EXPECT_NEAR(rise(strand(2, 10, 10, 1)), 17.777778, 5e-7);
    EXPECT_NEAR(rise(strand(5, 10, 10, 1)), 17.274128, 5e-7);
    EXPECT_NEAR(rise(strand(10, 10, 10, 1)), 17.205514, 2e-6);
    // l_i = (k r + w sum of l_j below) / (k - w / 2)
    constexpr Index n = 7;
    constexpr double k = 10.0 * n / 4;
    const auto result = solved(strand(n, 4, 10, 1));
    double above = 0;
    for (Index e = n - 1; e >= 0; --e) {
        const double length = (k * 4 / n + above) / (k - 0.5);
        EXPECT_NEAR(result.member_lengths[e], length, 1e-10);
        above += length;
    }
}

/// Ribs to an apex, without hoops, springs of no rest length: the thrust of each is the same everywhere.
ScenePtr rib_dome(Index ribs, Index bays, double radius, double covering, double thrust) {
    Points nodes(1 + ribs * bays, 3);
    std::vector<Member> members;
    Panels panels;
    Support base;
    const auto node = [bays](Index rib, Index ring) { return ring == 0 ? 0 : 1 + rib * bays + ring - 1; };
    nodes.row(0).setZero();
    for (Index rib = 0; rib < ribs; ++rib) {
        const Index next = (rib + 1) % ribs;
        const double azimuth = 2 * std::numbers::pi * rib / ribs;
        for (Index ring = 1; ring <= bays; ++ring) {
            const double r = radius * ring / bays;
            nodes.row(node(rib, ring)) << r * std::cos(azimuth), r * std::sin(azimuth), 0;
            members.push_back({node(rib, ring - 1), node(rib, ring)});
            std::vector<Index> corners{node(rib, ring - 1), node(rib, ring), node(next, ring)};
            if (ring > 1)
                corners.push_back(node(next, ring - 1));
            panels.add(corners);
        }
        base.nodes.push_back(node(rib, bays));
    }
    const double force_density = thrust / (radius / bays);
    const auto count = static_cast<Index>(members.size());
    return std::make_shared<const Scene>(
        std::make_shared<const Net>(nodes, members, panels), std::vector<Support>{base},
        std::vector<EffectDescription>{
            AxialStiffness{Eigen::VectorXd::Constant(1, force_density), true, true},
            CoveringWeight{covering / standard_gravity, CornerShare::equal}},
        Eigen::VectorXd::Zero(count));
}

TEST(Oracle, RibDomeWithFlatBaysUnderItsCovering) {
    const double coarse = rise(rib_dome(12, 80, 10, 1, 20));
    const double middle = rise(rib_dome(12, 160, 10, 1, 20));
    const double fine = rise(rib_dome(12, 320, 10, 1, 20));
    EXPECT_NEAR(observed_order(coarse, middle, fine), 2, 0.01);
    // The triangles at the apex add a term of third order.
    const double first = (4 * middle - coarse) / 3;
    const double second = (4 * fine - middle) / 3;
    EXPECT_NEAR((8 * second - first) / 7, 4.692433429, 1e-9);
}

/// Two strands side by side with panels, but no members, between them.
ScenePtr snowy_strip(Index n, double half_span, double snow, double weight, double thrust) {
    Points nodes(2 * (n + 1), 3);
    std::vector<Member> members;
    Panels panels;
    for (Index i = 0; i <= n; ++i)
        for (Index side = 0; side < 2; ++side) {
            nodes.row(2 * i + side) << half_span * (2.0 * i / n - 1), 2 * side, 0;
            if (i > 0)
                members.push_back({2 * (i - 1) + side, 2 * i + side});
            if (i > 0 && side > 0)
                panels.add(std::vector<Index>{2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
        }
    return std::make_shared<const Scene>(
        std::make_shared<const Net>(nodes, members, panels),
        std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, 1, 2 * n, 2 * n + 1}}},
        std::vector<EffectDescription>{
            AxialStiffness{Eigen::VectorXd::Constant(1, thrust * n / (2 * half_span)), true, true},
            MemberWeight{weight / standard_gravity}, Snow{snow}},
        Eigen::VectorXd::Zero(2 * n));
}

TEST(Oracle, SnowOnPlanWithSelfWeight) {
    EXPECT_NEAR(rise(snowy_strip(20, 5, 1, 0, 5)), 2.5, 1e-10)
        << "snow alone makes a parabola, exact at the nodes";
    const double coarse = rise(snowy_strip(40, 5, 1, 1, 10));
    const double middle = rise(snowy_strip(80, 5, 1, 1, 10));
    const double fine = rise(snowy_strip(160, 5, 1, 1, 10));
    EXPECT_NEAR(observed_order(coarse, middle, fine), 2, 0.01);
    EXPECT_NEAR(extrapolated(coarse, middle, fine), 2.601391873, 1e-9);
}

/// A sheet of 10 m under 0.5 kN/m of its members' present length, EA 100 kN.
double rise_of_sheet(Index cells, bool on_corners) {
    const auto net = flat_sheet(10, 10, 10.0 / cells);
    return rise(std::make_shared<const Scene>(
        net,
        std::vector<Support>{
            {.kind = SupportKind::fixed, .nodes = on_corners ? net->lattice()->corners() : net->border()}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e5)},
                                       MemberWeight{500 / standard_gravity}}));
}

TEST(Oracle, SheetsRiseAsAnotherCodeHasThem) {
    EXPECT_NEAR(rise_of_sheet(20, false), 1.486945, 5e-7);
    EXPECT_NEAR(rise_of_sheet(50, false), 1.487065, 5e-7);
    EXPECT_NEAR(rise_of_sheet(20, true), 5.529614, 5e-7);
    EXPECT_NEAR(rise_of_sheet(50, true), 5.887808, 5e-7);
}

} // namespace
} // namespace funicular::test
