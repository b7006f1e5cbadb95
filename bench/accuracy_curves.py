# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs, on three scenes and by every method: accuracy_curves.py results.csv quick|full"""

import pathlib
import sys

import numpy as np
from measuring import Rows

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "src" / "freecad_wb"))

import funicular as fn  # noqa: E402
from funicular.accuracy import COLUMNS  # noqa: E402

# (cells a side of the sheets, cells of the dome from base to top, the longest solve [s])
EXTENTS = {"quick": (10, 5, 5.0), "full": (30, 15, 60.0)}


def sheet(cells, held):
    net = fn.Net.grid(10.0, 10.0, 10.0 / cells)
    nodes = net.border if held == "border" else net.lattice.corners
    effects = [fn.AxialStiffness(100e3), fn.MemberWeight(12.0), fn.CoveringWeight(30.0)]
    return fn.Scene(net, [fn.Fixed(nodes)], effects)


def dome(cells):
    """A hemisphere of 10 m radius; stiff, as the hoops of a soft one sag into another shape."""
    lattice = fn.lattice(4 * cells, cells, closed_u=True, poles=["v_max"])
    turn, height = 2 * np.pi * lattice.uv[:, 0], np.pi / 2 * lattice.uv[:, 1]
    nodes = 10 * np.column_stack(
        [np.cos(height) * np.cos(turn), np.cos(height) * np.sin(turn), np.sin(height)]
    )
    net = lattice.net(nodes)
    effects = [fn.AxialStiffness(100e6), fn.MemberWeight(25.0), fn.CoveringWeight(50.0)]
    return fn.Scene(net, [fn.Fixed(net.border)], effects)


def main(path, extent):
    cells, rings, most_seconds = EXTENTS[extent]
    scenes = {
        "flat, border fixed": sheet(cells, "border"),
        "flat, four corners": sheet(cells, "corners"),
        "steel dome": dome(rings),
    }
    rows = Rows(path, ("scene", "nodes", *COLUMNS))
    for name, scene in scenes.items():
        place = {"scene": name, "nodes": len(scene.net.nodes)}
        fn.accuracy_study(
            scene,
            on_progress=lambda row: rows.add({**place, **row}),
            max_seconds=most_seconds,
            coarser=0,
        )


if __name__ == "__main__":
    main(*sys.argv[1:])
