// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "pattern_grid.hpp"

#include <span>

namespace funicular {

/// How one pattern is laid (paper section 5.1 and figure 2).
struct PatternRule {
    Pattern pattern;
    const char *name;
    /// Points of the grid for each cell.
    Index points_u, points_v;
    /// Extent of a cell in member lengths, where all members are to be of one length.
    double cell_u, cell_v;
    /// Cells after which it repeats: in a closed direction their number is a multiple of it.
    Index period_u, period_v;
    void (*lay)(PatternGrid &);
};

[[nodiscard]] std::span<const PatternRule> pattern_rules();
[[nodiscard]] const PatternRule &rule_of(Pattern pattern);

} // namespace funicular
