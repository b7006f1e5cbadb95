# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gridshell's panel: from the command to OK or Cancel, and what it says on the way."""

import FreeCAD as App
import FreeCADGui as Gui
import hand
import numpy as np
import pytest
from funicular.features import progress
from funicular.gui.inputs import SECTIONS, InputLabel, counts
from window import (
    QtCore,
    QtWidgets,
    clear_report_view,
    double_click_in_tree,
    edit_again,
    names,
    panel_box,
    press,
    press_key,
    report_view,
    result_line,
    run_command,
    send_key,
    settle,
    type_into,
    wait_for_rest,
    wait_for_result,
)


def shown_inputs(shell):
    """Names of the inputs that the panel of a gridshell on faces shows, from top to bottom."""
    owners = {"Net": shell.Net, "Gridshell": shell}
    rows = [(owners.get(owner), name) for _, rows in SECTIONS for owner, name, _ in rows]
    return [name for obj, name in rows if obj is not None and counts(obj, name)]


class WhileSolving(QtCore.QObject):
    """Does something once, when the status bar first speaks of a solve."""

    def __init__(self, action):
        super().__init__()
        self._action, self.happened = action, False
        Gui.getMainWindow().statusBar().messageChanged.connect(self._changed)

    def _changed(self, message):
        if "Esc cancels" in message and not self.happened:
            self.happened = True
            self._action()

    def stop(self):
        Gui.getMainWindow().statusBar().messageChanged.disconnect(self._changed)


def test_command_makes_net_and_gridshell_and_shows_the_result(opened):
    assert names(opened.Document) == ["Roof", "Net", "Gridshell"]
    assert result_line().startswith("✔") and "mm from equilibrium" in result_line()
    assert "Compression only" in result_line()
    form = wait_for_rest(opened)
    assert opened.Status == "" and opened.Shape.isNull(), "nothing is written before OK"
    press("Ok")
    assert opened.Status == "converged"
    assert len(opened.Shape.Edges) == opened.Net.MemberCount == len(opened.MemberForces) > 100
    written = np.array([tuple(node) for node in opened.NodePositions]) * 1e-3
    assert np.abs(written - form.nodes).max() < 2e-3, "what was seen is what is written"


def test_source_and_net_give_way_to_the_gridshell_and_hang_below_it(opened, roof):
    assert not roof.Visibility and not opened.Net.Visibility and opened.Visibility
    assert opened.ViewObject.claimChildren() == [opened.Net]
    assert opened.Net.ViewObject.claimChildren() == [roof]


def test_every_input_has_a_label_and_says_what_it_is(opened):
    names_of_inputs = shown_inputs(opened)
    assert len(names_of_inputs) == 20
    boxes = [panel_box(name) for name in names_of_inputs]
    reached, widget = [], boxes[0]
    while len(reached) < len(boxes) and widget.objectName() not in reached:
        reached += [widget.objectName()] if widget in boxes else []
        widget = widget.nextInFocusChain()
    assert reached == names_of_inputs, "the Tab key goes down the panel"
    for box in boxes:
        assert len(box.toolTip()) > 10, f"{box.objectName()} has no tooltip"
        assert box.focusPolicy() & QtCore.Qt.TabFocus, f"{box.objectName()} is not reached by the Tab key"


def test_a_new_weight_gives_a_new_result(opened):
    before = result_line()
    force = wait_for_rest(opened).member_forces.min()
    type_into(panel_box("CoveringWeight"), "60 kg/m^2")
    wait_for_result(before)
    assert opened.CoveringWeight.getValueAs("kg/m^2") == pytest.approx(60.0)
    assert wait_for_rest(opened).member_forces.min() < 1.2 * force
    press("Ok")
    assert opened.Status == "converged" and min(opened.MemberForces) < 1.2 * force


def test_a_bare_number_is_in_the_unit_that_is_shown(opened):
    type_into(panel_box("MemberWeight"), "20")
    assert opened.MemberWeight.getValueAs("kg/m") == pytest.approx(20.0)
    type_into(panel_box("MemberWeight"), "0.05 t/m")
    assert opened.MemberWeight.getValueAs("kg/m") == pytest.approx(50.0)


def test_a_new_step_makes_a_new_net(opened):
    before, members = result_line(), opened.Net.MemberCount
    type_into(panel_box("StepU"), "800 mm")
    wait_for_result(before)
    assert opened.Net.StepU.Value == pytest.approx(800.0)
    assert opened.Net.MemberCount != members
    assert len(wait_for_rest(opened).members) == opened.Net.MemberCount
    press("Ok")
    assert len(opened.Shape.Edges) == len(opened.MemberForces) == opened.Net.MemberCount


def test_choices_follow_the_keyboard(opened):
    before = result_line()
    panel_box("SupportRecipe").setFocus()
    send_key(panel_box("SupportRecipe"), QtCore.Qt.Key_Down)
    assert opened.SupportRecipe == "Corners"
    wait_for_result(before)
    # As after a double click on it; the space bar is FreeCAD's key for hiding what is selected.
    Gui.Selection.addSelection(opened)
    panel_box("AllowTension").setFocus()
    send_key(panel_box("AllowTension"), QtCore.Qt.Key_Space, " ")
    assert opened.AllowTension and opened.Visibility
    # Not by buddy(): PySide would keep what that gave it.
    labels = [each for each in QtWidgets.QApplication.allWidgets() if isinstance(each, InputLabel)]
    hand.mouse_on(next(each for each in labels if each._box is panel_box("AllowTension")))
    assert not opened.AllowTension, "a click on the words ticks the box"


def test_ok_is_one_undo_step(opened, roof):
    document = opened.Document
    type_into(panel_box("CoveringWeight"), "45 kg/m^2")
    press("Ok")
    assert not Gui.Control.activeDialog() and Gui.ActiveDocument.getInEdit() is None
    assert opened.CoveringWeight.getValueAs("kg/m^2") == pytest.approx(45.0)
    assert document.UndoCount == 1 and not document.HasPendingTransaction
    document.undo()
    assert names(document) == ["Roof"]
    assert roof.Visibility
    document.redo()
    assert names(document) == ["Roof", "Net", "Gridshell"]
    shell = document.getObject("Gridshell")
    assert shell.CoveringWeight.getValueAs("kg/m^2") == pytest.approx(45.0)
    assert shell.Net == document.getObject("Net") and len(shell.Shape.Edges) == shell.Net.MemberCount


def test_ok_solves_with_what_was_typed_last(opened):
    type_into(panel_box("CoveringWeight"), "75 kg/m^2")
    weight = opened.TotalWeight.Value
    press("Ok")
    assert "Touched" not in opened.State
    assert opened.TotalWeight.Value > weight


def test_cancel_leaves_nothing_behind(opened, roof):
    document = opened.Document
    type_into(panel_box("CoveringWeight"), "45 kg/m^2")
    clear_report_view()
    press("Cancel")
    assert names(document) == ["Roof"]
    assert roof.Visibility
    assert document.UndoCount == 0 and not document.HasPendingTransaction
    assert not Gui.Control.activeDialog() and Gui.ActiveDocument.getInEdit() is None
    assert report_view() == ""


def test_escape_cancels(opened, roof):
    press_key(panel_box("CoveringWeight"), QtCore.Qt.Key_Escape)
    settle()
    assert not Gui.Control.activeDialog()
    assert names(roof.Document) == ["Roof"]


def press_escape_in_the_view():
    """What FreeCAD does then: it ends the edit mode and asks no panel."""
    Gui.ActiveDocument.resetEdit()
    settle()


def test_escape_in_the_3d_view_cancels_the_command(opened, roof):
    type_into(panel_box("CoveringWeight"), "45")
    clear_report_view()
    press_escape_in_the_view()
    assert not Gui.Control.activeDialog()
    assert names(roof.Document) == ["Roof"]
    assert not roof.Document.HasPendingTransaction and roof.Document.UndoCount == 0
    assert report_view() == ""


def test_escape_in_the_3d_view_cancels_an_edit(opened):
    press("Ok")
    weight = opened.CoveringWeight
    edit_again(opened)
    type_into(panel_box("CoveringWeight"), "45")
    press_escape_in_the_view()
    assert not Gui.Control.activeDialog()
    assert opened.CoveringWeight == weight
    assert not opened.Document.HasPendingTransaction and opened.Document.UndoCount == 1


def test_double_click_edits_and_cancel_restores(opened):
    press("Ok")
    document, nodes, weight = opened.Document, opened.NodePositions, opened.CoveringWeight
    before = edit_again(opened)
    assert Gui.ActiveDocument.getInEdit().Object == opened
    type_into(panel_box("CoveringWeight"), "90 kg/m^2")
    wait_for_result(before)
    assert opened.NodePositions == nodes, "nothing is written before OK"
    press("Cancel")
    assert opened.CoveringWeight == weight
    assert len(opened.NodePositions) == len(nodes)
    assert max((a - b).Length for a, b in zip(opened.NodePositions, nodes)) < 2 * opened.Accuracy.Value
    assert document.UndoCount == 1 and not document.HasPendingTransaction
    assert "Touched" not in opened.State


def test_double_click_edits_and_ok_is_one_more_undo_step(opened):
    press("Ok")
    document, weight = opened.Document, opened.CoveringWeight
    edit_again(opened)
    type_into(panel_box("CoveringWeight"), "90 kg/m^2")
    type_into(panel_box("StepV"), "700 mm")
    press("Ok")
    assert document.UndoCount == 2
    document.undo()
    assert opened.CoveringWeight == weight and opened.Net.StepV.Value != pytest.approx(700.0)


def test_double_click_in_the_tree_is_one_undo_step(opened):
    press("Ok")
    document = opened.Document
    double_click_in_tree("Gridshell")
    before = wait_for_result()
    type_into(panel_box("CoveringWeight"), "55")
    wait_for_result(before)
    press("Ok")
    assert document.UndoCount == 2 and not document.HasPendingTransaction
    double_click_in_tree("Gridshell")
    wait_for_result()
    type_into(panel_box("CoveringWeight"), "95")
    press("Cancel")
    assert opened.CoveringWeight.getValueAs("kg/m^2") == pytest.approx(55.0)
    assert document.UndoCount == 2 and not document.HasPendingTransaction


def test_a_net_is_edited_with_its_gridshell(opened):
    press("Ok")
    assert opened.Net.ViewObject.Proxy.doubleClicked(opened.Net.ViewObject)
    wait_for_result()
    assert Gui.ActiveDocument.getInEdit().Object == opened
    press("Cancel")


def test_deleting_the_gridshell_closes_its_panel(opened):
    document = opened.Document
    clear_report_view()
    type_into(panel_box("CoveringWeight"), "45")
    document.removeObject("Gridshell")
    settle()
    assert not Gui.Control.activeDialog()
    assert report_view() == ""


def test_enter_in_a_box_ends_the_typing_alone(opened):
    type_into(panel_box("MemberWeight"), "15")
    press_key(panel_box("MemberWeight"), QtCore.Qt.Key_Return)
    assert not hand.panel()._pause.isActive(), "it is taken up at once"
    wait_for_rest(opened)
    assert Gui.Control.activeDialog()
    press_key(panel_box("MemberWeight"), QtCore.Qt.Key_Escape)
    assert Gui.Control.activeDialog() and "press Cancel" in result_line()
    press("Ok")
    assert opened.MemberWeight.getValueAs("kg/m") == pytest.approx(15.0) and opened.Document.UndoCount == 1


def test_esc_ends_a_long_solve_and_leaves_the_last_good_shape(opened, monkeypatch):
    edges = len(opened.Shape.Edges)
    monkeypatch.setattr(progress, "SHOWN_AFTER", 0.0)
    before = result_line()
    watch = WhileSolving(lambda: press_key(Gui.getMainWindow(), QtCore.Qt.Key_Escape))
    opened.CoveringWeight = "70 kg/m^2"
    opened.Document.recompute()
    watch.stop()
    assert watch.happened, "the window took no events during the solve"
    assert "Invalid" in opened.State and "cancelled" in opened.getStatusString()
    assert len(opened.Shape.Edges) == edges and result_line() == before
    assert Gui.Control.activeDialog(), "the panel took no notice of the key"


def test_a_second_double_click_does_not_disturb_the_open_panel(opened):
    document = opened.Document
    opened.ViewObject.Proxy.doubleClicked(opened.ViewObject)
    settle()
    assert Gui.Control.activeDialog()
    press("Cancel")
    assert names(document) == ["Roof"]


def test_closing_the_document_closes_the_panel(opened):
    type_into(panel_box("CoveringWeight"), "45")
    clear_report_view()
    App.closeDocument(opened.Document.Name)
    settle()
    assert not Gui.Control.activeDialog()
    # Longer than the panel's pause before it solves.
    QtCore.QThread.msleep(500)
    settle()
    assert report_view() == ""


def test_an_expression_is_shown_and_left_alone(opened, roof):
    press("Ok")
    roof.addProperty("App::PropertyLength", "Cell")
    roof.Cell = "750 mm"
    opened.Net.setExpression("StepU", "Roof.Cell")
    roof.Document.recompute()
    edit_again(opened)
    assert panel_box("StepU").property("rawValue") == pytest.approx(750.0)
    type_into(panel_box("CoveringWeight"), "35")
    press("Ok")
    assert opened.Net.ExpressionEngine == [("StepU", "Roof.Cell")]
    assert opened.Net.StepU.Value == pytest.approx(750.0)


EXPRESSIONS = {
    "MemberWeight": "10 kg/m + 5 kg/m",
    "Snow": "0.5 kPa",
    "AxialStiffness": "40 kN * 2",
    "LengthMatching": "0 + 0",
    "Method": "1",
    "AllowTension": "1 > 2 ? 1 : 0",
}


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_what_an_expression_drives_is_read_only_and_says_so(opened, name):
    press("Ok")
    opened.setExpression(name, EXPRESSIONS[name])
    opened.Document.recompute()
    value = getattr(opened, name)
    expression = dict(opened.ExpressionEngine)[name]
    edit_again(opened)
    box = panel_box(name)
    assert expression in box.toolTip()
    line = box if isinstance(box, QtWidgets.QLineEdit) else box.findChild(QtWidgets.QLineEdit)
    assert line.isReadOnly() if line is not None else not box.isEnabled()
    assert not panel_box("CoveringWeight").isReadOnly() and panel_box("SupportRecipe").isEnabled()
    press("Ok")
    assert getattr(opened, name) == value and dict(opened.ExpressionEngine)[name] == expression


def test_what_follows_an_expression_follows_it_in_the_panel_too(opened):
    press("Ok")
    opened.Net.setExpression("StepV", ".StepU")
    opened.setExpression("Snow", "CoveringWeight * 10 m/s^2")
    opened.Document.recompute()
    before = edit_again(opened)
    assert panel_box("Snow").text() == "0.3 kN/m²"
    type_into(panel_box("StepU"), "800 mm")
    type_into(panel_box("CoveringWeight"), "50")
    wait_for_result(before)
    assert panel_box("StepV").property("rawValue") == pytest.approx(800.0)
    assert panel_box("Snow").text() == "0.5 kN/m²"
    press("Ok")
    assert opened.Net.StepV.Value == pytest.approx(800.0) and len(opened.ExpressionEngine) == 1


def test_units_of_the_field(opened):
    assert panel_box("CoveringWeight").text() == "30 kg/m²"
    assert panel_box("Snow").text() == "0 kN/m²"
    before = result_line()
    type_into(panel_box("Snow"), "0.75")
    wait_for_result(before)
    assert opened.Snow.getValueAs("Pa") == pytest.approx(750.0)
    type_into(panel_box("Snow"), "600 N/m²")
    assert opened.Snow.getValueAs("Pa") == pytest.approx(600.0)
    type_into(panel_box("CoveringWeight"), "45 kg/m²")
    assert opened.CoveringWeight.getValueAs("kg/m^2") == pytest.approx(45.0)


def test_labels_stand_beside_their_inputs_and_none_is_cut_off(opened):
    rows = [panel_box(name) for name in shown_inputs(opened)]
    labels = [
        widget for widget in QtWidgets.QApplication.allWidgets() if isinstance(widget, QtWidgets.QLabel)
    ]
    labels = [label for label in labels if label.isVisible() and label.buddy() in rows]
    assert len(labels) == len(rows)
    for label in labels:
        box, place = place_of(label.buddy()), place_of(label)
        assert box.x() >= place.x() + label.width() and place.y() > box.y() - label.height()
        assert label.width() >= label.sizeHint().width(), f"{label.text()} is cut off"


def place_of(widget):
    return widget.mapToGlobal(QtCore.QPoint(0, 0))


def test_a_net_can_carry_a_second_gridshell(opened):
    press("Ok")
    document = opened.Document
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(opened.Net)
    run_command()
    wait_for_result()
    press("Ok")
    assert names(document) == ["Roof", "Net", "Gridshell", "Gridshell001"]
    assert document.getObject("Gridshell001").Net == opened.Net


def test_each_pattern_has_a_picture_and_can_be_chosen(opened):
    box = panel_box("Pattern")
    pictures = [box.itemIcon(row).pixmap(64, 64).toImage() for row in range(box.count())]
    assert len(pictures) == 14
    for row, picture in enumerate(pictures):
        assert not picture.isNull()
        assert picture not in pictures[:row], f"{box.itemText(row)} looks like another one"
    before = result_line()
    box.setCurrentIndex(box.findText("Kagome"))
    assert wait_for_result(before).startswith("✔")
    assert opened.Net.Pattern == "Kagome"
    assert len(wait_for_rest(opened).members) == opened.Net.MemberCount
