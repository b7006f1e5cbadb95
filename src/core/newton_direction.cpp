// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton_direction.hpp"

#include "kept_factor.hpp"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace funicular {

namespace {

// The notional pull that stands in where members give no stiffness (a flat sheet, a slack member), as part of
// the force density that carries the whole load over the net's size. It fades with the residual, so that
// Newton's method keeps its order.
constexpr double notional_pull = 0.1;
constexpr double least_pull = 1e-10;

// Near equilibrium the negative stiffness of members that push belongs into the tangent; farther off it leads
// astray.
constexpr double near_equilibrium = 0.1;
// Below this residual a failed iteration is worth a direct factorisation of the unsymmetric tangent.
constexpr double close_to_equilibrium = 1e-3;

constexpr double most_of_residual = 0.1;
constexpr double aim = 0.3;
constexpr double finest_accuracy = 1e-6;
constexpr double coarsest_accuracy = 0.1;
// A factor gives so many digits at once.
constexpr double accuracy_of_factor = 0.01;

constexpr int most_cycles = 40;
// What was prepared where the relative residual was below this is of use to the end, unless so many
// iterations say otherwise.
constexpr double residual_to_keep = 0.3;
constexpr double residual_to_try_kept = 1;
constexpr int most_with_kept = 15;
constexpr int most_with_new_factor = 60;
constexpr int most_to_keep = 8;

double notional_force_density(const Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const double whole_load = equilibrium.mean_nodal_load() * scene.net().node_count();
    const double size = scene.net().size() / scene.scale().length;
    const double part = std::clamp(equilibrium.relative_residual(), least_pull, 1.0);
    // Without any load the stiffness itself is the measure.
    return notional_pull * part * (whole_load > 0 ? whole_load / size : scene.axial().stiffness().mean());
}

/// How exactly to solve for a step, as part of the residual: no better than the step itself can be, as the
/// tangent changes along it, nor than the goal asks for.
double wished_accuracy(double relative, double tolerance) {
    return std::clamp(std::max(most_of_residual * relative, aim * tolerance / relative), finest_accuracy,
                      coarsest_accuracy);
}

} // namespace

NewtonDirection::NewtonDirection(const Equilibrium &equilibrium)
    : preconditioner_(std::make_unique<KeptFactor>(equilibrium)), is_factor_(true) {}

NewtonDirection::NewtonDirection(std::unique_ptr<Preconditioner> preconditioner)
    : preconditioner_(std::move(preconditioner)), is_factor_(false) {}

void NewtonDirection::compute(const Points &x, Equilibrium &equilibrium, const Goal &goal) {
    const Eigen::VectorXd &residual = equilibrium.residual();
    const double floor = notional_force_density(equilibrium);
    floor_ = floor;
    double accuracy = wished_accuracy(equilibrium.relative_residual(), goal.tolerance);
    is_newton_step_ = false;
    motion_.resize(x.rows(), 3);
    if (!is_factor_) {
        const bool is_kept = prepared_at_ < residual_to_keep && progress_.iterations <= most_to_keep;
        is_newton_step_ = is_kept && iterate(x, equilibrium, floor, accuracy, most_with_kept);
        if (!is_newton_step_) {
            equilibrium.linearise(x, {.floor = floor, .convex = true});
            prepared_at_ = equilibrium.relative_residual();
            is_newton_step_ = preconditioner_->prepare(x, equilibrium, floor) &&
                              iterate(x, equilibrium, floor, accuracy, most_cycles);
        }
        if (!is_newton_step_) {
            preconditioner_ = std::make_unique<KeptFactor>(equilibrium);
            is_factor_ = true;
        }
    }
    if (is_factor_) {
        accuracy = std::min(accuracy, accuracy_of_factor);
        // Far off, the next step's tangent is another one altogether.
        if (!is_stale_ && equilibrium.relative_residual() < residual_to_try_kept)
            is_newton_step_ = iterate(x, equilibrium, floor, accuracy, most_with_kept);
        if (!is_newton_step_) {
            const bool is_prepared = prepare_factor(x, equilibrium, floor);
            if (is_prepared)
                is_newton_step_ = iterate(x, equilibrium, floor, accuracy, most_with_new_factor);
            if (!is_newton_step_ && equilibrium.relative_residual() < close_to_equilibrium)
                is_newton_step_ = solve_directly(x, equilibrium, floor);
            if (!is_newton_step_ && is_prepared)
                preconditioner_->apply(residual, direction_);
            else if (!is_newton_step_)
                direction_.setZero(residual.size());
        }
        is_stale_ = !is_newton_step_ || progress_.iterations > most_to_keep;
    }
    equilibrium.scene().freedoms().expand(direction_, motion_);
    largest_motion_ = motion_.rowwise().norm().maxCoeff();
}

/// Positive definite in exact arithmetic; rounding may ask for a larger pull in the factor, which only
/// preconditions.
bool NewtonDirection::prepare_factor(const Points &x, Equilibrium &equilibrium, double floor) {
    double pull = floor;
    for (int attempt = 0; attempt < 12; ++attempt, pull *= 100) {
        equilibrium.linearise(x, {.floor = pull, .convex = true});
        if (preconditioner_->prepare(x, equilibrium, pull))
            return true;
    }
    return false;
}

bool NewtonDirection::iterate(const Points &x, Equilibrium &equilibrium, double floor, double accuracy,
                              int most_iterations) {
    const Eigen::VectorXd &residual = equilibrium.residual();
    equilibrium.linearise(x, {.floor = floor, .convex = equilibrium.relative_residual() > near_equilibrium});
    equilibrium.linearise_loads(x);
    direction_.setZero(residual.size());
    progress_ = equations_.solve(x, equilibrium, TangentEquations::Loads::following, *preconditioner_,
                                 residual, accuracy, most_iterations, direction_);
    // Beyond the limit of existence, or at a saddle, the full tangent points downhill.
    return progress_.residual <= accuracy && direction_.allFinite() &&
           (residual.dot(direction_) > 0 || residual.squaredNorm() == 0);
}

bool NewtonDirection::solve_directly(const Points &x, Equilibrium &equilibrium, double floor) {
    const Eigen::VectorXd &residual = equilibrium.residual();
    BlockMatrix blocks(equilibrium.coupling());
    equilibrium.tangent(x, {.floor = floor, .convex = false}, blocks);
    // A column-major result would be the transpose.
    Eigen::SparseMatrix<double, Eigen::RowMajor> tangent;
    blocks.reduce(equilibrium.scene().freedoms(), tangent);
    Eigen::SparseLU<Eigen::SparseMatrix<double>> direct(tangent);
    if (direct.info() != Eigen::Success)
        return false;
    direction_ = direct.solve(residual);
    return direct.info() == Eigen::Success && direction_.allFinite() && residual.dot(direction_) > 0;
}

} // namespace funicular
