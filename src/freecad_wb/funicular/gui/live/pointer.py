# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D views of a document, as the parts of the live panel take it."""

import FreeCADGui

from funicular.gui.drawing.on_screen import OnScreen
from funicular.gui.qt import QtCore, QtWidgets

MOUSE = {
    QtCore.QEvent.MouseMove: "moved",
    QtCore.QEvent.MouseButtonPress: "pressed",
    # What Qt makes of a second press that follows soon.
    QtCore.QEvent.MouseButtonDblClick: "pressed",
    QtCore.QEvent.MouseButtonRelease: "released",
    QtCore.QEvent.Leave: "left",
}


class Pointer(QtCore.QObject):
    """Sees the mouse before the 3D view does.

    Whoever takes part has any of the methods moved, pressed, released (each with an At) and left(): True says
    that the event is its own, and then neither the view nor anyone after it gets to see it. The latest to
    come is asked first.

    It listens to the whole application: a reference to the widget of a view, once PySide has one, may outlive
    the view and be taken for the next at the same address.
    """

    def __init__(self, document, placement, parent=None):
        super().__init__(parent)
        self._document, self._placement = document, placement
        self._takers = []
        self.tip = Tip()
        QtWidgets.QApplication.instance().installEventFilter(self)

    def add(self, taker):
        self._takers.insert(0, taker)

    def remove(self, taker):
        if taker in self._takers:
            self._takers.remove(taker)

    def stop(self):
        """Listen no more."""
        QtWidgets.QApplication.instance().removeEventFilter(self)
        self._takers = []
        self.tip.clear()
        self.deleteLater()

    def eventFilter(self, watched, event):
        name = MOUSE.get(event.type())
        if name is None or not self._takers:
            return False
        view = self._view_of(watched)
        if view is None:
            return False
        for taker in tuple(self._takers):
            take = getattr(taker, name, None)
            if take is not None and take(*(() if name == "left" else (At(view, event, self._placement),))):
                return True
        return False

    def _view_of(self, widget):
        """The 3D view of the document that the widget draws; None if it is no such widget."""
        try:
            if not (isinstance(widget, QtWidgets.QWidget) and widget.inherits("QOpenGLWidget")):
                return None
        except RuntimeError:
            return None  # it is just being closed
        active = FreeCADGui.activeDocument()
        view = active.ActiveView if active and active.Document == self._document else None
        # A press makes a view the active one before this; what only passes over another is not ours.
        return view if hasattr(view, "getCameraNode") else None


class Tip:
    """The tooltip at the mouse, which those who take part share: it says what each of them has to say."""

    def __init__(self):
        self._said, self._shown = {}, ""

    def say(self, taker, words, at=None):
        """What one of them says from now on, "" for nothing. at: At of the mouse, to show it there."""
        self._said.pop(id(taker), None)
        if words:
            self._said[id(taker)] = words
        text = "\n".join(self._said.values())
        if text and at is not None:
            self._shown = text
            QtWidgets.QToolTip.showText(at.on_global_screen, text)
        elif not text:
            self.clear()

    def clear(self):
        """Nothing is said; another's tooltip stays."""
        self._said = {}
        if self._shown:
            self._shown = ""
            QtWidgets.QToolTip.hideText()


class At:
    """Where the mouse is, and what it does.

    view: FreeCAD's. place: (x, y) in the widget of the view. button: that was pressed or released; buttons,
    modifiers: as Qt has them. on_global_screen: for a tooltip.
    """

    def __init__(self, view, event, placement):
        self.view, self._placement = view, placement
        self.place = (event.pos().x(), event.pos().y())
        self.button, self.buttons, self.modifiers = event.button(), event.buttons(), event.modifiers()
        self.on_global_screen = event.globalPos()

    def screen(self):
        """The OnScreen for points of the gridshell, in its own millimetres."""
        return OnScreen(self.view, self._placement())
