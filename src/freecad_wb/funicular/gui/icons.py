# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths of this addon's icons, and the colour of those that are drawn."""

import os

import FreeCADGui
import funicular_locate

from funicular.gui.qt import QtGui, QtWidgets


def icon(name):
    """Path of Resources/icons/<name>.svg, as FreeCAD's Pixmap and getIcon() take it."""
    return os.path.join(funicular_locate.ICON_FOLDER, name + ".svg")


def ink_of_window():
    """QColor of text in FreeCAD's window: under a style sheet the application's palette does not tell."""
    probe = QtWidgets.QLabel(FreeCADGui.getMainWindow())
    probe.ensurePolished()
    colour = QtGui.QColor(probe.palette().color(QtGui.QPalette.WindowText))
    probe.setParent(None)
    probe.deleteLater()
    return colour
