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
// So small that the position error, which rounding may hide, need not be known.
constexpr double residual_of_rounding = 1e-10;
// The growth is told from parts that differ by as much as this.
constexpr double lesser_part = 0.95;
// The whole was refused.
constexpr double most_of_the_whole = 0.98;
constexpr double first_part = 0.25;
// No part of the loads worth naming.
constexpr double least_part = 1e-12;
// The search ends when the smallest part refused is this many times the largest part carried.
constexpr double narrow_bracket = 1.02;
// How far to go up at once: at first, and where a refusal has turned out too early.
constexpr double long_stride = 2;
constexpr double short_stride = 1.05;
// A refusal stands if it was tried from a shape that carries this part of it.
constexpr double close_below = 0.985;

/// How far a search follows a net, in terms of its size.
struct GrowthLimits {
    double telling;  ///< the limit can be told without going closer
    double moderate; ///< what has grown more is left to extrapolation
    double hopeless; ///< what is so large on the way is not waited for
};
constexpr GrowthLimits growth_of_small_net{1e3, 3e3, 1e5};
// Each decade is costly, and from so far below nothing can be told: what is carried there is the figure.
constexpr GrowthLimits growth_of_large_net{30, 100, 1e3};
constexpr Index large_net = 1000;

GrowthLimits growth_limits(const Scene &scene) {
    return scene.net().node_count() < large_net ? growth_of_small_net : growth_of_large_net;
}

// Growth that deserves a word.
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

LoadLimitSearch::LoadLimitSearch(std::shared_ptr<const Scene> scene, Points start)
    : scene_(std::move(scene)), start_(std::move(start)),
      extent_(std::max(start_.cwiseAbs().maxCoeff(), scene_->net().size() / scene_->scale().length)),
      stride_(long_stride) {
    try_part(first_part);
}

void LoadLimitSearch::try_part(double part) {
    part_ = part;
    x_ = carried_ > 0 ? shape_ : start_;
    newton_.reset();
    equilibrium_ =
        std::make_unique<Equilibrium>(std::make_shared<const Scene>(scene_->with_loads_times(part)));
    equilibrium_->evaluate(x_);
    newton_ = std::make_unique<Newton>(*equilibrium_);
    steps_of_trial_ = 0;
}

bool LoadLimitSearch::step() {
    if (has_ended_)
        return true;
    const double growth = x_.cwiseAbs().maxCoeff() / extent_;
    const double error = newton_->position_error(x_, *equilibrium_, {});
    ++steps_;
    if (equilibrium_->significant_residual() <= residual_of_rounding ||
        (equilibrium_->significant_residual() <= residual_of_trial &&
         error <= error_of_trial * growth * extent_))
        end_trial(growth <= growth_limits(*scene_).moderate);
    else if (!(growth < growth_limits(*scene_).hopeless) || ++steps_of_trial_ > most_steps_of_trial ||
             newton_->move(x_, *equilibrium_) == Iteration::Move::impossible)
        end_trial(false);
    const bool is_large = scene_->net().node_count() >= large_net;
    return has_ended_ = has_ended_ || steps_ >= (is_large ? most_steps_of_large_net : most_steps);
}

double LoadLimitSearch::log_size(const Points &x) const {
    return std::log((x.colwise().maxCoeff() - x.colwise().minCoeff()).norm());
}

void LoadLimitSearch::end_trial(bool is_carried) {
    if (is_carried) {
        carried_ = part_;
        // What was refused without a start, or from farther below, may be no limit at all.
        if (refused_from_ == 0 || part_ >= refused_) {
            refused_ = std::min(1.0, stride_ * carried_);
            refused_from_ = 0;
        }
        shape_ = x_;
        growths_.push_back({part_, log_size(x_)});
    } else {
        if (carried_ > 0)
            stride_ = short_stride;
        refused_ = part_;
        refused_from_ = carried_;
    }

    if (carried_ >= 1 || refused_ < least_part) {
        has_ended_ = true;
        return;
    }
    if (carried_ == 0)
        return try_part(refused_ * refused_);
    if (growth() < growth_limits(*scene_).telling) {
        if (refused_from_ == 0)
            return try_part(refused_);
        if (refused_ > narrow_bracket * carried_)
            return try_part(std::sqrt(carried_ * refused_));
        if (refused_from_ < close_below * refused_)
            return try_part(refused_);
    }
    has_ended_ = true;
}

double LoadLimitSearch::growth() const {
    return shape_.cwiseAbs().maxCoeff() / extent_;
}

double LoadLimitSearch::limit() const {
    if (scene_->net().node_count() >= large_net || growth() < growth_limits(*scene_).telling)
        return carried_;
    std::vector<Growth> told{growths_.back()};
    for (auto earlier = growths_.rbegin(); earlier != growths_.rend() && told.size() < 3; ++earlier)
        if (earlier->part <= lesser_part * told.back().part)
            told.push_back(*earlier);
    if (told.size() < 3)
        return carried_;
    // Near a limit λ* of order p a net grows as size = C (λ* - λ)^-p, so that λ = λ* - A exp(-μ ln size), μ =
    // 1/p; with μ = 0, which is growth without a limit, λ is linear in ln size.
    const auto [part2, size2] = told[0];
    const auto [part1, size1] = told[1];
    const auto [part0, size0] = told[2];
    const auto gain = [](double mu, double from, double to) { // of λ, relative to A exp(-μ from)
        return mu == 0 ? to - from : -std::expm1(-mu * (to - from)) / mu;
    };
    const double wanted = (part2 - part1) / (part1 - part0);
    const auto ratio = [&](double mu) {
        return std::exp(-mu * (size1 - size0)) * gain(mu, size1, size2) / gain(mu, size0, size1);
    };
    double low = 0;
    double high = 100;
    if (ratio(0) > wanted)
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = (low + high) / 2;
            (ratio(middle) > wanted ? low : high) = middle;
        }
    const double runaway = log_size(start_) + std::log(runaway_growth);
    const double further =
        std::exp(-low * (size2 - size1)) * gain(low, size2, runaway) / gain(low, size1, size2);
    return std::clamp(part2 + (part2 - part1) * further, carried_, std::max(carried_, most_of_the_whole));
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
    const std::string stiffness = is_uniform
                                      ? "stiffness " + stiffness_text(axial->stiffness[0], axial->per_spring)
                                      : "the members' stiffness";

    const double most = limit();
    std::string text = "No equilibrium: ";
    if (loads.size() == 1) {
        text += loads[0].text() + " is beyond what " + stiffness + " can carry; at most about " +
                loads[0].text_of(most);
    } else {
        text += "the loads are " + to_text(1 / most) + " times what " + stiffness +
                " can carry; at most about " + plain(rounded_down(100 * most)) + " % of them: ";
        for (std::size_t k = 0; k < loads.size(); ++k)
            text += (k > 0 ? ", " : "") + loads[k].name + " " + loads[k].text_of(most);
    }
    if (growth() > notable_growth)
        text +=
            " (at " +
            (loads.size() == 1 ? loads[0].text_of(carried_) : plain(rounded_down(100 * carried_)) + " %") +
            " the net has already grown to " + plain(std::round(growth())) + " times its size)";
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
