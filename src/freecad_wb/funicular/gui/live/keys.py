# SPDX-License-Identifier: LGPL-2.1-or-later
"""Esc, undo and redo, which belong to the panel before they belong to FreeCAD."""

import FreeCADGui

from funicular.gui.qt import QtCore, QtGui, QtWidgets

KEYS = (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease)
# What has a text of its own to take steps back in.
WITH_TEXT = (QtWidgets.QLineEdit, QtWidgets.QTextEdit, QtWidgets.QPlainTextEdit)


class PanelForm(QtWidgets.QWidget):
    """What a panel shows. Enter ends the typing in a box, and nothing more: FreeCAD would press OK.

    on_enter : callable()
    """

    def __init__(self, on_enter):
        super().__init__()
        self._on_enter = on_enter

    def keyPressEvent(self, event):
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            self._on_enter()
        else:
            super().keyPressEvent(event)


class Keys(QtCore.QObject):
    """Sees keys before the window and what is in it do; like Pointer it listens to the whole application.

    Parameters
    ----------
    escape, undo, redo : callable() -> bool
        True says that the key was taken.
    is_meant : callable(widget) -> bool
        Whether a key in this widget may be the panel's.
    """

    def __init__(self, escape, undo, redo, is_meant):
        super().__init__()
        self._escape, self._is_meant = escape, is_meant
        self._shortcuts = ((QtGui.QKeySequence.Undo, undo), (QtGui.QKeySequence.Redo, redo))
        self._is_taken = False
        QtWidgets.QApplication.instance().installEventFilter(self)

    def stop(self):
        """Listen no more."""
        QtWidgets.QApplication.instance().removeEventFilter(self)
        self.deleteLater()

    def eventFilter(self, watched, event):
        if event.type() not in KEYS or not _is_in_window(watched) or not self._is_meant(watched):
            return False
        if event.type() == QtCore.QEvent.ShortcutOverride:
            return not isinstance(watched, WITH_TEXT) and self._is_shortcut_taken(event)
        if event.key() != QtCore.Qt.Key_Escape:
            return False
        if event.type() == QtCore.QEvent.KeyPress:
            self._is_taken = self._escape()
            return self._is_taken
        # The 3D view ends the panel when the key is let go.
        was_taken, self._is_taken = self._is_taken, False
        return was_taken

    def _is_shortcut_taken(self, event):
        for sequence, do in self._shortcuts:
            if event.matches(sequence) and do():
                event.accept()
                return True
        return False


def _is_in_window(watched):
    """Whether it is a widget of FreeCAD's window or of a dock beside it, and not of a dialog or menu."""
    try:
        if not isinstance(watched, QtWidgets.QWidget):
            return False
        window = watched.window()
        return window == FreeCADGui.getMainWindow() or isinstance(window, QtWidgets.QDockWidget)
    except RuntimeError:
        return False  # it is just being closed
