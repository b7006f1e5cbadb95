# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the tools with which nodes are picked."""

from funicular.gui.drawing.mark_shapes import COLOURS, DOT
from funicular.gui.drawn_icons import draw_dots, drawn_icon, polygon
from funicular.gui.icons import icon
from funicular.gui.qt import QtCore, QtGui

POINTER = ((30, 14), (30, 74), (45, 60), (54, 82), (64, 78), (55, 57), (74, 56))


def tool_icon(tool):
    """QIcon of a tool of pick_tools by its name."""
    return drawn_icon(_PICTURES[tool])


def _pointer(painter, ink):
    painter.setPen(QtGui.QPen(ink, 6.0, QtCore.Qt.SolidLine, QtCore.Qt.RoundCap, QtCore.Qt.RoundJoin))
    painter.drawPolygon(polygon(*POINTER))


def _nodes(painter, ink):
    painter.setPen(QtGui.QPen(ink, 4.0))
    for k in (24, 48, 72):
        painter.drawLine(QtCore.QPointF(10, k), QtCore.QPointF(86, k))
        painter.drawLine(QtCore.QPointF(k, 10), QtCore.QPointF(k, 86))
    draw_dots(painter, _accent(), [(48, 48)])


def _box(painter, ink):
    painter.setPen(_dashed(ink))
    painter.drawRect(QtCore.QRectF(12, 18, 72, 60))
    draw_dots(painter, _accent(), [(36, 40), (60, 58)])


def _lasso(painter, ink):
    painter.setPen(_dashed(ink))
    path = QtGui.QPainterPath(QtCore.QPointF(46, 86))
    path.cubicTo(-14, 76, 12, 6, 52, 12)
    path.cubicTo(112, 20, 84, 82, 46, 66)
    painter.drawPath(path)
    draw_dots(painter, _accent(), [(40, 40), (62, 42)])


def _edges(painter, ink):
    painter.setPen(QtGui.QPen(ink, 4.0))
    painter.drawPolygon(polygon((16, 40), (80, 16), (84, 62), (20, 82)))
    painter.setPen(QtGui.QPen(_accent(), 12.0, QtCore.Qt.SolidLine, QtCore.Qt.RoundCap))
    painter.drawLine(QtCore.QPointF(20, 82), QtCore.QPointF(84, 62))


def _raise(painter, _ink):
    QtGui.QIcon(icon("Funicular_Raise")).paint(painter, QtCore.QRect(6, 6, 84, 84))


_PICTURES = {
    "Off": _pointer,
    "Nodes": _nodes,
    "Box": _box,
    "Lasso": _lasso,
    "Edges": _edges,
    "Raise": _raise,
}


def _accent():
    return QtGui.QColor(COLOURS[DOT])


def _dashed(ink):
    pen = QtGui.QPen(ink, 6.0)
    pen.setDashPattern((2.0, 1.4))
    return pen
