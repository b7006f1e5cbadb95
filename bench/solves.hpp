// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace funicular::bench {

/// How large the scenes are that are measured, and how many: tiny is for tests, quick takes minutes.
enum class Extent { tiny, quick, full };

/// Cold, warm and interactive solves, and what the yardstick's factorisations take.
void register_solves(Extent extent);
/// What each effect costs.
void register_effects(Extent extent);

} // namespace funicular::bench
