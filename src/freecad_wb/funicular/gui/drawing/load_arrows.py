# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point loads as arrows in the 3D view, each with its tip on the node that bears it."""

import numpy as np
from pivy import coin

from funicular.arrows import POINTS, arrow_lines, arrow_points

# Unlike any force in a member, and seen on white as on dark blue.
COLOUR = (0.62, 0.18, 0.66)
LINE_WIDTH, FONT_SIZE = 3.0, 12
# Of the size of what bears it: the arrow of the largest load.
LONGEST = 0.15
LABEL = " ".join(map(str, COLOUR))


def size_of(nodes):
    """Of nodes (n, 3): the longest edge of the box that holds them."""
    # By columns, for along rows of three numpy takes ten times as long.
    return max((float(np.ptp(column)) for column in nodes.T), default=0.0)


class LoadArrows:
    """The arrows of one load, and beside one of them what it is. root: a coin node to be hung somewhere."""

    def __init__(self):
        self.root = coin.SoSeparator()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        colour, style = coin.SoBaseColor(), coin.SoDrawStyle()
        colour.rgb, style.lineWidth = COLOUR, LINE_WIDTH
        self._points, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        # FreeCAD's own, which can be read before anything; in front of what lies there.
        front, self._place = coin.SoAnnotation(), coin.SoTranslation()
        self._label = coin.SoType.fromName("SoFrameLabel").createInstance()
        for name, value in (("size", FONT_SIZE), ("textColor", "1 1 1"), ("backgroundColor", LABEL)):
            self._label.getField(name).set(str(value))
        for node in (self._place, self._label):
            front.addChild(node)
        for node in (light, colour, style, self._points, self._lines, front):
            self.root.addChild(node)
        self._count = self.text = None
        self.show(np.zeros((0, 3)), (0.0, 0.0, -1.0), 0.0, "")

    def show(self, nodes, direction, length, text):
        """Draw other arrows in place of those before.

        nodes: (k, 3), where their tips are, and length, both in mm. direction: (3,), all point there.
        """
        points = arrow_points(nodes, np.tile(direction, (len(nodes), 1)), length).astype(np.float32)
        count = len(points) // POINTS if length > 0.0 else 0
        if count != self._count:
            # No line may name a point that is not there any more.
            self._lines.coordIndex.setNum(0)
        self._points.point.setValues(0, len(points), points)
        self._points.point.setNum(len(points))
        if count != self._count:
            indices = np.column_stack([arrow_lines(count), np.full(5 * count, -1)]).ravel().tolist()
            self._lines.coordIndex.setValues(0, len(indices), indices)
            self._count = count
        text = text if count else ""
        if text != self.text:
            self.text = text
            self._label.getField("string").set(f'"{text}"')
        if count:
            # Where it begins, away from members and nodes.
            self._place.translation = [float(each) for each in points[POINTS * (count // 2)]]
