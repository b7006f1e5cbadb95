// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "types.hpp"

#include <span>
#include <vector>

namespace funicular {

/// Area, corner angles and their derivatives of one panel at a time; the work space is kept between panels.
///
/// The area of a panel that is not plane is that of the fan of triangles between its edges and the mean of
/// its corners: it does not depend on where the corners' list starts, is exact for plane convex panels, and
/// never cancels when a panel warps.
class PanelGeometry {
public:
    /// Looks at a panel, which has at least three corners.
    void place(const Points &x, std::span<const Index> corners);

    [[nodiscard]] int corner_count() const { return static_cast<int>(corners_.size()); }
    [[nodiscard]] const Vector3 &corner(int k) const { return corners_[k]; }
    [[nodiscard]] const Vector3 &middle() const { return middle_; }
    [[nodiscard]] int after(int k) const { return k + 1 == corner_count() ? 0 : k + 1; }
    [[nodiscard]] int before(int k) const { return k == 0 ? corner_count() - 1 : k - 1; }

    [[nodiscard]] double area() const;
    /// Derivative of the area by each corner's position.
    void area_gradient(std::vector<Vector3> &gradient) const;

    /// Angle between the two edges at each corner, in [0, π]. It is that of the edges also where a panel
    /// points inwards: in a warped panel inwards and outwards are not told apart without a jump, and a load
    /// must not jump.
    void angles(std::vector<double> &angles) const;
    /// Derivatives of the angle at corner k by the positions of the corners before and after it; by the
    /// corner itself, minus their sum. Zero where an edge has no length.
    struct AngleGradient {
        Vector3 before, after;
    };
    [[nodiscard]] AngleGradient angle_gradient(int k) const;

private:
    /// Twice the area vector of the fan triangle on the edge from corner k.
    [[nodiscard]] Vector3 fan_normal(int k) const {
        return (corners_[k] - middle_).cross(corners_[after(k)] - middle_);
    }

    std::vector<Vector3> corners_;
    Vector3 middle_;
};

} // namespace funicular
