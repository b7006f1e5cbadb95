# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flat sheets, supports of their own, and what else than one face a gridshell can be made from."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from funicular.gui.commands import SheetCommand, SupportCommand
from funicular.make import make_gridshell
from window import names, panel_box, press, result_line, run_command, settle, type_into, wait_for_result

SHEET, SUPPORT = SheetCommand.NAME, SupportCommand.NAME


@pytest.fixture
def shell(roof):
    roof.Visibility = False
    shell = make_gridshell(roof.Document, source=(roof, ["Face1"]), StepU="1 m", StepV="1 m")
    roof.Document.recompute()
    assert shell.Status == "converged", shell.Summary
    roof.Document.clearUndos()
    settle()
    return shell


def select(obj, *elements):
    for element in elements or ("",):
        Gui.Selection.addSelection(obj, element)
    settle()


def test_a_flat_sheet_rises_on_its_corners_and_takes_another_size(document):
    Gui.Selection.clearSelection()
    assert Gui.isCommandActive(SHEET)
    run_command(SHEET)
    before = wait_for_result()
    assert before.startswith("✔"), before
    assert names(document) == ["Net", "Gridshell"]
    type_into(panel_box("Width"), "6 m")
    wait_for_result(before)
    assert document.Net.Width.Value == 6000
    press("Ok")
    assert document.Gridshell.Status == "converged"
    assert document.Gridshell.Shape.BoundBox.XLength == pytest.approx(6000, rel=0.2)
    document.undo()
    assert names(document) == []


def test_a_sheet_can_be_cancelled(document):
    run_command(SHEET)
    press("Cancel")
    assert names(document) == []


def test_a_support_holds_the_edge_that_is_selected_too(shell, roof):
    shell.SupportRecipe = "Corners"
    shell.Document.recompute()
    Gui.Selection.clearSelection()
    assert not Gui.isCommandActive(SUPPORT)
    select(shell)
    select(roof, "Edge1")
    assert Gui.isCommandActive(SUPPORT)
    run_command(SUPPORT)
    support = shell.Document.Support
    assert list(support.Elements) == ["Edge1"] and len(support.HeldNodes) > 5
    assert support in shell.ViewObject.claimChildren()
    assert [selected.Name for selected in Gui.Selection.getSelection()] == ["Support"]
    assert shell.Status == "converged"
    shell.Document.undo()
    assert "Support" not in names(shell.Document)


def test_a_support_holds_the_node_that_was_clicked(shell):
    vertex = 1 + min(
        range(len(shell.Shape.Vertexes)),
        key=lambda k: shell.Shape.Vertexes[k].Point.distanceToPoint(shell.NodePositions[30]),
    )
    Gui.Selection.clearSelection()
    select(shell, f"Vertex{vertex}")
    run_command(SUPPORT)
    support = shell.Document.Support
    assert support.Where == "Points" and list(support.HeldNodes) == [30]


def test_a_support_without_more_holds_the_border(shell):
    Gui.Selection.clearSelection()
    select(shell)
    run_command(SUPPORT)
    assert shell.Document.Support.Where == "Boundary"


def test_a_sketch_like_object_of_edges_becomes_a_gridshell(document):
    lines = document.addObject("Part::Feature", "Lines")
    spans = [k * 1000 for k in range(5)]
    lines.Shape = Part.Compound(
        [Part.makeLine((x, 0, 0), (x, 4000, 0)) for x in spans]
        + [Part.makeLine((0, y, 0), (4000, y, 0)) for y in spans]
    )
    document.recompute()
    Gui.Selection.clearSelection()
    select(lines)
    run_command()
    assert result_line().startswith("✔"), result_line()
    assert "where edges cross" in result_line(), "the net's remarks are told too"
    assert document.Net.PanelCount == 16
    press("Ok")


def test_a_mesh_object_becomes_a_gridshell(document):
    import Mesh

    mesh = Mesh.Mesh()
    points = [App.Vector(1000 * x, 1000 * y, 0) for y in range(5) for x in range(5)]
    facets = [
        facet
        for y in range(4)
        for x in range(4)
        for a in [5 * y + x]
        for facet in ((a, a + 1, a + 6), (a, a + 6, a + 5))
    ]
    mesh.addFacets((points, facets))
    obj = document.addObject("Mesh::Feature", "Ground")
    obj.Mesh = mesh
    document.recompute()
    Gui.Selection.clearSelection()
    select(obj)
    assert Gui.isCommandActive("Funicular_Gridshell")
    run_command()
    assert result_line().startswith("✔"), result_line()
    assert document.Net.NodeCount == 25 and document.Net.PanelCount == 32
    press("Ok")
