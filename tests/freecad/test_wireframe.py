# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of every origin become nets: nodes where they meet, panels where their cycles allow it."""

import os
from math import cos, pi, sin

import FreeCAD as App
import numpy as np
import Part
import pytest

import funicular as fn
from funicular.wireframe import net_of_edges

V = App.Vector


def line(a, b):
    return Part.makeLine(V(*a), V(*b))


def arc(a, b, c):
    return Part.Arc(V(*a), V(*b), V(*c)).toShape()


def crossing_lines(along, across, step=1000.0, over=500.0):
    """Lines that cross without vertices, which stick out all round."""
    ends = -over, (across - 1) * step + over
    lines = [line((ends[0], i * step, 0), (ends[1], i * step, 0)) for i in range(along)]
    ends = -over, (along - 1) * step + over
    return lines + [line((j * step, ends[0], 0), (j * step, ends[1], 0)) for j in range(across)]


def dome_of_ribs(ribs=8, radius=8000.0, levels=(0.0, 0.4, 0.8, 1.2)):
    """Quarter circles that end at one pole, and full circles; none has a vertex where they cross."""
    half = 0.5**0.5
    turns = [2.0 * pi * k / ribs for k in range(ribs)]
    quarters = [
        arc(
            (radius * cos(a), radius * sin(a), 0),
            (radius * cos(a) * half, radius * sin(a) * half, radius * half),
            (0, 0, radius),
        )
        for a in turns
    ]
    return quarters + [Part.makeCircle(radius * cos(h), V(0, 0, radius * sin(h))) for h in levels]


def assert_sound(net):
    """No node twice, every panel's side a member, panels and rims as the core sees them."""
    core = fn.Net(net.nodes * 1e-3, net.members, net.panels)
    members = set(map(frozenset, net.members.tolist()))
    sides = [side for panel in net.panels for side in zip(panel, (*panel[1:], panel[0]))]
    assert len(set(sides)) == len(sides) and set(map(frozenset, sides)) <= members
    assert sorted(set(np.concatenate([*net.rims, []]).astype(int).tolist())) == core.border.tolist()
    assert set(net.members.ravel().tolist()) == set(range(len(net.nodes)))
    return core


def corners(net):
    return sorted(len(panel) for panel in net.panels)


@pytest.mark.parametrize("along, across", [(2, 2), (4, 7), (12, 9)])
def test_lines_that_cross_without_vertices_are_divided_there(along, across):
    net = net_of_edges(Part.Compound(crossing_lines(along, across)), "Source Grid")
    assert_sound(net)
    assert len(net.nodes) == along * across + 2 * (along + across)
    assert len(net.members) == along * (across + 1) + across * (along + 1)
    assert corners(net) == [4] * ((along - 1) * (across - 1))
    assert [len(rim) for rim in net.rims] == [2 * (along + across - 2)]
    assert net.remarks[0] == f"{along * across} nodes where edges cross without a vertex."
    first = net.nodes[net.edge_nodes["Edge1"]]
    np.testing.assert_allclose(first[:, 0], [-500, *range(0, across * 1000, 1000), across * 1000 - 500])
    assert (first[:, 1] == 0).all()


def test_panels_run_counter_clockwise_from_above_however_the_lines_lie():
    tilted = Part.Compound(crossing_lines(4, 4))
    tilted.Placement = App.Placement(V(1e5, 0, 0), App.Rotation(V(1, 2, 0), 50))
    net = net_of_edges(tilted, "Source")
    for panel in net.panels:
        a, b, c = net.nodes[list(panel[:3])]
        assert np.cross(b - a, c - b)[2] > 0.0


def test_an_end_in_the_middle_of_another_edge_is_a_node_there():
    frame = Part.makePolygon([V(0, 0, 0), V(4000, 0, 0), V(4000, 3000, 0), V(0, 3000, 0), V(0, 0, 0)])
    net = net_of_edges(
        [frame, line((1000, 0, 0), (1000, 3000, 0)), line((1000, 1000, 0), (4000, 1000, 0))], "S"
    )
    assert_sound(net)
    assert len(net.nodes) == 8 and len(net.members) == 10 and len(net.panels) == 3
    assert net.edge_nodes["0.Edge1"].tolist() == [0, 4, 1]
    # The wide panel has a node along its side and still four corners.
    assert corners(net) == [4, 4, 5]


def test_three_lines_through_one_point_have_one_node_there():
    rays = [line((-3000 * cos(a), -3000 * sin(a), 0), (3000 * cos(a), 3000 * sin(a), 0)) for a in (0, 1, 2)]
    net = net_of_edges(rays, "Source Star")
    assert len(net.nodes) == 7 and len(net.members) == 6
    np.testing.assert_allclose(net.nodes[6], 0.0, atol=1e-9)


def test_ends_that_nearly_meet_are_one_node_and_lines_that_pass_are_not():
    size = np.hypot(4000.0, 4000.0)
    near = [line((0, 0, 0), (4000, 0, 0)), line((4000 + 0.5e-6 * size, 0, 0), (4000, 4000, 0))]
    assert len(net_of_edges(near, "S").nodes) == 3
    passing = [line((0, 0, 0), (4000, 4000, 0)), line((4000, 0, 3e-6 * size), (0, 4000, 3e-6 * size))]
    assert len(net_of_edges(passing, "S").members) == 2
    passing[1] = line((4000, 0, 0.5e-6 * size), (0, 4000, 0.5e-6 * size))
    assert len(net_of_edges(passing, "S").members) == 4


def test_edges_on_top_of_each_other_count_once():
    net = net_of_edges(
        [line((0, 0, 0), (2000, 0, 0)), line((2000, 0, 0), (0, 0, 0)), line((1000, 0, 0), (3000, 0, 0))], "S"
    )
    assert net.members.tolist() == [[0, 2], [2, 1], [1, 3]]
    assert net.remarks[0] == "1 edge along others is counted once (1.Edge1)."
    assert [nodes.tolist() for nodes in net.edge_nodes.values()] == [[0, 2, 1], [1, 2, 0], [2, 1, 3]]


def test_edges_of_no_length_are_dropped_and_told():
    net = net_of_edges([line((0, 0, 0), (5000, 0, 0)), line((5000, 0, 0), (5000.001, 0, 0))], "S")
    assert net.members.tolist() == [[0, 1]] and "1 edge of no length is left out (1.Edge1)." in net.remarks
    sphere = net_of_edges(Part.makeSphere(1000.0), "S")
    assert "2 edges of no length are left out (Edge1, Edge3)." in sphere.remarks


def test_a_curve_is_one_chord_or_equal_parts_no_longer_than_asked():
    bow = arc((-5000, 0, 0), (0, 0, 5000), (5000, 0, 0))
    assert net_of_edges(bow, "S").members.tolist() == [[0, 1]]
    net = net_of_edges(bow, "S", chord=1000.0)
    # Half the circumference is 15,708 mm.
    assert len(net.members) == 16 and net.edge_nodes["Edge1"].tolist() == list(range(17))
    angles = pi * np.arange(17) / 16
    expected = np.column_stack([-5000 * np.cos(angles), 0 * angles, 5000 * np.sin(angles)])
    np.testing.assert_allclose(net.nodes, expected, atol=1e-6)
    assert len(net_of_edges(line((0, 0, 0), (5000, 0, 0)), "S", chord=1000.0).members) == 1


def test_a_circle_alone_is_a_triangle_and_says_so():
    net = net_of_edges(Part.makeCircle(1000.0), "S")
    assert corners(net) == [3] and "give a shorter chord" in net.remarks[0]
    assert net.edge_nodes["Edge1"].tolist() == [0, 1, 2, 0]
    hexagon = net_of_edges(Part.makeCircle(1000.0), "S", chord=1050.0)
    assert corners(hexagon) == [6] and hexagon.remarks == []


def test_curves_between_the_same_ends_stay_apart():
    halves = [Part.makeCircle(1000.0, V(), V(0, 0, 1), begin, begin + 180) for begin in (0, 180)]
    net = net_of_edges(halves, "S")
    np.testing.assert_allclose(np.linalg.norm(net.nodes, axis=1), 1000.0)
    assert len(net.nodes) == len(net.members) == 4 and corners(net) == [4]
    # The same curve twice is one.
    assert len(net_of_edges([halves[0], halves[0].copy()], "S").members) == 2


def test_a_line_through_a_circle_divides_it_where_they_cross():
    net = net_of_edges([Part.makeCircle(1000.0), line((-2000, 600, 0), (2000, 600, 0))], "S")
    assert_sound(net)
    on_line = net.nodes[net.edge_nodes["1.Edge1"]]
    np.testing.assert_allclose(on_line[:, 0], [-2000, -800, 800, 2000], atol=1e-6)
    assert len(net.panels) == 2


def test_a_line_that_touches_a_circle_meets_it_in_one_node():
    net = net_of_edges([Part.makeCircle(1000.0), line((-2000, 1000, 0), (2000, 1000, 0))], "S")
    touching = net.nodes[net.edge_nodes["1.Edge1"]]
    assert len(touching) == 3 and np.abs(touching[1] - [0, 1000, 0]).max() < 1.0


@pytest.mark.parametrize("ribs", [6, 8, 48])
def test_a_dome_of_ribs_is_divided_where_ribs_and_rings_cross(ribs):
    """Counts of a dome: a pole, a node on each ring for each rib."""
    net = net_of_edges(Part.Compound(dome_of_ribs(ribs)), "Source Dome")
    assert_sound(net)
    assert len(net.nodes) == 4 * ribs + 1 and len(net.members) == 8 * ribs
    assert corners(net) == [3] * ribs + [4] * 3 * ribs
    assert [len(rim) for rim in net.rims] == [ribs]
    np.testing.assert_allclose(np.linalg.norm(net.nodes, axis=1), 8000.0, rtol=1e-9)
    heights = net.nodes[net.edge_nodes["Edge2"], 2]
    np.testing.assert_allclose(heights, 8000 * np.sin([0.0, 0.4, 0.8, 1.2, pi / 2]), atol=1e-6)


def test_crossing_arches_share_their_crown():
    arches = [arc((-4000, 0, 0), (0, 0, 3000), (4000, 0, 0)), arc((0, -4000, 0), (0, 0, 3000), (0, 4000, 0))]
    net = net_of_edges(arches, "S", chord=700.0)
    crown = set(net.edge_nodes["0.Edge1"].tolist()) & set(net.edge_nodes["1.Edge1"].tolist())
    assert len(crown) == 1
    np.testing.assert_allclose(net.nodes[crown.pop()], [0, 0, 3000], atol=1e-6)


def hexagons(columns=5, rows=4, side=1000.0):
    """A frame of hexagons, each with its own six edges: those between two are there twice."""
    edges = []
    for i in range(columns):
        for j in range(rows):
            x, y = 1.5 * side * i, 3**0.5 * side * (j + 0.5 * (i % 2))
            around = [(x + side * cos(pi * k / 3), y + side * sin(pi * k / 3), 0.0) for k in range(6)]
            edges += [line(a, b) for a, b in zip(around, around[1:] + around[:1])]
    return edges


def test_a_hexagonal_frame_has_hexagons_for_panels():
    net = net_of_edges(Part.Compound(hexagons()), "Source Frame")
    core = assert_sound(net)
    assert corners(net) == [6] * 20
    assert len(core.members) == len(core.nodes) + 20 - 1
    assert "along others are counted once" in net.remarks[0]


def test_warped_quads_are_panels_and_warped_hexagons_are_not():
    def lifted(point):
        return (*point[:2], 1e-4 * point[0] * point[1])

    def lift(edges):
        ends = [[tuple(vertex.Point) for vertex in edge.Vertexes] for edge in edges]
        return [line(*map(lifted, pair)) for pair in ends]

    quads = [
        line((1000 * i, 1000 * j, 0), (1000 * (i + di), 1000 * (j + dj), 0))
        for i in range(4)
        for j in range(4)
        for di, dj in ((1, 0), (0, 1))
        if i + di < 4 and j + dj < 4
    ]
    assert corners(net_of_edges(lift(quads), "S")) == [4] * 9
    net = net_of_edges(lift(hexagons()), "S")
    assert net.panels == () and net.rims == ()
    assert "20 cycles of five corners or more that are not flat without a panel" in net.remarks[-1]


def test_a_star_has_no_panels_and_says_why():
    rays = [line((0, 0, 1000), (3000 * cos(a), 3000 * sin(a), 0)) for a in np.linspace(0, 6, 9)]
    net = net_of_edges(rays, "Source Star")
    assert net.panels == () and len(net.members) == 9
    assert net.remarks == ["9 members with a free end, or leading to one only, without a panel (first: 0)."]


def test_members_that_dangle_lie_on_no_panel():
    edges = [
        *crossing_lines(2, 2, over=0.0),
        line((500, 500, 0), (1000, 1000, 0)),
        line((0, 0, 0), (-9, -9, 0)),
    ]
    net = net_of_edges(edges, "S")
    assert_sound(net)
    assert corners(net) == [4] and len(net.members) == 6


def test_a_cycle_around_another_one_is_no_panel():
    inner = [line((a, b, 0), (c, d, 0)) for a, b, c, d in ((4, 4, 5, 4), (5, 4, 5, 5), (5, 5, 4, 4))]
    outer = [
        line((a, b, 0), (c, d, 0)) for a, b, c, d in ((0, 0, 9, 0), (9, 0, 9, 9), (9, 9, 0, 9), (0, 9, 0, 0))
    ]
    net = net_of_edges([*outer, *inner, line((0, 0, 0), (4, 4, 0))], "S")
    assert corners(net) == [3] and "around something inside" in net.remarks[0]
    apart = net_of_edges([*outer, *inner], "S")
    assert apart.panels == () and "in 2 parts that do not touch" in apart.remarks[0]


def test_a_wireframe_that_folds_over_itself_has_no_panels_and_says_so():
    net = net_of_edges(Part.makeBox(1000.0, 1000.0, 1000.0), "Source Box")
    assert len(net.nodes) == 8 and len(net.members) == 12 and net.panels == ()
    assert "so no panels are found" in net.remarks[0]


def test_a_tall_dome_is_seen_from_above_where_its_best_plane_is_upright():
    """A barrel 20 m long, 2 m wide and 6 m high: most of its extent is in an upright plane."""
    heights = 6000.0 * (1.0 - np.linspace(-1, 1, 9) ** 4)
    points = [[(2500.0 * i, x, z) for x, z in zip(np.linspace(-1000, 1000, 9), heights)] for i in range(9)]
    edges = [line(row[k], row[k + 1]) for row in points for k in range(8)]
    edges += [line(a, b) for one, other in zip(points, points[1:]) for a, b in zip(one, other)]
    net = net_of_edges(edges, "S")
    assert corners(net) == [4] * 64 and net.remarks == []


def test_a_sketch_becomes_a_net(doc):
    sketch = doc.addObject("Sketcher::SketchObject", "Sketch")
    for a, b in (
        ((0, 0), (6000, 0)),
        ((6000, 0), (6000, 4000)),
        ((6000, 4000), (0, 4000)),
        ((0, 4000), (0, 0)),
    ):
        sketch.addGeometry(Part.LineSegment(V(*a, 0), V(*b, 0)), False)
    sketch.addGeometry(Part.LineSegment(V(0, 2000, 0), V(6000, 2000, 0)), False)
    sketch.addGeometry(Part.LineSegment(V(3000, 0, 0), V(3000, 4000, 0)), False)
    sketch.addGeometry(Part.LineSegment(V(0, 0, 0), V(6000, 4000, 0)), True)  # for construction only
    sketch.Placement = App.Placement(V(0, 0, 3000), App.Rotation())
    doc.recompute()
    net = net_of_edges(sketch.Shape, "Source Sketch")
    assert_sound(net)
    assert len(net.nodes) == 9 and corners(net) == [4] * 4 and (net.nodes[:, 2] == 3000.0).all()
    np.testing.assert_array_equal(
        net.nodes[net.edge_nodes["Edge5"]][:, :2], [[0, 2000], [3000, 2000], [6000, 2000]]
    )


def test_draft_wires_become_a_net(doc, monkeypatch):
    # What FreeCAD's own programs put on the path: the folder of each workbench, and of what they need.
    for folder in ("Ext", os.path.join("Mod", "Draft")):
        monkeypatch.syspath_prepend(os.path.join(App.getResourceDir(), folder))
    import Draft

    wires = [
        Draft.make_wire([V(0, y, 0), V(3000, y, 1500), V(6000, y, 0)], face=False) for y in (0, 2000, 4000)
    ]
    wires += [
        Draft.make_wire([V(x, 0, z), V(x, 4000, z)], face=False) for x, z in ((0, 0), (3000, 1500), (6000, 0))
    ]
    doc.recompute()
    net = net_of_edges([wire.Shape for wire in wires], "Source Wires")
    assert_sound(net)
    assert len(net.nodes) == 9 and len(net.members) == 12 and corners(net) == [4] * 4
    assert len(net.edge_nodes["4.Edge1"]) == 3


@pytest.mark.parametrize(
    "shapes, chord, words",
    [
        ([], None, "Source Wire has no edges"),
        (Part.Shape(), None, "Source Wire has no shape"),
        ([None], None, "Source Wire has no shape"),
        (Part.Vertex(0, 0, 0), None, "Source Wire has no edges"),
        (Part.Line(V(0, 0, 0), V(1, 0, 0)).toShape(), None, "Source Wire: Edge1 is endless"),
        (Part.makeCircle(1000.0), 0.0, "chord is 0 mm: give a length greater than zero"),
        (Part.makeCircle(1000.0), float("nan"), "chord is nan mm"),
        (Part.makeCircle(1000.0), 1e-3, "chord is 0.001 mm, which makes more than 1000000 members"),
    ],
)
def test_what_gives_no_net_is_refused(shapes, chord, words):
    with pytest.raises(fn.InvalidInput) as caught:
        net_of_edges(shapes, "Source Wire", chord)
    assert words in str(caught.value)


def solved(net, fixed, **options):
    core = assert_sound(net)
    effects = [fn.AxialStiffness(1e6, **options), fn.MemberWeight(20.0)]
    effects += [fn.CoveringWeight(30.0)] if net.panels else []
    scene = fn.Scene(core, [fn.Fixed(fixed)], effects)
    result = fn.solve(scene)
    assert result.status == "converged"
    return result, fn.certify(scene, result)


def test_a_dome_of_ribs_stands_in_compression():
    net = net_of_edges(dome_of_ribs(12), "Source Dome")
    _, certificate = solved(net, net.rims[0])
    assert certificate.compression_only


def test_a_hexagonal_frame_stands_in_compression_on_its_border():
    net = net_of_edges(Part.Compound(hexagons()), "Source Frame")
    result, certificate = solved(net, net.rims[0])
    assert certificate.compression_only and result.nodes[:, 2].max() > 0.01


def test_an_arch_of_chords_is_the_catenary_of_its_length():
    """An arch of 20 stiff chords under its own weight: the chain of the same length, turned round."""
    net = net_of_edges(arc((-5000, 0, 0), (0, 0, 4000), (5000, 0, 0)), "S", chord=690.0)
    ends = [0, len(net.nodes) - 1]
    core = fn.Net(net.nodes * 1e-3, net.members)
    scene = fn.Scene(core, [fn.Fixed(ends)], [fn.AxialStiffness(1e9), fn.MemberWeight(20.0)])
    result = fn.solve(scene)
    assert result.status == "converged" and fn.certify(scene, result).compression_only
    length, span = core.source_lengths.sum(), 10.0
    low, high = 0.1, 100.0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if 2 * middle * np.sinh(span / 2 / middle) > length else (low, middle)
    rise = low * (np.cosh(span / 2 / low) - 1.0)
    assert result.nodes[:, 2].max() == pytest.approx(rise, rel=0.01)
