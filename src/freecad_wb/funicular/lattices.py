# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lattice of a pattern on a face, whichever way the pattern is turned."""

import numpy as np

import funicular as fn

ACROSS = {"u_min": "v_min", "u_max": "v_max", "v_min": "u_min", "v_max": "u_max"}


def lattice_on(cells, closed, poles, pattern="quad", swapped=False):
    """(lattice, (n, 2) its nodes in the unit square of the face); cells, closed: along u, v of the face.

    poles: names of sides of the face. The lattice of a swapped pattern runs along v first.
    """
    if swapped:
        cells, closed, poles = cells[::-1], closed[::-1], [ACROSS[pole] for pole in poles]
    lattice = fn.lattice(*cells, pattern=pattern, closed_u=closed[0], closed_v=closed[1], poles=sorted(poles))
    return lattice, lattice.uv[:, ::-1] if swapped else lattice.uv


def turned_lattice(cells, pattern, angle, offset):
    """(lattice, (n, 2) its nodes, (2,) extent in members) of a turned pattern, with all of a face in it.

    cells: that the face would have along u and v. angle: degrees, from u to v, about the middle of the face.
    offset: along the pattern's own u and v, in cells. Nodes are given in the unit square of the face, and lie
    beyond it too.
    """
    cell = np.array(fn.cell_extent(pattern))
    extent = np.array(cells) * cell
    # An even number, so that the middle is a corner of cells; with a cell to spare on each side.
    across = 2 * (np.ceil(0.5 * np.hypot(*extent) / cell).astype(int) + 2)
    lattice = fn.lattice(int(across[0]), int(across[1]), pattern=pattern)
    flat = (lattice.uv - 0.5) * across * cell + np.asarray(offset, dtype=float) % 1.0 * cell
    turn = np.radians(angle)
    flat = flat @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    return lattice, flat / extent + 0.5, extent
