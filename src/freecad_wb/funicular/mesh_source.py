# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh taken as it is: one node per vertex, one member per edge, one panel per facet.

What can be repaired without changing the surface is repaired, and told; what cannot is refused with the
numbers at fault. Vertices and facets are counted from 0, as FreeCAD counts those of a mesh. Lengths are mm.
"""

from dataclasses import dataclass
from numbers import Integral

import numpy as np

import funicular as fn

from . import mesh_repair, topology
from .files import read_parts
from .wording import and_more, counted, is_or_are, listed


@dataclass(frozen=True)
class MeshNet:
    """A mesh as a net.

    nodes: (n, 3) [mm]. members: (m, 2) nodes. panels: tuple of tuples of nodes, all the same way round.
    numbers: (n,) the vertex of the mesh that each node is, ascending. rims: border loops, int arrays of nodes
    in order, the longest first. remarks: list of sentences, what was repaired or left out.
    """

    nodes: np.ndarray
    members: np.ndarray
    panels: tuple
    numbers: np.ndarray
    rims: tuple
    remarks: list


def net_of_mesh(points, facets, name, weld=None, lines=()):
    """The net of a mesh, node for vertex and panel for facet.

    points: (n, 3) [mm]. facets: sequence of sequences of three or more vertex numbers, counted from 0. name:
    how errors call the mesh. weld: vertices that differ by no more than this in each coordinate [mm] are one
    node, the first; 1e-6 of the bounding box's diagonal unless given. lines: pairs of vertices that are
    members as well, whether or not they are edges of facets.

    Node i is vertex i unless vertices were welded or belong to nothing; `numbers` tells them. Members are
    the lines, then the edges in the order in which the facets run around. Left out and told in `remarks`:
    vertices on no facet or line, facets with fewer than three corners after welding, facets and lines given
    twice. Facets that run against their neighbours are turned round.

    Raises InvalidInput for no facets and no lines, a number out of range, a coordinate that is not finite, a
    facet that passes a vertex twice, an edge on three or more facets, facets that meet only at a vertex,
    several components, and a surface with one side only.
    """
    points = _checked_points(points, name)
    facets = _checked_facets(facets, len(points), name)
    lines = _checked_lines(lines, len(points), name)
    if not len(facets.corners) and not len(lines):
        raise fn.InvalidInput(f"{name} has no facets: pick a mesh that has some")
    remarks = []
    numbers, lookup, tolerance = mesh_repair.weld_vertices(points, facets, lines, name, weld, remarks)
    welded = mesh_repair.Facets(lookup[facets.corners], facets.sizes, facets.of)
    facets = mesh_repair.each_once(
        mesh_repair.with_corners(welded, numbers, name, tolerance, remarks), remarks
    )
    lines = mesh_repair.proper_lines(lookup[lines], remarks)
    if not len(facets.sizes) and not len(lines):
        raise fn.InvalidInput(
            f"{name} has no facet left: all have fewer than three corners once vertices within "
            f"{tolerance:g} mm of each other are one; give a smaller tolerance, or another mesh"
        )
    numbers, facets, lines = mesh_repair.without_unused(len(points), numbers, lookup, facets, lines, remarks)
    nodes = points[numbers]
    mesh_repair.tell_slivers(nodes, facets, remarks)

    sides = topology.HalfEdges.of(facets.corners, facets.sizes)
    _refuse_crowded_edges(sides, facets, numbers, name)
    _refuse_points_of_contact(sides, facets, numbers, name)
    members = np.vstack([lines, np.column_stack([sides.start, sides.end])])
    _, first = np.unique(topology.edge_keys(*members.T), return_index=True)
    members = members[np.sort(first)]
    _refuse_components(len(nodes), members, name)
    panels = _turned(sides, facets, numbers, name, remarks)
    return MeshNet(nodes, members, panels, numbers, topology.rims(nodes, panels), remarks)


def mesh_of(obj, name, place=None):
    """(points, facets) of a FreeCAD Mesh::Feature, placed as it stands in the document, or at another place.

    points: (n, 3) [mm], facets: list of triples, both in the numbering of the mesh. FreeCAD's meshes hold
    triangles only: what was a quad in a file is two of them there (`read_mesh_file` keeps it).
    Raises InvalidInput for an object that is no mesh, or one without facets.
    """
    if obj is None or not obj.isDerivedFrom("Mesh::Feature"):
        raise fn.InvalidInput(f"{name} is not a mesh: pick a mesh object")
    mesh = obj.Mesh.copy()
    # The mesh knows its object's own place, not that of what contains it.
    mesh.Placement = obj.getGlobalPlacement() if place is None else place
    points, facets = mesh.Topology
    if not facets:
        raise fn.InvalidInput(f"{name} has no facets: pick a mesh that has some")
    return np.array([tuple(point) for point in points], dtype=float).reshape(-1, 3), facets


def read_mesh_file(path):
    """(points, facets, lines) of an .obj, .ply, .stl or .off file in metres, for `net_of_mesh`.

    points: (n, 3) [mm]. facets: list of tuples of three or more vertices. lines: (k, 2) vertices, the file's
    own lines. Raises InvalidInput that names file and line where its content is wrong, OSError if it cannot
    be read.
    """
    try:
        vertices, lines, faces = read_parts(path)
    except ValueError as error:
        raise fn.InvalidInput(str(error)) from error
    return vertices * 1e3, faces, np.array(lines, dtype=np.int64).reshape(-1, 2)


def _checked_points(points, name):
    try:
        points = np.asarray(points, dtype=float)
    except (TypeError, ValueError):
        raise fn.InvalidInput(f"{name}: points are not numbers: give an (n, 3) array in mm") from None
    if points.size == 0:
        return points.reshape(0, 3)
    if points.ndim != 2 or points.shape[1] != 3:
        raise fn.InvalidInput(f"{name}: points have the shape {points.shape}: give an (n, 3) array in mm")
    return points


def _checked_facets(facets, count, name):
    facets = facets.tolist() if isinstance(facets, np.ndarray) else list(facets)
    try:
        sizes = np.array([len(facet) for facet in facets], dtype=np.int64)
        corners = np.array([corner for facet in facets for corner in facet])
    except (TypeError, ValueError):
        sizes = corners = None
    if corners is None or (corners.size and (corners.ndim != 1 or corners.dtype.kind not in "iu")):
        _refuse_corners(facets, count, name)
    wrong = np.flatnonzero((corners < 0) | (corners >= count))
    if len(wrong):
        facet = int(np.searchsorted(np.cumsum(sizes), wrong[0], side="right"))
        raise _out_of_range(f"facet {facet}", corners[wrong[0]], count, name)
    return mesh_repair.Facets(corners.astype(np.int64), sizes, np.arange(len(sizes)))


def _refuse_corners(facets, count, name):
    """Raises for the first corner that is no number of a vertex."""
    for number, facet in enumerate(facets):
        if not hasattr(facet, "__len__") or isinstance(facet, (str, bytes, dict, set)):
            raise fn.InvalidInput(f"{name}: facet {number} is {facet!r}: give its vertex numbers in order")
        for corner in facet:
            if not isinstance(corner, Integral) or isinstance(corner, bool):
                raise fn.InvalidInput(
                    f"{name}: facet {number} has the corner {corner!r}: give whole vertex numbers from 0"
                )
            if not 0 <= corner < count:
                raise _out_of_range(f"facet {number}", corner, count, name)
    raise fn.InvalidInput(f"{name}: facets are not sequences of vertex numbers: give tuples of integers")


def _out_of_range(what, vertex, count, name):
    return fn.InvalidInput(
        f"{name}: {what} names vertex {vertex}, but the mesh has {count} (counted from 0): correct it or "
        "leave it out"
    )


def _checked_lines(lines, count, name):
    try:
        lines = np.asarray(lines)
        if lines.size == 0:
            return np.zeros((0, 2), dtype=np.int64)
    except ValueError:
        lines = np.zeros(1)
    if lines.dtype.kind not in "iu" or lines.ndim != 2 or lines.shape[1] != 2:
        raise fn.InvalidInput(f"{name}: lines are not pairs of vertex numbers: give a (k, 2) array of them")
    wrong = np.argwhere((lines < 0) | (lines >= count))
    if len(wrong):
        raise _out_of_range(f"line {wrong[0, 0]}", lines[tuple(wrong[0])], count, name)
    return lines.astype(np.int64)


def _refuse_crowded_edges(sides, facets, numbers, name):
    crowded = np.flatnonzero(np.bincount(sides.edge)[sides.edge] > 2) if len(sides.edge) else ()
    if len(crowded):
        first = crowded[0]
        on_it = facets.of[sides.facet[sides.edge == sides.edge[first]]].tolist()
        a, b = sorted(numbers[[sides.start[first], sides.end[first]]].tolist())
        more = len(np.unique(sides.edge[crowded])) - 1
        raise fn.InvalidInput(
            f"{name}: edge {a}-{b} lies on {len(on_it)} facets ({listed(on_it)}){and_more(more)}: a net is "
            "one sheet, so delete facets there until each edge has two at most"
        )


def _refuse_points_of_contact(sides, facets, numbers, name):
    """Raises where the facets around a node are not one fan: they are joined corner by corner over edges."""
    shared = np.flatnonzero(sides.twin >= 0)
    twin = sides.twin[shared]
    alike = sides.start[shared] == sides.start[twin]
    at_start = np.column_stack([shared, np.where(alike, twin, sides.following[twin])])
    at_end = np.column_stack([sides.following[shared], np.where(alike, sides.following[twin], twin)])
    fan = topology.parts(len(sides.start), np.vstack([at_start, at_end]))
    first_corners = np.flatnonzero(fan == np.arange(len(fan)))
    fans = np.bincount(sides.start[first_corners], minlength=len(numbers))
    contacts = np.flatnonzero(fans > 1)
    if len(contacts):
        vertex = contacts[0]
        one_of_each = facets.of[sides.facet[first_corners[sides.start[first_corners] == vertex]]].tolist()
        raise fn.InvalidInput(
            f"{name}: vertex {numbers[vertex]} joins {fans[vertex]} fans of facets only at a point (facets "
            f"{listed(one_of_each)}, one of each){and_more(len(contacts) - 1)}: give each fan a vertex of "
            "its own there, or join them by facets with a common edge"
        )


def _refuse_components(count, members, name):
    sizes = np.bincount(topology.parts(count, members))
    sizes = sorted(sizes[sizes > 0].tolist(), reverse=True)
    if len(sizes) > 1:
        raise fn.InvalidInput(
            f"{name}: the mesh has {len(sizes)} components, of {listed(sizes, last=' and ')} vertices: a net "
            "is one piece, so split it (Meshes, Split by components) and make a net of each, or give a "
            "larger tolerance if they should touch"
        )


def _turned(sides, facets, numbers, name, remarks):
    """The panels, all the same way round: of facets that hang together by edges, the fewer are turned."""
    turn = np.zeros(len(facets.sizes), dtype=bool)
    shared = np.flatnonzero(sides.twin > np.arange(len(sides.twin)))
    twin = sides.twin[shared]
    pairs = np.column_stack([sides.facet[shared], sides.facet[twin]])
    against = sides.start[shared] == sides.start[twin]
    if against.any():
        for patch in _walked(len(turn), pairs, against, turn):
            if 2 * np.count_nonzero(turn[patch]) > len(patch):
                turn[patch] = ~turn[patch]
        torn = np.flatnonzero(against ^ turn[pairs[:, 0]] ^ turn[pairs[:, 1]])
        if len(torn):
            a, b = sorted(numbers[[sides.start[shared[torn[0]]], sides.end[shared[torn[0]]]]].tolist())
            of = facets.of[pairs[torn[0]]]
            raise fn.InvalidInput(
                f"{name}: the surface has one side only, as a Moebius band has (its facets, turned one after "
                f"the other, do not agree at edge {a}-{b} of facets {of[0]} and {of[1]}): cut it there"
            )
    turned = np.flatnonzero(turn)
    if len(turned):
        remarks.append(
            f"{counted(len(turned), 'facet')} that ran against {'its' if len(turned) == 1 else 'their'} "
            f"neighbours {is_or_are(turned)} turned round (first: {facets.of[turned[0]]})."
        )
    panels = list(topology.polygons(facets.corners, facets.sizes))
    for panel in turned.tolist():
        panels[panel] = panels[panel][:1] + panels[panel][:0:-1]
    return tuple(panels)


def _walked(count, pairs, against, turn):
    """Sets which facets to turn, breadth first from the first of each patch; yields the patches."""
    ends = np.concatenate([pairs, pairs[:, ::-1]])
    order = np.argsort(ends[:, 0], kind="stable")
    neighbours = ends[order, 1].tolist()
    differs = np.concatenate([against, against])[order].tolist()
    begin = np.searchsorted(ends[order, 0], np.arange(count + 1)).tolist()
    turned = [None] * count
    for first in range(count):
        if turned[first] is not None:
            continue
        turned[first], patch = False, [first]
        for facet in patch:
            for k in range(begin[facet], begin[facet + 1]):
                if turned[neighbours[k]] is None:
                    turned[neighbours[k]] = turned[facet] ^ differs[k]
                    patch.append(neighbours[k])
        turn[patch] = [turned[facet] for facet in patch]
        yield patch
