# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the nodes of a scene are held, by kind, as whoever draws it wants to know it. Only numpy."""

from dataclasses import dataclass

import numpy as np

import funicular as fn

POINT, LINE, PLANE = "point", "line", "plane"


@dataclass(frozen=True)
class Held:
    """Nodes that are held in one way.

    nodes: (k,). directions: (k, 3) of lines, or normals of planes; zero for points. yields: (k,) bool.
    """

    nodes: np.ndarray
    directions: np.ndarray
    yields: np.ndarray


def held_of(supports):
    """{POINT, LINE, PLANE: Held} of fn supports."""
    found = {POINT: [], LINE: [], PLANE: []}
    for support in supports:
        kind, direction = POINT, (0.0, 0.0, 0.0)
        if isinstance(support, fn.OnLine):
            kind, direction = LINE, support.direction
        elif isinstance(support, fn.OnPlane):
            kind, direction = PLANE, support.normal
        found[kind].append((np.asarray(support.ids), direction, np.isfinite(support.stiffness)))
    return {kind: _joined(parts) for kind, parts in found.items()}


def _joined(parts):
    sizes = [len(ids) for ids, _, _ in parts]
    nodes = np.concatenate([ids for ids, _, _ in parts]) if parts else np.zeros(0)
    directions = np.array([direction for _, direction, _ in parts], dtype=float).reshape(-1, 3)
    length = np.linalg.norm(directions, axis=1)
    directions = directions / np.where(length > 0.0, length, 1.0)[:, None]
    yields = np.array([yields for _, _, yields in parts], dtype=bool)
    return Held(nodes.astype(int), np.repeat(directions, sizes, axis=0), np.repeat(yields, sizes))


def square_in(normals):
    """(k, 4, 3) corners, at a distance of one from the middle, of squares across unit normals (k, 3).

    A diagonal is level: so a vertical plane is seen as a square that stands on a corner.
    """
    level = np.column_stack([-normals[:, 1], normals[:, 0], np.zeros(len(normals))])
    flat = np.linalg.norm(level, axis=1)
    level = np.where((flat > 1e-9)[:, None], level / np.maximum(flat, 1e-300)[:, None], (1.0, 0.0, 0.0))
    steep = np.cross(normals, level)
    return np.stack([level, steep, -level, -steep], axis=1)
