# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small picture of a form: all of it and nothing else, whatever part of it the 3D view shows."""

import numpy as np

from funicular.gui.qt import QtCore, QtGui

MARGIN = 0.06  # of the width
# Drawn so much larger, for lines thinner than a pixel.
TIMES = 4
LINE = 0.012  # of the height


def net_picture(form, colours, rotation, width, height):
    """A PNG picture, as bytes.

    Parameters
    ----------
    form : funicular.form.Form
    colours : list of (r, g, b)
        Of each member; one for all of them.
    rotation : (3, 3) array
        Rows: to the right, upward, and toward the eye.
    width, height : int
        [px]
    """
    across, up, near = rotation @ (form.nodes - form.nodes.mean(axis=0)).T
    size = np.array([width, height]) * TIMES
    low, high = np.array([across.min(), up.min()]), np.array([across.max(), up.max()])
    scale = ((1 - 2 * MARGIN) * size / np.maximum(high - low, 1e-6 * np.ptp(form.nodes) + 1e-12)).min()
    places = 0.5 * size + scale * (np.column_stack([across, up]) - 0.5 * (low + high)) * (1, -1)
    image = QtGui.QImage(*size.tolist(), QtGui.QImage.Format_ARGB32_Premultiplied)
    image.fill(QtCore.Qt.white)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    # What is nearest comes last.
    order = np.argsort(near[form.members].sum(axis=1))
    ends = places[form.members].reshape(-1, 4).tolist()
    pens = [
        QtGui.QPen(QtGui.QColor.fromRgbF(*each), LINE * size[1], QtCore.Qt.SolidLine, QtCore.Qt.RoundCap)
        for each in colours
    ]
    for member in order.tolist():
        painter.setPen(pens[member] if len(pens) > 1 else pens[0])
        painter.drawLine(QtCore.QLineF(*ends[member]))
    painter.end()
    small = image.scaled(width, height, QtCore.Qt.IgnoreAspectRatio, QtCore.Qt.SmoothTransformation)
    data = QtCore.QByteArray()
    buffer = QtCore.QBuffer(data)
    buffer.open(QtCore.QIODevice.WriteOnly)
    small.save(buffer, "PNG")
    return bytes(data)
