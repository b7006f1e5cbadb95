// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton_direction.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace funicular {

namespace {

// The notional pull that stands in where members give no stiffness (a flat sheet, a slack member), as part of
// the force density that carries the whole load over the net's size. It fades with the residual, so that
// Newton's method keeps its order.
constexpr double notional_pull = 0.1;
constexpr double least_pull = 1e-10;
// What holds a net that its supports let slide or turn as a whole, as part of the notional pull. Small enough
// not to bend the smooth modes of a net of a thousand members across.
constexpr double notional_ground = 1e-6;

// Near equilibrium the negative stiffness of members that push belongs into the tangent; farther off it leads
// astray.
constexpr double near_equilibrium = 0.1;
// Below this residual a failed iteration is worth a direct factorisation of the unsymmetric tangent.
constexpr double close_to_equilibrium = 1e-3;

double notional_force_density(const Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const double whole_load = equilibrium.mean_nodal_load() * scene.net().node_count();
    const double size = scene.net().size() / scene.scale().length;
    const double part = std::clamp(equilibrium.relative_residual(), least_pull, 1.0);
    // Without any load the stiffness itself is the measure.
    return notional_pull * part * (whole_load > 0 ? whole_load / size : scene.axial().stiffness().mean());
}

/// Lets an iterative solver of Eigen's use a factorisation as its preconditioner.
class Preconditioner {
public:
    void use(const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> &factor) { factor_ = &factor; }
    template <class Matrix>
    Preconditioner &analyzePattern(const Matrix & /*matrix*/) {
        return *this;
    }
    template <class Matrix>
    Preconditioner &factorize(const Matrix & /*matrix*/) {
        return *this;
    }
    template <class Matrix>
    Preconditioner &compute(const Matrix & /*matrix*/) {
        return *this;
    }
    template <class Vector>
    [[nodiscard]] Eigen::VectorXd solve(const Vector &right) const {
        return factor_->solve(right);
    }
    [[nodiscard]] static Eigen::ComputationInfo info() { return Eigen::Success; }

private:
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> *factor_ = nullptr;
};

} // namespace

NewtonDirection::NewtonDirection(const Equilibrium &equilibrium)
    : member_blocks_(equilibrium.member_coupling()), full_blocks_(equilibrium.coupling()),
      motion_(equilibrium.scene().net().node_count(), 3) {}

void NewtonDirection::compute(const Points &x, Equilibrium &equilibrium) {
    const Eigen::VectorXd &residual = equilibrium.residual();
    const double floor = notional_force_density(equilibrium);
    // Positive definite in exact arithmetic; rounding may ask for a larger pull in the factor, which only
    // preconditions.
    is_newton_step_ = false;
    direction_.setZero(residual.size());
    double pull = floor;
    for (int attempt = 0; attempt < 12; ++attempt, pull *= 100)
        if (factorise(x, equilibrium, pull)) {
            direction_ = factor_.solve(residual);
            is_newton_step_ = solve_full_tangent(x, equilibrium, floor);
            break;
        }

    equilibrium.scene().freedoms().expand(direction_, motion_);
    largest_motion_ = motion_.rowwise().norm().maxCoeff();
}

bool NewtonDirection::factorise(const Points &x, Equilibrium &equilibrium, double floor) {
    equilibrium.member_tangent(x, {.floor = floor, .convex = true}, member_blocks_);
    // Symmetric, so that column-major storage holds the matrix itself.
    member_blocks_.reduce(equilibrium.scene().freedoms(), member_tangent_);
    for (Index unknown = 0; unknown < member_tangent_.rows(); ++unknown)
        member_tangent_.coeffRef(unknown, unknown) += notional_ground * floor;
    if (!analysed_) {
        factor_.analyzePattern(member_tangent_);
        analysed_ = true;
    }
    factor_.factorize(member_tangent_);
    return factor_.info() == Eigen::Success && (factor_.vectorD().array() > 0).all();
}

bool NewtonDirection::solve_full_tangent(const Points &x, Equilibrium &equilibrium, double floor) {
    const Eigen::VectorXd &residual = equilibrium.residual();
    const double relative = equilibrium.relative_residual();
    equilibrium.tangent(x, {.floor = floor, .convex = relative > near_equilibrium}, full_blocks_);
    full_blocks_.reduce(equilibrium.scene().freedoms(), full_tangent_);

    Eigen::BiCGSTAB<Eigen::SparseMatrix<double, Eigen::RowMajor>, Preconditioner> iteration;
    iteration.preconditioner().use(factor_);
    iteration.setTolerance(std::clamp(0.1 * relative, 1e-9, 1e-2));
    iteration.setMaxIterations(60);
    iteration.compute(full_tangent_);
    Eigen::VectorXd full = iteration.solveWithGuess(residual, direction_);
    bool solved = iteration.info() == Eigen::Success && full.allFinite();
    if (!solved && relative < close_to_equilibrium) {
        Eigen::SparseLU<Eigen::SparseMatrix<double>> direct(full_tangent_);
        if (direct.info() == Eigen::Success) {
            full = direct.solve(residual);
            solved = direct.info() == Eigen::Success && full.allFinite();
        }
    }
    if (!solved)
        return false;
    // Beyond the limit of existence, or at a saddle, the full tangent points downhill.
    if (residual.dot(full) <= 0 && residual.squaredNorm() > 0)
        return false;
    direction_ = full;
    return true;
}

} // namespace funicular
