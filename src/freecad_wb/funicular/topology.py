# SPDX-License-Identifier: LGPL-2.1-or-later
"""How facets and members hang together: welding, parts, edges with a facet on each side, border loops.

Needs numpy only, and works on whole arrays where a mesh may have 10^5 facets.
"""

from dataclasses import dataclass
from itertools import chain

import numpy as np

from .files import stl

# No row, column or diagonal of points is square to it, so that few points are level along it.
GENERIC = np.array([0.7548776662466927, 0.5698402909980532, 0.3247179572447460])

# Beyond so many points level with one within the tolerance, each is compared by cells instead.
MOST_LEVEL = 64


def weld(points, tolerance):
    """Points within the tolerance of each other, by coordinate, become the first of them.

    points: (n, 3), finite. Returns (kept, number): the (k,) indices of the points that stay, ascending, and
    for each of the n points the number of its own among them.
    """
    points = np.asarray(points, dtype=float).reshape(-1, 3) + 0.0  # makes -0.0 the same as 0.0
    if not len(points):
        return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64)
    _, first, of_distinct = np.unique(points, axis=0, return_index=True, return_inverse=True)
    own = first[of_distinct.ravel()]
    distinct = np.sort(first)
    suspects = distinct[_have_neighbours(points[distinct], tolerance)]
    if len(suspects):
        _, group = stl.weld(points[suspects], tolerance)
        _, first_of_group = np.unique(group, return_index=True)
        welded = np.arange(len(points))
        welded[suspects] = suspects[first_of_group[group]]
        own = welded[own]
    kept = np.unique(own)
    return kept, np.searchsorted(kept, own)


def _have_neighbours(points, tolerance):
    """Whether each of distinct points may have another within the tolerance."""
    offsets = points - points.min(axis=0)
    along = offsets @ GENERIC
    order = np.argsort(along, kind="stable")
    reach = tolerance * GENERIC.sum() + 1e-14 * along.max()
    suspect = np.zeros(len(points), dtype=bool)
    for step in range(1, min(len(points), MOST_LEVEL + 1)):
        low, high = order[:-step], order[step:]
        level = along[high] - along[low] <= reach
        if not level.any():
            break
        low, high = low[level], high[level]
        if step < MOST_LEVEL:
            close = (np.abs(offsets[low] - offsets[high]) <= tolerance).all(axis=1)
            low, high = low[close], high[close]
        suspect[low] = suspect[high] = True
    return suspect


def parts(count, pairs):
    """(count,) for each of `count` things the lowest of those that it hangs together with, itself included.

    pairs: (k, 2) things that are joined.
    """
    label = np.arange(count)
    a, b = np.asarray(pairs, dtype=np.int64).reshape(-1, 2).T
    while len(a):
        low, high = np.minimum(label[a], label[b]), np.maximum(label[a], label[b])
        apart = low < high
        a, b, low, high = a[apart], b[apart], low[apart], high[apart]
        # Of several assignments to one place the last one stays: the lowest.
        order = np.argsort(-low, kind="stable")
        label[high[order]] = low[order]
        while (label[label] != label).any():
            label = label[label]
    return label


@dataclass(frozen=True)
class HalfEdges:
    """The sides of polygons, each of which runs from a corner to the next one. Side h begins at corner h.

    start, end: nodes. facet: the polygon. following: the next side around it. twin: the side of the other
    polygon on the same edge, whichever way it runs, -1 on the border; of no meaning on an edge with more than
    two sides. edge: the same number for all sides of one edge.
    """

    start: np.ndarray
    end: np.ndarray
    facet: np.ndarray
    following: np.ndarray
    twin: np.ndarray
    edge: np.ndarray

    @classmethod
    def of(cls, corners, sizes):
        """corners: nodes around one polygon after the other. sizes: how many each of them has."""
        corners, sizes = np.asarray(corners, dtype=np.int64), np.asarray(sizes, dtype=np.int64)
        following = np.arange(1, len(corners) + 1)
        ends = np.cumsum(sizes)
        following[ends - 1] = ends - sizes
        end = corners[following]
        _, edge = np.unique(edge_keys(corners, end), return_inverse=True)
        order = np.argsort(edge, kind="stable")
        twin = np.full(len(corners), -1)
        same = np.flatnonzero(edge[order[1:]] == edge[order[:-1]])
        twin[order[same]], twin[order[same + 1]] = order[same + 1], order[same]
        return cls(corners, end, np.repeat(np.arange(len(sizes)), sizes), following, twin, edge)


def edge_keys(start, end):
    """(k,) one number for each edge, the same in either direction."""
    start, end = np.asarray(start, dtype=np.int64), np.asarray(end, dtype=np.int64)
    return (np.minimum(start, end) << 32) | np.maximum(start, end)


def flat(polygons):
    """(corners, sizes) of a sequence of index sequences."""
    sizes = np.fromiter(map(len, polygons), dtype=np.int64, count=len(polygons))
    return np.fromiter(chain.from_iterable(polygons), dtype=np.int64, count=sizes.sum()), sizes


def polygons(corners, sizes):
    """The tuple of tuples that `flat` flattened."""
    corners, ends = corners.tolist(), np.cumsum(sizes)
    return tuple(
        tuple(corners[begin:end]) for begin, end in zip((ends - sizes).tolist(), ends.tolist(), strict=True)
    )


def rims(nodes, panels):
    """The border loops of panels that all run the same way round: a tuple of int arrays of nodes in order.

    Each loop runs as the panels beside it do and begins at its lowest node, which is not repeated at its end;
    the loop that spans most is the first. Panels that meet at a node only have loops of their own there.
    """
    sides = HalfEdges.of(*flat(panels))
    following, twin, start = sides.following.tolist(), sides.twin.tolist(), sides.start.tolist()
    loops, walked = [], set()
    for first in np.flatnonzero(sides.twin < 0).tolist():
        loop, side = [], first
        while side not in walked:
            walked.add(side)
            loop.append(start[side])
            side = following[side]
            # Around the node, from panel to panel, until the border comes again.
            while twin[side] >= 0:
                side = following[twin[side]]
        if loop:
            lowest = int(np.argmin(loop))
            loops.append(np.array(loop[lowest:] + loop[:lowest], dtype=np.int64))
    # What is around a hole spans less than what the hole is in, however long its way may be.
    lengths = [np.linalg.norm(np.ptp(nodes[loop], axis=0)) for loop in loops]
    # Equal loops keep the order of their nodes, whatever the last digit of their length.
    rank = [(-round(length / max(lengths), 9), int(loop[0])) for loop, length in zip(loops, lengths)]
    return tuple(loops[k] for k in sorted(range(len(loops)), key=rank.__getitem__))
