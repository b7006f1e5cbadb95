# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user has set on the page Funicular of FreeCAD's preferences, and what holds where nothing was set.

They are asked for each time, so that they count as soon as the page is closed. Resources/ui/preferences.ui
writes them by these names.
"""

import os

import FreeCAD
import FreeCADGui
import funicular_locate

from funicular import colours, wording
from funicular.gui.qt import QtCore

GROUP = "User parameter:BaseApp/Preferences/Mod/Funicular"
PAGE = os.path.join(funicular_locate.RESOURCE_FOLDER, "ui", "preferences.ui")

# In the order of the page's boxes, of which FreeCAD keeps the place.
FORCE_UNITS = ("auto", "N", "kN", "lbf", "kip")
PALETTES = (colours.ON_SCREEN, colours.ONE_RAMP)

DEFAULT_ACCURACY = 1.0  # [mm]
DEFAULT_FRAME = 33  # [ms]
FRAMES = (10, 200)  # [ms]


def force_units():
    """What forces are written in: of several units the largest of which there is one or more."""
    chosen = _chosen("ForceUnit", FORCE_UNITS)
    if chosen != "auto":
        return (chosen,)
    return ("lbf", "kip") if is_imperial() else ("N", "kN")


def is_imperial():
    """Whether FreeCAD's unit schema writes lengths in feet, inches or yards."""
    return FreeCAD.Units.Quantity(1000.0, FreeCAD.Units.Length).getUserPreferred()[2] not in ("mm", "cm", "m")


def ramps():
    """The colours.Ramps for members in the 3D view."""
    return _chosen("Palette", PALETTES)


def accuracy():
    """Of a new gridshell [mm]."""
    value = _group().GetFloat("Accuracy", DEFAULT_ACCURACY)
    # A page can write nothing, a file of parameters anything.
    return value if value > 0.0 else DEFAULT_ACCURACY


def frame_ms():
    """Time from one frame to the next while a form moves [ms]."""
    return min(max(_group().GetInt("FrameBudget", DEFAULT_FRAME), FRAMES[0]), FRAMES[1])


def animates():
    """Whether a form is shown on its way, rather than where it comes to."""
    return _group().GetBool("Animate", True)


def install():
    """Put the page into FreeCAD's preferences, and let all sentences be written as it says."""
    FreeCADGui.addIconPath(funicular_locate.ICON_FOLDER)
    FreeCADGui.addPreferencePage(PAGE, "Funicular")
    wording.habits = lambda: wording.Habits(
        force_units(), ("in", 0.0254) if is_imperial() else ("mm", 1e-3), QtCore.QLocale().decimalPoint()
    )


def _group():
    return FreeCAD.ParamGet(GROUP)


def _chosen(name, choices):
    place = _group().GetInt(name, 0)
    return choices[place] if 0 <= place < len(choices) else choices[0]
