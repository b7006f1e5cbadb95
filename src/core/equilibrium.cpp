// SPDX-License-Identifier: LGPL-2.1-or-later
#include "equilibrium.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace funicular {

Equilibrium::Equilibrium(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), costs_(scene_->acting().size()), forces_(scene_->net().node_count(), 3),
      loads_(scene_->net().node_count(), 3) {
    std::vector<double> summed(scene_->net().node_count(), 0.0);
    for (Index e = 0; e < scene_->net().member_count(); ++e)
        for (const Index end : scene_->net().members()[e])
            summed[end] += scene_->axial().stiffness()[e];
    for (const auto &support : scene_->elastic_supports())
        summed[support.node] += support.stiffness.diagonal().maxCoeff();
    stiffest_node_ = *std::max_element(summed.begin(), summed.end());
}

template <class Work>
void Equilibrium::timed(std::size_t effect, const Work &work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    ++costs_[effect].evaluations;
    costs_[effect].seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
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
    for (const auto &support : scene_->elastic_supports())
        forces_.row(support.node) -=
            (support.stiffness * (x.row(support.node).transpose() - support.anchor)).transpose();
    measure_residual(x);
}

void Equilibrium::measure_residual(const Points &x) {
    const Freedoms &freedoms = scene_->freedoms();
    freedoms.reduce(forces_, residual_);
    const Index node_count = scene_->net().node_count();

    mean_nodal_load_ = loads_.rowwise().norm().sum() / node_count;
    if (mean_nodal_load_ == 0) {
        Eigen::VectorXd tensions;
        scene_->axial().tensions(x, tensions);
        mean_nodal_load_ = tensions.cwiseAbs().mean();
    }
    double worst = 0;
    for (Index node = 0; node < node_count; ++node)
        worst = std::max(worst, residual_.segment(freedoms.offset(node), freedoms.count(node)).squaredNorm());
    worst = std::sqrt(worst);
    relative_residual_ = worst == 0 ? 0 : worst / mean_nodal_load_;

    constexpr double units_in_last_place = 4;
    rounding_floor_ = mean_nodal_load_ == 0 ? 0
                                            : units_in_last_place * std::numeric_limits<double>::epsilon() *
                                                  stiffest_node_ * x.cwiseAbs().maxCoeff() / mean_nodal_load_;
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

void Equilibrium::add_costs_of(const Equilibrium &other) {
    for (std::size_t k = 0; k < costs_.size(); ++k) {
        costs_[k].evaluations += other.costs_[k].evaluations;
        costs_[k].seconds += other.costs_[k].seconds;
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
