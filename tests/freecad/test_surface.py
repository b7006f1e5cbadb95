# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces of every kind become nodes on the face, at equal arc lengths, welded where the face closes."""

import FreeCAD as App
import numpy as np
import Part
import pytest

import funicular as fn
from faces import FACES, collapsed_face, trimmed_faces, wave
from funicular import surface

every_face = pytest.mark.parametrize("kind", FACES)


def read(kind):
    make_face, closed_u, closed_v, poles = FACES[kind]
    face = make_face()
    return face.Faces[0], surface.read_face(face.Faces[0]), (closed_u, closed_v, poles)


def lattice_of(chart, cells_u, cells_v):
    return fn.lattice(
        cells_u, cells_v, closed_u=chart.closed_u, closed_v=chart.closed_v, poles=sorted(chart.poles)
    )


@every_face
def test_closed_directions_and_poles_are_recognised(kind):
    _, chart, expected = read(kind)
    assert (chart.closed_u, chart.closed_v, sorted(chart.poles)) == expected


@every_face
def test_nodes_lie_on_the_face(kind):
    face, chart, _ = read(kind)
    nodes = surface.sample(chart, lattice_of(chart, 13, 11).uv)
    for node in nodes:
        assert face.Surface.projectPoint(App.Vector(*node), "LowerDistance") < 1e-9 * chart.size


@every_face
def test_isolines_are_divided_into_equal_arc_lengths(kind):
    face, chart, _ = read(kind)
    if kind == "rectangle turned on its plane":
        corners = surface.sample(chart, [[0, 0], [1, 0], [1, 1], [0, 1]])
        uv = np.array([[0.25, 0.5], [0.7, 0.1]])
        expected = corners[0] + uv[:, :1] * (corners[1] - corners[0]) + uv[:, 1:] * (corners[3] - corners[0])
        np.testing.assert_allclose(surface.sample(chart, uv), expected, atol=1e-9 * chart.size)
        return
    # Of a face with more than a hundred waves the table, which is bounded, holds a few lines for each.
    within = 2e-5 if kind in ("egg crate", "wave") else 1e-6
    shares = np.array([[s, t] for s in (0.1, 0.35, 0.8) for t in (0.2, 0.5, 0.9)])
    nodes = surface.sample(chart, shares)
    u_first, u_last, v_first, v_last = face.ParameterRange
    for (s, t), node in zip(shares, nodes):
        u, v = face.Surface.parameter(App.Vector(*node))
        along_u, along_v = face.Surface.vIso(v), face.Surface.uIso(u)
        assert along_u.length(u_first, u) / along_u.length(u_first, u_last) == pytest.approx(s, abs=within)
        assert along_v.length(v_first, v) / along_v.length(v_first, v_last) == pytest.approx(t, abs=within)


def test_shares_that_the_table_gets_wrong_are_refused(monkeypatch):
    """What is measured along the isolines themselves decides, not the table."""
    monkeypatch.setattr(surface, "_knots", lambda surface: ((), ()))
    monkeypatch.setattr(surface, "MOST_POINTS", 0)
    chart = surface.read_face(wave().Faces[0])
    with pytest.raises(fn.InvalidInput, match="cannot be divided into equal lengths.*evenly spaced poles"):
        surface.sample(chart, lattice_of(chart, 13, 11).uv)


@every_face
def test_seams_and_poles_are_welded(kind):
    """Node counts, no two nodes in one place, and the Euler characteristic of the surface."""
    _, chart, (closed_u, closed_v, poles) = read(kind)
    lattice = lattice_of(chart, 12, 8)
    nodes = surface.sample(chart, lattice.uv)
    columns = 12 if closed_u else 13
    rows = 8 if closed_v else 9
    of_u = sum(pole.startswith("u") for pole in poles)
    of_v = sum(pole.startswith("v") for pole in poles)
    assert len(nodes) == (columns - of_u) * (rows - of_v) + of_u + of_v
    gaps = np.linalg.norm(nodes[:, None] - nodes[None], axis=2) + np.eye(len(nodes)) * chart.size
    assert gaps.min() > 1e-3 * chart.size
    characteristic = len(nodes) - len(lattice.members) + len(lattice.panels)
    assert characteristic == euler_characteristic(closed_u, closed_v, poles)


def euler_characteristic(closed_u, closed_v, poles):
    """Sphere 2, disc 1, band and torus 0."""
    if closed_u or closed_v:
        return len(poles)
    return 1


def test_a_sphere_has_its_poles_at_its_poles():
    chart = surface.read_face(Part.makeSphere(1000).Faces[0])
    lattice = lattice_of(chart, 8, 6)
    z = surface.sample(chart, lattice.uv)[:, 2]
    assert sorted(z)[0] == -1000.0 and sorted(z)[-1] == 1000.0
    assert np.count_nonzero(np.abs(z) > 999.0) == 2


def test_cells_are_the_mean_length_over_the_step():
    chart = surface.read_face(Part.makePlane(3000, 2000))
    assert surface.count_cells(chart, 300, 500) == (10, 4)
    assert surface.count_cells(chart, 3000, 2000) == (1, 1)
    assert surface.count_cells(chart, 290, 2000) == (10, 1)


def test_closed_directions_have_three_cells_at_least():
    chart = surface.read_face(Part.makeCylinder(1000, 3000).Faces[0])
    assert surface.count_cells(chart, 6000, 3000) == (3, 1)


def test_two_poles_have_two_cells_between_them():
    chart = surface.read_face(Part.makeSphere(1000).Faces[0])
    assert surface.count_cells(chart, 1000, 3000)[1] == 2


@pytest.mark.parametrize("step", [0.0, -5.0, float("nan")])
def test_a_step_of_nothing_is_refused(step):
    chart = surface.read_face(Part.makePlane(3000, 2000))
    with pytest.raises(fn.InvalidInput, match="StepV is .* mm: give a length greater than zero"):
        surface.count_cells(chart, 100, step)


def test_a_step_larger_than_the_face_is_refused():
    chart = surface.read_face(Part.makePlane(3000, 2000))
    with pytest.raises(fn.InvalidInput, match="StepV is 2001 mm.* measures 2000 mm: give a smaller step"):
        surface.count_cells(chart, 3000, 2001)


def test_a_slip_of_the_unit_is_refused_before_it_fills_the_memory():
    chart = surface.read_face(Part.makePlane(3000, 2000))
    with pytest.raises(fn.InvalidInput, match="30000 × 20000 cells.*give larger steps"):
        surface.count_cells(chart, 0.1, 0.1)


@pytest.mark.parametrize("kind", trimmed_faces())
def test_trimmed_faces_are_refused_with_a_way_out(kind):
    with pytest.raises(fn.InvalidInput, match="nets on several faces need whole ones: pick it alone"):
        surface.read_face(trimmed_faces()[kind])


def test_a_face_without_area_is_refused():
    with pytest.raises(fn.InvalidInput, match="has no area: pick a face that spans a surface"):
        surface.read_face(collapsed_face())


def test_an_endless_face_is_refused():
    with pytest.raises(fn.InvalidInput, match="is endless: pick a face with an outline"):
        surface.read_face(Part.Plane().toShape())


@pytest.mark.parametrize("shape", [None, Part.Shape(), Part.makeBox(1, 1, 1)])
def test_what_is_no_face_is_refused(shape):
    with pytest.raises(fn.InvalidInput, match="Source x is not a face: pick one face"):
        surface.read_face(shape, "Source x")


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e6])
def test_reading_does_not_depend_on_the_size(size):
    scaled = Part.makeSphere(size, App.Vector(), App.Vector(0, 0, 1), 30, 90, 360).Faces[0]
    unit = Part.makeSphere(1000, App.Vector(), App.Vector(0, 0, 1), 30, 90, 360).Faces[0]
    uv = [[0.2, 0.3], [0.5, 0.9], [0.0, 0.0]]
    points = surface.sample(surface.read_face(scaled), uv) / size
    np.testing.assert_allclose(points, surface.sample(surface.read_face(unit), uv) / 1000, atol=1e-9)
