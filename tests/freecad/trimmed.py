# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trimmed faces of every kind that a net can lie on, by name: (face, openings, handles)."""

import FreeCAD as App
import Part

from faces import UP, V, bspline_roof, rectangle


def face_of(shape, kind):
    """The largest face of a shape on a surface of this kind."""
    return max((face for face in shape.Faces if isinstance(face.Surface, kind)), key=lambda face: face.Area)


def drill(radius, base, direction=UP, length=20000):
    return Part.makeCylinder(radius, length, base, direction)


def plate_with_two_holes():
    plate = Part.makePlane(6000, 4000)
    return plate.cut(drill(700, V(1700, 1500, -5))).cut(drill(900, V(4200, 2300, -5))).Faces[0]


def ell():
    corners = [(0, 0), (5000, 0), (5000, 2100), (2300, 2100), (2300, 4700), (0, 4700)]
    return rectangle(*((x, y, 0) for x, y in corners))


def disc():
    return Part.Face(Part.Wire([Part.makeCircle(2500)]))


def annulus():
    return disc().cut(drill(900, V(0, 0, -5))).Faces[0]


def triangle():
    return rectangle((0, 0, 0), (6000, 0, 0), (2500, 4800, 0))


def plate_with_a_turned_opening():
    opening = rectangle((2000, 1300, 0), (3500, 800, 0), (4200, 2400, 0), (2600, 2900, 0))
    return Part.makePlane(6000, 4000).cut(opening).Faces[0]


def oblique_half_cylinder():
    above = Part.makeBox(19000, 19000, 9000, V(-9500, -9500, 0))
    above.Placement = App.Placement(V(0, 0, 4200), App.Rotation(V(1, 2, 0), 17))
    return Part.makeCylinder(2000, 6000, V(), UP, 180).Faces[0].cut(above).Faces[0]


def cylinder_with_a_hole_on_its_seam():
    return face_of(Part.makeCylinder(2000, 6000).cut(drill(800, V(0, 0, 3000), V(1, 0, 0))), Part.Cylinder)


def dome(*drills):
    sphere = Part.makeSphere(5000, V(), UP, 10, 90, 360).Faces[0]
    for each in drills:
        sphere = sphere.cut(each)
    return face_of(sphere, Part.Sphere)


def dome_with_an_oculus():
    return dome(drill(900, V()), drill(800, V(0, 0, 2600), V(1, 0.3, 0)))


def dome_with_its_pole():
    return dome(drill(1200, V(1700, 500, 0)))


def torus_with_a_hole():
    return face_of(Part.makeTorus(4000, 1500).cut(drill(700, V(4000, 0, 0), V(0.3, 0.2, 1))), Part.Toroid)


def torus_with_a_hole_on_its_seams():
    return face_of(Part.makeTorus(4000, 1500).cut(drill(800, V(3000, 0, 0), V(1, 0, 0))), Part.Toroid)


def roof():
    return bspline_roof().toShape().common(drill(9000, V(15000, 10000, -20000), UP, 40000)).Faces[0]


TRIMMED = {
    "plate with two holes": (plate_with_two_holes, 2, 0),
    "L": (ell, 0, 0),
    "disc": (disc, 0, 0),
    "annulus": (annulus, 1, 0),
    "triangle": (triangle, 0, 0),
    "plate with a turned opening": (plate_with_a_turned_opening, 1, 0),
    "oblique half cylinder": (oblique_half_cylinder, 0, 0),
    "cylinder with a hole on its seam": (cylinder_with_a_hole_on_its_seam, 2, 0),
    "dome with an oculus": (dome_with_an_oculus, 2, 0),
    "dome with its pole": (dome_with_its_pole, 1, 0),
    "torus with a hole": (torus_with_a_hole, 0, 1),
    "torus with a hole on its seams": (torus_with_a_hole_on_its_seams, 0, 1),
    "roof": (roof, 0, 0),
}
