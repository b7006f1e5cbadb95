# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for every equal-length net, whatever the face."""

import math
from collections import Counter

import numpy as np

import funicular as fn


def lengths(net):
    return np.linalg.norm(net.nodes[net.members[:, 0]] - net.nodes[net.members[:, 1]], axis=1)


def number_at(net, i, j):
    found = np.flatnonzero((net.grid == (i, j)).all(axis=1))
    assert len(found) == 1, f"no node at {i}, {j}"
    return int(found[0])


def node_at(net, i, j):
    return net.nodes[number_at(net, i, j)]


def corner_angles(net):
    """(k, 4) angles of the panels [degrees]."""
    corners = net.nodes[net.panels]
    ahead = np.roll(corners, -1, axis=1) - corners
    back = np.roll(corners, 1, axis=1) - corners
    cosines = np.einsum("nki,nki->nk", ahead, back)
    return np.degrees(np.arccos(cosines / np.linalg.norm(ahead, axis=2) / np.linalg.norm(back, axis=2)))


def corner_normals(net):
    corners = net.nodes[net.panels]
    return np.cross(np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners)


def check(net, chart, step, most_shear=60.0):
    """What holds for every net."""
    assert np.abs(lengths(net) / step - 1.0).max() < 1e-9
    assert ((net.uv >= 0.0) & (net.uv <= 1.0)).all()
    assert np.abs(chart.point(*net.uv.T) - net.nodes).max() < 1e-8 * step + 1e-14 * np.abs(net.nodes).max()

    # The grid says what members and panels join.
    i_j = net.grid[net.members[:, 1]] - net.grid[net.members[:, 0]]
    assert set(map(tuple, i_j.tolist())) == {(1, 0), (0, 1)}
    square = net.grid[net.panels] - net.grid[net.panels[:, :1]]
    assert (square == [[0, 0], [1, 0], [1, 1], [0, 1]]).all()
    assert len({tuple(place) for place in net.grid.tolist()}) == len(net.nodes)
    assert (net.grid == 0).all(axis=1).any()

    # Every member is the side of one panel or two; the rims are the sides of one, each way round once.
    sides = [tuple(side) for k in range(4) for side in net.panels[:, [k, (k + 1) % 4]].tolist()]
    assert len(set(sides)) == len(sides)
    assert {tuple(sorted(side)) for side in sides} == {tuple(sorted(pair)) for pair in net.members.tolist()}
    once = set(sides)
    border = Counter(side for side in sides if side[::-1] not in once)
    pairs = [pair for rim in net.rims for pair in zip(rim.tolist(), np.roll(rim, -1).tolist())]
    assert border == Counter(pairs)

    # One piece, joined by sides.
    panels_of = {}
    for panel, nodes in enumerate(net.panels.tolist()):
        for k in range(4):
            panels_of.setdefault(frozenset((nodes[k], nodes[k - 1])), []).append(panel)
    reached, waiting = {0}, [0]
    while waiting:
        nodes = net.panels[waiting.pop()].tolist()
        for k in range(4):
            for panel in panels_of[frozenset((nodes[k], nodes[k - 1]))]:
                if panel not in reached:
                    reached.add(panel)
                    waiting.append(panel)
    assert len(reached) == len(net.panels)

    # Nothing is folded, nothing coincides.
    angles = corner_angles(net)
    assert angles.min() > 90.0 - most_shear - 1e-6 and angles.max() < 90.0 + most_shear + 1e-6
    normals = corner_normals(net)
    assert (np.einsum("nki,ni->nk", normals, normals.sum(axis=1)) > 0.0).all()
    h = 1e-6
    a, b = net.uv[net.panels[:, 0]].T
    ahead_a, ahead_b = np.where(a > 0.5, -h, h), np.where(b > 0.5, -h, h)
    here = chart.point(a, b)
    along = (chart.point(a + ahead_a, b) - here) / ahead_a[:, None]
    across = (chart.point(a, b + ahead_b) - here) / ahead_b[:, None]
    outwards = np.cross(along, across)
    singular = np.linalg.norm(outwards, axis=1) < 1e-6 * np.linalg.norm(outwards, axis=1).max()
    assert (np.einsum("ni,ni->n", normals[:, 0], outwards) > 0.0)[~singular].all()
    shortest = 2.0 * math.sin(math.radians(0.5 * (90.0 - most_shear))) * step
    # Along the rim nodes may be the corners of a cell that was sheared too much.
    assert closest(net.nodes) > min(0.499 * shortest, 0.74 * step)
    fn.Net(net.nodes * 1e-3, net.members, net.panels)


def closest(points):
    """The smallest distance between two of the points."""
    smallest = np.inf
    for first in range(0, len(points), 200):
        apart = np.linalg.norm(points[first : first + 200, None] - points[None], axis=2)
        rows = np.arange(len(apart))
        apart[rows, first + rows] = np.inf
        smallest = min(smallest, apart.min())
    return smallest
