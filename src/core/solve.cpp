// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solve.hpp"

#include "errors.hpp"
#include "newton.hpp"
#include "relaxation.hpp"
#include "text.hpp"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace funicular {

namespace {

constexpr long most_newton_steps = 1000;
constexpr long most_relaxation_steps = 10'000'000;
constexpr double seconds_between_reports = 0.01;
constexpr std::size_t longest_history = 4096;
// A net that has grown to this many times its size has no equilibrium that anyone would build.
constexpr double runaway_growth = 1e4;

double clock_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void check(const Scene &scene, const SolveOptions &options) {
    if (!(options.accuracy > 0))
        throw InvalidInput("accuracy must be positive, in metres");
    if (!(options.tolerance > 0))
        throw InvalidInput("tolerance must be positive (a residual relative to the mean nodal load)");
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

/// Moves supported nodes to where their supports let them be.
Points on_supports(const Scene &scene, const Points &local) {
    const Points anchors = scene.scale().to_local(scene.net().nodes());
    const Points from_anchors = local - anchors;
    Eigen::VectorXd along_freedoms;
    scene.freedoms().reduce(from_anchors, along_freedoms);
    Points motion(local.rows(), 3);
    scene.freedoms().expand(along_freedoms, motion);
    return anchors + motion;
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

std::string limit_message(const std::string &limit, const Report &report) {
    return "Stopped at the limit of " + limit + " with a relative residual of " + to_text(report.residual) +
           ": this is not an equilibrium. Allow more, or ask for less accuracy.";
}

} // namespace

Solver::Solver(std::shared_ptr<const Scene> scene, SolveOptions options)
    : scene_(std::move(scene)), options_(std::move(options)) {
    if (!scene_)
        throw InvalidInput("scene is missing: give a Scene");
    check(*scene_, options_);
    begin(scene_->scale().to_local(options_.start ? *options_.start : scene_->net().nodes()));
}

void Solver::begin(const Points &local_start) {
    goal_ = {.tolerance = options_.tolerance, .accuracy = options_.accuracy / scene_->scale().length};
    equilibrium_ = std::make_unique<Equilibrium>(scene_);
    x_ = on_supports(*scene_, local_start);
    equilibrium_->evaluate(x_);
    report_ = {};
    history_.clear();
    history_stride_ = 1;
    seconds_before_ = 0;
    last_told_ = -std::numeric_limits<double>::infinity();
    is_measured_ = false;
    status_.reset();
    use(options_.method == Method::relaxation ? Method::relaxation : Method::newton);
    publish();
}

void Solver::use(Method method) {
    method_ = method;
    if (method == Method::relaxation)
        iteration_ = std::make_unique<Relaxation>(*equilibrium_);
    else
        iteration_ = std::make_unique<Newton>(*equilibrium_);
}

void Solver::replace(std::shared_ptr<const Scene> scene) {
    if (!scene)
        throw InvalidInput("scene is missing: give a Scene");
    if (scene->net().node_count() != x_.rows())
        throw InvalidInput("scene has " + std::to_string(scene->net().node_count()) +
                           " nodes, but the shape to go on from has " + std::to_string(x_.rows()));
    const Points shape = scene_->scale().to_metres(x_);
    scene_ = std::move(scene);
    begin(scene_->scale().to_local(shape));
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

bool Solver::end_if_decided() {
    if (Iteration::residual_is_small(*equilibrium_, goal_) && report_.position_error <= options_.accuracy)
        return end(Status::converged, report_.residual <= goal_.tolerance
                                          ? "In equilibrium."
                                          : "In equilibrium as far as rounding lets one tell: the members "
                                            "are too stiff for a smaller residual.");
    const double size = scene_->net().size() / scene_->scale().length;
    if (!(x_.cwiseAbs().maxCoeff() < runaway_growth * size))
        return end(Status::no_equilibrium,
                   "No equilibrium: the net grows without bound, as its weight is too large for its "
                   "stiffness. Raise the axial stiffness, or lower the weights.");
    const long limit = options_.max_iterations.value_or(method_ == Method::relaxation ? most_relaxation_steps
                                                                                      : most_newton_steps);
    if (report_.iteration >= limit)
        return end(Status::iteration_limit, limit_message(std::to_string(limit) + " iterations", report_));
    if (seconds() >= options_.max_seconds)
        return end(Status::time_limit, limit_message(to_text(options_.max_seconds) + " seconds", report_));
    return false;
}

bool Solver::make_move() {
    if (iteration_->move(x_, *equilibrium_) == Iteration::Move::impossible) {
        if (options_.method != Method::automatic)
            return end(Status::iteration_limit, "Newton's method found no step that lowers the residual of " +
                                                    to_text(report_.residual) +
                                                    ". Use method \"auto\" or \"relaxation\".");
        use(Method::relaxation);
        iteration_->move(x_, *equilibrium_);
    }
    ++report_.iteration;
    is_measured_ = false;
    return false;
}

Result Solver::result() const {
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
