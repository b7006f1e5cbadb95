// SPDX-License-Identifier: LGPL-2.1-or-later
#include "interior_point.hpp"

#include "multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace funicular {

namespace {

// Close to taut: from there the path is short.
constexpr double first_slack = 0.01;
// Where it is not so short, as from a flat sheet that will stand on its corners, only small parts of the
// steps can be taken from early on, and it would be crept along. Then it is begun so much farther from its
// end.
constexpr double short_length = 0.2;
constexpr int most_short_steps = 3;
constexpr double farther = 10;
constexpr int most_beginnings = 4;
// A shape as near as this has most of its slack members right: that is what Newton's method needs, and it is
// left when it does not arrive in so many steps.
constexpr double residual_for_newton = 0.5;
constexpr int most_newton_steps = 15;

// Of the way to where the first slack or force density vanishes; more of it near the end of the path.
constexpr double least_part_of_way = 0.9;
constexpr double most_part_of_way = 0.999;
// The slack that a shape has is taken at its word, unless it would be less than this part of what it was.
constexpr double least_kept_slack = 0.5;
// Members may stretch to ten times their length.
constexpr double most_of_stiffness = 0.9;

// Near the end the change of loads along a step counts.
constexpr double residual_near_end = 1;
// How exactly multigrid solves for a step; at worst.
constexpr double accuracy_of_step = 1e-3;
constexpr double least_accuracy = 0.1;
constexpr int most_iterations = 60;

// A factor of fewer nodes costs less than the cycles of a step.
constexpr Index least_nodes_for_multigrid = 5000;

constexpr int most_steps = 100;
constexpr double least_length = 1e-6;
constexpr double most_growth = 100; // in the scene's own units, in which the net has a size of about one
// A shape as near as this is a better one to go on from than the start.
constexpr double residual_to_keep = 1e-2;

/// Whether the change of the loads along a step counts.
bool is_near_end(const Equilibrium &equilibrium) {
    return equilibrium.relative_residual() < residual_near_end;
}

/// How far values can go along their change before the first of them vanishes.
double length_to_boundary(const Eigen::VectorXd &values, const Eigen::VectorXd &changes) {
    double length = std::numeric_limits<double>::infinity();
    for (Eigen::Index e = 0; e < values.size(); ++e)
        if (changes[e] < 0)
            length = std::min(length, -values[e] / changes[e]);
    return length;
}

} // namespace

bool InteriorPoint::is_for(const Equilibrium &equilibrium) {
    return calls_for_exact_steps(equilibrium) && !equilibrium.loads().isZero(0) &&
           equilibrium.scene().axial().rest_lengths().minCoeff() > 0;
}

InteriorPoint::InteriorPoint(const Equilibrium &equilibrium, const CoarserLevels &levels)
    : is_factor_(levels.empty() || equilibrium.scene().net().node_count() < least_nodes_for_multigrid) {
    if (is_factor_)
        preconditioner_ = std::make_unique<KeptFactor>(equilibrium);
    else
        preconditioner_ = std::make_unique<Multigrid>(equilibrium.scene(), levels);
}

void InteriorPoint::begin_path(const Points &x, const Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const AxialForces &axial = scene.axial();
    const auto &rest = axial.rest_lengths();
    const auto member_count = static_cast<double>(rest.size());
    const double whole_load = equilibrium.mean_nodal_load() * scene.net().node_count();
    const double size = scene.net().size() / scene.scale().length;
    typical_density_ = whole_load / size / std::sqrt(member_count);
    typical_product_ = typical_density_ * rest.squaredNorm() / member_count;
    densities_ = (0.5 * most_of_stiffness * axial.stiffness()).cwiseMin(first_density_ * typical_density_);
    first_density_ *= farther;
    ++beginnings_;
    slacks_ = first_slack * rest.array().square();
    start_ = x;
    steps_ = 0;
    short_steps_ = 0;
    last_motion_.reset();
    phase_ = Phase::path;
}

void InteriorPoint::use_newton(Phase phase, const Equilibrium &equilibrium) {
    phase_ = phase;
    steps_ = 0;
    if (!newton_ || !newton_->restart())
        newton_.emplace(equilibrium);
}

bool InteriorPoint::restart() {
    phase_ = Phase::begun;
    first_density_ = first_density_from_near;
    beginnings_ = 0;
    return true;
}

double InteriorPoint::position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) {
    if (phase_ == Phase::begun) {
        if (equilibrium.relative_residual() <= residual_for_newton)
            use_newton(Phase::newton, equilibrium);
        else
            begin_path(x, equilibrium);
    } else if (phase_ == Phase::newton && steps_ >= most_newton_steps) {
        begin_path(x, equilibrium);
    }
    if (phase_ != Phase::path)
        return newton_->position_error(x, equilibrium, goal);

    goal_ = goal;
    if (last_motion_)
        return *last_motion_;
    linearise(x, equilibrium);
    products_.setZero(densities_.size());
    unknowns_.setZero(equilibrium.scene().freedoms().size());
    has_step_ = prepare(x, equilibrium) && compute_step(x, equilibrium);
    return has_step_ && leads_to_end() ? largest_motion() : std::numeric_limits<double>::infinity();
}

Iteration::Move InteriorPoint::move(Points &x, Equilibrium &equilibrium) {
    ++steps_;
    if (phase_ == Phase::newton_at_last)
        return newton_->move(x, equilibrium);
    if (phase_ == Phase::newton) {
        if (newton_->move(x, equilibrium) == Move::impossible)
            begin_path(x, equilibrium);
        return Move::made;
    }
    if (steps_ <= most_steps && follow_path(x, equilibrium))
        return Move::made;
    if (!(equilibrium.relative_residual() <= residual_to_keep)) {
        // Without an equilibrium there is no path to it; Newton's method says so.
        x = start_;
        equilibrium.evaluate(x);
    }
    use_newton(Phase::newton_at_last, equilibrium);
    return Move::made;
}

void InteriorPoint::linearise(const Points &x, Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const auto &members = scene.net().members();
    const auto &stiffness = scene.axial().stiffness();
    const auto &rest = scene.axial().rest_lengths();
    unbalanced_ = equilibrium.loads();
    equilibrium.add_elastic_supports(x, unbalanced_);
    spans_.resize(members.size());
    gaps_.resize(densities_.size());
    compliances_.resize(densities_.size());
    equilibrium.linearise_as([&](std::vector<AxialForces::MemberTangent> &tangents) {
        for (Index e = 0; e < densities_.size(); ++e) {
            const auto [i, j] = members[e];
            const Vector3 span = (x.row(j) - x.row(i)).transpose();
            const double density = densities_[e];
            const double stretch = 1 / (1 - density / stiffness[e]);
            const double when_taut = 0.5 * std::pow(rest[e] * stretch, 2); // l² / 2
            const double square = span.squaredNorm();
            double &slack = slacks_[e];
            if (const double present = when_taut - 0.5 * square; present > least_kept_slack * slack)
                slack = present;
            spans_[e] = span;
            gaps_[e] = 0.5 * square + slack - when_taut;
            compliances_[e] = 2 * when_taut * stretch / stiffness[e] + slack / density;
            const double length = std::sqrt(square);
            tangents[e] = {.direction = length > 0 ? Vector3(span / length) : Vector3::Zero(),
                           .along = square / compliances_[e],
                           .around = density};
            unbalanced_.row(i) += density * span.transpose();
            unbalanced_.row(j) -= density * span.transpose();
        }
    });
    if (is_near_end(equilibrium))
        equilibrium.linearise_loads(x);
}

bool InteriorPoint::prepare(const Points &x, const Equilibrium &equilibrium) {
    return preconditioner_->prepare(x, equilibrium, typical_density_);
}

/// Solves K u = right_, K the stiffness of the present step, beginning with the u that is there: the step to
/// the end of the path says much of the one that is taken.
bool InteriorPoint::solve(const Points &x, Equilibrium &equilibrium) {
    if (is_factor_ && !is_near_end(equilibrium)) {
        preconditioner_->apply(right_, unknowns_);
        return unknowns_.allFinite();
    }
    const auto loads =
        is_near_end(equilibrium) ? TangentEquations::Loads::following : TangentEquations::Loads::as_they_are;
    const LinearProgress progress = equations_.solve(x, equilibrium, loads, *preconditioner_, right_,
                                                     accuracy_of_step, most_iterations, unknowns_);
    if (is_factor_ || progress.residual <= least_accuracy)
        return unknowns_.allFinite();
    // Slack and taut members have become too different for coarser nets to tell of them.
    preconditioner_ = std::make_unique<KeptFactor>(equilibrium);
    is_factor_ = true;
    return prepare(x, equilibrium) && solve(x, equilibrium);
}

bool InteriorPoint::compute_step(const Points &x, Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const auto &members = scene.net().members();
    step_.densities =
        (gaps_.array() + products_.array() / densities_.array() - slacks_.array()) / compliances_.array();
    forces_ = unbalanced_;
    for (Index e = 0; e < densities_.size(); ++e) {
        const auto [i, j] = members[e];
        const Vector3 force = step_.densities[e] * spans_[e];
        forces_.row(i) += force.transpose();
        forces_.row(j) -= force.transpose();
    }
    scene.freedoms().reduce(forces_, right_);
    if (!solve(x, equilibrium))
        return false;
    step_.motion.resize(forces_.rows(), 3);
    scene.freedoms().expand(unknowns_, step_.motion);
    for (Index e = 0; e < densities_.size(); ++e) {
        const auto [i, j] = members[e];
        const Vector3 stretch = (step_.motion.row(j) - step_.motion.row(i)).transpose();
        step_.densities[e] += spans_[e].dot(stretch) / compliances_[e];
    }
    step_.slacks = (products_.array() - slacks_.array() * step_.densities.array()) / densities_.array() -
                   slacks_.array();
    const Eigen::VectorXd room = most_of_stiffness * scene.axial().stiffness() - densities_;
    step_.density_length = std::min(
        {1.0, length_to_boundary(densities_, step_.densities), length_to_boundary(room, -step_.densities)});
    step_.slack_length = std::min(1.0, length_to_boundary(slacks_, step_.slacks));
    return step_.densities.allFinite();
}

double InteriorPoint::parameter_after(double density_length, double slack_length) const {
    return (densities_ + density_length * step_.densities).dot(slacks_ + slack_length * step_.slacks) /
           static_cast<double>(densities_.size());
}

/// Goes all the way if that is near enough.
bool InteriorPoint::jump_to_end(Points &x, Equilibrium &equilibrium) {
    if (!leads_to_end() || largest_motion() > goal_.accuracy)
        return false;
    const Points present = x;
    x += step_.motion;
    equilibrium.evaluate(x);
    if (equilibrium.significant_residual() <= goal_.tolerance) {
        // What is left is less than this.
        last_motion_ = largest_motion();
        return true;
    }
    x = present;
    equilibrium.evaluate(x);
    return false;
}

/// \pre step_ leads to the end of the path
bool InteriorPoint::follow_path(Points &x, Equilibrium &equilibrium) {
    if (!has_step_)
        return false;
    if (jump_to_end(x, equilibrium))
        return true;
    // How much of the step to the end of the path can be taken tells how far to aim; what it would make of
    // q s, how the path bends.
    const double present = parameter_after(0, 0);
    const double aim =
        std::pow(parameter_after(step_.density_length, step_.slack_length) / present, 3) * present;
    products_ =
        aim - step_.density_length * step_.slack_length * (step_.densities.array() * step_.slacks.array());
    if (!compute_step(x, equilibrium) || std::max(step_.slack_length, step_.density_length) < least_length)
        return false;
    const double part = std::clamp(1 - present / typical_product_, least_part_of_way, most_part_of_way);
    x += part * step_.slack_length * step_.motion;
    slacks_ += part * step_.slack_length * step_.slacks;
    densities_ += part * step_.density_length * step_.densities;
    const double length = std::min(step_.slack_length, step_.density_length);
    short_steps_ = length < short_length ? short_steps_ + 1 : 0;
    if (short_steps_ == most_short_steps && beginnings_ < most_beginnings) {
        x = start_;
        equilibrium.evaluate(x);
        begin_path(x, equilibrium);
    } else {
        equilibrium.evaluate(x);
    }
    return x.cwiseAbs().maxCoeff() < most_growth;
}

} // namespace funicular
