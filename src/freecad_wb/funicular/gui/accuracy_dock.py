# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs: a dock that measures a gridshell, and in which its accuracy is chosen by a click."""

import math
import os
import time

import FreeCAD
import FreeCADGui

from funicular.accuracy import METHODS
from funicular.wording import time_text
from funicular.export import to_be_studied
from funicular.features.feature import reason
from funicular.features.gridshell import METRES
from funicular.gui.accuracy_plot import AccuracyPlot, row_in_words
from funicular.gui.inputs import expression_of
from funicular.gui.lengths import length_in_words
from funicular.gui.measuring import Measurement
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from funicular.gui.texts import BUSY, DOUBTFUL, GOOD, WRONG, ResultLine, WrappedText

# How often the window looks what has been measured, and draws it at the most [s]: a picture may take longer
# than many a solve.
LOOK_EVERY_MS = 20
DRAW_EVERY = 0.25

# A solve that takes longer is named, and for how long it has been going on [s]; what is over at once would
# only make the line flicker, and writing it would take time from what is measured.
SHORT, LONG = 0.1, 1.0

WIDTH = 440

# What a click on a point sets, and the properties that describe the scene, by their group in the document.
CHOSEN = ("Accuracy", "Method")
GROUPS_OF_SCENE = ("Net", "Weights", "Stiffness", "Supports")

OUTDATED = QT_TRANSLATE_NOOP(
    "Funicular", "The gridshell has changed since this was begun: press “Measure again”."
)


class AccuracyDock(QtWidgets.QDockWidget):
    """Stays for as long as FreeCAD's window does; closing it ends what it does and hides it."""

    def __init__(self, window):
        super().__init__(translate("What accuracy costs"), window)
        self.setObjectName("FunicularAccuracy")
        self._shell = self._measurement = self._study = None
        self._document = None
        self._rows, self._total, self._drawn = [], 0, 0.0
        # What the line says is being measured: it keeps other sentences until that changes.
        self._told = None, None
        # Whether the thread waits to be resumed, and whether what it measures is the gridshell no longer.
        self._waits = self._outdated = False
        self._poll = QtCore.QTimer(self)
        self._poll.setInterval(LOOK_EVERY_MS)
        self._poll.timeout.connect(self._look)
        self.setWidget(self._build())
        QtWidgets.QApplication.instance().aboutToQuit.connect(self._stop)

    def _build(self):
        inner = QtWidgets.QWidget()
        column = QtWidgets.QVBoxLayout(inner)
        self.line = ResultLine()
        self.line.setObjectName("AccuracyLine")
        column.addWidget(self.line)
        self.plot = AccuracyPlot(self._choose)
        column.addWidget(self.plot, 1)
        legend = WrappedText(
            translate(
                "Full lines: how far the nodes truly are from where they stand in equilibrium. Dashed lines: "
                "how far the solver says they are. Farther right is more accurate, lower is faster."
            )
        )
        column.addWidget(legend)
        # All height that is to spare is the plot's.
        policy = QtWidgets.QSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Minimum)
        policy.setHeightForWidth(True)
        for text in (self.line, legend):
            text.setSizePolicy(policy)
        buttons = QtWidgets.QHBoxLayout()
        column.addLayout(buttons)
        self._cancel = self._button(buttons, "CancelStudy", translate("Cancel"), self._cancel_pressed)
        self._cancel.setToolTip(translate("Stop measuring; what was measured stays"))
        self._again = self._button(buttons, "MeasureAgain", translate("Measure again"), self.measure)
        self._again.setToolTip(translate("Measure the gridshell as it is now"))
        self._save = self._button(buttons, "SaveStudy", translate("Save as…"), self._save_pressed)
        self._save.setToolTip(translate("Write what was measured as a table (.csv) and a picture (.png)"))
        return inner

    @staticmethod
    def _button(row, name, text, pressed):
        button = QtWidgets.QPushButton(text)
        button.setObjectName(name)
        button.clicked.connect(lambda *_: pressed())
        row.addWidget(button)
        return button

    # From opening to closing

    def study(self, shell):
        """Show the dock for a Gridshell, and measure that."""
        self._forget()
        self._shell, self._document = shell, shell.Document
        FreeCAD.addDocumentObserver(self)
        self.setWindowTitle(translate("What accuracy costs: {}").format(shell.Label))
        self.show()
        self.raise_()
        self.measure()

    def measure(self):
        """Begin anew with the gridshell as it is now."""
        if self._shell is None:
            return
        self._stop()
        self._rows, self._study, self._outdated = [], None, False
        try:
            scene, options = to_be_studied(self._shell)
        except (ValueError, ImportError) as error:
            self.line.say(WRONG, str(reason(error)))
        else:
            self._total = len(METHODS) * len(options["accuracies"])
            # Of coarser nets there is nothing to choose by a click: their steps are the Net's.
            self._measurement = Measurement(scene, {**options, "coarser": 0})
            self._waits = False
            self._poll.start()
            self._tell_what_runs()
        self._show()

    def closeEvent(self, event):
        super().closeEvent(event)
        self._leave()

    def _stop(self):
        """Let the thread end by itself, within a step of the solver, and ask it for nothing more."""
        self._poll.stop()
        measurement, self._measurement = self._measurement, None
        if measurement is not None:
            measurement.cancel()

    def _leave(self):
        """Forget the gridshell, and say so."""
        self._forget()
        self.line.say(BUSY, translate("Select a gridshell and press “What accuracy costs”."))
        self._show()

    def _forget(self):
        """Ask nothing more of the gridshell, which may be about to go."""
        self._stop()
        if self._shell is not None:
            FreeCAD.removeDocumentObserver(self)
        self._shell = self._document = self._study = None
        self._rows = []

    # While it measures

    def _look(self):
        measurement = self._measurement
        # In this order: once the thread has ended, no row comes any more.
        ended = not measurement.running
        if len(measurement.rows) > len(self._rows):
            self._rows = list(measurement.rows)
            if time.monotonic() > self._drawn + DRAW_EVERY:
                self.line.say(BUSY, translate("{} of {} measured").format(len(self._rows), self._total))
                self._show()
            # It waits until the next look: by then Qt has painted, which takes time of its own.
            self._waits = True
        elif ended:
            self._stop()
            self._study = measurement.study
            self._tell_what_came_of_it(measurement.error)
            self._show()
        elif self._waits:
            self._waits = False
            measurement.resume()
        elif measurement.now[2] > (LONG if measurement.now[:2] == self._told else SHORT):
            self._tell_what_runs()

    def _cancel_pressed(self):
        if self._measurement is not None:
            self._measurement.cancel()

    def _tell_what_runs(self):
        method, accuracy, seconds = self._measurement.now
        self._told = method, accuracy
        if method is None:
            text = translate("Finding the shape to measure against")
        else:
            text = translate("Measuring {} by {}, {} of {}").format(
                length_in_words(accuracy), method.capitalize(), len(self._rows) + 1, self._total
            )
        self.line.say(BUSY, text + (f" ({time_text(seconds)})" if seconds > LONG else ""))

    def _tell_what_came_of_it(self, error):
        if error:
            self.line.say(WRONG, error)
            return
        sentences = [translate("Cancelled; what was measured stays.")] if self._study.cancelled else []
        if self._rows:
            sentences.append(translate("Click a point: the gridshell takes its accuracy and method."))
        sentences += [
            translate("{} gave up after {}, without coming as near as {}.").format(
                row["method"].capitalize(), time_text(row["seconds"]), length_in_words(row["accuracy"])
            )
            for row in self._rows
            if row["status"] != "converged"
        ]
        if self._shell.LengthMatching:
            sentences.append(translate("Length matching was left out: each of its rounds is one more solve."))
        if self._outdated:
            sentences.append(translate(OUTDATED))
        self.line.say(DOUBTFUL if self._study.cancelled or self._outdated else GOOD, " ".join(sentences))

    # What the user chooses

    def _choose(self, row):
        shell = self._shell
        words = row_in_words(row)
        if FreeCADGui.Control.activeDialog():
            self.line.say(DOUBTFUL, translate("Close the panel that is open, then click the point again."))
            return
        for name in CHOSEN:
            if expression_of(shell, name):
                self.line.say(
                    DOUBTFUL,
                    translate("{} follows the expression {}: change that instead.").format(
                        name, expression_of(shell, name)
                    ),
                )
                return
        if row is self._present_row():
            self.line.say(GOOD, translate("{}. The gridshell has this accuracy and method.").format(words))
            return
        document = shell.Document
        document.openTransaction(translate("Accuracy"))
        try:
            # In twelve digits a millimetre is one, whatever it was in metres.
            accuracy, method = f"{row['accuracy'] / METRES:.12g} mm", row["method"].capitalize()
            if shell.Accuracy != FreeCAD.Units.Quantity(accuracy):
                shell.Accuracy = accuracy
            if shell.Method != method:
                shell.Method = method
            document.recompute()
            if not shell.isValid():
                raise ValueError(shell.getStatusString())
        except Exception as error:
            # As with what a command makes: nothing stays by halves, and the user reads why.
            document.abortTransaction()
            document.recompute()
            self.line.say(WRONG, translate("{} Accuracy and method are as before.").format(reason(error)))
        else:
            document.commitTransaction()
            self.line.say(
                GOOD,
                translate("{}. Chosen: the gridshell was solved again in {}.").format(
                    words, time_text(shell.Seconds)
                ),
            )

    def _save_pressed(self):
        home = os.path.dirname(self._document.FileName) or os.path.expanduser("~")
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            self,
            translate("Save what was measured"),
            os.path.join(home, f"{self._shell.Label}-accuracy.csv"),
            translate("Table, and a picture of the same name (*.csv)"),
        )
        stem = path[:-4] if path.lower().endswith(".csv") else path
        if not path or not self._may_replace(path, (stem + ".csv", stem + ".png")):
            return
        try:
            self._study.write(stem + ".csv")
            row = self._present_row() or {}
            self._study.plot(stem + ".png", chosen=row.get("accuracy"), method=row.get("method"))
        except OSError as error:
            self.line.say(WRONG, str(error))
        else:
            name = os.path.basename(stem)
            self.line.say(GOOD, translate("{} and {} are written.").format(name + ".csv", name + ".png"))

    def _may_replace(self, asked, paths):
        """Whether files may be written; the file dialog has asked for the one that was chosen there."""
        there = [path for path in paths if os.path.exists(path) and not os.path.exists(asked)]
        if not there:
            return True
        names = ", ".join(os.path.basename(path) for path in there)
        question = translate("{} is there already. Replace it?").format(names)
        box = QtWidgets.QMessageBox
        return box.question(self, translate("Save what was measured"), question) == box.Yes

    # What is shown

    def _accuracy(self):
        """The gridshell's own [m]."""
        return self._shell.Accuracy.Value * METRES if self._shell is not None else None

    def _present_row(self):
        """The row that measured what the gridshell is set to, None if none did."""
        if self._shell is None:
            return None
        method, accuracy = self._shell.Method.lower(), self._accuracy()
        return next(
            (
                row
                for row in self._rows
                if row["method"] == method and math.isclose(row["accuracy"], accuracy, rel_tol=1e-9)
            ),
            None,
        )

    def _show(self):
        running = self._measurement is not None
        self._cancel.setEnabled(running)
        self._again.setEnabled(not running and self._shell is not None)
        self._save.setEnabled(not running and bool(self._rows))
        self.plot.show_rows(self._rows, self._accuracy(), self._present_row())
        self._drawn = time.monotonic()

    # What FreeCAD tells of its documents

    def slotChangedObject(self, obj, name):
        if obj == self._shell and name in CHOSEN:
            self._show()
        elif obj == self._shell and name == "Label":
            self.setWindowTitle(translate("What accuracy costs: {}").format(obj.Label))
        elif self._is_of_scene(obj, name):
            self._outdated = True
            if self._rows and self._measurement is None:
                self.line.say(DOUBTFUL, translate(OUTDATED))

    def _is_of_scene(self, obj, name):
        if obj == self._shell:
            return obj.getGroupOfProperty(name) in GROUPS_OF_SCENE
        if obj == self._shell.Net:
            return name == "SourceNodes"
        return obj in (*self._shell.Supports, *self._shell.PointLoads) and name not in ("Label", "Visibility")

    def slotDeletedObject(self, obj):
        if obj == self._shell:
            self.close()

    def slotDeletedDocument(self, document):
        if document == self._document:
            self.close()


_dock = None


def show(shell):
    """Measure a Gridshell in the dock, which is made at the first call. Returns it."""
    global _dock
    if _dock is None:
        window = FreeCADGui.getMainWindow()
        _dock = AccuracyDock(window)
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, _dock)
        window.resizeDocks([_dock], [WIDTH], QtCore.Qt.Horizontal)
    _dock.study(shell)
    return _dock
