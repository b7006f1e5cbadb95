# SPDX-License-Identifier: LGPL-2.1-or-later
"""Member force to colour, and the marks of the legend that explains it. Numbers only: no Qt, no FreeCAD.

Compression runs along a blue ramp, tension along an orange one. Blue against orange stays distinct for every
common colour vision deficiency, and the lightness of each ramp falls with the force, so that a grey print
still reads.
"""

# From nothing to the largest force. The ends of the two ramps are far apart even at zero: a member in tension
# must catch the eye however small its force is, because a compression-only shell has none.
COMPRESSION_RAMP = ((0.80, 0.91, 0.97), (0.34, 0.66, 0.86), (0.05, 0.36, 0.73), (0.02, 0.12, 0.42))
TENSION_RAMP = ((1.00, 0.73, 0.25), (0.94, 0.45, 0.00), (0.72, 0.20, 0.00))

KILONEWTON = 1000.0


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
    """

    def __init__(self, forces, tension_members=()):
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
            return ramp_colour(TENSION_RAMP, _share(force, self.largest_tension))
        return ramp_colour(COMPRESSION_RAMP, _share(-force, self.largest_compression))

    @property
    def unit(self):
        """Kilonewtons, written "kN", once the largest force reaches one; else "N"."""
        return "kN" if max(self.largest_compression, self.largest_tension) >= KILONEWTON else "N"

    def text(self, force):
        """A force in N as the legend writes it: three significant digits in the legend's unit, with a true
        minus."""
        value = force / KILONEWTON if self.unit == "kN" else force
        if value == 0.0:
            return "0"
        magnitude = abs(value)
        decimals = 0 if magnitude >= 100.0 else 1 if magnitude >= 10.0 else 2
        digits = f"{magnitude:.{decimals}f}" if magnitude >= 0.01 else f"{magnitude:.1e}"
        return ("\u2212" if value < 0.0 else "") + digits

    def marks(self, count=5):
        """Marks of the legend from its top (most tension) to its bottom (most compression).

        Returns
        -------
        list of (position, force)
            `position` in [0, 1] counts from the bottom of the bar, `force` is in N. Zero is always marked,
            and with it the largest compression and, if there is any, the largest tension.
        """
        zero = self.zero_position
        marks = []
        if self.largest_tension > 0.0:
            marks.append((1.0, self.largest_tension))
        steps = max(1, round((count - 1) * zero)) if self.largest_compression > 0.0 else 0
        marks.append((zero, 0.0))
        for step in range(1, steps + 1):
            share = step / steps
            marks.append((zero * (1.0 - share), -share * self.largest_compression))
        return marks

    @property
    def zero_position(self):
        """Where zero lies on the bar, in [0, 1] from its bottom.

        A small tension keeps a visible stretch of the bar, so the bar is not to scale across zero.
        """
        if self.largest_tension <= 0.0:
            return 1.0
        if self.largest_compression <= 0.0:
            return 0.0
        share = self.largest_compression / (self.largest_compression + self.largest_tension)
        return min(max(share, 0.25), 0.75)

    def bar_colour(self, position):
        """Colour of the bar at `position` in [0, 1] from its bottom."""
        zero = self.zero_position
        if position > zero:
            return ramp_colour(TENSION_RAMP, (position - zero) / (1.0 - zero))
        return ramp_colour(COMPRESSION_RAMP, 1.0 - position / zero if zero > 0.0 else 0.0)


def _share(force, largest):
    return force / largest if largest > 0.0 else 0.0
