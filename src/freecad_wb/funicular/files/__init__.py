# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets in mesh files: OBJ, PLY, STL and OFF. Needs numpy only.

What a file says of a net, whatever its format:

- one node per vertex, with the file's numbering; coordinates are metres;
- each face is a panel, of any number of corners;
- members are the file's lines (OBJ `l`, PLY `element edge`) in their order, then every edge of a face that is
  not among them, in the order in which the faces run around; each member once.

OBJ and PLY write all members, so what comes back is the same net, number by number; only a panel's edge that
was no member comes back as one. OFF and STL hold faces only: their members are the panels' edges, and a net
with a member on no panel is refused. STL holds triangles without numbering: panels are fanned from their
first corner, which adds members, and corners closer than `stl.WELD` of the box's diagonal become one node.

Why not a library: of those in Debian, meshio 5 drops OBJ lines, reads and writes OFF triangles only, refuses
PLY edges, silently finds no faces in a PLY that calls them `vertex_index`, and does not name the wrong line.
"""

import os

import numpy as np

from . import obj, off, ply, stl
from .source import Source

FORMATS = {".obj": obj, ".ply": ply, ".stl": stl, ".off": off}


def read_mesh(path):
    """Read a net from an .obj, .ply, .stl or .off file.

    Returns
    -------
    nodes : (n, 3) float64 array, m
    members : (m, 2) int64 array of node indices
    panels : list of tuples of node indices

    Raises
    ------
    FileNotFoundError
        There is no such file.
    ValueError
        Unknown suffix; or the content is wrong: the message names file, line (in a binary file: element)
        and index.
    """
    return _read(path).net()


def read_parts(path):
    """Read a mesh from an .obj, .ply, .stl or .off file, its lines apart from its faces.

    Returns
    -------
    vertices : (n, 3) float64 array, m
    lines : list of pairs of vertex indices, as the file has them
    faces : list of tuples of vertex indices

    Raises as `read_mesh` does.
    """
    return _read(path).parts()


def read_textured(path):
    """Read a mesh and its UV coordinates: of .obj files only; of others there are none.

    Returns vertices and faces as `read_parts`, uvs : (k, 2) float64 array, and face_uvs : for each face a
    tuple of numbers of uvs, or None. Raises as `read_mesh` does.
    """
    form = _format_of(path)
    source = _read(path, **({"with_uv": True} if form is obj else {}))
    vertices, _, faces = source.parts()
    uvs, face_uvs = source.textured()
    return vertices, faces, uvs, face_uvs or [None] * len(faces)


def _read(path, **options):
    form = _format_of(path)
    with open(path, "rb") as file:
        content = file.read()
    source = Source(path)
    if not content.strip():
        raise source.error("the file is empty")
    form.read(source, content, **options)
    return source


def write_mesh(path, nodes, members, panels):
    """Write a net to an .obj, .ply, .stl or .off file; the module's text says what each format keeps.

    nodes (n, 3) in m; members (m, 2) node indices; panels: sequence of sequences of node indices. Coordinates
    are written so that reading gives the same floats; PLY is binary, the others are text.

    Raises ValueError for an unknown suffix, and for OFF and STL if a member lies on no panel.
    """
    form = _format_of(path)
    nodes = np.asarray(nodes, dtype=np.float64).reshape(-1, 3)
    members = [(int(a), int(b)) for a, b in members]
    panels = [tuple(int(corner) for corner in panel) for panel in panels]
    # Made before the file is opened: a net that is refused destroys no earlier file.
    content = form.write(path, nodes, members, panels)
    with open(path, "wb") as file:
        file.write(content)


def _format_of(path):
    suffix = os.path.splitext(os.fspath(path))[1].lower()
    if suffix not in FORMATS:
        raise ValueError(f"{path}: the suffix '{suffix}' is not one of {', '.join(FORMATS)}")
    return FORMATS[suffix]
