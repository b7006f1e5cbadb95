// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"
#include "types.hpp"

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace funicular {

/// How a solve ended. It is never success by default.
enum class Status { iteration_limit, time_limit, cancelled, no_equilibrium, converged };

enum class Method { automatic, newton, relaxation };

[[nodiscard]] inline const char *status_name(Status status) {
    switch (status) {
    case Status::iteration_limit:
        return "iteration_limit";
    case Status::time_limit:
        return "time_limit";
    case Status::cancelled:
        return "cancelled";
    case Status::no_equilibrium:
        return "no_equilibrium";
    case Status::converged:
        break;
    }
    return "converged";
}

/// Where a solve stands after an iteration.
struct Report {
    long iteration = 0;
    double seconds = 0;
    double residual = std::numeric_limits<double>::infinity();
    /// [m]; infinite while it is not known.
    double position_error = std::numeric_limits<double>::infinity();
};

/// A shape and what is known of it. SI units; forces in the sense of the built structure.
struct Result {
    Points nodes;                   ///< [m]
    Eigen::VectorXd member_forces;  ///< [N], compression negative
    Eigen::VectorXd member_lengths; ///< [m]
    Points reactions;               ///< [N], zero where unsupported
    double residual = 0;            ///< max |r_i| / mean nodal load
    double position_error = 0;      ///< [m]
    long iterations = 0;
    double seconds = 0;
    Status status = Status::iteration_limit;
    Method method = Method::newton; ///< the one that was used
    std::string message;            ///< why it ended, and what to do if that is not convergence
    double tolerance = 0;           ///< relative residual that was asked for
    double accuracy = 0;            ///< position error that was asked for [m]
    std::vector<Report> history;    ///< one per iteration; of very many, evenly spaced ones
    std::map<std::string, Cost> costs;

    /// Positions relative to the net's centre [m]: a net far from the origin has digits here that `nodes`
    /// cannot hold.
    Points centred_nodes;
};

} // namespace funicular
