# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a gridshell is to be seen: properties of its view provider, and what they say taken together."""

import math
from dataclasses import dataclass, replace

from funicular.gui.qt import QT_TRANSLATE_NOOP

LINES, ROUND, RECTANGULAR = "Lines", "Round bars", "Rectangular bars"
COVERING, AND_COVERING = "Covering", " and covering"
# Written out, to be found for translation: with its covering each is what it is, and AND_COVERING.
DISPLAYS = (
    QT_TRANSLATE_NOOP("Funicular", "Lines"),
    QT_TRANSLATE_NOOP("Funicular", "Round bars"),
    QT_TRANSLATE_NOOP("Funicular", "Rectangular bars"),
    QT_TRANSLATE_NOOP("Funicular", "Covering"),
    QT_TRANSLATE_NOOP("Funicular", "Lines and covering"),
    QT_TRANSLATE_NOOP("Funicular", "Round bars and covering"),
    QT_TRANSLATE_NOOP("Funicular", "Rectangular bars and covering"),
)

LEAST_EXAGGERATION, MOST_EXAGGERATION = 1.0, 20.0

# (type, name, value in a new gridshell, documentation); of an enumeration the first of its values.
PROPERTIES = (
    (
        "App::PropertyEnumeration",
        "Display",
        DISPLAYS,
        QT_TRANSLATE_NOOP("App::Property", "What is drawn of the gridshell: members, its covering, or both"),
    ),
    (
        "App::PropertyLength",
        "BarWidth",
        80.0,
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Diameter of round bars, width of others; where such a section is given, its own",
        ),
    ),
    (
        "App::PropertyLength",
        "BarHeight",
        120.0,
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Height of rectangular bars, upright; where such a section is given, its own",
        ),
    ),
    (
        "App::PropertyBool",
        "ShowSource",
        False,
        QT_TRANSLATE_NOOP("App::Property", "Show the net as it was laid, pale, beside what it has become"),
    ),
    (
        "App::PropertyBool",
        "ShowGround",
        False,
        QT_TRANSLATE_NOOP("App::Property", "Show level ground at the lowest node, and the shadow on it"),
    ),
    (
        "App::PropertyAngle",
        "SunAzimuth",
        225.0,
        QT_TRANSLATE_NOOP(
            "App::Property", "Where the sun stands, from north (y) clockwise: 180° is in the south"
        ),
    ),
    (
        "App::PropertyAngle",
        "SunAltitude",
        50.0,
        QT_TRANSLATE_NOOP(
            "App::Property", "How high the sun stands above the horizon; below 5° it is taken for 5°"
        ),
    ),
    (
        "App::PropertyFloat",
        "Exaggeration",
        LEAST_EXAGGERATION,
        QT_TRANSLATE_NOOP(
            "App::Property", "How many times larger than it is the way from the source is drawn: 1 to 20"
        ),
    ),
)
NAMES = tuple(name for _, name, _, _ in PROPERTIES)


@dataclass(frozen=True)
class Look:
    """What the properties say. members: LINES, ROUND, RECTANGULAR, or "" for none. In mm and °."""

    members: str = LINES
    covering: bool = False
    width: float = 0.0
    height: float = 0.0
    source: bool = False
    ground: bool = False
    azimuth: float = 0.0
    altitude: float = 90.0
    exaggeration: float = 1.0

    @property
    def bars(self):
        """Whether members are drawn as bars."""
        return self.members in (ROUND, RECTANGULAR)

    @property
    def is_left_to_shape(self):
        """Whether the members are those of the gridshell's own shape; a shadow needs lines of its own."""
        return self.members == LINES and self.exaggeration == 1.0 and not self.ground

    @property
    def is_plain(self):
        """Whether nothing is asked for but the gridshell's own shape."""
        return self.is_left_to_shape and not (self.covering or self.source)

    def fit_for(self, form):
        """What can be seen of a form: one without panels has no covering, and then shows its members."""
        if len(form.panels):
            return self
        return replace(self, covering=False, members=self.members or LINES)


def add_look(vobj, group):
    """Add the view properties that are not there yet, as in files of an older version."""
    for kind, name, value, documentation in PROPERTIES:
        if name not in vobj.PropertiesList:
            vobj.addProperty(kind, name, group, documentation)
            setattr(vobj, name, list(value) if kind == "App::PropertyEnumeration" else value)


def look_of(vobj):
    """The Look of a gridshell; plain lines while properties are missing, as when a file is read."""
    if any(name not in vobj.PropertiesList for name in NAMES) or vobj.Display not in DISPLAYS:
        return Look()
    display, width, height = vobj.Display, vobj.BarWidth.Value, vobj.BarHeight.Value
    if is_as_section(vobj):
        width, height = vobj.Object.SectionWidth.Value, vobj.Object.SectionHeight.Value
    members = display.replace(AND_COVERING, "")
    if (members == ROUND and not width) or (members == RECTANGULAR and not width * height):
        # Bars without a size would not be seen.
        members = LINES
    return Look(
        "" if members == COVERING else members,
        display == COVERING or display.endswith(AND_COVERING),
        width,
        height,
        vobj.ShowSource,
        vobj.ShowGround,
        vobj.SunAzimuth.Value,
        vobj.SunAltitude.Value,
        exaggeration_of(vobj),
    )


def is_as_section(vobj):
    """Whether bars are drawn as large as the section of the members, one of their shape being given."""
    shape = getattr(vobj.Object, "SectionShape", "")
    return bool(shape) and vobj.Display.startswith(shape)


def exaggeration_of(vobj):
    """The factor of the way from the source, between 1 and 20 whatever a script has set."""
    factor = getattr(vobj, "Exaggeration", 1.0)
    if not math.isfinite(factor):
        return LEAST_EXAGGERATION
    return min(max(factor, LEAST_EXAGGERATION), MOST_EXAGGERATION)
