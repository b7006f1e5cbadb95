// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene.hpp"

#include <cstddef>
#include <map>
#include <string>

namespace funicular {

/// What each effect takes of memory [bytes], by name: what it holds itself, and the blocks of the tangent
/// that are there for it alone.
[[nodiscard]] std::map<std::string, std::size_t> effect_memory(const Scene &scene);

} // namespace funicular
