// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "lattice.hpp"

#include <memory>

namespace funicular {

/// The open quad lattice that a net could have been made on, in the net's own numbering; null if there is
/// none: a mesh from another program is often a grid that has lost the word for it.
///
/// Follows the members from a corner, row by row, and gives up at the first one that does not fit: linear
/// cost. Which corner is the first, and which way is u, is read from positions, so that numbering does not
/// matter. The net's panels are not looked at: the lattice's are its cells.
[[nodiscard]] std::shared_ptr<const Lattice> recognised_lattice(const Net &net);

} // namespace funicular
