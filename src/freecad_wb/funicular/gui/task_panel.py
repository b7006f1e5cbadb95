# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a gridshell: its inputs, and the form as it follows each of them.

The panel only edits properties, inside one transaction of its own: OK commits it, Cancel aborts it, and when
another command ends it, that ends the panel. What is found meanwhile is drawn and not written: the gridshell
is computed once, by OK.
"""

import FreeCAD
import FreeCADGui
import numpy as np

from funicular.features.gridshell import METRES
from funicular.gui.drawing.net_drawing import NetDrawing
from funicular.gui.drawing.standpoint import rotation_of
from funicular.gui.effect_list import EffectList
from funicular.gui.icons import icon
from funicular.gui.inputs import SECTIONS
from funicular.gui.live.by_keys import explain_all, order_tabs
from funicular.gui.load_command import where_selected
from funicular.gui.live.colours_part import ColoursPart
from funicular.gui.live.hover import Hover
from funicular.gui.live.inputs_part import InputsPart
from funicular.gui.live.keys import Keys, PanelForm
from funicular.gui.live.loads_part import LoadsPart
from funicular.gui.live.look_part import LookPart
from funicular.gui.live.matching_part import MatchingPart
from funicular.gui.live.motion_part import MotionPart
from funicular.gui.live.pointer import Pointer
from funicular.gui.live.section import Section
from funicular.gui.live.session import Session
from funicular.gui.live.state_part import StatePart
from funicular.gui.live.supports_part import SupportsPart
from funicular.gui.live.variants_part import VariantsPart
from funicular.gui.messages import report
from funicular.gui.picking import (
    WrongSelection,
    are_edges_source,
    clicked_object,
    is_mesh_source,
    the_faces,
)
from funicular.gui.price_tag import PriceTag
from funicular.gui.qt import QtCore, QtGui, QtWidgets, translate
from funicular.gui.texts import BUSY, DOUBTFUL, WRONG
from funicular.gui.thumbnail import net_picture

# After the last keystroke: half-typed values are no steps to lay a net by, nor anything to be told about.
PAUSE_MS = 300
# After the last motion: until then the time is its own.
QUIET_MS = 600

# Sections that fold, as they come: what is changed most stands open.
FOLDED_AT_FIRST = ("MoreOfTheNet", "PointLoads", "View", "ColoursAndReadings", "Alternatives")


def active_transaction():
    """Id of the transaction that is open in FreeCAD, None without one."""
    active = FreeCAD.getActiveTransaction()
    return active[1] if active else None


class GridshellPanel:
    """Edits a gridshell and its net while the form moves.

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
        self._unreadable, self._says_unreadable = {}, False
        self._columns, self._scene, self._is_to_fit = [], None, False
        self._pause = QtCore.QTimer()
        self._pause.setSingleShot(True)
        self._pause.setInterval(PAUSE_MS)
        self._pause.timeout.connect(self._typed)
        self._quiet = QtCore.QTimer()
        self._quiet.setSingleShot(True)
        self._quiet.setInterval(QUIET_MS)
        self._quiet.timeout.connect(self._rested)
        self.session = Session(shell)
        self.pointer = Pointer(self._document, shell.getGlobalPlacement)
        self.form = self._build()
        self.drawing = NetDrawing(shell.ViewObject)
        self._keys = Keys(self._escape, self.supports.undo, self.supports.redo, self._is_in_front)
        self.hover = Hover(self.session, self.pointer)
        self.session.moved.connect(self._draw)
        self.session.rested.connect(self.drawing.rest)
        self.session.came.connect(self._came)
        self.session.failed.connect(self._failed)
        self._in_dialog = True
        self.form.destroyed.connect(self._form_destroyed)
        # Last, for whatever cannot be shown would leave it open.
        if transaction is None:
            self._document.openTransaction(translate("Edit gridshell"))
            transaction = active_transaction()
        self._transaction = transaction
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

    def slotRecomputedDocument(self, document):
        # As after each edit in FreeCAD's own editor, or of the source: what that has come to is taken up.
        if document != self._document:
            return
        if not self._unreadable and not self._pause.isActive():
            self._show_values()
        self.session.follow()

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
        form = PanelForm(self._entered)
        form.setWindowTitle(translate("Gridshell"))
        form.setWindowIcon(QtGui.QIcon(icon("Funicular_Gridshell")))
        column = QtWidgets.QVBoxLayout(form)
        column.setContentsMargins(0, 0, 0, 0)
        self.state = StatePart(self.session, self._show_these, lambda change: self.supports.do(change))
        column.addWidget(self.state)
        self.motion = MotionPart(self.session)
        column.addWidget(self.motion)
        for name, title, content in (*self._inputs(), *self._parts()):
            column.addWidget(Section(name, title, content, name not in FOLDED_AT_FIRST))
        explain_all(form)
        order_tabs(form)
        return form

    def _inputs(self):
        """(name, title, widget) of each section of inputs."""
        net = self._shell.Net
        # A sheet is a net without a source, and its size an input like any other.
        is_sheet = net is not None and net.Source is None and bool(net.Width.Value or net.Depth.Value)
        is_file = net is not None and net.Source is None and bool(net.File)
        owners = {
            "Gridshell": self._shell,
            "Net": net,
            "Sheet": net if is_sheet else None,
            "File": net if is_file else None,
            "Mesh": net if is_file or is_mesh_source(net) else None,
            "Edges": net if are_edges_source(net) else None,
        }
        for heading, rows in SECTIONS:
            rows = [(owners[row[0]], *row[1:]) for row in rows if owners[row[0]] is not None]
            if not rows:
                continue
            part = InputsPart(self.session, rows, self._unreadable, self._edited)
            self._columns.append(part)
            if heading == "Net":
                part.form.insertRow(0, translate("Source"), self._source_button())
            elif heading == "Solution":
                self.price = PriceTag()
                self.effects = EffectList(self.session.scene_and_accuracy)
                part.form.insertRow(part.row_of("Accuracy") + 1, "", self.price)
                part.form.addRow(self.effects)
                self.matching = MatchingPart(self.session, lambda n: part.set_value("LengthMatching", n))
                part.form.insertRow(part.row_of("LengthMatching") + 1, self.matching)
            yield heading.title().replace(" ", ""), translate(heading), part

    def _parts(self):
        """(name, title, widget) of each other section."""
        self.supports = SupportsPart(self.session, self.pointer)
        yield "Supports", translate("Supports"), self.supports
        self.loads = LoadsPart(self.session, self._where_picked, self._unreadable, self._edited)
        yield "PointLoads", translate("Point loads"), self.loads
        self.look = LookPart(self.session)
        yield "View", translate("View"), self.look
        self.colours = ColoursPart(self.session, self._unreadable)
        self._columns.append(self.colours)
        yield "ColoursAndReadings", translate("Colours and readings"), self.colours
        self.variants = VariantsPart(self.session, self._thumbnail, self._looks_at, self._show_inputs)
        yield "Alternatives", translate("Alternatives"), self.variants

    def _where_picked(self):
        """The properties that say which nodes are picked, here or in FreeCAD. Raises WrongSelection where
        none are."""
        picks = self.supports.picks
        if len(picks):
            where = picks.where(self._shell.Net)
            picks.clear()
            return where
        form = self.session.own_form
        return where_selected(self._shell, None if form is None else form.nodes / METRES)

    def _thumbnail(self, width, height):
        """A PNG picture of the form in its colours, seen as the 3D view sees it."""
        vobj, form = self._shell.ViewObject, self.session.form
        colours = vobj.Proxy.colour(vobj, form).colours(vobj.LineColor)
        placement = np.array(self._shell.getGlobalPlacement().toMatrix().A).reshape(4, 4)[:3, :3]
        return net_picture(form, colours, rotation_of(self._view()) @ placement, width, height)

    def _looks_at(self, name):
        if name:
            self.state.line.say(
                BUSY, translate("{} is shown, as it was kept. Esc shows the present form again.").format(name)
            )
        elif self._unreadable:
            self._say_what_is_unreadable()
        else:
            self.state.show_moment()

    def _view(self):
        """The 3D view of the document."""
        return FreeCADGui.getDocument(self._document.Name).ActiveView

    def _show_inputs(self):
        """Let all that is about the properties follow what they have become by other hands."""
        self._show_values()
        self.supports.forget_steps()
        self.state.warnings.forget()

    def _show_values(self):
        for column in self._columns:
            column.show_all()
        self.loads.show_all()

    def _source_button(self):
        button = QtWidgets.QPushButton(translate("Use selected faces"))
        button.setObjectName("Source")
        button.setToolTip(translate("Lay the net on the faces that are selected in the 3D view"))
        button.clicked.connect(self._use_selected_faces)
        return button

    # What the user does

    def _edited(self, is_typed=True):
        for column in self._columns:
            column.show_what_counts()
        if not is_typed:
            self._say_what_is_unreadable()
            return
        self.session.awaited.add("typing")
        self._pause.start()

    def _typed(self):
        """Typing has ended for now."""
        self.session.awaited.discard("typing")
        self.session.change()
        self._say_what_is_unreadable()

    def _entered(self):
        """The Enter key: what was typed counts at once."""
        if self._pause.isActive():
            self._pause.stop()
            self._typed()
        elif self.session.problem:
            self.session.lay_anyway()

    def _escape(self):
        """The Esc key ends what is under way, one thing at a time; the panel only where that loses nothing.

        Returns whether it was taken: FreeCAD ends the panel otherwise.
        """
        things = (
            self.supports.lay_down_tool,
            self.variants.look_away,
            self.matching.end,
            self.effects.end,
            self.session.end_solving,
        )
        if any(end() for end in things):
            self.motion.show_motion()
            return True
        if self.session.is_changed:
            self.state.line.say(
                DOUBTFUL, translate("Esc takes nothing back: press Cancel for that, or OK to keep it.")
            )
        return self.session.is_changed

    def _is_in_front(self, widget):
        """Whether a key in a widget is meant for the document of the panel, and not for another one."""
        active = FreeCADGui.activeDocument()
        return self.form.isAncestorOf(widget) or (active and active.Document == self._document)

    def _say_what_is_unreadable(self):
        """What cannot be read stands before what was found without it."""
        if self._unreadable:
            self.state.line.say(WRONG, next(iter(self._unreadable.values())))
            self._says_unreadable = True
        elif self._says_unreadable:
            # It has been put right, maybe as it was before, and then nothing else will say anything.
            self._says_unreadable = False
            self.state.show_moment()

    def _use_selected_faces(self):
        if self._shell is None:
            return
        net = self._shell.Net
        try:
            source = the_faces()
        except WrongSelection as error:
            self.state.line.say(WRONG, str(error))
            return
        before = clicked_object(net.Source)
        if before:
            before.Visibility = True
        net.Source = source
        FreeCADGui.Selection.clearSelection()
        self.session.take_up()
        if self.session.source_net is not None:
            clicked_object(source).Visibility = False

    def _show_these(self, nodes, members):
        """Let nodes and members stand out in the 3D view, until others are shown."""
        self.drawing.highlight.choose(nodes, members)
        self.session.show_again()

    def _draw(self):
        form, vobj = self.session.form, self._shell.ViewObject
        self.drawing.show(form, vobj.Proxy.colour(vobj, form))

    # What follows

    def begin(self):
        """Let the net rise."""
        self.session.take_up()

    def fit_at_rest(self):
        """Once the form has settled for the first time, show all of it."""
        self._is_to_fit = True

    def _failed(self, sentence):
        if not self._unreadable:
            self.state.show_failure(sentence)

    def _came(self):
        moment = self.session.moment
        if not self._unreadable:
            self.state.show_moment()
        if moment.scene is not self._scene:
            # What was measured is of another one.
            self._scene = moment.scene
            self.effects.stop()
            # Of what had been shown, it may be no more so, and numbers may mean other members.
            self.drawing.highlight.choose()
        # A price is found by solving: it would take its time from what moves.
        self.price.stop()
        self._quiet.start()

    def _rested(self):
        """Nothing has come for a while."""
        moment = self.session.moment
        # Warnings come and go, and their buttons with them.
        order_tabs(self.form)
        if self._is_to_fit and moment.ended:
            self._is_to_fit = False
            if hasattr(self._view(), "fitAll"):
                self._view().fitAll()
        # Of the other methods no price is known.
        if moment.ended and self._shell.Method == "Auto" and moment.result.status == "converged":
            self.price.ask(moment.scene, self.session.accuracy, None)

    def _leave(self):
        """Stop following the document, which may be about to go; returns it."""
        self._pause.stop()
        self._quiet.stop()
        self._keys.stop()
        self.session.stop()
        self.supports.leave()
        self.hover.leave()
        self.pointer.stop()
        self.drawing.remove()
        self.price.stop()
        self.effects.stop()
        for part in (*self._columns, self.motion, self.matching, self.loads):
            part.leave()
        FreeCAD.removeDocumentObserver(self)
        document, self._document, self._shell = self._document, None, None
        return document


def edit(shell, transaction=None):
    """Show the panel of a gridshell and let its form rise; for the arguments see GridshellPanel.

    Returns the panel, or None if another dialog is in the way.
    """
    if FreeCADGui.Control.activeDialog():
        report(translate("Another dialog is open in the task panel. Close it, then edit the gridshell."))
        return None
    if shell.Net is not None and getattr(shell.Net, "FunicularType", "") != "Net":
        report(f"Net is {shell.Net.Label}, which is not a Net: set it to a Net of this document")
        return None
    panel = GridshellPanel(shell, transaction)
    FreeCADGui.Control.showDialog(panel)
    panel.begin()
    return panel
