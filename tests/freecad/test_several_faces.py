# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets on several faces of one body: connected, with as many cells on both sides of each common edge."""

import collections
import math

import FreeCAD as App
import numpy as np
import Part
import pytest

import funicular as fn
from documents import array, assert_refused, recompute
from funicular.features.net import PATTERNS, net_of
from funicular.make import make_gridshell, make_net

V = App.Vector


def folded_strip():
    """Three rectangles along a zigzag, 4 m wide."""
    points = [V(0, 0, 0), V(5000, 0, 2000), V(9000, 0, 1500), V(12000, 0, 3000)]
    return Part.makePolygon(points).extrude(V(0, 4000, 0))


def tube_of_halves():
    """A tube of two half cylinders: two common edges, open at both ends."""
    half = Part.makeCylinder(3000, 8000, V(), V(0, 0, 1), 180).Faces[0]
    other = half.copy()
    other.rotate(V(), V(0, 0, 1), 180)
    sewn = Part.makeCompound([half, other])
    sewn.sewShape()
    return Part.Shell(sewn.Faces)


def lofted_vault():
    """A vault of two B-spline faces that share the ridge, where they are tangent in no way."""
    arcs = [
        Part.Arc(V(x, 0, 0), V(x, 2500, 1800 + 100 * x / 1000), V(x, 5000, 2500)).toShape()
        for x in (0, 6000, 12000)
    ]
    more = [Part.Arc(V(x, 5000, 2500), V(x, 8000, 1500), V(x, 11000, 0)).toShape() for x in (0, 6000, 12000)]
    one, other = (Part.makeLoft([Part.Wire(arc) for arc in each]) for each in (arcs, more))
    sewn = Part.makeCompound([one, other])
    sewn.sewShape()
    return Part.Shell(sewn.Faces)


def box_without_bottom():
    faces = Part.makeBox(8000, 6000, 3000).Faces
    return Part.makeShell(faces[:4] + faces[5:])


SHELLS = {
    "strip": (folded_strip, 1),
    "vault": (lofted_vault, 1),
    "tube": (tube_of_halves, 2),
    "box": (box_without_bottom, 1),
}


def add(doc, shape):
    obj = doc.addObject("Part::Feature", "Shell")
    obj.Shape = shape
    return obj


def loops(net):
    """Number of closed border loops."""
    count = collections.Counter(
        tuple(sorted(pair)) for panel in net.panels for pair in zip(panel, panel[1:] + panel[:1])
    )
    after = collections.defaultdict(list)
    for (a, b), number in count.items():
        assert number <= 2
        if number == 1:
            after[a].append(b)
            after[b].append(a)
    assert all(len(others) == 2 for others in after.values())
    seen, found = set(), 0
    for start in after:
        if start in seen:
            continue
        found += 1
        stack = [start]
        while stack:
            node = stack.pop()
            if node not in seen:
                seen.add(node)
                stack += after[node]
    return found


@pytest.mark.parametrize("kind", SHELLS)
@pytest.mark.parametrize("pattern", ["Quad", "Diagonal", "Crossed", "Centred", "Diagrid"])
def test_one_connected_net_without_gaps(doc, kind, pattern):
    make, border_loops = SHELLS[kind]
    source = add(doc, make())
    obj = make_net(doc, (source, [f"Face{k + 1}" for k in range(len(source.Shape.Faces))]), Pattern=pattern)
    assert recompute(doc) == {}
    net = net_of(obj)
    nodes = array(obj.SourceNodes)
    size = source.Shape.BoundBox.DiagonalLength
    # On the faces, no two in one place, none a loose end.
    for node in obj.SourceNodes[:: max(1, len(nodes) // 60)]:
        assert source.Shape.distToShape(Part.Vertex(node))[0] < 1e-9 * size
    apart = np.linalg.norm(nodes[:, None] - nodes[None], axis=2) + size * np.eye(len(nodes))
    assert apart.min() > 100.0
    assert loops(net) == border_loops
    edges = {tuple(sorted(pair)) for panel in net.panels for pair in zip(panel, panel[1:] + panel[:1])}
    assert len(nodes) - len(edges) + len(net.panels) == 2 - border_loops
    # Panels turn alike: each inner edge is run along once either way.
    directed = collections.Counter(pair for panel in net.panels for pair in zip(panel, panel[1:] + panel[:1]))
    assert max(directed.values()) == 1
    members = {tuple(sorted(member)) for member in net.members.tolist()}
    assert len(members) == len(net.members)


def test_counts_agree_along_common_edges_and_are_told(doc):
    # A cylinder of 3 m beside a plane that narrows away from it would have other counts by itself.
    narrow = Part.Face(Part.makePolygon([V(0, 0, 0), V(8000, 0, 0), V(8000, 5000, 0), V(0, 5000, 0), V()]))
    ruled = Part.makeRuledSurface(
        Part.makeLine(V(0, 5000, 0), V(8000, 5000, 0)),
        Part.makeLine(V(2000, 9000, 2000), V(5000, 9000, 2000)),
    )
    shell = Part.makeCompound([narrow, ruled])
    shell.sewShape()
    source = add(doc, Part.Shell(shell.Faces))
    obj = make_net(doc, (source, ["Face1", "Face2"]))
    assert recompute(doc) == {}
    assert "to meet its neighbours" in obj.Remarks
    assert loops(net_of(obj)) == 1


def test_a_whole_shell_is_taken_without_naming_its_faces(doc):
    source = add(doc, folded_strip())
    obj = make_net(doc, source)
    assert recompute(doc) == {}
    assert obj.Shape.BoundBox.XLength == pytest.approx(12000)


def test_an_edge_in_the_middle_of_a_side_is_named(doc):
    long = Part.Face(Part.makePolygon([V(0, 0, 0), V(8000, 0, 0), V(8000, 4000, 0), V(0, 4000, 0), V()]))
    parts = [
        Part.Face(
            Part.makePolygon(
                [V(x, 0, 0), V(x, -3000, 500), V(x + 4000, -3000, 500), V(x + 4000, 0, 0), V(x, 0, 0)]
            )
        )
        for x in (0, 4000)
    ]
    fused = long.multiFuse(parts)
    source = add(doc, fused)
    obj = make_net(doc, (source, [f"Face{k + 1}" for k in range(len(fused.Faces))]))
    recompute(doc)
    assert_refused(obj, "is only a part of a side of", "split that face at their common vertex")


def test_patterns_that_do_not_meet_are_named(doc):
    source = add(doc, box_without_bottom())
    obj = make_net(doc, source, Pattern="Triangle")
    recompute(doc)
    assert_refused(obj, "do not meet along Edge", "choose another Pattern")


def test_a_gridshell_on_several_faces_stands_and_follows(doc):
    source = add(doc, lofted_vault())
    shell = make_gridshell(doc, (source, ["Face1", "Face2"]), StepU="800 mm", StepV="800 mm")
    assert recompute(doc) == {}
    assert shell.Status == "converged" and shell.CompressionOnly
    count = shell.Net.NodeCount
    shell.Net.StepU = "1200 mm"
    assert recompute(doc) == {}
    assert shell.Net.NodeCount < count and len(shell.NodePositions) == shell.Net.NodeCount


@pytest.mark.parametrize("pattern", PATTERNS)
def test_every_pattern_on_two_neighbours_is_a_net_or_says_why_not(doc, pattern):
    source = add(doc, folded_strip())
    shell = make_gridshell(doc, (source, ["Face1", "Face2"]), Pattern=pattern)
    recompute(doc)
    if "Invalid" in shell.Net.State:
        assert "do not meet along Edge" in shell.Net.getStatusString()
        return
    net = net_of(shell.Net)
    assert "Invalid" not in shell.State or "no support" in shell.getStatusString()
    if "Invalid" not in shell.State:
        assert shell.Status == "converged"
    assert isinstance(net, fn.Net) and math.isfinite(net.size)
