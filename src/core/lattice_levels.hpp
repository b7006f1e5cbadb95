// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "coarsening.hpp"
#include "scene.hpp"

#include <memory>
#include <vector>

namespace funicular {

/// A coarser net in the place of a net on a lattice.
struct LatticeLevel {
    /// From the next finer lattice to this one.
    Coarsening coarsening;
    std::shared_ptr<const Net> net;
    /// Two members in a row are as one of half their stiffness; lines side by side add up.
    AxialStiffness stiffness;
    Eigen::VectorXd rest_lengths; ///< [m]
    /// A support of a node that was left out passes to those beside it.
    std::vector<Support> supports;
    /// How many lines of the scene's own net each member stands for.
    Eigen::VectorXd lines;
};

/// Nets of every second, fourth, … line of the scene's, from the finest to the coarsest; none if the net was
/// not made on a quad lattice. Ends before a net that would fold onto itself.
[[nodiscard]] std::vector<LatticeLevel> coarser_levels(const Scene &scene);

} // namespace funicular
