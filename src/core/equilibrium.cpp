// SPDX-License-Identifier: LGPL-2.1-or-later
#include "equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace funicular {

namespace {

// What rounding may excuse at a node: so many units in the last place of the largest coordinate, turned into
// forces by all members and supports there, but never more than a part of the mean nodal load. Half of what
// the certificate excuses, which rounds in its own way, so that it need not deny what is called converged.
constexpr double units_in_last_place = 4;
constexpr double most_excused_residual = 5e-4;
// Forces in a net without loads are measured by what its members pull, or would at this strain: those that
// have gone slack pull with nothing, which is no measure.
constexpr double least_strain = 1e-6;

} // namespace

Equilibrium::Equilibrium(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), costs_(scene_->acting().size()), forces_(scene_->net().node_count(), 3),
      loads_(scene_->net().node_count(), 3) {
    nodal_stiffness_.setZero(scene_->net().node_count());
    for (Index e = 0; e < scene_->net().member_count(); ++e)
        for (const Index end : scene_->net().members()[e])
            nodal_stiffness_[end] += scene_->axial().stiffness()[e];
    // The trace bounds the largest eigenvalue whichever way the support faces.
    for (const auto &support : scene_->elastic_supports())
        nodal_stiffness_[support.node] += support.stiffness.trace();
}

void Equilibrium::evaluate(const Points &x) {
    loads_.setZero();
    const auto &acting = scene_->acting();
    for (std::size_t k = 0; k < acting.size(); ++k)
        if (acting[k]->is_load())
            timed(k, [&] { acting[k]->add_forces(x, loads_); });
    forces_ = loads_;
    for (std::size_t k = 0; k < acting.size(); ++k)
        if (!acting[k]->is_load())
            timed(k, [&] { acting[k]->add_forces(x, forces_); });
    add_elastic_supports(x, forces_);
    measure_residual(x);
}

void Equilibrium::add_elastic_supports(const Points &x, Points &forces) const {
    for (const auto &support : scene_->elastic_supports())
        forces.row(support.node) -=
            (support.stiffness * (x.row(support.node).transpose() - support.anchor)).transpose();
}

void Equilibrium::measure_residual(const Points &x) {
    const Freedoms &freedoms = scene_->freedoms();
    freedoms.reduce(forces_, residual_);
    const Index node_count = scene_->net().node_count();

    double whole_load = 0;
    Index movable = 0;
    for (Index node = 0; node < node_count; ++node)
        if (freedoms.count(node) > 0) {
            whole_load += loads_.row(node).norm();
            ++movable;
        }
    mean_nodal_load_ = movable > 0 ? whole_load / movable : 0;
    const double rounding =
        units_in_last_place * std::numeric_limits<double>::epsilon() * x.cwiseAbs().maxCoeff();
    double unit = mean_nodal_load_;
    if (mean_nodal_load_ == 0) {
        Eigen::VectorXd tensions;
        scene_->axial().tensions(x, tensions);
        const AxialForces &axial = scene_->axial();
        mean_nodal_load_ =
            std::max(tensions.cwiseAbs().mean(),
                     least_strain * axial.stiffness().cwiseProduct(axial.rest_lengths()).mean());
        // Of unstretched members it is rounding, which is no measure of itself.
        unit = std::max(mean_nodal_load_, rounding * nodal_stiffness_.maxCoeff() / most_excused_residual);
    }

    relative_residual_ = significant_residual_ = beyond_rounding_ = 0;
    if (!forces_.allFinite()) {
        relative_residual_ = significant_residual_ = beyond_rounding_ =
            std::numeric_limits<double>::infinity();
        return;
    }
    for (Index node = 0; node < node_count; ++node) {
        const double force = residual_.segment(freedoms.offset(node), freedoms.count(node)).norm();
        if (force == 0)
            continue;
        const double relative = force / unit;
        const double floor = rounding * nodal_stiffness_[node] / unit;
        relative_residual_ = std::max(relative_residual_, relative);
        if (relative > std::min(floor, most_excused_residual))
            significant_residual_ = std::max(significant_residual_, relative);
        if (relative > floor)
            beyond_rounding_ = std::max(beyond_rounding_, relative);
    }
}

Coupling Equilibrium::coupling() const {
    Coupling coupling(scene_->net().node_count());
    for (const auto &effect : scene_->acting())
        effect->couple(coupling);
    return coupling;
}

Coupling Equilibrium::member_coupling() const {
    Coupling coupling(scene_->net().node_count());
    scene_->axial().couple(coupling);
    return coupling;
}

void Equilibrium::tangent(const Points &x, AxialForces::Regularisation regularisation, BlockMatrix &tangent) {
    member_tangent(x, regularisation, tangent);
    const auto &acting = scene_->acting();
    for (std::size_t k = 0; k < acting.size(); ++k)
        if (acting[k]->is_load())
            timed(k, [&] { acting[k]->add_tangent(x, tangent); });
}

void Equilibrium::member_tangent(const Points &x, AxialForces::Regularisation regularisation,
                                 BlockMatrix &tangent) {
    tangent.set_zero();
    // The members' pull stands first among what acts.
    timed(0, [&] { scene_->axial().add_tangent(x, regularisation, tangent); });
    for (const auto &support : scene_->elastic_supports())
        tangent.add(support.node, support.node, support.stiffness);
}

void Equilibrium::linearise(const Points &x, AxialForces::Regularisation regularisation) {
    timed(0, [&] { scene_->axial().linearise(x, regularisation, member_tangents_); });
}

void Equilibrium::linearise_loads(const Points &x) {
    load_gradients_.clear();
    const auto &acting = scene_->acting();
    are_gradients_kept_.assign(acting.size(), false);
    for (std::size_t k = 0; k < acting.size(); ++k)
        if (acting[k]->is_load())
            timed(k, [&] { are_gradients_kept_[k] = acting[k]->keep_gradients(x, load_gradients_); });
}

void Equilibrium::member_product(const Points &motion, Points &product) const {
    product.setZero(motion.rows(), 3);
    const auto &members = scene_->net().members();
    for (std::size_t e = 0; e < members.size(); ++e) {
        const auto [i, j] = members[e];
        const Vector3 force = member_tangents_[e] * (motion.row(i) - motion.row(j)).transpose();
        product.row(i) += force.transpose();
        product.row(j) -= force.transpose();
    }
    for (const auto &support : scene_->elastic_supports())
        product.row(support.node) += (support.stiffness * motion.row(support.node).transpose()).transpose();
}

void Equilibrium::tangent_product(const Points &x, const Points &motion, Points &product) {
    member_product(motion, product);
    const auto &acting = scene_->acting();
    for (std::size_t k = 0; k < acting.size(); ++k)
        if (acting[k]->is_load() && !are_gradients_kept_[k])
            timed(k, [&] { acting[k]->add_tangent_product(x, motion, product); });
    for (const auto &[node, by, gradient] : load_gradients_)
        product(node, 2) -= gradient.dot(motion.row(by));
}

void Equilibrium::add_costs(const std::map<std::string, Cost> &other) {
    for (const auto &[name, cost] : other)
        for (std::size_t k = 0; k < costs_.size(); ++k)
            if (scene_->acting()[k]->name() == name) {
                costs_[k].evaluations += cost.evaluations;
                costs_[k].seconds += cost.seconds;
                break;
            }
}

std::map<std::string, Cost> Equilibrium::costs() const {
    std::map<std::string, Cost> costs;
    for (std::size_t k = 0; k < costs_.size(); ++k) {
        Cost &cost = costs[std::string(scene_->acting()[k]->name())];
        cost.evaluations += costs_[k].evaluations;
        cost.seconds += costs_[k].seconds;
    }
    return costs;
}

} // namespace funicular
