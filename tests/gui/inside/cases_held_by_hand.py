# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports by hand in the panel: picked in the 3D view, held, weakened, lifted, taken back."""

import FreeCADGui as Gui
import numpy as np
import pytest
from funicular.gui.drawing import mark_shapes as marks
from hand import click, drag, key, move, panel, place_of, viewport
from window import (
    QtCore,
    QtWidgets,
    child,
    edit_again,
    names,
    panel_box,
    press,
    report_view,
    result_line,
    settle,
    wait_until,
)

SHIFT, ALT, CONTROL = QtCore.Qt.ShiftModifier, QtCore.Qt.AltModifier, QtCore.Qt.ControlModifier


@pytest.fixture
def standing(opened):
    """The panel of a roof on its corners, 9 × 7 nodes seen at a slant, at rest."""
    opened.Net.StepU = opened.Net.StepV = "1 m"
    opened.SupportRecipe = "Corners"
    panel().session.change()
    at_rest()
    view = Gui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    settle()
    return opened


def at_rest():
    wait_until(lambda: panel().session.is_settled, "the end of the movement")


def tool(name):
    panel_box(f"Tool{name}").click()


def hold(name):
    panel_box(f"Hold{name}").click()
    at_rest()


def picked():
    return sorted(panel().supports.picks.nodes.tolist())


def marked(kind):
    return panel().supports.marks.count(kind)


def rows():
    """The list: [(what, nodes, stiffness)]."""
    tree = panel_box("SupportList")
    items = [tree.topLevelItem(row) for row in range(tree.topLevelItemCount())]
    return [tuple(item.text(column) for column in range(3)) for item in items]


def corners():
    """Numbers of the nodes at the four corners of the net."""
    return panel().session.source_net.lattice.corners.tolist()


def border(side):
    return panel().session.source_net.lattice.sides[side].tolist()


def middle():
    """The node in the middle of the net."""
    nodes = panel().session.source_net.nodes
    return int(np.argmin(np.linalg.norm(nodes[:, :2] - nodes[:, :2].mean(axis=0), axis=1)))


def save(pictures, name):
    settle()
    Gui.ActiveDocument.ActiveView.saveImage(str(pictures / f"{name}.png"), 1000, 700, "Current")


def our_nodes():
    """How many coin nodes of the panel are in the view: below the gridshell, and beside the model."""
    shell = Gui.ActiveDocument.Document.Gridshell
    graph = Gui.ActiveDocument.ActiveView.getSceneGraph()
    roots = [shell.ViewObject.RootNode, graph]
    found = [root.getChild(k).getName().getString() for root in roots for k in range(root.getNumChildren())]
    return [name for name in found if name.startswith("Funicular_") and "legend" not in name]


def test_clicks_pick_nodes_and_one_click_holds_them(standing, pictures):
    tool("Nodes")
    one, other = middle(), middle() + 1
    click(place_of(one))
    click(place_of(other), SHIFT)
    assert picked() == sorted([one, other])
    click(place_of(other), SHIFT)
    assert picked() == sorted([one, other]), "Shift adds and does not take out"
    click(place_of(other))
    assert picked() == [one]
    height = panel().session.form.nodes[one, 2]
    hold("Fixed")
    (support,) = standing.Supports
    assert support.Kind == "Fixed" and len(support.Points) == 1 and not picked()
    source = panel().session.source_net.nodes[one]
    assert panel().session.form.nodes[one] == pytest.approx(source, abs=1e-9) and height != source[2]
    assert rows()[1][1:] == ("1", "rigid") and marked(marks.POINT) == 5
    save(pictures, "held-by-hand-point")


def test_boxes_and_lassos_pick_what_is_within(standing, pictures):
    tool("Nodes")
    centre = place_of(middle())
    around = [place_of(node) for node in (middle() - 1, middle() + 1)]
    reach = 1.1 * max(np.abs(np.array(around) - centre).max(), 20.0)
    corner = np.array([reach, reach])
    drag(
        [centre - corner, centre, centre + corner], before_release=lambda: save(pictures, "held-by-hand-box")
    )
    in_box = picked()
    form = panel().session.form
    at = np.array([place_of(node) for node in range(len(form.nodes))])
    assert in_box == np.flatnonzero((np.abs(at - centre) < corner).all(axis=1)).tolist() and len(in_box) > 2
    corner_place = place_of(corners()[0])
    drag([corner_place - 15, corner_place + 15], SHIFT)
    assert picked() == sorted({*in_box, corners()[0]}), "Shift adds to what is picked"
    # A triangle that leaves out most of the box around it.
    lasso = [centre - (0, 25), centre + (60, 12), centre + (-60, 12)]
    drag(lasso, ALT, before_release=lambda: save(pictures, "held-by-hand-lasso"))
    with_alt = picked()
    assert middle() in with_alt and set(with_alt) < set(range(len(at)))
    tool("Lasso")
    drag(lasso)
    assert picked() == with_alt
    panel_box("ClearPicks").click()
    assert not picked()
    assert "Funicular_outline" not in our_nodes()


def test_an_edge_is_picked_whole_and_outlives_another_step(standing, pictures):
    tool("Edges")
    side = border("v_min")
    between = 0.5 * (place_of(side[3]) + place_of(side[4]))
    move(between)
    assert marked(marks.HOVER) == len(side)
    click(between)
    assert picked() == sorted(side)
    hold("UprightPlane")
    (support,) = standing.Supports
    assert support.Where == "Edges and vertices" and len(support.Elements) == 1
    assert marked(marks.PLANE) == len(side)
    save(pictures, "held-by-hand-edge")
    # It moved, but for its ends in the plane in which it was.
    source, now = panel().session.source_net.nodes[side], panel().session.form.nodes[side]
    assert now[:, 1] == pytest.approx(source[:, 1], abs=1e-6) and np.abs(now - source).max() > 1e-3
    standing.Net.StepU = "500 mm"
    panel().session.change()
    at_rest()
    assert marked(marks.PLANE) == len(border("v_min")) > len(side)


@pytest.mark.parametrize(
    "button, direction, kind, free",
    [
        ("UprightLine", "z", "On its vertical line", (0, 0, 1)),
        ("LineAlong", "x", "On a line", (1, 0, 0)),
        ("PlaneAcross", "y", "On a plane", (1, 0, 1)),
    ],
)
def test_nodes_slide_only_where_they_may(standing, pictures, button, direction, kind, free):
    tool("Nodes")
    node = middle()
    click(place_of(node))
    choice = panel_box("SupportDirection")
    choice.setCurrentIndex(choice.findData(direction))
    hold(button)
    (support,) = standing.Supports
    assert support.Kind == kind
    moved = np.abs(panel().session.form.nodes[node] - panel().session.source_net.nodes[node])
    assert (moved[np.array(free) == 0] < 1e-9).all()
    assert marked({"L": marks.LINE, "U": marks.LINE, "P": marks.PLANE}[button[0]]) == 1
    save(pictures, f"held-by-hand-{button.lower()}")


def test_a_selected_edge_gives_the_direction(standing, roof):
    tool("Nodes")
    click(place_of(middle()))
    choice = panel_box("SupportDirection")
    choice.setCurrentIndex(choice.findData("Selected"))
    hold("LineAlong")
    assert "0 edges and faces are selected" in panel_box("SupportWords").text() and not standing.Supports
    assert picked() == [middle()], "nothing is lost by it"
    Gui.Selection.addSelection(roof, "Edge1")
    hold("LineAlong")
    assert "straight" in panel_box("SupportWords").text(), "an arch has no one direction"
    block = standing.Document.addObject("Part::Box", "Block")
    block.Placement.Rotation.Angle = 0.5
    standing.Document.recompute([block])
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(block, "Face1")
    normal = block.Shape.Faces[0].Surface.Axis
    hold("PlaneAcross")
    (support,) = standing.Supports
    assert abs(support.Direction.normalize() * normal) == pytest.approx(1.0)


def test_the_slider_weakens_from_rigid_to_free(standing, pictures):
    tree, slider = panel_box("SupportList"), panel_box("SupportStiffnessSlider")
    assert not slider.isEnabled(), "nothing is chosen"
    tree.topLevelItem(0).setSelected(True)
    at_corner, nodes = corners()[0], panel().session.source_net.nodes
    sunk = []
    for place in (150, 60):
        slider.setValue(place)
        at_rest()
        sunk.append(float(np.linalg.norm(panel().session.form.nodes[at_corner] - nodes[at_corner])))
    assert 1e-6 < sunk[0] < sunk[1], "the softer, the further it yields"
    (support,) = standing.Supports
    assert support.Where == "Corners" and rows()[0][2].endswith("kN/mm")
    assert panel_box("SupportStiffness").text() == rows()[0][2]
    assert marked(marks.YIELDS) == 4 and marked(marks.POINT) == 0
    save(pictures, "held-by-hand-yielding")
    slider.setValue(slider.maximum())
    at_rest()
    assert support.Stiffness.Value == 0 and support.Kind == "Fixed" and rows()[0][2] == "rigid"
    slider.setValue(slider.minimum())
    assert support.Kind == "Free" and rows()[0][2] == "free"
    slider.setValue(100)
    assert support.Kind == "Fixed" and support.Stiffness.Value > 0, "back from free it is what it was"
    panel_box("SupportUndo").click()
    assert not standing.Supports, "one drag is one step"


def test_what_is_held_by_hand_counts_and_is_lifted(standing):
    tool("Nodes")
    node = corners()[0]
    click(place_of(node))
    hold("UprightLine")
    click(place_of(node))
    hold("Free")
    (support,) = standing.Supports
    assert support.Kind == "Free", "what has lost its last node is gone"
    assert marked(marks.FREE) == 1 and marked(marks.POINT) == 3
    panel_box("SupportLift").click()
    at_rest()
    assert not standing.Supports and marked(marks.POINT) == 4, "the recipe holds it again"
    assert names(standing.Document) == ["Roof", "Net", "Gridshell"]


def test_list_and_view_choose_in_each_other(standing):
    tool("Nodes")
    click(place_of(middle()))
    hold("Fixed")
    (support,) = standing.Supports
    key(viewport(), QtCore.Qt.Key_Escape)
    tree = panel_box("SupportList")
    tree.clearSelection()
    assert marked(marks.RING) == 0
    click(place_of(middle()))
    assert panel().supports.list.names() == [support.Name] and marked(marks.RING) == 1
    move(place_of(corners()[0]))
    assert marked(marks.HOVER) == 4 and "Corners" in QtWidgets.QToolTip.text()
    move(place_of(middle()))
    assert support.Label in QtWidgets.QToolTip.text() and marked(marks.HOVER) == 1
    tree.clearSelection()
    tree.topLevelItem(0).setSelected(True)
    assert marked(marks.RING) == 4


def test_undo_is_the_panels_own_and_esc_ends_the_tool_first(standing):
    tool("Nodes")
    click(place_of(middle()))
    hold("Fixed")
    panel_box("RecipeBoundary").click()
    key(viewport(), QtCore.Qt.Key_Z, CONTROL)
    assert standing.SupportRecipe == "Corners" and len(standing.Supports) == 1
    key(viewport(), QtCore.Qt.Key_Z, CONTROL)
    assert not standing.Supports and Gui.Control.activeDialog()
    panel_box("SupportRedo").click()
    panel_box("SupportRedo").click()
    assert standing.SupportRecipe == "Boundary" and len(standing.Supports) == 1
    assert panel_box("ToolNodes").isChecked()
    key(viewport(), QtCore.Qt.Key_Escape)
    assert panel_box("ToolOff").isChecked() and Gui.Control.activeDialog()
    at_rest()
    key(viewport(), QtCore.Qt.Key_Escape)
    settle()
    assert Gui.Control.activeDialog() and "press Cancel" in result_line(), "what was done is not lost by it"


def test_what_cannot_hold_is_said_where_it_was_asked_for(standing):
    panel_box("RecipeNone").click()
    settle()
    assert panel_box("SupportWords").text().startswith("✖") and "falls" in panel_box("SupportWords").text()
    assert panel_box("SupportList").topLevelItemCount() == 0
    panel_box("RecipeCorners").click()
    at_rest()
    assert panel_box("SupportWords").text().startswith("Pick nodes")
    assert panel_box("SupportWords").styleSheet() == ""
    assert panel_box("SupportList").topLevelItemCount() == 1


def test_a_corner_is_raised_by_dragging(standing, pictures):
    tool("Raise")
    node = corners()[0]
    height, at = panel().session.form.nodes[node, 2], place_of(node)
    drag([at, at - (0, 30), at - (0, 60)], before_release=lambda: save(pictures, "held-by-hand-raising"))
    at_rest()
    (raised,) = standing.Net.Raised
    now = panel().session.form.nodes[node, 2]
    assert now - height == pytest.approx(raised.z / 1000) and raised.z > 100
    assert place_of(node) == pytest.approx(at - (0, 60), abs=2.0), "it stands where it was let go"
    save(pictures, "held-by-hand-raised")
    panel_box("SupportUndo").click()
    at_rest()
    assert not standing.Net.Raised
    assert "Funicular_raise" not in our_nodes()


def test_cancel_leaves_nothing_and_ok_is_one_undo_step(standing):
    document = standing.Document
    tool("Nodes")
    click(place_of(middle()))
    hold("Fixed")
    press("Ok")
    assert document.UndoCount == 1 and not our_nodes()
    support = document.Support
    assert list(support.HeldNodes) and support.ViewObject.SwitchNode.whichChild.getValue() >= 0
    before = names(document)
    edit_again(standing)
    at_rest()
    assert support.ViewObject.SwitchNode.whichChild.getValue() < 0, "marks stand for its shape"
    panel().supports.list.choose([support.Name])
    panel_box("SupportLift").click()
    tool("Nodes")
    click(place_of(middle() + 1))
    hold("UprightLine")
    panel_box("RecipeBoundary").click()
    press("Cancel")
    assert names(document) == before and standing.SupportRecipe == "Corners" and not our_nodes()
    support = document.Support
    assert standing.Supports == [support] and support.Kind == "Fixed"
    assert support.ViewObject.SwitchNode.whichChild.getValue() >= 0
    document.undo()
    assert names(document) == ["Roof"]
    assert "Error" not in report_view() and "Traceback" not in report_view()


def test_a_picture_of_all_kinds(standing, pictures):
    dock = child(QtWidgets.QDockWidget, "Combo View")
    Gui.getMainWindow().resizeDocks([dock], [400], QtCore.Qt.Horizontal)
    tool("Edges")
    side = border("u_max")
    click(0.5 * (place_of(side[2]) + place_of(side[3])))
    hold("UprightPlane")
    tool("Nodes")
    side = border("v_max")
    for node in side[3:6]:
        click(place_of(node))
    hold("UprightLine")
    click(place_of(middle()))
    hold("Fixed")
    panel_box("SupportStiffnessSlider").setValue(80)
    click(place_of(corners()[0]))
    hold("Free")
    click(place_of(middle() - 2))
    panel().supports.list.choose([standing.Supports[1].Name])
    at_rest()
    save(pictures, "held-by-hand-kinds")
    assert [marked(kind) for kind in (marks.PLANE, marks.YIELDS, marks.FREE, marks.DOT)] == [7, 1, 1, 1]
    settle()
    panel().supports.grab().save(str(pictures / "held-by-hand-panel.png"))
