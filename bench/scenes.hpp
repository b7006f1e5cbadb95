// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// The scenes that are measured.
///
/// S       flat square net of quads, 10 m, EA 100 kN, 0.5 kN/m on the members' present length, border fixed
/// S100    the same with a hundred times the stiffness
/// S_bare  S as nodes, members and panels, without the word that they are a lattice
/// S_gap   S_bare with one member in the middle left out, so that there is none
/// C       S held on its four corners only
/// D       hemispherical net of meridians and hoops, 10 m radius, EA 100 MN, 0.25 kN/m and a covering of
///         0.5 kN/m², base ring fixed
/// T       free-form roof of triangles over 10 m x 10 m, loads and stiffness as D, border fixed, no lattice
#pragma once

#include "scene.hpp"

#include <memory>
#include <string>

namespace funicular::bench {

using NetPtr = std::shared_ptr<const Net>;
using ScenePtr = std::shared_ptr<const Scene>;

/// The net of a named scene, with as nearly so many nodes as its kind of lattice allows.
/// \throws InvalidInput for a name that is not known.
[[nodiscard]] NetPtr make_net(const std::string &scene, Index node_count);

/// A named scene on its net.
/// \param weight_factor multiplies every weight
/// \throws InvalidInput for a name that is not known.
[[nodiscard]] ScenePtr make_scene(const std::string &scene, const NetPtr &net, double weight_factor = 1);

/// Height of the highest node above the lowest [m].
[[nodiscard]] double rise(const Points &nodes);

} // namespace funicular::bench
