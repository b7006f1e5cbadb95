# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Covering in the document: a face for each panel, planes told from what is warped, its mesh."""

import FreeCAD as App
import Part
import numpy as np
import pytest

import funicular as fn
from documents import array, recompute, reopened
from funicular.export import mesh_of_covering
from funicular.features.net import panels_of
from funicular.features.net import PATTERNS, net_of
from funicular.make import make_covering, make_gridshell

V = App.Vector
# Of the panels on top of the box: their side [mm].
SIDE = 1000.0


@pytest.fixture
def shell(doc, dome):
    made = make_gridshell(doc, source=dome, StepU="3 m", StepV="2 m")
    assert recompute(doc) == {}
    return made


@pytest.fixture
def sheet(doc, box):
    """A gridshell of eight by six quads of one metre on plan, whose nodes the tests put where they want."""
    made = make_gridshell(doc, (box, "Face6"), StepU="1 m", StepV="1 m", AxialStiffness="300 kN")
    assert recompute(doc) == {} and made.Net.PanelCount == 48
    return made


def saddled(sheet, height):
    """Every panel's corners lie `height` above and below one plane, by turns. Returns the positions."""
    nodes = array(sheet.Net.SourceNodes)
    columns, rows = (nodes[:, :2] / SIDE).round().astype(int).T
    nodes[:, 2] = height * (-1.0) ** (columns + rows)
    put(sheet, nodes)
    return nodes


def put(sheet, nodes):
    sheet.NodePositions = [V(*node) for node in nodes.tolist()]
    sheet.purgeTouched()


def covered(sheet, **properties):
    """A covering of a gridshell as it is, which is not relaxed again."""
    covering = make_covering(sheet.Document, sheet, **properties)
    covering.recompute()
    return covering


def items(covering):
    return covering.Shape.childShapes()


def fan_area(corners):
    centre = corners.mean(axis=0)
    return sum(
        0.5 * np.linalg.norm(np.cross(a - centre, b - centre))
        for a, b in zip(corners, np.roll(corners, -1, axis=0))
    )


def ruled_area(corners):
    """Of the ruled surface between two opposite sides, by Gauss-Legendre quadrature."""
    points, weights = np.polynomial.legendre.leggauss(24)
    u, v = (0.5 * (1.0 + each)[..., None] for each in np.meshgrid(points, points))
    a, b, c, d = corners
    along = (1.0 - v) * (b - a) + v * (c - d)
    across = (1.0 - u) * (d - a) + u * (c - b)
    return 0.25 * (np.outer(weights, weights) * np.linalg.norm(np.cross(along, across), axis=2)).sum()


def test_a_plane_face_on_every_panel_of_a_dome_in_panel_order(doc, shell):
    """Quads between two rings of nodes are trapezia, and so plane."""
    covering = make_covering(doc, shell)
    assert recompute(doc) == {}
    nodes, panels = array(shell.NodePositions), panels_of(shell.Panels)
    assert covering.PanelCount == covering.PlanarPanels == len(panels) == shell.Net.PanelCount
    assert list(covering.WarpedPanels) == [] and covering.LargestOutOfPlane.Value < 1e-3
    assert len(items(covering)) == len(covering.Shape.Faces) == len(panels)
    for face, panel in zip(items(covering), panels):
        assert face.ShapeType == "Face" and isinstance(face.Surface, Part.Plane)
        corners = array([vertex.Point for vertex in face.OuterWire.OrderedVertexes])
        distances = np.linalg.norm(corners[:, None] - nodes[list(panel)], axis=2)
        assert distances.min(axis=1).max() < 1e-3 and len(corners) == len(panel)
    area = sum(fan_area(nodes[list(panel)]) for panel in panels)
    assert covering.Area.Value == pytest.approx(area, rel=1e-12)
    assert covering.Shape.Area == pytest.approx(area, rel=1e-9)


def test_the_area_is_the_one_that_the_covering_weight_counts(example):
    covering = make_covering(example.Document, example)
    assert recompute(example.Document) == {}
    lengths = sum(edge.Length for edge in example.Shape.Edges) / 1000
    members = 9.80665 * example.MemberWeight.getValueAs("kg/m").Value * lengths
    panels = 9.80665 * example.CoveringWeight.getValueAs("kg/m^2").Value * covering.Area.Value / 1e6
    assert example.TotalWeight.getValueAs("N").Value == pytest.approx(members + panels, rel=1e-6)


class TestSaddles:
    """Corners of a square, one height above and below its plane by turns: all is known in closed form."""

    def test_within_the_tolerance_they_are_planes(self, sheet):
        saddled(sheet, 0.4)
        covering = covered(sheet)
        assert (covering.PlanarPanels, list(covering.WarpedPanels)) == (48, [])
        assert covering.LargestOutOfPlane.Value == pytest.approx(0.4, abs=1e-9)
        for face in items(covering):
            assert isinstance(face.Surface, Part.Plane)
            assert np.abs(array([vertex.Point for vertex in face.Vertexes])[:, 2]).max() < 1e-9
            assert face.Area == pytest.approx(SIDE**2, rel=1e-9)

    def test_beyond_it_they_are_ruled(self, sheet):
        nodes = saddled(sheet, 60.0)
        covering = covered(sheet)
        assert (covering.PlanarPanels, list(covering.WarpedPanels)) == (0, list(range(48)))
        assert covering.LargestOutOfPlane.Value == pytest.approx(60.0, abs=1e-9)
        for face, panel in zip(items(covering), panels_of(sheet.Panels)):
            assert face.ShapeType == "Face" and not isinstance(face.Surface, Part.Plane)
            assert face.Area == pytest.approx(ruled_area(nodes[list(panel)]), rel=1e-6)
            assert face.Area < covering.Area.Value / 48
            for corner in nodes[list(panel)]:
                assert min((vertex.Point - V(*corner)).Length for vertex in face.Vertexes) < 1e-6
            middle = face.CenterOfMass
            assert abs(middle.z) < 1e-6 and (V(*nodes[list(panel)].mean(axis=0)) - middle).Length < 1e-6
        # Four triangles about the middle: of each, half a side times the way to it, aslant.
        assert covering.Area.Value == pytest.approx(48 * SIDE * np.hypot(SIDE, 120.0), rel=1e-12)

    def test_the_tolerance_is_the_users(self, sheet):
        saddled(sheet, 60.0)
        covering = covered(sheet, PlanarTolerance="61 mm")
        assert covering.PlanarPanels == 48
        covering.PlanarTolerance = "59 mm"
        covering.recompute()
        assert covering.PlanarPanels == 0

    def test_without_tolerance_a_plane_is_still_a_plane(self, sheet):
        nodes = saddled(sheet, 0.0)
        nodes[:, 2] = nodes[:, :2] @ [0.37, 0.11]
        put(sheet, nodes)
        assert covered(sheet, PlanarTolerance=0).PlanarPanels == 48

    def test_ruled_faces_meet_at_the_nodes_where_planes_would_not(self, sheet):
        nodes = saddled(sheet, 0.4)
        covering = covered(sheet, Kind="Ruled faces")
        assert covering.PlanarPanels == 48
        for face, panel in zip(items(covering), panels_of(sheet.Panels)):
            assert not isinstance(face.Surface, Part.Plane)
            for corner in nodes[list(panel)]:
                assert min((vertex.Point - V(*corner)).Length for vertex in face.Vertexes) < 1e-6

    @pytest.mark.parametrize("height", [0.0, 60.0])
    def test_triangles_about_the_mean(self, sheet, height):
        nodes = saddled(sheet, height)
        covering = covered(sheet, Kind="Triangles")
        assert len(items(covering)) == 48 and len(covering.Shape.Faces) == 4 * 48
        assert covering.Shape.Area == pytest.approx(48 * SIDE * np.hypot(SIDE, 2 * height), rel=1e-9)
        for item, panel in zip(items(covering), panels_of(sheet.Panels)):
            mean = V(*nodes[list(panel)].mean(axis=0))
            assert len(item.Faces) == 4
            for face in item.Faces:
                assert min((vertex.Point - mean).Length for vertex in face.Vertexes) < 1e-6

    @pytest.mark.parametrize("kind", ["Faces", "Ruled faces", "Triangles"])
    @pytest.mark.parametrize("height", [0.4, 60.0])
    def test_all_faces_look_the_way_round_that_the_panels_run(self, sheet, kind, height):
        saddled(sheet, height)
        for face in covered(sheet, Kind=kind).Shape.Faces:
            u_first, u_last, v_first, v_last = face.ParameterRange
            assert face.normalAt(0.5 * (u_first + u_last), 0.5 * (v_first + v_last)).z > 0.9


def test_a_plane_outline_that_crosses_itself_is_cut_into_triangles(sheet):
    nodes = saddled(sheet, 0.0)
    panels = panels_of(sheet.Panels)
    crossed = panels[0]
    a, b = crossed[0], crossed[1]
    nodes[[a, b]] = nodes[[b, a]]
    put(sheet, nodes)
    covering = covered(sheet)
    assert covering.isValid(), covering.getStatusString()
    beside = [number for number, panel in enumerate(panels) if {a, b} & set(panel) and number]
    assert items(covering)[0].ShapeType == "Compound" and beside
    assert items(covering)[0].Area == pytest.approx(fan_area(nodes[list(crossed)]), rel=1e-9)
    assert covering.Shape.isValid()


def test_warped_panels_of_more_corners_are_cut_into_triangles(doc, box):
    shell = make_gridshell(
        doc, (box, "Face6"), StepU="500 mm", StepV="500 mm", Pattern="Hexagon", AxialStiffness="300 kN"
    )
    assert recompute(doc) == {}
    nodes = array(shell.NodePositions)
    nodes[:, 2] += np.random.default_rng(5).uniform(-40.0, 40.0, len(nodes))
    put(shell, nodes)
    covering = covered(shell)
    panels = panels_of(shell.Panels)
    warped = set(covering.WarpedPanels)
    hexagons = [number for number, panel in enumerate(panels) if len(panel) == 6]
    assert len(hexagons) > 20 and set(hexagons) <= warped
    for number in hexagons:
        item = items(covering)[number]
        assert item.ShapeType == "Compound" and len(item.Faces) == 6
        assert item.Area == pytest.approx(fan_area(nodes[list(panels[number])]), rel=1e-9)
    quads = [number for number in warped if len(panels[number]) == 4]
    assert quads and all(items(covering)[number].ShapeType == "Face" for number in quads)


@pytest.mark.parametrize("pattern", PATTERNS)
def test_every_pattern_can_be_covered(doc, dome, box, pattern):
    source = (box, "Face6") if pattern.startswith("Ribs") else dome
    shell = make_gridshell(
        doc, source, StepU="1.5 m", StepV="1.5 m", Pattern=pattern, AxialStiffness="300 kN"
    )
    covering = make_covering(doc, shell)
    assert recompute(doc) == {}
    panels = net_of(shell.Net).panels
    assert covering.PanelCount == len(items(covering)) == len(panels) > 0
    assert covering.PlanarPanels + len(covering.WarpedPanels) == len(panels)
    assert covering.Shape.isValid()
    nodes = array(shell.NodePositions)
    for number, (item, panel) in enumerate(zip(items(covering), panels)):
        ruled = len(panel) == 4 and number in covering.WarpedPanels
        area = (ruled_area if ruled else fan_area)(nodes[list(panel)])
        assert item.Area == pytest.approx(area, rel=1e-5)


def test_it_follows_the_gridshell(doc, shell):
    covering = make_covering(doc, shell)
    assert recompute(doc) == {}
    area = covering.Area.Value
    shell.AxialStiffness = "50 kN"
    assert recompute(doc) == {}
    assert covering.Area.Value > 1.001 * area
    shell.Net.StepV = "1 m"
    assert recompute(doc) == {}
    assert covering.PanelCount == len(covering.Shape.Faces) == shell.Net.PanelCount


def test_it_stands_where_the_gridshell_stands(doc, shell):
    covering = make_covering(doc, shell)
    shell.Placement = App.Placement(V(5000, -3000, 800), App.Rotation(V(0, 0, 1), 30))
    assert recompute(doc) == {}
    assert_stands_on(covering, shell)
    assert covering.Shape.BoundBox.ZMin == pytest.approx(shell.Shape.BoundBox.ZMin, abs=1e-5)


def assert_stands_on(covering, shell):
    """A corner of the first face is the node that it should be, in the document's own axes."""
    place = shell.getGlobalPlacement()
    corners = [place.multVec(shell.NodePositions[node]) for node in panels_of(shell.Panels)[0]]
    of_covering = covering.getGlobalPlacement().multiply(covering.Placement.inverse())
    for vertex in items(covering)[0].Vertexes:
        at = of_covering.multVec(vertex.Point)
        assert min((at - corner).Length for corner in corners) < 1e-5


def test_it_goes_into_the_gridshells_part(doc, shell):
    part = doc.addObject("App::Part", "Building")
    part.addObject(shell)
    part.Placement = App.Placement(V(0, 20000, 0), App.Rotation(V(0, 0, 1), 90))
    covering = make_covering(doc, shell)
    assert recompute(doc) == {}
    assert covering.getParentGeoFeatureGroup() == part and covering.Placement == shell.Placement
    assert_stands_on(covering, shell)


def test_a_gridshell_in_a_part_is_covered_from_outside_of_it(doc, shell, sheet):
    covering = make_covering(doc, shell)
    part = doc.addObject("App::Part", "Building")
    part.addObject(sheet)
    part.Placement = App.Placement(V(0, 20000, 0), App.Rotation(V(0, 0, 1), 90))
    covering.Gridshell = sheet
    assert recompute(doc) == {} and covering.getParentGeoFeatureGroup() is None
    assert covering.Placement == part.Placement
    assert_stands_on(covering, sheet)


def test_a_file_brings_it_back_and_it_follows_again(doc, shell, tmp_path):
    covering = make_covering(doc, shell, Kind="Ruled faces")
    assert recompute(doc) == {}
    count, area = covering.PanelCount, covering.Area.Value
    again = reopened(doc, tmp_path / "covered.FCStd")
    covering = again.Covering
    assert type(covering.Proxy).__name__ == "Covering" and covering.Kind == "Ruled faces"
    assert (covering.PanelCount, covering.Area.Value) == (count, pytest.approx(area, rel=1e-9))
    again.Net.StepV = "1 m"
    assert recompute(again) == {}
    assert covering.PanelCount == again.Net.PanelCount > count


def test_its_faces_go_through_a_step_file(doc, shell, tmp_path):
    covering = make_covering(doc, shell)
    shell.AxialStiffness = "20 kN"
    assert recompute(doc) == {}
    covering.Shape.exportStep(str(tmp_path / "covering.step"))
    read = Part.read(str(tmp_path / "covering.step"))
    assert len(read.Faces) == covering.PanelCount and read.isValid()
    assert read.Area == pytest.approx(covering.Shape.Area, rel=1e-6)


class TestMesh:
    def test_it_has_the_area_of_the_covering_and_no_gaps(self, example):
        covering = make_covering(example.Document, example)
        assert recompute(example.Document) == {}
        for mesh in (mesh_of_covering(covering), mesh_of_covering(example)):
            # A mesh is kept in single precision.
            assert mesh.Area == pytest.approx(covering.Area.Value, rel=1e-5)
            assert mesh.countNonUniformOrientedFacets() == 0 and not mesh.hasNonManifolds()
            corners = [len(panel) for panel in panels_of(example.Panels)]
            assert mesh.CountFacets == sum(count for count in corners if count > 3) + corners.count(3)
            assert mesh.CountPoints == example.Net.NodeCount + sum(count > 3 for count in corners)

    def test_it_stands_where_the_gridshell_stands(self, doc, shell):
        shell.Placement.Base = V(40000, 0, 0)
        covering = make_covering(doc, shell)
        assert recompute(doc) == {}
        mesh = mesh_of_covering(covering)
        for name in ("XMin", "XMax", "YMin", "YMax", "ZMin", "ZMax"):
            there = getattr(shell.Shape.BoundBox, name)
            assert getattr(mesh.BoundBox, name) == pytest.approx(there, abs=0.01)
        assert mesh.BoundBox.XMin > 30000

    def test_what_is_not_up_to_date_is_refused(self, doc, shell):
        covering = make_covering(doc, shell)
        with pytest.raises(
            fn.InvalidInput, match="Covering is not that of Gridshell as it is now: recompute"
        ):
            mesh_of_covering(covering)
        with pytest.raises(fn.InvalidInput, match="Dome is neither a Covering nor a Gridshell"):
            mesh_of_covering(doc.Dome)
