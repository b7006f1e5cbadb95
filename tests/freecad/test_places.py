# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where things are: through links and parts, across seams, at poles and holes, after the source changes."""

import collections

import FreeCAD as App
import Mesh
import numpy as np
import Part
import pytest

from documents import array, assert_refused, recompute
from funicular import export
from funicular.features.gridshell import scene_of
from funicular.features.net import net_of, panels_of
from funicular.make import make_covering, make_gridshell, make_net, make_support

V = App.Vector


def feature(doc, shape):
    obj = doc.addObject("Part::Feature", "Source")
    obj.Shape = shape
    return obj


@pytest.fixture
def plate(doc):
    return feature(doc, Part.makePlane(12000, 12000))


class TestContainers:
    @pytest.fixture
    def part(self, doc, box):
        part = doc.addObject("App::Part", "Part")
        part.addObject(box)
        part.Placement.Base = V(0, 0, 1000)
        doc.recompute()
        return part

    def test_edges_of_a_body_in_a_part_that_was_moved(self, doc, box, part):
        net = make_net(doc, (box, ["Face6"]))
        both = make_net(doc, (box, ["Face6", "Face1"]))
        assert recompute(doc) == {}
        assert len([name for name in net.SourceElements if name.startswith("Edge")]) == 4
        assert len([name for name in both.SourceElements if name.startswith("Edge")]) == 7
        assert net.Shape.BoundBox.ZMax == 4000

    def test_edges_seen_through_a_link(self, doc, box):
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject = box
        link.Placement.Base = V(0, 0, 500)
        doc.recompute()
        shell = make_gridshell(doc, (link, ["Face6", "Face1"]), SupportRecipe="Lowest points")
        support = make_support(doc, shell, Elements=["Edge6"])
        assert recompute(doc) == {}
        assert len(support.HeldNodes) > 1 and shell.Status == "converged"

    def test_a_mesh_seen_through_a_link(self, doc):
        inner = doc.addObject("Mesh::Feature", "Inner")
        mesh = Mesh.Mesh()
        mesh.addFacets(([V(0, 0, 0), V(1000, 0, 0), V(0, 1000, 0)], [(0, 1, 2)]))
        inner.Mesh = mesh
        part = doc.addObject("App::Part", "Part")
        part.addObject(inner)
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        link.Placement.Base = V(0, 0, 90000)
        straight = doc.addObject("App::Link", "Straight")
        straight.LinkedObject = inner
        straight.Placement.Base = V(0, 0, 500)
        doc.recompute()
        nets = [make_net(doc, (link, ["Inner."])), make_net(doc, straight)]
        assert recompute(doc) == {}
        assert [net.SourceNodes[0].z for net in nets] == [90000, 500]

    def test_a_support_stands_in_the_part_of_its_gridshell(self, doc, box):
        shell = make_gridshell(doc, (box, ["Face6"]))
        part = doc.addObject("App::Part", "Storey")
        part.addObject(shell)
        support = make_support(doc, shell)
        assert recompute(doc) == {}
        assert support.getParentGeoFeatureGroup() == part


class TestSeamsAndPoles:
    def test_a_panel_at_the_seam_of_a_trimmed_cylinder(self, doc):
        cut = Part.makeCylinder(1200, 8000, V(0, 0, 3000), V(1, 0, 0))
        face = next(
            each
            for each in Part.makeCylinder(3000, 6000).cut(cut).Faces
            if isinstance(each.Surface, Part.Cylinder) and abs(each.Surface.Radius - 3000) < 1
        )
        source = feature(doc, face)
        for u in (0.48, 0.985, 0.0):
            net = make_net(doc, source, StepU=600, StepV=600, RemovedPanels=[(u, 0.1)])
            assert recompute(doc) == {}
            middle = net_of(net).nodes[list(panels_of(net.OpeningNodes)[0])].mean(axis=0)
            turn = np.arctan2(middle[1], middle[0]) / (2 * np.pi)
            assert abs((turn - u + 0.5) % 1.0 - 0.5) < 0.02

    def test_a_pole_is_everywhere_along_its_side(self, doc, dome):
        net = make_net(doc, (dome, ["Face1"]), StepU="2 m", StepV="2 m", Raised=[(0.5, 1.0, 100.0)])
        assert recompute(doc) == {}
        assert max(node.z for node in net.SourceNodes) == pytest.approx(10100)
        net.Raised, net.RemovedPanels = [], [V(0.3, 0.95, 0)]
        assert recompute(doc) == {}
        corners = [node for node in panels_of(net.OpeningNodes)[0] if net.NodePlaces[node].y < 1.0]
        turns = sorted(net.NodePlaces[node].x for node in corners)
        assert turns[0] <= 0.3 <= turns[-1]


class TestCurvedEdges:
    def test_a_crest_is_on_its_edge_after_a_window_has_drawn_the_source(self, doc):
        vault = feature(doc, Part.makeCylinder(6000, 9000, V(), V(0, 1, 0), 180).Faces[0])
        arcs = [
            f"Edge{k}" for k, edge in enumerate(vault.Shape.Edges, 1) if isinstance(edge.Curve, Part.Circle)
        ]
        vault.Shape.tessellate(500)
        shell = make_gridshell(doc, vault, StepU=590, StepV=590, SupportRecipe="None")
        support = make_support(doc, shell, Elements=arcs)
        assert recompute(doc) == {}
        nodes = array(shell.Net.SourceNodes)
        assert len(support.HeldNodes) == np.sum((nodes[:, 1] < 1) | (nodes[:, 1] > 8999)) == 2 * 33


class TestHoles:
    def test_a_skylight_is_no_support(self, doc, plate):
        shell = make_gridshell(doc, plate)
        assert recompute(doc) == {}
        height = max(node.z for node in shell.NodePositions)
        shell.Net.RemovedPanels = [V(0.46, 0.46, 0)]
        assert recompute(doc) == {}
        assert max(node.z for node in shell.NodePositions) > 0.95 * height

    def test_the_hole_of_a_trimmed_face_is_no_boundary_and_has_a_recipe_of_its_own(self, doc):
        source = feature(
            doc, Part.makePlane(12000, 12000).cut(Part.makeCylinder(2000, 1, V(6000, 6000, 0))).Faces[0]
        )
        shell = make_gridshell(doc, source)
        rim = make_support(doc, shell, Where="Opening rims", Kind="Free")
        assert recompute(doc) == {}
        away = np.linalg.norm(array(shell.Net.SourceNodes)[rim.HeldNodes][:, :2] - 6000, axis=1)
        assert away == pytest.approx(2000, abs=1e-3)
        held = {node for support in scene_of(shell).supports for node in support.ids.tolist()}
        assert held.isdisjoint(rim.HeldNodes) and shell.Status == "converged"
        rim.Kind = "Fixed"
        assert recompute(doc) == {}
        moved = array(shell.NodePositions) - array(shell.Net.SourceNodes)
        assert np.abs(moved[rim.HeldNodes]).max() < 1e-9

    def test_both_ends_of_a_tube_with_a_side_hole_are_boundary(self, doc):
        face = Part.makeCylinder(3000, 9000).cut(Part.makeCylinder(1200, 8000, V(0, 0, 4500), V(1, 0, 0)))
        face = next(each for each in face.Faces if abs(getattr(each.Surface, "Radius", 0) - 3000) < 1)
        shell = make_gridshell(doc, feature(doc, face), StepU=600, StepV=600)
        assert recompute(doc) == {}
        heights = {round(vertex_z) for vertex_z in _held_heights(shell)}
        assert heights == {0, 9000}

    def test_a_member_taken_out_beside_an_opening_enlarges_it_and_no_weight_is_lost(self, doc):
        shell = make_gridshell(doc, Width="6 m", Depth="6 m", MemberWeight=0, AxialStiffness="90 MN")
        shell.Net.RemovedPanels = [V(5 / 12, 5 / 12, 0)]
        assert recompute(doc) == {}
        before = shell.TotalWeight.Value
        shell.Net.RemovedMembers = [V(0.5, 5 / 12, 0)]
        assert recompute(doc) == {}
        assert len(shell.Net.OpeningAreas) == 1 and shell.Net.OpeningAreas[0] == pytest.approx(2e6)
        assert shell.TotalWeight.Value == pytest.approx(before, rel=0.02)

    def test_a_panel_taken_out_at_a_corner_leaves_nothing_loose(self, doc):
        shell = make_gridshell(doc, Width="6 m", Depth="6 m", SupportRecipe="Corners")
        shell.Net.RemovedPanels = [V(0.05, 0.05, 0)]
        assert recompute(doc) == {}
        net = net_of(shell.Net)
        assert shell.Net.NodeCount == 48 and set(range(48)) == {n for p in net.panels for n in p}


def _held_heights(shell):
    for support in scene_of(shell).supports:
        for node in support.ids.tolist():
            yield shell.Net.SourceNodes[node].z


class TestChanges:
    def test_a_deleted_source_does_not_make_the_net_a_sheet_again(self, doc, box):
        shell = make_gridshell(doc, Width="6 m", Depth="6 m")
        assert recompute(doc) == {}
        shell.Net.Source = (box, ["Face6"])
        assert recompute(doc) == {}
        doc.removeObject("Box")
        recompute(doc)
        assert_refused(shell.Net, "Source is empty")

    def test_numbers_of_a_support_mean_what_they_did_before_edits(self, doc):
        shell = make_gridshell(doc, Width="6 m", Depth="6 m", SupportRecipe="Corners")
        support = make_support(doc, shell, Nodes=[45])
        assert recompute(doc) == {}
        place = array(shell.Net.SourceNodes)[support.HeldNodes]
        shell.Net.RemovedPanels = [V(0.05, 0.05, 0)]
        assert recompute(doc) == {}
        assert np.array_equal(array(shell.Net.SourceNodes)[support.HeldNodes], place)
        support.Nodes = [0]
        recompute(doc)
        assert_refused(support, "Nodes holds 0, which edits of the net have taken out")

    def test_an_edge_that_becomes_another_is_refused(self, doc):
        whole = Part.makePlane(8000, 6000)
        source = feature(doc, whole)
        shell = make_gridshell(doc, source, SupportRecipe="Corners")
        support = make_support(doc, shell, Elements=["Edge4"])
        assert recompute(doc) == {}
        source.Shape = Part.makePlane(9000, 6000)
        assert recompute(doc) == {}, "a face that grows keeps its edges"
        source.Shape = whole.cut(Part.makeBox(2500, 2500, 10, V(7000, -500, -5))).Faces[0]
        recompute(doc)
        assert_refused(support, "Elements: Edge4 may be another", "set Elements again")
        support.Elements = ["Edge1"]
        assert recompute(doc) == {}

    def test_what_fails_is_told_to_all_that_hangs_on_it(self, doc, plate):
        shell = make_gridshell(doc, plate)
        covering = make_covering(doc, shell)
        assert recompute(doc) == {}
        shell.Net.StepU = 0
        recompute(doc)
        assert shell.Status == "failed" and "Touched" in covering.State

    def test_tables_are_not_written_of_supports_that_have_changed(self, doc, plate, tmp_path):
        shell = make_gridshell(doc, plate, SupportRecipe="Corners")
        support = make_support(doc, shell, Nodes=[24])
        assert recompute(doc) == {}
        support.Nodes = [10]
        with pytest.raises(ValueError, match="recompute it first"):
            export.export_tables(shell, str(tmp_path / "x"))


class TestVerticalPlanes:
    def test_edges_that_go_on_smoothly_are_one_line(self, doc):
        half = [Part.Arc(V(5000 * s, 0, 0), V(0, 5000 * s, 0), V(-5000 * s, 0, 0)).toShape() for s in (1, -1)]
        shell = make_gridshell(doc, feature(doc, Part.Face(Part.Wire(half))), SupportRecipe="None")
        make_support(doc, shell, Elements=["Edge1", "Edge2"], Kind="On its vertical plane")
        assert recompute(doc)["Gridshell"]
        make_support(doc, shell, Nodes=[0])
        assert recompute(doc) == {}
        planes = [support for support in scene_of(shell).supports if hasattr(support, "normal")]
        count = collections.Counter(node for plane in planes for node in plane.ids.tolist())
        assert set(count.values()) == {1}
        nodes = array(shell.Net.SourceNodes)
        for plane in planes:
            for node in plane.ids:
                outwards = nodes[node][:2] / np.linalg.norm(nodes[node][:2])
                assert abs(abs(outwards @ np.array(plane.normal)[:2]) - 1) < 0.01

    def test_a_corner_between_two_edges_is_on_both_planes(self, doc):
        shell = make_gridshell(doc, Width="6 m", Depth="4 m", SupportRecipe="None")
        make_support(doc, shell, Elements=["Edge1", "Edge2", "Edge3", "Edge4"], Kind="On its vertical plane")
        make_support(doc, shell, Points=[(0, 0)])
        assert recompute(doc) == {}
        moved = array(shell.NodePositions) - array(shell.Net.SourceNodes)
        corner = int(np.argmax(array(shell.Net.SourceNodes)[:, :2].sum(axis=1)))
        assert np.abs(moved[corner][:2]).max() < 1e-9


class TestRemarks:
    def test_a_shell_that_falls_together_on_one_point_says_so(self, doc):
        shell = make_gridshell(
            doc, feature(doc, Part.makeSphere(5000).Faces[0]), SupportRecipe="Lowest points"
        )
        recompute(doc)
        assert shell.Status != "converged" or "panels have shrunk" in shell.Summary

    def test_a_file_of_kilometres_asks_for_its_unit(self, doc, tmp_path):
        import funicular as fn

        sheet, path = fn.Net.grid(5, 4, 1), str(tmp_path / "mm.obj")
        fn.Net(sheet.nodes * 1000, sheet.members, sheet.panels).write(path)
        shell = make_gridshell(doc, File=path)
        recompute(doc)
        assert "the file measures 6.4 km in m: if it is in another unit, set FileUnit" in shell.Net.Remarks
        shell.Net.FileUnit = "mm"
        assert recompute(doc) == {}
        assert shell.Net.Remarks == "" and shell.Status == "converged"

    def test_equal_lengths_say_what_they_leave_out(self, doc, plate):
        net = make_net(doc, plate, Laying="Equal lengths", Pattern="Hexagon", Start=(0.5, 0.5), Angle=45)
        assert recompute(doc) == {}
        assert "takes StepU alone: Pattern is not used" in net.Remarks

    def test_curves_without_a_chord_are_told(self, doc):
        net = make_net(doc, feature(doc, Part.Compound([Part.makeCircle(5000)])))
        recompute(doc)
        assert "set Chord" in net.Remarks


@pytest.mark.parametrize(
    "properties, sentence",
    [
        ({"RemovedPanels": [(5, 5)]}, "RemovedPanels[0] is (5, 5, 0): give u and v between 0 and 1"),
        ({"Raised": [(0.5, 0.5, 100.0), (7000.0, 3000.0, 500.0)]}, "Raised[1] is (7000, 3000, 500)"),
        ({"RaisedNodes": [1], "RaisedHeights": [float("nan")]}, "RaisedHeights[0] is nan"),
    ],
)
def test_places_that_are_none_are_named(doc, plate, properties, sentence):
    net = make_net(doc, plate, **properties)
    recompute(doc)
    assert_refused(net, sentence)


def test_a_source_and_a_size_contradict_each_other(doc, plate):
    with pytest.raises(ValueError, match="give either source, or Width and Depth"):
        make_gridshell(doc, plate, Width="3 m", Depth="3 m")


def test_lines_that_enclose_nothing_say_what_to_do(doc):
    arch = feature(doc, Part.makePolygon([V(0, 0, 0), V(3000, 0, 3000), V(6000, 0, 0)]))
    shell = make_gridshell(doc, arch)
    recompute(doc)
    assert_refused(shell, "the net has no panels, and so no border", "leave the covering out")
    shell.CoveringWeight, shell.SupportRecipe = 0, "None"
    make_support(doc, shell, Elements=["Vertex1", "Vertex3"])
    assert recompute(doc) == {}
    assert shell.Status == "converged" and shell.CompressionOnly


def test_edges_of_a_body_keep_their_names(doc):
    lines = [Part.makeLine(V(0, 0, 0), V(4000, 0, 0)), Part.makeLine(V(4000, 0, 0), V(4000, 4000, 0))]
    source = feature(doc, Part.Compound([*lines, Part.makeCircle(3000)]))
    one = make_net(doc, (source, ["Edge3"]), Chord="500 mm")
    two = make_net(doc, (source, ["Edge1", "Edge2"]))
    assert recompute(doc) == {}
    assert [name for name in one.SourceElements if name[0] == "E"] == ["Edge3"]
    assert [name for name in two.SourceElements if name[0] == "E"] == ["Edge1", "Edge2"]
