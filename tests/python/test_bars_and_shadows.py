# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn of a form, as figures in space: bars, convex panels, shadows on level ground."""

from collections import Counter

import numpy as np
import pytest

from funicular import bars, shadows
from funicular.form import Form
from funicular.panels import are_convex

SECTIONS = (bars.round_section(0.2, 8), bars.round_section(0.2, 6), bars.rectangular_section(0.1, 0.3))
# Level, inclined, vertical upwards and downwards, almost vertical, and without length.
NODES = np.array([[0, 0, 0], [2, 0, 0], [3, 4, 5], [3, 4, 9], [3, 4, 1], [3, 4 + 1e-9, 8], [0, 0, 0]], float)
MEMBERS = np.array([[0, 1], [1, 2], [2, 3], [2, 4], [2, 5], [0, 6]])


def area_of(section):
    x, y = section.T
    return 0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum()


@pytest.mark.parametrize("section", SECTIONS, ids=("octagon", "hexagon", "rectangle"))
def test_bars_are_closed_and_enclose_length_times_section(section):
    points = bars.bar_points(NODES, MEMBERS, section).reshape(len(MEMBERS), -1, 3)
    faces = bars.bar_faces(len(section))
    assert np.isfinite(points).all() and points.shape[1] == 2 * len(section)
    edges = Counter((a, b) for face in faces for a, b in zip(face, (*face[1:], face[0])))
    assert set(edges.values()) == {1}, "no edge is run along twice in one direction"
    assert all((b, a) in edges for a, b in edges), "each face has a neighbour along each edge"
    # By the divergence theorem: positive where faces look outwards.
    triangles = np.array([(face[0], a, b) for face in faces for a, b in zip(face[1:], face[2:])])
    a, b, c = (points[:, triangles[:, corner]] - points[:, :1] for corner in range(3))
    volumes = np.einsum("mti,mti->m", a, np.cross(b, c)) / 6.0
    lengths = np.linalg.norm(NODES[MEMBERS[:, 0]] - NODES[MEMBERS[:, 1]], axis=1)
    assert lengths[-1] == 0.0
    assert volumes == pytest.approx(lengths * area_of(section), abs=1e-9)


def test_a_rectangular_bar_is_level_across_and_high_in_its_vertical_plane():
    points = bars.bar_points(NODES, MEMBERS, bars.rectangular_section(0.1, 0.3))
    points = points.reshape(len(MEMBERS), 2, 4, 3)
    for member in (0, 1):
        bottom, top = points[member, 0, :2], points[member, 0, 2:]
        assert bottom[0, 2] == pytest.approx(bottom[1, 2]) and top[0, 2] == pytest.approx(top[1, 2])
        assert np.linalg.norm(bottom[1] - bottom[0]) == pytest.approx(0.1)
        assert top[0, 2] > bottom[0, 2]
        # Upwards: in the plane of the member and of the vertical, 0.3 along.
        upright = top[1] - bottom[0]
        along = NODES[MEMBERS[member, 1]] - NODES[MEMBERS[member, 0]]
        assert np.linalg.norm(upright) == pytest.approx(0.3) and upright @ along == pytest.approx(0.0)
        assert np.linalg.det([upright, along, (0.0, 0.0, 1.0)]) == pytest.approx(0.0, abs=1e-12)


def test_a_panel_with_a_corner_that_looks_inwards_is_not_convex():
    square, arrow = [(0, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), (2, 1), (0, 2), (0.5, 1)]
    halved = [(0, 0), (1, 0), (2, 0), (2, 2), (1, 2), (0, 2)]
    corners = np.array([*square, *arrow, *halved], dtype=float)
    panels = ((0, 1, 2, 3), (3, 2, 1, 0), (4, 5, 6, 7), (7, 6, 5, 4), (8, 9, 10, 11, 12, 13), (0, 1, 2))
    # Upright, aslant, and warped a little.
    for nodes in (
        np.column_stack([0 * corners[:, 0], corners]),
        corners @ np.array([[0.6, 0.0, 0.8], [0.1, 1.0, 0.3]]) + (5.0, -7.0, 11.0),
        np.column_stack([corners, 0.05 * corners[:, 0] * corners[:, 1]]),
    ):
        assert are_convex(nodes, panels).tolist() == [True, True, False, False, True, True]


@pytest.mark.parametrize(
    "azimuth, falls", [(0.0, (0, -1)), (90.0, (-1, 0)), (180.0, (0, 1)), (270.0, (1, 0))]
)
def test_a_pole_throws_its_shadow_away_from_the_sun(azimuth, falls):
    for altitude, length in ((45.0, 2.0), (30.0, 2.0 * 3.0**0.5), (90.0, 0.0)):
        sun = shadows.toward_sun(azimuth, altitude)
        top = shadows.shadows(np.array([[1.0, 2.0, 5.0]]), sun, level=3.0)[0]
        assert top == pytest.approx([1.0 + length * falls[0], 2.0 + length * falls[1], 3.0])


def test_a_sun_below_five_degrees_stays_there_and_the_ground_holds_all():
    assert (shadows.toward_sun(40.0, -20.0) == shadows.toward_sun(40.0, 5.0)).all()
    points = np.array([[0, 0, 0], [4, 0, 0], [4, 3, 2]], dtype=float)
    sun = shadows.toward_sun(225.0, 1.0)
    ground = shadows.ground_below(points, sun, 0.0)
    both = np.vstack([points, shadows.shadows(points, sun, 0.0)])
    assert (both[:, :2] > ground[0, :2]).all() and (both[:, :2] < ground[2, :2]).all()
    assert (ground[:, 2] == 0.0).all() and area_of(ground[:, :2]) > 0.0


def test_only_the_way_from_the_source_is_exaggerated():
    source = np.zeros((2, 3))
    nodes = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.1]])
    form = Form(nodes, source, np.array([[0, 1]]), (), np.zeros(1), np.zeros((2, 3)))
    assert form.drawn_nodes is nodes
    larger = Form(nodes, source, form.members, (), form.member_forces, form.reactions, exaggeration=5.0)
    assert larger.drawn_nodes[:, 2] == pytest.approx([0.0, 0.5])
    assert larger.member_lengths == pytest.approx([0.1]), "what is measured stays"
