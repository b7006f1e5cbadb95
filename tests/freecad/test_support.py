# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports of their own: which nodes they find, how they hold them, and that they outlive other steps."""

import FreeCAD as App
import numpy as np
import Part
import pytest

import funicular as fn
from documents import array, assert_refused, recompute, reopened
from funicular.features.gridshell import scene_of
from funicular.features.net import net_of
from funicular.features.support import held_by_each
from funicular.make import make_gridshell, make_support

V = App.Vector


@pytest.fixture
def shell(doc, box):
    """On the top of the box, 8 m x 6 m, whose edges along x are at y = 0 and y = 6 m."""
    made = make_gridshell(doc, source=(box, ["Face6"]), SupportRecipe="Corners")
    assert recompute(doc) == {}
    return made


def edge_of(box, **at):
    """Name of the edge of the box all of whose points have these coordinates [mm]."""
    for number, edge in enumerate(box.Shape.Edges, 1):
        ends = [vertex.Point for vertex in edge.Vertexes]
        if all(abs(getattr(end, axis) - value) < 1e-6 for end in ends for axis, value in at.items()):
            return f"Edge{number}"
    raise AssertionError(at)


def held(shell):
    """{kind: sorted nodes} of the scene's supports."""
    found = {}
    for support in scene_of(shell).supports:
        found.setdefault(type(support).__name__, set()).update(support.ids.tolist())
    return {kind: sorted(nodes) for kind, nodes in found.items()}


def test_every_node_on_an_edge_is_fixed_whatever_the_step(doc, box, shell):
    edge = edge_of(box, y=0, z=3000)
    support = make_support(doc, shell, Where="Edges and vertices", Elements=[edge])
    for step, count in (("1 m", 9), ("500 mm", 17), ("2 m", 5)):
        shell.Net.StepU = shell.Net.StepV = step
        assert recompute(doc) == {}
        nodes = array(shell.Net.SourceNodes)
        assert sorted(support.HeldNodes) == np.flatnonzero(nodes[:, 1] == 0).tolist()
        assert len(support.HeldNodes) == len(support.Shape.Vertexes) == count
        assert set(support.HeldNodes) <= set(held(shell)["Fixed"])
        moved = np.linalg.norm(array(shell.NodePositions) - nodes, axis=1)
        assert moved[support.HeldNodes].max() < 1e-9 and moved.max() > 100


def test_supports_follow_a_face_that_changes(doc, box, shell):
    support = make_support(doc, shell, Where="Edges and vertices", Elements=[edge_of(box, y=0, z=3000)])
    box.Length, box.Height = 12000, 4000
    assert recompute(doc) == {}
    assert len(support.HeldNodes) == 13
    assert {vertex.Z for vertex in support.Shape.Vertexes} == {4000}


def test_nodes_on_an_edge_stay_on_its_vertical_plane(doc, box, shell):
    edge = edge_of(box, x=0, z=3000)
    make_support(doc, shell, Where="Edges and vertices", Elements=[edge], Kind="On its vertical plane")
    assert recompute(doc) == {}
    on_edge = np.flatnonzero(array(shell.Net.SourceNodes)[:, 0] == 0)
    positions = array(shell.NodePositions)[on_edge]
    assert np.abs(positions[:, 0]).max() < 1e-9
    assert positions[:, 2].max() > 3100, "it rises within that plane"


def test_picked_nodes_of_the_border_stay_on_its_vertical_planes(doc, box, shell):
    nodes = array(shell.Net.SourceNodes)
    on_side, on_front = np.flatnonzero(nodes[:, 0] == 0)[2:5], np.flatnonzero(nodes[:, 1] == 0)[2:5]
    places = [shell.Net.NodePlaces[node] for node in [*on_side.tolist(), *on_front.tolist()]]
    support = make_support(doc, shell, Points=places, Kind="On its vertical plane")
    assert recompute(doc) == {}
    moved = np.abs(array(shell.NodePositions) - nodes)
    assert moved[on_side, 0].max() < 1e-9 < 1.0 < moved[on_side, 2].min()
    assert moved[on_front, 1].max() < 1e-9 < 1.0 < moved[on_front, 2].min()
    support.Points = [V(0.5, 0.5, 0)]
    recompute(doc)
    assert_refused(support, "is not on the border of the net", "'On a plane'")


def test_a_support_takes_nodes_over_from_those_before_it(doc, box, shell):
    edge = make_support(doc, shell, Elements=[edge_of(box, y=0, z=3000)])
    assert recompute(doc) == {}
    first, second, *others = edge.HeldNodes
    place_of = shell.Net.NodePlaces
    line = make_support(doc, shell, Points=[place_of[second]], Kind="On its vertical line")
    assert second in held(shell)["Fixed"], "without more it adds to what holds the node"
    line.TakesOver = True
    assert recompute(doc) == {}
    assert second not in held(shell)["Fixed"] and held(shell)["OnLine"] == [second]
    assert set(others) <= set(held(shell)["Fixed"])
    free = make_support(doc, shell, Points=[place_of[node] for node in (first, second)], Kind="Free")
    assert "OnLine" not in held(shell) and first not in held(shell)["Fixed"]
    again = make_support(doc, shell, Points=[place_of[first]], TakesOver=True)
    assert first in held(shell)["Fixed"] and "OnLine" not in held(shell), "nor may what was freed stay so"
    nodes = {each: part.tolist() for each, part, _ in held_by_each(shell, net_of(shell.Net))}
    assert nodes[free] == [second] and nodes[again] == [first] and not nodes[line]
    assert nodes[edge] == others


def test_nodes_on_vertical_lines_rise_straight(doc, box, shell):
    make_support(doc, shell, Where="Boundary", Kind="On its vertical line")
    recompute(doc)
    assert_refused(shell, "nothing holds the component of 63 nodes vertically")
    make_support(doc, shell, Where="Corners")
    assert recompute(doc) == {}
    border = net_of(shell.Net).border
    moved = (array(shell.NodePositions) - array(shell.Net.SourceNodes))[border]
    assert np.abs(moved[:, :2]).max() < 1e-9


def test_a_support_that_frees_takes_nodes_from_the_recipe(doc, box, shell):
    fixed = held(shell)["Fixed"]
    corner = shell.Net.SourceElements[-1]
    freed = make_support(doc, shell, Where="Edges and vertices", Elements=[corner], Kind="Free")
    assert recompute(doc) == {}
    assert len(freed.HeldNodes) == 1 and freed.HeldNodes[0] in fixed
    assert held(shell)["Fixed"] == sorted(set(fixed) - set(freed.HeldNodes))
    assert np.linalg.norm(tuple(shell.Reactions[freed.HeldNodes[0]])) == 0


def test_a_point_is_the_node_nearest_to_it_on_the_face(doc, shell):
    support = make_support(doc, shell, Where="Points", Points=[V(0.5, 0.5, 0), V(0.27, 1, 0)])
    assert recompute(doc) == {}
    place = array(shell.Net.SourceNodes)[support.HeldNodes][:, :2]
    assert place.round(6).tolist() == [[4000, 3000], [2000, 6000]]
    shell.Net.StepU = "500 mm"
    assert recompute(doc) == {}
    place = array(shell.Net.SourceNodes)[support.HeldNodes][:, :2]
    assert place.round(6).tolist() == [[4000, 3000], [2000, 6000]]


def test_a_point_across_the_seam(doc, dome):
    shell = make_gridshell(doc, source=(dome, ["Face1"]), StepU="1 m", StepV="1 m")
    support = make_support(doc, shell, Where="Points", Points=[V(0.999, 0.0, 0)])
    assert recompute(doc) == {}
    assert net_of(shell.Net).lattice.uv[support.HeldNodes[0]].tolist() == [0.0, 0.0]


def test_a_weak_support_yields(doc, shell):
    stiff = array(shell.NodePositions)
    make_support(doc, shell, Where="Nodes", Nodes=[31], Stiffness="1 kN/m", Kind="Fixed")
    assert recompute(doc) == {}
    weakly = array(shell.NodePositions)
    assert (
        1
        < np.linalg.norm(weakly[31] - stiff[31])
        < np.linalg.norm(weakly[31] - array(shell.Net.SourceNodes)[31]) * 100
    )
    assert np.linalg.norm(tuple(shell.Reactions[31])) == pytest.approx(
        np.linalg.norm(weakly[31] - array(shell.Net.SourceNodes)[31]), rel=1e-6
    )


def test_a_plane_and_a_line_of_any_direction(doc, shell):
    make_support(doc, shell, Where="Nodes", Nodes=[31], Kind="On a plane", Direction=V(1, 0, 1))
    make_support(doc, shell, Where="Nodes", Nodes=[22], Kind="On a line", Direction=V(0, 1, 1))
    assert recompute(doc) == {}
    moved = array(shell.NodePositions) - array(shell.Net.SourceNodes)
    assert abs(moved[31] @ (1, 0, 1)) < 1e-9 and np.linalg.norm(moved[31]) > 1
    assert np.linalg.norm(np.cross(moved[22], (0, 1, 1))) < 1e-9 and np.linalg.norm(moved[22]) > 1


def test_supports_alone_without_a_recipe(doc, box, shell):
    shell.SupportRecipe = "None"
    recompute(doc)
    assert_refused(shell, "SupportRecipe is None", "or give it Supports")
    make_support(doc, shell, Where="Boundary")
    assert recompute(doc) == {}
    assert shell.Status == "converged"


def test_several_supports_are_saved_and_come_back(doc, box, shell, tmp_path):
    make_support(doc, shell, Where="Edges and vertices", Elements=[edge_of(box, y=0, z=3000)])
    make_support(doc, shell, Where="Points", Points=[V(0.5, 0.5, 0)], Kind="On its vertical line")
    assert recompute(doc) == {}
    before = held(shell)
    again = reopened(doc, tmp_path / "supports.FCStd")
    assert held(again.Gridshell) == before
    again.Net.StepU = "2 m"
    assert recompute(again) == {}
    assert len(again.Support.HeldNodes) == 5


def test_one_undo_step_makes_and_unmakes_a_support(doc, shell):
    doc.UndoMode = 1
    support = make_support(doc, shell, Where="Boundary")
    assert shell.Supports == [support] and doc.UndoNames == ["Make support"]
    doc.undo()
    assert shell.Supports == [] and "Support" not in [obj.Name for obj in doc.Objects]


@pytest.mark.parametrize(
    "properties, sentences",
    [
        ({"Where": "Edges and vertices"}, ["Elements is empty"]),
        ({"Where": "Edges and vertices", "Elements": ["Edge99"]}, ["no nodes on 'Edge99': there are Edge"]),
        ({"Where": "Points", "Points": [V(0.2, 1.5, 0)]}, ["Points[0] is (0.2, 1.5)", "between 0 and 1"]),
        ({"Where": "Points"}, ["no node is found by Points"]),
        ({"Where": "Nodes", "Nodes": [3, 63]}, ["Nodes holds 63, but the net has nodes 0 to 62"]),
        ({"Where": "Opening rims"}, ["the net has no opening"]),
        ({"Where": "Corners", "Kind": "On its vertical plane"}, ["Kind: Corners have no direction"]),
        ({"Where": "Corners", "Kind": "On a plane", "Direction": V(0, 0, 0)}, ["Direction is zero"]),
    ],
)
def test_bad_input_is_named_and_the_last_shape_stays(doc, shell, properties, sentences):
    before = array(shell.NodePositions)
    support = make_support(doc, shell, **properties)
    recompute(doc)
    assert_refused(support, *sentences)
    assert shell.Status == "failed" and shell.Summary.startswith("Support: ")
    assert np.array_equal(array(shell.NodePositions), before)


def test_what_is_no_gridshell_is_refused(doc, box, shell):
    with pytest.raises(ValueError, match="gridshell is 'Box', which is no Gridshell"):
        make_support(doc, box)
    with pytest.raises(ValueError, match="Sort is not a property of a Support"):
        make_support(doc, shell, Sort="Fixed")


def test_a_support_of_another_net_is_refused(doc, box, shell):
    other = make_gridshell(doc, source=(box, ["Face5"]), SupportRecipe="Corners")
    support = make_support(doc, other, Where="Boundary")
    shell.Supports = [support]
    recompute(doc)
    assert_refused(shell, "which is no support of the net Net")


def test_elements_of_a_dome_and_of_several_faces(doc, dome):
    shell = make_gridshell(doc, source=(dome, ["Face1"]), StepU="1 m", StepV="1 m", SupportRecipe="None")
    base = [
        f"Edge{k}" for k, edge in enumerate(dome.Shape.Edges, 1) if not edge.Degenerated and edge.isClosed()
    ]
    support = make_support(doc, shell, Where="Edges and vertices", Elements=base)
    assert recompute(doc) == {}
    assert sorted(support.HeldNodes) == net_of(shell.Net).border.tolist()
    assert shell.Status == "converged"


def test_opening_rims_are_the_borders_but_the_longest():
    from funicular.recipes import support_recipe
    from funicular.topology import rims

    sheet = fn.Net.grid(6, 6, 1)
    panels = [panel for panel in sheet.panels if not {24} & set(panel)]
    net = fn.Net(sheet.nodes, [m for m in sheet.members.tolist() if 24 not in m] + [[24, 17]], panels)
    outer, rim = rims(net.nodes, net.panels)
    assert len(outer) == 24 and len(rim) == 8
    (support,) = support_recipe(net, "opening rims")
    assert sorted(support.ids) == sorted(rim)
    assert sorted(support_recipe(net, "corners")[0].ids) == [0, 6, 42, 48]


def test_part_edges_of_a_cylinder_are_in_order(doc):
    half = doc.addObject("Part::Feature", "Half")
    half.Shape = Part.makeCylinder(3000, 8000, V(), V(0, 1, 0), 180).Faces[0]
    shell = make_gridshell(doc, source=half, StepU="700 mm", StepV="700 mm", SupportRecipe="Lowest points")
    assert recompute(doc) == {}
    from funicular.features.net import nodes_of_element

    nodes = array(shell.Net.SourceNodes)
    for element in shell.Net.SourceElements:
        line = nodes[nodes_of_element(shell.Net, element)]
        if len(line) > 1:
            apart = np.linalg.norm(np.diff(line, axis=0), axis=1)
            assert apart.max() < 1.02 * apart.min(), "neighbours along the edge"
