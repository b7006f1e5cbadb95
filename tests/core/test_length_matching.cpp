// SPDX-License-Identifier: LGPL-2.1-or-later
#include "length_matching.hpp"
#include "scenes.hpp"

#include <algorithm>

namespace funicular::test {

namespace {

TEST(LengthMatching, SetsRestLengthsByThePapersProportion) {
    const auto scene = hemisphere(12, 6, 5, 1e5, true, 20);
    const auto result = solve(scene);
    const auto matched = match_lengths(*scene, result);
    for (Index e = 0; e < scene->net().member_count(); ++e)
        EXPECT_NEAR(matched->rest_lengths()[e],
                    scene->rest_lengths()[e] * scene->net().source_lengths()[e] / result.member_lengths[e],
                    1e-14);
}

TEST(LengthMatching, LengthsThatTheOtherReadingDrivesAwayComeNearer) {
    const auto scene = catenary(12, 10, 10, 200, 1);
    const auto matching = solve_matching_lengths(scene, 3);
    ASSERT_EQ(matching.result.status, Status::converged);
    ASSERT_GE(matching.deviations.size(), 2);
    EXPECT_LT(matching.deviations[1], matching.deviations[0]);
}

TEST(LengthMatching, KeepsTheBestOfAHundredRounds) {
    const auto scene = hemisphere(16, 8, 5, 1e5, true, 20, 30);
    const auto matching = solve_matching_lengths(scene, 100);
    ASSERT_EQ(matching.result.status, Status::converged);
    const auto best = std::min_element(matching.deviations.begin(), matching.deviations.end());
    EXPECT_EQ(matching.best_round, best - matching.deviations.begin());
    EXPECT_NEAR(length_deviation(*matching.scene, matching.result), *best, 1e-15);
    EXPECT_LT(*best, matching.deviations.front());
    EXPECT_EQ(matching.stopped_improving, matching.deviations.size() < 101);
}

TEST(LengthMatching, NoRoundsIsAPlainSolve) {
    const auto scene = hemisphere(12, 6, 5, 1e5, true, 20);
    const auto matching = solve_matching_lengths(scene, 0);
    EXPECT_EQ(matching.best_round, 0);
    EXPECT_EQ(matching.deviations.size(), 1);
    EXPECT_EQ(matching.result.nodes, solve(scene).nodes);
    expect_invalid([&] { (void)solve_matching_lengths(scene, -1); }, {"rounds"});
}

TEST(LengthMatching, ReturnsTheUnfinishedResultWithItsStatus) {
    SolveOptions options;
    options.max_iterations = 1;
    const auto matching = solve_matching_lengths(hemisphere(12, 6, 5, 1e5, true, 20), 5, options);
    EXPECT_EQ(matching.result.status, Status::iteration_limit);
    EXPECT_EQ(matching.status, Status::iteration_limit);
    EXPECT_TRUE(matching.deviations.empty());
}

TEST(LengthMatching, TellsOfALaterRoundThatWasCancelled) {
    SolveOptions options;
    int begun = 0;
    options.on_progress = [&begun](const Report &report) { return (begun += report.iteration == 0) < 3; };
    const auto matching = solve_matching_lengths(hemisphere(12, 6, 5, 1e5, true, 20), 5, options);
    EXPECT_EQ(matching.status, Status::cancelled);
    EXPECT_EQ(matching.result.status, Status::converged) << "the best before is kept";
}

TEST(LengthMatching, NeedsAResultOfTheSameNet) {
    const auto scene = hemisphere(12, 6, 5, 1e5, true, 20);
    const auto other = solve(catenary(12, 10, 12, 200, 1));
    expect_invalid([&] { (void)match_lengths(*scene, other); },
                   {"12 members", std::to_string(scene->net().member_count())});
}

} // namespace
} // namespace funicular::test
