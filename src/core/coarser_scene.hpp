// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "lattice_levels.hpp"

#include <memory>
#include <vector>

namespace funicular {

/// What acts on a net acts on a coarser one: members stand for the lines side by side, and loads on nodes
/// that are left out pass to those beside them.
[[nodiscard]] std::vector<EffectDescription> effects_on(const LatticeLevel &level,
                                                        const std::vector<EffectDescription> &effects);

/// A scene as it would be with twice the step.
struct CoarserScene {
    std::shared_ptr<const Scene> scene;
    /// The finer scene's node in the place of each of this one.
    std::vector<Index> kept;
};

/// The scene on every second line of its lattice, and on all ribs, with members that stand for those left
/// out. \throws InvalidInput for a net that is no lattice of quads or ribs or too coarse, and for a support
/// that none of the kept nodes stands for
[[nodiscard]] CoarserScene coarser_scene(const Scene &scene);

} // namespace funicular
