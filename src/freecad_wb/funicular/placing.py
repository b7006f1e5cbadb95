# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which nodes of a lattice lie inside an outline, which are moved onto it, and where its edges are cut.

Numbers only: knows nothing of FreeCAD.
"""

from dataclasses import dataclass

import numpy as np

from .buckets import Buckets

# A node nearer to the outline than this part of its shortest member is moved onto it.
REACH = 1.0 / 3.0

# How far a node may be moved onto a corner of the outline, in members, and what an inner node counts further.
CORNER_REACH = 1.05
INNER = 0.3

# Between a node on the outline and a crossing the outline has to rise this far, in members, over the edge;
# less is its curvature.
RISE = 0.15

# What is equal but for rounding has to be decided alike.
ROUNDING = 1e-6


@dataclass(frozen=True)
class Placed:
    """Nodes of a lattice, and after them those of the cuts.

    sign: (n,) 1 inside, 0 on the outline, -1 outside. place: (n,) on the outline, -1 for nodes that are not.
    xy: (n, 2) positions. cut_node: (k,) the node that cuts each edge, -1 where none does. gap: (k,) of a cut
    between a node on the outline and one inside, whether what lies before it is outside.
    lost: places near edges that should be crossed and are not.
    """

    sign: np.ndarray
    place: np.ndarray
    xy: np.ndarray
    cut_node: np.ndarray
    gap: np.ndarray
    lost: np.ndarray


def place_nodes(xy, edges, outline, poles):
    """The Placed of nodes at xy (n, 2) with edges (k, 2). poles: as pole_nodes gives them."""
    count = len(xy)
    a, b = edges.T
    at_a, at_b = _facing(xy, a, b, poles)
    length = np.linalg.norm(outline.offset(at_a - at_b), axis=1)
    shortest = np.full(count, np.inf)
    np.minimum.at(shortest, a, length)
    np.minimum.at(shortest, b, length)
    place, apart = outline.nearest(xy)
    for pole, axis in poles.items():
        place[pole], apart[pole] = outline.nearest_to_side(xy[pole], axis)
    on = apart <= REACH * shortest * (1.0 + ROUNDING)
    sign = np.where(on, 0, np.where(outline.inside(xy), 1, -1))
    place = np.where(on, place, -1.0)
    for corner, node in _corner_nodes(outline, xy, sign).items():
        sign[node], place[node] = 0, corner
    moved = xy.copy()
    moved[sign == 0] = outline.plane(place[sign == 0])

    through = np.flatnonzero(sign[a] * sign[b] < 0)
    places, lost = _middle(*outline.crossings(at_a[through], at_b[through]), len(through))
    beside = np.flatnonzero(np.abs(sign[a]) + np.abs(sign[b]) == 1)
    again, places_again = _again(outline, moved, edges, beside, sign, place, poles)
    cut = np.concatenate([through, again])
    cut_node = np.full(len(edges), -1)
    cut_node[cut] = count + np.arange(len(cut))
    place_of_cuts = np.concatenate([places, places_again])
    near, _ = outline.nearest(0.5 * (at_a + at_b)[through[lost]])
    return Placed(
        sign=np.concatenate([sign, np.zeros(len(cut), dtype=int)]),
        place=np.concatenate([place, place_of_cuts]),
        xy=np.concatenate([moved, outline.plane(place_of_cuts)]),
        cut_node=cut_node,
        gap=(sign[a] + sign[b] == 1) & (cut_node >= 0),
        lost=near,
    )


def pole_nodes(uv, sides):
    """{node: axis} of nodes that are a whole side of the rectangle, with the axis across that side."""
    found = {}
    for side in sides:
        axis = "uv".index(side[0])
        at = 0.0 if side.endswith("min") else 1.0
        found[int(np.flatnonzero(uv[:, axis] == at)[0])] = axis
    return found


def _facing(xy, a, b, poles):
    """Ends of edges, (k, 2) each; a pole is opposite to the other end."""
    at_a, at_b = xy[a], xy[b]
    for pole, axis in poles.items():
        for one, ends, others in ((a, at_a, at_b), (b, at_b, at_a)):
            ends[one == pole, 1 - axis] = others[one == pole, 1 - axis]
    return at_a, at_b


def _corner_nodes(outline, xy, sign):
    """{corner of the outline: node that is moved onto it}."""
    corners = outline.start[outline.corners]
    corner, node = Buckets(outline.extent, outline.period, xy).pairs(corners)
    distance = np.linalg.norm(outline.offset(xy[node] - corners[corner]), axis=1)
    near = distance <= CORNER_REACH
    corner, node = corner[near], node[near]
    cost = (distance[near] + INNER * (sign[node] > 0)).round(6)
    taken, used = {}, set()
    # Where costs are equal, position decides, not the numbering.
    for k in np.lexsort((*xy[node].round(6).T, cost)).tolist():
        place = int(outline.corners[corner[k]])
        if place not in taken and int(node[k]) not in used:
            taken[place] = int(node[k])
            used.add(int(node[k]))
    return taken


def _middle(line, share, place, count):
    """(place where each of count lines is crossed, of several the middle one; lines that are not crossed)."""
    order = np.lexsort((share, line))
    line, place = line[order], np.append(place[order], 0.0)
    first = np.searchsorted(line, np.arange(count), side="left")
    crossed = np.searchsorted(line, np.arange(count), side="right") - first
    return place[first + crossed // 2], np.flatnonzero(crossed == 0)


def _again(outline, moved, edges, beside, sign, place, poles):
    """(edges, places): cuts of edges with one end on the outline, by another part of it.

    One end may be on one side of a corner, or of a narrow part, and the other beyond the other side.
    """
    a, b = edges[beside].T
    line, share, at = outline.crossings(*_facing(moved, a, b, poles))
    on = np.where(sign[a] == 0, a, b)[line]
    inner = (share > 1e-3) & (share < 1.0 - 1e-3)
    line, at, on = line[inner], at[inner], on[inner]
    rises = [outline.rise(*both) > RISE for both in zip(place[on].tolist(), at.tolist())]
    line, at = line[rises], at[rises]
    # Two crossings leave the ends as they are.
    alone = np.bincount(line, minlength=len(beside))[line] == 1
    return beside[line[alone]], at[alone]
