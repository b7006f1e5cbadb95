# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which colour a number has, and the marks of the legend that explains it. Knows no Qt and no FreeCAD."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .colours import ON_PAPER, ramp_colours
from .quantities import CATEGORY, SHARE, SIGNED

# What is smaller than this part of the largest number is no difference.
SAME = 1e-6
# The part of the bar that the smaller of two stretches keeps.
LEAST_STRETCH = 0.25
MOST_DIGITS = 7


@dataclass(frozen=True)
class Stretch:
    """A part of the bar: numbers from `low` to `high`, from `bottom` to `top` of the bar, which is [0, 1]."""

    low: float
    high: float
    bottom: float
    top: float
    ramp: tuple

    def colours(self, values):
        """(k, 3) of numbers (k,), those outside having the colour of the nearer end."""
        span = self.high - self.low
        return ramp_colours(self.ramp, (np.asarray(values) - self.low) / (span if span > 0.0 else 1.0))

    def position(self, value):
        span = self.high - self.low
        return self.top if span <= 0.0 else self.bottom + (self.top - self.bottom) * (value - self.low) / span

    def value(self, position):
        extent = self.top - self.bottom
        share = (position - self.bottom) / extent if extent > 0.0 else 0.0
        return self.low + share * (self.high - self.low)


class Scale:
    """The numbers that colours stand for.

    Parameters
    ----------
    values : (m,) array
        In the unit of the quantity.
    quantity : quantities.Quantity
    above : (m,) bool array, optional
        Which values of a SIGNED quantity are in tension. It alone draws the line between tension and the
        rounding of a solver, so that colours never contradict the certificate. None is, without it.
    limits : (low, high), optional
        A range that is given, in the same unit, instead of that of the values. Numbers beyond it have the
        colours of its ends, but what is in tension, or beyond what is borne, keeps a colour of its own.
    ramps : colours.Ramps
        Those for paper or those for the screen.
    unit_of : callable(unit, largest) -> (size, name), optional
        In what to write numbers of which this is the largest; N, kN and the like without it.
    """

    def __init__(self, values, quantity, above=None, limits=None, ramps=ON_PAPER, unit_of=None):
        self.quantity, self._ramps = quantity, ramps
        self._values = np.asarray(values, dtype=float)
        self._known = np.isfinite(self._values)
        known = self._values[self._known]
        self._above = (
            np.zeros(len(self._values), dtype=bool) if above is None else np.array(above, dtype=bool)
        )
        if quantity.kind == SHARE:
            self._above = self._known & (self._values > 1.0)
        highest = float(self._values[self._above & self._known].max(initial=0.0))
        self._turn = {SIGNED: 0.0, SHARE: 1.0}.get(quantity.kind)
        least, most = (float(known.min()), float(known.max())) if len(known) else (0.0, 0.0)
        if most - least <= SAME * max(abs(least), abs(most)):
            least = most
        if quantity.from_zero:
            least = min(least, 0.0)
        if quantity.kind == SIGNED:
            least, most = min(least, 0.0), max(highest, 0.0)
        low, high = (least, most) if limits is None else self._within(limits, least, most, highest)
        self.stretches = self._lay(low, high)
        self.low, self.high = low, high
        tolerance = SAME * (high - low)
        self.is_beyond_low = limits is not None and bool((known < low - tolerance).any())
        self.is_beyond_high = limits is not None and bool((known > high + tolerance).any())
        self.is_fixed = limits is not None
        self.size, self.unit = (unit_of or si_unit)(quantity.unit, max(abs(low), abs(high)))

    def _within(self, limits, least, most, highest):
        """(low, high) of limits, with room for what must not be hidden."""
        low, high = sorted(map(float, limits))
        if self.quantity.kind == SIGNED:
            # Zero is where the colours turn.
            low, high = (low if low < 0.0 else least), (high if high > 0.0 else highest)
        elif self.quantity.kind == SHARE:
            low, high = (low if low < 1.0 else 0.0), (high if high > 1.0 or highest <= 1.0 else most)
        return low, high

    def _lay(self, low, high):
        """Stretches from bottom to top."""
        turn, below, over = self._turn, self._ramps.amount, self._ramps.tension
        if self.quantity.kind == CATEGORY:
            return ()
        if self.quantity.kind == SIGNED:
            # From the most compression upwards; without any there is only where it begins.
            below = self._ramps.compression[::-1] if high > low else (self._ramps.compression[0],) * 2
        if turn is None or high <= turn:
            return (Stretch(low, high, 0.0, 1.0, below),)
        if low >= turn:
            return (Stretch(low, high, 0.0, 1.0, over),)
        share = (turn - low) / (high - low)
        place = min(max(share, LEAST_STRETCH), 1.0 - LEAST_STRETCH)
        return (Stretch(low, turn, 0.0, place, below), Stretch(turn, high, place, 1.0, over))

    # Colours

    def colours(self):
        """(m, 3) of every member, in member order."""
        if self.quantity.kind == CATEGORY:
            rgb = np.array([colour for colour, _ in self.entries])[(self._values > 0.5).astype(int)]
        else:
            values = np.where(self._known, self._values, self.low)
            if self.quantity.kind == SIGNED:
                # A positive force that is rounding is none.
                values = np.where(self._above, values, np.minimum(values, 0.0))
            if self._lower:
                rgb = self._lower.colours(values)
            else:
                # All there is to be seen is in tension, and what is not carries nothing.
                rgb = np.tile(self._ramps.compression[0], (len(values), 1))
            if self._upper:
                rgb[self._above] = self._upper.colours(values[self._above])
        rgb[~self._known] = self._ramps.unknown
        return rgb

    def bar_colours(self, positions):
        """(k, 3) of the bar at `positions` (k,) in [0, 1] from its bottom."""
        positions = np.asarray(positions)
        rgb = np.empty((len(positions), 3))
        for stretch in reversed(self.stretches):
            below = positions <= stretch.top
            rgb[below] = stretch.colours(stretch.value(positions[below]))
        return rgb

    @property
    def entries(self):
        """((r, g, b), value) of each of the categories, of a CATEGORY."""
        return ((self._ramps.compression[1], 0), (self._ramps.tension[1], 1))

    @property
    def _upper(self):
        """The stretch beyond where colours turn, None without one."""
        top = self.stretches[-1]
        return top if self._turn is not None and top.high > self._turn else None

    @property
    def _lower(self):
        """The stretch up to there, None without one."""
        return self.stretches[0] if self.stretches[0] is not self._upper else None

    @property
    def has_upper(self):
        """Whether there is tension, or more than is borne."""
        return self._upper is not None

    @property
    def has_lower(self):
        return self._lower is not None and self._lower.high > self._lower.low

    @property
    def enlarged(self):
        """ "upper" or "lower" for a stretch that is on a scale of its own to be seen at all, else ""."""
        if len(self.stretches) < 2:
            return ""
        lower, upper = self.stretches
        share = (lower.high - lower.low) / (upper.high - lower.low)
        if lower.top == share:
            return ""
        return "upper" if share > 0.5 else "lower"

    # Marks

    def marks(self, count=5):
        """Marks of the legend from its top to its bottom.

        Returns
        -------
        list of (position, value)
            `position` in [0, 1] counts from the bottom of the bar, `value` is in the unit of the quantity.
            The ends of all stretches are marked; between them stand numbers that are round as text() writes
            them.
        """
        marks = {}
        for stretch in self.stretches:
            low, high = stretch.low / self.size, stretch.high / self.size
            share = max(1.0, (count - 1) * (stretch.top - stretch.bottom))
            inner = [value * self.size for value in _round_numbers(low, high, share)]
            for value in (stretch.low, *inner, stretch.high):
                # Where two stretches meet rounding may give the same value two places.
                marks.setdefault(value, stretch.position(value))
        return sorted(((position, value) for value, position in marks.items()), reverse=True)

    def text(self, value):
        """A value as the legend writes it, without its unit."""
        return number_text(value / self.size, self._more)

    @cached_property
    def _more(self):
        """Digits beyond three, where numbers lie so close together that three would not tell them apart."""
        values = [value / self.size for _, value in self.marks()]
        for more in range(MOST_DIGITS - 3):
            if len({number_text(value, more) for value in values}) == len(values):
                return more
        return MOST_DIGITS - 3

    def mark_text(self, value):
        """The same, with what tells that values beyond a fixed range have the colour of its end."""
        if value == self.high and self.is_beyond_high:
            return "≥ " + self.text(value)
        if value == self.low and self.is_beyond_low:
            return "≤ " + self.text(value)
        return self.text(value)


def number_text(value, more=0):
    """Three significant digits, or `more`, with a true minus."""
    magnitude = abs(value)
    if not magnitude > 0.0:
        return "0" if value == 0.0 else "–"
    decimals = more + (0 if magnitude >= 100.0 else 1 if magnitude >= 10.0 else 2)
    digits = f"{magnitude:.{decimals}f}" if magnitude >= 0.01 else f"{magnitude:.1e}"
    return ("−" if value < 0.0 else "") + digits


def si_unit(unit, largest):
    """(size, name) of the multiple of an SI unit in which to write numbers up to `largest`."""
    if unit == "N":
        return (1e3, "kN") if largest >= 1e3 else (1.0, "N")
    if unit == "m":
        return (1.0, "m") if largest >= 10.0 else (1e-3, "mm")
    return {"Pa": (1e6, "MPa"), "": (1e-2, "%")}[unit]


def _round_numbers(low, high, count):
    """Multiples of a round step, about `count` of them, that keep clear of both ends."""
    if not high > low:
        return []
    least = 0.8 * (high - low) / count
    decade = 10.0 ** math.floor(math.log10(least))
    step = next(factor * decade for factor in (1.0, 2.0, 2.5, 5.0, 10.0) if factor * decade >= least)
    # Half a step away from the ends, but for rounding.
    first, last = math.ceil(low / step + 0.5 - 1e-9), math.floor(high / step - 0.5 + 1e-9)
    return [step * index for index in range(first, last + 1)]
