# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels of a wireframe: the cycles of its members that enclose nothing else, seen square to its surface."""

import numpy as np

from . import topology
from .crossings import meetings
from .wording import counted, listed

# Of a cycle's size: how far its nodes may be from one plane. Cycles of four corners may be warped.
FLAT = 1e-3

# In radians: at less a cycle runs straight on and has no corner.
STRAIGHT = 1e-3

# Of the net's size: nodes and members that come nearer in projection coincide there.
COINCIDENT = 1e-6


def panels_of(nodes, members, remarks):
    """The panels between members that hang together and lie near a surface.

    nodes: (n, 3). members: (m, 2) that cross nowhere. remarks: list that is told what is left open, and why.
    The net is laid on the plane that fits its nodes best, or else on the horizontal one; where no two members
    cross there, its panels are the faces of that plane graph which are flat or have three or four corners.
    Returns a tuple of tuples of nodes, which run counter-clockwise seen from above.
    """
    pieces = np.unique(topology.parts(len(nodes), members))
    if len(pieces) > 1:
        remarks.append(
            f"The members are in {len(pieces)} parts that do not touch, so no panels are found: join them, "
            "or make a net of each."
        )
        return ()
    closed = _without_dangling(len(nodes), members)
    if not closed.all():
        remarks.append(
            f"{counted(int((~closed).sum()), 'member')} with a free end, or leading to one only, without a "
            f"panel (first: {np.flatnonzero(~closed)[0]})."
        )
    numbers = np.flatnonzero(closed)
    if not len(numbers):
        return ()
    members = members[numbers]
    flat, crossing = _projected(nodes, members, numbers)
    if flat is None:
        remarks.append(
            f"Seen square to the surface that fits best, {crossing}, so no panels are found: give a "
            "wireframe that lies near one surface, or a mesh."
        )
        return ()
    return _sound(nodes, _faces(flat, members), remarks)


def _without_dangling(count, members):
    """(m,) whether a member is left once those with a free end are taken away, again and again."""
    keep = np.ones(len(members), dtype=bool)
    while True:
        degree = np.bincount(members[keep].ravel(), minlength=count)
        free = keep & (degree[members] == 1).any(axis=1)
        if not free.any():
            return keep
        keep &= ~free


def _projected(nodes, members, numbers):
    """((n, 2) the nodes on a plane where members do not cross, None), or (None, what crosses)."""
    used = np.unique(members)
    centred = nodes - nodes[used].mean(axis=0)
    size = np.linalg.norm(np.ptp(centred[used], axis=0))
    axes = np.linalg.svd(centred[used], full_matrices=False)[2]
    # Upwards, so that panels are counter-clockwise from above.
    if next(part for part in axes[2, ::-1] if abs(part) > 1e-9) < 0.0:
        axes[2] *= -1.0
    axes[1] = np.cross(axes[2], axes[0])
    crossing = None
    for across in (axes[:2], np.eye(3)[:2]):
        flat = centred @ across.T
        why = _what_crosses(np.column_stack([flat, np.zeros(len(flat))]), used, members, numbers, size)
        if why is None:
            return flat, None
        crossing = crossing or why
    return None, crossing


def _what_crosses(flat, used, members, numbers, size):
    kept, number = topology.weld(flat[used], COINCIDENT * size)
    if len(kept) < len(used):
        again = np.setdiff1d(np.arange(len(used)), kept)[0]
        return f"nodes {used[kept[number[again]]]} and {used[again]} lie one behind the other"
    met = meetings(flat, members, COINCIDENT * size)
    if not len(met):
        return None
    if len(met.crossing):
        one, other = numbers[met.crossing[0]]
        return f"members {one} and {other} cross"
    return f"node {met.node[0]} lies on member {numbers[met.touched[0]]}"


def _faces(flat, members):
    """Nodes around each inner face of a plane graph, counter-clockwise. flat: (n, 2)."""
    start, end = members.T.ravel(), members[:, ::-1].T.ravel()
    directions = flat[end] - flat[start]
    order = np.lexsort((np.arctan2(directions[:, 1], directions[:, 0]), start))
    # Around each node, the side before each one: clockwise from it.
    first = np.searchsorted(start[order], start[order])
    last = np.searchsorted(start[order], start[order], side="right") - 1
    place = np.arange(len(order))
    before = np.empty_like(order)
    before[order] = order[np.where(place == first, last, place - 1)]
    # The face on the left goes on with the side that is clockwise from the way back.
    following = before[(place + len(members)) % len(order)].tolist()
    x, y = (flat - flat[start].mean(axis=0)).T
    doubled_areas = (x[start] * y[end] - x[end] * y[start]).tolist()
    faces, areas, walked, start = [], [], [False] * len(order), start.tolist()
    for side in range(len(order)):
        face, area = [], 0.0
        while not walked[side]:
            walked[side] = True
            face.append(start[side])
            area += doubled_areas[side]
            side = following[side]
        if face:
            faces.append(face)
            areas.append(area)
    # The one around all is walked the other way, with an area below zero.
    del faces[int(np.argmin(areas))]
    return faces


def _sound(nodes, faces, remarks):
    panels, twisted, warped = [], [], []
    for face in faces:
        lowest = face.index(min(face))
        panel = tuple(face[lowest:] + face[:lowest])
        if len(set(face)) < len(face):
            twisted.append(panel)
        elif len(face) > 4 and _corners(nodes[face]) > 4 and not _is_flat(nodes[face]):
            warped.append(panel)
        else:
            panels.append(panel)
    for cycles, why in (
        (twisted, "around something inside that is joined to them at one place"),
        (warped, "of five corners or more that are not flat"),
    ):
        if cycles:
            remarks.append(
                f"{counted(len(cycles), 'cycle')} {why} without a panel (first: nodes {listed(cycles[0])})."
            )
    return tuple(panels)


def _corners(around):
    along = around - around[np.arange(len(around)) - 1]
    along /= np.sqrt((along**2).sum(axis=1))[:, None]
    turns = along - along[np.arange(len(around)) - 1]
    return np.count_nonzero((turns**2).sum(axis=1) > STRAIGHT**2)


def _is_flat(around):
    centred = around - around.mean(axis=0)
    normal = np.linalg.svd(centred, full_matrices=False)[2][2]
    return np.abs(centred @ normal).max() <= FLAT * np.linalg.norm(np.ptp(around, axis=0))
