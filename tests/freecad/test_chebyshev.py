# SPDX-License-Identifier: LGPL-2.1-or-later
"""Equal-length nets: members of one length on faces of every kind, against closed forms where known."""

import dataclasses
import math

import numpy as np
import Part
import pytest

import funicular as fn
from equal_length import check, corner_angles, node_at, number_at
from faces import FACES, V, spline
from funicular import surface
from funicular.chebyshev import equal_length_net

every_face = pytest.mark.parametrize("kind", FACES)
every_angle = pytest.mark.parametrize("angle", [0.0, 30.0, 45.0])


def read(kind):
    return surface.read_face(FACES[kind][0]().Faces[0])


def mean_side(chart):
    return math.sqrt(chart.table.lengths_u.mean() * chart.table.lengths_v.mean())


def sphere(radius=1000.0):
    return surface.read_face(Part.makeSphere(radius).Faces[0])


def saddle():
    """The hyperbolic paraboloid z = x y / 1000 over 2 m by 2 m, as a B-spline of degree one."""
    return spline(
        [[V(-1000, -1000, 1000), V(-1000, 1000, -1000)], [V(1000, -1000, -1000), V(1000, 1000, 1000)]], 1
    )


@every_angle
@every_face
def test_faces_of_every_kind_take_a_net_of_one_length(kind, angle):
    chart = read(kind)
    step = mean_side(chart) / 12.0
    net = equal_length_net(chart, step, start=(0.4, 0.55), angle=angle)
    check(net, chart, step)
    # The wave's waves are shorter than this step.
    assert len(net.panels) > (0 if kind == "wave" else 20)


def test_a_face_that_bends_too_much_within_a_step_is_refused():
    chart = read("wave")
    with pytest.raises(fn.InvalidInput, match="no whole cell.*give a smaller step.*and on ahead"):
        equal_length_net(chart, mean_side(chart) / 20.0, angle=30.0)


@pytest.mark.parametrize(
    "kind", ["B-spline", "half a cylinder", "twisted B-spline", "spherical cap", "placed"]
)
def test_a_start_off_centre_and_a_crossing_that_is_not_square(kind):
    chart = read(kind)
    step = mean_side(chart) / 20.0
    net = equal_length_net(chart, step, start=(0.2, 0.7), angle=20.0, crossing=60.0)
    check(net, chart, step)
    origin = node_at(net, 0, 0)
    np.testing.assert_allclose(
        origin, chart.point(np.array([0.2]), np.array([0.7]))[0], atol=1e-9 * chart.size
    )
    first, second = node_at(net, 1, 0) - origin, node_at(net, 0, 1) - origin
    assert math.degrees(math.acos(first @ second / step**2)) == pytest.approx(60.0, abs=3.0)
    # All but the cells that the border would cut.
    sheared = np.sin(np.radians(corner_angles(net)[:, 0])).sum() * step**2
    assert sheared > 0.8 * FACES[kind][0]().Faces[0].Area


@every_angle
def test_on_a_plane_it_is_the_square_lattice_and_fills_the_sheet(angle):
    chart = read("plane")
    net = equal_length_net(chart, 100.0, start=(0.5, 0.5), angle=angle)
    check(net, chart, 100.0)
    turn = math.radians(angle)
    axes = np.array([[math.cos(turn), math.sin(turn), 0.0], [-math.sin(turn), math.cos(turn), 0.0]])
    expected = node_at(net, 0, 0) + 100.0 * net.grid @ axes
    np.testing.assert_allclose(net.nodes, expected, atol=1e-7)
    # All lattice squares that lie on the sheet of 3 m by 2 m, counted apart from the net.
    places = np.stack(np.meshgrid(*[np.arange(-40, 41)] * 2, indexing="ij"), axis=-1)
    lattice = np.array([1500.0, 1000.0]) + 100.0 * places @ axes[:, :2]
    on_sheet = ((lattice > -1e-6) & (lattice < np.array([3000.0, 2000.0]) + 1e-6)).all(axis=2)
    whole = on_sheet[1:, 1:] & on_sheet[1:, :-1] & on_sheet[:-1, 1:] & on_sheet[:-1, :-1]
    assert len(net.panels) == whole.sum()
    assert net.stopped == ()
    assert len(net.rims) == 1


@pytest.mark.parametrize("crossing", [90.0, 60.0])
@every_angle
def test_on_a_cylinder_it_unrolls_to_a_lattice(angle, crossing):
    """A screw motion along the cylinder moves any chord to one of the same length."""
    chart, radius, step = read("cylinder"), 1000.0, 90.0
    net = equal_length_net(chart, step, start=(0.45, 0.5), angle=angle, crossing=crossing)
    check(net, chart, step)

    def chord(degrees):
        """(arc, rise) of the chord of the step's length that sets out in this direction."""
        along, up = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        low, high = 0.0, 1.0
        for _ in range(200):
            turn = 0.5 * (low + high)
            rise = radius * math.sin(turn) * up / along if along > 1e-12 else step
            if (2.0 * radius * math.sin(0.5 * turn)) ** 2 + rise**2 < step**2:
                low = turn
            else:
                high = turn
        return np.array([low * radius, rise])

    first = chord(angle)
    beyond = angle + crossing
    second = chord(beyond) if beyond <= 90.0 else chord(180.0 - beyond) * [-1.0, 1.0]
    unrolled = np.stack([radius * np.arctan2(net.nodes[:, 1], net.nodes[:, 0]), net.nodes[:, 2]], axis=1)
    off = unrolled - unrolled[number_at(net, 0, 0)] - net.grid @ np.array([first, second])
    # Once around is back again.
    off[:, 0] -= 2.0 * math.pi * radius * (off[:, 0] / (2.0 * math.pi * radius)).round()
    assert len(net.nodes) > 2000
    assert np.abs(off).max() < 1e-9 * 2.0 * math.pi * radius


@every_angle
def test_guides_stay_on_great_circles_of_a_sphere(angle):
    net = equal_length_net(sphere(), 50.0, start=(0.3, 0.4), angle=angle)
    for along in (0, 1):
        guide = net.nodes[net.grid[:, 1 - along] == 0]
        assert len(guide) > 50
        normal = np.linalg.svd(guide)[2][2]
        assert np.abs(guide @ normal).max() < 1e-6


def test_on_a_sphere_it_does_not_matter_where_it_begins():
    """Over poles and seams as anywhere else: start, pole and direction only turn the same net."""
    face = sphere()
    nets = [
        equal_length_net(face, 100.0, start=start, angle=angle)
        for start, angle in (((0.5, 0.5), 0.0), ((0.2, 0.3), 30.0), ((0.7, 1.0), 10.0), ((0.1, 0.99), 45.0))
    ]
    near = [net.grid[(np.abs(net.grid).sum(axis=1) < 24)] for net in nets]
    for net in nets[1:]:
        check(net, face, 100.0)
        for (i, j), (k, m) in (((12, 8), (-5, 3)), ((20, 2), (0, -20)), ((-9, -9), (9, 9))):
            first = np.linalg.norm(node_at(nets[0], i, j) - node_at(nets[0], k, m))
            assert np.linalg.norm(node_at(net, i, j) - node_at(net, k, m)) == pytest.approx(first, rel=1e-6)
    assert len({len(each) for each in near}) == 1


@pytest.mark.parametrize("step", [60.0, 150.0])
def test_panels_cover_no_point_of_a_sphere_twice(step):
    net = equal_length_net(sphere(), step, start=(0.5, 0.5), angle=45.0)
    rays = np.random.default_rng(1).normal(size=(3000, 3))
    corners = net.nodes[net.panels]
    covered = np.zeros(len(rays), dtype=int)
    for half in ((0, 1, 2), (0, 2, 3)):
        shares = np.linalg.inv(corners[:, half].transpose(0, 2, 1)) @ rays.T
        covered += (shares > 0.0).all(axis=1).sum(axis=0)
    assert covered.max() == 1
    assert covered.mean() > 0.8
    assert {stop.reason for stop in net.stopped} == {"shear", "overlap"}


def angle_of_directions(net, i, j):
    """The angle between the two directions at a node, from the chords over two steps [rad]."""
    first = node_at(net, i + 1, j) - node_at(net, i - 1, j)
    second = node_at(net, i, j + 1) - node_at(net, i, j - 1)
    return math.acos(first @ second / np.linalg.norm(first) / np.linalg.norm(second))


def spherical_area(net, n):
    """The solid angle of the cells from the start to (n, n), by their two triangles each."""
    total = 0.0
    for i in range(n):
        for j in range(n):
            p, q, r, s = (node_at(net, *at) for at in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            for a, b, c in ((p, q, r), (p, r, s)):
                a, b, c = (x / np.linalg.norm(x) for x in (a, b, c))
                total += 2.0 * math.atan2(a @ np.cross(b, c), 1.0 + a @ b + b @ c + c @ a)
    return total


def test_the_angles_of_a_quadrilateral_fall_short_by_the_curvature_in_it():
    """Hazzidakis: with w'uv = -K sin w, the interior angles sum up to 2 pi less the integral of K; on a
    sphere of radius 1 that is the area. Second order in the step."""
    errors = []
    for n in (8, 16):
        net = equal_length_net(sphere(), 800.0 / n)
        at = [angle_of_directions(net, *corner) for corner in ((0, 0), (n, 0), (n, n), (0, n))]
        total = at[0] + (math.pi - at[1]) + at[2] + (math.pi - at[3])
        errors.append(abs(2.0 * math.pi - total - spherical_area(net, n)))
    assert errors[0] < 0.02
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.3)


def sine_gordon(product):
    """The angle of the Chebyshev net of the unit sphere with square geodesic guides, at distances of this
    product along them: w(uv) with z w'' + w' = -sin w, w(0) = pi / 2 (Runge-Kutta from a series)."""
    z, count = 1e-6, 400
    state = np.array([0.5 * math.pi - z, -1.0])

    def rate(z, state):
        return np.array([state[1], -(math.sin(state[0]) + state[1]) / z])

    # Even steps in the logarithm of z, where the equation is not stiff.
    h = math.log(product / z) / count
    for _ in range(count):
        k1 = z * rate(z, state)
        k2 = z * math.exp(h / 2) * rate(z * math.exp(h / 2), state + h / 2 * k1)
        k3 = z * math.exp(h / 2) * rate(z * math.exp(h / 2), state + h / 2 * k2)
        k4 = z * math.exp(h) * rate(z * math.exp(h), state + h * k3)
        state, z = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), z * math.exp(h)
    return state[0]


def test_the_shear_on_a_sphere_is_that_of_the_sine_gordon_equation():
    errors = []
    for n in (8, 16):
        net = equal_length_net(sphere(), 800.0 / n)
        errors.append(abs(angle_of_directions(net, n, n) - sine_gordon(0.64)))
    assert errors[0] < 0.02
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.3)


@pytest.mark.parametrize("most_shear", [30.0, 60.0])
def test_it_stops_where_the_shear_is_known_to_reach_the_limit(most_shear):
    step = 40.0
    net = equal_length_net(sphere(), step, most_shear=most_shear)
    check(net, sphere(), step, most_shear)
    low, high = 1e-3, 3.0
    for _ in range(12):
        middle = 0.5 * (low + high)
        short = sine_gordon(middle) > math.radians(90.0 - most_shear)
        low, high = (middle, high) if short else (low, middle)
    expected = 1000.0 * math.sqrt(low) / step
    sheared = [stop for stop in net.stopped if stop.reason == "shear"]
    for si, sj in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        of_quadrant = [stop for stop in sheared if si * stop.grid[0] > 0 and sj * stop.grid[1] > 0]
        nearest = min(of_quadrant, key=lambda stop: abs(abs(stop.grid[0]) - abs(stop.grid[1])))
        reached = math.sqrt(abs(nearest.grid[0] * nearest.grid[1]))
        assert reached == pytest.approx(expected, abs=1.5)
        assert f"outside of {90 - most_shear:g}° to {90 + most_shear:g}°" in nearest.text
        assert np.linalg.norm(nearest.point) == pytest.approx(1000.0, rel=1e-9)
    assert any("too small or too large an angle" in remark for remark in net.remarks)


def test_a_saddle_opens_the_other_angles():
    """Negative curvature: interior angles sum up to more than 2 pi."""
    chart = surface.read_face(saddle())
    net = equal_length_net(chart, 100.0)
    check(net, chart, 100.0)
    for si, sj in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        at = angle_of_directions(net, 6 * si, 6 * sj)
        assert (at if si * sj > 0 else math.pi - at) > 0.5 * math.pi + 0.1
    # The rulings are straight lines and geodesics, and both guides run along them.
    guide = net.nodes[net.grid[:, 1] == 0]
    assert np.abs(guide[:, 1:] - guide[0, 1:]).max() < 1e-6


def test_around_a_cylinder_it_ends_where_it_began():
    chart, step = read("cylinder"), 200.0
    net = equal_length_net(chart, step, start=(0.1, 0.5))
    check(net, chart, step)
    turn = 2.0 * math.asin(0.5 * step / 1000.0)
    columns = int(np.ptp(net.grid[:, 0]))
    # No second time around, and not more than two columns short of once.
    assert 2.0 * math.pi - 2.0 * turn < columns * turn < 2.0 * math.pi
    assert {stop.reason for stop in net.stopped} == {"overlap"}
    assert any("does not overlap itself" in remark for remark in net.remarks)
    assert int(np.ptp(net.grid[:, 1])) == 14


def test_a_narrow_cylinder_is_not_wound_round_twice():
    chart = surface.read_face(Part.makeCylinder(1000, 20000).Faces[0])
    net = equal_length_net(chart, 1400.0, start=(0.3, 0.5))
    assert np.ptp(net.grid[:, 0]) * 2.0 * math.asin(0.7) < 2.0 * math.pi


def test_no_cell_encloses_the_apex_of_a_cone():
    """Unrolled, the cone is a sector: no panel may lie across its cut, and the net is a plane lattice."""
    chart, step = read("cone with its apex up"), 100.0
    net = equal_length_net(chart, step, start=(0.4, 0.2))
    check(net, chart, step)
    assert "pole" in {stop.reason for stop in net.stopped}
    around = np.diff(net.uv[np.column_stack([net.panels, net.panels[:, :1]])][:, :, 0], axis=1)
    assert np.abs((around - around.round()).sum(axis=1)).max() < 1e-9


def test_a_hole_is_left_out_and_walked_over():
    chart, step = read("plane"), 100.0

    def inside(a, b):
        return np.hypot(3000.0 * a - 2200.0, 2000.0 * b - 1000.0) > 350.0

    net = equal_length_net(chart, step, start=(0.3, 0.5), inside=inside)
    whole = equal_length_net(chart, step, start=(0.3, 0.5))
    check(net, chart, step)
    assert len(net.rims) == 2
    assert inside(*net.uv.T).all()
    assert len(whole.panels) > len(net.panels)
    beyond = net.nodes[:, 0] > 2700.0
    assert beyond.sum() == (whole.nodes[:, 0] > 2700.0).sum() > 0
    assert any("Cells are whole" in remark for remark in net.remarks)


def test_a_part_that_is_cut_off_is_left_out():
    chart = read("plane")
    net = equal_length_net(chart, 100.0, start=(0.2, 0.5), inside=lambda a, b: np.abs(a - 0.6) > 0.05)
    check(net, chart, 100.0)
    assert net.nodes[:, 0].max() < 1660.0
    assert any("no side joins" in remark for remark in net.remarks)


@pytest.mark.parametrize("kind", ["B-spline", "spherical cap", "half a cylinder"])
def test_a_net_stands_in_compression(kind):
    chart = read(kind)
    laid = equal_length_net(chart, mean_side(chart) / 15.0, angle=45.0)
    net = fn.Net(laid.nodes * 1e-3, laid.members, laid.panels)
    rim = np.unique(np.concatenate(laid.rims))
    assert set(rim.tolist()) == set(net.border.tolist())
    scene = fn.Scene(net, [fn.Fixed(rim)], [fn.AxialStiffness(1e5), fn.CoveringWeight(30.0)])
    result = fn.solve(scene)
    certificate = fn.certify(scene, result)
    assert result.status == "converged"
    assert certificate.compression_only
    assert result.position_error < 1e-3


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"step": 0.0}, "step is 0 mm: give a length greater than zero"),
        ({"step": -5.0}, "step is -5 mm: give a length greater than zero"),
        ({"step": math.nan}, "step is nan: give a length"),
        ({"step": 1e5}, "step is 100000 mm, larger than the face"),
        ({"step": 0.1}, "more than 250000: give a larger step"),
        ({"step": 2500.0}, "no whole cell of step = 2500 mm fits"),
        ({"start": (0.5, 1.2)}, r"start\[1\] is 1.2, outside the face"),
        ({"start": (math.nan, 0.2)}, r"start\[0\] is nan, outside the face"),
        ({"start": (0.5,)}, "two numbers"),
        ({"angle": math.inf}, "angle is inf: give degrees"),
        ({"crossing": 20.0}, "crossing is 20°, which most_shear = 60°.*from 30° to 150°"),
        ({"most_shear": 90.0}, "most_shear is 90°: give more than 0° and at most 80°"),
        ({"most_shear": 0.0}, "most_shear is 0°"),
        ({"inside": lambda a, b: a < 0.2}, "start .* is where the face is cut away"),
        ({"inside": lambda a, b: True}, "inside gave bool of shape"),
    ],
)
def test_what_does_not_do_is_refused_by_name(arguments, message):
    with pytest.raises(fn.InvalidInput, match=message):
        equal_length_net(read("plane"), **{"step": 100.0, **arguments})


def test_a_start_at_the_apex_of_a_cone_is_refused():
    with pytest.raises(fn.InvalidInput, match="has no tangent plane: start elsewhere"):
        equal_length_net(read("cone with its apex up"), 100.0, start=(0.5, 1.0))


def test_the_chart_is_asked_within_the_square_only():
    """Surfaces of FreeCAD may not be defined beyond it."""
    chart = read("twisted B-spline")

    def point(a, b):
        assert ((a >= 0.0) & (a <= 1.0) & (b >= 0.0) & (b <= 1.0)).all()
        return chart.point(a, b)

    net = equal_length_net(dataclasses.replace(chart, point=point), 200.0, start=(0.0, 0.5), angle=45.0)
    assert len(net.panels) > 50
