# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL: https://www.loc.gov/preservation/digital/formats/fdd/fdd000504.shtml"""

import struct

import numpy as np

from .connectivity import check_members_on_panels

WELD = 1e-6
"""Corners whose coordinates differ by no more than this part of the bounding box's diagonal are one node."""


def read(source, content):
    # Binary files may start with "solid" too; their length tells them apart.
    if len(content) >= 84 and len(content) == 84 + 50 * struct.unpack_from("<I", content, 80)[0]:
        facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        facets = np.frombuffer(content, dtype=facet, offset=84)
        source.nodes = facets["corners"].reshape(-1, 3)
        source.node_places = [f"triangle {corner // 3}" for corner in range(len(source.nodes))]
    elif content.lstrip()[:5].lower() == b"solid":
        for keyword, *words in source.text_lines(content):
            if keyword.lower() == "vertex":
                source.add_node(words)
            elif keyword.lower() == "endloop" and len(source.nodes) % 3:
                raise source.error("this facet does not have 3 vertices")
        if len(source.nodes) % 3:
            raise source.error("the file ends within a facet")
    else:
        raise source.error(
            "this is neither a text STL ('solid …') nor a binary one of the length that it states"
        )
    corners = source.finite_nodes()
    with np.errstate(over="ignore"):
        size = np.linalg.norm(np.ptp(corners, axis=0)) if len(corners) else 0.0
    if not np.isfinite(size):
        raise source.error("the vertices span more than a floating-point number holds", "")
    source.nodes, ids = weld(corners, WELD * size)
    # A triangle that welding closes has no area and says nothing about the surface.
    source.faces = [(None, tuple(face)) for face in ids.reshape(-1, 3).tolist() if len(set(face)) == 3]


def weld(points, tolerance):
    """Points within the tolerance of each other, by coordinate, become the first of them.

    Returns the points that stay, in order of first appearance, and for every point the index of its own.
    """
    if not len(points):
        return points, np.zeros(0, dtype=np.int64)
    # In cells as wide as the tolerance a point can only meet one of its own or of the 26 cells around.
    cells = np.floor((points - points.min(axis=0)) / (tolerance or 1.0)).astype(np.int64).tolist()
    kept, kept_in_cell, ids = [], {}, np.empty(len(points), dtype=np.int64)
    seen = {}
    for i, (point, cell) in enumerate(zip(points.tolist(), cells)):
        point, cell = tuple(point), tuple(cell)
        if point not in seen:
            seen[point] = _kept_near(point, cell, kept, kept_in_cell, tolerance)
            if seen[point] is None:
                seen[point] = kept_in_cell[cell] = len(kept)
                kept.append(point)
        ids[i] = seen[point]
    return np.array(kept), ids


_AROUND = [(i, j, k) for i in (0, -1, 1) for j in (0, -1, 1) for k in (0, -1, 1)]


def _kept_near(point, cell, kept, kept_in_cell, tolerance):
    for i, j, k in _AROUND:
        index = kept_in_cell.get((cell[0] + i, cell[1] + j, cell[2] + k))
        if index is not None and max(abs(p - q) for p, q in zip(point, kept[index])) <= tolerance:
            return index
    return None


def write(path, nodes, members, panels):
    check_members_on_panels(path, members, panels)
    triangles = [(panel[0], b, c) for panel in panels for b, c in zip(panel[1:], panel[2:])]
    corners = nodes[np.array(triangles, dtype=np.int64).reshape(-1, 3)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    rows = ["solid net"]
    for (x, y, z), triangle in zip(normals.tolist(), corners.tolist()):
        rows += [f"facet normal {x!r} {y!r} {z!r}", "outer loop"]
        rows += [f"vertex {x!r} {y!r} {z!r}" for x, y, z in triangle]
        rows += ["endloop", "endfacet"]
    return "\n".join([*rows, "endsolid net", ""]).encode("ascii")
