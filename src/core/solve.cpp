// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solve.hpp"

#include "coarse_start.hpp"
#include "errors.hpp"
#include "interior_point.hpp"
#include "messages.hpp"
#include "newton.hpp"
#include "relaxation.hpp"
#include "text.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace funicular {

namespace {

constexpr long most_newton_steps = 1000;
constexpr long most_relaxation_steps = 10'000'000;
// Where Newton's method found no step, relaxation gets so far or not at all.
constexpr long most_steps_after_newton = 100'000;
// Each costs a pass over the net: a large one must not be relaxed for hours to no end.
constexpr long most_steps_to_halve = 2000;
constexpr const char *allow_more = "Allow more, or ask for less accuracy.";
constexpr const char *try_else = "Start from another shape, or ask for less accuracy.";
// Farther from rest than this, finding the shape on coarser nets first costs less than going on from it.
constexpr double residual_of_far_start = 0.5;
constexpr int most_departures = 8;
constexpr double seconds_between_reports = 0.01;
constexpr std::size_t longest_history = 4096;

double clock_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void check(const Scene &scene, const SolveOptions &options) {
    if (!(options.accuracy > 0) || !std::isfinite(options.accuracy))
        throw InvalidInput("accuracy must be positive and finite, in metres");
    if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
        throw InvalidInput(
            "tolerance must be positive and finite (a residual relative to the mean nodal load)");
    if (!(options.max_seconds >= 0))
        throw InvalidInput("max_seconds must be zero or positive");
    if (options.max_iterations && *options.max_iterations < 0)
        throw InvalidInput("max_iterations must be zero or positive");
    if (!options.start)
        return;
    if (options.start->rows() != scene.net().node_count())
        throw InvalidInput("start has " + std::to_string(options.start->rows()) + " nodes, but the net has " +
                           std::to_string(scene.net().node_count()));
    for (Index i = 0; i < options.start->rows(); ++i)
        if (!options.start->row(i).allFinite())
            throw InvalidInput("start[" + std::to_string(i) + "] is not finite");
}

Points reactions_at(const Points &x, const Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    Points balanced(x.rows(), 3);
    scene.freedoms().expand(equilibrium.residual(), balanced);
    Points reactions = Points::Zero(x.rows(), 3);
    for (Index node = 0; node < x.rows(); ++node)
        if (scene.freedoms().count(node) < 3)
            reactions.row(node) = equilibrium.forces().row(node) - balanced.row(node);
    for (const auto &support : scene.elastic_supports())
        reactions.row(support.node) +=
            (support.stiffness * (x.row(support.node).transpose() - support.anchor)).transpose();
    return reactions * scene.scale().force;
}

} // namespace

Solver::Solver(std::shared_ptr<const Scene> scene, SolveOptions options)
    : scene_(std::move(scene)), options_(std::move(options)) {
    if (!scene_)
        throw InvalidInput("scene is missing: give a Scene");
    check(*scene_, options_);
    if (options_.method == Method::automatic)
        levels_ = coarser_levels(*scene_);
    const Points start = scene_->scale().to_local(options_.start ? *options_.start : scene_->net().nodes());
    begin(start, !options_.start);
}

void Solver::begin(const Points &local_start, bool is_cold) {
    goal_ = {.tolerance = options_.tolerance, .accuracy = options_.accuracy / scene_->scale().length};
    equilibrium_ = std::make_unique<Equilibrium>(scene_);
    start_ = x_ = scene_->on_supports(local_start);
    extent_ = std::max(x_.cwiseAbs().maxCoeff(), scene_->net().size() / scene_->scale().length);
    equilibrium_->evaluate(x_);
    rest_without_loads();
    report_ = {};
    history_.clear();
    history_stride_ = 1;
    seconds_before_ = 0;
    last_told_ = -std::numeric_limits<double>::infinity();
    is_measured_ = false;
    status_.reset();
    load_limit_.reset();
    instability_.reset();
    departures_ = 0;
    const bool had_path = has_path_;
    has_path_ = options_.method == Method::automatic && InteriorPoint::is_for(*equilibrium_);
    if (has_path_ != had_path) {
        iteration_.reset();
        if (had_path)
            levels_ = coarser_levels(*scene_);
    }
    CoarserLevels of_path;
    if (!levels_.empty() && calls_for_exact_steps(*equilibrium_)) {
        of_path = std::exchange(levels_, {});
        iteration_.reset();
    }
    const bool is_far = is_cold || equilibrium_->relative_residual() > residual_of_far_start;
    if (is_far && !levels_.empty()) {
        method_ = Method::newton;
        iteration_ = std::make_unique<CoarseToFine>(*equilibrium_, levels_);
    } else if (has_path_) {
        method_ = Method::newton;
        if (!iteration_ || !iteration_->restart())
            iteration_ = std::make_unique<InteriorPoint>(*equilibrium_,
                                                         of_path.empty() ? coarser_levels(*scene_) : of_path);
    } else if (!iteration_ || !iteration_->restart())
        use(options_.method == Method::relaxation ? Method::relaxation : Method::newton);
    publish();
}

/// Slack members that bear nothing leave the shape open. Once the last load is taken off, the net lies down
/// on its source rather than stopping anywhere on the way there.
void Solver::rest_without_loads() {
    if (!scene_->axial().is_compression_only() || !equilibrium_->loads().isZero(0) ||
        equilibrium_->relative_residual() == 0)
        return;
    const Points source = scene_->on_supports(scene_->scale().to_local(scene_->net().nodes()));
    equilibrium_->evaluate(source);
    if (equilibrium_->significant_residual() <= options_.tolerance)
        start_ = x_ = source;
    else
        equilibrium_->evaluate(x_);
}

void Solver::use(Method method) {
    method_ = method;
    if (method == Method::relaxation)
        iteration_ = std::make_unique<Relaxation>(*equilibrium_);
    else
        iteration_ = std::make_unique<Newton>(*equilibrium_, levels_);
}

void Solver::replace(std::shared_ptr<const Scene> scene) {
    if (!scene)
        throw InvalidInput("scene is missing: give a Scene");
    if (scene->net().node_count() != x_.rows())
        throw InvalidInput("scene has " + std::to_string(scene->net().node_count()) +
                           " nodes, but the shape to go on from has " + std::to_string(x_.rows()));
    const std::scoped_lock lock(working_);
    const Points shape = has_run_away() ? scene->net().nodes() : scene_->scale().to_metres(x_);
    const bool is_same_structure =
        scene->shared_net() == scene_->shared_net() && scene->supports() == scene_->supports();
    scene_ = std::move(scene);
    if (!is_same_structure) {
        iteration_.reset();
        if (options_.method == Method::automatic)
            levels_ = coarser_levels(*scene_);
    }
    begin(scene_->scale().to_local(shape), false);
}

double Solver::seconds() const {
    return seconds_before_ + (entered_ ? clock_now() - *entered_ : 0);
}

void Solver::publish() {
    Points shape = scene_->scale().to_metres(x_);
    const std::scoped_lock lock(published_guard_);
    published_ = std::move(shape);
}

Points Solver::nodes() const {
    const std::scoped_lock lock(published_guard_);
    return published_;
}

bool Solver::told(const Report &report) {
    if (report.iteration % history_stride_ == 0) {
        history_.push_back(report);
        if (history_.size() >= longest_history) {
            for (std::size_t k = 0; 2 * k < history_.size(); ++k)
                history_[k] = history_[2 * k];
            history_.resize((history_.size() + 1) / 2);
            history_stride_ *= 2;
        }
    }
    const double interval = method_ == Method::relaxation ? seconds_between_reports : 0;
    if (report.seconds - last_told_ < interval)
        return true;
    last_told_ = report.seconds;
    publish();
    return !options_.on_progress || options_.on_progress(report);
}

bool Solver::end(Status status, std::string message) {
    status_ = status;
    message_ = std::move(message);
    publish();
    return true;
}

bool Solver::advance(double max_seconds) {
    if (!(max_seconds >= 0))
        throw InvalidInput("max_seconds must be zero or positive");
    const std::scoped_lock lock(working_);
    if (status_)
        return true;
    struct Clock { // keeps the time also when a callback throws
        Solver &solver;
        explicit Clock(Solver &of) : solver(of) { solver.entered_ = clock_now(); }
        Clock(const Clock &) = delete;
        Clock &operator=(const Clock &) = delete;
        ~Clock() {
            solver.seconds_before_ = solver.seconds();
            solver.entered_.reset();
        }
    } const clock(*this);
    const double until = seconds() + max_seconds;

    if (measure() || end_if_decided())
        return true;
    do {
        if (make_move() || measure() || end_if_decided())
            return true;
    } while (seconds() < until);
    return false;
}

/// Looks at the present shape, once, and tells of it. Returns whether that ended the solve.
bool Solver::measure() {
    if (is_measured_)
        return false;
    report_.residual = equilibrium_->relative_residual();
    report_.position_error = iteration_->position_error(x_, *equilibrium_, goal_) * scene_->scale().length;
    report_.seconds = seconds();
    is_measured_ = true;
    return !told(report_) &&
           end(Status::cancelled, "Cancelled. The shape is that of the last iteration, not an equilibrium.");
}

std::string Solver::limit_message(const std::string &limit, const std::string &advice) const {
    return equilibrium_->is_hidden_by_rounding(goal_.tolerance)
               ? rounding_message(report_)
               : "Stopped at " + limit + ". " +
                     missed_message(report_, options_.tolerance, options_.accuracy) + " " + advice;
}

bool Solver::has_run_away() const {
    return report_.iteration > 0 && !(x_.cwiseAbs().maxCoeff() < runaway_growth_of(*scene_) * extent_);
}

bool Solver::has_moved_as_a_whole() const {
    double longest = 0;
    for (const auto &[i, j] : scene_->net().members())
        longest = std::max(longest, (x_.row(j) - x_.row(i)).norm());
    return longest < extent_;
}

bool Solver::end_or_look_for_limit() {
    if (has_moved_as_a_whole())
        return end(
            Status::no_equilibrium,
            "No equilibrium: the net moves away as a whole. Its supports are too weak, or leave it free "
            "in a direction in which a load acts: hold it there.");
    if (!load_limit_)
        load_limit_ = std::make_unique<LoadLimitSearch>(
            scene_, scene_->on_supports(scene_->scale().to_local(scene_->net().nodes())), levels_);
    const bool must_end = report_.iteration >= iteration_limit() || seconds() >= options_.max_seconds;
    if (load_limit_->has_ended() || must_end)
        return end(Status::no_equilibrium, load_limit_->message());
    return false;
}

/// Makes a step of the search for the load that the net can carry; goes on from its last shape where that is
/// the whole.
bool Solver::look_for_limit() {
    ++report_.iteration;
    if (load_limit_->step() && load_limit_->carried() == 1) {
        x_ = load_limit_->shape();
        equilibrium_->evaluate(x_);
        use(Method::newton);
        is_measured_ = false;
        return false;
    }
    report_.seconds = seconds();
    return !told(report_) &&
           end(Status::cancelled, "Cancelled. The net has no equilibrium under its loads, or "
                                  "none was found.");
}

/// Ends the solve at an equilibrium, unless that is one in the wrong sign that can be left. With struts,
/// which only two-way members can be, a net has several equilibria; meant is the one that the start shape
/// leads to, and not one that coarser nets did.
bool Solver::end_converged() {
    if (!levels_.empty() && count_pushing(x_, *equilibrium_) > 0) {
        levels_ = {};
        if (!iteration_->has_begun_anew()) {
            x_ = start_;
            equilibrium_->evaluate(x_);
            use(Method::newton);
            is_measured_ = false;
            return measure();
        }
    }
    instability_ = find_instability(x_, *equilibrium_);
    if (!instability_ || !instability_->way_out)
        return end(Status::converged, equilibrium_message(x_, *equilibrium_, report_, goal_.tolerance,
                                                          instability_.has_value()));
    if (report_.iteration >= iteration_limit())
        return end(Status::iteration_limit, unstable_message(steps_text(iteration_limit())));
    if (seconds() >= options_.max_seconds)
        return end(Status::time_limit, unstable_message(seconds_text(options_.max_seconds)));
    if (departures_ >= most_departures)
        return end(Status::iteration_limit,
                   unstable_message("the limit of " + std::to_string(most_departures) +
                                    " attempts to find a stable shape"));
    return false;
}

/// Whether the relaxation that follows where Newton's method found no step has come to nothing either.
bool Solver::has_stalled() {
    if (method_ != Method::relaxation || options_.method == Method::relaxation)
        return false;
    if (report_.residual <= halved_.residual / 2)
        halved_ = report_;
    return report_.iteration - halved_.iteration >= most_steps_to_halve;
}

bool Solver::end_if_decided() {
    const bool is_near = report_.position_error <= options_.accuracy;
    if (is_near && equilibrium_->significant_residual() <= goal_.tolerance)
        return end_converged();
    if (is_near && equilibrium_->is_hidden_by_rounding(goal_.tolerance))
        return end(Status::iteration_limit, rounding_message(report_));
    if (has_run_away())
        return end_or_look_for_limit();
    if (report_.iteration >= iteration_limit())
        return end(Status::iteration_limit, limit_message(steps_text(iteration_limit()), allow_more));
    if (seconds() >= options_.max_seconds)
        return end(Status::time_limit, limit_message(seconds_text(options_.max_seconds), allow_more));
    return has_stalled() &&
           end(Status::iteration_limit,
               limit_message(
                   "a shape from which Newton's method found no step that lowers the residual, and " +
                       std::to_string(most_steps_to_halve) + " steps of relaxation have not halved it",
                   try_else));
}

long Solver::iteration_limit() const {
    if (options_.max_iterations)
        return *options_.max_iterations;
    if (method_ == Method::newton)
        return most_newton_steps;
    return options_.method == Method::relaxation ? most_relaxation_steps : most_steps_after_newton;
}

bool Solver::make_move() {
    if (has_run_away())
        return look_for_limit();
    if (instability_) {
        leave_along(*instability_->way_out, x_, *equilibrium_);
        instability_.reset();
        ++departures_;
        use(method_);
        ++report_.iteration;
        is_measured_ = false;
        return false;
    }
    if (iteration_->move(x_, *equilibrium_) == Iteration::Move::impossible) {
        const bool only_accuracy_is_missing = report_.residual <= goal_.tolerance;
        if (options_.method != Method::automatic || only_accuracy_is_missing)
            return end(Status::iteration_limit,
                       limit_message(
                           "the limit of what Newton's method can do (no step from here lowers the residual)",
                           try_else));
        use(Method::relaxation);
        halved_ = report_;
        iteration_->move(x_, *equilibrium_);
    }
    ++report_.iteration;
    is_measured_ = false;
    return false;
}

Result Solver::result() const {
    const std::scoped_lock lock(working_);
    const Scale &scale = scene_->scale();
    Result result;
    result.nodes = scale.to_metres(x_);
    result.centred_nodes = x_ * scale.length;
    scene_->axial().tensions(x_, result.member_forces);
    result.member_forces *= -scale.force;
    result.member_lengths.resize(scene_->net().member_count());
    for (Index e = 0; e < scene_->net().member_count(); ++e) {
        const auto [i, j] = scene_->net().members()[e];
        result.member_lengths[e] = (x_.row(j) - x_.row(i)).norm() * scale.length;
    }
    result.reactions = reactions_at(x_, *equilibrium_);
    result.residual = report_.residual;
    result.position_error = report_.position_error;
    result.iterations = report_.iteration;
    result.seconds = seconds();
    result.status = status_.value_or(Status::iteration_limit);
    result.method = method_;
    result.message = status_ ? message_ : "Not finished: call advance again.";
    result.tolerance = options_.tolerance;
    result.accuracy = options_.accuracy;
    result.history = history_;
    result.costs = equilibrium_->costs();
    return result;
}

Result solve(std::shared_ptr<const Scene> scene, SolveOptions options) {
    Solver solver(std::move(scene), std::move(options));
    solver.advance();
    return solver.result();
}

} // namespace funicular
