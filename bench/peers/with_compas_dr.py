# SPDX-License-Identifier: LGPL-2.1-or-later
"""compas_dr: dynamic relaxation with viscous damping, by numpy."""

import time

import numpy as np
from compas_dr.numdata import InputData
from compas_dr.solvers import dr_numpy
from problem import STIFFNESS

MODELS = ("springs",)
ITERATES = True


class TimeIsUp(Exception):
    """Leaves the relaxation, which has a limit of steps but none of time."""


def prepare(problem, model):
    """Its input of lists; solve(tolerance, max_seconds) gives the shape, also one that is not there yet.

    What it compares with its tolerance is the norm of all residuals, which is no less than their largest. Its
    second criterion, small steps, is set to 0: it would end the relaxation wherever a swing turns.
    """
    count = len(problem.members)
    # An area of 1 mm² and E in kN/mm² stand for EA in its units; newtons throughout serve as well.
    data = {
        "edges": problem.members.tolist(),
        "fixed": problem.fixed.tolist(),
        "loads": problem.loads.tolist(),
        "qpre": [0.0] * count,
        "linit": [problem.step] * count,
        "E": [STIFFNESS] * count,
        "radius": [3.14159**-0.5] * count,
    }

    def solve(tolerance, max_seconds):
        shape = None
        end = time.process_time() + max_seconds

        def look(step, positions, left_over, moved, _):
            nonlocal shape
            shape = positions
            if time.process_time() > end:
                raise TimeIsUp

        try:
            # It works on its input's own arrays: each run has a new one.
            indata = InputData(vertices=problem.nodes.tolist(), **data)
            most = 10_000_000
            dr_numpy(indata=indata, kmax=most, tol1=tolerance * problem.loads.max(), tol2=0.0, callback=look)
        except TimeIsUp:
            pass
        return np.array(shape)

    return solve
