# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repairs of a mesh that leave its surface as it is; each says in `remarks` what it did.

Functions take and give numbers of vertices or nodes; what they say names vertices and facets as they came.
"""

from dataclasses import dataclass, replace

import numpy as np

import funicular as fn

from . import topology
from .wording import counted, is_or_are

# Of the bounding box's diagonal: what counts as one point unless a tolerance is given, and at least, because
# a member needs a length.
WELD = 1e-6
LEAST_WELD = 1e-10

# Of a facet's perimeter squared: an area below it is none.
NO_AREA = 1e-12


@dataclass(frozen=True)
class Facets:
    """corners: vertices around one facet after the other; sizes: how many each has; of: its number."""

    corners: np.ndarray
    sizes: np.ndarray
    of: np.ndarray

    def only(self, keep):
        return Facets(self.corners[np.repeat(keep, self.sizes)], self.sizes[keep], self.of[keep])

    @property
    def facet(self):
        """The facet of each corner."""
        return np.repeat(np.arange(len(self.sizes)), self.sizes)


def weld_vertices(points, facets, lines, name, weld, remarks):
    """(numbers, lookup, tolerance): the vertex of each node, the node of each vertex (-1: none), [mm]."""
    used = np.unique(np.concatenate([facets.corners, lines.ravel()]))
    wrong = used[~np.isfinite(points[used]).all(axis=1)]
    if len(wrong):
        at = np.flatnonzero(facets.corners == wrong[0])
        where = f" of facet {facets.facet[at[0]]}" if len(at) else ""
        raise fn.InvalidInput(
            f"{name}: vertex {wrong[0]}{where} is not finite ({', '.join(map(str, points[wrong[0]]))}): "
            "correct it or leave the facet out"
        )
    with np.errstate(over="ignore", invalid="ignore"):
        size = float(np.linalg.norm(np.ptp(points[used], axis=0)))
    if not np.isfinite(size):
        raise fn.InvalidInput(f"{name} spans more than a floating-point number holds: give points in mm")
    if weld is not None and not 0.0 <= weld < np.inf:
        raise fn.InvalidInput(f"weld is {weld:g} mm: give zero or more, or nothing for {WELD:g} of the size")
    tolerance = max(WELD * size if weld is None else float(weld), LEAST_WELD * size)
    kept, number = topology.weld(points[used], tolerance)
    lookup = np.full(len(points), -1, dtype=np.int64)
    lookup[used] = number
    welded = np.setdiff1d(np.arange(len(used)), kept, assume_unique=True)
    if len(welded):
        first = welded[0]
        remarks.append(
            f"{counted(len(welded), 'vertex', 'vertices')} within {tolerance:.3g} mm of another "
            f"{is_or_are(welded)} one node with it (first: {used[first]}, with {used[kept[number[first]]]})."
        )
    return used[kept], lookup, tolerance


def with_corners(facets, numbers, name, tolerance, remarks):
    """The facets that have three corners or more; a corner that repeats the one before it is none."""
    following = np.arange(1, len(facets.corners) + 1)
    ends = np.cumsum(facets.sizes)
    filled = facets.sizes > 0
    following[ends[filled] - 1] = (ends - facets.sizes)[filled]
    keep = facets.corners != facets.corners[following] if len(following) else np.zeros(0, dtype=bool)
    facet = facets.facet
    merged = Facets(facets.corners[keep], np.bincount(facet[keep], minlength=len(facets.sizes)), facets.of)
    pairs = np.unique((merged.facet << 32) | merged.corners)
    distinct = np.bincount(pairs >> 32, minlength=len(facets.sizes))
    closed = np.flatnonzero(distinct < 3)
    if len(closed):
        remarks.append(
            f"{counted(len(closed), 'facet')} with fewer than three corners {is_or_are(closed)} left out "
            f"(first: {facets.of[closed[0]]})."
        )
    repeated = np.flatnonzero((distinct >= 3) & (merged.sizes > distinct))
    if len(repeated):
        corners = merged.corners[merged.facet == repeated[0]].tolist()
        twice = next(corner for corner in corners if corners.count(corner) > 1)
        raise fn.InvalidInput(
            f"{name}: facet {facets.of[repeated[0]]} passes vertex {numbers[twice]} twice (vertices within "
            f"{tolerance:.3g} mm are one): split it there into facets of its own"
        )
    fewer = np.flatnonzero((distinct >= 3) & (merged.sizes < facets.sizes))
    if len(fewer):
        remarks.append(
            f"{counted(len(fewer), 'facet')} {'has' if len(fewer) == 1 else 'have'} fewer corners than "
            f"given, as some are one node (first: {facets.of[fewer[0]]})."
        )
    return merged.only(distinct >= 3)


def each_once(facets, remarks):
    """The facets without those that have the corners of an earlier one, in its order or against it."""
    same_as = np.arange(len(facets.sizes))
    begin = np.cumsum(facets.sizes) - facets.sizes
    for size in np.unique(facets.sizes).tolist():
        alike = np.flatnonzero(facets.sizes == size)
        corners = facets.corners[begin[alike][:, None] + np.arange(size)]
        # From the lowest corner on, towards its lower neighbour.
        from_lowest = (np.argmin(corners, axis=1)[:, None] + np.arange(size)) % size
        corners = np.take_along_axis(corners, from_lowest, axis=1)
        backwards = corners[:, 1] > corners[:, -1]
        corners[backwards, 1:] = corners[backwards, :0:-1]
        _, first, group = np.unique(corners, axis=0, return_index=True, return_inverse=True)
        same_as[alike] = alike[first[group.ravel()]]
    again = np.flatnonzero(same_as != np.arange(len(same_as)))
    if len(again):
        earlier = facets.of[same_as[again[0]]]
        remarks.append(
            f"{counted(len(again), 'facet')} given twice {is_or_are(again)} left out "
            f"(first: {facets.of[again[0]]}, the same as {earlier})."
        )
    return facets.only(same_as == np.arange(len(same_as)))


def proper_lines(lines, remarks):
    closed = np.flatnonzero(lines[:, 0] == lines[:, 1])
    if len(closed):
        remarks.append(
            f"{counted(len(closed), 'line')} of no length {is_or_are(closed)} left out (first: {closed[0]})."
        )
    _, first = np.unique(topology.edge_keys(*lines.T), return_index=True)
    again = np.setdiff1d(np.setdiff1d(np.arange(len(lines)), first), closed)
    if len(again):
        remarks.append(
            f"{counted(len(again), 'line')} given twice {is_or_are(again)} left out (first: {again[0]})."
        )
    return lines[np.setdiff1d(first, closed)]


def without_unused(count, numbers, lookup, facets, lines, remarks):
    """(numbers, facets, lines) with only the nodes that facets and lines have."""
    used = np.unique(np.concatenate([facets.corners, lines.ravel()]))
    number = np.full(len(numbers), -1, dtype=np.int64)
    number[used] = np.arange(len(used))
    unused = np.ones(count, dtype=bool)
    unused[lookup >= 0] = number[lookup[lookup >= 0]] < 0
    unused = np.flatnonzero(unused)
    if len(unused):
        remarks.append(
            f"{counted(len(unused), 'vertex', 'vertices')} on no facet {is_or_are(unused)} left out "
            f"(first: {unused[0]})."
        )
    return numbers[used], replace(facets, corners=number[facets.corners]), number[lines]


def tell_slivers(nodes, facets, remarks):
    if not len(facets.sizes):
        return
    sides = topology.HalfEdges.of(facets.corners, facets.sizes)
    begin = np.cumsum(facets.sizes) - facets.sizes
    from_first = nodes[sides.start] - nodes[facets.corners[begin]][sides.facet]
    cross = np.cross(from_first, from_first[sides.following])
    area = 0.5 * np.linalg.norm(np.add.reduceat(cross, begin), axis=1)
    perimeter = np.add.reduceat(np.linalg.norm(nodes[sides.start] - nodes[sides.end], axis=1), begin)
    slivers = np.flatnonzero(area <= NO_AREA * perimeter**2)
    if len(slivers):
        remarks.append(
            f"{counted(len(slivers), 'facet')} {'has' if len(slivers) == 1 else 'have'} no area and "
            f"{is_or_are(slivers)} kept (first: {facets.of[slivers[0]]})."
        )
