# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small valid mesh files of every format and habit, and what must hold of reading any bytes at all."""

import re
import struct

import numpy as np

import funicular as fn
from funicular.files import obj, off, ply, read_mesh, stl

SUFFIXES = ("obj", "ply", "stl", "off")

_NODES = np.array([[0.0, 0, 0], [1, 0, 0.25], [1, 1, 0], [0, 1, 0.125], [2, 0.5, 1e-3]])
_PANELS = [(0, 1, 2, 3), (1, 4, 2)]
_MEMBERS = [(0, 1), (1, 2), (2, 3), (3, 0), (1, 4), (4, 2)]


def seeds():
    """(suffix, content) of each."""
    for suffix, form in (("obj", obj), ("ply", ply), ("stl", stl), ("off", off)):
        yield suffix, form.write(f"net.{suffix}", _NODES, _MEMBERS, _PANELS)
    yield "obj", (
        b"\xef\xbb\xbf# a comment\r\nmtllib x\r\nv 0 0 0 0.5 0.5 0.5\r\nv 1 0 0\r\nv 1 1 0\r\nvn 0 0 1\r\n"
        b"g roof\r\nf 1/1/1 2//1 \\\r\n  3/1\r\nv 2 0 0\r\nf -1 -2 -3\r\nl 1 2 4 1\r\n"
    )
    yield "off", b"COFF 3 1 0 # colours\n0 0 0 9 9\n1 0 0\n\n0 1e-3 0\n3 0 1 2 255 0 0\n"
    vertices = "element vertex 3\nproperty double x\nproperty float y\nproperty short z\nproperty uchar red\n"
    faces = "element face 1\nproperty list uint8 float uv\nproperty list int ushort vertex_index\n"
    edges = "element edge 1\nproperty char vertex1\nproperty uint vertex2\nend_header\n"
    header = f"comment from elsewhere\n{vertices}{faces}{edges}"
    text = b"0 0 0 1\n1 0 0 1\n0 1 0 1\n2 0.5 0.5 3 0 1 2\n0 1\n"
    yield "ply", f"ply\nformat ascii 1.0\n{header}".encode() + text
    for order, name in (("<", "little"), (">", "big")):
        body = b"".join(struct.pack(order + "dfhB", x, y, 0, 1) for x, y in ((0, 0), (1, 0), (0, 1)))
        body += struct.pack(order + "B2fi3HbI", 2, 0.5, 0.5, 3, 0, 1, 2, 0, 1)
        yield "ply", f"ply\nformat binary_{name}_endian 1.0\n{header}".encode() + body
    triangle = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    yield "stl", b"solid binary".ljust(80) + struct.pack("<I", 2) + 2 * triangle


def check_reading(path, content):
    """Reads these bytes: a net comes of them, or a ValueError that names the file, its place or the member.

    Where the file can be read and the net is refused, it is the net's own refusal, by argument and index.
    """
    path.write_bytes(content)
    try:
        nodes, members, panels = read_mesh(path)
    except ValueError as refusal:
        assert re.match(re.escape(str(path)) + r"(:\d+)?: .{8,}", str(refusal), re.DOTALL), str(refusal)
        return
    assert nodes.dtype == np.float64 and np.isfinite(nodes).all() and nodes.shape[1:] == (3,)
    assert members.dtype == np.int64 and members.shape[1:] == (2,)
    assert all(type(corner) is int for panel in panels for corner in panel)
    # Nothing comes of nothing: a few bytes cannot hold many of anything.
    assert max(len(nodes), len(members), sum(map(len, panels))) <= len(content)
    try:
        net = fn.Net(nodes, members, panels)
    except fn.InvalidInput as refusal:
        assert re.match(r"(nodes|members|panels)\b", str(refusal)), str(refusal)
        return
    np.testing.assert_array_equal(net.nodes, nodes)
    assert net.panels == tuple(panels)
