# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where things of a 3D view lie on the screen, and which of them the pointer is on."""

import FreeCADGui
import numpy as np

# Of a line of sight, squared: the level part below which heights cannot be told from it.
STEEPEST = 1e-2
REACH = 12.0  # [px] from the pointer to what it is taken to mean


def size_of(view):
    """(width, height) of a 3D view in its widget's points, which may not be the pixels of its screen."""
    ratio = FreeCADGui.getMainWindow().devicePixelRatioF()
    width, height = view.getSize()
    return width / ratio, height / ratio


class OnScreen:
    """A 3D view as it now looks at points of a gridshell.

    Parameters
    ----------
    view : FreeCADGui 3D view
    placement : FreeCAD.Placement
        Of what the points belong to, in the document.
    """

    def __init__(self, view, placement=None):
        width, height = view.getSize()
        volume = view.getCameraNode().getViewVolume(width / height)
        # As coin multiplies: rows, from the left.
        self._matrix = np.array(volume.getMatrix().getValue())
        if placement is not None:
            # FreeCAD multiplies columns, from the right.
            self._matrix = np.array(placement.toMatrix().A).reshape(4, 4).T @ self._matrix
        self._size = np.array(size_of(view))

    def of(self, points):
        """(n, 2) places in the widget, from its upper left corner, of points (n, 3) [mm]; and (n,) depths."""
        homogeneous = np.column_stack([points, np.ones(len(points))]) @ self._matrix
        w = np.where(np.abs(homogeneous[:, 3]) < 1e-300, 1e-300, homogeneous[:, 3])
        x, y, depth = (homogeneous[:, :3] / w[:, None]).T
        return np.column_stack([0.5 + 0.5 * x, 0.5 - 0.5 * y]) * self._size, depth

    def ray(self, at):
        """(point, unit direction) [mm] of what is seen below the place `at` (x, y) of the widget."""
        share = np.asarray(at, dtype=float) / self._size
        x, y = 2.0 * share[0] - 1.0, 1.0 - 2.0 * share[1]
        ends = np.array([[x, y, -1.0, 1.0], [x, y, 1.0, 1.0]]) @ np.linalg.inv(self._matrix)
        near, far = ends[:, :3] / ends[:, 3:]
        return near, (far - near) / np.linalg.norm(far - near)

    def height_at(self, point, at):
        """Height above `point` (3,) [mm] at which the vertical through it is nearest to the place `at`.

        None where the vertical is seen from above, or as good as that.
        """
        origin, direction = self.ray(at)
        level = 1.0 - direction[2] ** 2
        if level < STEEPEST:
            return None
        away = origin - point
        return float((away[2] - direction[2] * (direction @ away)) / level)

    def length_of(self, points, members):
        """Median length [px] of members (m, 2), of a few dozen if there are more."""
        some = members[:: max(1, len(members) // 50)]
        places, _ = self.of(points[some.ravel()])
        return float(np.median(np.linalg.norm(places[::2] - places[1::2], axis=1))) if len(some) else 0.0

    def nearest_node(self, points, at, reach=REACH):
        """Number of the point (n, 3) [mm] that `at` (x, y) is on, the foremost of several; None for none."""
        places, depth = self.of(points)
        away = np.linalg.norm(places - at, axis=1)
        near = np.flatnonzero(away <= reach)
        if not len(near):
            return None
        # Of those about as near, the one in front.
        near = near[away[near] <= away[near].min() + 2.0]
        return int(near[np.argmin(depth[near])])

    def nearest_member(self, points, members, at, reach=REACH / 2):
        """Number of the member (m, 2) that `at` is on, the foremost of several; None for none."""
        places, depth = self.of(points)
        begin, end = places[members[:, 0]], places[members[:, 1]]
        along = end - begin
        squared = np.maximum((along**2).sum(axis=1), 1e-12)
        share = np.clip(((at - begin) * along).sum(axis=1) / squared, 0.0, 1.0)
        away = np.linalg.norm(begin + share[:, None] * along - at, axis=1)
        near = np.flatnonzero(away <= reach)
        if not len(near):
            return None
        near = near[away[near] <= away[near].min() + 1.0]
        first, second = depth[members[near, 0]], depth[members[near, 1]]
        return int(near[np.argmin(first + share[near] * (second - first))])

    def inside(self, points, outline):
        """Numbers of the points (n, 3) [mm] within a closed outline (k, 2) on the screen."""
        places, _ = self.of(points)
        odd = np.zeros(len(places), dtype=bool)
        for (x0, y0), (x1, y1) in zip(outline, np.roll(outline, -1, axis=0)):
            if y0 == y1:
                continue
            crosses = (places[:, 1] < y0) != (places[:, 1] < y1)
            at = x0 + (places[:, 1] - y0) * (x1 - x0) / (y1 - y0)
            odd ^= crosses & (places[:, 0] < at)
        return np.flatnonzero(odd)
