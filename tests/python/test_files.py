# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files: what is written comes back, other programs' habits are understood, errors name the line."""

import struct

import meshio
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from funicular.files import read_mesh, stl, write_mesh

FORMATS = ["obj", "ply", "stl", "off"]


def edges_of(panels):
    return {frozenset(edge) for panel in panels for edge in zip(panel, panel[1:] + panel[:1])}


def assert_same_net(read, written):
    nodes, members, panels = read
    assert nodes.dtype == np.float64 and nodes.shape[1:] == (3,)
    assert members.dtype == np.int64 and members.shape[1:] == (2,)
    np.testing.assert_array_equal(nodes, written[0])
    np.testing.assert_array_equal(members, written[1])
    assert panels == [tuple(panel) for panel in written[2]]


@pytest.fixture
def mixed_net():
    """A triangle, a quad and a pentagon, a member on no panel, members in an order no reader would derive."""
    angles = np.linspace(0.1, 5.9, 8)
    nodes = np.column_stack([np.cos(angles) / 3, np.sin(angles) / 7, angles * 1e5])
    panels = [(0, 1, 2), (0, 2, 3, 4), (4, 3, 5, 6, 7)]
    members = [(7, 4), (1, 5), (2, 1), (0, 1), (3, 2), (0, 2), (3, 4), (0, 4), (3, 5), (6, 5), (6, 7)]
    return nodes, np.array(members), panels


@pytest.mark.parametrize("suffix", ["obj", "ply", "OBJ"])
def test_obj_and_ply_give_back_the_same_net_number_by_number(tmp_path, mixed_net, suffix):
    path = tmp_path / f"net.{suffix}"
    write_mesh(path, *mixed_net)
    assert_same_net(read_mesh(path), mixed_net)


@pytest.mark.parametrize("suffix", ["obj", "ply"])
def test_a_net_without_panels_comes_back(tmp_path, suffix):
    path = tmp_path / f"arch.{suffix}"
    arch = np.array([[0, 0, 0], [1, 0, 0.5], [2, 0, 0.1]]), [(0, 1), (2, 1)], []
    write_mesh(path, *arch)
    assert_same_net(read_mesh(path), arch)


def test_off_gives_back_nodes_and_panels_and_the_same_set_of_members(tmp_path, mixed_net):
    nodes, members, panels = mixed_net
    on_panels = [pair for pair in members.tolist() if frozenset(pair) in edges_of(panels)]
    path = tmp_path / "net.off"
    write_mesh(path, nodes, on_panels, panels)
    read_nodes, read_members, read_panels = read_mesh(path)
    np.testing.assert_array_equal(read_nodes, nodes)
    assert read_panels == panels
    assert len(read_members) == len(on_panels)
    assert {frozenset(pair) for pair in read_members.tolist()} == set(map(frozenset, on_panels))


def test_stl_fans_panels_into_triangles_and_welds_them_again(tmp_path):
    nodes = np.array([[0, 0, 0], [1 / 3, 0, 0], [1 / 3, 2, 0.1], [0, 2, 0.1], [0.5, 1, 0]])
    panels = [(0, 1, 2, 3), (1, 4, 2)]
    path = tmp_path / "net.stl"
    write_mesh(path, nodes, [(0, 1), (1, 2), (2, 3), (3, 0), (1, 4), (4, 2)], panels)
    read_nodes, members, triangles = read_mesh(path)
    np.testing.assert_array_equal(read_nodes, nodes)
    assert triangles == [(0, 1, 2), (0, 2, 3), (1, 4, 2)]
    assert {frozenset(pair) for pair in members.tolist()} == edges_of(triangles)


@pytest.mark.parametrize("suffix", ["off", "stl"])
def test_formats_without_lines_refuse_to_lose_a_member(tmp_path, mixed_net, suffix):
    path = tmp_path / f"net.{suffix}"
    path.write_text("an earlier file")
    with pytest.raises(ValueError, match=r"member 1 \(1 such in all\).*write \.obj or \.ply"):
        write_mesh(path, *mixed_net)
    assert path.read_text() == "an earlier file"


@pytest.mark.parametrize("suffix", FORMATS)
def test_an_independent_reader_finds_the_same_triangles(tmp_path, suffix):
    nodes = np.array([[0, 0, 0], [1, 0, 1 / 3], [1, 1, 0], [0, 1, 0.1]])
    panels = [(0, 1, 2), (0, 2, 3)]
    path = tmp_path / f"net.{suffix}"
    write_mesh(path, nodes, [(0, 1), (1, 2), (0, 2), (2, 3), (0, 3)], panels)
    # meshio refuses the edge element of PLY; its own file then stands for ours.
    if suffix == "ply":
        content = path.read_bytes()
        start, end = content.index(b"element edge"), content.index(b"end_header")
        path.write_bytes((content[:start] + content[end:])[: -5 * 8])
    mesh = meshio.read(path)
    triangles = mesh.points[mesh.get_cells_type("triangle")]
    np.testing.assert_allclose(triangles, nodes[np.array(panels)], rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    "suffix, options",
    [
        ("ply", {"binary": True}),
        ("ply", {"binary": False}),
        ("stl", {"binary": True}),
        ("stl", {"binary": False}),
        ("obj", {}),
        ("off", {}),
    ],
)
def test_an_independent_writer_is_understood(tmp_path, suffix, options):
    points = np.array([[0, 0, 0], [1, 0, 0.25], [1, 1, 0], [0, 1, 0.125]])
    triangles = [(0, 1, 2), (0, 2, 3)]
    path = tmp_path / f"other.{suffix}"
    meshio.Mesh(points, [("triangle", triangles)]).write(path, **options)
    nodes, members, panels = read_mesh(path)
    np.testing.assert_array_equal(nodes, points)
    assert panels == triangles
    assert members.tolist() == [[0, 1], [1, 2], [2, 0], [2, 3], [3, 0]]


def test_obj_habits(tmp_path):
    """Texture and normal indices, negative ones, continuations, colours, polylines, a byte-order mark."""
    path = tmp_path / "habits.obj"
    path.write_bytes(
        "\ufeff# made elsewhere\r\nmtllib x.mtl\r\nv 0 0 0 0.5 0.5 0.5\r\nv 1 0 0\r\nv 1 1 0\r\nvn 0 0 1\r\n"
        "vt 0 0\r\n"
        "g roof\r\nf 1/1/1 2//1 \\\r\n  3/1\r\nv 2 0 0 # a comment\r\nf -1 -2 -3\r\nl 1 2 4 1\r\n".encode()
    )
    nodes, members, panels = read_mesh(path)
    assert nodes.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0]]
    assert panels == [(0, 1, 2), (3, 2, 1)]
    assert members.tolist() == [[0, 1], [1, 3], [3, 0], [1, 2], [2, 0], [3, 2]]


@pytest.mark.parametrize("order, name", [("<", "little"), (">", "big")])
def test_ply_with_more_in_it_than_is_asked_for(tmp_path, order, name):
    path = tmp_path / "scan.ply"
    header = (
        f"ply\nformat binary_{name}_endian 1.0\ncomment no end_header\n"
        "element camera 1\nproperty list uchar short view\n"
        "element vertex 3\nproperty uchar red\nproperty float z\nproperty float y\nproperty float x\n"
        "element face 1\nproperty list uchar float uv\nproperty list uint8 uint32 vertex_index\n"
        "property uchar flag\nend_header\n"
    )
    body = struct.pack(order + "B2h", 2, 5, 6)
    body += b"".join(
        struct.pack(order + "B3f", 255, z, y, x) for x, y, z in [(0, 0, 9), (1, 0, 9), (0, 2, 9)]
    )
    body += struct.pack(order + "B2fB3IB", 2, 0.5, 0.5, 3, 2, 1, 0, 7)
    path.write_bytes(header.encode() + body)
    nodes, members, panels = read_mesh(path)
    assert nodes.tolist() == [[0, 0, 9], [1, 0, 9], [0, 2, 9]]
    assert panels == [(2, 1, 0)]


def test_ply_with_a_panel_of_many_corners(tmp_path):
    angles = np.linspace(0, 6, 300)
    ring = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    panel = tuple(range(300))
    path = tmp_path / "ring.ply"
    write_mesh(path, ring, [], [panel])
    assert read_mesh(path)[2] == [panel]


@pytest.mark.parametrize(
    "start", ["OFF\n3 1 3\n", "COFF 3 1 0\n", "# a comment\n\nOFF # another\n3 1 0\n", "3 1 0\n"]
)
def test_off_headers(tmp_path, start):
    path = tmp_path / "net.off"
    path.write_text(start + "0 0 0 9 9\n1 0 0\n\n0 1 0\n3 0 1 2 255 0 0\n")
    nodes, _, panels = read_mesh(path)
    assert nodes.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert panels == [(0, 1, 2)]


def stl_text(*triangles):
    facets = "".join(
        "facet normal 0 0 0\n outer loop\n"
        + "".join(f"  vertex {x!r} {y!r} {z!r}\n" for x, y, z in triangle)
        + " endloop\nendfacet\n"
        for triangle in triangles
    )
    return f"solid\n{facets}endsolid\n"


@pytest.mark.parametrize("origin", [(0.0, 0.0, 0.0), (0.3, -7.7, 1e3)])
@pytest.mark.parametrize("gap, nodes", [(0.9, 4), (1.1, 5)])
def test_stl_corners_weld_within_the_stated_tolerance(tmp_path, gap, nodes, origin):
    offset = np.array(origin)
    tolerance = stl.WELD * np.sqrt(2)
    for direction in (1, -1):
        shifted = (1.0 + direction * gap * tolerance, 0.0, 0.0)
        triangles = [
            [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)],
            [shifted, (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)],
        ]
        path = tmp_path / "seam.stl"
        path.write_text(stl_text(*[[tuple((offset + corner).tolist()) for corner in t] for t in triangles]))
        assert len(read_mesh(path)[0]) == nodes


def test_stl_triangles_that_welding_closes_are_dropped(tmp_path):
    path = tmp_path / "needle.stl"
    path.write_text(stl_text([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 0, 1e-9), (0, 1, 0)]))
    assert read_mesh(path)[2] == [(0, 1, 2)]


def test_a_binary_stl_may_begin_with_the_word_solid(tmp_path):
    path = tmp_path / "solid.stl"
    triangle = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    path.write_bytes(b"solid".ljust(80) + struct.pack("<I", 1) + triangle)
    assert read_mesh(path)[2] == [(0, 1, 2)]


PLY_HEADER = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
PLY_FACE = "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
PLY_STRIPS = "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
PLY_TRIANGLE = "0 0 0\n1 0 0\n0 1 0\n"
PLY_BINARY = (PLY_HEADER + PLY_FACE).replace("ascii", "binary_little_endian")
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

WRONG = {
    "index beyond": ("a.obj", TRIANGLE + "f 1 2 3\nf 1 2 4\n", r"a\.obj:5: face 1 names vertex 3 .*has 3"),
    "index zero": ("a.obj", TRIANGLE + "f 0 1 2\n", r"a\.obj:4: vertex index 0 "),
    "index before": ("a.obj", TRIANGLE + "f -4 1 2\n", r"a\.obj:4: vertex index -4 "),
    "index no number": ("a.obj", TRIANGLE + "f 1 2 x\n", r"a\.obj:4: a vertex index .*'x'"),
    "line index": ("a.obj", TRIANGLE + "l 1 9\n", r"a\.obj:4: line 0 names vertex 8"),
    "short line": ("a.obj", TRIANGLE + "l 1\n", r"a\.obj:4: a line has at least 2"),
    "vertex twice": ("a.obj", TRIANGLE + "f 1 2 2\n", r"a\.obj:4: face 0 names vertex 1 .*twice"),
    "two corners": ("a.obj", TRIANGLE + "f 1 2\n", r"a\.obj:4: face 0 has 2 corners"),
    "nan": ("a.obj", "v 0 0 0\nv 0 nan 0\nv 1 0 0\nf 1 2 3\n", r"a\.obj:2: vertex 1 .*not finite.*nan"),
    "inf": ("a.obj", "v 0 0 0\nv 0 1e999 0\nv 1 0 0\nf 1 2 3\n", r"a\.obj:2: vertex 1 .*not finite.*inf"),
    "two coordinates": ("a.obj", "v 0 0\n", r"a\.obj:1: vertex 0 has 2 coordinates"),
    "a word": ("a.obj", "v 0 0 zero\n", r"a\.obj:1: a coordinate .*'zero'"),
    "empty": ("a.obj", " \n\n", r"a\.obj: the file is empty"),
    "comments": ("a.obj", "# nothing\n", r"a\.obj: there are no vertices"),
    "points": ("a.obj", TRIANGLE, r"a\.obj: there are neither faces nor lines"),
    "suffix": ("a.dxf", "0\n", r"a\.dxf: the suffix '\.dxf' is not one of \.obj, \.ply, \.stl, \.off"),
    "no suffix": ("roof", "0\n", r"the suffix ''"),
    "off start": ("a.off", "roof\n", r"a\.off:1: .*does not start with 'OFF'"),
    "off binary": ("a.off", "OFF BINARY\n", r"a\.off:1: binary OFF"),
    "off 4d": ("a.off", "4OFF\n1 1 0\n", r"a\.off:1: "),
    "off vertices": ("a.off", "OFF\n3 1 0\n0 0 0\n", r"a\.off:3: the file ends before vertex 1 of 3"),
    "off faces": ("a.off", "OFF\n1 1 0\n0 0 0\n", r"a\.off:3: the file ends before face 0 of 1"),
    "off comments": ("a.off", "# nothing\n", r"a\.off: the file ends before the header"),
    "off corners": ("a.off", "OFF\n1 1 0\n0 0 0\n3 0 1\n", r"a\.off:4: face 0 has 2 corners instead of 3"),
    "off index": ("a.off", "OFF\n1 1 0\n0 0 0\n3 0 1 -2\n", r"a\.off:4: face 0 names vertex 1 .*has 1"),
    "stl neither": ("a.stl", "roof\n", r"a\.stl: this is neither a text STL"),
    "stl facet": ("a.stl", "solid\nvertex 0 0 0\nendloop\n", r"a\.stl:3: .*3 vertices"),
    "stl end": ("a.stl", "solid\nvertex 0 0 0\n", r"a\.stl:2: the file ends within a facet"),
    "stl nan": ("a.stl", stl_text([(0, 0, 0), (1, 0, 0), (0, np.nan, 0)]), r"a\.stl:6: vertex 2 .*finite"),
    "stl nothing": ("a.stl", "solid\nendsolid\n", r"a\.stl: there are no vertices"),
    "ply start": ("a.ply", "plu\n", r"a\.ply: the file does not start with 'ply'"),
    "ply header": ("a.ply", "ply\nformat ascii 1.0\nelement\nend_header\n", r"a\.ply:3: .*: element$"),
    "ply type": ("a.ply", PLY_HEADER + "property half w\n" + PLY_FACE, r"a\.ply:7: .*property half w"),
    "ply format": ("a.ply", "ply\nend_header\n", r"a\.ply:2: the header does not state the format"),
    "ply no z": ("a.ply", PLY_HEADER.replace(" z", " w") + PLY_FACE, r"a\.ply:.*'vertex' has no .*'z'"),
    "ply end": ("a.ply", PLY_HEADER + PLY_FACE + "0 0 0\n", r"a\.ply:10: the file ends before vertex 1"),
    "ply value": ("a.ply", PLY_HEADER + PLY_FACE + "0 0 0\n0 0\n", r"a\.ply:11: vertex 1 has too few values"),
    "ply strips": ("a.ply", PLY_HEADER + PLY_STRIPS + PLY_TRIANGLE, r"a\.ply:.*triangle strips"),
    "ply index": ("a.ply", PLY_HEADER + PLY_FACE + PLY_TRIANGLE + "3 0 1 3\n", r"a\.ply:13: .*vertex 3"),
    "ply binary end": ("a.ply", PLY_BINARY + "\0" * 20, r"a\.ply: vertex 1: the file ends"),
    "ply binary index": ("a.ply", PLY_BINARY + "\0" * 36 + "\3" + "\0" * 8 + "\7\0\0\0", r"face 0: .* 7"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_said_with_its_place(tmp_path, case):
    name, content, message = WRONG[case]
    path = tmp_path / name
    path.write_text(content)
    with pytest.raises(ValueError, match=message):
        read_mesh(path)


def test_nan_in_a_binary_stl_names_the_triangle(tmp_path):
    path = tmp_path / "a.stl"
    good = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    bad = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, float("nan"), 0, 0, 1, 0, 0)
    path.write_bytes(b"".ljust(80) + struct.pack("<I", 2) + good + bad)
    with pytest.raises(ValueError, match=r"a\.stl: triangle 1: vertex 4 .*not finite"):
        read_mesh(path)


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_missing_file_is_a_missing_file(tmp_path, suffix):
    with pytest.raises(FileNotFoundError):
        read_mesh(tmp_path / f"none.{suffix}")


def test_writing_to_an_unknown_suffix_is_refused(tmp_path, mixed_net):
    with pytest.raises(ValueError, match="suffix '.dwg'"):
        write_mesh(tmp_path / "net.dwg", *mixed_net)
    assert not list(tmp_path.iterdir())


coordinate = st.floats(allow_nan=False, allow_infinity=False)


@settings(max_examples=60, deadline=None)
@given(data=st.data(), suffix=st.sampled_from(["obj", "ply"]))
def test_any_net_survives_obj_and_ply(tmp_path_factory, data, suffix):
    count = data.draw(st.integers(3, 12))
    nodes = data.draw(st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=count, max_size=count))
    corner = st.integers(0, count - 1)
    panels = data.draw(st.lists(st.lists(corner, min_size=3, max_size=7, unique=True), max_size=5))
    spare = data.draw(st.lists(st.tuples(corner, corner).filter(lambda pair: pair[0] != pair[1]), min_size=1))
    pairs = {frozenset(pair): pair for pair in spare + [tuple(edge) for edge in edges_of(panels)]}
    members = data.draw(st.permutations(list(pairs.values())))
    path = tmp_path_factory.mktemp("net") / f"net.{suffix}"
    write_mesh(path, nodes, members, panels)
    assert_same_net(read_mesh(path), (nodes, members, panels))
