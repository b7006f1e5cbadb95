// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene.hpp"

#include "effects/axial.hpp"
#include "effects/covering_weight.hpp"
#include "effects/member_weight.hpp"
#include "effects/point_load.hpp"
#include "effects/snow.hpp"
#include "errors.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace funicular {

namespace {

bool is_absent(const AxialStiffness & /*effect*/) {
    return false;
}
bool is_absent(const MemberWeight &effect) {
    return effect.per_length == 0;
}
bool is_absent(const CoveringWeight &effect) {
    return effect.per_area == 0;
}
bool is_absent(const PointLoad &effect) {
    return effect.nodes.empty() || effect.force == Vector3::Zero();
}
bool is_absent(const Snow &effect) {
    return effect.pressure == 0;
}

void multiply_load(AxialStiffness & /*effect*/, double /*factor*/) {}
void multiply_load(MemberWeight &effect, double factor) {
    effect.per_length *= factor;
}
void multiply_load(CoveringWeight &effect, double factor) {
    effect.per_area *= factor;
}
void multiply_load(PointLoad &effect, double factor) {
    effect.force *= factor;
}
void multiply_load(Snow &effect, double factor) {
    effect.pressure *= factor;
}

std::shared_ptr<const Net> existing(std::shared_ptr<const Net> net) {
    if (!net)
        throw InvalidInput("net is missing: give a Net");
    return net;
}

Eigen::VectorXd checked_rest_lengths(const Net &net, std::optional<Eigen::VectorXd> given) {
    if (!given)
        return net.source_lengths();
    if (given->size() != net.member_count())
        throw InvalidInput("rest_lengths has " + std::to_string(given->size()) + " values, but the net has " +
                           std::to_string(net.member_count()) + " members");
    for (Index e = 0; e < given->size(); ++e)
        if (!((*given)[e] >= 0) || !std::isfinite((*given)[e]))
            throw InvalidInput("rest_lengths[" + std::to_string(e) +
                               "] must be zero or positive and finite, in metres");
    return *std::move(given);
}

/// A rough nodal load [N], for the unit of force; no geometry is computed for it that the effects would not
/// need.
double rough_nodal_load(const Net &net, const std::vector<EffectDescription> &effects) {
    double load = 0;
    double stiffest = 0;
    for (const auto &effect : effects) {
        if (const auto *members = std::get_if<MemberWeight>(&effect))
            load += standard_gravity * members->per_length * net.source_lengths().sum();
        else if (const auto *covering = std::get_if<CoveringWeight>(&effect))
            load += standard_gravity * covering->per_area * net.size() * net.size();
        else if (const auto *snow = std::get_if<Snow>(&effect))
            load += snow->pressure * net.size() * net.size();
        else if (const auto *point = std::get_if<PointLoad>(&effect))
            load += point->force.stableNorm() * static_cast<double>(point->nodes.size());
        else if (const auto *axial = std::get_if<AxialStiffness>(&effect);
                 axial && axial->stiffness.size() > 0)
            stiffest = axial->stiffness.maxCoeff();
    }
    // Without loads the members pull on one another only.
    return load > 0 ? load / net.node_count() : stiffest;
}

/// What cannot be meant as a load leaves the unit at one newton; what is wrong with it is said where it is
/// checked.
double force_unit(double rough_load) {
    return std::isfinite(rough_load) && rough_load > 0 ? power_of_two_above(rough_load) : 1;
}

} // namespace

Scene::Scene(std::shared_ptr<const Net> net, std::vector<Support> supports,
             const std::vector<EffectDescription> &effects, std::optional<Eigen::VectorXd> rest_lengths)
    : net_(existing(std::move(net))), supports_(std::move(supports)),
      rest_lengths_(checked_rest_lengths(*net_, std::move(rest_lengths))),
      scale_{.origin = net_->centre(),
             .length = power_of_two_above(net_->size()),
             .force = force_unit(rough_nodal_load(*net_, effects))},
      freedoms_(*net_, supports_) {
    check_every_component_is_held(*net_, supports_, freedoms_);

    for (const auto &effect : effects) {
        if (const auto *point = std::get_if<PointLoad>(&effect))
            PointLoads(*net_, *point, scale_); // a wrong one is an error also where it has no force
        if (std::visit([](const auto &part) { return is_absent(part); }, effect))
            continue;
        descriptions_.push_back(effect);
        if (const auto *axial = std::get_if<AxialStiffness>(&effect)) {
            if (axial_)
                throw InvalidInput("effects: AxialStiffness is given twice; members have one stiffness");
            axial_ = std::make_shared<const AxialForces>(*net_, *axial, rest_lengths_, scale_);
            acting_.insert(acting_.begin(), axial_);
        } else if (const auto *members = std::get_if<MemberWeight>(&effect)) {
            acting_.push_back(std::make_shared<const MemberLoads>(*net_, *members, scale_));
        } else if (const auto *covering = std::get_if<CoveringWeight>(&effect)) {
            acting_.push_back(std::make_shared<const CoveringLoads>(*net_, *covering, scale_));
        } else if (const auto *point = std::get_if<PointLoad>(&effect)) {
            acting_.push_back(std::make_shared<const PointLoads>(*net_, *point, scale_));
        } else if (const auto *snow = std::get_if<Snow>(&effect)) {
            acting_.push_back(std::make_shared<const SnowLoads>(*net_, *snow, scale_));
        }
    }
    if (!axial_)
        throw InvalidInput("effects: AxialStiffness is missing; members without stiffness cannot carry");
    if (!std::isfinite(rough_nodal_load(*net_, descriptions_)))
        throw InvalidInput("effects: the loads add up to more than a floating-point number holds: check the "
                           "weights, the forces and the size of the net");

    elastic_supports_ = elastic_supports_of(*net_, supports_, scale_);
}

Scene Scene::with_stiffness_up_to(double most) const {
    auto effects = descriptions_;
    for (auto &effect : effects)
        if (auto *axial = std::get_if<AxialStiffness>(&effect)) {
            // One value no longer serves all members where k is limited but given per spring.
            if (axial->stiffness.size() == 1 && axial->per_spring)
                axial->stiffness = Eigen::VectorXd::Constant(net_->member_count(), axial->stiffness[0]);
            for (Index e = 0; e < axial->stiffness.size(); ++e) {
                const double length =
                    axial->per_spring ? std::max(rest_lengths_[e], net_->source_lengths()[e]) : 1;
                axial->stiffness[e] = std::min(axial->stiffness[e], most / length);
            }
        }
    return {net_, supports_, effects, rest_lengths_};
}

Points Scene::on_supports(const Points &local) const {
    const Points anchors = scale_.to_local(net_->nodes());
    Eigen::VectorXd along_freedoms;
    freedoms_.reduce(local - anchors, along_freedoms);
    Points motion(local.rows(), 3);
    freedoms_.expand(along_freedoms, motion);
    return anchors + motion;
}

Scene Scene::with_loads_times(double factor) const {
    if (!(factor >= 0))
        throw InvalidInput("factor of the loads must be zero or positive");
    auto effects = descriptions_;
    for (auto &effect : effects)
        std::visit([factor](auto &part) { multiply_load(part, factor); }, effect);
    return {net_, supports_, effects, rest_lengths_};
}

} // namespace funicular
