// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Hard cases of stiffness: the limit of existence, EA from 1e-2 to 1e12, rest lengths that differ 1:1000 (4,
/// 5, 6).
#include "certificate.hpp"
#include "scenes.hpp"

#include <cmath>
#include <optional>

namespace funicular::test {

namespace {

AxialStiffness axial(double ea) {
    return {Eigen::VectorXd::Constant(1, ea)};
}

/// Half of a chain of n equal members, n odd, built outwards from its level middle member at a horizontal
/// thrust: l = r (1 + T / EA), and V grows by the weight of the halves on either side of a node.
struct HalfChain {
    double run = 0;
    double rise = 0;
};
HalfChain half_chain(Index n, double rest, double ea, double weight, double thrust) {
    const double r = rest / n;
    double length = r * (1 + thrust / ea);
    double vertical = 0;
    HalfChain half{length / 2, 0};
    for (Index e = 0; e < n / 2; ++e) {
        const double before = length;
        double from = vertical;
        double pull = thrust;
        // l = r (1 + √(H² + V²) / EA) with V = V' + w (l' + l) / 2: contracts by w r / (2 EA) at most.
        for (int pass = 0; pass < 200; ++pass) {
            vertical = from + weight * (before + length) / 2;
            pull = std::hypot(thrust, vertical);
            length = r * (1 + pull / ea);
        }
        half.run += length * thrust / pull;
        half.rise += length * vertical / pull;
    }
    return half;
}

/// Rise of such a chain over a span, by bisection of its thrust: shares nothing with the solver but the
/// model.
double rise_of_chain(Index n, double span, double rest, double ea, double weight) {
    double low = 1e-12 * ea;
    double high = 1e12 * weight * span;
    for (int step = 0; step < 300; ++step) {
        const double thrust = std::sqrt(low * high);
        (half_chain(n, rest, ea, weight, thrust).run < span / 2 ? low : high) = thrust;
    }
    return half_chain(n, rest, ea, weight, low).rise;
}

TEST(HardCase04_LimitOfExistence, AStrandBelowItsLimitIsFoundHoweverLong) {
    // l = k r / (k - w / 2) in the upper one, and the lower one carries that too; the limit is w = 2 k.
    for (const double short_of : {0.5, 1e-1, 1e-2, 1e-3, 1e-4}) {
        constexpr double k = 1;
        const double weight = 2 * k * (1 - short_of);
        const auto scene = strand(1, 10, 10 * k, weight);
        const auto result = solved(scene);
        expect_certified(scene, result);
        EXPECT_NEAR(result.nodes(1, 2) * short_of, 10, 1e-8) << short_of;
    }
}

TEST(HardCase04_LimitOfExistence, AStrandAtAndPastItHasNone) {
    for (const Index n : {1, 2, 7})
        for (const double part : {1.0, 1.001, 2.0, 1e3, 1e9})
            expect_no_equilibrium(strand(n, 10, 10, part * 2 * n), {"No equilibrium", "weight", "stiffness"});
}

ScenePtr covered_sheet(double ea, double covering) {
    const auto net = flat_sheet(10, 10, 1);
    return std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->border()}},
        std::vector<EffectDescription>{axial(ea), CoveringWeight{covering}});
}

TEST(HardCase04_LimitOfExistence, OfACoveredSheetIsOneWeight) {
    // From light to far too heavy: an equilibrium up to some weight and none above it, always higher.
    double rise = 0;
    std::optional<double> beyond;
    for (double covering = 10; covering < 1e5; covering *= 1.3) {
        const auto scene = covered_sheet(1e4, covering);
        const auto result = solve(scene);
        EXPECT_TRUE(result.nodes.allFinite());
        if (result.status == Status::converged) {
            EXPECT_FALSE(beyond) << covering << " kg/m² stands where " << *beyond << " does not";
            expect_certified(scene, result, 1e-6);
            EXPECT_GT(result.nodes.col(2).maxCoeff(), rise) << covering;
            rise = result.nodes.col(2).maxCoeff();
        } else {
            EXPECT_EQ(result.status, Status::no_equilibrium) << covering << ": " << result.message;
            expect_words(result.message, {"No equilibrium", "weight", "stiffness"});
            beyond = beyond.value_or(covering);
        }
    }
    EXPECT_TRUE(beyond);
    EXPECT_GT(rise, 5);
}

TEST(HardCase04_LimitOfExistence, TheMessageNamesTheWeightAndWhatTheStiffnessCarries) {
    const auto net = flat_sheet(10, 10, 1);
    const std::vector<Support> border{{.kind = SupportKind::fixed, .nodes = net->border()}};
    const auto covered = std::make_shared<const Scene>(
        net, border, std::vector<EffectDescription>{axial(1e4), CoveringWeight{8000}});
    expect_no_equilibrium(covered, {"covering weight", "kg/m²", "at most about"});
    expect_no_equilibrium(strand(3, 10, 10, 1000), {"member weight", "kg/m", "at most about"});
}

class HardCase05_StiffnessFrom1e_2To1e12 : public testing::TestWithParam<int> {};

TEST_P(HardCase05_StiffnessFrom1e_2To1e12, AChainHasTheRiseOfItsRecursion) {
    const double ea = std::pow(10, GetParam());
    constexpr Index n = 21;
    for (const double weight : {1e-3, 1.0, 100.0}) {
        // Softer than this, the chain would be longer than its span by more than anyone would build.
        const bool is_beyond = ea < 0.2 * weight * 10;
        const auto scene = catenary(n, 10, 10.5, ea, weight);
        SolveOptions options;
        options.accuracy = 1e-7;
        const auto result = solve(scene, options);
        if (result.status == Status::converged) {
            if (result.residual <= result.tolerance)
                expect_certified(scene, result, result.tolerance);
            else
                expect_words(result.message, {"as far as rounding lets one tell"});
            const double rise = rise_of_chain(n, 10, 10.5, ea, weight);
            EXPECT_NEAR(result.nodes.col(2).maxCoeff(), rise, 1e-6 * std::max(1.0, rise)) << weight;
        } else if (is_beyond) {
            EXPECT_EQ(result.status, Status::no_equilibrium) << result.message;
            expect_words(result.message, {"weight", "stiffness"});
        } else {
            // A unit in the last place of a position times k is more than 1e-3 of a nodal load.
            EXPECT_GT(ea / (weight * 0.5 * 0.5) * 4 * 2.2e-16 * 5, 1e-6) << result.message;
            expect_words(result.message, {"rounding", "Lower the stiffness"});
        }
    }
}

TEST_P(HardCase05_StiffnessFrom1e_2To1e12, ADomeStandsOrSaysWhyNot) {
    const double ea = std::pow(10, GetParam());
    const auto scene = hemisphere(12, 6, 5, ea, true, 20, 30);
    const auto result = solve(scene);
    EXPECT_TRUE(result.nodes.allFinite());
    // Below some kN nothing need stand.
    if (ea < 1e4 && result.status != Status::converged)
        expect_no_equilibrium(scene, {"weight", "stiffness"});
    else
        expect_certified(scene, result, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Decades, HardCase05_StiffnessFrom1e_2To1e12, testing::Range(-2, 13),
                         [](const auto &each) {
                             return each.param < 0 ? "EA1e_" + std::to_string(-each.param)
                                                   : "EA1e" + std::to_string(each.param);
                         });

TEST(HardCase05_Verdicts, WhatTheSolverCallsConvergedTheCertificateDoes) {
    // Where rounding makes a residual that both excuse, the sums of that very residual must be excused too.
    for (const double ea : {1e7, 1e8, 1e9, 1e10, 1e11})
        for (const double weight : {1e-3, 1e-2, 0.1, 1.0, 100.0}) {
            const auto scene = catenary(21, 10, 10.5, ea, weight);
            const auto result = solve(scene);
            if (result.status == Status::converged)
                expect_certified(scene, result, result.tolerance);
        }
}

TEST(HardCase06_RestLengths1To1000, OnAChainInTurns) {
    // Rest lengths of 1 mm and 1 m in turns, over a span that stretches the first a hundredfold.
    for (const double ea : {1e2, 1e4, 1e6}) {
        const auto scene = catenary(12, 10, 12, ea, 5);
        Eigen::VectorXd rest(12);
        for (Index e = 0; e < 12; ++e)
            rest[e] = e % 2 == 0 ? 1e-3 : 1;
        const auto uneven = std::make_shared<const Scene>(scene->with_rest_lengths(rest));
        const auto result = solved_in_any_numbering(uneven);
        // A force density tells them apart as little as the law does: T = EA (l / r - 1), in each.
        for (Index e = 0; e < 12; ++e)
            EXPECT_NEAR(-result.member_forces[e], ea * (result.member_lengths[e] / rest[e] - 1),
                        1e-6 * -result.member_forces[e] + 1e-9 * ea);
    }
}

TEST(HardCase06_RestLengths1To1000, EveryThirdMemberOfANetAThousandTimesTooShort) {
    const auto net = flat_sheet(6, 6, 1);
    Eigen::VectorXd rest = net->source_lengths();
    for (Index e = 0; e < rest.size(); e += 3)
        rest[e] *= 1e-3;
    const auto scene = std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = net->lattice()->corners()}},
        std::vector<EffectDescription>{axial(1e4), MemberWeight{5}, CoveringWeight{20}}, rest);
    const auto result = solved_in_any_numbering(scene);
    EXPECT_TRUE(certify(*scene, result.centred_nodes, nullptr, 1e-9).compression_only);
}

TEST(HardCase06_RestLengths1To1000, DiagonalsAThousandTimesTooLongAreAsIfAbsent) {
    const auto braced = braced_sheet(6, 6, 6, 6);
    const auto plain = flat_sheet(6, 6, 1);
    const std::vector<Support> supports{{.kind = SupportKind::fixed, .nodes = plain->lattice()->corners()}};
    const std::vector<EffectDescription> effects{axial(1e5), CoveringWeight{20}};
    Eigen::VectorXd rest = braced->source_lengths();
    for (Index e = plain->member_count(); e < rest.size(); ++e)
        rest[e] *= 1e3;
    const auto result =
        solved_in_any_numbering(std::make_shared<const Scene>(braced, supports, effects, rest));
    const auto reference = solved(std::make_shared<const Scene>(plain, supports, effects));
    EXPECT_LT(distance(result.nodes, reference.nodes), 1e-10);
    EXPECT_EQ(result.member_forces.tail(rest.size() - plain->member_count()).cwiseAbs().maxCoeff(), 0);
}

} // namespace
} // namespace funicular::test
