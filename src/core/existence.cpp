// SPDX-License-Identifier: LGPL-2.1-or-later
#include "existence.hpp"

#include "coarse_start.hpp"
#include "newton.hpp"
#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace funicular {

namespace {

constexpr int most_steps_of_trial = 60;
// Enough to tell an equilibrium from the narrow place that is left of one just beyond the limit.
constexpr Goal goal_of_trial{.tolerance = 1e-4, .accuracy = 1e-3};
// So small that the position error, which rounding may hide, need not be known.
constexpr double residual_of_rounding = 1e-10;
// Newton's method does not come back from so far.
constexpr double hopeless_growth = 10 * most_growth;
// Where the net grows this fast, its size settles the part to a few per cent.
constexpr double nearly_grown = 0.95;
constexpr double first_part = 0.25;
constexpr double first_descent = 4;
// No part of the loads worth naming.
constexpr double least_part = 1e-12;
// The search ends when the smallest part refused is this many times the largest part carried.
constexpr double narrow_bracket = 1.02;
// How far to go up at once: at first, and where a refusal has turned out too early.
constexpr double long_stride = 2;
constexpr double short_stride = 1.05;
// A start is extrapolated no further than from the other shape to the one carried.
constexpr double furthest_back = -1;
// From here on the whole may be carried by a net that has grown more.
constexpr double close_to_whole = 0.5;
// Growth that deserves a word.
constexpr double notable_growth = 2;

constexpr Index large_net = 1000;

constexpr double unknown = std::numeric_limits<double>::infinity();

double box_diagonal(const Points &x) {
    return (x.colwise().maxCoeff() - x.colwise().minCoeff()).norm();
}

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
            loads.push_back(
                {point->nodes.size() == 1 ? "point load" : "point loads of", "N", point->force.stableNorm()});
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

double runaway_growth_of(const Scene &scene) {
    return scene.net().node_count() < large_net ? runaway_growth : runaway_growth_of_large_net;
}

LoadLimitSearch::LoadLimitSearch(std::shared_ptr<const Scene> scene, Points start, CoarserLevels levels)
    : scene_(std::move(scene)), levels_(std::move(levels)), start_(std::move(start)),
      size_(std::max(box_diagonal(start_), scene_->net().size() / scene_->scale().length) *
            std::max(1.0, scene_->rest_lengths().sum() / scene_->net().source_lengths().sum())),
      descent_(first_descent), stride_(long_stride) {
    try_part(first_part);
}

void LoadLimitSearch::try_part(double part) {
    part_ = part;
    x_ = start_for(part);
    iteration_.reset();
    equilibrium_ =
        std::make_unique<Equilibrium>(std::make_shared<const Scene>(scene_->with_loads_times(part)));
    equilibrium_->evaluate(x_);
    if (carried_.part > 0 || levels_.empty())
        iteration_ = std::make_unique<Newton>(*equilibrium_, levels_);
    else
        iteration_ = std::make_unique<CoarseToFine>(*equilibrium_, levels_);
    steps_of_trial_ = 0;
}

Points LoadLimitSearch::start_for(double part) const {
    if (carried_.part == 0)
        return start_;
    if (other_part_ == 0)
        return shape_;
    const double way = std::log(part / carried_.part) / std::log(other_part_ / carried_.part);
    return shape_ + std::max(way, furthest_back) * (other_shape_ - shape_);
}

void LoadLimitSearch::carry(const Trial &trial) {
    other_part_ = carried_.part;
    other_shape_ = std::move(shape_);
    carried_ = trial;
    shape_ = x_;
}

double LoadLimitSearch::growth_of(const Points &x) const {
    return box_diagonal(x) / size_;
}

bool LoadLimitSearch::step() {
    if (has_ended_)
        return true;
    const double growth = growth_of(x_);
    const double error = iteration_->position_error(x_, *equilibrium_, goal_of_trial);
    ++steps_;
    if (equilibrium_->significant_residual() <= residual_of_rounding ||
        (equilibrium_->significant_residual() <= goal_of_trial.tolerance &&
         error <= goal_of_trial.accuracy * growth * size_))
        end_trial(true);
    else if (!(growth < hopeless_growth) || ++steps_of_trial_ > most_steps_of_trial ||
             iteration_->move(x_, *equilibrium_) == Iteration::Move::impossible)
        end_trial(false);
    return has_ended_ = has_ended_ || steps_ >= most_steps;
}

void LoadLimitSearch::end_trial(bool is_at_rest) {
    const Trial trial{part_, is_at_rest ? growth_of(x_) : unknown};
    if (is_at_rest && part_ == 1) {
        carry(trial);
        has_ended_ = has_found_ = true;
        return;
    }
    if (has_found_) { // the whole was tried for the last time
        has_ended_ = true;
        return;
    }
    if (trial.growth <= most_growth) {
        carry(trial);
        // What was refused without a start, or from farther below, may be no limit at all.
        if (refused_from_ == 0 || part_ >= refused_.part) {
            refused_ = {std::min(1.0, stride_ * part_), unknown};
            refused_from_ = 0;
        }
    } else {
        refused_ = trial;
        refused_from_ = is_at_rest ? part_ : carried_.part;
        if (is_at_rest) {
            other_part_ = part_;
            other_shape_ = x_;
        }
        if (!is_at_rest && carried_.part > 0)
            stride_ = short_stride;
    }
    try_next();
}

void LoadLimitSearch::try_next() {
    if (carried_.part == 0) {
        const double lower = refused_.part / descent_;
        descent_ *= descent_;
        if (lower < least_part)
            has_ended_ = true;
        else
            try_part(lower);
        return;
    }
    if (carried_.growth < nearly_grown * most_growth) {
        if (refused_from_ == 0)
            return try_part(refused_.part);
        if (refused_.part > narrow_bracket * carried_.part)
            return try_part(part_between());
        if (refused_from_ * narrow_bracket < refused_.part)
            return try_part(refused_.part);
    }
    has_found_ = true;
    if (carried_.part >= close_to_whole && !(refused_.part == 1 && refused_from_ > 0))
        return try_part(1);
    has_ended_ = true;
}

double LoadLimitSearch::part_between() const {
    const double ratio = refused_.part / carried_.part;
    if (!std::isfinite(refused_.growth))
        return carried_.part * std::sqrt(ratio);
    // Sizes grow like a power of the loads or faster, so that this falls short, if anything.
    const double aim = 0.5 * (1 + nearly_grown) * most_growth;
    const double way = std::log(aim / carried_.growth) / std::log(refused_.growth / carried_.growth);
    return carried_.part * std::pow(ratio, std::clamp(way, 0.1, 0.9));
}

std::string LoadLimitSearch::message() const {
    const auto loads = named_loads(*scene_);
    const double most = carried_.part;
    if (most == 0 || most == 1 || loads.empty())
        return "No equilibrium: the net grows without bound, as its weight is too large for its stiffness. "
               "Raise the axial stiffness, or lower the weights.";
    const AxialStiffness *axial = nullptr;
    for (const auto &effect : scene_->effects())
        if (const auto *found = std::get_if<AxialStiffness>(&effect))
            axial = found;
    const bool is_uniform = axial->stiffness.minCoeff() == axial->stiffness.maxCoeff();
    const std::string stiffness = is_uniform
                                      ? "stiffness " + stiffness_text(axial->stiffness[0], axial->per_spring)
                                      : "the members' stiffness";

    const std::string at_most = has_found_ ? "at most about " : "when the search was stopped, at least ";
    const double runaway = runaway_growth_of(*scene_);
    std::string text = runaway == runaway_growth
                           ? "No equilibrium: "
                           : "No equilibrium within " + plain(runaway) + " times the size of the net: ";
    if (loads.size() == 1) {
        text += loads[0].text() + " is beyond what " + stiffness + " can carry; " + at_most +
                loads[0].text_of(most);
    } else {
        text += "the loads are " + to_text(1 / most) + " times what " + stiffness + " can carry; " + at_most +
                plain(rounded_down(100 * most)) + " % of them: ";
        for (std::size_t k = 0; k < loads.size(); ++k)
            text += (k > 0 ? ", " : "") + loads[k].name + " " + loads[k].text_of(most);
    }
    if (carried_.growth > notable_growth)
        text +=
            " (there the net has already grown to " + plain(std::round(carried_.growth)) + " times its size)";
    text += ".";
    // With the same loads over stiffness a net has the same shape, unless a support yields.
    if (scene_->elastic_supports().empty())
        text += is_uniform
                    ? " Or raise the axial stiffness to at least about " +
                          stiffness_text(rounded_up(axial->stiffness[0] / most), axial->per_spring) + "."
                    : " Or raise the axial stiffness to at least about " + plain(rounded_up(1 / most)) +
                          " times what it is.";
    return text;
}

} // namespace funicular
