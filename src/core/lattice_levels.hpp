// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "coarsening.hpp"
#include "scene.hpp"

#include <memory>
#include <optional>
#include <utility>
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

/// Coarser nets of one net, or of one of them, each thinner than the one before. Made once and shared.
class CoarserLevels {
public:
    CoarserLevels() = default;
    explicit CoarserLevels(std::shared_ptr<const std::vector<LatticeLevel>> levels, std::size_t first = 0)
        : levels_(std::move(levels)), first_(first) {}
    [[nodiscard]] bool empty() const { return size() == 0; }
    [[nodiscard]] std::size_t size() const { return levels_ ? levels_->size() - first_ : 0; }
    [[nodiscard]] const LatticeLevel &operator[](std::size_t k) const { return (*levels_)[first_ + k]; }
    /// Those below level k.
    [[nodiscard]] CoarserLevels below(std::size_t k) const { return CoarserLevels(levels_, first_ + k + 1); }

private:
    std::shared_ptr<const std::vector<LatticeLevel>> levels_;
    std::size_t first_ = 0;
};

/// The net of every second line of the scene's own; none if that has too few of them, or neither was made on
/// a lattice of quads or of ribs nor is as if it were, or would fold onto itself.
[[nodiscard]] std::optional<LatticeLevel> coarser_level(const Scene &scene);

/// Values of the scene's members summed over those in a row that each member of a level stands for, the mean
/// of lines side by side being taken by their stiffness.
[[nodiscard]] Eigen::VectorXd summed_in_rows(const Scene &scene, const LatticeLevel &level,
                                             const Eigen::VectorXd &values);

/// Nets of every second, fourth, … line of the scene's, from the finest to the coarsest; none if the net
/// neither was made on a quad lattice nor is as if it were. Ends before a net that would fold onto itself.
[[nodiscard]] CoarserLevels coarser_levels(const Scene &scene);

} // namespace funicular
