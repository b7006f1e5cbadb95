// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Units and signs, stated once.
///
/// SI throughout: metre, kilogram, newton, second; up is +z.
///
/// The form is found in tension with gravity turned round: a member's pull T is positive when it is
/// stretched, and the loads point up. The structure that is built stands the same way up with every force
/// reversed. What leaves the core (member forces, reactions, point loads) is in the sense of the built
/// structure: N = -T, compression negative.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace funicular {

/// Number of a node, member or panel.
using Index = int;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
/// One row per node.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Standard acceleration of free fall [m/s²].
inline constexpr double standard_gravity = 9.80665;

} // namespace funicular
