# SPDX-License-Identifier: LGPL-2.1-or-later
"""A node on its way up or down: where it was, its members as they would go, and the height beside it."""

import FreeCADGui
import numpy as np
from pivy import coin

from funicular.gui.drawing.shapes import set_field
from funicular.gui.qt import QtCore, QtGui

NAME = "Funicular_raise"
COLOUR = (0.91, 0.12, 0.60)
LINE_WIDTH, GUIDE_WIDTH = 4.0, 1.5
PAPER, INK = QtGui.QColor(255, 255, 255, 235), QtGui.QColor(25, 30, 40)
MARGIN, BESIDE, TEXT = 6, 14, 13  # [points]


class RaiseDrawing:
    """Below the view provider of a gridshell while a node is dragged."""

    def __init__(self, vobj):
        self._vobj, self._shown = vobj, False
        # After all else, so that no line hides it.
        self._root = coin.SoAnnotation()
        self._root.setName(NAME)
        unpickable, light = coin.SoPickStyle(), coin.SoLightModel()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        colour = coin.SoBaseColor()
        colour.rgb = COLOUR
        guide, thick = coin.SoDrawStyle(), coin.SoDrawStyle()
        guide.lineWidth, guide.linePattern = GUIDE_WIDTH, 0x3333
        thick.lineWidth = LINE_WIDTH
        self._way, self._members = coin.SoCoordinate3(), coin.SoCoordinate3()
        self._lines, self._place, self._label = coin.SoLineSet(), coin.SoTranslation(), coin.SoImage()
        self._label.vertAlignment = coin.SoImage.HALF
        for node in (unpickable, light, colour, guide, self._way, coin.SoLineSet()):
            self._root.addChild(node)
        for node in (thick, self._members, self._lines, self._place, self._label):
            self._root.addChild(node)

    def show(self, base, height, neighbours, text):
        """base: (3,) where the node is, height: above it, neighbours: (k, 3) the others' ends [mm]."""
        if not self._shown:
            self._vobj.RootNode.addChild(self._root)
            self._shown = True
        top = base + (0.0, 0.0, height)
        set_field(self._way.point, [tuple(base), tuple(top)])
        set_field(
            self._members.point,
            np.stack([np.broadcast_to(top, neighbours.shape), neighbours], 1).reshape(-1, 3).tolist(),
        )
        set_field(self._lines.numVertices, [2] * len(neighbours))
        self._place.translation = tuple(top)
        picture = _picture(text, FreeCADGui.getMainWindow().devicePixelRatioF())
        rows = bytes(picture.mirrored(False, True).constBits())
        self._label.image.setValue(coin.SbVec2s(picture.width(), picture.height()), 4, rows)

    def hide(self):
        if self._shown:
            self._shown = False
            try:
                self._vobj.RootNode.removeChild(self._root)
            except (ReferenceError, RuntimeError):
                pass  # the gridshell is gone, and what was below it


def _picture(text, ratio):
    font = QtGui.QFont(FreeCADGui.getMainWindow().font())
    font.setPixelSize(TEXT)
    metrics = QtGui.QFontMetrics(font)
    # At its left nothing, so that it stands beside the node.
    width, height = metrics.horizontalAdvance(text) + 2 * MARGIN + 1, metrics.height() + MARGIN
    picture = QtGui.QImage(
        round((BESIDE + width) * ratio), round(height * ratio), QtGui.QImage.Format_RGBA8888
    )
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    painter.scale(ratio, ratio)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(PAPER)
    box = QtCore.QRectF(BESIDE, 0, width, height)
    painter.drawRoundedRect(box, 4, 4)
    painter.setPen(INK)
    painter.setFont(font)
    painter.drawText(box, QtCore.Qt.AlignCenter, text)
    painter.end()
    return picture
