# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets on trimmed faces: a lattice on the whole rectangle of parameters, cut along the face's outline."""

from dataclasses import dataclass

import numpy as np

import funicular as fn

from . import surface
from .buckets import Buckets
from .clipping import Rings, border, clip, loops
from .outline import read_outline

REACH = 1.0 / 3.0
CORNER_REACH = 1.05
INNER = 0.3
LEAST_PIECE = 0.12
RISE = 0.15


@dataclass(frozen=True)
class TrimmedNet:
    """A net on a trimmed face, in mm and before any relaxation.

    nodes: (n, 3) [mm]. members: (m, 2) node numbers. panels: list of tuples of node numbers, all round the
    same way. rims: the closed borders, each an array of node numbers in order with the net to the left, the
    outer one first, then one for each opening. edge_nodes: {"Edge3": the nodes on that edge of the face, in
    order along it}. corners: the nodes where the outer border turns by more than 30 degrees, ascending.
    """

    nodes: np.ndarray
    members: np.ndarray
    panels: list
    rims: tuple
    edge_nodes: dict
    corners: np.ndarray


class Cut:
    pass


def trimmed_net(face, name, step_u, step_v, pattern="quad"):
    chart, to_square = surface.read_rectangle(face, name)
    lattice = fn.lattice(
        *surface.count_cells(chart, step_u, step_v, pattern),
        pattern=pattern,
        closed_u=chart.closed_u,
        closed_v=chart.closed_v,
        poles=sorted(chart.poles),
    )
    extent = np.array(lattice.cells) * fn.cell_extent(pattern)
    outline = read_outline(face, name, chart, to_square, extent)
    c = cut(lattice, extent, outline, chart)
    return c


def cut(lattice, extent, outline, chart):
    xy = lattice.uv * extent
    count = len(xy)
    rings = Rings.of(lattice.panels)
    poles = _pole_nodes(lattice, chart)
    a, b = rings.edges.T
    xa, xb = _facing(xy, a, b, poles, outline)
    length = np.linalg.norm(outline.offset(xa - xb), axis=1)
    reach = np.full(count, np.inf)
    np.minimum.at(reach, a, length)
    np.minimum.at(reach, b, length)
    places, apart = outline.nearest(xy)
    for pole, axis in poles.items():
        places[pole], apart[pole] = outline.lowest(xy[pole], axis)
    on = apart <= REACH * reach * (1.0 + 1e-6)
    sign = np.where(on, 0, np.where(outline.inside(xy), 1, -1))
    place = np.where(on, places, -1.0)
    for corner, node in _corner_nodes(outline, extent, xy, sign).items():
        sign[node], place[node] = 0, corner

    moved = xy.copy()
    moved[place >= 0] = outline.plane(place[place >= 0])
    ma, mb = _facing(moved, a, b, poles, outline)
    is_cut, cut_place = _cuts(outline, (a, b), (xa, xb), (ma, mb), sign, place, reach)
    cut_node = np.full(len(a), -1)
    cut_node[is_cut] = count + np.arange(len(is_cut))
    gap = (sign[a] + sign[b] == 1) & (cut_node >= 0)
    place = np.concatenate([place, cut_place])
    sign = np.concatenate([sign, np.zeros(len(is_cut), dtype=int)])
    xy0 = np.concatenate([xy, outline.plane(cut_place)])
    at_border = np.flatnonzero(place >= 0)
    xy1 = xy0.copy()
    xy1[at_border] = outline.plane(place[at_border])
    whole, pieces, doubtful = clip(rings, sign, cut_node, gap)
    kept = _decide(rings, xy, xy1, doubtful, outline)
    panels = rings.select(whole) + [r for _, r in pieces] + [r for _, r in kept]
    origin = np.concatenate([whole, [p for p, _ in pieces], [p for p, _ in kept]]).astype(int)
    c = Cut()
    c.__dict__.update(locals())
    edges, _, twice = border(panels)
    c.rims, c.ambiguous = loops(edges)
    c.twice = twice
    return c


def _decide(rings, xy, xy1, doubtful, outline):
    kept = []
    if not doubtful:
        return kept
    centres, areas = _centres([r for _, r, _ in doubtful], xy1, outline)
    full = np.array([_centres(rings.select(np.array([p])), xy, outline)[1][0] for p, _, _ in doubtful])
    inside = outline.inside(centres)
    for (panel, joined, apart), within, area, f in zip(doubtful, inside, areas, full):
        if apart == ():
            if within and area >= LEAST_PIECE * f:
                kept.append((panel, joined))
        elif within:
            kept.append((panel, joined))
        else:
            kept += [(panel, r) for r in apart]
    return kept


def _centres(panels, xy, outline):
    """((n, 2) mean of the corners, (n,) area) of rings in the plane of the lattice."""
    centres, areas = [], []
    for ring in panels:
        at = xy[list(ring)]
        away = outline.offset(at - at[0])
        nxt = np.roll(away, -1, axis=0)
        areas.append(0.5 * (away[:, 0] * nxt[:, 1] - away[:, 1] * nxt[:, 0]).sum())
        centres.append(at[0] + away.mean(axis=0))
    return np.array(centres), np.array(areas)


def _pole_nodes(lattice, chart):
    """{node: axis across the side} of nodes that are a whole side of the rectangle."""
    found = {}
    for side in chart.poles:
        axis = 0 if side[0] == "u" else 1
        at = 0.0 if side.endswith("min") else 1.0
        found[int(np.flatnonzero(lattice.uv[:, axis] == at)[0])] = axis
    return found


def _facing(xy, a, b, poles, outline):
    """Ends of lines between nodes, a pole's opposite to the other end."""
    xa, xb = xy[a].copy(), xy[b].copy()
    for pole, axis in poles.items():
        for one, ends, others in ((a, xa, xb), (b, xb, xa)):
            of_pole = one == pole
            ends[of_pole, 1 - axis] = others[of_pole, 1 - axis]
    return xa, xb


def _corner_nodes(outline, extent, xy, sign):
    """{corner segment: node that is moved onto it}."""
    if not len(outline.corners):
        return {}
    corners = outline.start[outline.corners]
    corner, node = Buckets(extent, outline.period, xy).pairs(corners)
    distance = np.linalg.norm(outline.offset(xy[node] - corners[corner]), axis=1)
    near = distance <= CORNER_REACH
    corner, node, distance = corner[near], node[near], distance[near]
    cost = (distance + INNER * (sign[node] > 0)).round(6)
    taken, used = {}, set()
    # Where costs are equal, position decides, not the numbering.
    for k in np.lexsort((xy[node, 0].round(6), xy[node, 1].round(6), cost)).tolist():
        place = int(outline.corners[corner[k]])
        if place not in taken and int(node[k]) not in used:
            taken[place] = int(node[k])
            used.add(int(node[k]))
    return taken


def _cuts(outline, edges, ends, moved, sign, place, reach):
    """(edges, places) at which edges are cut: see the module."""
    a, b = edges
    sum_ = np.abs(sign[a]) + np.abs(sign[b])
    full = np.flatnonzero(sign[a] * sign[b] < 0)
    half = np.flatnonzero(sum_ == 1)
    full_place = _middle(*outline.crossings(ends[0][full], ends[1][full]), len(full))
    line, share, at = outline.crossings(moved[0][half], moved[1][half])
    on_b = sign[b[half]] == 0
    on = np.where(on_b, b[half], a[half])
    share = np.where(on_b[line], 1.0 - share, share)  # from the node on the outline
    good = [
        k
        for k in range(len(line))
        if 0.02 < share[k] < 0.98 and outline.rise(place[on[line[k]]], at[k]) > RISE
    ]
    line, at = line[good], at[good]
    # an odd number
    keep_line, keep_at = [], []
    for l in np.unique(line):
        these = np.flatnonzero(line == l)
        if len(these) == 1:
            keep_line.append(l)
            keep_at.append(at[these[0]])
    return (
        np.concatenate([full, half[np.array(keep_line, dtype=int)]]),
        np.concatenate([full_place, keep_at]),
    )


def _middle(line, share, place, count):
    """The place where the outline crosses each line; of several the one in the middle."""
    order = np.lexsort((share, line))
    line, place = line[order], place[order]
    first = np.searchsorted(line, np.arange(count), side="left")
    counts = np.searchsorted(line, np.arange(count), side="right") - first
    if (counts == 0).any():
        raise fn.InvalidInput("lost crossing")
    return place[first + counts // 2]
