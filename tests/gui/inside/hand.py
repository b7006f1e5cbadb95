# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D view, and keys as FreeCAD's window gets them."""

import FreeCADGui as Gui
import numpy as np
from window import QtCore, QtGui, QtWidgets, settle

LEFT, NONE = QtCore.Qt.LeftButton, QtCore.Qt.NoButton


def panel():
    """The GridshellPanel that is open."""
    shell = Gui.ActiveDocument.getInEdit().Object
    return shell.ViewObject.Proxy._panel


def viewport():
    """The widget of the 3D view in front; not by the view's own graphicsView(), which PySide would keep."""
    return next(
        widget
        for widget in QtWidgets.QApplication.allWidgets()
        if widget.inherits("QOpenGLWidget") and widget.isVisible() and not widget.visibleRegion().isEmpty()
    )


def places(points):
    """(n, 2) places in the viewport of points (n, 3) [mm]."""
    from funicular.gui.drawing.on_screen import OnScreen

    return OnScreen(Gui.ActiveDocument.ActiveView).of(np.atleast_2d(points))[0]


def place_of(node):
    """Where a node of the form that is shown is in the viewport."""
    return places(panel().session.form.drawn_nodes[[node]] * 1e3)[0]


def mouse(kind, place, button=NONE, buttons=NONE, modifiers=QtCore.Qt.NoModifier):
    at = QtCore.QPointF(*map(float, place))
    on_screen = QtCore.QPointF(viewport().mapToGlobal(at.toPoint()))
    event = QtGui.QMouseEvent(getattr(QtCore.QEvent, kind), at, on_screen, button, buttons, modifiers)
    QtWidgets.QApplication.sendEvent(viewport(), event)


def mouse_on(widget):
    """Press and let go in the middle of a widget."""
    at = QtCore.QPointF(widget.rect().center())
    for kind, buttons in ((QtCore.QEvent.MouseButtonPress, LEFT), (QtCore.QEvent.MouseButtonRelease, NONE)):
        event = QtGui.QMouseEvent(kind, at, LEFT, buttons, QtCore.Qt.NoModifier)
        QtWidgets.QApplication.sendEvent(widget, event)
    settle()


def move(place):
    mouse("MouseMove", place)
    settle(1)


def press(place, modifiers=QtCore.Qt.NoModifier):
    mouse("MouseButtonPress", place, LEFT, LEFT, modifiers)


def release(place, modifiers=QtCore.Qt.NoModifier):
    mouse("MouseButtonRelease", place, LEFT, NONE, modifiers)
    settle(1)


def click(place, modifiers=QtCore.Qt.NoModifier):
    press(place, modifiers)
    release(place, modifiers)


def drag(way, modifiers=QtCore.Qt.NoModifier, before_release=lambda: None):
    """Press at the first place of a way, go along it, let go at the last."""
    press(way[0], modifiers)
    for place in way[1:]:
        mouse("MouseMove", place, NONE, LEFT, modifiers)
    settle(1)
    before_release()
    release(way[-1], modifiers)


def key(widget, code, modifiers=QtCore.Qt.NoModifier):
    """Press a key and let it go; Qt asks first who would rather have it than a shortcut of the window."""
    text = "" if modifiers else chr(code) if code < 128 else ""
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.sendEvent(widget, QtGui.QKeyEvent(kind, code, modifiers, text))
    settle()


def shortcut(widget, code):
    """Press Ctrl and a key where whoever has it for a shortcut is asked for it."""
    event = QtGui.QKeyEvent(QtCore.QEvent.ShortcutOverride, code, QtCore.Qt.ControlModifier)
    QtWidgets.QApplication.sendEvent(widget, event)
    settle()
