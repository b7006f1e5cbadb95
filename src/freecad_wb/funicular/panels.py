# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels as figures in space: their best planes, areas and triangles. Needs numpy only.

A panel is a sequence of node numbers, in order around it. Lengths are in the unit of the nodes.
"""

import numpy as np


def best_planes(nodes, panels):
    """The plane of each panel whose corners' distances from it have the least sum of squares.

    nodes: (n, 3). panels: p sequences of node numbers.
    Returns (centres (p, 3), unit normals (p, 3), distances (p,)): the mean of the corners; the normal on the
    side from which the corners run counter-clockwise; the largest distance of a corner from the plane, zero
    for a triangle.
    """
    centres, normals, distances = np.zeros((3, len(panels), 3))
    distances = distances[:, 0]
    for which, corners in Groups(panels).corners(nodes):
        centre = corners.mean(axis=1)
        offsets = corners - centre[:, None]
        # The last of the right singular vectors is the direction in which the corners vary least.
        normal = np.linalg.svd(offsets, full_matrices=False)[2][:, -1]
        around = np.cross(offsets, np.roll(offsets, -1, axis=1)).sum(axis=1)
        normal *= np.where(np.einsum("pi,pi->p", normal, around) < 0.0, -1.0, 1.0)[:, None]
        centres[which], normals[which] = centre, normal
        if corners.shape[1] > 3:
            distances[which] = np.abs(np.einsum("pki,pi->pk", offsets, normal)).max(axis=1)
    return centres, normals, distances


def areas(nodes, panels):
    """(p,) areas as the core counts covering: of the triangles between the edges and the corners' mean."""
    return Groups(panels).areas(nodes)


def are_convex(nodes, panels):
    """(p,) whether each panel turns the same way at all of its corners, as seen along its mean normal."""
    convex = np.ones(len(panels), dtype=bool)
    for which, corners in Groups(panels).corners(nodes):
        sides = np.roll(corners, -1, axis=1) - corners
        turns = np.cross(np.roll(sides, 1, axis=1), sides)
        around = np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1)
        along = np.einsum("pki,pi->pk", turns, around)
        # A corner within a straight side turns neither way, but for rounding.
        convex[which] = (along >= -1e-9 * np.abs(along).max(axis=1, keepdims=True)).all(axis=1)
    return convex


def triangles(nodes, panels):
    """The panels cut into triangles about the mean of their corners, panel by panel.

    Returns (points, triangles): the nodes and behind them, for every panel of more than three corners, their
    mean; a list of triples of their numbers. A triangular panel stays as it is.
    """
    points, cut = [np.asarray(nodes, dtype=float)], []
    middle = len(nodes)
    for panel in panels:
        if len(panel) == 3:
            cut.append(tuple(panel))
            continue
        points.append(points[0][list(panel)].mean(axis=0, keepdims=True))
        cut += [(a, b, middle) for a, b in zip(panel, turned(panel))]
        middle += 1
    return np.concatenate(points), cut


def turned(panel):
    """The corners, each replaced by the one that follows it: zip(panel, turned(panel)) are the sides."""
    return (*panel[1:], panel[0])


class Groups:
    """Panels by how many corners they have, for whoever asks for their areas at many positions of the nodes.

    panels: sequences of node numbers.
    """

    def __init__(self, panels):
        counts = np.array([len(panel) for panel in panels], dtype=int)
        self._count = len(panels)
        self._groups = [
            (which, np.array([panels[number] for number in which]))
            for which in (np.flatnonzero(counts == count) for count in np.unique(counts))
        ]

    def corners(self, nodes):
        """(numbers of the panels, (k, corners, 3) positions) for each number of corners that occurs."""
        nodes = np.asarray(nodes, dtype=float)
        for which, numbers in self._groups:
            yield which, nodes[numbers]

    def areas(self, nodes):
        """As areas(), of these panels."""
        found = np.zeros(self._count)
        for which, corners in self.corners(nodes):
            spokes = corners - corners.mean(axis=1, keepdims=True)
            doubled = np.linalg.norm(np.cross(spokes, np.roll(spokes, -1, axis=1)), axis=2)
            found[which] = 0.5 * doubled.sum(axis=1)
        return found


class Cover:
    """The panels of a Net, and what becomes of their area as the nodes move.

    panels: as net.panels, which makes them anew each time that it is asked.
    """

    def __init__(self, net):
        self.panels = net.panels
        self._groups = Groups(self.panels)
        self._before = self._groups.areas(net.nodes).sum()

    def left(self, nodes):
        """Area of the panels at `nodes` (n, 3) over that as the net was laid; 1 without panels."""
        return float(self._groups.areas(nodes).sum() / self._before) if self._before else 1.0
