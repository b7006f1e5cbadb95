# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets on trimmed faces: on the face, along its edges, whole, and without slivers."""

import functools
import math

import FreeCAD as App
import numpy as np
import Part
import pytest

import funicular as fn
from faces import FACES, UP, V, rectangle
from funicular import surface, trimming
from funicular.trimming import trimmed_net
from trimmed import TRIMMED, drill, plate_with_two_holes

PATTERNS = ("quad", "diagrid", "triangle", "hexagon", "kagome")
PARTS = (25.0, 33.7, 41.0)

every_face = pytest.mark.parametrize("kind", TRIMMED)


def step_of(face, parts):
    return face.BoundBox.DiagonalLength / parts


@functools.lru_cache(maxsize=None)
def nets(kind, pattern):
    """(face, step, net) for several steps; of what has no room at one step, another must do."""
    face = TRIMMED[kind][0]()
    made = []
    for parts in PARTS:
        step = step_of(face, parts)
        try:
            made.append((face, step, trimmed_net(face, kind, step, step, pattern)))
        except fn.InvalidInput as error:
            assert f"{kind}: " in str(error) and "Edge" in str(error) and "give StepU, StepV" in str(error)
    assert len(made) >= 2
    return made


def sides(panels):
    return [(ring[k - 1], ring[k]) for ring in panels for k in range(len(ring))]


@every_face
@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_net_is_one_whole(kind, pattern):
    _, openings, handles = TRIMMED[kind]
    for _, _, net in nets(kind, pattern):
        directed = sides(net.panels)
        members = {tuple(sorted(member)) for member in net.members.tolist()}
        edges = {tuple(sorted(side)) for side in directed}
        there = set(directed)
        assert len(directed) == len(there), "panels are not all round the same way"
        assert len(members) == len(net.members) and members == edges
        assert len(net.nodes) - len(edges) + len(net.panels) == 1 - openings - 2 * handles
        alone = {side for side in directed if side[::-1] not in there}
        along = {(int(rim[k - 1]), int(rim[k])) for rim in net.rims for k in range(len(rim))}
        assert along == alone and len(net.rims) == 1 + openings
        numeric = fn.Net(net.nodes * 1e-3, net.members, net.panels)
        assert sorted(np.concatenate(net.rims)) == numeric.border.tolist()
        assert sorted(set(np.concatenate(list(net.edge_nodes.values())))) == numeric.border.tolist()


@every_face
def test_nodes_lie_on_the_face_and_on_its_edges(kind):
    for pattern in ("quad", "kagome"):
        face, _, net = nets(kind, pattern)[0]
        size = face.BoundBox.DiagonalLength
        for node in net.nodes[::3]:
            assert face.Surface.projectPoint(App.Vector(*node), "LowerDistance") < 1e-9 * size
        for name, nodes in net.edge_nodes.items():
            edge = face.Edges[int(name[4:]) - 1]
            along = [edge.Curve.parameter(App.Vector(*net.nodes[node])) for node in nodes]
            assert (np.diff(along) > 0).all() or edge.Curve.isPeriodic() or edge.Curve.isClosed()
            for node in nodes:
                assert Part.Vertex(App.Vector(*net.nodes[node])).distToShape(edge)[0] < 1e-3


@every_face
def test_the_area_is_that_of_the_face(kind):
    """Chords leave out of the area what the second order of step over radius says, no more."""
    for face, step, net in nets(kind, "quad"):
        area = 0.0
        for ring in net.panels:
            at = net.nodes[list(ring)] - net.nodes[ring[0]]
            area += 0.5 * np.linalg.norm(np.cross(at, np.roll(at, -1, axis=0)).sum(axis=0))
        assert area == pytest.approx(face.Area, rel=0.06)


@pytest.mark.parametrize("kind", ["plate with two holes", "L", "disc", "annulus", "triangle"])
@pytest.mark.parametrize("pattern", PATTERNS)
def test_there_are_no_slivers(kind, pattern):
    """On a plane, where the plane of the lattice is the face itself but for the rounding of cells."""
    whole = {"triangle": math.sqrt(3) / 4, "kagome": math.sqrt(3) / 4, "hexagon": 1.5 * math.sqrt(3)}
    for _, step, net in nets(kind, pattern):
        for ring in net.panels:
            at = net.nodes[list(ring), :2]
            after = np.roll(at, -1, axis=0) - at
            before = -np.roll(after, 1, axis=0)
            area = 0.5 * (at[:, 0] * np.roll(at[:, 1], -1) - at[:, 1] * np.roll(at[:, 0], -1)).sum()
            turn = after[:, 0] * before[:, 1] - after[:, 1] * before[:, 0]
            angles = np.arctan2(turn, (after * before).sum(axis=1)) % (2 * np.pi)
            # Half and quarter panels at the sides of a lattice are whole ones there.
            assert area > 0.25 * trimming.LEAST_AREA * whole.get(pattern, 1.0) * step**2
            assert angles.min() > 0.85 * trimming.LEAST_ANGLE
            assert angles.sum() == pytest.approx((len(ring) - 2) * np.pi)
            assert np.linalg.norm(after, axis=1).min() > 0.9 * trimming.LEAST_LENGTH * step


@pytest.mark.parametrize("turn", [0.0, 7.0, 31.0, 45.0, 68.0])
def test_corners_of_the_face_are_nodes(turn):
    corners = [(0, 0, 0), (6000, 0, 0), (6000, 2500, 0), (2700, 2500, 0), (2700, 5100, 0), (0, 5100, 0)]
    face = rectangle(*corners)
    face.rotate(V(), UP, turn)
    expected = np.array([tuple(vertex.Point) for vertex in face.Vertexes])
    for step in (230.0, 310.0):
        net = trimmed_net(face, "L", step, step)
        assert len(net.corners) == 6
        for node in net.nodes[net.corners]:
            assert np.linalg.norm(expected - node, axis=1).min() < 1e-6
        ends = {int(node) for nodes in net.edge_nodes.values() for node in (nodes[0], nodes[-1])}
        assert ends == set(net.corners.tolist())


@pytest.mark.parametrize("kind", ["plate with two holes", "dome with an oculus", "roof", "annulus"])
@pytest.mark.parametrize("pattern", PATTERNS)
def test_trimmed_nets_stand(kind, pattern):
    _, _, net = nets(kind, pattern)[0]
    numeric = fn.Net(net.nodes * 1e-3, net.members, net.panels)
    scene = fn.Scene(numeric, [fn.Fixed(net.rims[0])], [fn.AxialStiffness(1e5), fn.CoveringWeight(30.0)])
    result = fn.solve(scene)
    assert result.status == "converged", result.message
    assert fn.certify(scene, result).in_equilibrium


def test_an_opening_smaller_than_a_cell_is_refused_with_a_step_that_does():
    face = Part.makePlane(6000, 4000).cut(drill(150, V(2130, 1640, -5))).Faces[0]
    with pytest.raises(fn.InvalidInput, match="plate: the opening around Edge5 is smaller.*about") as refusal:
        trimmed_net(face, "plate", 1000.0, 1000.0)
    step = float(str(refusal.value).split()[-2])
    assert 20.0 < step <= 150.0
    assert len(trimmed_net(face, "plate", step, step).rims) == 2


def test_a_spike_is_refused():
    face = rectangle((0, 0, 0), (6000, 0, 0), (6000, 300, 0))
    with pytest.raises(fn.InvalidInput, match="spike: .*Edge.*give StepU, StepV of at most"):
        trimmed_net(face, "spike", 280.0, 280.0)


def test_a_face_without_outline_is_refused():
    with pytest.raises(fn.InvalidInput, match="ball has no outline"):
        trimmed_net(Part.makeSphere(1000).Faces[0], "ball", 200.0, 200.0)


def test_an_untrimmed_face_gets_the_lattice_itself():
    face = FACES["half a cylinder"][0]().Faces[0]
    net = trimmed_net(face, "x", 250.0, 250.0)
    chart = surface.read_face(face)
    lattice = fn.lattice(*surface.count_cells(chart, 250.0, 250.0))
    assert len(net.panels) == len(lattice.panels) and len(net.members) == len(lattice.members)
    expected = surface.sample(chart, lattice.uv)
    gaps = np.linalg.norm(net.nodes[:, None] - expected[None], axis=2)
    assert gaps.min(axis=1).max() < 1e-3


def test_results_turn_with_the_face():
    """Numbers of edges and the last digits of vertices have no say in where nodes lie."""
    face = plate_with_two_holes()
    reference = trimmed_net(face, "x", 250.0, 250.0, "triangle")
    place = App.Placement(V(1e4, -3e3, 2e3), App.Rotation(V(1, 2, 3), 50))
    moved = face.copy()
    moved.Placement = place
    net = trimmed_net(moved, "x", 250.0, 250.0, "triangle")
    back = np.array([tuple(place.inverse().multVec(V(*node))) for node in net.nodes])
    assert len(back) == len(reference.nodes)
    np.testing.assert_allclose(back, reference.nodes, atol=1e-5)
