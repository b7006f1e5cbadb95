# SPDX-License-Identifier: LGPL-2.1-or-later
"""In which direction a support lets its nodes slide: along an axis, or as a selected edge or face says."""

import FreeCAD
import FreeCADGui
import Part

from funicular.gui.picking import WrongSelection
from funicular.gui.qt import QT_TRANSLATE_NOOP, translate

SELECTED = "Selected"
CHOICES = (
    ("z", QT_TRANSLATE_NOOP("Funicular", "z, upright")),
    ("x", QT_TRANSLATE_NOOP("Funicular", "x")),
    ("y", QT_TRANSLATE_NOOP("Funicular", "y")),
    (SELECTED, QT_TRANSLATE_NOOP("Funicular", "selected edge or face")),
)
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def direction_of(choice, shell):
    """The unit App.Vector of one of CHOICES, as the gridshell has its own axes.

    A straight edge has its own direction, a plane face that of its normal. Raises WrongSelection for SELECTED
    unless one of these is selected.
    """
    if choice in AXES:
        return FreeCAD.Vector(*AXES[choice])
    parts = [
        selected.Object.getSubObject(path)
        for selected in FreeCADGui.Selection.getSelectionEx("", 0)
        for path in selected.SubElementNames
        if path.rpartition(".")[2].startswith(("Edge", "Face"))
    ]
    if len(parts) != 1:
        raise WrongSelection(
            translate("{} edges and faces are selected: select one, in the model or the 3D view.").format(
                len(parts)
            )
        )
    direction = _direction(parts[0])
    return shell.getGlobalPlacement().Rotation.inverted().multVec(direction).normalize()


def _direction(part):
    if isinstance(part, Part.Edge) and isinstance(part.Curve, (Part.Line, Part.LineSegment)):
        return part.tangentAt(part.FirstParameter)
    if isinstance(part, Part.Face):
        surface = part.Surface if isinstance(part.Surface, Part.Plane) else part.findPlane()
        if surface is not None:
            return FreeCAD.Vector(surface.Axis)
    raise WrongSelection(
        translate(
            "What is selected is curved and has no one direction: select a straight edge or a plane face."
        )
    )
