# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units that a panel writes where FreeCAD's own boxes write none that anyone reckons in.

FreeCAD's unit schemas know no kg/m and kg/m²: its box shows 30 kg/m² as "0.00 kg/mm^2" and rounds it to that.
Snow it shows as "0.00 Pa", a strength as "6000.00 kPa", and a force, in each schema for buildings and in all
imperial ones, in mm·kg/s². It also lets no M be typed before N, and takes "2 MN" for 2 N.
"""

import FreeCAD

from funicular.gui import preferences

METRIC = {
    "MemberWeight": "kg/m",
    "CoveringWeight": "kg/m²",
    "Snow": "kN/m²",
    "CompressiveStrength": "MPa",
    "YoungsModulus": "MPa",
}
IMPERIAL = {
    "MemberWeight": "lb/ft",
    "CoveringWeight": "lb/ft²",
    "Snow": "psf",
    "CompressiveStrength": "psi",
    "YoungsModulus": "ksi",
}

# From how many of a unit on its multiple is written.
MULTIPLES = {"kN": ((1e4, "MN"),)}

# As engineers write them, and as FreeCAD's parser reads them.
WRITTEN = (("²", "^2"), ("psf", "lbf/ft^2"), ("kip", "*1000 lbf"))


def unit_of(name, quantity):
    """The unit that the amount of a property is to be written in; None where FreeCAD's own box serves."""
    if name in METRIC:
        return (IMPERIAL if preferences.is_imperial() else METRIC)[name]
    if name == "Accuracy":
        # In feet and in metres its own box shows a millimetre as "0.00".
        short = "in" if preferences.is_imperial() else "mm"
        return None if quantity.getUserPreferred()[2] == short == "mm" else short
    if quantity.Unit.Type == "Force":
        units = preferences.force_units()
        # Stiffnesses are thousands of the smaller unit.
        return units[-1]
    return None


def fitting(unit, quantity):
    """The unit to write a quantity in where `unit` is asked for: that, or a multiple that fits better."""
    size = abs(amount_in(quantity, unit)) if unit in MULTIPLES else 0.0
    return next((larger for factor, larger in MULTIPLES.get(unit, ()) if size >= factor), unit)


def as_parsed(text):
    """What an engineer writes as FreeCAD's parser reads it: it takes "m²" for "m"."""
    for written, parsed in WRITTEN:
        text = text.replace(written, parsed)
    return text


def amount_in(quantity, unit):
    """The number of a Quantity in a unit as it is written."""
    return quantity.Value / FreeCAD.Units.Quantity(as_parsed(f"1 {unit}")).Value
