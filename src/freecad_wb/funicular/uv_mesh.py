# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh seen as a face: its UV coordinates map a rectangle to its facets, and patterns can be laid on it.

The map is flat on each triangle, so that nodes lie on the facets themselves. Lengths are millimetres.
"""

import numpy as np

import funicular as fn

from . import surface
from .files import read_textured
from .wording import and_more

# In shares of the rectangle's sides: what files that write six digits leave between like corners.
SNAP = 2e-6

# Numbers whose squares and products can be counted with.
LARGEST = 1e60

# By how much the area in UV coordinates may differ from that of the rectangle: of what lies between corners
# that files round, but never of a facet.
FILLED = 1e-4

# How far apart, relative to the size of the mesh, two corners with the same (u, v) may be.
APART = 1e-6

# A query this near beyond the rectangle's border is meant to be on it.
NUDGE = 1e-9


def chart_of_uv(points, facets, uvs, corners, name):
    """(surface.Chart, area [mm²]) of a mesh whose UV coordinates fill a rectangle once.

    points: (n, 3) [mm]. facets: list of tuples of point numbers. uvs: (k, 2). corners: for each facet a tuple
    of numbers of uvs, None for a facet that has none. name: how errors call it. Where one side of the
    rectangle is mapped onto the other the chart closes, and a side that is one point is a pole.

    Raises InvalidInput that names the first facet for one without UV coordinates or turned over in them, for
    coordinates of points that lie apart, and for a rectangle that is not filled or filled twice.
    """
    if not len(uvs):
        raise fn.InvalidInput(
            f"{name} has no UV coordinates: unwrap it where it was made and write them into an .obj file "
            "(vt), or take the mesh as it is"
        )
    missing = [number for number, around in enumerate(corners) if around is None]
    if missing:
        raise fn.InvalidInput(
            f"{name}: facet {missing[0]}{and_more(len(missing) - 1)} has no UV coordinates: unwrap all "
            "of the mesh, or take it as it is"
        )
    if not facets:
        raise fn.InvalidInput(f"{name} has no facets: a pattern is laid over facets, not over lines")
    low, high = _bounds(uvs, corners)
    if max(np.abs(uvs).max(), np.abs(points).max()) > LARGEST:
        raise fn.InvalidInput(f"{name} has coordinates beyond {LARGEST:g}: scale it where it was made")
    if not (high > low).all():
        raise fn.InvalidInput(f"{name}: its UV coordinates all lie on a line: unwrap it anew")
    square = (uvs - low) / (high - low)
    for side in (0.0, 1.0):
        square[np.abs(square - side) < SNAP] = side
    triangles, of = _fans(facets)
    flat, _ = _fans(corners)
    keys, places, own = _welded(square, flat, points, triangles, name)
    _check_cover(places, keys, of, name)
    sides = own[keys[:, 1:]] - own[keys[:, :1]]
    area = 0.5 * float(np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum())
    # Rows of a regular mesh are where it bends; of another there are more than a table could hold.
    knots = [_inner(places[:, axis]) for axis in (0, 1)]
    return surface.make_chart(area, name, _Facets(places, keys, own), None, knots), area


def read_uv_mesh_file(path):
    """(points, facets, uvs, corners) of an .obj file in metres, for `chart_of_uv`; points in mm.

    Other formats have no uvs. Raises as mesh_source.read_mesh_file does.
    """
    try:
        vertices, faces, uvs, face_uvs = read_textured(path)
    except ValueError as error:
        raise fn.InvalidInput(str(error)) from error
    return vertices * 1e3, faces, uvs, face_uvs


class _Facets:
    """The map: (a, b) in the unit square -> (n, 3) points [mm]."""

    def __init__(self, places, triangles, points):
        # A well-kept point location; matplotlib takes its time to load.
        from matplotlib.tri import Triangulation

        self._places, self._triangles, self._points = places, triangles, points
        try:
            self._find = Triangulation(*places.T, triangles).get_trifinder()
        except (RuntimeError, ValueError):
            raise fn.InvalidInput(
                "facets overlap in the mesh's UV coordinates, or a corner of one lies within the edge of "
                "another: unwrap it anew, and join facets corner to corner"
            ) from None

    def __call__(self, a, b):
        at = np.column_stack([np.clip(a, 0.0, 1.0), np.clip(b, 0.0, 1.0)])
        found = self._find(*at.T)
        lost = found < 0
        if lost.any():
            inwards = NUDGE + (1.0 - 2.0 * NUDGE) * at[lost]
            found[lost] = self._find(*inwards.T)
        corners = self._triangles[np.maximum(found, 0)]
        first, along, across = (self._places[corners[:, k]] for k in range(3))
        along, across, to = along - first, across - first, at - first
        whole = along[:, 0] * across[:, 1] - along[:, 1] * across[:, 0]
        share_along = (to[:, 0] * across[:, 1] - to[:, 1] * across[:, 0]) / whole
        share_across = (along[:, 0] * to[:, 1] - along[:, 1] * to[:, 0]) / whole
        shares = np.column_stack([1.0 - share_along - share_across, share_along, share_across])
        points = np.einsum("nk,nkx->nx", shares, self._points[corners])
        points[found < 0] = np.nan
        return points


def _bounds(uvs, corners):
    used = uvs[np.unique(np.concatenate([np.asarray(around) for around in corners]))]
    return used.min(axis=0), used.max(axis=0)


def _fans(polygons):
    """((t, 3) triangles from the first corner of each polygon, (t,) the polygon that each is of)."""
    rows = [
        (polygon[0], b, c, number)
        for number, polygon in enumerate(polygons)
        for b, c in zip(polygon[1:], polygon[2:])
    ]
    rows = np.array(rows, dtype=np.int64).reshape(-1, 4)
    return rows[:, :3], rows[:, 3]


def _welded(square, flat, points, triangles, name):
    """(triangles, (k, 2) places, (k, 3) points) with one entry for each (u, v), whatever the file repeats."""
    rounded = np.round(square / SNAP).astype(np.int64)
    _, first, key = np.unique(rounded, axis=0, return_index=True, return_inverse=True)
    keys = key.reshape(-1)[flat]
    own = np.empty(len(first), dtype=np.int64)
    own[keys.ravel()] = triangles.ravel()
    size = np.linalg.norm(np.ptp(points, axis=0))
    apart = np.linalg.norm(points[own[keys]] - points[triangles], axis=2) > APART * size
    if apart.any():
        at = tuple(np.argwhere(apart)[0])
        u, v = square[first[keys[at]]]
        raise fn.InvalidInput(
            f"{name}: vertices {own[keys[at]]} and {triangles[at]} lie apart but both have the UV "
            f"coordinates ({u:.4g}, {v:.4g}): unwrap it without parts that lie on one another"
        )
    return keys, square[first], points[own]


def _check_cover(places, keys, of, name):
    """Raises unless the triangles fill the unit square once."""
    along, across = places[keys[:, 1]] - places[keys[:, 0]], places[keys[:, 2]] - places[keys[:, 0]]
    doubled = along[:, 0] * across[:, 1] - along[:, 1] * across[:, 0]
    if doubled.sum() < 0.0:
        doubled = -doubled
    over = np.flatnonzero(doubled <= 0.0)
    if len(over):
        raise fn.InvalidInput(
            f"{name}: facet {of[over[0]]}{and_more(len(np.unique(of[over])) - 1)} is turned over or empty "
            "in its UV coordinates: unwrap it without folds, in convex facets"
        )
    filled = 0.5 * doubled.sum()
    if abs(filled - 1.0) > min(FILLED, 0.25 * doubled.min()):
        missing = 100.0 * (1.0 - filled)
        what = "overlap" if filled > 1.0 else f"leave {missing:.3g} % of the rectangle they lie in empty"
        raise fn.InvalidInput(
            f"{name}: its UV coordinates {what}: unwrap it so that they fill a rectangle once, or take the "
            "mesh as it is"
        )


def _inner(values):
    inner = np.unique(values)[1:-1]
    return inner if len(inner) <= surface.MOST_KNOTS else np.zeros(0)
