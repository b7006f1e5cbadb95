# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ground that a compass walks on: a chart made to reach past its borders, seams and smooth poles.

Lengths are millimetres. Numbers only: FreeCAD is behind the chart's `point(a, b)`.
"""

import math
from dataclasses import dataclass

import numpy as np

# Differences of the parameters, of which slopes are made.
SLOPE_DIFFERENCE = 1e-5
BORDER_DIFFERENCE = 1e-3

# Within this much of a smooth pole, in parameters, places are counted in the plane that is tangent to it.
CAP = 0.25


@dataclass(frozen=True)
class _Cap:
    """A smooth pole: the axis that runs round it, where the other axis has it, the sense of rotation that
    keeps (x, y) oriented as (a, b)."""

    around: int
    at: float
    sense: float

    def polar(self, uv):
        return np.abs(uv[:, 1 - self.around] - self.at), self.sense * 2.0 * np.pi * uv[:, self.around]

    def flat(self, uv):
        radius, turn = self.polar(uv)
        return np.stack([radius * np.cos(turn), radius * np.sin(turn)], axis=1)

    def uv(self, flat):
        found = np.empty_like(flat)
        found[:, self.around] = self.sense * np.arctan2(flat[:, 1], flat[:, 0]) / (2.0 * np.pi) % 1.0
        found[:, 1 - self.around] = np.abs(self.at - np.hypot(*flat.T))
        return found


_CAPS = {
    "u_min": _Cap(1, 0.0, 1.0),
    "u_max": _Cap(1, 1.0, -1.0),
    "v_min": _Cap(0, 0.0, -1.0),
    "v_max": _Cap(0, 1.0, 1.0),
}


class Ground:
    """A chart as the compass needs it. Places are (n, 2) parameters, of the unit square or beyond it.

    Around a closed direction parameters wrap. A smooth pole with the face all round it is a place like any
    other. Beyond an open border the face goes on along its tangents: nodes there are not on the face, but
    the way to a node may lead over them. Other poles are where the ground ends.
    """

    def __init__(self, chart):
        self.chart = chart
        self.closed = np.array([chart.closed_u, chart.closed_v])
        self.extent = np.array([chart.table.lengths_u.mean(), chart.table.lengths_v.mean()])
        self.caps = [_CAPS[side] for side in sorted(chart.poles) if self._is_smooth(_CAPS[side])]
        ends = {side for side in chart.poles if _CAPS[side] not in self.caps}
        self.low = np.array([0.0 if f"{axis}_min" in ends else -np.inf for axis in "uv"])
        self.high = np.array([1.0 if f"{axis}_max" in ends else np.inf for axis in "uv"])

    def at(self, uv):
        """(n, 3) points [mm]."""
        inner = np.minimum(np.maximum(uv, 0.0), 1.0)
        beyond = uv - inner
        out, axes = np.nonzero(beyond)
        if not len(out):
            return self.chart.point(inner[:, 0], inner[:, 1])
        # The slope at the border is that of a parabola through it and two points inside.
        inwards = np.zeros((len(out), 2))
        far = beyond[out, axes]
        inwards[np.arange(len(out)), axes] = -np.sign(far) * BORDER_DIFFERENCE
        points = self.chart.point(*np.vstack([inner, inner[out] + inwards, inner[out] + 2.0 * inwards]).T)
        points, first, second = np.split(points, [len(uv), len(uv) + len(out)])
        slope = (4.0 * first - 3.0 * points[out] - second) / (2.0 * inwards.sum(axis=1)[:, None])
        extended = points.copy()
        np.add.at(extended, out, far[:, None] * slope)
        return extended

    def moved(self, uv, by):
        """Places after a small move, which near a smooth pole is counted in the plane of the pole."""
        moved = uv + by
        for cap, near in self._near(uv):
            moved[near] = cap.uv(cap.flat(uv[near]) + by[near])
        if self.closed.any():
            moved[:, self.closed] %= 1.0
        return np.minimum(np.maximum(moved, self.low), self.high)

    def apart(self, uv, other):
        """(n, 2) the moves that lead from places to others, the short way round."""
        by = other - uv
        by[:, self.closed] -= by[:, self.closed].round()
        for cap, near in self._near(uv):
            by[near] = cap.flat(other[near]) - cap.flat(uv[near])
        return by

    def slopes(self, uv, points):
        """(n, 2, 3) derivatives of the point to the two moves [mm], of second order."""
        h = SLOPE_DIFFERENCE
        result = np.empty((len(uv), 2, 3))
        for axis in (0, 1):
            first, second = np.full(len(uv), h), np.full(len(uv), -h)
            if not self.closed[axis]:
                # Both on the inner side of a border, which has no curvature beyond.
                first[np.abs(uv[:, axis] - 1.0) < 2 * h] = -2 * h
                second[np.abs(uv[:, axis]) < 2 * h] = 2 * h
            both = np.zeros((2 * len(uv), 2))
            both[:, axis] = np.concatenate([first, second])
            there = self.at(self.moved(np.vstack([uv, uv]), both)) - np.vstack([points, points])
            weights = first * second * (second - first)
            result[:, axis] = second[:, None] ** 2 * there[: len(uv)] - first[:, None] ** 2 * there[len(uv) :]
            result[:, axis] /= weights[:, None]
        return result

    def frames(self, uv):
        """(n,) numbers that are equal where moves are counted alike."""
        return sum(
            (near * (number + 1) for number, (_, near) in enumerate(self._near(uv))), np.zeros(len(uv))
        )

    def along_u(self, uv, slopes):
        """(3,) direction in which u grows at one place; at a pole, the limit along its isoline."""
        for cap, near in self._near(uv):
            if near[0]:
                _, turn = cap.polar(uv)
                c, s = math.cos(turn[0]), math.sin(turn[0])
                inwards = 1.0 if cap.at == 0.0 else -1.0
                x, y = cap.sense * np.array([-s, c]) if cap.around == 0 else inwards * np.array([c, s])
                return x * slopes[0, 0] + y * slopes[0, 1]
        return slopes[0, 0]

    def beyond(self, uv, slopes):
        """(n,) how far places lie outside the face [mm]. slopes: (n, 2, 3) there [mm]."""
        return np.linalg.norm((uv - np.clip(uv, 0.0, 1.0))[:, :, None] * slopes, axis=2).sum(axis=1)

    def at_end(self, uv):
        """(n,) whether places lie at a pole where the ground ends."""
        return ((uv <= self.low + 1e-4) | (uv >= self.high - 1e-4)).any(axis=1)

    def _near(self, uv):
        return [(cap, cap.polar(uv)[0] < CAP) for cap in self.caps]

    def _is_smooth(self, cap):
        """Whether the face lies all round a pole and is flat there: a cone's apex is not."""
        if not self.closed[cap.around]:
            return False
        turns = np.arange(8) / 8.0
        ring, pole = np.empty((8, 2)), np.empty((8, 2))
        ring[:, cap.around] = pole[:, cap.around] = turns
        ring[:, 1 - cap.around], pole[:, 1 - cap.around] = abs(cap.at - 1e-4), cap.at
        spokes = self.chart.point(*ring.T) - self.chart.point(*pole.T)
        lengths = np.linalg.norm(spokes, axis=1, keepdims=True)
        if lengths.min() <= 1e-3 * lengths.max():
            return False
        spokes /= lengths
        return bool(np.abs(spokes[:4] + spokes[4:]).max() < 1e-2)
