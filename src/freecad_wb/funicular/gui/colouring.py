# SPDX-License-Identifier: LGPL-2.1-or-later
"""How members are coloured: properties of a gridshell's view provider, and what they make of a Form."""

import math
from dataclasses import dataclass

import numpy as np

from funicular.colours import packed
from funicular.features.feature import EXPECTED, reason
from funicular.features.section import section_of
from funicular.gui import preferences
from funicular.gui.qt import QT_TRANSLATE_NOOP, translate
from funicular.gui.units import unit_of
from funicular.quantities import QUANTITIES, are_in_tension
from funicular.scale import Scale

NONE = "None"

TITLES = {
    "Force": QT_TRANSLATE_NOOP("Funicular", "Member force"),
    "Stress": QT_TRANSLATE_NOOP("Funicular", "Stress"),
    "Utilisation": QT_TRANSLATE_NOOP("Funicular", "Utilisation"),
    "Length": QT_TRANSLATE_NOOP("Funicular", "Member length"),
    "Deviation": QT_TRANSLATE_NOOP("Funicular", "From the source"),
    "Slack": QT_TRANSLATE_NOOP("Funicular", "Slack members"),
}

# What a quantity needs that is not given.
MISSING = {
    "section": QT_TRANSLATE_NOOP("Funicular", "Needs a section: choose its shape and size."),
    "strength": QT_TRANSLATE_NOOP(
        "Funicular", "Needs a section and the strength or Young's modulus of its material."
    ),
}

# Of each quantity with a range: the type of the properties of its two ends, and how many of their units make
# one of the quantity's.
RANGES = {
    "Force": ("App::PropertyForce", 1e3),
    "Stress": ("App::PropertyPressure", 1e-3),
    "Utilisation": ("App::PropertyFloat", 1e2),
    "Length": ("App::PropertyLength", 1e3),
    "Deviation": ("App::PropertyLength", 1e3),
}
FROM, TO = "From", "To"

_OF_RANGE = {
    FROM: QT_TRANSLATE_NOOP(
        "App::Property", "Where a fixed range of this colouring begins (utilisation in %)"
    ),
    TO: QT_TRANSLATE_NOOP("App::Property", "Where a fixed range of this colouring ends (utilisation in %)"),
}

# (type, name, group, value in a new gridshell, documentation); of an enumeration the first of its values.
PROPERTIES = (
    (
        "App::PropertyEnumeration",
        "Colours",
        "Gridshell",
        (*QUANTITIES, NONE),
        QT_TRANSLATE_NOOP("App::Property", "What the colour of each member stands for"),
    ),
    (
        "App::PropertyBool",
        "ShowLegend",
        "Gridshell",
        True,
        QT_TRANSLATE_NOOP("App::Property", "Show what each colour stands for"),
    ),
    (
        "App::PropertyBool",
        "ShowReactions",
        "Gridshell",
        False,
        QT_TRANSLATE_NOOP("App::Property", "Show the reactions as arrows, all to one scale"),
    ),
    (
        "App::PropertyBool",
        "FixedRange",
        "Range of colours",
        False,
        QT_TRANSLATE_NOOP("App::Property", "Colour by the range that is given, unless its ends are equal"),
    ),
    *(
        (kind, name + end, "Range of colours", 0.0, _OF_RANGE[end])
        for name, (kind, _) in RANGES.items()
        for end in (FROM, TO)
    ),
)
NAMES = tuple(name for _, name, _, _, _ in PROPERTIES)

BEFORE = "ColourByForce"  # of files of an older version


def add_colouring(vobj):
    """Add the view properties that are not there yet, as in files of an older version."""
    for kind, name, group, value, documentation in PROPERTIES:
        if name not in vobj.PropertiesList:
            vobj.addProperty(kind, name, group, documentation)
            setattr(vobj, name, list(value) if kind == "App::PropertyEnumeration" else value)


def migrate_colouring(vobj):
    """Take over what a file of an older version says."""
    if BEFORE in vobj.PropertiesList:
        if not vobj.getPropertyByName(BEFORE):
            vobj.Colours = NONE
        vobj.removeProperty(BEFORE)


def is_complete(vobj):
    """Whether all view properties are there: they arrive one at a time while a file is read."""
    return all(name in vobj.PropertiesList for name in NAMES)


@dataclass(frozen=True)
class Colouring:
    """What the view properties say. quantity: None for no colours. limits: a fixed range, else None.
    section: CrossSection or None; wrong: what is wrong with it, else ""."""

    quantity: object = None
    limits: tuple = None
    section: object = None
    wrong: str = ""


def colouring_of(vobj):
    """The Colouring of a gridshell's view provider."""
    quantity = QUANTITIES.get(vobj.Colours)
    if quantity is None:
        return Colouring()
    section, wrong = section_or_fault(vobj.Object)
    return Colouring(quantity, limits_of(vobj, quantity), section, wrong if quantity.needs else "")


def section_or_fault(shell):
    """(CrossSection or None, what is wrong with it or "")."""
    if "SectionShape" not in shell.PropertiesList:
        return None, ""
    try:
        return section_of(shell), ""
    except EXPECTED as error:
        return None, str(reason(error))


def limits_of(vobj, quantity):
    """(low, high) in the unit of the quantity; None for the range of the members."""
    if not vobj.FixedRange or quantity.name not in RANGES:
        return None
    factor = RANGES[quantity.name][1]
    ends = [getattr(vobj, quantity.name + end) for end in (FROM, TO)]
    low, high = (getattr(end, "Value", end) / factor for end in ends)
    return (low, high) if math.isfinite(low) and math.isfinite(high) and low != high else None


def set_limits(vobj, quantity, low, high):
    factor = RANGES[quantity.name][1]
    for end, value in ((FROM, low), (TO, high)):
        setattr(vobj, quantity.name + end, value * factor)


class Coloured:
    """A Form in its colours.

    form: it. colouring: what they go by. scale: the Scale of it; None where it is not coloured, and then
    `missing` says why, or is "" where no colours are wanted.
    """

    def __init__(self, form, colouring):
        self.form, self.colouring = form, colouring
        self.scale, self.missing = None, colouring.wrong
        quantity = colouring.quantity
        if quantity is None or self.missing:
            return
        values = quantity.of(form, colouring.section)
        if values is None:
            self.missing = translate(MISSING[quantity.needs])
            return
        self.scale = Scale(
            values, quantity, are_in_tension(form), colouring.limits, preferences.ramps(), unit_of
        )

    @property
    def title(self):
        """Of the legend."""
        return translate(TITLES[self.colouring.quantity.name])

    def colours(self, plain):
        """List of (r, g, b) of each member; one that stands for all where they are not coloured.

        plain: that colour, where none are wanted.
        """
        if self.scale is None:
            return [preferences.ramps().unknown if self.missing else tuple(plain[:3])]
        return [tuple(colour) for colour in self.scale.colours().tolist()]

    def packed(self, plain):
        """(m,) of each member, as coin has them."""
        if self.scale is None:
            return np.repeat(packed(self.colours(plain)), len(self.form.members))
        return packed(self.scale.colours())

    def holds_for(self, form, colouring):
        """Whether another form, with this colouring, has the same colours."""
        before, quantity = self.form, colouring.quantity
        return (
            colouring == self.colouring
            and form.member_forces is before.member_forces
            and form.is_certified == before.is_certified
            and form.members is before.members
            and (quantity is None or not quantity.follows_nodes or form.nodes is before.nodes)
        )
