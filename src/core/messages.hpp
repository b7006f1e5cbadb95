// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"
#include "result.hpp"

#include <string>

namespace funicular {

// What a solve says of its end, in whole sentences.

/// A limit of iterations.
[[nodiscard]] std::string steps_text(long most_steps);
/// A limit of time [s].
[[nodiscard]] std::string seconds_text(double most_seconds);

/// In what a shape falls short of the tolerance (a relative residual) or the accuracy [m] that was asked for.
[[nodiscard]] std::string missed_message(const Report &report, double tolerance, double accuracy);
/// The residual is of rounding alone.
[[nodiscard]] std::string rounding_message(const Report &report);
/// An equilibrium in the wrong sign, at which a solve stopped for this limit.
[[nodiscard]] std::string unstable_message(const std::string &limit);
/// The equilibrium x, where it was evaluated.
[[nodiscard]] std::string equilibrium_message(const Points &x, const Equilibrium &equilibrium,
                                              const Report &report, double tolerance, bool is_unstable);

} // namespace funicular
