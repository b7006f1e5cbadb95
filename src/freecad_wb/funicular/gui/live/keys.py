# SPDX-License-Identifier: LGPL-2.1-or-later
"""Esc, undo and redo, which belong to the panel before they belong to FreeCAD."""

import FreeCADGui

from funicular.gui.qt import QtCore, QtGui


class Keys(QtCore.QObject):
    """Sees keys before the panel's own frame, the 3D views and the window do.

    Parameters
    ----------
    escape, undo, redo : callable() -> bool
        True says that the key was taken.
    """

    def __init__(self, escape, undo, redo):
        super().__init__()
        self._escape = escape
        self._shortcuts = ((QtGui.QKeySequence.Undo, undo), (QtGui.QKeySequence.Redo, redo))
        self._is_over = self._is_taken = False

    def watch(self, document, form):
        """Watch the form and what it lies in, up to the window, and the document's 3D views."""
        # None of them is kept: a view may close, and PySide takes what is kept for the next in its place.
        for view in FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor"):
            view.graphicsView().installEventFilter(self)
        FreeCADGui.getMainWindow().installEventFilter(self)
        while form is not None and not form.isWindow():
            form.installEventFilter(self)
            form = form.parentWidget()

    def stop(self):
        """Qt takes a filter that is deleted off whatever it watched."""
        self._is_over = True
        self.deleteLater()

    def eventFilter(self, watched, event):
        if self._is_over:
            return False
        if event.type() == QtCore.QEvent.ShortcutOverride:
            # A box for text accepts what it can take back itself, and then it does not come here.
            for sequence, do in self._shortcuts:
                if event.matches(sequence) and do():
                    event.accept()
                    return True
        elif event.type() == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            self._is_taken = self._escape()
            return self._is_taken
        elif event.type() == QtCore.QEvent.KeyRelease and event.key() == QtCore.Qt.Key_Escape:
            # The 3D view ends the panel when the key is let go.
            was_taken, self._is_taken = self._is_taken, False
            return was_taken
        return False
