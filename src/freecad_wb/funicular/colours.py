# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of numbers, the ramps that they run along. Numbers only: no Qt, no FreeCAD.

Compression runs along a blue ramp, tension along an orange one, what has no sign from sand to violet. Blue
against orange stays distinct for every common colour vision deficiency, and the lightness of each ramp falls
with the amount, so that a grey print still reads.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Ramps:
    """Colours from nothing to the largest amount, evenly spaced, each (r, g, b) in [0, 1]; and of what is not
    known."""

    compression: tuple
    tension: tuple
    amount: tuple
    unknown: tuple


# The ends of the two ramps are far apart even at zero: a member in tension must catch the eye however small
# its force is, because a compression-only shell has none.
ON_PAPER = Ramps(
    compression=((0.80, 0.91, 0.97), (0.34, 0.66, 0.86), (0.05, 0.36, 0.73), (0.02, 0.12, 0.42)),
    tension=((1.00, 0.73, 0.25), (0.94, 0.45, 0.00), (0.72, 0.20, 0.00)),
    amount=((0.93, 0.88, 0.52), (0.48, 0.73, 0.42), (0.10, 0.51, 0.52), (0.24, 0.20, 0.45)),
    unknown=(0.60, 0.60, 0.60),
)
# A 3D view is white for one user and, as FreeCAD comes, dark blue for the next: these are neither light nor
# dark at their ends, and their hue does more.
ON_SCREEN = Ramps(
    compression=((0.33, 0.78, 0.84), (0.10, 0.60, 0.95), (0.12, 0.42, 1.00), (0.42, 0.20, 0.98)),
    tension=((0.98, 0.62, 0.05), (0.94, 0.40, 0.00), (0.84, 0.18, 0.00)),
    amount=(
        (0.78, 0.74, 0.25),
        (0.30, 0.68, 0.40),
        (0.10, 0.56, 0.66),
        (0.36, 0.42, 0.82),
        (0.60, 0.22, 0.74),
    ),
    unknown=(0.60, 0.60, 0.60),
)

# Forces on one ramp from most compression to most tension, after viridis: ever lighter, so that lightness is
# enough to tell.
ONE_RAMP = Ramps(
    compression=((0.12, 0.63, 0.53), (0.15, 0.53, 0.56), (0.19, 0.45, 0.58), (0.23, 0.40, 0.60)),
    tension=((0.55, 0.71, 0.14), (0.76, 0.70, 0.10), (0.90, 0.69, 0.05)),
    amount=ON_SCREEN.amount,
    unknown=ON_SCREEN.unknown,
)


def ramp_colours(ramp, shares):
    """(k, 3) colours (r, g, b), each in [0, 1], at shares (k,) of a ramp of evenly spaced colours.

    Shares below 0 and above 1 have the colours of the ends.
    """
    ramp = np.asarray(ramp)
    positions = np.linspace(0.0, 1.0, len(ramp))
    return np.column_stack([np.interp(shares, positions, channel) for channel in ramp.T])


def packed(rgb):
    """(k,) uint32 0xRRGGBBAA, as coin has them, of colours (k, 3)."""
    red, green, blue = np.rint(255 * np.asarray(rgb)).astype(np.uint32).T
    return red << 24 | green << 16 | blue << 8 | 255
