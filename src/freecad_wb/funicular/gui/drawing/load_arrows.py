# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point loads as arrows in the 3D view, each with its tip on the node that bears it."""

import numpy as np
from pivy import coin

from funicular.arrows import POINTS, arrow_points
from funicular.gui.drawing.shapes import Arrows

# Unlike any force in a member, and seen on white as on dark blue.
COLOUR = (0.62, 0.18, 0.66)
LINE_WIDTH, FONT_SIZE = 3.0, 12
# Of the size of what bears it: the arrow of the largest load.
LONGEST = 0.15
LABEL = " ".join(map(str, COLOUR))


class LoadArrows:
    """The arrows of one load, and beside one of them what it is. root: a coin node to be hung somewhere."""

    def __init__(self):
        self.root = coin.SoSeparator()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        colour, style = coin.SoBaseColor(), coin.SoDrawStyle()
        colour.rgb, style.lineWidth = COLOUR, LINE_WIDTH
        self._arrows = Arrows()
        # FreeCAD's own, which can be read before anything; in front of what lies there.
        front, self._place = coin.SoAnnotation(), coin.SoTranslation()
        self._label = coin.SoType.fromName("SoFrameLabel").createInstance()
        for name, value in (("size", FONT_SIZE), ("textColor", "1 1 1"), ("backgroundColor", LABEL)):
            self._label.getField(name).set(str(value))
        for node in (self._place, self._label):
            front.addChild(node)
        for node in (light, colour, style, self._arrows.group, front):
            self.root.addChild(node)
        self.text = None
        self.show(np.zeros((0, 3)), (0.0, 0.0, -1.0), 0.0, "")

    def show(self, nodes, direction, length, text):
        """Draw other arrows in place of those before.

        nodes: (k, 3), where their tips are, and length, both in mm. direction: (3,), all point there.
        """
        points = arrow_points(nodes, np.tile(direction, (len(nodes), 1)), length)
        points = points if length > 0.0 else points[:0]
        self._arrows.show(points)
        count = len(points) // POINTS
        text = text if count else ""
        if text != self.text:
            self.text = text
            self._label.getField("string").set(f'"{text}"')
        if count:
            # Where it begins, away from members and nodes.
            self._place.translation = [float(each) for each in points[POINTS * (count // 2)]]
