# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a gridshell: its inputs, and the result as it follows each of them.

The panel only edits properties, inside one transaction of its own: OK commits it, Cancel aborts it, and when
another command ends it, that ends the panel.
"""

import FreeCAD
import FreeCADGui

from funicular.gui.effect_list import EffectList
from funicular.gui.icons import icon
from funicular.gui.inputs import SECTIONS, counts, expression_of, make_input, show_value
from funicular.gui.picking import (
    WrongSelection,
    are_edges_source,
    clicked_object,
    is_mesh_source,
    the_faces,
)
from funicular.gui.price_tag import PriceTag
from funicular.gui.qt import QtCore, QtGui, QtWidgets, translate
from funicular.gui.texts import BUSY, DOUBTFUL, GOOD, WRONG, Heading, ResultLine

# After the last keystroke: long enough not to solve for each digit of a number, short enough to feel
# immediate.
PAUSE_MS = 300


def report(sentence):
    """Write an error to FreeCAD's report view."""
    FreeCAD.Console.PrintError(f"Funicular: {sentence}\n")


def show_message(sentence):
    """Say what is wrong in the report view and, if no other panel is open, in a panel of its own."""
    report(sentence)
    if not FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.showDialog(MessagePanel(sentence))


class MessagePanel:
    """A sentence and a Close button, where there is nothing to edit."""

    def __init__(self, sentence):
        line = ResultLine()
        line.say(WRONG, sentence)
        self.form = line
        self.form.setWindowTitle(translate("Funicular"))
        self.form.setWindowIcon(QtGui.QIcon(icon("Funicular")))

    def getStandardButtons(self):
        return QtWidgets.QDialogButtonBox.Close

    def reject(self):
        FreeCADGui.Control.closeDialog()
        return True


def active_transaction():
    """Id of the transaction that is open in FreeCAD, None without one."""
    active = FreeCAD.getActiveTransaction()
    return active[1] if active else None


class GridshellPanel:
    """Edits a gridshell and its net.

    Parameters
    ----------
    shell : document object
        The gridshell.
    transaction : int, optional
        Id of a transaction that the panel is to finish; without it the panel opens its own.
    """

    def __init__(self, shell, transaction=None):
        self._shell = shell
        self._document = shell.Document
        # Sentences on inputs that cannot be read, by property.
        self._unreadable = {}
        # (label, widget, object, property) of all inputs.
        self._rows = []
        # (widget, object, property) of the inputs that follow an expression.
        self._driven = []
        if transaction is None:
            self._document.openTransaction(translate("Edit gridshell"))
            transaction = active_transaction()
        self._transaction = transaction
        self._pause = QtCore.QTimer()
        self._pause.setSingleShot(True)
        self._pause.setInterval(PAUSE_MS)
        self._pause.timeout.connect(self.recompute)
        self.form = self._build()
        self._in_dialog = True
        self.form.destroyed.connect(self._form_destroyed)
        FreeCAD.addDocumentObserver(self)

    # What FreeCAD calls

    def getStandardButtons(self):
        return QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel

    def accept(self):
        if self._unreadable:
            self._say_what_is_unreadable()
            return False
        document = self._leave()
        document.recompute()
        FreeCAD.closeActiveTransaction(False, self._transaction)
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
        changed = document.HasPendingTransaction
        FreeCAD.closeActiveTransaction(True, self._transaction)
        if changed:
            # Aborting restores the values and leaves what they belong to marked as out of date.
            document.recompute()

    def dismiss(self):
        """Cancel unless finished, and close the dialog if it is still there."""
        self.cancel()
        if self._in_dialog:
            FreeCADGui.Control.closeDialog()

    def slotDeletedDocument(self, document):
        if document == self._document:
            self._leave()
            FreeCADGui.Control.closeDialog()

    def slotDeletedObject(self, obj):
        if obj == self._shell:
            self._leave()
            FreeCADGui.Control.closeDialog()

    def slotCloseTransaction(self, abort):
        if self._shell is not None and active_transaction() != self._transaction:
            self._end(
                translate("Another command ended the panel of {}. What was entered in it was taken back.")
                if abort
                else translate(
                    "Another command ended the panel of {}. What was entered in it is an undo step."
                )
            )

    def slotUndoDocument(self, document):
        if document == self._document:
            self._end(translate("Undo and redo end the panel of {}: its inputs no longer hold."))

    slotRedoDocument = slotUndoDocument

    def _end(self, sentence):
        """Close the panel from outside, nothing being left for it to commit or to abort."""
        report(sentence.format(self._shell.Label))
        document = self._leave()
        FreeCADGui.getDocument(document.Name).resetEdit()

    def _form_destroyed(self):
        # By another tool's Control.closeDialog(); after OK and Cancel the panel is finished by now.
        self._in_dialog = False
        if self._shell is not None:
            self.reject()

    # The form

    def _build(self):
        form = QtWidgets.QWidget()
        form.setWindowTitle(translate("Gridshell"))
        form.setWindowIcon(QtGui.QIcon(icon("Funicular_Gridshell")))
        column = QtWidgets.QVBoxLayout(form)
        column.setContentsMargins(0, 0, 0, 0)
        self.line = ResultLine()
        self.price = PriceTag()
        self.effects = EffectList(self._scene_and_accuracy)
        column.addWidget(self.line)
        net = self._shell.Net
        # A sheet is a net without a source, and its size an input like any other.
        is_sheet = net is not None and net.Source is None and bool(net.Width.Value or net.Depth.Value)
        is_file = net is not None and net.Source is None and bool(net.File)
        is_mesh = is_file or is_mesh_source(net)
        owners = {
            "Gridshell": self._shell,
            "Net": net,
            "Sheet": net if is_sheet else None,
            "File": net if is_file else None,
            "Mesh": net if is_mesh else None,
            "Edges": net if are_edges_source(net) else None,
        }
        # One layout for all: the inputs stand in one column, and a heading costs a line and no frame.
        inputs = QtWidgets.QFormLayout()
        inputs.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
        inputs.setVerticalSpacing(1)
        column.addLayout(inputs)
        for heading, rows in SECTIONS:
            rows = [row for row in rows if owners[row[0]] is not None]
            if rows:
                inputs.addRow(Heading(translate(heading)))
            if rows and rows[0][0] == "Net":
                inputs.addRow(translate("Source"), self._source_button())
            for owner, name, label in rows:
                obj = owners[owner]
                widget = make_input(obj, name, self._setter(obj, name), self._unread(name))
                inputs.addRow(translate(label), widget)
                self._rows.append((inputs.labelForField(widget), widget, obj, name))
                if name == "Accuracy":
                    inputs.addRow("", self.price)
                if expression_of(obj, name):
                    self._driven.append((widget, obj, name))
                inputs.labelForField(widget).setToolTip(widget.toolTip())
        self._show_what_counts()
        inputs.addRow(self.effects)
        return form

    def _show_what_counts(self):
        """Hide the inputs that have no say as the others are."""
        for label, widget, obj, name in self._rows:
            for each in (label, widget):
                each.setVisible(counts(obj, name))

    def _source_button(self):
        button = QtWidgets.QPushButton(translate("Use selected faces"))
        button.setObjectName("Source")
        button.setToolTip(translate("Lay the net on the faces that are selected in the 3D view"))
        button.clicked.connect(self._use_selected_faces)
        return button

    # What the user does

    def _setter(self, obj, name):
        def set_property(value):
            self._unreadable.pop(name, None)
            if self._shell is None:
                return
            try:
                # A property that follows an expression is the expression's to set.
                if not expression_of(obj, name) and getattr(obj, name) != value:
                    setattr(obj, name, value)
                    self._show_what_counts()
            except ReferenceError:
                # The object is gone, and what depended on it says so when it is solved.
                pass
            except (TypeError, ValueError) as error:
                self._unreadable[name] = f"{name}: {error}"
            self._pause.start()

        return set_property

    def _unread(self, name):
        def keep(sentence):
            # Half-typed values are unreadable too: the sentence waits for the pause, as the solver does.
            self._unreadable[name] = sentence
            self._pause.start()

        return keep

    def _say_what_is_unreadable(self):
        self.line.say(WRONG, next(iter(self._unreadable.values())))

    def _use_selected_faces(self):
        if self._shell is None:
            return
        net = self._shell.Net
        try:
            source = the_faces()
        except WrongSelection as error:
            self.line.say(WRONG, str(error))
            return
        before = clicked_object(net.Source)
        if before:
            before.Visibility = True
        net.Source = source
        FreeCADGui.Selection.clearSelection()
        self.recompute()
        if "Invalid" not in net.State:
            clicked_object(source).Visibility = False

    # What follows

    def recompute(self):
        """Solve with what the properties say now, and show what came of it."""
        if self._shell is None:
            return
        if self._unreadable:
            self._say_what_is_unreadable()
            return
        self.effects.stop()
        self.line.say(BUSY, translate("Solving"))
        self.line.repaint()
        before = self._shell.Seconds
        self._document.recompute()
        # No two solves take the same time to the last digit: of what was not solved now nothing is learnt.
        seconds = self._shell.Seconds if self._shell.Seconds != before else None
        for widget, obj, name in self._driven:
            if obj in (self._shell, self._shell.Net):
                show_value(widget, obj, name)
        self._show_result(seconds)

    def _show_result(self, seconds):
        from funicular.features.gridshell import result_line

        for obj in (self._shell.Net, self._shell):
            if obj is not None and "Invalid" in obj.State:
                kept = "" if self._shell.Shape.isNull() else " " + translate("(The last good shape stays.)")
                self.line.say(WRONG, obj.getStatusString() + self._remedy(obj) + kept)
                return
        self._ask_price(seconds)
        sentence = result_line(self._shell)
        if self._shell.Net is not None and self._shell.Net.Remarks:
            # What came out otherwise than it was asked for.
            sentence += ". " + self._shell.Net.Remarks
        if self._shell.Status != "converged":
            self.line.say(WRONG, sentence)
        elif not self._shell.CompressionOnly:
            self.line.say(DOUBTFUL, sentence)
        else:
            self.line.say(GOOD, sentence)

    def _ask_price(self, seconds):
        # Of the other methods no price is known.
        if self._shell.Method == "Auto" and self._shell.Status == "converged":
            # Of several rounds only the best one's time is kept, which began near its end.
            seconds = None if self._shell.LengthMatching else seconds
            self.price.ask(*self._scene_and_accuracy(), seconds)
        else:
            self.price.stop()

    def _scene_and_accuracy(self):
        """(fn.Scene, accuracy [m]) as the properties are."""
        from funicular.features.gridshell import scene_of, solver_options

        return scene_of(self._shell), solver_options(self._shell)["accuracy"]

    def _remedy(self, obj):
        if obj == self._shell or "pick" not in obj.getStatusString():
            return ""
        return translate(". Select another face and press “Use selected faces”.")

    def _leave(self):
        """Stop following the document, which may be about to go; returns it."""
        self._pause.stop()
        self.price.stop()
        self.effects.stop()
        FreeCAD.removeDocumentObserver(self)
        document, self._document, self._shell = self._document, None, None
        return document


def edit(shell, transaction=None):
    """Show the panel of a gridshell and bring its result up to date; for the arguments see GridshellPanel.

    Returns the panel, or None if another dialog is in the way.
    """
    if FreeCADGui.Control.activeDialog():
        report(translate("Another dialog is open in the task panel. Close it, then edit the gridshell."))
        return None
    panel = GridshellPanel(shell, transaction)
    FreeCADGui.Control.showDialog(panel)
    panel.recompute()
    return panel
