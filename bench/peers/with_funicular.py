# SPDX-License-Identifier: LGPL-2.1-or-later
"""Funicular, on the same arrays.

It knows springs only. Where force densities are given, it gets springs of EA 100 kN with the rest lengths
that pull as much at the lengths that another package found: the same equilibrium, of a problem that is no
longer linear.
"""

import pathlib
import sys

import numpy as np
from problem import SIDE, STIFFNESS, flat_net, lengths

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "src" / "freecad_wb"))

import funicular as fn  # noqa: E402

MODELS = ("force densities", "springs")
ITERATES = True


def prepare(problem, model, found=None):
    """The scene; solve(tolerance, max_seconds) gives the shape. found: the one for given force densities."""
    rest = np.full(len(problem.members), problem.step)
    if model == "force densities":
        length = lengths(problem, found)
        rest = STIFFNESS * length / (STIFFNESS + problem.force_densities * length)
    net = fn.Net(problem.nodes, problem.members, problem.panels)
    load = fn.PointLoad(problem.free, -problem.loads[problem.free[0]])
    spring = fn.AxialStiffness(STIFFNESS, compression_only=False)
    scene = fn.Scene(net, [fn.Fixed(problem.fixed)], [spring, load], rest_lengths=rest)

    def solve(tolerance, max_seconds):
        # As accurate as the net is wide: the residual alone decides.
        return fn.solve(scene, accuracy=SIDE, tolerance=tolerance, max_seconds=max_seconds).nodes

    return solve


if __name__ == "__main__":
    print(prepare(flat_net(11), "springs")(1e-6, 10.0)[:, 2].max())
