# SPDX-License-Identifier: LGPL-2.1-or-later
"""An accuracy study in a thread of its own, which touches no document and no window."""

import threading

import funicular as fn


class Measurement:
    """Begins with the constructor; what came of it is asked for, from the thread of the window.

    After each row the thread waits for resume(): what the window does with the row would otherwise take its
    time from the next one, and be measured with it.

    Parameters
    ----------
    scene : fn.Scene
    options : dict
        Arguments of fn.accuracy_study.

    Attributes
    ----------
    rows : list
        The rows so far.
    now : tuple
        (method, accuracy [m], seconds) of the solve that runs; method and accuracy are None while the shape
        to measure against is sought.
    study : Study or None
        What it came to, once it has ended well or was cancelled.
    error : str
        The sentence, once it has ended in an error.
    """

    def __init__(self, scene, options):
        self.rows, self.now = [], (None, None, 0.0)
        self.study, self.error = None, ""
        self._cancelled, self._resumed = threading.Event(), threading.Event()
        # No daemon: Python waits for it when FreeCAD ends, and so it never runs into what is gone.
        self._thread = threading.Thread(
            target=self._run, args=(scene, options), name="Funicular accuracy study"
        )
        self._thread.start()

    @property
    def running(self):
        return self._thread.is_alive()

    def resume(self):
        """Let the next row be measured."""
        self._resumed.set()

    def cancel(self):
        """End it within the present solve; the rows so far stay."""
        self._cancelled.set()
        self._resumed.set()

    def _run(self, scene, options):
        try:
            self.study = fn.accuracy_study(
                scene, on_progress=self._measured, on_report=self._report, **options
            )
        except Exception as error:
            # Whatever it is, it is the window that has to say it.
            self.error = str(error)

    def _report(self, method, accuracy, report):
        self.now = method, accuracy, report.seconds
        return not self._cancelled.is_set()

    def _measured(self, row):
        self._resumed.clear()
        self.rows.append(row)
        if not self._cancelled.is_set():
            self._resumed.wait()
        return not self._cancelled.is_set()
