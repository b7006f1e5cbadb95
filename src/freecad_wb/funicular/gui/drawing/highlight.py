# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes and members that are shown among the others: thick, and in a colour that no force has."""

import numpy as np
from pivy import coin

from funicular.gui.drawing.shapes import set_points

COLOUR = (0.91, 0.12, 0.60)
LINE_WIDTH, POINT_SIZE = 7.0, 11.0


class Highlight:
    """Coin nodes below `root`; empty until something is shown. rgb: their colour."""

    def __init__(self, root, rgb=COLOUR):
        self._root = root
        self._nodes, self._members = (), ()
        self.separator = coin.SoSeparator()
        colour = coin.SoBaseColor()
        colour.rgb = rgb
        style = coin.SoDrawStyle()
        style.lineWidth, style.pointSize = LINE_WIDTH, POINT_SIZE
        self._line_points, self._points = coin.SoCoordinate3(), coin.SoCoordinate3()
        self._lines, self._dots = coin.SoLineSet(), coin.SoPointSet()
        # Coin would take one point, at the origin, for what there is to be seen.
        self._lines.numVertices.setNum(0)
        self._dots.numPoints = 0
        for node in (colour, style, self._line_points, self._lines, self._points, self._dots):
            self.separator.addChild(node)
        root.addChild(self.separator)

    def choose(self, nodes=(), members=()):
        """Show these, by their numbers, from the next form on."""
        self._nodes, self._members = np.asarray(nodes, dtype=int), np.asarray(members, dtype=int)

    def show(self, form):
        """Show what is chosen where it is in a Form."""
        if len(self._members) and self._members.max() >= len(form.members):
            self._members = ()
        if len(self._nodes) and self._nodes.max() >= len(form.nodes):
            self._nodes = ()
        members, nodes = np.asarray(self._members, dtype=int), np.asarray(self._nodes, dtype=int)
        set_points(self._line_points, form.drawn_nodes[form.members[members]].reshape(-1, 3))
        self._lines.numVertices.setValues(0, len(self._members), [2] * len(self._members))
        self._lines.numVertices.setNum(len(self._members))
        set_points(self._points, form.drawn_nodes[nodes])
        self._dots.numPoints = len(self._nodes)
