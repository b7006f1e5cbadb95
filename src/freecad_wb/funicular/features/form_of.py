# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Form of a Gridshell as its last result is in the document."""

import numpy as np

from ..form import Form
from .net import panels_of, positions_of

METRES = 1e-3  # of a millimetre

RESULTS = (
    "NodePositions",
    "Members",
    "Panels",
    "MemberForces",
    "Reactions",
    "TensionMembers",
    "SlackMembers",
)


def form_of(shell, exaggeration=1.0):
    """The funicular.form.Form of a Gridshell's results, before its Placement; None before it has any, or as
    they are read or written.

    exaggeration: as the Form has it.
    Where the net has changed since, source nodes are those of the result: nothing is known of how far it is
    from where it was laid.
    """
    if any(name not in shell.PropertiesList for name in RESULTS) or not len(shell.MemberForces):
        return None
    if 2 * len(shell.MemberForces) != len(shell.Members) or len(shell.Reactions) != len(shell.NodePositions):
        return None
    nodes = np.array([tuple(node) for node in shell.NodePositions]) * METRES
    source = positions_of(shell.Net) * METRES if getattr(shell.Net, "SourceNodes", None) else nodes
    return Form(
        nodes,
        source if len(source) == len(nodes) else nodes,
        np.array(shell.Members, dtype=int).reshape(-1, 2),
        panels_of(shell.Panels),
        np.array(shell.MemberForces),
        np.array([tuple(reaction) for reaction in shell.Reactions]),
        np.array(shell.TensionMembers, dtype=int),
        np.array(shell.SlackMembers, dtype=int),
        exaggeration,
        is_certified=True,
    )
