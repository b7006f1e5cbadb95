# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the effects of a scene cost in a whole solve, as result.costs tells.

    effect_costs.py results.csv quick|full
"""

import pathlib
import statistics
import sys

from measuring import Rows, repeated

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "src" / "freecad_wb"))

import funicular as fn  # noqa: E402

SIDES = {"quick": 31, "full": 101}
COLUMNS = ("scene", "nodes", "effect", "evaluations", "seconds", "solve_seconds")


def main(path, extent):
    side = SIDES[extent]
    net = fn.Net.grid(10.0, 10.0, 10.0 / (side - 1))
    least = [fn.AxialStiffness(100e3), fn.MemberWeight(12.0)]
    middle = len(net.nodes) // 2
    scenes = {
        "members alone": least,
        "everything": [
            *least,
            fn.CoveringWeight(30.0),
            fn.Snow(800.0),
            fn.PointLoad([middle], (0, 0, -500.0)),
        ],
    }
    rows = Rows(path, COLUMNS)
    for name, effects in scenes.items():
        scene = fn.Scene(net, [fn.Fixed(net.border)], effects)
        results = []
        _, _, seconds, _ = repeated(lambda: results.append(fn.solve(scene, accuracy=1e-4)))
        if results[-1].status != "converged":
            raise RuntimeError(f"{name}: {results[-1].message}")
        for effect, (evaluations, _) in results[-1].costs.items():
            spent = statistics.median(result.costs[effect][1] for result in results)
            rows.add(dict(zip(COLUMNS, (name, len(net.nodes), effect, evaluations, spent, seconds))))


if __name__ == "__main__":
    main(*sys.argv[1:])
