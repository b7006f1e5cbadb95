// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Nets and scenes that several tests build on.
#pragma once

#include "errors.hpp"
#include "lattice.hpp"
#include "scene.hpp"
#include "solve.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace funicular::test {

using ScenePtr = std::shared_ptr<const Scene>;
using NetPtr = std::shared_ptr<const Net>;

/// Members between neighbours of a row of nodes.
NetPtr chain_net(const Points &nodes);
/// n equal members along x from 0 to `span`.
NetPtr straight_chain(Index n, double span);
/// The paper's catenary: ends fixed, rest lengths adding up to `rest`, weight w [N/m] on the present length.
ScenePtr catenary(Index n, double span, double rest, double ea, double weight);
/// Members standing on one another, held at the foot only.
ScenePtr strand(Index n, double length, double ea, double weight);
/// A hemisphere of meridians and hoops, apex welded, base ring fixed.
ScenePtr hemisphere(Index around, Index up, double radius, double ea, bool compression_only,
                    double member_weight, double covering_weight = 0);
/// A gently warped sheet of quads, held at its corners, with every effect there is.
ScenePtr warped_roof(bool compression_only = true);

/// Solved to rounding.
Result solved(const ScenePtr &scene, Method method = Method::newton);
/// Largest distance between corresponding nodes.
double distance(const Points &a, const Points &b);

/// Runs `work`, which must throw InvalidInput with all of these words in its message.
void expect_invalid(const std::function<void()> &work, const std::vector<std::string> &words);

} // namespace funicular::test
