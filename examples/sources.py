# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a gridshell can be made from, relaxed and drawn on one sheet. Needs FreeCAD, but no window.

    /usr/bin/python3 tools/freecad_run.py examples/sources.py build/gallery/sources.png
"""

import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "src" / "freecad_wb"), str(ROOT / "examples")]

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402

from gallery import sheet_of  # noqa: E402
from funicular.export import lattice_of  # noqa: E402
from funicular.make import make_gridshell, make_support  # noqa: E402

V = App.Vector


def plate_with_openings():
    plate = Part.makePlane(12000, 9000)
    for x, y, radius in ((3600, 3000, 1200), (8400, 5800, 1500)):
        plate = plate.cut(Part.makeCylinder(radius, 100, V(x, y, -50)))
    return plate.Faces[0]


def dome_with_oculus():
    dome = Part.makeSphere(6000, V(), V(0, 0, 1), 20, 90, 360).Faces[0]
    dome = dome.cut(Part.makeCylinder(1400, 9000, V(0.0, 0.0, 0.0)))
    return dome.cut(Part.makeCylinder(900, 9000, V(), V(0, -1, 0.45))).Faces[0]


def cut_roof():
    """A free-form face of which a curve leaves a part."""
    points = [
        [V(3000 * i, 2500 * j, 900 * math.sin(1.1 * i) + 700 * math.cos(1.7 * j + i)) for j in range(5)]
        for i in range(5)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    ellipse = Part.Ellipse(V(6000, 5000, 0), 5600, 4600).toShape()
    column = Part.Face(Part.Wire(ellipse)).extrude(V(0, 0, 9000))
    column.translate(V(0, 0, -4500))
    return surface.toShape().common(column).Faces[0]


def folded_vault():
    """Three faces of one shell, each tangent to none of the others."""
    lines = [V(0, 0, 0), V(2500, 0, 2600), V(7500, 0, 3400), V(11000, 0, 0)]
    return Part.makePolygon(lines).extrude(V(0, 9000, 0))


def mesh_of_hill(document):
    import Mesh
    import MeshPart

    cap = Part.makeSphere(9000, V(0, 0, -6000), V(0, 0, 1), 45, 90, 360).Faces[0]
    obj = document.addObject("Mesh::Feature", "Mesh")
    obj.Mesh = Mesh.Mesh(MeshPart.meshFromShape(Shape=cap, MaxLength=1300))
    return obj


def ribs():
    """Meridians and rings of a dome, as lines alone."""
    half = Part.Arc(V(6000, 0, 0), V(4243, 0, 3200), V(0, 0, 4500)).toShape()
    lines = []
    for number in range(16):
        line = half.copy()
        line.rotate(V(), V(0, 0, 1), 22.5 * number)
        lines.append(line)
    for share in (0.0, 0.3, 0.55, 0.8):
        at = half.valueAt(half.FirstParameter + share * (half.LastParameter - half.FirstParameter))
        lines.append(Part.makeCircle(at.x, V(0, 0, at.z)))
    return Part.Compound(lines)


def shells(document):
    """{title: Gridshell} of each kind of source."""

    def face(shape):
        obj = document.addObject("Part::Feature", "Source")
        obj.Shape = shape
        return obj

    stiff = {"AxialStiffness": "60 kN"}
    made = {
        "Face with openings": make_gridshell(
            document, face(plate_with_openings()), StepU="750 mm", StepV="750 mm", **stiff
        ),
        "Dome, oculus and side opening": make_gridshell(
            document, face(dome_with_oculus()), StepU="750 mm", StepV="750 mm", AxialStiffness="600 kN"
        ),
        "Roof cut by a curve, triangles": make_gridshell(
            document, face(cut_roof()), StepU="900 mm", StepV="900 mm", Pattern="Triangle", **stiff
        ),
        "Three faces, one net": make_gridshell(
            document, face(folded_vault()), StepU="800 mm", StepV="800 mm", AxialStiffness="200 kN"
        ),
        "Mesh, edge by edge": make_gridshell(document, mesh_of_hill(document), **stiff),
        "Lines alone": make_gridshell(document, face(ribs()), AxialStiffness="60 kN"),
        "Equal lengths": make_gridshell(
            document, face(cut_roof()), Laying="Equal lengths", StepU="750 mm", **stiff
        ),
        "Flat sheet on corners, opened": make_gridshell(
            document,
            Width="12 m",
            Depth="9 m",
            StepU="750 mm",
            StepV="750 mm",
            SupportRecipe="Corners",
            AxialStiffness="200 kN",
        ),
    }
    sheet = made["Flat sheet on corners, opened"]
    sheet.Net.RemovedPanels = [V(u, v, 0) for u in (0.47, 0.53) for v in (0.21, 0.29)]
    sheet.Net.RemovedMembers = [V(0.5, v, 0) for v in (0.21, 0.29)] + [V(u, 0.25, 0) for u in (0.47, 0.53)]
    make_support(
        document, sheet, Where="Edges and vertices", Elements=["Edge1"], Kind="On its vertical plane"
    )
    return made


def main(path):
    document = App.newDocument("Sources")
    made = shells(document)
    document.recompute()
    for title, shell in made.items():
        if shell.Status != "converged" or not shell.CompressionOnly:
            raise RuntimeError(f"{title}: {shell.Summary or shell.Net.getStatusString()}")
    sheet_of({title: lattice_of(shell) for title, shell in made.items()}, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
