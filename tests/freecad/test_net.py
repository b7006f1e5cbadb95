# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Net in the document: made, recomputed, saved, copied, shared, and what it says of bad input."""

import FreeCAD as App
import numpy as np
import Part
import pytest

from documents import array, assert_refused, edge_ends, recompute, reopened
from faces import FACES, collapsed_face, trimmed_faces
from funicular.features.net import net_of
from funicular.make import make_net

V = App.Vector


@pytest.fixture
def net(doc, box):
    made = make_net(doc, (box, ["Face6"]), StepU="1 m", StepV="1 m")
    assert recompute(doc) == {}
    return made


@pytest.mark.parametrize("kind", FACES)
def test_a_net_on_each_kind_of_face(doc, kind):
    source = doc.addObject("Part::Feature", "Source")
    source.Shape = FACES[kind][0]()
    size = source.Shape.Faces[0].BoundBox.DiagonalLength
    net = make_net(doc, source, StepU=size / 15, StepV=size / 15)
    assert recompute(doc) == {}
    numeric = net_of(net)
    nodes = numeric.nodes * 1000
    assert (len(nodes), len(numeric.members), len(numeric.panels)) == (
        net.NodeCount,
        net.MemberCount,
        net.PanelCount,
    )
    np.testing.assert_allclose(edge_ends(net.Shape), nodes[numeric.members], atol=1e-9 * size)
    distance = max(
        source.Shape.Faces[0].Surface.projectPoint(V(*node), "LowerDistance") for node in nodes[::7]
    )
    assert distance < 1e-9 * size + 1e-9 * np.abs(nodes).max()


def test_the_numbers_of_a_plain_net(net):
    assert (net.CellsU, net.CellsV, net.NodeCount, net.MemberCount, net.PanelCount) == (8, 6, 63, 110, 48)
    assert net_of(net).nodes.min(axis=0).tolist() == [0.0, 0.0, 3.0]
    assert net_of(net).nodes.max(axis=0).tolist() == [8.0, 6.0, 3.0]
    assert net_of(net).lattice.cells == (8, 6)


def test_a_net_follows_its_face(doc, box, net):
    box.Length = 10000
    assert recompute(doc) == {}
    assert net.CellsU == 10
    assert net.Shape.BoundBox.XMax == 10000
    box.Placement.Base = V(0, 0, 5000)
    doc.recompute()
    assert net.Shape.BoundBox.ZMin == 8000


def test_a_net_follows_its_properties(doc, net):
    net.StepU = "2 m"
    net.StepV = 500
    doc.recompute()
    assert (net.CellsU, net.CellsV) == (4, 12)


def test_nodes_keep_the_pattern_that_they_were_sampled_in(doc, net):
    assert net.SampledPattern == "Quad"
    net.Pattern = "Diagrid"
    assert net_of(net).lattice.pattern == "quad"


def test_a_count_takes_the_place_of_a_step(doc, net):
    net.CountU, net.CountV = 5, 3
    assert recompute(doc) == {}
    assert (net.CellsU, net.CellsV, net.NodeCount) == (5, 3, 24)
    net.CountV = 0
    assert recompute(doc) == {}
    assert (net.CellsU, net.CellsV) == (5, 6)
    net.CountU = -1
    recompute(doc)
    assert_refused(net, "CountU is -1 cells: give 0 (none) or more")


def test_a_turned_pattern_runs_along_the_other_direction(doc, net):
    net.Pattern = "Ribs u"
    assert recompute(doc) == {}
    lengthwise = net.Shape
    net.SwapUV = True
    assert recompute(doc) == {}
    across = net.Shape
    direction = {id(shape): shape.Edges[0].tangentAt(0.0) for shape in (lengthwise, across)}
    assert abs(direction[id(lengthwise)].dot(direction[id(across)])) < 1e-9
    assert (net.CellsU, net.CellsV) == (8, 6)
    # What is read back is what was laid, also of a net that would be laid otherwise now.
    net.SwapUV = False
    again = net_of(net)
    ends = again.nodes[again.members[0]]
    assert abs((ends[1] - ends[0]) @ np.array(tuple(direction[id(lengthwise)]))) < 1e-9


def test_spacing_in_the_parameter(doc, net):
    # A face whose parameters are bunched: a B-spline with poles at 0, 1 and 10 m.
    surface = Part.BSplineSurface()
    poles = [[App.Vector(x, y, 0) for y in (0, 4000)] for x in (0, 1000, 10000)]
    surface.buildFromPolesMultsKnots(poles, [3, 3], [2, 2], [0, 1], [0, 1], False, False, 2, 1)
    source = doc.addObject("Part::Feature", "Bunched")
    source.Shape = surface.toShape()
    net.Source, net.CountU, net.CountV = (source, ["Face1"]), 4, 1
    assert recompute(doc) == {}
    assert sorted({round(node.x) for node in net.SourceNodes}) == [0, 2500, 5000, 7500, 10000]
    net.Spacing = "Parameter"
    assert recompute(doc) == {}
    assert sorted({round(node.x) for node in net.SourceNodes}) == [0, 1000, 3000, 6000, 10000]


def test_counts_that_the_pattern_forces_are_told(doc, dome):
    net = make_net(doc, (dome, ["Face1"]), Pattern="Alternating", CountU=23, CountV=4)
    assert recompute(doc) == {}
    assert net.CellsU == 24 and "24 cells around the face along u instead of 23" in net.Remarks
    net.CountU = net.CellsU
    assert recompute(doc) == {}
    assert net.Remarks == ""


def test_a_net_follows_an_expression(doc, box, net):
    net.setExpression("StepU", "Box.Length / 5")
    doc.recompute()
    assert net.CellsU == 5
    box.Length = 40000
    doc.recompute()
    assert (net.CellsU, net.StepU.Value) == (5, 8000)


def test_a_net_follows_when_it_is_moved(doc, net):
    net.Placement.Base = V(0, 0, 1000)
    doc.recompute()
    assert net.Shape.BoundBox.ZMin == 4000
    assert net_of(net).nodes[:, 2].min() == 4.0


def test_save_and_reopen(doc, net, tmp_path):
    before = array(net.SourceNodes)
    again = reopened(doc, tmp_path / "net.FCStd")
    net = again.Net
    assert type(net.Proxy).__module__ == "funicular.features.net"
    assert net.State == ["Up-to-date"]
    assert again.recompute() == 0
    np.testing.assert_array_equal(array(net.SourceNodes), before)
    assert net_of(net).lattice.cells == (8, 6)
    net.StepU = "4 m"
    assert recompute(again) == {}
    assert net.CellsU == 2


def test_one_undo_step_makes_and_unmakes_a_net(doc, box):
    doc.UndoMode = 1
    make_net(doc, (box, "Face6"))
    assert doc.UndoNames == ["Make net"]
    doc.undo()
    assert doc.getObject("Net") is None
    doc.redo()
    assert recompute(doc) == {}
    assert doc.Net.CellsU == 8


def test_undo_of_a_step(doc, net):
    doc.UndoMode = 1
    doc.openTransaction("Step")
    net.StepU = "4 m"
    doc.recompute()
    doc.commitTransaction()
    assert net.CellsU == 2
    doc.undo()
    assert (net.CellsU, net.StepU.Value) == (8, 1000)
    doc.recompute()
    assert (net.CellsU, len(net.Shape.Edges)) == (8, net.MemberCount)


def test_a_copy_is_a_net_of_its_own(doc, box, net):
    copy = doc.copyObject(net)
    assert copy.Source[0] == box
    copy.StepU = "2 m"
    assert recompute(doc) == {}
    assert (copy.CellsU, net.CellsU) == (4, 8)


class TestSources:
    def test_an_object_with_one_face(self, doc, dome):
        net = make_net(doc, dome)
        assert recompute(doc) == {}
        assert net.Poles == ["v_max"] and net.ClosedU

    def test_an_object_with_a_placement(self, doc, box):
        box.Placement = App.Placement(V(0, 0, 1000), App.Rotation(V(0, 0, 1), 90))
        net = make_net(doc, (box, "Face6"))
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.XMin == pytest.approx(-6000)
        assert net.Shape.BoundBox.ZMin == pytest.approx(4000)

    def test_inside_a_part_that_moves(self, doc, box):
        part = doc.addObject("App::Part", "Storey")
        part.addObject(box)
        part.Placement.Base = V(0, 0, 10000)
        net = make_net(doc, (box, ["Face6"]))
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.ZMin == 13000
        part.Placement.Base = V(0, 0, 20000)
        doc.recompute()
        assert net.Shape.BoundBox.ZMin == 23000

    def test_inside_a_part_that_a_link_shows_again(self, doc, box):
        part = doc.addObject("App::Part", "Storey")
        part.addObject(box)
        part.Placement.Base = V(0, 0, 10000)
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        doc.recompute()
        assert len(box.Parents) == 2
        net = make_net(doc, (box, ["Face6"]))
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.ZMin == 13000

    def test_parts_within_parts(self, doc, box):
        inner, outer = doc.addObject("App::Part", "Inner"), doc.addObject("App::Part", "Outer")
        inner.addObject(box)
        outer.addObject(inner)
        inner.Placement.Base, outer.Placement.Base = V(0, 0, 1000), V(0, 0, 20000)
        net = make_net(doc, (box, ["Face6"]))
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.ZMin == 24000

    def test_a_path_through_a_link(self, doc, box):
        part = doc.addObject("App::Part", "Storey")
        part.addObject(box)
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement.Base = part, V(0, 20000, 0)
        doc.recompute()
        net = make_net(doc, (link, "Box.Face6"))
        assert net.Source == (link, ["Box.Face6"])
        assert recompute(doc) == {}
        assert (net.Shape.BoundBox.YMin, net.Shape.BoundBox.ZMin) == (20000, 3000)

    def test_beside_its_face_in_the_same_part(self, doc, box, net):
        part = doc.addObject("App::Part", "Storey")
        part.addObjects([box, net])
        part.Placement.Base = V(0, 0, 10000)
        assert recompute(doc) == {}
        assert net.Source == (box, ["Face6"])
        assert (net.Shape.BoundBox.ZMin, net.getGlobalPlacement().Base.z) == (3000, 10000)

    def test_a_lone_face_inside_a_part(self, doc, dome):
        part = doc.addObject("App::Part", "Storey")
        part.addObject(dome)
        part.Placement.Base = V(0, 0, 10000)
        net = make_net(doc, dome)
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.ZMax == pytest.approx(20000)

    def test_inside_a_body_that_moves(self, doc):
        body = doc.addObject("PartDesign::Body", "Body")
        pad = body.newObject("PartDesign::AdditiveBox", "Block")
        pad.Length, pad.Width, pad.Height = 8000, 6000, 3000
        doc.recompute()
        net = make_net(doc, (pad, ["Face6"]))
        assert recompute(doc) == {}
        body.Placement.Base = V(0, 0, 1000)
        doc.recompute()
        assert net.Shape.BoundBox.ZMin == 4000

    def test_a_face_of_a_body(self, doc):
        body = doc.addObject("PartDesign::Body", "Body")
        body.newObject("PartDesign::AdditiveBox", "Block").Height = 3000
        doc.recompute()
        net = make_net(doc, (body, ["Face6"]), StepU=2, StepV=2)
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.ZMin == 3000

    def test_a_face_of_a_compound(self, doc, box):
        compound = doc.addObject("Part::Compound", "Compound")
        compound.Links = [box]
        compound.Placement.Base = V(0, 0, 500)
        doc.recompute()
        net = make_net(doc, (compound, ["Face6"]))
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.ZMin == 3500

    def test_a_link(self, doc, box):
        link = doc.addObject("App::Link", "Link")
        link.LinkedObject = box
        link.Placement.Base = V(0, 0, 500)
        doc.recompute()
        net = make_net(doc, (link, ["Face6"]))
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.ZMin == 500 + 3000


class TestBadInput:
    def refused(self, doc, net, *sentences):
        """The net is refused with these sentences; its geometry, its numbers and the document stay whole."""
        nodes, edges = array(net.SourceNodes), edge_ends(net.Shape)
        doc.recompute()
        assert_refused(net, *sentences)
        np.testing.assert_array_equal(array(net.SourceNodes), nodes)
        np.testing.assert_array_equal(edge_ends(net.Shape), edges)
        assert len(nodes) == net.NodeCount == 63

    @pytest.fixture(autouse=True)
    def saveable(self, doc, tmp_path):
        yield
        again = reopened(doc, tmp_path / "refused.FCStd")
        assert len(again.Net.Shape.Edges) == 110
        assert "Invalid" in again.Net.State

    def test_several_faces(self, doc, box, net):
        net.Source = (box, ["Face5", "Face6"])
        self.refused(doc, net, "Face6 shares no edge with Face5", "pick faces that are neighbours")

    def test_an_object_with_several_faces(self, doc, box, net):
        net.Source = (box, [""])
        self.refused(doc, net, "Source Box has 6 faces: pick one of them")

    def test_a_vertex(self, doc, box, net):
        net.Source = (box, ["Vertex1"])
        self.refused(doc, net, "Source Box.Vertex1 is not a face: pick a face")

    def test_a_face_that_is_not_there(self, doc, box, net):
        net.Source = (box, ["Face7"])
        self.refused(doc, net, "Source Box.Face7 no longer exists (Box has 6 faces now): pick the face again")

    def test_nothing(self, doc, net):
        net.Source = None
        self.refused(doc, net, "Source is empty", "set it to one face")

    def test_a_deleted_source(self, doc, net):
        doc.removeObject("Box")
        self.refused(doc, net, "Source is empty (nothing was picked, or its object was deleted): set it")

    def test_a_source_without_shape(self, doc, net):
        net.Source = (doc.addObject("Part::Feature", "Hollow"), ["Face1"])
        self.refused(doc, net, "Source Hollow has no shape: recompute or mend it, or pick another face")

    def test_inside_the_part_that_holds_its_face(self, doc, box, net):
        part = doc.addObject("App::Part", "Storey")
        part.addObject(box)
        net.Source = (part, ["Box.Face6"])
        part.addObject(net)
        self.refused(doc, net, "Net lies inside Storey, which holds its own face: move it out of Storey")

    def test_a_face_that_pinches_to_a_point(self, doc, net):
        source = doc.addObject("Part::Feature", "Horn")
        source.Shape = Part.makeTorus(2000, 2000).Faces[0]
        net.Source = (source, ["Face1"])
        net.StepV = 2000
        self.refused(
            doc, net, "Source Horn.Face1 pinches to a point inside, at (0, 0, 0) mm: split the face there"
        )

    def test_a_step_of_zero(self, doc, net):
        net.StepU = 0
        self.refused(doc, net, "StepU is 0 mm: give a length greater than zero")

    def test_a_step_larger_than_the_face(self, doc, net):
        net.StepV = "6.1 m"
        self.refused(
            doc, net, "StepV is 6100 mm, larger than the face", "measures 6000 mm: give a smaller step"
        )

    def test_an_opening_that_is_smaller_than_a_cell(self, doc, net):
        source = doc.addObject("Part::Feature", "Cut")
        source.Shape = trimmed_faces()["hole"]
        net.Source = (source, ["Face1"])
        self.refused(
            doc,
            net,
            "Source Cut.Face1: the opening around Edge5",
            "give StepU, StepV of at most about 230 mm",
        )

    @pytest.mark.parametrize("kind", trimmed_faces())
    def test_a_trimmed_face_spaced_by_parameter(self, doc, net, kind):
        source = doc.addObject("Part::Feature", "Cut")
        source.Shape = trimmed_faces()[kind]
        net.Source, net.Spacing = (source, ["Face1"]), "Parameter"
        self.refused(doc, net, "Source Cut.Face1 is trimmed", "set Spacing to Length")

    def test_a_face_without_area(self, doc, net):
        source = doc.addObject("Part::Feature", "Line")
        source.Shape = collapsed_face()
        net.Source = (source, ["Face1"])
        self.refused(doc, net, "Source Line.Face1 has no area: pick a face that spans a surface")


class TestChangedBody:
    """Before FreeCAD 1.0 'Face6' is merely the sixth face: another one, maybe, once the body has changed."""

    @pytest.fixture
    def block(self, doc):
        made = doc.addObject("Part::Feature", "Block")
        made.Shape = Part.makeBox(8000, 6000, 3000)
        return made

    @pytest.fixture
    def net(self, doc, block):
        made = make_net(doc, (block, ["Face6"]))
        assert recompute(doc) == {}
        return made

    @pytest.mark.skipif(
        int(App.Version()[0]) >= 1, reason="FreeCAD 1.0 and later follow faces through changes"
    )
    def test_a_face_that_may_be_another_is_asked_for_again(self, doc, block, net):
        block.Shape = Part.makeBox(8000, 6000, 3000).fuse(Part.makeBox(1000, 1000, 5000))
        doc.recompute()
        assert_refused(
            net, "Source Block.Face6 may be another face", "Block has changed", "pick the face again"
        )
        assert net.NodeCount == len(net.SourceNodes) == 63

    def test_a_new_pick_is_trusted(self, doc, block, net):
        block.Shape = Part.makeBox(8000, 6000, 3000).fuse(Part.makeBox(1000, 6000, 5000))
        doc.recompute()
        top = max(range(len(block.Shape.Faces)), key=lambda i: block.Shape.Faces[i].CenterOfMass.z)
        net.Source = (block, [f"Face{top + 1}"])
        assert recompute(doc) == {}
        assert net.Shape.BoundBox.ZMin == 5000

    def test_other_measures_are_the_same_body(self, doc, block, net):
        block.Shape = Part.makeBox(9000, 6000, 4000)
        assert recompute(doc) == {}
        assert (net.CellsU, net.Shape.BoundBox.ZMin) == (9, 4000)

    def test_a_lone_face_may_become_another_surface(self, doc, dome):
        net = make_net(doc, dome)
        doc.recompute()
        dome.Shape = Part.makePlane(3000, 2000)
        assert recompute(doc) == {}
        assert (net.CellsU, net.CellsV, net.ClosedU, net.Poles) == (3, 2, False, [])
