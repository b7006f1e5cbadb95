// SPDX-License-Identifier: LGPL-2.1-or-later
#include "existence.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace funicular {

namespace {

constexpr int most_steps_of_trial = 60;
// Enough to tell an equilibrium from the narrow place that is left of one just beyond the limit.
constexpr double residual_of_trial = 1e-4;
constexpr double error_of_trial = 1e-3;
constexpr double first_part = 0.25;
// No part of the loads worth naming.
constexpr double least_part = 1e-12;
// The search ends when the smallest part refused is this many times the largest part carried.
constexpr double narrow_bracket = 1.02;
constexpr double narrow_bracket_of_large_net = 1.05;
constexpr Index large_net = 20'000;
// A refusal stands if it was tried from a shape that carries this part of it.
constexpr double close_below = 0.9;
// A net that has grown so much at the limit deserves a word about it.
constexpr double notable_growth = 10;

/// Three significant digits, none of them rounded up: what is said to be carried is.
double rounded_down(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
    return std::floor(value / unit * (1 + 1e-12)) * unit;
}

double rounded_up(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
    return std::ceil(value / unit * (1 - 1e-12)) * unit;
}

std::string plain(double value) {
    // Exponents only where zeros would have to be counted.
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), value >= 1000 && value < 1e7 ? "%.0f" : "%.3g", value);
    return buffer.data();
}

/// A load and its name, in the unit of its description.
struct NamedLoad {
    std::string name, unit;
    double value;

    [[nodiscard]] std::string text() const { return name + " " + plain(value) + " " + unit; }
    [[nodiscard]] std::string text_of(double part) const {
        return plain(rounded_down(part * value)) + " " + unit;
    }
};

std::vector<NamedLoad> named_loads(const Scene &scene) {
    std::vector<NamedLoad> loads;
    for (const auto &effect : scene.effects()) {
        if (const auto *members = std::get_if<MemberWeight>(&effect))
            loads.push_back({"member weight", "kg/m", members->per_length});
        else if (const auto *covering = std::get_if<CoveringWeight>(&effect))
            loads.push_back({"covering weight", "kg/m²", covering->per_area});
        else if (const auto *snow = std::get_if<Snow>(&effect))
            loads.push_back({"snow", "N/m²", snow->pressure});
        else if (const auto *point = std::get_if<PointLoad>(&effect))
            loads.push_back({point->nodes.size() == 1 ? "point load" : "point loads of", "N",
                             point->force.stableNorm()});
    }
    return loads;
}

std::string stiffness_text(double value, bool per_spring) {
    std::string prefix;
    if (value >= 1e6) {
        value /= 1e6;
        prefix = "M";
    } else if (value >= 1e3) {
        value /= 1e3;
        prefix = "k";
    }
    return (per_spring ? "k = " : "EA = ") + plain(value) + " " + prefix + (per_spring ? "N/m" : "N");
}

} // namespace

LoadLimitSearch::LoadLimitSearch(std::shared_ptr<const Scene> scene, Points start)
    : scene_(std::move(scene)), start_(std::move(start)),
      extent_(std::max(start_.cwiseAbs().maxCoeff(), scene_->net().size() / scene_->scale().length)) {
    try_part(first_part);
}

void LoadLimitSearch::try_part(double part) {
    part_ = part;
    // Where weights and stiffness are large, the start is that of a light net, which is nearly as it was cut.
    x_ = carried_ > 0 ? shape_ : start_;
    newton_.reset();
    equilibrium_ = std::make_unique<Equilibrium>(std::make_shared<const Scene>(scene_->with_loads_times(part)));
    equilibrium_->evaluate(x_);
    newton_ = std::make_unique<Newton>(*equilibrium_);
    steps_of_trial_ = 0;
}

bool LoadLimitSearch::step() {
    if (has_ended_)
        return true;
    const double size = x_.cwiseAbs().maxCoeff();
    const double error = newton_->position_error(x_, *equilibrium_, {});
    ++steps_;
    if (equilibrium_->significant_residual() <= residual_of_trial && error <= error_of_trial * size)
        end_trial(true);
    else if (!(size < runaway_growth * extent_) || ++steps_of_trial_ > most_steps_of_trial ||
             newton_->move(x_, *equilibrium_) == Iteration::Move::impossible)
        end_trial(false);
    return has_ended_ = has_ended_ || steps_ >= most_steps;
}

void LoadLimitSearch::end_trial(bool is_carried) {
    if (is_carried) {
        // What was refused from farther below may be no limit at all.
        if (part_ >= refused_) {
            refused_ = 1;
            refused_from_ = 0;
        }
        carried_ = part_;
        shape_ = x_;
    } else {
        refused_ = part_;
        refused_from_ = carried_;
    }

    if (carried_ >= 1 || refused_ < least_part) {
        has_ended_ = true;
        return;
    }
    if (carried_ == 0)
        return try_part(refused_ * refused_);
    const double narrow =
        scene_->net().node_count() < large_net ? narrow_bracket : narrow_bracket_of_large_net;
    if (refused_ > narrow * carried_)
        return try_part(std::sqrt(carried_ * refused_));
    if (refused_from_ < close_below * refused_)
        return try_part(refused_);
    has_ended_ = true;
}

std::string LoadLimitSearch::message() const {
    const auto loads = named_loads(*scene_);
    if (carried_ == 0 || carried_ == 1 || loads.empty())
        return "No equilibrium: the net grows without bound, as its weight is too large for its stiffness. "
               "Raise the axial stiffness, or lower the weights.";
    const AxialStiffness *axial = nullptr;
    for (const auto &effect : scene_->effects())
        if (const auto *found = std::get_if<AxialStiffness>(&effect))
            axial = found;
    const bool is_uniform = axial->stiffness.minCoeff() == axial->stiffness.maxCoeff();
    const std::string stiffness =
        is_uniform ? "stiffness " + stiffness_text(axial->stiffness[0], axial->per_spring)
                   : "the members' stiffness";

    std::string text = "No equilibrium: ";
    if (loads.size() == 1) {
        text += loads[0].text() + " is beyond what " + stiffness + " can carry; at most about " +
                loads[0].text_of(carried_);
    } else {
        text += "the loads are " + to_text(1 / carried_) + " times what " + stiffness +
                " can carry; at most about " + plain(rounded_down(100 * carried_)) + " % of them: ";
        for (std::size_t k = 0; k < loads.size(); ++k)
            text += (k > 0 ? ", " : "") + loads[k].name + " " + loads[k].text_of(carried_);
    }
    const double growth = shape_.cwiseAbs().maxCoeff() / extent_;
    if (growth > notable_growth)
        text += ", where the net has grown to " + to_text(growth) + " times its size";
    text += ".";
    // With the same loads over stiffness a net has the same shape, unless a support yields.
    if (scene_->elastic_supports().empty())
        text += is_uniform ? " Or raise the axial stiffness to at least about " +
                                 stiffness_text(rounded_up(axial->stiffness[0] / carried_), axial->per_spring) +
                                 "."
                           : " Or raise the axial stiffness to at least about " +
                                 plain(rounded_up(1 / carried_)) + " times what it is.";
    return text;
}

} // namespace funicular
