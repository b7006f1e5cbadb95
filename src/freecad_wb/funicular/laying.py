# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laying a net on faces: how many cells, in which pattern, and where its nodes come to lie.

Lengths are millimetres, as in FreeCAD.
"""

from dataclasses import dataclass

import numpy as np

import funicular as fn

from . import surface

# A closed direction begins anew with the same nodes; one point of a pole has none to repeat.
_ACROSS = {"u_min": "v_min", "u_max": "v_max", "v_min": "u_min", "v_max": "u_max"}


@dataclass(frozen=True)
class Division:
    """How a face is divided.

    pattern: one of fn.patterns(). step_u, step_v: lengths of members along u and along v [mm], wherever no
    count of cells (count_u, count_v, 0 for none) is given. swapped: the pattern's u runs along the face's v.
    in_parameter: cells are equal in the surface's parameters, and not in length.
    """

    step_u: float
    step_v: float
    pattern: str = "quad"
    count_u: int = 0
    count_v: int = 0
    swapped: bool = False
    in_parameter: bool = False


@dataclass(frozen=True)
class Laid:
    """A net as it lies on its source.

    nodes: (n, 3) [mm]. uv: (n, 2) in the unit square of the face, None where there is none. lattice: what it
    was made on, None where it is no lattice; members, panels: its connectivity. cells, closed, poles: of the
    lattice, along u and along v of the face. remarks: sentences on what came out otherwise than it was asked
    for.
    """

    nodes: np.ndarray
    members: np.ndarray
    panels: tuple
    lattice: object = None
    cells: tuple = (0, 0)
    closed: tuple = (False, False)
    poles: frozenset = frozenset()
    remarks: tuple = ()
    uv: np.ndarray = None


def lattice_on(cells, closed, poles, pattern="quad", swapped=False):
    """(lattice, (n, 2) its nodes in the unit square of the face); cells, closed: along u, v of the face.

    poles: names of sides of the face. The lattice of a swapped pattern runs along v first.
    """
    if swapped:
        cells, closed, poles = cells[::-1], closed[::-1], [_ACROSS[pole] for pole in poles]
    lattice = fn.lattice(*cells, pattern=pattern, closed_u=closed[0], closed_v=closed[1], poles=sorted(poles))
    return lattice, lattice.uv[:, ::-1] if swapped else lattice.uv


def lay_on_face(face, name, division):
    """The Laid net on one untrimmed face. Raises InvalidInput naming the face or the step."""
    chart = surface.read_face(face, name)
    wanted = surface.count_cells(
        chart,
        division.step_u,
        division.step_v,
        division.pattern,
        (division.count_u, division.count_v),
        division.swapped,
    )
    closed = chart.closed_u, chart.closed_v
    lattice, uv = lattice_on(wanted, closed, chart.poles, division.pattern, division.swapped)
    cells = lattice.cells[::-1] if division.swapped else lattice.cells
    nodes = place(chart, uv, division)
    refuse_pinches(nodes, lattice.members, chart.size, name)
    remarks = tuple(_forced(wanted, cells, division))
    return Laid(nodes, lattice.members, lattice.panels, lattice, cells, closed, chart.poles, remarks, uv)


def place(chart, uv, division):
    """Points of the face: (n, 3) [mm]."""
    return chart.point(*uv.T) if division.in_parameter else surface.sample(chart, uv)


def _forced(wanted, cells, division):
    for axis, asked, made in zip("uv", wanted, cells):
        if made != asked:
            yield (
                f"{made} cells around the face along {axis} instead of {asked}: the pattern "
                f"{division.pattern.replace('_', ' ')} closes after a multiple of them only"
            )


def refuse_pinches(nodes, members, size, name):
    """Raises InvalidInput where nodes coincide though the lattice tells them apart. nodes, size: [mm]."""
    lengths = np.linalg.norm(nodes[members[:, 0]] - nodes[members[:, 1]], axis=1)
    shortest = int(np.argmin(lengths))
    if lengths[shortest] <= surface.COINCIDENT * size:
        x, y, z = (nodes[members[shortest, 0]] + 0.0).round(3)
        raise fn.InvalidInput(
            f"{name} pinches to a point inside, at ({x:g}, {y:g}, {z:g}) mm: split the face there and make a "
            "net on each part"
        )
