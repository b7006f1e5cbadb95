// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/corner_areas.hpp"
#include "scenes.hpp"

#include <array>
#include <cmath>
#include <numeric>

namespace funicular::test {

namespace {

std::vector<double> shares(const Points &corners, CornerShare share) {
    std::vector<Index> ids(corners.rows());
    std::iota(ids.begin(), ids.end(), 0);
    CornerAreas areas(share);
    return areas.areas(corners, ids);
}

double sum(const std::vector<double> &values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

constexpr std::array every_share{CornerShare::angle, CornerShare::equal, CornerShare::voronoi};

TEST(PanelShares, OfTheThirtySixtyNinetyTriangle) {
    // Angles of 30, 60 and 90 degrees, in this order (the case that the paper's rule is best known by).
    const Points corners = (Points(3, 3) << 0, 0, 0, std::sqrt(3), 1, 0, std::sqrt(3), 0, 0).finished();
    const double area = std::sqrt(3) / 2;
    const auto by_angle = shares(corners, CornerShare::angle);
    EXPECT_NEAR(by_angle[0], area / 6, 1e-15);
    EXPECT_NEAR(by_angle[1], area / 3, 1e-15);
    EXPECT_NEAR(by_angle[2], area / 2, 1e-15);
    // The nearest areas of a right-angled triangle: its bisectors meet in the middle of the longest side.
    const auto by_distance = shares(corners, CornerShare::voronoi);
    EXPECT_NEAR(by_distance[0], area / 4, 1e-15);
    EXPECT_NEAR(by_distance[1], area / 4, 1e-15);
    EXPECT_NEAR(by_distance[2], area / 2, 1e-15);
}

TEST(PanelShares, OfASquareAreQuarters) {
    const Points corners = (Points(4, 3) << 0, 0, 5, 2, 0, 5, 2, 2, 5, 0, 2, 5).finished();
    for (const auto share : every_share)
        for (const double area : shares(corners, share))
            EXPECT_NEAR(area, 1, 1e-15);
}

TEST(PanelShares, AddUpToTheAreaOfWarpedPanels) {
    const Points corners =
        (Points(5, 3) << 0, 0, 0, 2, 0, 0.3, 3, 1, 0, 1.5, 2, -0.4, -0.2, 1, 0.1).finished();
    const double area = sum(shares(corners, CornerShare::equal));
    for (const auto share : every_share)
        EXPECT_NEAR(sum(shares(corners, share)), area, 1e-14 * area);
}

TEST(PanelShares, OfAnObtuseTriangleStayWithinIt) {
    const Points corners = (Points(3, 3) << 0, 0, 0, 4, 0, 0, 1, 0.5, 0).finished();
    const auto by_distance = shares(corners, CornerShare::voronoi);
    EXPECT_NEAR(sum(by_distance), 1, 1e-15);
    for (const double area : by_distance)
        EXPECT_GT(area, 0);
    EXPECT_GT(by_distance[2], 0.5);
}

TEST(PanelShares, DoNotJumpWhereAWarpedPanelTurnsInwards) {
    // A corner is pushed through the panel: at every step the parts move by as little as the corner does.
    std::vector<double> before;
    constexpr int steps = 400;
    for (int k = 0; k <= steps; ++k) {
        const double at = 3.0 * k / steps;
        const Points corners = (Points(4, 3) << 0, 0, 0, 4, 2, 0.5, 0, 4, -0.4, 3 - at, 2, 0.3).finished();
        const auto now = shares(corners, CornerShare::angle);
        for (std::size_t c = 0; c < before.size(); ++c)
            EXPECT_LT(std::abs(now[c] - before[c]), 10 * 3.0 / steps);
        before = now;
    }
}

TEST(PanelShares, DegeneratePanelsGiveNumbers) {
    const Points point = Points::Zero(4, 3);
    const Points needle = (Points(3, 3) << 0, 0, 0, 1, 0, 0, 2, 0, 0).finished();
    const Points folded = (Points(4, 3) << 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0).finished();
    for (const auto &corners : {point, needle, folded})
        for (const auto share : every_share) {
            std::vector<Index> ids(corners.rows());
            std::iota(ids.begin(), ids.end(), 0);
            CornerAreas areas(share);
            for (const double area : areas.areas(corners, ids))
                EXPECT_EQ(area, 0);
            for (const Vector3 &gradient : areas.gradients(corners, ids))
                EXPECT_TRUE(gradient.allFinite());
        }
}

} // namespace
} // namespace funicular::test
