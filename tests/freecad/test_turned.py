# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns that are turned by an angle or shifted on their face, with a border on its edges all the same."""

import FreeCAD as App
import numpy as np
import Part
import pytest

from documents import array, assert_refused, recompute, reopened
from faces import FACES
from funicular.features.net import net_of
from funicular.features.net_properties import PATTERNS
from funicular.make import make_gridshell, make_net
from funicular.topology import rims

V = App.Vector


@pytest.fixture
def plane(doc):
    obj = doc.addObject("Part::Feature", "Plane")
    obj.Shape = Part.makePlane(8000, 6000)
    return obj


def area(net):
    """Of a plane net's panels, by the shoelace formula [m²]."""
    total = 0.0
    for panel in net.panels:
        x, y = net.nodes[list(panel)][:, 0], net.nodes[list(panel)][:, 1]
        total += 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1))
    return total


@pytest.mark.parametrize("angle", [20, 37, -15, 120])
@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_turned_pattern_covers_the_face_and_keeps_its_border(doc, plane, pattern, angle):
    obj = make_net(doc, plane, Pattern=pattern, Angle=angle, StepU="600 mm", StepV="600 mm")
    if recompute(doc):
        assert_refused(obj, "a sliver", "give StepU, StepV of at most about 300 mm")
        obj.StepU = obj.StepV = "300 mm"
        assert recompute(doc) == {}
    net = net_of(obj)
    assert area(net) == pytest.approx(48.0)
    (rim,) = rims(net.nodes, net.panels)
    x, y = net.nodes[rim][:, 0], net.nodes[rim][:, 1]
    to_edge = np.min([np.abs(x), np.abs(x - 8), np.abs(y), np.abs(y - 6)], axis=0)
    assert to_edge.max() < 1e-9
    edges = {tuple(sorted(pair)) for panel in net.panels for pair in zip(panel, panel[1:] + panel[:1])}
    assert len(net.nodes) - len(edges) + len(net.panels) == 1


@pytest.mark.parametrize("angle", [0.0, 30.0])
def test_members_run_in_the_direction_that_was_asked_for(doc, plane, angle):
    obj = make_net(doc, plane, Angle=angle, OffsetU=0.5, StepU="600 mm", StepV="600 mm")
    assert recompute(doc) == {}
    net = net_of(obj)
    inner = ~np.isin(net.members, net.border).any(axis=1)
    spans = np.diff(net.nodes[net.members[inner]], axis=1)[:, 0]
    turn = np.degrees(np.arctan2(spans[:, 1], spans[:, 0])) % 90
    assert np.abs((turn - angle + 45) % 90 - 45).max() < 2.0, "a cell of 615 by 600 mm is not quite square"
    assert np.linalg.norm(spans, axis=1) == pytest.approx(0.61, rel=0.03)


def test_an_offset_of_whole_cells_changes_nothing_and_half_a_cell_does(doc, plane):
    obj = make_net(doc, plane, Angle=30)
    nodes = []
    for offset in (0.0, 1.0, -2.0, 0.5):
        obj.OffsetV = offset
        assert recompute(doc) == {}
        nodes.append(array(obj.SourceNodes))
    assert np.array_equal(nodes[0], nodes[1]) and np.array_equal(nodes[0], nodes[2])
    assert nodes[0].shape != nodes[3].shape or np.abs(nodes[0] - nodes[3]).max() > 100


@pytest.mark.parametrize("kind", ["B-spline", "half a cylinder", "extrusion", "twisted B-spline"])
def test_it_stands_on_curved_faces(doc, kind, tmp_path):
    source = doc.addObject("Part::Feature", "Source")
    source.Shape = FACES[kind][0]()
    step = source.Shape.BoundBox.DiagonalLength / 16
    shell = make_gridshell(doc, source, Angle=35, OffsetU=0.3, StepU=step, StepV=step)
    assert recompute(doc) == {}
    assert shell.Status == "converged" and shell.CompressionOnly
    face = source.Shape.Faces[0]
    for node in shell.Net.SourceNodes[::9]:
        assert face.distToShape(Part.Vertex(node))[0] < 1e-9 * face.BoundBox.DiagonalLength + 1e-7
    count = len(shell.Net.Shape.Edges)
    again = reopened(doc, tmp_path / "turned.FCStd")
    assert len(net_of(again.Net).members) == count


def test_where_it_cannot_be_turned_is_named(doc, dome, box):
    net = make_net(doc, (dome, ["Face1"]), Angle=30)
    recompute(doc)
    assert_refused(net, "closes on itself or runs to a pole", "turn the pattern with SwapUV")
    net.Source = (box, ["Face2", "Face6"])
    recompute(doc)
    assert_refused(net, "Angle, OffsetU and OffsetV turn and shift the pattern on one face")
