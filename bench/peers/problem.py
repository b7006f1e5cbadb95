# SPDX-License-Identifier: LGPL-2.1-or-later
"""The problem that every package solves, and how far a shape is from equilibrium: numpy alone.

A flat square net of n × n nodes on 10 m × 10 m whose border is fixed, with 1 kN a metre of step pulling up
all other nodes. It is asked in two models. "force densities": every member's is given, which makes the
problem linear. "springs": every member is one, of EA 100 kN and as long at rest as in the flat net, and
pulls or pushes.
"""

from dataclasses import dataclass

import numpy as np

SIDE, STIFFNESS, LOAD = 10.0, 100e3, 1000.0  # [m], EA [N], [N/m]
# Such that both models rise by about 1.5 m, whatever the step.
FORCE_DENSITY = 5000.0  # [N/m] times the step [m]


@dataclass(frozen=True)
class Problem:
    """nodes: (n, 3) [m]; members: (m, 2); panels: (p, 4); fixed, free: node numbers; loads: (n, 3) [N];
    step: the members' length in the flat net [m]; force_densities: (m,) [N/m]."""

    nodes: np.ndarray
    members: np.ndarray
    panels: np.ndarray
    fixed: np.ndarray
    free: np.ndarray
    loads: np.ndarray
    step: float
    force_densities: np.ndarray


def flat_net(side):
    """The Problem with side × side nodes."""
    step = SIDE / (side - 1)
    x, y = np.meshgrid(np.arange(side) * step, np.arange(side) * step)
    number = np.arange(side * side).reshape(side, side)
    along = np.column_stack([number[:, :-1].ravel(), number[:, 1:].ravel()])
    across = np.column_stack([number[:-1].ravel(), number[1:].ravel()])
    corners = (number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1])
    inside = np.zeros((side, side), dtype=bool)
    inside[1:-1, 1:-1] = True
    members = np.vstack([along, across])
    loads = np.zeros((side * side, 3))
    loads[:, 2] = LOAD * step
    return Problem(
        nodes=np.column_stack([x.ravel(), y.ravel(), np.zeros(side * side)]),
        members=members,
        panels=np.column_stack([corner.ravel() for corner in corners]),
        fixed=number[~inside],
        free=number[inside],
        loads=loads,
        step=step,
        force_densities=np.full(len(members), FORCE_DENSITY / step),
    )


def lengths(problem, shape):
    return np.linalg.norm(shape[problem.members[:, 1]] - shape[problem.members[:, 0]], axis=1)


def force_densities(problem, model, shape):
    """(m,) [N/m] of a shape, (n, 3) [m]: those given, or what springs pull at their present length."""
    if model == "force densities":
        return problem.force_densities
    return STIFFNESS * (1 / problem.step - 1 / lengths(problem, shape))


def residual(problem, model, shape):
    """The largest force left at a free node, Σ force density · edge + load, of the largest load."""
    pulls = force_densities(problem, model, shape)[:, None] * (
        shape[problem.members[:, 1]] - shape[problem.members[:, 0]]
    )
    left = problem.loads.copy()
    np.add.at(left, problem.members[:, 0], pulls)
    np.subtract.at(left, problem.members[:, 1], pulls)
    return float(np.linalg.norm(left[problem.free], axis=1).max() / np.abs(problem.loads).max())
