// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solve.hpp"

#include <memory>
#include <vector>

namespace funicular {

/// The scene with rest lengths r ← r L / l', L a member's length in the source net and l' in the result
/// (paper section 4.2; its equation (1) is meant so: l'² / L, the other reading, diverges).
///
/// \throws InvalidInput if the result is not one of this scene's net, or a member has shrunk to nothing
[[nodiscard]] std::shared_ptr<const Scene> match_lengths(const Scene &scene, const Result &result);

/// Root mean square over the members of (l' - L) / L.
[[nodiscard]] double length_deviation(const Scene &scene, const Result &result);

/// The best of several rounds of solving and matching.
struct LengthMatching {
    std::shared_ptr<const Scene> scene;
    Result result;
    /// Root mean square relative deviation after each round that converged; the first is without matching.
    std::vector<double> deviations;
    Index best_round = 0;
    /// How the last round ended: other than converged, matching was cut short, and `result` is the best
    /// before.
    Status status = Status::iteration_limit;
    /// Further rounds did not lower the deviation: the best that matching reaches was reached.
    bool stopped_improving = false;
};

/// Solves and matches `rounds` times, each from the shape before. Matching need not converge: it gets nearer
/// for some rounds and then drifts, so the best is kept, and it ends when three rounds in a row have brought
/// nothing. A round that ends without equilibrium ends the matching; if it is the first one, that result is
/// returned. /// The time limit is for all rounds together.
/// \throws InvalidInput for a negative number of rounds
[[nodiscard]] LengthMatching solve_matching_lengths(std::shared_ptr<const Scene> scene, Index rounds,
                                                    SolveOptions options = {});

} // namespace funicular
