# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of buttons in the colours of the user's theme; of one that is chosen, on a pane: not every style
sheet lets a button that is down be told from the others."""

from funicular.gui.icons import ink_of_window
from funicular.gui.qt import QtCore, QtGui, QtWidgets

PIXELS = 96
PANE = 70  # of 255, how much of what is behind it the pane covers


def drawn_icon(paint):
    """QIcon of what paint(painter, ink) draws on a square of PIXELS by PIXELS. ink: QColor."""
    icon, ink = QtGui.QIcon(), ink_of_window()
    for state in (QtGui.QIcon.Off, QtGui.QIcon.On):
        pixmap = QtGui.QPixmap(PIXELS, PIXELS)
        pixmap.fill(QtCore.Qt.transparent)
        painter = QtGui.QPainter(pixmap)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        if state == QtGui.QIcon.On:
            _draw_pane(painter)
        paint(painter, ink)
        painter.end()
        icon.addPixmap(pixmap, QtGui.QIcon.Normal, state)
    return icon


def draw_dots(painter, colour, places, size=22.0):
    """Round dots at places (x, y)."""
    pen = QtGui.QPen(colour, size)
    pen.setCapStyle(QtCore.Qt.RoundCap)
    painter.setPen(pen)
    for place in places:
        painter.drawPoint(QtCore.QPointF(*place))


def polygon(*places):
    """QPolygonF through places (x, y)."""
    return QtGui.QPolygonF([QtCore.QPointF(*place) for place in places])


def _draw_pane(painter):
    colour = QtWidgets.QApplication.palette().color(QtGui.QPalette.Highlight)
    painter.setPen(QtGui.QPen(colour, 5.0))
    colour.setAlpha(PANE)
    painter.setBrush(colour)
    painter.drawRoundedRect(QtCore.QRectF(2.5, 2.5, PIXELS - 5, PIXELS - 5), 10, 10)
    painter.setBrush(QtCore.Qt.NoBrush)
