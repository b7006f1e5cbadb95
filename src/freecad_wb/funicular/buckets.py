# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of a plane sorted into buckets, so that those near to others are found without trying all pairs.

Numbers only: knows nothing of FreeCAD.
"""

import numpy as np


class Buckets:
    """Points in buckets no smaller than 1 x 1.

    extent: (2,) size of the plane. period: (2,) after which it repeats, inf where it does not.
    points: (n, 2).
    """

    def __init__(self, extent, period, points):
        self._counts = np.maximum(1, np.asarray(extent).astype(int))
        self._widths = np.asarray(extent) / self._counts
        self._closed = np.isfinite(period)
        buckets = self._bucket(points)
        numbers = buckets[:, 0] * self._counts[1] + buckets[:, 1]
        self._order = np.argsort(numbers, kind="stable")
        self._numbers = numbers[self._order]

    def pairs(self, queries):
        """(query, point): all pairs that lie in one bucket or in two that touch.

        So none is missed that is nearer than 1. queries: (q, 2).
        """
        found = []
        home = self._bucket(queries)
        offsets = [range(-1, 2) if not c or n > 2 else range(n) for c, n in zip(self._closed, self._counts)]
        for i in offsets[0]:
            for j in offsets[1]:
                at = home + (i, j)
                at = np.where(self._closed, at % self._counts, at)
                there = np.flatnonzero(((at >= 0) & (at < self._counts)).all(axis=1))
                numbers = at[there, 0] * self._counts[1] + at[there, 1]
                first = np.searchsorted(self._numbers, numbers, side="left")
                counts = np.searchsorted(self._numbers, numbers, side="right") - first
                query = np.repeat(there, counts)
                within = np.arange(len(query)) - np.repeat(np.cumsum(counts) - counts, counts)
                found.append((query, self._order[np.repeat(first, counts) + within]))
        return tuple(np.concatenate(each) for each in zip(*found))

    def _bucket(self, points):
        bucket = np.floor(points / self._widths).astype(int)
        inner = np.clip(bucket, 0, self._counts - 1)
        return np.where(self._closed, bucket % self._counts, inner)
