# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arc lengths along the isolines of a face, tabled, and the crossings of isolines at given shares of them.

Numbers only: knows nothing of FreeCAD.
"""

from dataclasses import dataclass

import numpy as np

# Lines of a table per direction, without knots. 192 intervals keep the fourth-order error of the table below
# 1e-6 of a cell on surfaces of ordinary curvature.
INTERVALS = 192
# Between two knots a cubic has to find its four points, and Richardson's extrapolation its pairs.
FEWEST = 4

# Shorter than this part of the longest isoline counts as no length at all.
NO_LENGTH = 1e-7


class Axis:
    """Where the lines of a table lie in [0, 1]: evenly between knots, beyond which nothing is smooth.

    knots: ascending, within (0, 1). fineness: the number of intervals as a multiple of the usual one.
    intervals: how many there are without knots; a flat face needs no more than the fewest.
    """

    def __init__(self, knots=(), fineness=1, intervals=INTERVALS):
        ends = np.array([0.0, *knots, 1.0])
        widths = np.diff(ends)
        counts = fineness * np.maximum(FEWEST, 2 * np.ceil(intervals * widths / 2 - 1e-9).astype(int))
        first = np.concatenate([[0], np.cumsum(counts)[:-1]])
        self.lines = np.concatenate(
            [*(np.linspace(a, b, n, endpoint=False) for a, b, n in zip(ends, ends[1:], counts)), [1.0]]
        )
        self._steps = np.repeat(widths / counts, counts)
        interval = np.arange(len(self._steps))
        first = np.repeat(first, counts)
        self._stencils = np.clip(interval - 1, first, first + np.repeat(counts, counts) - 3)

    def cell(self, parameter):
        """(interval, share of the interval before it) of parameters in [0, 1]."""
        index = np.clip(np.searchsorted(self.lines, parameter, side="right") - 1, 0, len(self._steps) - 1)
        return index, (parameter - self.lines[index]) / self._steps[index]

    def stencil(self, parameter):
        """(first of the four lines around, place among them in steps, step); none lies beyond a knot."""
        index, _ = self.cell(parameter)
        start = self._stencils[index]
        return start, (parameter - self.lines[start]) / self._steps[index], self._steps[index]


@dataclass(frozen=True)
class Table:
    """Shares of arc length over the unit square (a, b).

    axis_u, axis_v: the lines that the tables hold in a and in b.
    along_u, along_v: indexed [a, b]: the part of the isoline's length along u (along v) before (a, b).
    lengths_u, lengths_v: lengths of the isolines along u (one for each b) and along v (one for each a) [mm].
    """

    axis_u: Axis
    axis_v: Axis
    along_u: np.ndarray
    along_v: np.ndarray
    lengths_u: np.ndarray
    lengths_v: np.ndarray

    @classmethod
    def of(cls, axis_u, axis_v, points):
        """The table of a grid of points (k, l, 3), one for each pair of lines."""
        along_u, lengths_u = _shares(points)
        along_v, lengths_v = _shares(points.transpose(1, 0, 2))
        return cls(axis_u, axis_v, along_u, along_v.T, lengths_u, lengths_v)

    def shares(self, a, b):
        """(share along u, share along v) at points of the square."""
        return self._interpolate(self.along_u, a, b)[0], self._interpolate(self.along_v, a, b)[0]

    def crossings(self, s, t):
        """Parameters (a, b) where the share along u is s and the one along v is t, as near as it gets."""
        even = Axis()
        grid = even.lines
        lines_u, lines_v = self.axis_u.lines, self.axis_v.lines
        # Tables of a at (s, b) and of b at (a, t): a share grows along its isoline, so each inverts alone.
        a_of = np.array([np.interp(grid, column, lines_u) for column in self.along_u.T]).T
        b_of = np.array([np.interp(grid, row, lines_v) for row in self.along_v])
        a, b = s.copy(), t.copy()
        for turn in range(40):
            # On twisted faces the plain iteration may circle round the crossing; a mean of two does not.
            weight = 1.0 if turn < 10 else 0.5
            a_next = a + weight * (_bilinear(a_of, even, self.axis_v, s, b) - a)
            b_next = b + weight * (_bilinear(b_of, self.axis_u, even, a_next, t) - b)
            change = max(np.abs(a_next - a).max(), np.abs(b_next - b).max())
            a, b = a_next, b_next
            if change < 1e-5:
                break
        for _ in range(12):
            su, su_a, su_b = self._interpolate(self.along_u, a, b)
            sv, sv_a, sv_b = self._interpolate(self.along_v, a, b)
            determinant = su_a * sv_b - su_b * sv_a
            with np.errstate(divide="ignore", invalid="ignore"):
                da = np.nan_to_num(((su - s) * sv_b - (sv - t) * su_b) / determinant, posinf=0.0, neginf=0.0)
                db = np.nan_to_num(((sv - t) * su_a - (su - s) * sv_a) / determinant, posinf=0.0, neginf=0.0)
            a = np.clip(a - np.clip(da, -0.05, 0.05), 0.0, 1.0)
            b = np.clip(b - np.clip(db, -0.05, 0.05), 0.0, 1.0)
            if max(np.abs(da).max(), np.abs(db).max()) < 1e-12:
                break
        return a, b

    def _interpolate(self, values, a, b):
        """Bicubic (Lagrange, four points a side) value and derivatives to a and b."""
        i, x, step_a = self.axis_u.stencil(a)
        j, y, step_b = self.axis_v.stencil(b)
        offsets = np.arange(4)
        patch = values[i[:, None, None] + offsets[:, None], j[:, None, None] + offsets]
        wx, dx = _cubic_weights(x)
        wy, dy = _cubic_weights(y)
        along = np.einsum("nij,nj->ni", patch, wy)
        value = (along * wx).sum(axis=1)
        to_a = (along * dx).sum(axis=1) / step_a
        to_b = (np.einsum("nij,nj->ni", patch, dy) * wx).sum(axis=1) / step_b
        return value, to_a, to_b


def _shares(points):
    """Shares of arc length along axis 0 of a (k, k, 3) grid of points, and the length of each line.

    Chords fall short of arcs by the square of their size, so pairs of chords and the chord across them
    extrapolate (Richardson) to an error of fourth order.
    """
    chords = np.linalg.norm(np.diff(points, axis=0), axis=2)
    pairs = chords[0::2] + chords[1::2]
    across = np.linalg.norm(points[2::2] - points[:-2:2], axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        stretch = np.where(pairs > 0.0, (4.0 * pairs - across) / (3.0 * pairs), 1.0)
    chords *= np.repeat(stretch, 2, axis=0)
    passed = np.vstack([np.zeros(chords.shape[1]), np.cumsum(chords, axis=0)])
    lengths = passed[-1].copy()
    has_length = lengths > NO_LENGTH * lengths.max()
    shares = np.empty_like(passed)
    shares[:, has_length] = passed[:, has_length] / lengths[has_length]
    # A side without length (a pole) takes the limit of the lines next to it.
    inner = np.flatnonzero(has_length)
    for line in np.flatnonzero(~has_length):
        nearest = inner[np.argmin(np.abs(inner - line))]
        following = nearest + (1 if nearest > line else -1)
        shares[:, line] = 2.0 * shares[:, nearest] - shares[:, following]
    return shares, lengths


def _bilinear(table, axis_a, axis_b, a, b):
    i, x = axis_a.cell(a)
    j, y = axis_b.cell(b)
    low = table[i, j] * (1 - x) + table[i + 1, j] * x
    high = table[i, j + 1] * (1 - x) + table[i + 1, j + 1] * x
    return low * (1 - y) + high * y


def _cubic_weights(x):
    """Lagrange weights at the points 0, 1, 2, 3 and their derivatives: (n, 4) each."""
    p, q, r = x - 1.0, x - 2.0, x - 3.0
    weights = np.stack([-p * q * r / 6, x * q * r / 2, -x * p * r / 2, x * p * q / 6], axis=1)
    slopes = np.stack(
        [
            -(q * r + p * r + p * q) / 6,
            (q * r + x * r + x * q) / 2,
            -(p * r + x * r + x * p) / 2,
            (p * q + x * q + x * p) / 6,
        ],
        axis=1,
    )
    return weights, slopes
