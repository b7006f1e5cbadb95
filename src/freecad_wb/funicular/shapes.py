# SPDX-License-Identifier: LGPL-2.1-or-later
"""Areas, angles and sides of panels in the plane of a lattice. Numbers only: knows nothing of FreeCAD."""

import numpy as np


def areas_and_centres(panels, xy, outline):
    """((p,) areas, (p, 2) means of the corners) of rings of nodes at xy (n, 2), positive anticlockwise."""
    areas, centres = np.empty(len(panels)), np.empty((len(panels), 2))
    for of, _, corners in _by_size(panels, xy, outline):
        following = np.roll(corners, -1, axis=1)
        areas[of] = 0.5 * _cross(corners, following).sum(axis=1)
        centres[of] = xy[[panels[k][0] for k in of]] + corners.mean(axis=1)
    return areas, centres


def shape_faults(panels, xy, full, outline, poles, bounds):
    """List of (panel, what is wrong) of panels that are folded or less than bounds.

    full: (p,) area of the whole panels. poles: nodes whose panels are left out. bounds: least area as a part
    of the full one, least angle [rad], least side.
    """
    area, angle, length = bounds
    worst = []
    for of, rings, corners in _by_size(panels, xy, outline):
        sides = np.roll(corners, -1, axis=1) - corners
        back = -np.roll(sides, 1, axis=1)
        angles = np.arctan2(_cross(sides, back), (sides * back).sum(axis=2)) % (2 * np.pi)
        # Without area in this plane are panels round a pole alone, which are skipped.
        with np.errstate(divide="ignore", invalid="ignore"):
            shares = 0.5 * _cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1) / full[of]
        shortest = np.linalg.norm(sides, axis=2).min(axis=1)
        folded = np.abs(angles.sum(axis=1) - (corners.shape[1] - 2) * np.pi) > 1e-6
        skip = np.isin(rings, list(poles)).any(axis=1)
        for wrong, what in (
            (folded | (shares < area), "area"),
            (angles.min(axis=1) < angle, "angle"),
            (shortest < length, "side"),
        ):
            worst += [(panels[of[k]], what) for k in np.flatnonzero(wrong & ~skip)]
    return worst


def _by_size(panels, xy, outline):
    """Yields (which, (k, s) nodes, (k, s, 2) corners relative to the first) of panels of s corners."""
    sizes = np.fromiter(map(len, panels), dtype=int, count=len(panels))
    for size in np.unique(sizes):
        of = np.flatnonzero(sizes == size)
        rings = np.array([panels[k] for k in of])
        at = xy[rings]
        yield of, rings, outline.offset(at - at[:, :1])


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
