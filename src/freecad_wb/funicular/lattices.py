# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lattice of a pattern on a face, whichever way the pattern is turned."""

import funicular as fn

_ACROSS = {"u_min": "v_min", "u_max": "v_max", "v_min": "u_min", "v_max": "u_max"}


def lattice_on(cells, closed, poles, pattern="quad", swapped=False):
    """(lattice, (n, 2) its nodes in the unit square of the face); cells, closed: along u, v of the face.

    poles: names of sides of the face. The lattice of a swapped pattern runs along v first.
    """
    if swapped:
        cells, closed, poles = cells[::-1], closed[::-1], [_ACROSS[pole] for pole in poles]
    lattice = fn.lattice(*cells, pattern=pattern, closed_u=closed[0], closed_v=closed[1], poles=sorted(poles))
    return lattice, lattice.uv[:, ::-1] if swapped else lattice.uv
