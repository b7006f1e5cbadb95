# SPDX-License-Identifier: LGPL-2.1-or-later
"""jax_fdm: the force density method, differentiable; its sparse model, compiled by the first solve."""

import equinox
import jax.numpy as jnp
import numpy as np
from jax_fdm.equilibrium import EquilibriumModelSparse, EquilibriumParametersState, EquilibriumStructureSparse
from jax_fdm.equilibrium import LoadState

MODELS = ("force densities",)
ITERATES = False


def prepare(problem, model):
    """Its structure and parameters of arrays; solve(tolerance, max_seconds) gives the shape."""
    held = np.zeros(len(problem.nodes), dtype=int)
    held[problem.fixed] = 1
    structure = EquilibriumStructureSparse(np.arange(len(problem.nodes)), problem.members, held)
    parameters = EquilibriumParametersState(
        jnp.asarray(problem.force_densities),
        jnp.asarray(problem.nodes[problem.fixed]),
        LoadState(jnp.asarray(problem.loads), 0.0, 0.0),
    )
    compiled = equinox.filter_jit(EquilibriumModelSparse(tmax=1))
    return lambda tolerance, max_seconds: np.asarray(compiled(parameters, structure).xyz)
