// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "net.hpp"
#include "scene_parts.hpp"

#include <vector>

namespace funicular {

/// Loads [N] on the built structure at a shape, by formulas that share nothing with the solver's effects.
/// \param centred_nodes shape [m]
[[nodiscard]] Points certificate_loads(const Net &net, const std::vector<EffectDescription> &effects,
                                       const Points &centred_nodes);

} // namespace funicular
