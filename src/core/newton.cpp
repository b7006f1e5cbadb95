// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace funicular {

namespace {

// A step is accepted when it has overshot by no more than this part of the work it began with.
constexpr double accepted_overshoot = 0.5;
constexpr int most_trials = 60;
constexpr double least_motion = 1e-16;

// So many steps in a row, each shorter than this part of what Newton's method asked for, call for softer
// members.
constexpr int most_short_steps = 2;
constexpr double short_step = 0.1;
// The softest stage has this mean k r (EA) for each newton of load, where strains are moderate.
constexpr double softest_stiffness_per_load = 10;
constexpr double first_stage_ratio = 10;
constexpr double residual_of_stage = 1e-2;

/// Whether the residual, having done work `begun` per step at the start, does not push back too hard at the
/// end.
bool is_acceptable(double work, double begun) {
    return work >= -accepted_overshoot * begun;
}

/// A step length between one that falls short and one that overshoots. The work of a stretching member falls
/// with the cube of the step from a flat start, so that a secant alone would creep.
double step_between(double low, double low_work, double high, double high_work) {
    const double secant = low + (high - low) * low_work / (low_work - high_work);
    const double middle =
        low > 0 ? std::sqrt(low * high) : high * std::cbrt(low_work / (low_work - high_work));
    return std::clamp(std::max(secant, middle), low + 0.05 * (high - low), high - 0.05 * (high - low));
}

/// Stiffness factor at which strains would be moderate.
double softest_factor(const Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const double whole_load = equilibrium.mean_nodal_load() * scene.net().node_count();
    const double mean_stiffness =
        (scene.axial().stiffness().array() * scene.net().source_lengths().array()).mean() /
        scene.scale().length;
    return softest_stiffness_per_load * whole_load / mean_stiffness;
}

} // namespace

double Newton::position_error(const Points &x, Equilibrium &equilibrium, const Goal & /*goal*/) {
    while (softened_ && softened_->relative_residual() <= residual_of_stage)
        stiffen(x, equilibrium);
    direction_.compute(x, softened_ ? *softened_ : equilibrium);
    return !softened_ && direction_.is_newton_step() ? direction_.largest_motion()
                                                     : std::numeric_limits<double>::infinity();
}

Iteration::Move Newton::move(Points &x, Equilibrium &equilibrium) {
    const double taken = search(x, softened_ ? *softened_ : equilibrium);
    if (softened_) {
        if (taken == 0)
            stiffen(x, equilibrium);
        equilibrium.evaluate(x);
        return Move::made;
    }
    short_steps_ = taken < short_step ? short_steps_ + 1 : 0;
    if (!has_softened_ && (taken == 0 || short_steps_ >= most_short_steps) &&
        softest_factor(equilibrium) < 1) {
        soften(x, equilibrium);
        return Move::made;
    }
    return taken > 0 ? Move::made : Move::impossible;
}

double Newton::search(Points &x, Equilibrium &stage) {
    const double begun = stage.residual().dot(direction_.unknowns());
    if (!(begun > 0) || !std::isfinite(begun))
        return 0;
    start_ = x;
    const auto work_at = [&](double step) {
        x = start_ + step * direction_.motion();
        stage.evaluate(x);
        return stage.residual().dot(direction_.unknowns());
    };

    const double wished = std::min(1.0, reach_ / direction_.largest_motion());
    double step = wished;
    double work = work_at(step);
    if (wished < 1 && work > 0)
        reach_ *= 2;

    double low = 0;
    double low_work = begun;
    double high = step;
    double high_work = work;
    for (int trial = 0; trial < most_trials && !is_acceptable(work, begun); ++trial) {
        step = step_between(low, low_work, high, high_work);
        if (step * direction_.largest_motion() < least_motion)
            break;
        work = work_at(step);
        (work > 0 ? low : high) = step;
        (work > 0 ? low_work : high_work) = work;
    }
    if (is_acceptable(work, begun))
        return step / wished;
    x = start_;
    stage.evaluate(x);
    return 0;
}

void Newton::soften(const Points &x, const Equilibrium &equilibrium) {
    has_softened_ = true;
    stiffness_factor_ = softest_factor(equilibrium);
    stage_ratio_ = first_stage_ratio;
    enter_stage(x, equilibrium);
}

void Newton::stiffen(const Points &x, Equilibrium &equilibrium) {
    equilibrium.add_costs_of(*softened_);
    softened_.reset();
    stiffness_factor_ *= stage_ratio_;
    stage_ratio_ *= stage_ratio_;
    if (stiffness_factor_ < 1)
        enter_stage(x, equilibrium);
    else
        equilibrium.evaluate(x);
}

void Newton::enter_stage(const Points &x, const Equilibrium &equilibrium) {
    softened_ = std::make_unique<Equilibrium>(
        std::make_shared<const Scene>(equilibrium.scene().with_stiffness_factor(stiffness_factor_)));
    softened_->evaluate(x);
}

} // namespace funicular
