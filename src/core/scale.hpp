// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "types.hpp"

#include <cmath>

namespace funicular {

/// The solver's own units: lengths of order one about the net's centre, forces of order one. The units are
/// powers of two, so that changing to them and back is exact, and millimetres or kilometres are solved alike.
struct Scale {
    Vector3 origin = Vector3::Zero(); ///< [m]
    double length = 1;                ///< [m]
    double force = 1;                 ///< [N]

    [[nodiscard]] Points to_local(const Points &nodes) const {
        return (nodes.rowwise() - origin.transpose()) / length;
    }
    [[nodiscard]] Points to_metres(const Points &local) const {
        return (local * length).rowwise() + origin.transpose();
    }
};

/// The power of two at or above a positive value.
[[nodiscard]] inline double power_of_two_above(double value) {
    return std::exp2(std::ceil(std::log2(value)));
}

} // namespace funicular
