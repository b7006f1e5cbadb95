# SPDX-License-Identifier: LGPL-2.1-or-later
"""Straight segments divided where they meet, and the panels of what they make: against exact fractions."""

from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st

import funicular as fn
from funicular import crossings, cycles, topology


def on_segment(point, a, b):
    cross = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])
    along = (point[0] - a[0]) * (b[0] - a[0]) + (point[1] - a[1]) * (b[1] - a[1])
    return cross == 0 and 0 <= along <= (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2


def exact_nodes(segments):
    """The points of each segment, exactly, where any other one crosses or touches it, and its ends."""
    nodes = [{tuple(map(Fraction, end)) for end in segment} for segment in segments]
    for i, j in combinations(range(len(segments)), 2):
        (a, b), (c, d) = segments[i], segments[j]
        nodes[i] |= {tuple(map(Fraction, end)) for end in (c, d) if on_segment(end, a, b)}
        nodes[j] |= {tuple(map(Fraction, end)) for end in (a, b) if on_segment(end, c, d)}
        turn = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])
        if turn:
            share = Fraction((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0]), turn)
            point = tuple(a[k] + share * (b[k] - a[k]) for k in (0, 1))
            if 0 <= share <= 1 and on_segment(point, c, d):
                nodes[i].add(point)
                nodes[j].add(point)
    return nodes


def rotated(points, turn):
    """(n, 3) of points in the plane, turned in space: rounding then has its way."""
    flat = np.column_stack([np.asarray(points, dtype=float), np.zeros(len(points))])
    return flat @ np.linalg.qr(np.random.default_rng(turn).normal(size=(3, 3)))[0]


def laid(segments, turn):
    """(points, (m, 2) node pairs, tolerance) of segments in the plane, each of two corners."""
    corners = sorted({corner for segment in segments for corner in segment})
    pairs = np.array([[corners.index(a), corners.index(b)] for a, b in segments])
    points = rotated(corners, turn)
    return points, pairs, 1e-6 * np.linalg.norm(np.ptp(points, axis=0))


@st.composite
def drawings(draw):
    corner = st.tuples(st.integers(0, 6), st.integers(0, 6))
    segments = draw(
        st.lists(st.tuples(corner, corner).filter(lambda ends: ends[0] != ends[1]), min_size=1, max_size=9)
    )
    return segments, draw(st.integers(0, 9))


@given(drawings())
def test_segments_have_nodes_where_exact_fractions_have_them(drawing):
    segments, turn = drawing
    points, pairs, tolerance = laid(segments, turn)
    nodes, chains = crossings.divided(points, pairs, tolerance)
    expected = exact_nodes(segments)
    assert len(nodes) == len(set().union(*expected))
    for segment, chain, of_segment in zip(segments, chains, expected):
        start = segment[0]
        along = sorted(of_segment, key=lambda p: (p[0] - start[0]) ** 2 + (p[1] - start[1]) ** 2)
        np.testing.assert_allclose(nodes[chain], rotated(along, turn), atol=tolerance)


@given(drawings())
def test_panels_of_a_drawing_are_the_faces_that_euler_counts(drawing):
    segments, turn = drawing
    nodes, chains = crossings.divided(*laid(segments, turn))
    members = np.unique([sorted(pair) for chain in chains for pair in zip(chain, chain[1:])], axis=0)
    assume(len(np.unique(topology.parts(len(nodes), members))) == 1)
    remarks = []
    panels = cycles.panels_of(nodes, members, remarks)
    twisted = [int(remark.split()[0]) for remark in remarks if "around something inside" in remark]
    assert len(panels) + sum(twisted) == len(members) - len(nodes) + 1
    fn.Net(nodes, members, panels)
    sides = [side for panel in panels for side in zip(panel, (*panel[1:], panel[0]))]
    assert len(set(sides)) == len(sides)


@given(
    st.integers(1, 80), st.integers(0, 99), st.sampled_from([0.02, 0.2, 2.0]), st.sampled_from([7, 10**6])
)
def test_boxes_overlap_as_comparing_each_with_each_says(count, seed, size, at_once):
    random = np.random.default_rng(seed)
    low = random.random((count, 3)).round(2)
    high = low + size * random.random((count, 3)).round(2)
    given_size, crossings.PAIRS_AT_ONCE = crossings.PAIRS_AT_ONCE, at_once
    try:
        found = [
            pair for i, j in crossings.overlapping_boxes(low, high) for pair in zip(i.tolist(), j.tolist())
        ]
    finally:
        crossings.PAIRS_AT_ONCE = given_size
    expected = [
        (i, j)
        for i, j in combinations(range(count), 2)
        if (low[i] <= high[j]).all() and (low[j] <= high[i]).all()
    ]
    assert sorted(found) == expected


def test_segments_that_pass_in_space_do_not_meet():
    points = np.array([[0, 0, 0], [1, 1, 0], [1, 0, 0.1], [0, 1, 0.1]], dtype=float)
    assert len(crossings.meetings(points, np.array([[0, 1], [2, 3]]), 0.09)) == 0
    met = crossings.meetings(points, np.array([[0, 1], [2, 3]]), 0.11)
    np.testing.assert_allclose(met.points, [[0.5, 0.5, 0.05]])
    np.testing.assert_allclose(met.shares, [[0.5, 0.5]])


@pytest.mark.parametrize(
    "pairs, count, expected", [([(0, 1), (3, 2), (1, 3)], 5, [0, 0, 0, 0, 4]), ([], 2, [0, 1])]
)
def test_parts_are_named_by_their_lowest(pairs, count, expected):
    assert topology.parts(count, pairs).tolist() == expected


@given(st.integers(1, 60), st.integers(0, 90), st.integers(0, 99))
def test_parts_are_those_of_joining_one_pair_after_the_other(count, joins, seed):
    pairs = np.random.default_rng(seed).integers(0, count, (joins, 2))
    label = list(range(count))
    for a, b in pairs.tolist():
        low, high = sorted((label[a], label[b]))
        label = [low if each == high else each for each in label]
    assert topology.parts(count, pairs).tolist() == label
