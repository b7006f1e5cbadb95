# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole cells of a grid of nodes: those that hang together with a place, their members and rims.

Numbers only: knows nothing of FreeCAD.
"""

import numpy as np

# East, north, west, south, and the cell to the left of a member that goes there from a node: where its lowest
# corner lies.
WAYS = ((1, 0), (0, 1), (-1, 0), (0, -1))
LEFT_CELLS = ((0, 0), (-1, 0), (-1, -1), (0, -1))


def whole_cells(present):
    """(k, l) bool: the cells of which all four corners are present, at the place of their lowest corner."""
    cells = np.zeros_like(present)
    cells[:-1, :-1] = present[:-1, :-1] & present[1:, :-1] & present[1:, 1:] & present[:-1, 1:]
    return cells


def hanging_together(cells, node):
    """The largest part of the cells that reach a node, each with another by a whole side. cells: (k, l) bool
    without any in its outermost rows and columns; node: its two indices. Empty if no cell is there."""
    best = np.zeros_like(cells)
    for di, dj in LEFT_CELLS:
        seed = (node[0] + di, node[1] + dj)
        if not cells[seed] or best[seed]:
            continue
        part, waiting = np.zeros_like(cells), [seed]
        part[seed] = True
        while waiting:
            i, j = waiting.pop()
            for di_, dj_ in WAYS:
                other = (i + di_, j + dj_)
                if cells[other] and not part[other]:
                    part[other] = True
                    waiting.append(other)
        if part.sum() > best.sum():
            best = part
    return best


def corners(cells):
    """(n, 4, 2) indices of the nodes round each cell."""
    at = np.argwhere(cells)
    return at[:, None] + np.array([[0, 0], [1, 0], [1, 1], [0, 1]])


def members(cells):
    """(m, 2, 2) indices of the ends of each side of a cell: those along the first direction before the
    others."""
    sides = []
    for axis, step in ((1, (1, 0)), (0, (0, 1))):
        at = np.argwhere(cells | np.roll(cells, 1, axis=axis))
        sides.append(np.stack([at, at + step], axis=1))
    return np.concatenate(sides)


def rims(cells):
    """List of (k, 2) arrays: the nodes of each border in order, the cells on the left, closed.

    A node at which cells meet by their corners only is passed once for each.
    """

    def on_rim(node, way):
        i, j = node
        (di, dj), (ei, ej) = LEFT_CELLS[way], LEFT_CELLS[way - 1]
        return cells[i + di, j + dj] and not cells[i + ei, j + ej]

    found, passed = [], set()
    for i, j in np.argwhere(cells & ~np.roll(cells, 1, axis=1)).tolist():
        node, way, rim = (i, j), 0, []
        while (node, way) not in passed:
            passed.add((node, way))
            rim.append(node)
            node = (node[0] + WAYS[way][0], node[1] + WAYS[way][1])
            # Leftmost first: the cell that was on the left stays there.
            way = next(turn % 4 for turn in (way + 1, way, way - 1) if on_rim(node, turn % 4))
        if rim:
            found.append(np.array(rim))
    return found
