# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was picked of a gridshell as edits of its Net: by place on the face, or by number where it has none.

So an edit keeps its meaning when the step or the face changes; see `edits`.
"""

import FreeCAD as App
import numpy as np

import funicular as fn

from ..edits import Places
from .net import panels_of
from .net_laying import lay
from .source import read_source
from .support import nodes_at


def raised(shell, points, height):
    """{property of the Net: value} that raises the nodes of a Gridshell at some points by a height [mm].

    points: App.Vector on its nodes, as it stands in the document. A node that was raised before gets the new
    height on top of the old one. Raises InvalidInput where nothing was picked.
    """
    nodes = nodes_at(shell, points)
    if not nodes:
        raise fn.InvalidInput("no node is picked: select nodes (the ends of members) of the gridshell")
    net = shell.Net
    if net.NodePlaces:
        by_place = [(net.NodePlaces[node].x, net.NodePlaces[node].y) for node in nodes]
        before = {(at.x, at.y): at.z for at in net.Raised}
        return {"Raised": [App.Vector(*at, z) for at, z in _added(before, by_place, height).items()]}
    numbers = net.NodeNumbers or range(net.NodeCount)
    before = dict(zip(net.RaisedNodes, net.RaisedHeights))
    after = _added(before, [int(numbers[node]) for node in nodes], height)
    return {"RaisedNodes": list(after), "RaisedHeights": list(after.values())}


def taken_out(shell, members=(), panels=()):
    """{property of the Net: value} that takes members and panels out of a Gridshell, by their numbers there.

    Raises InvalidInput where nothing was picked, and for a panel that is no longer the net's own where there
    are no places to say it by.
    """
    if not len(members) and not len(panels):
        raise fn.InvalidInput("nothing is picked: select members of the gridshell, or faces of its covering")
    net = shell.Net
    of_members = np.array(shell.Members).reshape(-1, 2)[list(members)].tolist()
    of_panels = [panels_of(shell.Panels)[panel] for panel in panels]
    if net.NodePlaces:
        uv = np.array([(at.x, at.y) for at in net.NodePlaces])
        places = Places(uv, (net.ClosedU, net.ClosedV), frozenset(net.Poles))
        changes = {"RemovedMembers": of_members, "RemovedPanels": of_panels}
        return {
            name: [*getattr(net, name), *(App.Vector(*at, 0.0) for at in places.middles(groups).tolist())]
            for name, groups in changes.items()
            if groups
        }
    numbers = np.array(net.NodeNumbers or range(net.NodeCount))
    whole, _ = lay(net, read_source(net))
    changes = {
        "RemovedMemberNumbers": (whole.members, of_members, "member"),
        "RemovedPanelNumbers": (whole.panels, of_panels, "panel"),
    }
    return {
        name: [*getattr(net, name), *_numbers_before(all_of, numbers, groups, what)]
        for name, (all_of, groups, what) in changes.items()
        if groups
    }


def panels_of_faces(covering, faces):
    """Numbers of the panels that faces of a Covering's shape, counted from 1, belong to."""
    counts = np.cumsum([len(item.Faces) for item in covering.Shape.SubShapes])
    return sorted({int(np.searchsorted(counts, face, side="left")) for face in faces})


def _added(before, keys, height):
    after = dict(before)
    for key in keys:
        after[key] = after.get(key, 0.0) + height
    return after


def _numbers_before(all_of, numbers, groups, what):
    """The numbers that groups of nodes had before edits."""
    number_of = {frozenset(map(int, group)): number for number, group in enumerate(all_of)}
    found = [number_of.get(frozenset(numbers[list(group)].tolist())) for group in groups]
    if None in found:
        raise fn.InvalidInput(
            f"a picked {what} came from members that were taken out, and has no number of its own: take "
            "those back first (RemovedMemberNumbers)"
        )
    return found
