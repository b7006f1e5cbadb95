# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress of a solve in FreeCAD's progress bar, where ESC cancels it."""

import math

import FreeCAD as App

# A bar that comes and goes within less is a flicker.
SHOWN_AFTER = 0.5
STEPS = 100

Indicator = App.Base.ProgressIndicator
"""Makes the bar: start(text, steps), next(may_abort) that raises RuntimeError once the user cancels, stop().

FreeCAD ignores its own indicator while another one runs, as one does during doc.recompute(). The layer that
owns the window may put one here that does not.
"""


class Progress:
    """A context manager to be called as `on_progress` of funicular.solve: False once the user has cancelled.

    accuracy [m]: the position error at which the solve ends. The bar grows with its logarithm.
    """

    def __init__(self, text, accuracy):
        self._text = text
        self._accuracy = accuracy
        self._first_error = None
        self._shown = 0
        self._indicator = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._indicator is not None:
            self._indicator.stop()

    def __call__(self, report):
        error = report.position_error
        if self._first_error is None and math.isfinite(error) and error > self._accuracy:
            self._first_error = error
        if report.seconds < SHOWN_AFTER:
            return True
        if self._indicator is None:
            self._indicator = Indicator()
            self._indicator.start(self._text, STEPS)
        try:
            # At least one step each time: it is the steps that look for ESC.
            self._indicator.next(True)
            self._shown += 1
            while self._shown < STEPS * self._passed(error):
                self._indicator.next(True)
                self._shown += 1
        except RuntimeError:
            return False
        return True

    def _passed(self, error):
        if self._first_error is None or not 0.0 < error < self._first_error:
            return 0.0
        return math.log(self._first_error / error) / math.log(self._first_error / self._accuracy)
