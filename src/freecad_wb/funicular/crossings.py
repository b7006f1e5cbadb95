# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where straight segments cross or touch without a common node, and their division there. Numpy only."""

from dataclasses import dataclass

import numpy as np

from . import topology

# Pairs of boxes that are looked at together: what bounds the memory.
PAIRS_AT_ONCE = 2_000_000

# Sine of an angle below which two segments have no crossing that could be told from their overlap.
PARALLEL = 1e-9


@dataclass(frozen=True)
class Meetings:
    """touched: (k,) segments inside which a node lies, share: (k,) how far along, node: (k,) that node.

    crossing: (c, 2) segments that cross inside, shares: (c, 2) how far along each, points: (c, 3) where.
    """

    touched: np.ndarray
    share: np.ndarray
    node: np.ndarray
    crossing: np.ndarray
    shares: np.ndarray
    points: np.ndarray

    def __len__(self):
        return len(self.touched) + len(self.crossing)


def overlapping_boxes(low, high):
    """Yields (i, j), arrays of the numbers of boxes that overlap, each pair once, some at a time.

    low, high: (n, 3) corners of the boxes.
    """
    best = None
    for axis in range(3):
        order = np.argsort(low[:, axis], kind="stable")
        last = np.searchsorted(low[order, axis], high[order, axis], side="right")
        following = last - np.arange(1, len(order) + 1)
        if best is None or following.sum() < best[1].sum():
            best = order, following
    order, following = best
    blocks = np.cumsum(following) // PAIRS_AT_ONCE
    for block in np.unique(blocks[following > 0]):
        rows = np.flatnonzero((blocks == block) & (following > 0))
        count = following[rows]
        i = np.repeat(rows, count)
        j = i + 1 + np.arange(len(i)) - np.repeat(np.cumsum(count) - count, count)
        i, j = order[i], order[j]
        overlap = ((low[i] <= high[j]) & (low[j] <= high[i])).all(axis=1)
        i, j = i[overlap], j[overlap]
        yield np.minimum(i, j), np.maximum(i, j)


def meetings(points, segments, tolerance):
    """The Meetings of segments that come within the tolerance of each other other than at common nodes.

    points: (n, 3), farther apart than the tolerance. segments: (m, 2) nodes.
    """
    ends = points[segments]
    low, high = ends.min(axis=1) - tolerance, ends.max(axis=1) + tolerance
    found = [_meetings_of(points, segments, i, j, tolerance) for i, j in overlapping_boxes(low, high)]
    if not found:
        none = np.zeros(0, dtype=np.int64)
        return Meetings(none, none + 0.0, none, np.zeros((0, 2), int), np.zeros((0, 2)), np.zeros((0, 3)))
    return Meetings(*(np.concatenate(parts) for parts in zip(*found)))


def _meetings_of(points, segments, i, j, tolerance):
    ends_touch = [_touches(points, segments, *pair, tolerance) for pair in ((i, j), (j, i))]
    touches = [touch for of_pair, _ in ends_touch for touch in of_pair]
    alone = ~(ends_touch[0][1] | ends_touch[1][1])
    alone &= (segments[i][:, :, None] != segments[j][:, None, :]).all(axis=(1, 2))
    i, j = i[alone], j[alone]

    begin = points[segments[i, 0]], points[segments[j, 0]]
    along = points[segments[i, 1]] - begin[0], points[segments[j, 1]] - begin[1]
    lengths = np.linalg.norm(along[0], axis=1), np.linalg.norm(along[1], axis=1)
    between = begin[0] - begin[1]
    normal = np.cross(*along)
    squared = (normal**2).sum(axis=1)
    apart = squared > (PARALLEL * lengths[0] * lengths[1]) ** 2
    squared = np.where(apart, squared, 1.0)
    # Feet of the common perpendicular of the two lines.
    s = (np.cross(along[1], between) * normal).sum(axis=1) / squared
    t = (np.cross(along[0], between) * normal).sum(axis=1) / squared
    at = begin[0] + s[:, None] * along[0], begin[1] + t[:, None] * along[1]
    meet = apart & (np.linalg.norm(at[0] - at[1], axis=1) <= tolerance)
    for share, length in ((s, lengths[0]), (t, lengths[1])):
        meet &= (share * length >= -tolerance) & ((1.0 - share) * length >= -tolerance)
    near = [_end_near(segments[k], p, n, tolerance) for k, p, n in ((i, s, lengths[0]), (j, t, lengths[1]))]
    for one, other, share in ((0, 1, t), (1, 0, s)):
        at_end = meet & (near[one] >= 0) & (near[other] < 0)
        touches.append(((j, i)[one][at_end], share[at_end], near[one][at_end]))
    meet &= (near[0] < 0) & (near[1] < 0)
    return (
        *(np.concatenate(part) for part in zip(*touches)),
        np.column_stack([i, j])[meet],
        np.column_stack([s, t])[meet],
        0.5 * (at[0] + at[1])[meet],
    )


def _touches(points, segments, i, j, tolerance):
    """Ends of segments j that lie inside segments i: [(segment, share, node), …], and in which pairs."""
    begin = points[segments[i, 0]]
    along = points[segments[i, 1]] - begin
    squared = (along**2).sum(axis=1)
    length = np.sqrt(squared)
    touches, hit = [], np.zeros(len(i), dtype=bool)
    for end in (0, 1):
        node = segments[j, end]
        offset = points[node] - begin
        share = (offset * along).sum(axis=1) / squared
        distance = np.linalg.norm(offset - share[:, None] * along, axis=1)
        inside = (distance <= tolerance) & (share * length > tolerance) & ((1.0 - share) * length > tolerance)
        inside &= (segments[i] != node[:, None]).all(axis=1)
        touches.append((i[inside], share[inside], node[inside]))
        hit |= inside
    return touches, hit


def _end_near(segments, share, length, tolerance):
    """The node at which a segment begins or ends where it meets another there, -1 where it does so inside."""
    at_begin, at_end = share * length <= 2.0 * tolerance, (1.0 - share) * length <= 2.0 * tolerance
    return np.where(at_begin, segments[:, 0], np.where(at_end, segments[:, 1], -1))


def divided(points, segments, tolerance):
    """(points, chains): segments with nodes wherever they meet.

    points: those given and after them the crossings, one where several segments cross. chains: for each
    segment its nodes in order, from its first end to its second.
    """
    met = meetings(points, segments, tolerance)
    everywhere = np.vstack([points, met.points])
    kept, number = topology.weld(everywhere, tolerance)
    new = number[len(points) :]
    count = len(segments)
    segment = np.concatenate([np.arange(count), np.arange(count), met.touched, met.crossing.T.ravel()])
    share = np.concatenate([np.zeros(count), np.ones(count), met.share, met.shares.T.ravel()])
    node = np.concatenate([number[segments.T.ravel()], number[met.node], new, new])
    order = np.lexsort((share, segment))
    segment, node = segment[order], node[order]
    fresh = np.append(True, (segment[1:] != segment[:-1]) | (node[1:] != node[:-1]))
    segment, node = segment[fresh], node[fresh]
    begin = np.searchsorted(segment, np.arange(count + 1)).tolist()
    node = node.tolist()
    return everywhere[kept], [node[begin[k] : begin[k + 1]] for k in range(count)]
