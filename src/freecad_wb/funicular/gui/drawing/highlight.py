# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes and members that are shown among the others: thick, and in a colour that no force has."""

import numpy as np
from pivy import coin

COLOUR = (0.91, 0.12, 0.60)
LINE_WIDTH, POINT_SIZE = 7.0, 11.0
MILLIMETRES = 1e3  # of a metre


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
        ends = (
            form.drawn_nodes[form.members[list(self._members)]].reshape(-1, 3) if len(self._members) else ()
        )
        _set(self._line_points, ends)
        self._lines.numVertices.setValues(0, len(self._members), [2] * len(self._members))
        self._lines.numVertices.setNum(len(self._members))
        dots = form.drawn_nodes[list(self._nodes)] if len(self._nodes) else ()
        _set(self._points, dots)
        self._dots.numPoints = len(self._nodes)


def _set(coordinates, points):
    points = (np.asarray(points) * MILLIMETRES).tolist() if len(points) else []
    coordinates.point.setValues(0, len(points), points)
    coordinates.point.setNum(len(points))
