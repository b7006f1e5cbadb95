# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plot of an accuracy study in FreeCAD's window: each point says what it is, and can be clicked.

Neither pyplot nor matplotlib.use is called: which backend FreeCAD's own Plot draws with is not ours to say.
"""

import math

# Matplotlib takes the Qt binding that is loaded, which is FreeCAD's: of Qt 5 or of Qt 6.
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from funicular.accuracy_picture import INK, PAPER, draw_on, mark, place_of
from funicular.gui.lengths import length_in_words
from funicular.gui.qt import QtCore, QtGui, QtWidgets, translate
from funicular.wording import time_text

if not issubclass(FigureCanvasQTAgg, QtWidgets.QWidget):
    raise ImportError(
        translate(
            "Matplotlib draws with another Qt than FreeCAD's, as some addon has asked of it: start FreeCAD "
            "again, and use Funicular before that addon."
        )
    )

FONT_SIZE = 9

# Left, right, bottom and top of the axes, in pixels: room for the texts beside them, the legend above them.
MARGINS = (86, 40, 46, 90)
MOST_TICKS = 6

# Of an empty plot.
FIRST_LENGTHS, FIRST_TIMES = (1e-6, 1e-2), (1e-3, 1.0)

# How much of a decade lies at least between a point and the frame.
SPARE = 0.08

# How near to a point counts as on it, in pixels of the figure.
REACH = 12.0


def row_in_words(row):
    """1 mm by Auto: 12 ms, truly 0.3 mm."""
    return translate("{} by {}: {}, truly {}").format(
        length_in_words(row["accuracy"]),
        row["method"].capitalize(),
        time_text(row["seconds"]),
        length_in_words(row["true_error"]),
    )


class AccuracyPlot(FigureCanvasQTAgg):
    """Rows of a Study as points; on_click(row) is called with the one that is clicked."""

    def __init__(self, on_click):
        super().__init__(Figure(facecolor=PAPER, dpi=100))
        self.setObjectName("AccuracyPlot")
        self.setMinimumSize(300, 220)
        self._axes = self.figure.add_subplot(facecolor="white")
        self._rows, self._on_click = [], on_click
        self.mpl_connect("motion_notify_event", self._moved)
        self.mpl_connect("button_press_event", self._pressed)

    def show_rows(self, rows, accuracy=None, chosen=None):
        """Draw rows; accuracy: what is asked for now [m]; chosen: the row that gets the ring."""
        self._rows = [row for row in rows if row["status"] == "converged"]
        axes = self._axes
        axes.clear()
        if accuracy:
            label = translate("accuracy now: {}").format(length_in_words(accuracy))
            axes.axvline(accuracy, color=INK, linestyle=":", linewidth=1.5, label=label)
        draw_on(axes, self._rows, in_words=length_in_words, columns=1)
        if chosen in self._rows:
            mark(axes, chosen)
        # The whole of it has no room in a dock, and the dock says it in a sentence.
        axes.set_xlabel(translate("distance from equilibrium"), fontsize=FONT_SIZE)
        axes.set_ylabel(translate("time in the solver"), fontsize=FONT_SIZE)
        axes.tick_params(labelsize=FONT_SIZE)
        for axis, interval in (
            (axes.xaxis, axes.dataLim.intervalx if accuracy or self._rows else FIRST_LENGTHS),
            (axes.yaxis, axes.dataLim.intervaly if self._rows else FIRST_TIMES),
        ):
            # Whole decades: the first rows then seldom move, and there are two labels or more.
            low, high = (math.log10(value) for value in sorted(interval))
            limits = 10.0 ** math.floor(low - SPARE), 10.0 ** math.ceil(high + SPARE)
            axis.set_view_interval(*limits, ignore=True)
            axis.set_major_locator(LogLocator(numticks=MOST_TICKS))
            axis.set_minor_locator(NullLocator())
        axes.xaxis.set_inverted(True)
        # One that is hidden is drawn when it is shown.
        if self.isVisible():
            self.draw()

    def showEvent(self, event):
        super().showEvent(event)
        self.draw_idle()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        left, right, bottom, top = MARGINS
        width, height = max(self.width(), 1), max(self.height(), 1)
        self.figure.subplots_adjust(left / width, bottom / height, 1 - right / width, 1 - top / height)

    def place_of(self, row):
        """QPoint of a row's point on this widget."""
        x, y = self._axes.transData.transform(place_of(row)) / self.device_pixel_ratio
        return QtCore.QPoint(round(x), round(self.height() - y))

    def _row_at(self, event):
        """The row whose point is nearest to the mouse, None if none is near.

        Of points at one place it is the most accurate: it costs no more than the others.
        """
        near = []
        for row in self._rows:
            x, y = self._axes.transData.transform(place_of(row))
            away = ((x - event.x) ** 2 + (y - event.y) ** 2) ** 0.5 / self.device_pixel_ratio
            near.append((round(away), row["accuracy"], row))
        best = min(near, key=lambda each: each[:2], default=None)
        return best[2] if best and best[0] <= REACH else None

    def _moved(self, event):
        row = self._row_at(event)
        self.setCursor(QtCore.Qt.PointingHandCursor if row else QtCore.Qt.ArrowCursor)
        if row:
            QtWidgets.QToolTip.showText(QtGui.QCursor.pos(), row_in_words(row), self)
        else:
            QtWidgets.QToolTip.hideText()

    def _pressed(self, event):
        row = self._row_at(event) if event.button == 1 else None
        if row:
            self._on_click(row)
