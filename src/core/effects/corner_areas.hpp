// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "effects/panel_geometry.hpp"
#include "scene_parts.hpp"

#include <span>
#include <vector>

namespace funicular {

/// How much of a panel's area each corner carries, one panel at a time; the parts add up to the area.
class CornerAreas {
public:
    explicit CornerAreas(CornerShare share) : share_(share) {}

    /// One area for each corner, valid until the next call.
    const std::vector<double> &areas(const Points &x, std::span<const Index> corners);
    /// Derivative of the area of corner k by the position of corner m, at k * (number of corners) + m.
    const std::vector<Vector3> &gradients(const Points &x, std::span<const Index> corners);

private:
    void angle_gradients();
    void voronoi_gradients();

    CornerShare share_;
    PanelGeometry panel_;
    std::vector<double> areas_, angles_;
    std::vector<Vector3> gradients_, area_gradient_;
};

} // namespace funicular
