# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the tools with which nodes are picked, in the colours of the user's theme."""

from funicular.gui.drawing.mark_shapes import COLOURS, DOT
from funicular.gui.icons import ink_of_window
from funicular.gui.qt import QtCore, QtGui

PIXELS = 96
POINTER = ((30, 14), (30, 74), (45, 60), (54, 82), (64, 78), (55, 57), (74, 56))


def tool_icon(tool):
    """QIcon of a tool of pick_tools by its name."""
    pixmap = QtGui.QPixmap(PIXELS, PIXELS)
    pixmap.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(pixmap)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    ink = ink_of_window()
    accent = QtGui.QColor(COLOURS[DOT])
    dashed = QtGui.QPen(ink, 6.0)
    dashed.setDashPattern((2.0, 1.4))
    painter.setPen(dashed)
    if tool == "Off":
        painter.setPen(QtGui.QPen(ink, 6.0, QtCore.Qt.SolidLine, QtCore.Qt.RoundCap, QtCore.Qt.RoundJoin))
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(*at) for at in POINTER]))
    elif tool == "Box":
        painter.drawRect(QtCore.QRectF(12, 18, 72, 60))
        _dots(painter, accent, (36, 40), (60, 58))
    elif tool == "Lasso":
        path = QtGui.QPainterPath(QtCore.QPointF(46, 86))
        path.cubicTo(-14, 76, 12, 6, 52, 12)
        path.cubicTo(112, 20, 84, 82, 46, 66)
        painter.drawPath(path)
        _dots(painter, accent, (40, 40), (62, 42))
    elif tool == "Edges":
        painter.setPen(QtGui.QPen(ink, 4.0))
        painter.drawPolygon(
            QtGui.QPolygonF([QtCore.QPointF(*at) for at in ((16, 40), (80, 16), (84, 62), (20, 82))])
        )
        painter.setPen(QtGui.QPen(accent, 12.0, QtCore.Qt.SolidLine, QtCore.Qt.RoundCap))
        painter.drawLine(QtCore.QPointF(20, 82), QtCore.QPointF(84, 62))
    else:
        painter.setPen(QtGui.QPen(ink, 4.0))
        for k in (24, 48, 72):
            painter.drawLine(QtCore.QPointF(10, k), QtCore.QPointF(86, k))
            painter.drawLine(QtCore.QPointF(k, 10), QtCore.QPointF(k, 86))
        _dots(painter, accent, (48, 48))
    painter.end()
    return QtGui.QIcon(pixmap)


def _dots(painter, colour, *places):
    pen = QtGui.QPen(colour, 22.0)
    pen.setCapStyle(QtCore.Qt.RoundCap)
    painter.setPen(pen)
    for place in places:
        painter.drawPoint(QtCore.QPointF(*place))
