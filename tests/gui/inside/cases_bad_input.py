# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user can do wrong in the panel: each a sentence, and the last good shape stays."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from window import (
    clear_report_view,
    edit_again,
    names,
    panel_box,
    press,
    report_view,
    result_line,
    run_command,
    select_faces,
    session_of,
    settle,
    type_into,
    wait_for_rest,
    wait_for_result,
    wait_until,
)


def panel_is_waiting(shell):
    return shell.ViewObject.Proxy._panel._pause.isActive()


def test_deleting_the_net_is_a_sentence(opened):
    before = result_line()
    opened.Document.removeObject("Net")
    type_into(panel_box("StepU"), "300 mm")
    line = wait_for_result(before)
    assert line.startswith("✖") and "Net is empty" in line


@pytest.mark.parametrize(
    "name, text, words",
    [
        ("StepU", "0 mm", "StepU"),
        ("StepU", "50 m", "StepU"),
        ("CoveringWeight", "-5 kg/m^2", "CoveringWeight"),
        ("MemberWeight", "-1", "MemberWeight"),
        ("AxialStiffness", "0 kN", "AxialStiffness"),
        ("Accuracy", "0 mm", "Accuracy"),
    ],
)
def test_bad_input_is_a_sentence_and_the_last_good_shape_stays(opened, name, text, words):
    before, form = result_line(), wait_for_rest(opened)
    type_into(panel_box(name), text)
    line = wait_for_result(before)
    assert line.startswith("✖") and words in line and "last good shape" in line
    assert len(session_of(opened).form.nodes) == len(form.nodes), "what was found stays in sight"
    clear_report_view()
    press("Ok")
    assert words in report_view(), "and OK tells it of the document"
    assert "Invalid" in (opened.Net if name == "StepU" else opened).State


def test_no_supports_is_a_sentence(opened):
    before = result_line()
    panel_box("RecipeNone").click()
    line = wait_for_result(before)
    assert line.startswith("✖") and "SupportRecipe" in line and "choose" in line


def test_what_is_no_quantity_is_a_sentence_and_ok_waits_for_better(opened):
    weight = opened.CoveringWeight
    type_into(panel_box("CoveringWeight"), "heavy")
    press("Ok")
    assert Gui.Control.activeDialog() and opened.CoveringWeight == weight
    assert result_line().startswith("✖") and "heavy" in result_line() and "kg/m²" in result_line()
    heavy = result_line()
    type_into(panel_box("CoveringWeight"), "5 mm")
    length = wait_for_result(heavy)
    assert length.startswith("✖") and "5 mm" in length
    type_into(panel_box("CoveringWeight"), "25")
    assert wait_for_result(length).startswith("✔")
    press("Ok")
    assert not Gui.Control.activeDialog()


def test_what_is_unreadable_is_not_forgotten_over_another_input(opened):
    before = result_line()
    type_into(panel_box("MemberWeight"), "heavy")
    unreadable = wait_for_result(before)
    assert unreadable.startswith("✖") and "heavy" in unreadable
    type_into(panel_box("StepV"), "600 mm")
    type_into(panel_box("CoveringWeight"), "light")
    wait_until(lambda: not panel_is_waiting(opened), "the panel's pause")
    assert result_line() == unreadable, "the first one is named"
    press("Ok")
    assert Gui.Control.activeDialog() and result_line() == unreadable
    type_into(panel_box("MemberWeight"), "13")
    assert "light" in wait_for_result(unreadable)
    type_into(panel_box("CoveringWeight"), "20")
    wait_until(lambda: result_line().startswith("✔"), "a form")
    press("Ok")
    assert not Gui.Control.activeDialog()


def test_an_unreadable_step_holds_ok_until_its_box_shows_the_old_one_again(opened):
    before, shown = result_line(), panel_box("StepU").property("text")
    type_into(panel_box("StepU"), "wide")
    assert "wide" in wait_for_result(before)
    press("Ok")
    assert Gui.Control.activeDialog()
    panel_box("StepV").setFocus()
    settle()
    assert panel_box("StepU").property("text") == shown, "FreeCAD's box takes it back by itself"
    wait_until(lambda: result_line() == before, "the result")


def test_an_unreadable_step_is_mended_by_the_old_one(opened):
    before = result_line()
    shown = panel_box("StepU").property("text")
    type_into(panel_box("StepU"), "wide")
    wrong = wait_for_result(before)
    type_into(panel_box("StepU"), shown)
    assert wait_for_result(wrong).startswith("✔")


def test_a_mended_input_mends_the_result(opened):
    before = result_line()
    type_into(panel_box("CoveringWeight"), "-5")
    wrong = wait_for_result(before)
    type_into(panel_box("CoveringWeight"), "30")
    assert wait_for_result(wrong).startswith("✔")


def test_a_deleted_source_is_a_sentence(opened, roof):
    press("Ok")
    roof.Document.removeObject("Roof")
    edges = len(opened.Shape.Edges)
    line = edit_again(opened)
    assert line.startswith("✖") and "Source" in line
    assert len(opened.Shape.Edges) == edges
    press("Cancel")


def test_a_hole_smaller_than_a_cell_is_a_sentence_and_cancel_takes_it_back(document):
    plate = document.addObject("Part::Feature", "Plate")
    hole = Part.makeCylinder(20, 10, App.Vector(1500, 900, -5))
    plate.Shape = Part.makePlane(3000, 2000).cut(hole).Faces[0]
    document.recompute()
    select_faces(plate, "Face1")
    run_command()
    line = wait_for_result()
    assert line.startswith("✖") and "smaller than a cell: give StepU" in line and "last good" not in line
    assert plate.Visibility, "there is nothing yet that could stand in its place"
    press("Cancel")
    assert names(document) == ["Plate"]
