# SPDX-License-Identifier: LGPL-2.1-or-later
"""compas_fd: the force density method, one sparse linear solve by scipy."""

from compas_fd.solvers import fd_numpy

MODELS = ("force densities",)
ITERATES = False


def prepare(problem, model):
    """Lists, as its documentation has them; solve(tolerance, max_seconds) gives the shape."""
    data = {
        "vertices": problem.nodes.tolist(),
        "fixed": problem.fixed.tolist(),
        "edges": problem.members.tolist(),
        "forcedensities": problem.force_densities.tolist(),
        "loads": problem.loads.tolist(),
    }
    return lambda tolerance, max_seconds: fd_numpy(**data).vertices
