# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces of every kind that a net can lie on, by name: (face, closed u, closed v, poles)."""

import math

import FreeCAD as App
import Part

V = App.Vector


def bspline_roof():
    points = [
        [V(7500 * i, 5000 * j, 900 * math.sin(1.1 * i) + 700 * math.cos(1.7 * j + i)) for j in range(5)]
        for i in range(5)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface


def twisted_patch():
    poles = [
        [V(0, 0, 0), V(0, 1000, 0), V(0, 3000, 0)],
        [V(100, 0, 0), V(1200, 1300, 500), V(2000, 3000, 800)],
        [V(3000, 0, 0), V(3200, 2800, 0), V(3000, 3000, 0)],
    ]
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(poles, [3, 3], [3, 3], [0, 1], [0, 1], False, False, 2, 2)
    return surface


def arc(start, end):
    return Part.Arc(Part.Circle(V(0, 0, 0), V(0, 1, 0), 2000), start, end).toShape()


def bezier():
    curve = Part.BezierCurve()
    curve.setPoles([V(1000, 0, 0), V(2000, 0, 100), V(300, 0, 2000)])
    return curve.toShape()


def turned(face):
    face.Placement = App.Placement(V(1e6, -2e5, 3e4), App.Rotation(V(1, 2, 3), 50))
    return face


def reversed_sense(face):
    face.reverse()
    return face


def rectangle(*corners):
    return Part.Face(Part.makePolygon([V(*corner) for corner in (*corners, corners[0])]))


def triangular_patch():
    """A B-spline whose side u_min is one point, with no degenerated edge to say so."""
    surface = Part.BSplineSurface()
    poles = [[V(0, 0, 0), V(0, 0, 0)], [V(3000, 0, 500), V(2000, 2500, 800)]]
    surface.buildFromPolesMultsKnots(poles, [2, 2], [2, 2], [0, 1], [0, 1], False, False, 1, 1)
    return surface.toShape()


def spline(poles, degree):
    """A B-spline of these rows of poles, with even knots."""

    def knots(count):
        inner = count - degree - 1
        return [degree + 1] + [1] * inner + [degree + 1], list(range(inner + 2))

    surface = Part.BSplineSurface()
    (mults_u, knots_u), (mults_v, knots_v) = knots(len(poles)), knots(len(poles[0]))
    surface.buildFromPolesMultsKnots(poles, mults_u, mults_v, knots_u, knots_v, False, False, degree, degree)
    return surface.toShape()


def folded_plate():
    return spline([[V(1000 * i, 1000 * j, 700 * (i % 2)) for j in range(3)] for i in range(8)], 1)


def egg_crate():
    return spline([[V(200 * i, 200 * j, 300 * (-1) ** (i + j)) for j in range(60)] for i in range(60)], 3)


def wave():
    return spline([[V(100 * i, 1000 * j, 200 * (-1) ** i) for j in range(4)] for i in range(120)], 3)


OPEN = (False, False, [])
UP = V(0, 0, 1)

FACES = {
    "plane": (lambda: Part.makePlane(3000, 2000), *OPEN),
    "rectangle turned on its plane": (
        lambda: rectangle((0, 0, 0), (4000, 2000, 0), (3000, 4000, 0), (-1000, 2000, 0)),
        *OPEN,
    ),
    "cylinder": (lambda: Part.makeCylinder(1000, 3000).Faces[0], True, False, []),
    "half a cylinder": (lambda: Part.makeCylinder(1000, 3000, V(), UP, 180).Faces[0], *OPEN),
    "torus": (lambda: Part.makeTorus(3000, 1000).Faces[0], True, True, []),
    "sphere": (lambda: Part.makeSphere(1000).Faces[0], True, False, ["v_max", "v_min"]),
    "spherical cap": (
        lambda: Part.makeSphere(1000, V(), UP, 30, 90, 360).Faces[0],
        True,
        False,
        ["v_max"],
    ),
    "quarter of a spherical cap": (
        lambda: Part.makeSphere(1000, V(), UP, 30, 90, 90).Faces[0],
        False,
        False,
        ["v_max"],
    ),
    "cone with its apex up": (lambda: Part.makeCone(1000, 0, 2000).Faces[0], True, False, ["v_max"]),
    "cone with its apex down": (lambda: Part.makeCone(0, 1000, 2000).Faces[0], True, False, ["v_min"]),
    "B-spline": (lambda: bspline_roof().toShape(), *OPEN),
    "twisted B-spline": (lambda: twisted_patch().toShape(), *OPEN),
    "triangular B-spline": (triangular_patch, False, False, ["u_min"]),
    "folded plate": (folded_plate, *OPEN),
    "egg crate": (egg_crate, *OPEN),
    "wave": (wave, *OPEN),
    "extrusion": (lambda: arc(0, 2.5).extrude(V(0, 5000, 300)), *OPEN),
    "extrusion of a range below zero": (lambda: arc(-2.5, -0.5).extrude(V(0, -5000, 300)), *OPEN),
    "offset": (lambda: Part.OffsetSurface(bspline_roof(), 200).toShape(), *OPEN),
    "revolution": (lambda: bezier().revolve(V(), UP, 200).Faces[0], *OPEN),
    "full revolution": (lambda: bezier().revolve(V(), UP, 360).Faces[0], True, False, []),
    "ruled": (
        lambda: Part.makeRuledSurface(
            Part.makeLine(V(0, 0, 0), V(1000, 0, 0)), Part.makeLine(V(0, 1000, 500), V(1000, 2000, 0))
        ),
        *OPEN,
    ),
    "reversed": (lambda: reversed_sense(bspline_roof().toShape()), *OPEN),
    "placed": (lambda: turned(bspline_roof().toShape()), *OPEN),
}


def trimmed_faces():
    """Faces that do not fill the rectangle of their parameters."""
    plate = Part.makePlane(3000, 2000)
    slanted = Part.makeBox(9000, 9000, 9000, V(-4500, -4500, 2000), V(0.3, 0, 1))
    return {
        "hole": plate.cut(Part.makeCylinder(300, 10, V(1000, 1000, -5))).Faces[0],
        "triangle": rectangle((0, 0, 0), (1000, 500, 0), (500, 1500, 0)),
        "trapezium": rectangle((0, 0, 0), (4000, 0, 0), (3000, 1000, 0), (1000, 1000, 0)),
        "slanted cut": Part.makeCylinder(1000, 3000).cut(slanted).Faces[0],
        "disc": Part.makeCylinder(1000, 1000).Faces[1],
    }


def collapsed_face():
    """A B-spline patch whose poles all lie on one line: a face without area."""
    surface = Part.BSplineSurface()
    poles = [[V(0, 0, 0), V(1000, 0, 0)], [V(2000, 0, 0), V(3000, 0, 0)]]
    surface.buildFromPolesMultsKnots(poles, [2, 2], [2, 2], [0, 1], [0, 1], False, False, 1, 1)
    return surface.toShape()
