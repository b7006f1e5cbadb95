# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of sketches, wires and compounds as a net: members where they run, nodes where they meet.

Lengths are mm. Edges are asked by their own methods, so that nothing of FreeCAD is imported here.
"""

from collections import Counter
from dataclasses import dataclass
from math import ceil

import numpy as np

import funicular as fn

from . import cycles, topology
from .crossings import divided
from .curves import met_inside
from .wording import counted, is_or_are, listed

# Of the size of the wireframe: ends that differ by no more in each coordinate are one node.
WELD = 1e-6

# By this part of its length a straight edge may be longer than the way between its ends: rounding.
STRAIGHT = 1e-10

# Beyond this a chord is a slip of the unit rather than a wish.
MOST_CHORDS = 1_000_000


@dataclass(frozen=True)
class WireNet:
    """A wireframe as a net.

    nodes: (n, 3) [mm]. members: (m, 2) nodes, along the first edge, the second, … panels: tuple of tuples of
    nodes, counter-clockwise seen from above. edge_nodes: "Edge3" -> int array of the nodes along that edge of
    the shape; of several shapes "0.Edge3", with the number of the shape. An edge without length has one node,
    or none if nothing else ends there. rims: border loops of the panels, int arrays, the longest first.
    remarks: list of sentences, what was divided, left out or found to have no panel.
    """

    nodes: np.ndarray
    members: np.ndarray
    panels: tuple
    edge_nodes: dict
    rims: tuple
    remarks: list


@dataclass
class _Edge:
    """An edge of a shape. knots: parameters where it has to have a node; parts: chords between them."""

    name: str
    shape: object
    curved: bool
    knots: list
    parts: list


def net_of_edges(shapes, name, chord=None):
    """The net of Part edges, placed as they stand.

    shapes: a Part shape, or several. name: how errors call them. chord: curved edges are divided into equal
    parts no longer than this [mm]; unless given, one member for each, three for one that closes on itself.

    Ends within 1e-6 of the size are one node. Edges that cross or touch inside are divided there, curved ones
    where the curves themselves meet; edges on top of each other count once. Panels are those that `cycles`
    finds. Raises InvalidInput for shapes without edges, an edge that is endless, and a chord that is not a
    length or gives more than 1,000,000 members.
    """
    shapes = list(shapes) if isinstance(shapes, (list, tuple)) else [shapes]
    if chord is not None and not 0.0 < chord < np.inf:
        raise fn.InvalidInput(f"chord is {chord:g} mm: give a length greater than zero")
    remarks = []
    edges, dropped = _read(shapes, name)
    size = _size(edges)
    tolerance = WELD * size
    _divide_curves(edges, size, tolerance)
    for edge in edges:
        _choose_parts(edge, chord, name)
    while True:
        points, number, begin = _points_along(edges, tolerance)
        of_segment, segments = _segments(edges, number, begin)
        if not len(segments):
            raise fn.InvalidInput(f"{name} has no edges with a length: pick a sketch, a wire or other edges")
        before = len(points)
        points, pieces = divided(points, segments, tolerance)
        if not _bulge_apart(edges, of_segment, pieces):
            break
    if len(points) > before:
        remarks.append(f"{counted(len(points) - before, 'node')} where edges cross without a vertex.")
    chains = [number[at : at + 1].tolist() for at in begin[:-1]]
    for (edge, _), piece in zip(of_segment, pieces):
        chains[edge] += piece[1:]
    chains = [np.array(chain, dtype=np.int64) for chain in chains]
    dropped += [edge.name for edge, chain in zip(edges, chains) if len(chain) < 2]
    members, again = _members(edges, chains)
    _tell(edges, dropped, again, remarks)

    used = np.unique(members)
    own = np.full(len(points), -1, dtype=np.int64)
    own[used] = np.arange(len(used))
    nodes, members = points[used], own[members]
    edge_nodes = {edge.name: own[chain][own[chain] >= 0] for edge, chain in zip(edges, chains)}
    panels = cycles.panels_of(nodes, members, remarks)
    return WireNet(nodes, members, panels, edge_nodes, topology.rims(nodes, panels), remarks)


def _read(shapes, name):
    """(edges with a length, names of those without)."""
    edges, dropped = [], []
    for number, shape in enumerate(shapes):
        if shape is None or not hasattr(shape, "Edges") or shape.isNull():
            raise fn.InvalidInput(f"{name} has no shape (number {number}): pick a sketch, a wire or edges")
        for count, edge in enumerate(shape.Edges, 1):
            key = f"Edge{count}" if len(shapes) == 1 else f"{number}.Edge{count}"
            if getattr(edge, "Degenerated", False):
                dropped.append(key)
                continue
            first, last = edge.FirstParameter, edge.LastParameter
            if max(abs(first), abs(last)) > 1e50:
                raise fn.InvalidInput(f"{name}: {key} is endless: give it two ends")
            way = edge.valueAt(first).distanceToPoint(edge.valueAt(last))
            curved = edge.Length - way > STRAIGHT * edge.Length
            edges.append(_Edge(key, edge, curved, [first, last], [1]))
    if not edges and not dropped:
        raise fn.InvalidInput(f"{name} has no edges: pick a sketch, a wire or other edges")
    return edges, dropped


def _size(edges):
    """Diagonal of the box around the ends of all edges and the middles of curved ones, in their parameter."""
    points = [
        tuple(edge.shape.valueAt(edge.knots[0] + share * (edge.knots[-1] - edge.knots[0])))
        for edge in edges
        for share in ((0.0, 0.25, 0.5, 0.75, 1.0) if edge.curved else (0.0, 1.0))
    ]
    return float(np.linalg.norm(np.ptp(np.array(points), axis=0))) if points else 0.0


def _divide_curves(edges, size, tolerance):
    """Gives curved edges a knot wherever another edge meets them inside."""
    if not any(edge.curved for edge in edges):
        return
    met = met_inside([edge.shape for edge in edges], [edge.curved for edge in edges], size, tolerance)
    for edge, parameters in zip(edges, met):
        edge.knots = _apart(edge, parameters, tolerance)
        edge.parts = [1] * (len(edge.knots) - 1)


def _apart(edge, parameters, tolerance):
    """The ends of an edge and the parameters between them, in order, without those that are one node."""
    first, last = edge.knots
    at_ends = edge.shape.valueAt(first), edge.shape.valueAt(last)
    knots, points = [first], [at_ends[0]]
    for knot in sorted(parameters):
        point = edge.shape.valueAt(knot)
        if all(point.distanceToPoint(taken) > 2.0 * tolerance for taken in (*at_ends, points[-1])):
            knots.append(knot)
            points.append(point)
    return [*knots, last]


def _choose_parts(edge, chord, name):
    if not edge.curved:
        return
    if chord is not None:
        curve = edge.shape.Curve
        lengths = [curve.length(a, b) for a, b in zip(edge.knots, edge.knots[1:])]
        if sum(lengths) > MOST_CHORDS * chord:
            raise fn.InvalidInput(
                f"chord is {chord:g} mm, which makes more than {MOST_CHORDS} members of {name}, {edge.name}: "
                "give a longer one"
            )
        # Rounding makes no part of its own.
        edge.parts = [max(1, ceil(length / chord * (1.0 - 1e-9))) for length in lengths]
    ends = [edge.shape.valueAt(knot) for knot in (edge.knots[0], edge.knots[-1])]
    closed = ends[0].distanceToPoint(ends[1]) <= STRAIGHT * edge.shape.Length
    if closed and sum(edge.parts) < 3:
        edge.parts = [3] if len(edge.parts) == 1 else [2, 1]


def _points_along(edges, tolerance):
    """(points, number, begin): nodes, the node of each point along the edges, where each edge begins."""
    points, begin = [], [0]
    for edge in edges:
        parameters = edge.knots[:1]
        for a, b, parts in zip(edge.knots, edge.knots[1:], edge.parts):
            if parts > 1:
                curve = edge.shape.Curve
                length = curve.length(a, b)
                parameters += [curve.parameterAtDistance(length * k / parts, a) for k in range(1, parts)]
            parameters.append(b)
        points += [tuple(edge.shape.valueAt(parameter)) for parameter in parameters]
        begin.append(len(points))
    points = np.array(points, dtype=float).reshape(-1, 3)
    kept, number = topology.weld(points, tolerance)
    return points[kept], number, begin


def _segments(edges, number, begin):
    """([(edge, which of its parts), …], (m, 2) nodes) of what runs straight between points along the edges.

    The second of the pair is None for a piece of an edge that is straight, or divided there already.
    """
    of_segment, segments = [], []
    for count, (edge, at) in enumerate(zip(edges, begin)):
        of_point = [
            k if edge.curved and parts == 1 else None
            for k, parts in enumerate(edge.parts)
            for _ in range(parts)
        ]
        for part, a, b in zip(of_point, number[at:].tolist(), number[at + 1 :].tolist()):
            if a != b:
                of_segment.append((count, part))
                segments.append((a, b))
    return of_segment, np.array(segments, dtype=np.int64).reshape(-1, 2)


def _bulge_apart(edges, of_segment, pieces):
    """Divides curves in two where their one chord lies on other members; whether there were any."""
    times = Counter(frozenset(pair) for piece in pieces for pair in zip(piece, piece[1:]))
    doubled = [
        (edge, part)
        for (edge, part), piece in zip(of_segment, pieces)
        if part is not None and all(times[frozenset(pair)] > 1 for pair in zip(piece, piece[1:]))
    ]
    for edge, part in doubled:
        edges[edge].parts[part] = 2
    return bool(doubled)


def _members(edges, chains):
    """(members, names of edges that lie on earlier ones all along)."""
    members, again = {}, []
    for edge, chain in zip(edges, chains):
        before = len(members)
        for a, b in zip(chain.tolist(), chain[1:].tolist()):
            members.setdefault((min(a, b), max(a, b)), (a, b))
        if len(members) == before and len(chain) > 1:
            again.append(edge.name)
    return np.array(list(members.values()), dtype=np.int64), again


def _tell(edges, dropped, again, remarks):
    closed = [edge.name for edge in edges if edge.curved and edge.parts in ([3], [2, 1])]
    if dropped:
        edges_are = f"{counted(len(dropped), 'edge')} of no length {is_or_are(dropped)}"
        remarks.append(f"{edges_are} left out ({listed(dropped)}).")
    if again:
        edges_are = f"{counted(len(again), 'edge')} along others {is_or_are(again)}"
        remarks.append(f"{edges_are} counted once ({listed(again)}).")
    if closed:
        remarks.append(
            f"Curves that close on themselves are triangles ({listed(closed)}): give a shorter chord."
        )
