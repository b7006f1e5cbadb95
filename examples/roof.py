# SPDX-License-Identifier: LGPL-2.1-or-later
"""A free-form roof of 30 m by 20 m: a B-spline face on four corner supports, its borders in vertical planes.

Inside FreeCAD: run this file as a macro. Without a window: `make demo`.
"""

import FreeCAD as App
import Part

from funicular.make import make_gridshell

# Heights of the points that the face runs through [mm], row by row along x; corners on the ground.
HEIGHTS = (
    (0, 1400, 1900, 1500, 0),
    (1500, 3100, 3700, 3200, 1700),
    (2000, 3900, 4600, 4400, 2600),
    (1800, 3500, 4500, 4600, 3000),
    (1600, 3000, 3900, 3900, 2300),
    (0, 1500, 2200, 2100, 0),
)
LENGTH = 30000.0
WIDTH = 20000.0


def build(doc):
    """Put the face, its net and the gridshell into a document, recompute it, return the gridshell."""
    rows, columns = len(HEIGHTS) - 1, len(HEIGHTS[0]) - 1
    surface = Part.BSplineSurface()
    surface.interpolate(
        [
            [App.Vector(LENGTH * i / rows, WIDTH * j / columns, height) for j, height in enumerate(row)]
            for i, row in enumerate(HEIGHTS)
        ]
    )
    face = doc.addObject("Part::Feature", "Surface")
    face.Shape = surface.toShape()
    shell = make_gridshell(
        doc,
        source=(face, ["Face1"]),
        StepU="1 m",
        StepV="1 m",
        MemberWeight="12 kg/m",
        CoveringWeight="30 kg/m^2",
        AxialStiffness="800 kN",
        SupportRecipe="Corners and border planes",
    )
    shell.Label = "Roof"
    doc.recompute()
    return shell


if __name__ == "__main__":
    build(App.ActiveDocument or App.newDocument("Roof"))
