# SPDX-License-Identifier: LGPL-2.1-or-later
"""From what is selected to a net that lies where it was clicked."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from window import (
    clear_report_view,
    panel_box,
    press,
    report_view,
    result_line,
    run_command,
    select_faces,
    settle,
    wait_for_rest,
    wait_for_result,
)


def click(root, path):
    """Select as a click in the 3D view does, by the path from the outermost object."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(root.Document.Name, root.Name, path)
    settle()


@pytest.fixture
def link(roof):
    link = roof.Document.addObject("App::Link", "Link")
    link.LinkedObject = roof
    link.Placement.Base = App.Vector(20_000, 0, 0)
    roof.Document.recompute()
    return link


def test_a_face_seen_through_a_link_is_built_on_where_it_is_seen(roof, link):
    click(link, "Face1")
    run_command()
    assert wait_for_result().startswith("✔")
    shell = roof.Document.getObject("Gridshell")
    assert wait_for_rest(shell).nodes[:, 0].min() == pytest.approx(20.0, abs=1e-3)
    assert roof.Visibility and not link.Visibility, "what was clicked gives way"
    press("Cancel")
    assert link.Visibility


def test_a_face_within_a_linked_part(roof):
    document = roof.Document
    part = document.addObject("App::Part", "Building")
    part.addObject(roof)
    part.Placement.Base = App.Vector(0, 0, 5_000)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = part
    link.Placement.Base = App.Vector(0, 30_000, 0)
    document.recompute()
    click(link, "Roof.Face1")
    run_command()
    assert wait_for_result().startswith("✔")
    shell = document.getObject("Gridshell")
    seen = link.getSubObject("Roof.Face1").BoundBox
    assert roof.Visibility and not link.Visibility
    press("Ok")
    assert shell.Shape.BoundBox.YMin == pytest.approx(seen.YMin, abs=1)
    assert shell.Shape.BoundBox.ZMin == pytest.approx(seen.ZMin, abs=1)
    document.removeObject("Gridshell")
    click(document.getObject("Net"), "")
    Gui.runCommand("Std_Delete")
    settle()
    assert document.getObject("Net") is None and link.Visibility


def test_an_object_within_a_part_picked_as_a_whole(roof):
    part = roof.Document.addObject("App::Part", "Building")
    part.addObject(roof)
    part.Placement.Base = App.Vector(0, 0, 5_000)
    roof.Document.recompute()
    click(part, "Roof.")
    run_command()
    assert wait_for_result().startswith("✔")
    shell = roof.Document.getObject("Gridshell")
    assert wait_for_rest(shell).nodes[:, 2].min() == pytest.approx(5.0, abs=1e-3)
    press("Cancel")


@pytest.mark.parametrize("length, width", [(10_000, 200), (200, 10_000), (8_000, 6_000), (30, 20)])
def test_the_first_steps_fit_the_face_in_each_direction(document, length, width):
    plane = document.addObject("Part::Plane", "Plane")
    plane.Length, plane.Width = length, width
    document.recompute()
    select_faces(plane, "Face1")
    run_command()
    assert wait_for_result().startswith("✔")
    net = document.getObject("Net")
    assert 4 <= net.CellsU <= 50 and 4 <= net.CellsV <= 50
    for step in (net.StepU.Value, net.StepV.Value):
        assert float(f"{step:.0e}") == pytest.approx(step) or float(f"{step:.1e}") == pytest.approx(step)
        assert f"{step:.6e}".startswith(("1.0", "2.0", "2.5", "5.0")), "a round number"
    press("Cancel")


def test_another_face_for_an_open_panel(opened, roof):
    other = roof.Document.addObject("Part::Feature", "Other")
    other.Shape = Part.makePlane(9_000, 5_000, App.Vector(0, 0, 7_000))
    roof.Document.recompute()
    before = result_line()
    select_faces(other, "Face1")
    panel_box("Source").click()
    assert wait_for_result(before).startswith("✔")
    assert opened.Net.Source == (other, ["Face1"])
    assert wait_for_rest(opened).nodes[:, 2].min() == pytest.approx(7.0, abs=1e-3)
    assert roof.Visibility and not other.Visibility
    press("Ok")
    roof.Document.undo()
    assert roof.Document.getObject("Net") is None and roof.Document.UndoCount == 0


def test_a_lost_source_is_mended_in_the_panel(opened, roof):
    press("Ok")
    other = roof.Document.addObject("Part::Feature", "Other")
    other.Shape = roof.Shape
    roof.Document.removeObject("Roof")
    roof.Document.recompute()
    gridshell = opened.ViewObject.Proxy
    gridshell.doubleClicked(opened.ViewObject)
    wrong = wait_for_result()
    assert wrong.startswith("✖") and "Source" in wrong and "Use selected face" in wrong
    select_faces(other, "Face1")
    panel_box("Source").click()
    assert wait_for_result(wrong).startswith("✔")


def test_other_faces_have_to_be_of_one_body(opened, roof):
    source, before = opened.Net.Source, result_line()
    box = roof.Document.addObject("Part::Box", "Box")
    roof.Document.recompute()
    select_faces(box, "Face1")
    Gui.Selection.addSelection(roof, "Face1")
    clear_report_view()
    panel_box("Source").click()
    assert "Faces of 2 bodies" in wait_for_result(before) and result_line().startswith("✖")
    assert opened.Net.Source == source and "Traceback" not in report_view()
