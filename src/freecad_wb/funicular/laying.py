# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laying a net on faces: how many cells, in which pattern, and where its nodes come to lie.

Lengths are millimetres, as in FreeCAD.
"""

from dataclasses import dataclass

import numpy as np

import funicular as fn

from . import surface
from .lattices import lattice_on
from .outline import read_outline
from .trimming import trimmed_net


@dataclass(frozen=True)
class Division:
    """How a face is divided.

    pattern: one of fn.patterns(). step_u, step_v: lengths of members along u and along v [mm], wherever no
    count of cells (count_u, count_v, 0 for none) is given. swapped: the pattern's u runs along the face's v.
    in_parameter: cells are equal in the surface's parameters, and not in length. angle: by which the pattern
    is turned [degrees]; offset: by which it is shifted, in cells.
    """

    step_u: float
    step_v: float
    pattern: str = "quad"
    count_u: int = 0
    count_v: int = 0
    swapped: bool = False
    in_parameter: bool = False
    angle: float = 0.0
    offset: tuple = (0.0, 0.0)


@dataclass(frozen=True)
class Laid:
    """A net as it lies on its source.

    nodes: (n, 3) [mm]. uv: (n, 2) in the unit square of the face, None where there is none. lattice: what it
    was made on, None where it is no lattice; members, panels: its connectivity. cells: of the lattice,
    closed, poles: of the face, along its u and v. openings: borders, as their nodes, that are those of holes.
    remarks: sentences on what came out otherwise than it was asked for.
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
    openings: tuple = ()


def lay_on_face(face, name, division):
    """The Laid net on one face, trimmed or not. Raises InvalidInput naming the face or the step."""
    if surface.is_trimmed(face, name) or division.angle or any(division.offset):
        return _lay_on_trimmed(face, name, division)
    return lay_on_chart(surface.read_face(face, name), name, division)


def lay_on_chart(chart, name, division):
    """The Laid net on all of the rectangle of a chart. Raises InvalidInput naming the step or the face."""
    wanted = cells_of(chart, division)
    closed = chart.closed_u, chart.closed_v
    lattice, uv = lattice_on(wanted, closed, chart.poles, division.pattern, division.swapped)
    cells = lattice.cells[::-1] if division.swapped else lattice.cells
    nodes = place(chart, uv, division)
    refuse_pinches(nodes, lattice.members, chart.size, name)
    remarks = tuple(_forced(wanted, cells, division))
    return Laid(nodes, lattice.members, lattice.panels, lattice, cells, closed, chart.poles, remarks, uv)


def chart_within_outline(face, name, step):
    """(chart, inside) of a face, or of the rectangle of parameters that a trimmed one lies in.

    step: length of members [mm], about how far apart what is asked for lies. inside: (a, b) -> array of bool,
    whether parameters in the unit square lie on the face; None where all do. Raises InvalidInput as
    surface.read_rectangle and read_outline do.
    """
    if not surface.is_trimmed(face, name):
        return surface.read_face(face, name), None
    chart, to_square = surface.read_rectangle(face, name)
    extent = np.array([chart.table.lengths_u.mean(), chart.table.lengths_v.mean()]) / step
    outline = read_outline(face, name, chart, to_square, extent)
    return chart, lambda a, b: outline.inside(np.column_stack(chart.table.shares(a, b)) * extent)


def _lay_on_trimmed(face, name, division):
    if division.in_parameter:
        raise fn.InvalidInput(
            f"{name} is trimmed, or its pattern turned or shifted, and such nets are spaced by length only: "
            "set Spacing to Length"
        )
    made = trimmed_net(
        face,
        name,
        division.step_u,
        division.step_v,
        division.pattern,
        (division.count_u, division.count_v),
        division.swapped,
        division.angle,
        division.offset,
    )
    # A rim along a whole side of the rectangle is where the face ends, and no hole in it.
    openings = tuple(
        rim for rim in made.rims[1:] if not any(np.ptp(made.uv[rim, axis]) < 1e-9 for axis in (0, 1))
    )
    return Laid(
        made.nodes,
        made.members,
        tuple(map(tuple, made.panels)),
        closed=made.closed,
        poles=made.poles,
        uv=np.where(made.closed, made.uv % 1.0, made.uv),
        openings=openings,
    )


def cells_of(chart, division):
    """Cells along u and v that a Division asks for. Raises InvalidInput naming the step."""
    counts = division.count_u, division.count_v
    return surface.count_cells(
        chart, division.step_u, division.step_v, division.pattern, counts, division.swapped
    )


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
