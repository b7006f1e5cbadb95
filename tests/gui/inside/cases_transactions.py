# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel's transaction and those of others: Cancel takes back what the panel did, and nothing else."""

import FreeCAD as App
import FreeCADGui as Gui
import funicular as fn
import pytest
from window import (
    QtWidgets,
    clear_report_view,
    edit_again,
    names,
    panel_box,
    press,
    report_view,
    settle,
    type_into,
    wait_for_result,
)


def weight_of(shell):
    return shell.CoveringWeight.getValueAs("kg/m^2")


def no_panel_is_left(document):
    return (
        not Gui.Control.activeDialog()
        and Gui.ActiveDocument.getInEdit() is None
        and App.getActiveTransaction() is None
        and not document.HasPendingTransaction
    )


def test_undo_ends_the_panel_with_a_sentence(opened):
    press("Ok")
    before = edit_again(opened)
    type_into(panel_box("CoveringWeight"), "90")
    wait_for_result(before)
    clear_report_view()
    Gui.runCommand("Std_Undo")
    settle()
    assert no_panel_is_left(opened.Document)
    assert weight_of(opened) == pytest.approx(30.0)
    assert "panel of Gridshell" in report_view() and "undo step" in report_view()
    Gui.runCommand("Std_Redo")
    assert weight_of(opened) == pytest.approx(90.0)


def test_undo_before_anything_is_entered_ends_the_panel(opened):
    press("Ok")
    edit_again(opened)
    type_into(panel_box("CoveringWeight"), "90")
    press("Ok")
    edit_again(opened)
    Gui.runCommand("Std_Undo")
    settle()
    assert no_panel_is_left(opened.Document)
    assert weight_of(opened) == pytest.approx(30.0)


def test_undo_of_a_new_gridshell_ends_its_panel(opened, roof):
    Gui.runCommand("Std_Undo")
    settle()
    assert no_panel_is_left(roof.Document)
    assert names(roof.Document) == ["Roof"]


def test_a_command_that_ends_the_transaction_ends_the_panel(opened, roof):
    document = roof.Document
    box = document.addObject("Part::Box", "Box")
    type_into(panel_box("CoveringWeight"), "90")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(box)
    clear_report_view()
    Gui.runCommand("Std_Delete")
    settle()
    assert no_panel_is_left(document)
    assert names(document) == ["Roof", "Net", "Gridshell"]
    assert "undo step" in report_view() and "Traceback" not in report_view()
    assert document.UndoCount == 2
    document.undo(), document.undo()
    assert names(document) == ["Roof"]


def test_the_panel_leaves_a_transaction_of_others_alone(opened):
    press("Ok")
    document = opened.Document
    document.openTransaction("Theirs")
    document.addObject("Part::Box", "Box")
    Gui.ActiveDocument.setEdit("Gridshell")
    wait_for_result()
    type_into(panel_box("CoveringWeight"), "90")
    press("Cancel")
    assert document.getObject("Box") is not None
    assert weight_of(opened) == pytest.approx(30.0)
    assert no_panel_is_left(document)


def test_a_dialog_closed_by_another_tool_is_cancelled(opened):
    press("Ok")
    edit_again(opened)
    type_into(panel_box("CoveringWeight"), "90")
    clear_report_view()
    Gui.Control.closeDialog()
    settle()
    assert no_panel_is_left(opened.Document)
    assert weight_of(opened) == pytest.approx(30.0)
    assert report_view() == ""
    assert edit_again(opened).startswith("✔"), "and it can be edited again"


class OtherPanel:
    def __init__(self):
        self.form = QtWidgets.QLabel("Other")


def test_a_dialog_that_takes_the_place_of_the_panel_stays(opened):
    press("Ok")
    edit_again(opened)
    Gui.Control.closeDialog()
    Gui.Control.showDialog(OtherPanel())
    settle()
    assert Gui.Control.activeDialog()
    assert Gui.ActiveDocument.getInEdit() is None and App.getActiveTransaction() is None


def test_the_view_provider_keeps_no_panel(opened):
    proxy = opened.ViewObject.Proxy
    assert proxy._panel is not None
    press("Cancel")
    assert proxy._panel is None


def test_cancel_with_nothing_changed_solves_nothing(opened, monkeypatch):
    press("Ok")
    edit_again(opened)
    solves, solve = [], fn.solve
    monkeypatch.setattr(fn, "solve", lambda *args, **options: solves.append(1) or solve(*args, **options))
    press("Cancel")
    assert not solves and "Touched" not in opened.State
    edit_again(opened)
    type_into(panel_box("CoveringWeight"), "90")
    press("Cancel")
    assert solves, "what was changed is solved again with the old value"


def test_cancel_takes_back_what_was_set_beside_the_panel(opened):
    press("Ok")
    edit_again(opened)
    # As FreeCAD's property editor does: it joins the transaction that is open.
    opened.CoveringWeight = "90 kg/m^2"
    press("Cancel")
    assert weight_of(opened) == pytest.approx(30.0) and "Touched" not in opened.State
