// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Nets and scenes that several tests build on.
#pragma once

#include "errors.hpp"
#include "lattice.hpp"
#include "scene.hpp"
#include "solve.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define FUNICULAR_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FUNICULAR_SANITIZED
#endif
#endif

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

/// A sheet of quads, `cells` each way, with both diagonals in every cell; panels are the cells.
NetPtr braced_sheet(double width, double depth, Index cells_u, Index cells_v);

/// What a scene is made of, for a test to change.
struct SceneParts {
    Points nodes;
    std::vector<Member> members;
    Panels panels;
    std::vector<Support> supports;
    std::vector<EffectDescription> effects;
    Eigen::VectorXd rest_lengths;

    [[nodiscard]] ScenePtr scene() const;
};
SceneParts parts_of(const Scene &scene);
/// The same scene with its nodes, members and panels in random order, members turned round at random and
/// panels begun at any corner; the lattice is forgotten. `number` becomes the new number of each node.
ScenePtr renumbered(const Scene &scene, unsigned seed, std::vector<Index> &number);

/// `full`, or `sanitized` where sanitizers make everything some twenty times slower.
constexpr Index sized([[maybe_unused]] Index full, [[maybe_unused]] Index sanitized) {
#ifdef FUNICULAR_SANITIZED
    return sanitized;
#else
    return full;
#endif
}

/// Solved to rounding.
Result solved(const ScenePtr &scene, Method method = Method::newton);
/// Largest distance between corresponding nodes.
double distance(const Points &a, const Points &b);

/// Converged, every number finite, and the certificate agrees to `tolerance`: residual, balance of forces
/// and of moments, supports.
void expect_certified(const ScenePtr &scene, const Result &result, double tolerance = 1e-9);
/// Solved to rounding and certified, and the same under three other numberings: to `agreed` of the net's
/// size.
Result solved_in_any_numbering(const ScenePtr &scene, double agreed = 1e-10);
/// No equilibrium, in any numbering, and a message with all of these words; the shape is finite.
void expect_no_equilibrium(const ScenePtr &scene, const std::vector<std::string> &words);
/// All of these words stand in the text.
void expect_words(const std::string &text, const std::vector<std::string> &words);

/// Runs `work`, which must throw InvalidInput with all of these words in its message.
void expect_invalid(const std::function<void()> &work, const std::vector<std::string> &words);

} // namespace funicular::test
