# SPDX-License-Identifier: LGPL-2.1-or-later
"""The marks of supports: of one size on the screen at any zoom, and as pictures for lists and buttons."""

import numpy as np
from pivy import coin

from funicular.gui.qt import QtCore, QtGui, QtWidgets

POINT, LINE, PLANE, YIELDS, FREE = "point", "line", "plane", "yields", "free"
# Around what is chosen, around what the mouse is on, and on what is picked.
RING, HOVER, DOT = "ring", "hover", "dot"

# Colours of Okabe and Ito, which everyone tells apart; that of what is picked is no force's and no support's.
COLOURS = {
    POINT: "#d55e00",
    LINE: "#0072b2",
    PLANE: "#009e73",
    YIELDS: "#b07800",
    FREE: "#555555",
    RING: "#e81f99",
    HOVER: "#111111",
    DOT: "#e81f99",
}
SIZE = 21  # [points] of a mark, around its node
HALO = 2.0  # [points] of white around it

SMALL = 0.55  # of that size, where marks stand close

# Below their node: in the middle of a picture, higher.
STANDING, HALF_HEIGHT = (POINT, YIELDS), 4.5

_markers = {}


def marker(shape, with_halo=False, is_small=False):
    """Number of a mark among coin's markers."""
    key = shape, with_halo, is_small
    if key not in _markers:
        _markers[key] = _new_marker(*key)
    return _markers[key]


def mark_icon(shape):
    """QIcon of a mark in its colour."""
    pixels = 4 * SIZE
    pixmap = QtGui.QPixmap(pixels, pixels)
    pixmap.fill(QtCore.Qt.transparent)
    up = HALF_HEIGHT if shape in STANDING else 0.0
    _paint(pixmap, shape, 4.0, QtGui.QColor(COLOURS[shape]), 0.0, up)
    return QtGui.QIcon(pixmap)


def _new_marker(shape, with_halo, is_small):
    ratio = QtWidgets.QApplication.instance().devicePixelRatio() * (SMALL if is_small else 1.0)
    # Whole bytes a row, so that no row begins within one.
    pixels = 8 * int(np.ceil((SIZE + 2) * ratio / 8.0))
    image = QtGui.QImage(pixels, pixels, QtGui.QImage.Format_Grayscale8)
    image.fill(0)
    _paint(image, shape, ratio, QtGui.QColor("white"), HALO if with_halo else 0.0)
    rows = np.frombuffer(bytes(image.constBits()), dtype=np.uint8).reshape(pixels, -1)[:, :pixels]
    # As pivy takes them: a character for each pixel, a blank where there is nothing.
    bits = np.where(rows > 127, ord("#"), ord(" ")).astype(np.uint8).tobytes()
    number = coin.SoMarkerSet.getNumDefinedMarkers()
    coin.SoMarkerSet.addMarker(number, coin.SbVec2s(pixels, pixels), bits, False, True)
    return number


def _paint(device, shape, scale, colour, halo, up=0.0):
    painter = QtGui.QPainter(device)
    painter.setRenderHint(QtGui.QPainter.Antialiasing, halo == 0.0 and device.depth() > 8)
    painter.translate(device.width() / 2.0, device.height() / 2.0)
    painter.scale(scale, scale)
    painter.translate(0.0, -up)
    filled, stroked, width = _path(shape)
    if halo:
        painter.strokePath(
            filled,
            QtGui.QPen(colour, 2.0 * halo, QtCore.Qt.SolidLine, QtCore.Qt.RoundCap, QtCore.Qt.RoundJoin),
        )
    painter.fillPath(filled, colour)
    painter.strokePath(stroked, QtGui.QPen(colour, width + 2.0 * halo))
    painter.end()


def _path(shape):
    """(what is filled, what is drawn as lines, width of these) around the node at (0, 0), y downwards."""
    filled, lines, width = QtGui.QPainterPath(), QtGui.QPainterPath(), 2.0
    if shape == POINT:
        # As on a drawing of a structure: it stands on the tip, on the ground.
        _polygon(filled, (0, 0), (6, 8), (-6, 8))
        _polyline(lines, (-8, 9), (8, 9))
    elif shape == LINE:
        filled.addEllipse(QtCore.QPointF(0, 0), 5.0, 5.0)
    elif shape == PLANE:
        _polygon(filled, (-5, -5), (5, -5), (5, 5), (-5, 5))
    elif shape == YIELDS:
        # A spring on the ground.
        _polyline(lines, (0, 0), (0, 1), (5, 2.5), (-5, 5), (5, 7.5), (0, 9))
        _polyline(lines, (-7, 9.5), (7, 9.5))
    elif shape == FREE:
        _polyline(lines, (-5, -5), (5, 5))
        _polyline(lines, (-5, 5), (5, -5))
    elif shape in (RING, HOVER):
        lines.addEllipse(QtCore.QPointF(0, 0), 8.5, 8.5)
    elif shape == DOT:
        filled.addEllipse(QtCore.QPointF(0, 0), 4.0, 4.0)
    return filled, lines, width


def _polygon(path, *corners):
    _polyline(path, *corners)
    path.closeSubpath()


def _polyline(path, first, *others):
    path.moveTo(*first)
    for other in others:
        path.lineTo(*other)
