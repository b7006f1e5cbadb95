// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.hpp"

#include "multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace funicular {

namespace {

// A step is accepted when it has overshot by no more than this part of the work it began with.
constexpr double accepted_overshoot = 0.5;
constexpr double hardly_fallen = 0.9;
constexpr int most_trials = 60;
constexpr double least_motion = 1e-16;
// Below this relative residual the tangent holds everywhere.
constexpr double residual_to_settle = 1e-3;

// So many steps in a row, each shorter than this part of what Newton's method asked for, call for softer
// members.
constexpr int most_short_steps = 2;
constexpr double short_step = 0.1;
// A scene that has not come to rest after so many steps is a stiff one too.
constexpr int most_direct_steps = 40;
// In the softest stage no member has a stiffness k r (EA) above this for each newton of load, where strains
// are moderate.
constexpr double softest_stiffness_per_load = 10;
constexpr double first_stage_ratio = 10;
// In that measure of stiffness.
constexpr double stiffness_for_exact_steps = 1.5;
constexpr double largest_stage_ratio = 1e3;
constexpr double residual_of_stage = 1e-2;
// In the scene's own units, in which the net has a size of about one.
constexpr double most_growth_of_stage = 100;

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

/// The stiffness k r [N] at which strains would be moderate.
double soft_stiffness(const Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    return softest_stiffness_per_load * equilibrium.mean_nodal_load() * scene.net().node_count() *
           scene.scale().force;
}

/// The largest k r of a member [N].
double stiffest_member(const Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const auto lengths = scene.rest_lengths().cwiseMax(scene.net().source_lengths()) / scene.scale().length;
    return (scene.axial().stiffness().array() * lengths.array()).maxCoeff() * scene.scale().force;
}

// Fewer nodes are factorised in less time than a lattice is thinned out in.
constexpr Index least_nodes_for_multigrid = 300;

NewtonDirection direction_for(const Equilibrium &equilibrium, const CoarserLevels &levels) {
    const Scene &scene = equilibrium.scene();
    if (!levels.empty() && scene.net().node_count() >= least_nodes_for_multigrid)
        return NewtonDirection(std::make_unique<Multigrid>(scene, levels));
    return NewtonDirection(equilibrium);
}

} // namespace

bool calls_for_exact_steps(const Equilibrium &equilibrium) {
    return equilibrium.scene().axial().is_compression_only() &&
           stiffest_member(equilibrium) > stiffness_for_exact_steps * soft_stiffness(equilibrium);
}

Newton::Newton(const Equilibrium &equilibrium, CoarserLevels levels)
    : levels_(std::move(levels)), direction_(direction_for(equilibrium, levels_)),
      settling_(equilibrium.scene().net()) {}

bool Newton::restart() {
    if (softened_)
        return false; // what was made for softer members is of no use to the scene
    reach_ = first_reach;
    short_steps_ = direct_steps_ = 0;
    has_softened_ = false;
    return true;
}

double Newton::position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) {
    while (softened_ && softened_->relative_residual() <= residual_of_stage)
        stiffen(x, equilibrium);
    direction_.compute(x, softened_ ? *softened_ : equilibrium, goal);
    return !softened_ && direction_.is_newton_step() ? direction_.largest_motion()
                                                     : std::numeric_limits<double>::infinity();
}

Iteration::Move Newton::move(Points &x, Equilibrium &equilibrium) {
    Equilibrium &stage = softened_ ? *softened_ : equilibrium;
    const double taken = search(x, stage);
    if (taken > 0 && stage.relative_residual() > residual_to_settle)
        settling_.settle(x, stage, direction_.floor());
    if (softened_) {
        // A stage may have no equilibrium where the scene has one.
        if (taken == 0 || x.cwiseAbs().maxCoeff() > most_growth_of_stage) {
            x = taken == 0 ? x : start_of_stage_;
            stiffen(x, equilibrium);
        }
        equilibrium.evaluate(x);
        return Move::made;
    }
    short_steps_ = taken < short_step ? short_steps_ + 1 : 0;
    if (!has_softened_ &&
        (taken == 0 || short_steps_ >= most_short_steps || ++direct_steps_ >= most_direct_steps) &&
        soft_stiffness(equilibrium) < stiffest_member(equilibrium)) {
        soften(x, equilibrium);
        return Move::made;
    }
    return taken > 0 ? Move::made : Move::impossible;
}

/// r(x)·d at a step from the start.
double Newton::work_at(double step, Points &x, Equilibrium &stage) const {
    x = start_ + step * direction_.motion();
    stage.evaluate(x);
    return stage.residual().dot(direction_.unknowns());
}

double Newton::search(Points &x, Equilibrium &stage) {
    const double begun = stage.residual().dot(direction_.unknowns());
    if (!(begun > 0) || !std::isfinite(begun))
        return 0;
    start_ = x;
    const double wished = std::min(1.0, reach_ / direction_.largest_motion());
    double low = 0;
    double low_work = begun;
    double step = wished;
    double work = work_at(step, x, stage);
    if (wished < 1 && work > 0)
        reach_ *= 2;
    // Where the residual has hardly fallen, as when a load grows with the shape that it makes, the step was
    // too short: it may be as long as the shape is large.
    const double longest = start_.cwiseAbs().maxCoeff() / direction_.largest_motion();
    while (work > hardly_fallen * begun && 2 * step <= longest) {
        low = step;
        low_work = work;
        step *= 2;
        work = work_at(step, x, stage);
    }

    double high = step;
    double high_work = work;
    for (int trial = 0; trial < most_trials && !is_acceptable(work, begun); ++trial) {
        step = step_between(low, low_work, high, high_work);
        if (step * direction_.largest_motion() < least_motion)
            break;
        work = work_at(step, x, stage);
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
    stiffness_limit_ = soft_stiffness(equilibrium);
    stage_ratio_ = first_stage_ratio;
    enter_stage(x, equilibrium);
}

void Newton::stiffen(const Points &x, Equilibrium &equilibrium) {
    equilibrium.add_costs(softened_->costs());
    softened_.reset();
    stiffness_limit_ *= stage_ratio_;
    stage_ratio_ = std::min(stage_ratio_ * stage_ratio_, largest_stage_ratio);
    if (stiffness_limit_ < stiffest_member(equilibrium))
        enter_stage(x, equilibrium);
    else {
        direction_ = direction_for(equilibrium, levels_);
        equilibrium.evaluate(x);
    }
}

void Newton::enter_stage(const Points &x, const Equilibrium &equilibrium) {
    softened_ = std::make_unique<Equilibrium>(
        std::make_shared<const Scene>(equilibrium.scene().with_stiffness_up_to(stiffness_limit_)));
    softened_->evaluate(x);
    direction_ = direction_for(*softened_, levels_);
    start_of_stage_ = x;
}

} // namespace funicular
