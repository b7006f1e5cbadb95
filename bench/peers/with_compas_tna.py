# SPDX-License-Identifier: LGPL-2.1-or-later
"""compas_tna: thrust network analysis. Heights alone are found, over a plan that stays as it is."""

import numpy as np
from compas_tna.diagrams import FormDiagram
from compas_tna.equilibrium import vertical_from_q

MODELS = ("force densities",)
ITERATES = False


def prepare(problem, model):
    """A form diagram with its force densities; no self-weight; solve(tolerance, max_seconds) gives the shape.

    With equal force densities this plan is in horizontal equilibrium, so that no force diagram is needed.
    """
    form = FormDiagram.from_vertices_and_faces(problem.nodes.tolist(), problem.panels.tolist())
    form.vertices_attribute("is_support", True, keys=problem.fixed.tolist())
    form.edges_attribute("q", float(problem.force_densities[0]))
    for vertex, load in enumerate(problem.loads.tolist()):
        form.vertex_attributes(vertex, ("px", "py", "pz"), load)
    flat = problem.nodes[:, 2].tolist()

    def solve(tolerance, max_seconds):
        for vertex, height in enumerate(flat):
            form.vertex_attribute(vertex, "z", height)
        vertical_from_q(form, density=0.0, tol=tolerance * float(problem.loads.max()))
        return np.array(form.vertices_attributes("xyz"))

    return solve
