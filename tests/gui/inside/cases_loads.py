# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point loads in the window: the command, the arrows, and their part of the panel."""

import FreeCADGui as Gui
import numpy as np
import pytest
from funicular.gui.load_command import PointLoadCommand
from funicular.make import make_gridshell, make_point_load
from window import (
    QtWidgets,
    child,
    clear_report_view,
    edit_again,
    names,
    panel_box,
    press,
    report_view,
    result_line,
    run_command,
    session_of,
    settle,
    type_into,
    wait_for_rest,
    wait_until,
)

LOAD = PointLoadCommand.NAME
CROWN = [(0.5, 0.5)]


@pytest.fixture
def shell(roof):
    """On its corners."""
    roof.Visibility = False
    shell = make_gridshell(
        roof.Document, source=(roof, ["Face1"]), StepU="800 mm", StepV="600 mm", AxialStiffness="300 kN"
    )
    shell.SupportRecipe = "Corners"
    roof.Document.recompute()
    assert shell.Status == "converged", shell.Summary
    roof.Document.clearUndos()
    view = Gui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    settle()
    return shell


def picture(path):
    settle()
    assert Gui.getMainWindow().screen().grabWindow(0).save(str(path))


def vertex_at(shell, node):
    at = shell.NodePositions[node]
    apart = [vertex.Point.distanceToPoint(at) for vertex in shell.Shape.Vertexes]
    return f"Vertex{1 + int(np.argmin(apart))}"


def tips_of(load):
    """(k, 3) [mm] of the arrows that are drawn, and their label."""
    arrows = load.ViewObject.Proxy._arrows
    points = np.array([point.getValue() for point in arrows._arrows._points.point.getValues()]).reshape(
        -1, 6, 3
    )
    return points[:, 1], arrows.text


def node_of(shell, number):
    return np.array(tuple(shell.NodePositions[number]))


def show_rows():
    """Let the section of loads be seen in the panel, which scrolls."""
    button = child(QtWidgets.QPushButton, "AddLoad")
    widgets = QtWidgets.QApplication.allWidgets()
    (area,) = [
        each for each in widgets if isinstance(each, QtWidgets.QScrollArea) and each.isAncestorOf(button)
    ]
    settle()
    area.ensureWidgetVisible(button, 0, 20)
    area.horizontalScrollBar().setValue(0)
    settle()


def click(kind, name):
    button = child(kind, name)
    assert button is not None and button.isEnabled(), f"{name} cannot be pressed"
    button.click()
    settle()


def test_the_command_loads_the_node_that_is_selected(shell, pictures):
    Gui.Selection.clearSelection()
    assert not Gui.isCommandActive(LOAD)
    Gui.Selection.addSelection(shell)
    run_command(LOAD)
    assert "No place for the load is selected" in result_line(), "and a panel says so"
    Gui.Control.closeDialog()
    settle()
    clear_report_view()
    node = len(shell.NodePositions) // 2
    height = shell.NodePositions[node].z
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(shell, vertex_at(shell, node))
    run_command(LOAD)
    load = shell.Document.PointLoad
    assert load.Where == "Points" and load.LoadedNodes == [node] and shell.PointLoads == [load]
    assert load in shell.ViewObject.claimChildren()
    assert [selected.Name for selected in Gui.Selection.getSelection()] == ["PointLoad"]
    assert shell.Status == "converged" and shell.NodePositions[node].z > height
    tips, label = tips_of(load)
    assert tips == pytest.approx(node_of(shell, node)[None], abs=0.1) and "1" in label
    Gui.Selection.clearSelection()
    picture(pictures / "loads_command.png")
    load.Force, shell.Placement.Base.x = "3 kN", 500
    shell.Document.recompute()
    tips, label = tips_of(load)
    expected = node_of(shell, node) + (shell.Placement.Base.x, 0, 0)
    assert tips == pytest.approx(expected[None], abs=0.1) and "3" in label, "arrows follow the result"
    assert report_view().strip() == ""
    for _ in range(shell.Document.UndoCount):
        shell.Document.undo()
    assert "PointLoad" not in names(shell.Document)


def test_loads_are_changed_in_the_panel_while_the_form_follows(shell, pictures):
    load = make_point_load(shell.Document, shell, Points=CROWN, Force="200 N")
    shell.Document.recompute()
    node = load.LoadedNodes[0]
    before, positions = shell.NodePositions[node].z, shell.NodePositions
    edit_again(shell)
    click(QtWidgets.QToolButton, "SectionPointLoads")
    wait_for_rest(shell)
    type_into(panel_box("PointLoadForce"), "2 kN")
    wait_until(lambda: load.Force.getValueAs("kN").Value == pytest.approx(2), "the typed force")
    wait_until(lambda: session_of(shell).moment.scene.effects[-1].force[2] < -1999, "its scene")
    form = wait_for_rest(shell)
    assert form.nodes[node, 2] * 1e3 > before + 50, "the built shell goes up where it is loaded"
    tips, label = tips_of(load)
    assert tips == pytest.approx(form.nodes[[node]] * 1e3, abs=0.1) and "2" in label
    assert shell.NodePositions == positions, "nothing is written before OK"
    show_rows()
    picture(pictures / "loads_panel.png")
    slider = panel_box("PointLoadForceSlider")
    assert slider.value() > 0
    slider.setValue(slider.maximum() // 2)
    settle()
    wait_until(lambda: session_of(shell).moment.scene.effects[-1].force[2] > -1999, "a smaller load")
    panel_box("PointLoadDirection").setCurrentIndex(2)
    wait_until(lambda: session_of(shell).moment.scene.effects[-1].force[0] > 0, "another direction")
    wait_for_rest(shell)
    show_rows()
    picture(pictures / "loads_sideways.png")
    force = load.Force.Value
    press("Ok")
    assert load.Force.Value == force and tuple(load.Direction) == (1, 0, 0)
    assert shell.Status == "converged"
    tips, _ = tips_of(load)
    assert tips == pytest.approx(node_of(shell, node)[None], abs=0.1)
    shell.Document.undo()
    settle()
    assert load.Force.getValueAs("N").Value == pytest.approx(200)


def test_a_load_is_added_in_the_panel_and_cancel_leaves_nothing(shell, pictures):
    first = make_point_load(shell.Document, shell, Points=CROWN)
    shell.Document.recompute()
    shell.Document.clearUndos()
    objects = names(shell.Document)
    edit_again(shell)
    click(QtWidgets.QToolButton, "SectionPointLoads")
    Gui.Selection.clearSelection()
    click(QtWidgets.QPushButton, "AddLoad")
    assert "No place for the load" in child(QtWidgets.QLabel, "LoadsSay").text()
    wait_for_rest(shell)
    edge = next(name for name in shell.Net.SourceElements if name.startswith("Edge"))
    Gui.Selection.addSelection(shell.Net.Source[0], edge)
    click(QtWidgets.QPushButton, "AddLoad")
    assert child(QtWidgets.QLabel, "LoadsSay") is None
    assert len(shell.PointLoads) == 2 and list(shell.PointLoads[1].Elements) == [edge]
    added = shell.PointLoads[1]
    wait_until(lambda: len(tips_of(added)[0]) > 5, "its arrows")
    wait_for_rest(shell)
    show_rows()
    picture(pictures / "loads_added.png")
    shell.ViewObject.Proxy._panel.supports.picks.add([3, 40])
    click(QtWidgets.QPushButton, "AddLoad")
    third = shell.PointLoads[2]
    wait_until(lambda: len(tips_of(third)[0]) == 2, "arrows on what was picked in the panel")
    assert not len(shell.ViewObject.Proxy._panel.supports.picks)
    click(QtWidgets.QToolButton, "PointLoadRemove")
    assert shell.PointLoads == [added, third]
    form = wait_for_rest(shell)
    assert tips_of(third)[0] == pytest.approx(form.nodes[[3, 40]] * 1e3, abs=0.1)
    press("Cancel")
    assert names(shell.Document) == objects and [each.Name for each in shell.PointLoads] == [first.Name]
    settle()
    assert shell.Document.UndoCount == 0
    back = shell.PointLoads[0]
    assert not back.ViewObject.Proxy.is_led
    tips, _ = tips_of(back)
    assert tips == pytest.approx(node_of(shell, back.LoadedNodes[0])[None], abs=0.1)


def test_arrows_stand_again_when_a_file_is_opened(shell, tmp_path):
    import FreeCAD as App

    make_point_load(shell.Document, shell, Points=CROWN)
    shell.Document.recompute()
    shell.Document.saveAs(str(tmp_path / "load.FCStd"))
    App.closeDocument(shell.Document.Name)
    document = App.openDocument(str(tmp_path / "load.FCStd"))
    settle()
    try:
        shell, load = document.Gridshell, document.PointLoad
        tips, label = tips_of(load)
        assert tips == pytest.approx(node_of(shell, load.LoadedNodes[0])[None], abs=0.1) and "1" in label
        assert load.ViewObject.DisplayMode == "Arrows"
        assert report_view().strip() == ""
    finally:
        App.closeDocument(document.Name)
