# SPDX-License-Identifier: LGPL-2.1-or-later
"""The relaxed lattice of a Gridshell, for other programs."""

import numpy as np

import funicular as fn

from .features.gridshell import refuse_tilt
from .features.net import panels_of
from .files import write_mesh


def lattice_of(shell):
    """(nodes, members, panels) of a Gridshell as it stands in the document.

    nodes: (n, 3) [m]; members: (m, 2) node numbers; panels: node numbers around each.
    Raises InvalidInput if the gridshell has no result, or none of its present input, or stands at a tilt.
    """
    if shell.Status not in ("", "converged"):
        raise fn.InvalidInput(f"{shell.Label} has no result: {shell.Summary}")
    if not shell.Status or any("Touched" in obj.State or not obj.isValid() for obj in (shell, shell.Net)):
        raise fn.InvalidInput(f"{shell.Label} has no result for its net as it is now: recompute it first")
    refuse_tilt(shell)
    place = shell.getGlobalPlacement().Matrix
    nodes = np.array([tuple(place.multVec(node)) for node in shell.NodePositions]) * 1e-3
    return nodes, np.array(shell.Members).reshape(-1, 2), panels_of(shell.Panels)


def export_gridshell(shell, path):
    """Write the relaxed lattice to a mesh file in metres; the suffix of the path chooses the format.

    .obj and .ply hold nodes, members and panels; .stl and .off hold panels. Raises InvalidInput if there is
    no result, ValueError for another suffix, OSError if the file cannot be written.
    """
    write_mesh(path, *lattice_of(shell))
