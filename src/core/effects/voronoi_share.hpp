// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace funicular {

template <class Scalar>
using VoronoiPoint = std::array<Scalar, 3>;

namespace voronoi {

template <class Scalar>
using Point = VoronoiPoint<Scalar>;

inline double real(double value) {
    return value;
}
inline double real(const std::complex<double> &value) {
    return value.real();
}

// Written out because Eigen's dot and cross products conjugate complex numbers, which a complex step must
// not.
template <class Scalar>
Point<Scalar> difference(const Point<Scalar> &a, const Point<Scalar> &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Scalar>
Scalar dot(const Point<Scalar> &a, const Point<Scalar> &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Scalar>
Point<Scalar> cross(const Point<Scalar> &a, const Point<Scalar> &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// How much farther a point is from `own` than from `other`, as half the difference of the squared distances.
template <class Scalar>
Scalar farther(const Point<Scalar> &point, const Point<Scalar> &own, const Point<Scalar> &other) {
    Point<Scalar> middle;
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] = (own[axis] + other[axis]) * 0.5;
    return dot(difference(point, middle), difference(other, own));
}

/// Cuts off the part of a convex polygon that is nearer to `other` than to `own`.
template <class Scalar>
std::vector<Point<Scalar>> clip(const std::vector<Point<Scalar>> &polygon, const Point<Scalar> &own,
                                const Point<Scalar> &other) {
    std::vector<Point<Scalar>> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto &here = polygon[k];
        const auto &next = polygon[(k + 1) % polygon.size()];
        const Scalar at_here = farther(here, own, other);
        const Scalar at_next = farther(next, own, other);
        const bool keep_here = real(at_here) <= 0;
        if (keep_here)
            kept.push_back(here);
        if (keep_here != (real(at_next) <= 0)) {
            const Scalar part = at_here / (at_here - at_next);
            Point<Scalar> crossing;
            for (int axis = 0; axis < 3; ++axis)
                crossing[axis] = here[axis] + part * (next[axis] - here[axis]);
            kept.push_back(crossing);
        }
    }
    return kept;
}

} // namespace voronoi

/// The area of the panel's fan triangles (see PanelGeometry) that is nearer to each corner than to any other.
/// \tparam Scalar double, or std::complex<double> for a derivative by complex step
template <class Scalar>
std::vector<Scalar> voronoi_areas(const std::vector<VoronoiPoint<Scalar>> &corners) {
    using namespace voronoi;
    Point<Scalar> middle{};
    for (const auto &corner : corners)
        for (int axis = 0; axis < 3; ++axis)
            middle[axis] += corner[axis] / static_cast<double>(corners.size());

    std::vector<Scalar> areas(corners.size(), Scalar(0));
    for (std::size_t edge = 0; edge < corners.size(); ++edge) {
        const auto &from = corners[edge];
        const auto &to = corners[(edge + 1) % corners.size()];
        Point<Scalar> normal = cross(difference(from, middle), difference(to, middle));
        const Scalar doubled = std::sqrt(dot(normal, normal));
        if (real(doubled) == 0)
            continue;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            std::vector<Point<Scalar>> cell{middle, from, to};
            for (std::size_t other = 0; other < corners.size() && cell.size() >= 3; ++other)
                if (other != k)
                    cell = clip(cell, corners[k], corners[other]);
            for (std::size_t a = 1; a + 1 < cell.size(); ++a)
                areas[k] +=
                    dot(cross(difference(cell[a], cell[0]), difference(cell[a + 1], cell[0])), normal) /
                    doubled * 0.5;
        }
    }
    return areas;
}

} // namespace funicular
