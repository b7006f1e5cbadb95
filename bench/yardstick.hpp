// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scenes.hpp"

#include <Eigen/SparseCore>

#include <string>
#include <vector>

namespace funicular::bench {

/// What a factorisation took [s], and how well it solved.
struct FactorTimes {
    double analyse = 0, factorise = 0, solve = 0;
    double residual = 0; ///< |A x - b| / |b|
    /// The yardstick's own measure: a net keeps its pattern, so that the analysis is done once for many of
    /// these.
    [[nodiscard]] double total() const { return factorise + solve; }
};

/// F: one sparse Cholesky factorisation and one solve of a scene's tangent, 3n x 3n less the held directions,
/// at a shape. It is the members' part of the tangent, which is symmetric, with a notional pull so small that
/// it only keeps a node without taut members from being singular.
class Yardstick {
public:
    /// \param nodes the scene's solution, relative to the net's centre [m]
    Yardstick(const ScenePtr &scene, const Points &centred_nodes);

    /// The factorisations there are on this machine.
    [[nodiscard]] static std::vector<std::string> backends();
    /// Runs one of them, the analysis included.
    [[nodiscard]] FactorTimes run(const std::string &backend) const;
    /// The one with the smallest total.
    [[nodiscard]] std::string best() const;

private:
    Eigen::SparseMatrix<double> tangent_;
    Eigen::VectorXd load_;
};

} // namespace funicular::bench
