// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/panel_geometry.hpp"

#include <cmath>

namespace funicular {

void PanelGeometry::place(const Points &x, std::span<const Index> corners) {
    corners_.resize(corners.size());
    middle_.setZero();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        corners_[k] = x.row(corners[k]).transpose();
        middle_ += corners_[k];
    }
    middle_ /= static_cast<double>(corners.size());
}

double PanelGeometry::area() const {
    double doubled = 0;
    for (int k = 0; k < corner_count(); ++k)
        doubled += fan_normal(k).norm();
    return doubled / 2;
}

void PanelGeometry::area_gradient(std::vector<Vector3> &gradient) const {
    gradient.assign(corner_count(), Vector3::Zero());
    Vector3 by_middle = Vector3::Zero();
    for (int k = 0; k < corner_count(); ++k) {
        const Vector3 normal = fan_normal(k);
        const double doubled = normal.norm();
        if (doubled == 0)
            continue;
        // d |a x b| / 2 = (b x n̂) · da / 2 + (n̂ x a) · db / 2, a and b from the middle to the edge's ends
        const Vector3 by_a = (corners_[after(k)] - middle_).cross(normal) / (2 * doubled);
        const Vector3 by_b = normal.cross(corners_[k] - middle_) / (2 * doubled);
        gradient[k] += by_a;
        gradient[after(k)] += by_b;
        by_middle -= by_a + by_b;
    }
    for (Vector3 &by_corner : gradient)
        by_corner += by_middle / corner_count();
}

void PanelGeometry::angles(std::vector<double> &angles) const {
    angles.resize(corner_count());
    for (int k = 0; k < corner_count(); ++k) {
        const Vector3 a = corners_[after(k)] - corners_[k];
        const Vector3 b = corners_[before(k)] - corners_[k];
        // An edge without length makes no angle; adding zero takes away the sign of a product that is -0.
        angles[k] = std::atan2(a.cross(b).norm(), a.dot(b) + 0.0);
    }
}

PanelGeometry::AngleGradient PanelGeometry::angle_gradient(int k) const {
    const Vector3 a = corners_[after(k)] - corners_[k];
    const Vector3 b = corners_[before(k)] - corners_[k];
    const Vector3 turn = a.cross(b);
    const double doubled = turn.norm();
    if (doubled == 0)
        return {Vector3::Zero(), Vector3::Zero()};
    // Turning an edge away from the other opens the angle by (way / length of the edge).
    const Vector3 axis = turn / doubled;
    return {.before = axis.cross(b) / b.squaredNorm(), .after = a.cross(axis) / a.squaredNorm()};
}

} // namespace funicular
