# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes as they are: numbering kept, what is safe repaired and told, the rest refused with its numbers."""

import itertools
import re

import numpy as np
import pytest
from hypothesis import given, strategies as st

import funicular as fn
from funicular import topology
from funicular.mesh_source import net_of_mesh, read_mesh_file

# A sheet of 3 × 2 quads, 1 m each: vertex 3 j + i is at (i, j) m.
SHEET = np.array([[1000.0 * i, 1000.0 * j, 0.0] for j in range(4) for i in range(3)])
QUADS = [(3 * j + i, 3 * j + i + 1, 3 * j + i + 4, 3 * j + i + 3) for j in range(3) for i in range(2)]
CUBE = np.array(list(itertools.product((0.0, 1000.0), repeat=3)))
SIDES_OF_CUBE = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def edges_of(facets):
    return {frozenset(edge) for facet in facets for edge in zip(facet, (*facet[1:], facet[0]))}


def sides_of(panels):
    return [side for panel in panels for side in zip(panel, (*panel[1:], panel[0]))]


def net_in_metres(mesh):
    return fn.Net(mesh.nodes * 1e-3, mesh.members, mesh.panels)


def assert_runs_one_way(panels):
    """Every side once at most in each direction: then panels that share an edge run the same way round."""
    sides = sides_of(panels)
    assert len(set(sides)) == len(sides)


def refusal(points, facets, **arguments):
    with pytest.raises(fn.InvalidInput) as caught:
        net_of_mesh(points, facets, "Mesh Roof", **arguments)
    assert "Mesh Roof" in str(caught.value)
    return str(caught.value)


def test_node_is_vertex_panel_is_facet_and_member_is_edge():
    facets = [*QUADS[:4], (6, 7, 10), (6, 10, 9), (7, 8, 11, 10)]
    mesh = net_of_mesh(SHEET, facets, "Mesh Roof")
    np.testing.assert_array_equal(mesh.nodes, SHEET)
    np.testing.assert_array_equal(mesh.numbers, range(12))
    assert mesh.panels == tuple(facets) and mesh.remarks == []
    assert len(mesh.members) == 18 and set(map(frozenset, mesh.members.tolist())) == edges_of(facets)
    assert mesh.members[:4].tolist() == [[0, 1], [1, 4], [4, 3], [3, 0]]
    np.testing.assert_array_equal(net_in_metres(mesh).border, sorted(set(range(12)) - {4, 7}))


def test_facets_of_many_corners_stay_whole():
    angles = np.linspace(0.0, 2.0 * np.pi, 7)[:-1]
    mesh = net_of_mesh(np.column_stack([np.cos(angles), np.sin(angles), 0 * angles]), [range(6)], "Mesh")
    assert mesh.panels == ((0, 1, 2, 3, 4, 5),) and len(mesh.members) == 6


def test_an_array_of_facets_is_a_list_of_facets():
    as_array = net_of_mesh(SHEET, np.array(QUADS), "Mesh")
    assert as_array.panels == net_of_mesh(SHEET, QUADS, "Mesh").panels == tuple(QUADS)


def test_rims_are_closed_loops_the_longest_first_that_run_as_their_panels():
    """A ring of 8 quads between squares of 3 m and 1 m."""
    points = [[1000.0 * i, 1000.0 * j, 0.0] for j in range(4) for i in range(4)]
    facets = [(4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4) for j in range(3) for i in range(3)]
    del facets[4]
    mesh = net_of_mesh(points, facets, "Mesh")
    assert [rim.tolist() for rim in mesh.rims] == [[0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4], [5, 9, 10, 6]]
    for rim in mesh.rims:
        assert rim.dtype.kind == "i"
        assert set(zip(rim.tolist(), np.roll(rim, -1).tolist())) <= set(sides_of(mesh.panels))


def test_a_closed_mesh_has_no_rims():
    mesh = net_of_mesh(CUBE, SIDES_OF_CUBE, "Mesh")
    assert mesh.rims == () and len(mesh.members) == 12
    assert_runs_one_way(mesh.panels)


def test_a_triangle_soup_welds_to_the_mesh_that_it_came_from():
    """Corners shaken by less than half the tolerance; each node is the first vertex at its place."""
    triangles = [t for a, b, c, d in QUADS for t in ((a, b, c), (a, c, d))]
    size = np.linalg.norm(np.ptp(SHEET, axis=0))
    shake = np.random.default_rng(1).uniform(-0.4e-6 * size, 0.4e-6 * size, (len(triangles) * 3, 3))
    soup = SHEET[np.array(triangles).ravel()] + shake
    mesh = net_of_mesh(soup, np.arange(len(soup)).reshape(-1, 3), "Mesh")
    firsts = [np.array(triangles).ravel().tolist().index(vertex) for vertex in range(12)]
    np.testing.assert_array_equal(mesh.numbers, sorted(firsts))
    np.testing.assert_array_equal(mesh.nodes, soup[mesh.numbers])
    assert len(mesh.panels) == 12 and len(mesh.members) == 23
    assert mesh.remarks[0].startswith(
        "24 vertices within 0.00361 mm of another are one node with it (first: 3,"
    )


def test_the_tolerance_can_be_given():
    points = np.vstack([SHEET, SHEET[4] + [0.5, 0.0, 0.0]])
    facets = [*QUADS[:3], (12, 5, 8, 7), *QUADS[4:]]
    mesh = net_of_mesh(points, facets, "Mesh", weld=1.0)
    assert mesh.panels == tuple(QUADS) and len(mesh.nodes) == 12
    assert "(first: 12, with 4)" in mesh.remarks[0]
    # Left apart, the sheet has a slit that opens at its border.
    assert "vertex 5 joins 2 fans" in refusal(points, facets)
    assert "weld" in refusal_of_weld(-1.0) and "weld" in refusal_of_weld(np.nan)


def refusal_of_weld(weld):
    with pytest.raises(fn.InvalidInput) as caught:
        net_of_mesh(SHEET, QUADS, "Mesh", weld=weld)
    return str(caught.value)


@given(st.integers(2, 60), st.floats(0.0, 0.6), st.integers(0, 99))
def test_welding_is_what_comparing_each_with_each_gives(count, tolerance, seed):
    points = np.random.default_rng(seed).random((count, 3)).round(1)
    kept, number = topology.weld(points, tolerance)
    expected = []
    for i, point in enumerate(points):
        near = [k for k in expected if (np.abs(points[k] - point) <= tolerance).all()]
        if not near:
            expected.append(i)
        assert i in kept if not near else kept[number[i]] in near
    np.testing.assert_array_equal(kept, expected)


def test_many_points_level_with_each_other_weld_all_the_same():
    """500 pairs, each within the tolerance, on a line square to the direction of sorting."""
    across = np.cross(topology.GENERIC, [0.0, 0.0, 1.0])
    places = np.outer(np.arange(500.0), across)
    kept, number = topology.weld(np.vstack([places, places + 1e-3]), 2e-3)
    np.testing.assert_array_equal(kept, np.arange(500))
    np.testing.assert_array_equal(number, np.tile(np.arange(500), 2))


def test_unused_vertices_are_left_out_and_told():
    points = np.vstack([[np.nan] * 3, SHEET, [[1e9, 0, 0]]])
    mesh = net_of_mesh(points, [[corner + 1 for corner in quad] for quad in QUADS], "Mesh")
    np.testing.assert_array_equal(mesh.numbers, np.arange(1, 13))
    assert mesh.panels == tuple(QUADS)
    assert mesh.remarks == ["2 vertices on no facet are left out (first: 0)."]


def test_facets_given_twice_count_once_whichever_way_they_run():
    mesh = net_of_mesh(SHEET, [*QUADS, (4, 3, 0, 1), (3, 4, 1, 0)], "Mesh")
    assert mesh.panels == tuple(QUADS)
    assert mesh.remarks == ["2 facets given twice are left out (first: 6, the same as 0)."]


def test_facets_that_weld_to_less_are_left_out_and_those_that_lose_a_corner_stay():
    points = np.vstack([SHEET, SHEET[4], [[5000, 5000, 0]]])
    facets = [QUADS[0], (4, 12, 5), (1, 2, 5, 12, 4), *QUADS[2:], (13, 13, 13)]
    mesh = net_of_mesh(points, facets, "Mesh")
    assert mesh.panels == tuple(QUADS)
    np.testing.assert_array_equal(mesh.numbers, range(12))
    assert mesh.remarks == [
        "1 vertex within 0.00707 mm of another is one node with it (first: 12, with 4).",
        "2 facets with fewer than three corners are left out (first: 1).",
        "1 facet has fewer corners than given, as some are one node (first: 2).",
        "1 vertex on no facet is left out (first: 13).",
    ]


def test_the_fewer_facets_are_turned_round_to_run_as_the_others():
    facets = list(QUADS)
    facets[0], facets[3] = facets[0][::-1], facets[3][::-1]
    mesh = net_of_mesh(SHEET, facets, "Mesh")
    assert_runs_one_way(mesh.panels)
    for panel, quad in zip(mesh.panels, QUADS):
        assert edges_of([panel]) == edges_of([quad]) and set(sides_of([panel])) == set(sides_of([quad]))
    assert mesh.remarks == ["2 facets that ran against their neighbours are turned round (first: 0)."]


def test_facets_without_area_are_kept_and_told():
    points = np.vstack([SHEET[:6], [[1000, -0.0, 0]]])
    mesh = net_of_mesh(points[:6], [(0, 4, 3), (0, 1, 4), (1, 5, 4), (1, 2, 5), (0, 2, 1)], "Mesh")
    assert len(mesh.panels) == 5
    assert mesh.remarks == ["1 facet has no area and is kept (first: 4)."]


def test_an_edge_on_three_facets_is_refused_with_its_numbers():
    points = np.vstack([SHEET, [[1000, 500, 1000]]])
    sentence = refusal(points, [*QUADS, (1, 4, 12)])
    assert "edge 1-4 lies on 3 facets (0, 1, 6): a net is one sheet, so delete facets" in sentence


def test_facets_that_meet_only_at_a_vertex_are_refused():
    sentence = refusal(SHEET, [QUADS[0], QUADS[3]])
    assert "vertex 4 joins 2 fans of facets only at a point (facets 0, 1, one of each)" in sentence
    assert "give each fan a vertex of its own" in sentence


def test_two_cubes_that_touch_at_a_corner_are_refused_though_closed():
    facets = [*SIDES_OF_CUBE, *([corner + 8 for corner in side] for side in SIDES_OF_CUBE)]
    assert "vertex 7 joins 2 fans" in refusal(np.vstack([CUBE, CUBE + 1000.0]), facets)


def test_several_components_are_refused_the_largest_first():
    far = np.vstack([SHEET, SHEET[[0, 1, 4]] + 9e3, SHEET[:5] + 5e4])
    sentence = refusal(far, [(12, 13, 14), *QUADS, (15, 16, 19, 18)])
    assert "has 3 components, of 12, 4 and 3 vertices" in sentence and "split it" in sentence


def test_a_moebius_band_is_refused_and_the_same_band_without_the_turn_is_not():
    angles = np.repeat(np.linspace(0, 2 * np.pi, 10)[:-1], 2)
    width = np.tile([-300.0, 300.0], 9)
    radius = 1000.0 + width * np.cos(angles / 2)
    points = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), width * np.sin(angles / 2)])
    band = [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(8)]
    assert "one side only" in refusal(points, [*band, (16, 17, 0, 1)])
    mesh = net_of_mesh(points, [*band, (16, 17, 1, 0)], "Mesh")
    assert len(mesh.rims) == 2 and len(mesh.members) == 27
    sentence = refusal(points, [*band, (16, 17, 0, 1)])
    a, b = map(int, re.search(r"edge (\d+)-(\d+)", sentence).groups())
    assert frozenset((a, b)) in edges_of(band)


@pytest.mark.parametrize(
    "points, facets, words",
    [
        (SHEET, [], "has no facets"),
        (np.zeros((0, 3)), [], "has no facets"),
        (SHEET, [QUADS[0], (1, 2, 12)], "facet 1 names vertex 12, but the mesh has 12 (counted from 0)"),
        (SHEET, [QUADS[0], (1, -1, 5)], "facet 1 names vertex -1"),
        (SHEET, [QUADS[0], (1, 2, 2**70)], f"facet 1 names vertex {2**70}"),
        (SHEET, [QUADS[0], (1, 2.5, 4)], "facet 1 has the corner 2.5"),
        (SHEET, [QUADS[0], (1, 2, np.nan)], "facet 1 has the corner nan"),
        (SHEET, [QUADS[0], "125"], "facet 1 is '125'"),
        (SHEET, [QUADS[0], 7], "facet 1 is 7"),
        (SHEET, [(0, 1, 4, 0, 3)], "facet 0 passes vertex 0 twice"),
        (SHEET[:, :2], QUADS, "points have the shape (12, 2)"),
        (np.where(SHEET == [1000, 0, 0], [np.inf, 1, 1], SHEET), QUADS, "vertex 1 of facet 0 is not finite"),
        (SHEET * 5e304, QUADS, "spans more than a floating-point number holds"),
        (0 * SHEET, QUADS, "has no facet left"),
    ],
)
def test_what_is_no_mesh_is_refused_with_what_is_wrong(points, facets, words):
    assert words in refusal(points, facets)


def test_lines_are_members_first_and_may_lie_on_no_facet():
    points = np.vstack([SHEET, [[1000, 1000, 2000]]])
    mesh = net_of_mesh(points, QUADS, "Mesh", lines=[(4, 12), (1, 0), (12, 4), (3, 3)])
    assert mesh.members[:3].tolist() == [[4, 12], [1, 0], [1, 4]] and len(mesh.members) == 18
    assert mesh.remarks == [
        "1 line of no length is left out (first: 3).",
        "1 line given twice is left out (first: 2).",
    ]
    assert "line 0 names vertex 13" in refusal(points, QUADS, lines=[(4, 13)])
    assert "lines are not pairs" in refusal(points, QUADS, lines=[(4, 1, 2)])


def test_lines_alone_are_a_net_without_panels():
    mesh = net_of_mesh(SHEET, [], "Mesh", lines=[(0, 1), (1, 2), (1, 4)])
    assert mesh.panels == () and mesh.rims == () and mesh.numbers.tolist() == [0, 1, 2, 4]


@pytest.mark.parametrize("suffix", ["obj", "ply", "off", "stl"])
def test_a_file_becomes_the_net_that_it_holds(tmp_path, suffix):
    path = tmp_path / f"roof.{suffix}"
    written = net_in_metres(net_of_mesh(SHEET + [0, 0, 123.456], QUADS, "Mesh"))
    written.write(path)
    points, facets, lines = read_mesh_file(path)
    mesh = net_of_mesh(points, facets, str(path), lines=lines)
    read = fn.Net.read(path)
    np.testing.assert_allclose(mesh.nodes, read.nodes * 1e3, rtol=1e-15)
    np.testing.assert_array_equal(mesh.members, read.members)
    assert mesh.panels == read.panels and mesh.remarks == []
    if suffix != "stl":
        assert mesh.panels == tuple(QUADS) and len(mesh.members) == 17


def test_lines_of_a_file_stay_members(tmp_path):
    path = tmp_path / "mast.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nf 1 2 3\nl 1 4\n")
    points, facets, lines = read_mesh_file(path)
    np.testing.assert_array_equal(points[3], [0, 0, 2000])
    assert facets == [(0, 1, 2)] and lines.tolist() == [[0, 3]]
    assert net_of_mesh(points, facets, "Mesh", lines=lines).members.tolist() == [
        [0, 3],
        [0, 1],
        [1, 2],
        [2, 0],
    ]


def test_a_file_that_is_wrong_is_refused_with_its_line(tmp_path):
    path = tmp_path / "roof.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 x\nf 1 2 3\n")
    with pytest.raises(fn.InvalidInput, match=r"roof\.obj:3: "):
        read_mesh_file(path)
    with pytest.raises(fn.InvalidInput, match="suffix"):
        read_mesh_file(tmp_path / "roof.dwg")
    with pytest.raises(FileNotFoundError):
        read_mesh_file(tmp_path / "none.obj")


@st.composite
def meshes(draw):
    """Facets at random, or grown edge by edge so that many are sound; points that may coincide."""
    count = draw(st.integers(1, 12))
    corner = st.integers(-1 if draw(st.integers(0, 9)) == 9 else 0, count - 1)
    facets = draw(st.lists(st.lists(corner, min_size=0, max_size=5), max_size=8))
    if draw(st.booleans()):
        facets = [[0, 1, 2]]
        for _ in range(draw(st.integers(0, 8))):
            facet = draw(st.sampled_from(facets))
            side = draw(st.integers(0, len(facet) - 1))
            new = draw(st.one_of(st.integers(0, 11), st.integers(3, 11)))
            facets.append([facet[side], facet[side - 1], new][:: draw(st.sampled_from([1, -1]))])
        count = 12
    coordinate = st.one_of(st.integers(0, 3).map(float), st.floats(-1e9, 1e9))
    points = [[draw(coordinate) for _ in range(3)] for _ in range(count)]
    if draw(st.integers(0, 9)) == 9:
        points[draw(st.integers(0, count - 1))][1] = np.nan
    if draw(st.booleans()):
        points = np.random.default_rng(draw(st.integers(0, 9))).random((count, 3)) * 1e3
    weld = draw(st.sampled_from([None, None, 0.0, 1e-300, 1.0, 1e4]))
    return points, facets, weld, draw(st.lists(st.tuples(corner, corner), max_size=3))


@given(meshes())
def test_any_mesh_is_a_sound_net_or_refused(case):
    points, facets, weld, lines = case
    try:
        mesh = net_of_mesh(points, facets, "Mesh", weld=weld, lines=lines)
    except fn.InvalidInput as error:
        assert str(error).startswith(("Mesh", "weld"))
        return
    net = net_in_metres(mesh)
    np.testing.assert_array_equal(mesh.nodes, np.asarray(points, dtype=float)[mesh.numbers])
    assert (np.diff(mesh.numbers) > 0).all()
    assert_runs_one_way(mesh.panels)
    on_one = [side for side in sides_of(mesh.panels) if side[::-1] not in sides_of(mesh.panels)]
    walked = [side for rim in mesh.rims for side in zip(rim.tolist(), np.roll(rim, -1).tolist())]
    assert sorted(walked) == sorted(on_one)
    assert sorted(set(sum(on_one, ()))) == net.border.tolist()
    assert edges_of(mesh.panels) <= set(map(frozenset, mesh.members.tolist()))
    if not mesh.remarks:
        np.testing.assert_array_equal(mesh.numbers, range(len(points)))
        assert mesh.panels == tuple(map(tuple, facets))
