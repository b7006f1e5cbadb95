# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in a thread beside the window: of what is asked for, the latest is what is wanted."""

import threading

from funicular.gui.qt import QtCore

LOOK_EVERY_MS = 50


class Background(QtCore.QObject):
    """One thread at a time; what it finds is handed over in the thread of the window.

    Parameters
    ----------
    parent : QObject
        With which it ends.
    on_found : callable(result)
        Called with what the latest work returned; not for work that something else was asked for after, nor
        after stop().
    """

    def __init__(self, parent, on_found):
        super().__init__(parent)
        self._on_found = on_found
        self._thread = self._running = self._wanted = None
        self._poll = QtCore.QTimer(self)
        self._poll.setInterval(LOOK_EVERY_MS)
        self._poll.timeout.connect(self._look)

    def ask(self, work):
        """Do this next, in place of what is asked for already. work(is_wanted) -> result, in the thread.

        is_wanted() tells the work whether it should go on.
        """
        self._wanted = _Work(work)
        if self._running is not None:
            self._running.cancelled.set()
        self._poll.start()
        self._look()

    def stop(self):
        """Nothing is wanted any more; what runs ends as soon as it looks."""
        self._wanted = None
        if self._running is not None:
            self._running.cancelled.set()

    def _look(self):
        if self._thread is not None and self._thread.is_alive():
            return
        done, self._running, self._thread = self._running, None, None
        if self._wanted is not None:
            # No daemon: Python waits for it when FreeCAD ends, and so it never runs into what is gone.
            self._running, self._wanted = self._wanted, None
            self._thread = threading.Thread(target=self._running.run, name="Funicular")
            self._thread.start()
        else:
            self._poll.stop()
        if done is not None and not done.cancelled.is_set():
            self._on_found(done.result)


class _Work:
    def __init__(self, work):
        self._work, self.result = work, None
        self.cancelled = threading.Event()

    def run(self):
        self.result = self._work(lambda: not self.cancelled.is_set())
