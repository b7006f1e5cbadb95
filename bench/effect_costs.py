# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a scene's effects cost, and what it is without each: effect_costs.py results.csv quick|full"""

import pathlib
import sys

from measuring import Rows

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "src" / "freecad_wb"))

import funicular as fn  # noqa: E402
from funicular.effect_costs import COLUMNS  # noqa: E402

SIDES = {"quick": 31, "full": 101}


def main(path, extent):
    side = SIDES[extent]
    net = fn.Net.grid(10.0, 10.0, 10.0 / (side - 1))
    effects = [
        fn.AxialStiffness(100e3),
        fn.MemberWeight(12.0),
        fn.CoveringWeight(30.0),
        fn.Snow(800.0),
        fn.PointLoad([len(net.nodes) // 2], (0, 0, -500.0)),
    ]
    rows = Rows(path, ("nodes", *COLUMNS))
    scene = fn.Scene(net, [fn.Fixed(net.border)], effects)
    fn.effect_study(scene, accuracy=1e-4, on_progress=lambda row: rows.add({"nodes": len(net.nodes), **row}))


if __name__ == "__main__":
    main(*sys.argv[1:])
