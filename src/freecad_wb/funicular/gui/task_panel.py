# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a gridshell: its inputs, and the result as it follows each of them.

The panel only edits properties, inside one open transaction: OK commits it, Cancel aborts it.
"""

import FreeCAD
import FreeCADGui

from funicular.gui.icons import icon
from funicular.gui.inputs import SECTIONS, make_input
from funicular.gui.qt import QtCore, QtGui, QtWidgets, translate

# After the last keystroke: long enough not to solve for each digit of a number, short enough to feel
# immediate.
PAUSE_MS = 300

# A symbol, and its colour on a light and on a dark window.
GOOD = ("✔", "#2e7d32", "#81c784")
DOUBTFUL = ("⚠", "#945200", "#ffb74d")
WRONG = ("✖", "#c62828", "#ff8a80")
BUSY = ("…", "#555555", "#bbbbbb")


def report(sentence):
    """Write an error to FreeCAD's report view."""
    FreeCAD.Console.PrintError(f"Funicular: {sentence}\n")


def show_message(sentence):
    """Say what is wrong in the report view and, if no other panel is open, in a panel of its own."""
    report(sentence)
    if not FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.showDialog(MessagePanel(sentence))


class ResultLine(QtWidgets.QLabel):
    """One sentence with a symbol and a colour, so that neither is needed to read the other."""

    def __init__(self):
        super().__init__()
        self.setObjectName("ResultLine")
        self.setWordWrap(True)
        self.setTextFormat(QtCore.Qt.PlainText)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        # Room for three lines, so that the inputs below do not jump, and as narrow as the panel's own width.
        self.setMinimumHeight(3 * self.fontMetrics().lineSpacing())
        self.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.MinimumExpanding)
        self.setAlignment(QtCore.Qt.AlignTop | QtCore.Qt.AlignLeft)

    def say(self, kind, sentence):
        symbol, on_light, on_dark = kind
        window = self.palette().color(QtGui.QPalette.Window)
        self.setStyleSheet(f"color: {on_light if window.lightness() > 127 else on_dark}")
        self.setText(f"{symbol} {sentence}")


class MessagePanel:
    """A sentence and a Close button, where there is nothing to edit."""

    def __init__(self, sentence):
        line = ResultLine()
        line.say(WRONG, sentence)
        self.form = line
        self.form.setWindowTitle(translate("Gridshell"))
        self.form.setWindowIcon(QtGui.QIcon(icon("Funicular_Gridshell")))

    def getStandardButtons(self):
        return QtWidgets.QDialogButtonBox.Close

    def reject(self):
        FreeCADGui.Control.closeDialog()
        return True


class GridshellPanel:
    """Edits a gridshell and its net.

    Parameters
    ----------
    shell : document object
        The gridshell. A transaction is open on its document, or is opened here.
    """

    def __init__(self, shell):
        self._shell = shell
        self._document = shell.Document
        self._unreadable = ""
        if not self._document.HasPendingTransaction:
            self._document.openTransaction(translate("Edit gridshell"))
        self._pause = QtCore.QTimer()
        self._pause.setSingleShot(True)
        self._pause.setInterval(PAUSE_MS)
        self._pause.timeout.connect(self.recompute)
        self.form = self._build()
        FreeCAD.addDocumentObserver(self)

    # What FreeCAD calls

    def getStandardButtons(self):
        return QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel

    def accept(self):
        if self._unreadable:
            self.line.say(WRONG, self._unreadable)
            return False
        document = self._leave()
        document.recompute()
        document.commitTransaction()
        FreeCADGui.getDocument(document.Name).resetEdit()
        return True

    def reject(self):
        document = self._document
        self.cancel()
        FreeCADGui.getDocument(document.Name).resetEdit()
        return True

    def cancel(self):
        """Take everything back that was done in this panel; nothing happens once it is finished."""
        if self._shell is None:
            return
        document = self._leave()
        document.abortTransaction()
        # Aborting restores the values and leaves what they belong to marked as out of date.
        document.recompute()

    def slotDeletedDocument(self, document):
        if document == self._document:
            self._leave()
            FreeCADGui.Control.closeDialog()

    def slotDeletedObject(self, obj):
        if obj == self._shell:
            self._leave()
            FreeCADGui.Control.closeDialog()

    # The form

    def _build(self):
        form = QtWidgets.QWidget()
        form.setWindowTitle(translate("Gridshell"))
        form.setWindowIcon(QtGui.QIcon(icon("Funicular_Gridshell")))
        column = QtWidgets.QVBoxLayout(form)
        column.setContentsMargins(0, 0, 0, 0)
        self.line = ResultLine()
        column.addWidget(self.line)
        owners = {"Gridshell": self._shell, "Net": self._shell.Net}
        for heading, rows in SECTIONS:
            box = QtWidgets.QGroupBox(translate(heading))
            layout = QtWidgets.QFormLayout(box)
            layout.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
            layout.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
            for owner, name, label in rows:
                if owners[owner] is None:
                    continue
                widget = make_input(owners[owner], name, self._setter(owners[owner], name), self._unread)
                if isinstance(widget, QtWidgets.QCheckBox):
                    widget.setText(translate(label))
                    layout.addRow(widget)
                else:
                    layout.addRow(translate(label), widget)
                    layout.labelForField(widget).setToolTip(widget.toolTip())
            if layout.rowCount():
                column.addWidget(box)
        return form

    # What the user does

    def _setter(self, obj, name):
        def set_property(value):
            self._unreadable = ""
            if self._shell is None:
                return
            try:
                # A property that follows an expression is the expression's to set.
                if not any(path.lstrip(".") == name for path, _ in obj.ExpressionEngine):
                    setattr(obj, name, value)
            except (ReferenceError, TypeError, ValueError) as error:
                self._unread(f"{name}: {error}")
            self._pause.start()

        return set_property

    def _unread(self, sentence):
        # Half-typed values are unreadable too: the sentence waits for the pause, as the solver does.
        self._unreadable = sentence
        self._pause.start()

    # What follows

    def recompute(self):
        """Solve with what the properties say now, and show what came of it."""
        if self._shell is None:
            return
        if self._unreadable:
            self.line.say(WRONG, self._unreadable)
            return
        self.line.say(BUSY, translate("Solving"))
        self.line.repaint()
        self._document.recompute()
        self._show_result()

    def _show_result(self):
        from funicular.features.gridshell import result_line

        for obj in (self._shell.Net, self._shell):
            if obj is not None and "Invalid" in obj.State:
                kept = "" if self._shell.Shape.isNull() else " " + translate("(The last good shape stays.)")
                self.line.say(WRONG, obj.getStatusString() + kept)
                return
        if self._shell.Status != "converged":
            self.line.say(WRONG, result_line(self._shell))
        elif not self._shell.CompressionOnly:
            self.line.say(DOUBTFUL, result_line(self._shell))
        else:
            self.line.say(GOOD, result_line(self._shell))

    def _leave(self):
        """Stop following the document, which may be about to go; returns it."""
        self._pause.stop()
        FreeCAD.removeDocumentObserver(self)
        document, self._document, self._shell = self._document, None, None
        return document


def edit(shell):
    """Show the panel of a gridshell and bring its result up to date.

    Returns the panel, or None if another dialog is in the way.
    """
    if FreeCADGui.Control.activeDialog():
        report(translate("Another dialog is open in the task panel. Close it, then edit the gridshell."))
        return None
    panel = GridshellPanel(shell)
    FreeCADGui.Control.showDialog(panel)
    panel.recompute()
    return panel
