# SPDX-License-Identifier: LGPL-2.1-or-later
"""Member force to colour, and the marks of the legend that explains it. Numbers only: no Qt, no FreeCAD.

Compression runs along a blue ramp, tension along an orange one. Blue against orange stays distinct for every
common colour vision deficiency, and the lightness of each ramp falls with the force, so that a grey print
still reads.
"""

import math
from dataclasses import dataclass

from .wording import force_unit, number


@dataclass(frozen=True)
class Ramps:
    """Colours from nothing to the largest force, evenly spaced, each (r, g, b) in [0, 1]."""

    compression: tuple
    tension: tuple


# The ends of the two ramps are far apart even at zero: a member in tension must catch the eye however small
# its force is, because a compression-only shell has none.
ON_PAPER = Ramps(
    compression=((0.80, 0.91, 0.97), (0.34, 0.66, 0.86), (0.05, 0.36, 0.73), (0.02, 0.12, 0.42)),
    tension=((1.00, 0.73, 0.25), (0.94, 0.45, 0.00), (0.72, 0.20, 0.00)),
)
# A 3D view is white for one user and, as FreeCAD comes, dark blue for the next: these are neither light nor
# dark at their ends, and their hue does more.
ON_SCREEN = Ramps(
    compression=((0.33, 0.78, 0.84), (0.10, 0.60, 0.95), (0.12, 0.42, 1.00), (0.42, 0.20, 0.98)),
    tension=((0.98, 0.62, 0.05), (0.94, 0.40, 0.00), (0.84, 0.18, 0.00)),
)

# One ramp from most compression to most tension, after viridis: ever lighter, so that lightness alone tells.
ONE_RAMP = Ramps(
    compression=((0.12, 0.63, 0.53), (0.15, 0.53, 0.56), (0.19, 0.45, 0.58), (0.23, 0.40, 0.60)),
    tension=((0.62, 0.74, 0.12), (0.78, 0.70, 0.10), (0.90, 0.69, 0.05)),
)


def ramp_colour(ramp, share):
    """Colour at `share` in [0, 1] of a ramp of evenly spaced colours: (r, g, b), each in [0, 1]."""
    position = min(max(share, 0.0), 1.0) * (len(ramp) - 1)
    index = min(int(position), len(ramp) - 2)
    blend = position - index
    low, high = ramp[index], ramp[index + 1]
    return tuple(low[k] + blend * (high[k] - low[k]) for k in range(3))


class ForceScale:
    """The forces that the two ramps span, in N, compression negative as in the results.

    Parameters
    ----------
    forces : sequence of float, (m,)
        Member forces in N.
    tension_members : sequence of int
        Members that the certificate counts as being in tension. It alone draws the line between tension and
        the rounding of a solver, so the picture never contradicts it.
    ramps : Ramps
        The colours: those for paper or those for the screen.
    """

    def __init__(self, forces, tension_members=(), ramps=ON_PAPER):
        self._ramps = ramps
        self._forces = [float(force) for force in forces]
        self._in_tension = frozenset(tension_members)
        self.largest_compression = -min(self._forces, default=0.0)
        self.largest_compression = max(self.largest_compression, 0.0)
        self.largest_tension = max(
            (self._forces[i] for i in self._in_tension if i < len(self._forces)), default=0.0
        )

    def member_colours(self):
        """(r, g, b) of every member, in member order."""
        return [self._colour(index, force) for index, force in enumerate(self._forces)]

    def _colour(self, index, force):
        if index in self._in_tension:
            return ramp_colour(self._ramps.tension, _share(force, self.largest_tension))
        return ramp_colour(self._ramps.compression, _share(-force, self.largest_compression))

    @property
    def unit(self):
        """That of the largest force: as forces are written in sentences."""
        return self._unit[0]

    @property
    def _unit(self):
        return force_unit(max(self.largest_compression, self.largest_tension))

    def text(self, force):
        """A force in N as the legend writes it: three significant digits in the legend's unit, with a true
        minus."""
        value = force / self._unit[1]
        if value == 0.0:
            return "0"
        magnitude = abs(value)
        decimals = 0 if magnitude >= 100.0 else 1 if magnitude >= 10.0 else 2
        digits = number(magnitude, f".{decimals}f" if magnitude >= 0.01 else ".1e")
        return ("\u2212" if value < 0.0 else "") + digits

    def marks(self, count=5):
        """Marks of the legend from its top (most tension) to its bottom (most compression).

        Returns
        -------
        list of (position, force)
            `position` in [0, 1] counts from the bottom of the bar, `force` is in N. Zero is always marked,
            and with it the largest compression and, if there is any, the largest tension; between them stand
            round numbers.
        """
        zero = self.zero_position
        marks = [(zero, 0.0)]
        for largest, end, sign in ((self.largest_tension, 1.0, 1.0), (self.largest_compression, 0.0, -1.0)):
            for force in _round_marks(largest, (count - 1) * abs(end - zero)):
                marks.append((zero + (end - zero) * force / largest, sign * force))
        return sorted(marks, reverse=True)

    @property
    def one_scale(self):
        """Whether the bar is to scale across zero."""
        return self.largest_compression <= 0.0 or self.zero_position == self._share_of_compression

    @property
    def zero_position(self):
        """Where zero lies on the bar, in [0, 1] from its bottom.

        Where one side is much the smaller it keeps a visible stretch of the bar, on a scale of its own: then
        `one_scale` is false.
        """
        if self.largest_tension <= 0.0:
            return 1.0
        if self.largest_compression <= 0.0:
            return 0.0
        return min(max(self._share_of_compression, 0.25), 0.75)

    @property
    def _share_of_compression(self):
        span = self.largest_compression + self.largest_tension
        return self.largest_compression / span if self.largest_tension > 0.0 else 1.0

    def bar_colour(self, position):
        """Colour of the bar at `position` in [0, 1] from its bottom."""
        zero = self.zero_position
        if position > zero:
            return ramp_colour(self._ramps.tension, (position - zero) / (1.0 - zero))
        return ramp_colour(self._ramps.compression, 1.0 - position / zero if zero > 0.0 else 0.0)


def _share(force, largest):
    return force / largest if largest > 0.0 else 0.0


def _round_marks(largest, count):
    """Multiples of a round step, about `count` of them, and `largest`, from which they keep clear."""
    if largest <= 0.0:
        return []
    least = 0.8 * largest / max(1.0, count)
    decade = 10.0 ** math.floor(math.log10(least))
    step = next(factor * decade for factor in (1.0, 2.0, 2.5, 5.0, 10.0) if factor * decade >= least)
    last = math.floor(largest / step - 0.5)
    return [step * index for index in range(1, last + 1)] + [largest]
