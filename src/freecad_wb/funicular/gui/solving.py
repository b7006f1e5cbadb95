# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a long solve shows in the window, and how Esc ends it.

FreeCAD's own progress indicator does nothing within doc.recompute(), for that one runs an indicator itself.
"""

import FreeCADGui

from funicular.features import progress
from funicular.gui.qt import QtCore, QtWidgets, translate

USER_INPUT = (
    QtCore.QEvent.KeyPress,
    QtCore.QEvent.KeyRelease,
    QtCore.QEvent.Shortcut,
    QtCore.QEvent.ShortcutOverride,
    QtCore.QEvent.MouseButtonPress,
    QtCore.QEvent.MouseButtonRelease,
    QtCore.QEvent.MouseButtonDblClick,
    QtCore.QEvent.Wheel,
    QtCore.QEvent.ContextMenu,
    QtCore.QEvent.Close,
)


class EscapeWatch(QtCore.QObject):
    """An event filter that lets the window redraw but not be used, and remembers Esc.

    Whatever else a user did meanwhile would change the document that is just being computed.
    """

    def __init__(self):
        super().__init__()
        self.pressed = False

    def eventFilter(self, watched, event):
        if event.type() not in USER_INPUT:
            return False
        if event.type() == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            self.pressed = True
        return True


class StatusBarIndicator:
    """Takes the place of FreeCAD.Base.ProgressIndicator in funicular.features.progress."""

    def __init__(self):
        self._watch = EscapeWatch()
        self._text, self._steps, self._done = "", 1, 0

    def start(self, text, steps):
        self._text, self._steps, self._done = text, steps, 0
        QtWidgets.QApplication.instance().installEventFilter(self._watch)

    def next(self, may_abort=False):
        """One step on. Raises RuntimeError if the user has pressed Esc and `may_abort` is set."""
        self._done += 1
        share = min(100, round(100 * self._done / self._steps))
        message = translate("{}: {} %, Esc cancels").format(self._text, share)
        FreeCADGui.getMainWindow().statusBar().showMessage(message)
        QtWidgets.QApplication.processEvents()
        if may_abort and self._watch.pressed:
            raise RuntimeError(translate("cancelled"))

    def stop(self):
        QtWidgets.QApplication.instance().removeEventFilter(self._watch)
        FreeCADGui.getMainWindow().statusBar().clearMessage()


def install():
    """Let every solve from now on show in the status bar and end on Esc."""
    progress.Indicator = StatusBarIndicator
