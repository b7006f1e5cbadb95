# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reactions of a form as arrows in the 3D view, below the view provider of its gridshell."""

import numpy as np
from pivy import coin

from funicular.arrows import LONGEST, POINTS, arrow_lines, arrow_points
from funicular.gui.drawing.shapes import MILLIMETRES

# Unlike any force, and seen on white as on dark blue.
COLOUR = (0.13, 0.62, 0.25)
LINE_WIDTH = 2.0
NAME = "Funicular_reactions"


class ReactionArrows:
    """One arrow a reaction, its tip at the node that is held; the largest is a fifth of the net's size."""

    def __init__(self, vobj):
        self._vobj = vobj
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        unpickable, light = coin.SoPickStyle(), coin.SoLightModel()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        colour, style = coin.SoBaseColor(), coin.SoDrawStyle()
        colour.rgb, style.lineWidth = COLOUR, LINE_WIDTH
        self._points, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        for node in (unpickable, light, colour, style, self._points, self._lines):
            self._root.addChild(node)
        # Before the shape, for what hides that hides what follows too.
        vobj.RootNode.insertChild(self._root, max(vobj.RootNode.findChild(vobj.SwitchNode), 0))
        self._count = 0

    def show(self, form):
        """Those of a Form in place of the ones before."""
        held = np.flatnonzero(np.abs(form.reactions).sum(axis=1))
        size = float(np.ptp(form.drawn_nodes, axis=0).max(initial=0.0))
        points = arrow_points(form.drawn_nodes[held], form.reactions[held], LONGEST * size)
        points = (points * MILLIMETRES).astype(np.float32)
        count = len(points) // POINTS
        is_new = count != self._count
        if is_new:
            # No line may name a point that is not there any more.
            self._lines.coordIndex.setNum(0)
        self._points.point.setValues(0, len(points), points)
        self._points.point.setNum(len(points))
        if is_new:
            self._count = count
            lines = arrow_lines(count)
            indices = np.column_stack([lines, np.full(len(lines), -1)]).ravel().tolist()
            self._lines.coordIndex.setValues(0, len(indices), indices)

    def remove(self):
        try:
            self._vobj.RootNode.removeChild(self._root)
        except (ReferenceError, RuntimeError):
            pass  # the gridshell is gone, and what was below it
