// SPDX-License-Identifier: LGPL-2.1-or-later
#include "length_matching.hpp"

#include "errors.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace funicular {

namespace {

constexpr int patience = 3;

void check_same_net(const Scene &scene, const Result &result) {
    if (result.member_lengths.size() != scene.net().member_count())
        throw InvalidInput("result has " + std::to_string(result.member_lengths.size()) +
                           " members, but the scene's net has " + std::to_string(scene.net().member_count()));
}

} // namespace

std::shared_ptr<const Scene> match_lengths(const Scene &scene, const Result &result) {
    check_same_net(scene, result);
    for (Index e = 0; e < result.member_lengths.size(); ++e)
        if (!(result.member_lengths[e] > 0))
            throw InvalidInput("result: member " + std::to_string(e) +
                               " has shrunk to no length; its rest length cannot be matched");
    const Eigen::VectorXd matched =
        scene.rest_lengths().array() * scene.net().source_lengths().array() / result.member_lengths.array();
    return std::make_shared<const Scene>(scene.with_rest_lengths(matched));
}

double length_deviation(const Scene &scene, const Result &result) {
    check_same_net(scene, result);
    return std::sqrt(
        (result.member_lengths.array() / scene.net().source_lengths().array() - 1).square().mean());
}

LengthMatching solve_matching_lengths(std::shared_ptr<const Scene> scene, Index rounds,
                                      SolveOptions options) {
    if (rounds < 0)
        throw InvalidInput("rounds must be zero or positive");
    LengthMatching best;
    best.scene = scene;
    best.result = solve(scene, options);
    best.status = best.result.status;
    if (best.status != Status::converged)
        return best;
    best.deviations.push_back(length_deviation(*scene, best.result));

    Result latest = best.result;
    double lowest = best.deviations.front();
    for (Index round = 1; round <= rounds; ++round) {
        scene = match_lengths(*scene, latest);
        options.start = latest.nodes;
        options.max_seconds = std::max(0.0, options.max_seconds - latest.seconds);
        latest = solve(scene, options);
        best.status = latest.status;
        if (best.status != Status::converged)
            break;
        const double deviation = length_deviation(*scene, latest);
        best.deviations.push_back(deviation);
        if (deviation < lowest) {
            lowest = deviation;
            best.best_round = round;
            best.scene = scene;
            best.result = latest;
        } else if (round - best.best_round >= patience) {
            best.stopped_improving = true;
            break;
        }
    }
    return best;
}

} // namespace funicular
