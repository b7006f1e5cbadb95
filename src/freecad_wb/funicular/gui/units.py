# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths, forces and stresses as the user's unit schema writes them, with the user's decimal point."""

import FreeCAD

from funicular import wording
from funicular.scale import number_text, si_unit

# FreeCAD's unit, and how many of its own units an SI one is.
FREECAD = {
    "m": (FreeCAD.Units.Length, 1e3),
    "Pa": (FreeCAD.Units.Pressure, 1e-3),
}
# Names that engineers do not use for stresses; nor base units, where a schema knows no other.
AWKWARD = ("Pa", "kPa", "GPa")


def unit_of(unit, largest):
    """As scale.si_unit, in the user's unit schema; forces in the units that were chosen for them."""
    if unit == "N":
        name, size = wording.force_unit(largest)
        return size, name
    if unit not in FREECAD or not largest > 0.0:
        return si_unit(unit, largest)
    dimension, factor = FREECAD[unit]
    _, size, name = FreeCAD.Units.Quantity(largest * factor, dimension).getUserPreferred()
    if name in AWKWARD or "*" in name:
        return si_unit(unit, largest)
    return size / factor, name


def in_words(value, unit):
    """A number in an SI unit ("m", "N", "Pa", or "" for a share) as "−4.21 kN", "512 mm", "23 %"."""
    size, name = unit_of(unit, abs(value))
    return f"{localised(number_text(value / size))} {name}"


def localised(number):
    """A number in figures with the decimal point of the user's language."""
    return number.replace(".", wording.habits().decimal_point)
