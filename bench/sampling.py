# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a net takes to be laid on faces of every kind, in headless FreeCAD.

    /usr/bin/python3 tools/freecad_run.py bench/sampling.py results.csv quick|full
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "src" / "freecad_wb"), str(ROOT / "examples")]

import Part  # noqa: E402
import roof  # noqa: E402
import sources  # noqa: E402
from funicular.features.source import Faces  # noqa: E402
from funicular.laying import Division, lay_on_face  # noqa: E402
from funicular.several_faces import lay_on_faces  # noqa: E402
from measuring import Rows, repeated  # noqa: E402

WANTED = {"quick": 1_000, "full": 10_000}
COLUMNS = ("face", "nodes", "members", "seconds", "first_seconds", "runs")


def nurbs_roof():
    rows, columns = len(roof.HEIGHTS) - 1, len(roof.HEIGHTS[0]) - 1
    surface = Part.BSplineSurface()
    surface.interpolate(
        [
            [
                sources.V(roof.LENGTH * i / rows, roof.WIDTH * j / columns, height)
                for j, height in enumerate(row)
            ]
            for i, row in enumerate(roof.HEIGHTS)
        ]
    )
    return surface.toShape()


SHAPES = {
    "plane": lambda: Part.makePlane(10000, 10000),
    "dome with its pole": lambda: Part.makeSphere(10000, sources.V(), sources.V(0, 0, 1), 0, 90, 360).Faces[
        0
    ],
    "NURBS roof": nurbs_roof,
    "plane with two holes": sources.plate_with_openings,
    "dome with two openings": sources.dome_with_oculus,
    "NURBS roof, cut by a curve": sources.cut_roof,
    "three faces, one net": sources.folded_vault,
}


def main(path, extent):
    rows = Rows(path, COLUMNS)
    for name, make in SHAPES.items():
        shape = make()
        # Square cells, each with about one node.
        step = (shape.Area / WANTED[extent]) ** 0.5
        names = tuple(f"Face{k + 1}" for k in range(len(shape.Faces)))

        def lay():
            division = Division(step, step)
            if len(names) == 1:
                return lay_on_face(shape.Faces[0], names[0], division)
            return lay_on_faces(Faces(tuple(shape.Faces), names, shape, ""), division)

        laid, first, seconds, runs = repeated(lay)
        rows.add(dict(zip(COLUMNS, (name, len(laid.nodes), len(laid.members), seconds, first, runs))))


if __name__ == "__main__":
    main(*sys.argv[1:])
