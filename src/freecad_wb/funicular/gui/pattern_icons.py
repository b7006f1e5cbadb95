# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of each pattern, drawn from the lattice itself, in the colours of the user's theme."""

import funicular as fn

from .icons import ink_of_window
from .qt import QtCore, QtGui

# Drawn larger than it is shown, so that it is sharp on a screen of any density.
PIXELS, MARGIN = 96, 5
CELLS = {"kagome": 2}


def pattern_icon(pattern):
    """QIcon of a pattern by its name in the document, such as "Other diagonal"; empty without the core."""
    name = pattern.lower().replace(" ", "_")
    try:
        along_u, along_v = fn.cell_extent(name)
        # As square as whole cells are.
        cells_u = CELLS.get(name, 3)
        lattice = fn.lattice(cells_u, max(1, round(cells_u * along_u / along_v)), pattern=name)
    except (ImportError, ValueError):
        return QtGui.QIcon()
    pixmap = QtGui.QPixmap(PIXELS, PIXELS)
    pixmap.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(pixmap)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    pen = QtGui.QPen(ink_of_window(), 3.5)
    pen.setCapStyle(QtCore.Qt.RoundCap)
    painter.setPen(pen)
    extent = PIXELS - 2 * MARGIN
    points = [
        QtCore.QPointF(MARGIN + extent * u, MARGIN + extent * (1.0 - v)) for u, v in lattice.uv.tolist()
    ]
    for a, b in lattice.members.tolist():
        painter.drawLine(points[a], points[b])
    if name == "centred":
        # What sets it apart from members that pass each other.
        pen.setWidthF(11.0)
        painter.setPen(pen)
        for point in points:
            painter.drawPoint(point)
    painter.end()
    return QtGui.QIcon(pixmap)
