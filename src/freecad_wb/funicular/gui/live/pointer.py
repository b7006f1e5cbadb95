# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D views of a document, as the parts of the live panel take it."""

import FreeCADGui

from funicular.gui.drawing.on_screen import OnScreen
from funicular.gui.qt import QtCore

MOUSE = {
    QtCore.QEvent.MouseMove: "moved",
    QtCore.QEvent.MouseButtonPress: "pressed",
    QtCore.QEvent.MouseButtonRelease: "released",
    QtCore.QEvent.Leave: "left",
}


class Pointer(QtCore.QObject):
    """Sees the mouse before the 3D view does.

    Whoever takes part has any of the methods moved, pressed, released (each with an At) and left(): True says
    that the event is its own, and then neither the view nor anyone after it gets to see it. The latest to
    come is asked first.
    """

    def __init__(self, document, placement, parent=None):
        super().__init__(parent)
        self._document, self._placement = document, placement
        self._takers, self._viewports = [], []
        self._watch()

    def add(self, taker):
        self._takers.insert(0, taker)

    def remove(self, taker):
        if taker in self._takers:
            self._takers.remove(taker)

    def stop(self):
        """Watch no view any more."""
        for _, viewport in self._viewports:
            try:
                viewport.removeEventFilter(self)
            except RuntimeError:
                pass  # it is closed
        self._viewports, self._takers = [], []

    def _watch(self):
        views = FreeCADGui.getDocument(self._document.Name).mdiViewsOfType("Gui::View3DInventor")
        for view in views:
            viewport = view.graphicsView().viewport()
            viewport.setMouseTracking(True)
            viewport.installEventFilter(self)
            self._viewports.append((view, viewport))

    def eventFilter(self, watched, event):
        name = MOUSE.get(event.type())
        view = next((view for view, viewport in self._viewports if viewport is watched), None)
        if name is None or view is None:
            return False
        for taker in tuple(self._takers):
            take = getattr(taker, name, None)
            if take is not None and take(*(() if name == "left" else (At(view, event, self._placement),))):
                return True
        return False


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
