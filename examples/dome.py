# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dome over a circle of 20 m: a spherical cap made with Part, held all along its base.

Inside FreeCAD: run this file as a macro. Without a window: `make demo`.
"""

import math

import FreeCAD as App
import Part

from funicular.make import make_gridshell

SPAN = 20000.0
RISE = 5000.0


def build(doc):
    """Put the face, its net and the gridshell into a document, recompute it, return the gridshell."""
    radius = (SPAN**2 / 4 + RISE**2) / (2 * RISE)
    latitude = math.degrees(math.asin((radius - RISE) / radius))
    cap = Part.makeSphere(radius, App.Vector(), App.Vector(0, 0, 1), latitude, 90, 360).Faces[0]
    cap.translate(App.Vector(0, 0, RISE - radius))
    face = doc.addObject("Part::Feature", "Cap")
    face.Shape = cap
    shell = make_gridshell(
        doc,
        source=(face, ["Face1"]),
        # On average over the height: 32 cells around.
        StepU="1.07 m",
        StepV="1 m",
        MemberWeight="12 kg/m",
        CoveringWeight="30 kg/m^2",
        AxialStiffness="100 kN",
        SupportRecipe="Boundary",
    )
    shell.Label = "Dome"
    doc.recompute()
    return shell


if __name__ == "__main__":
    build(App.ActiveDocument or App.newDocument("Dome"))
