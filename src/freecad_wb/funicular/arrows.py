# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forces at points as arrows to one scale, each of five lines. Needs numpy only."""

import numpy as np

# The longest, of the size of what it stands at; its head, of its own length; how slender a head is.
LONGEST, HEAD, SLENDER = 0.2, 0.28, 0.32
# Of the largest force: what is smaller is no arrow.
LEAST = 1e-3

POINTS = 6
# Shaft, and four barbs from the tip.
LINES = np.array([[0, 1], [1, 2], [1, 3], [1, 4], [1, 5]])


def arrow_points(tips, forces, longest):
    """(k * POINTS, 3): of each arrow where it begins, its tip, and the ends of its barbs.

    tips: (n, 3), where the forces (n, 3) act, an arrow's tip being there. longest: length of the arrow of the
    largest force. The k arrows are those of forces that can be seen.
    """
    sizes = np.linalg.norm(forces, axis=1)
    seen = np.flatnonzero(sizes > LEAST * sizes.max(initial=0.0))
    ways, lengths = forces[seen] / sizes[seen, None], longest * sizes[seen, None] / sizes.max(initial=1e-300)
    # Beside an arrow in two directions: away from that axis which it is least along.
    axes = np.eye(3)[np.abs(ways).argmin(axis=1)]
    beside = np.cross(ways, axes)
    beside /= np.linalg.norm(beside, axis=1)[:, None]
    across = np.cross(ways, beside)
    tips = tips[seen]
    neck, reach = tips - HEAD * lengths * ways, SLENDER * HEAD * lengths
    ends = [neck + reach * way for way in (beside, -beside, across, -across)]
    return np.stack([tips - lengths * ways, tips, *ends], axis=1).reshape(-1, 3)


def arrow_lines(count):
    """(5 * count, 2) points of each line of so many arrows."""
    return (POINTS * np.arange(count)[:, None, None] + LINES).reshape(-1, 2)
