# SPDX-License-Identifier: LGPL-2.1-or-later
"""compas_shapeop: ShapeOp's projections, whose edge strain of weight EA is a spring's energy.

It has loads in its dynamic mode alone, so that the net swings until it stands. In every step of time it
projects so many times, and what one step leaves undone remains in the shape that it comes to rest in: a
smaller residual takes more projections a step. Supports are held by stiff springs.
"""

import math
import time

import numpy as np
from compas_shapeop.shapeop import Solver
from problem import STIFFNESS, residual

MODELS = ("springs",)
ITERATES = True

SUPPORT = 1e7  # times EA
PROJECTIONS = 14  # a step, for each digit: measured on the smallest net
DAMPING = 0.1
LOOK_EVERY = 20  # steps


def prepare(problem, model):
    """solve(tolerance, max_seconds) gives the shape, also one that is not there yet; it makes a solver anew,
    as ShapeOp cannot be set back."""

    def solve(tolerance, max_seconds):
        end = time.process_time() + max_seconds
        solver = Solver()
        solver.points = problem.nodes
        for node in problem.fixed.tolist():
            solver.add_closeness_constraint(node, SUPPORT * STIFFNESS)
        for first, second in problem.members.tolist():
            solver.add_edge_strain_constraint(first, second, STIFFNESS, 1.0, 1.0)
        for node in problem.free.tolist():
            solver.add_vertex_force(node, *problem.loads[node])
        # Inertia as large as a member's stiffness, with masses of 1.
        solver.init(dynamic=True, masses=1.0, damping=DAMPING, timestep=math.sqrt(problem.step / STIFFNESS))
        projections = math.ceil(-math.log10(tolerance) * PROJECTIONS)
        while True:
            for _ in range(LOOK_EVERY):
                solver.solve(projections)
            shape = np.array(solver.points)
            if time.process_time() > end or residual(problem, model, shape) <= tolerance:
                return shape

    return solve
