# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units that a panel writes where FreeCAD's own boxes write none that anyone reckons in.

FreeCAD's unit schemas know no kg/m and kg/m²: its box shows 30 kg/m² as "0.00 kg/mm^2" and rounds it to that.
Snow it shows as "0.00 Pa", a strength as "6000.00 kPa", and a force, in each schema for buildings and in all
imperial ones, in mm·kg/s².
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
        return None if quantity.getUserPreferred()[2] in units else units[-1]
    return None


def as_parsed(text):
    """What an engineer writes as FreeCAD's parser reads it: it takes "m²" for "m"."""
    for written, parsed in WRITTEN:
        text = text.replace(written, parsed)
    return text


def amount_in(quantity, unit):
    """The number of a Quantity in a unit as it is written."""
    return quantity.Value / FreeCAD.Units.Quantity(as_parsed(f"1 {unit}")).Value
