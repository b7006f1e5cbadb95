# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was picked of a gridshell as edits of its Net: by place on the face, or by number where it has none.

So an edit keeps its meaning when the step or the face changes; see `edits`.
"""

import FreeCAD as App
import numpy as np

import funicular as fn

from .net import panels_of, places_of
from .net_laying import lay
from .source import read_source
from .node_choice import nodes_at


def raised(shell, points, height):
    """{property of the Net: value} that raises the nodes of a Gridshell at some points by a height [mm].

    points: App.Vector on its nodes, as it stands in the document. A node that was raised before gets the new
    height on top of the old one. Raises InvalidInput where nothing was picked.
    """
    nodes = nodes_at(shell, points)
    if not nodes:
        raise fn.InvalidInput("no node is picked: select nodes (the ends of members) of the gridshell")
    return raised_of_net(shell.Net, nodes, height)


def raised_of_net(net, nodes, height):
    """As raised(), of nodes of a Net by their numbers."""
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

    A panel that several have become by members taken out is said by one of these. Raises InvalidInput where
    nothing was picked.
    """
    if not len(members) and not len(panels):
        raise fn.InvalidInput("nothing is picked: select members of the gridshell, or faces of its covering")
    pairs = np.array(shell.Members).reshape(-1, 2)[list(members)]
    return taken_out_of_net(shell.Net, pairs, [panels_of(shell.Panels)[panel] for panel in panels])


def taken_out_of_net(net, members, panels=()):
    """As taken_out(), of a Net as it is: members as their nodes (k, 2), panels as tuples of theirs."""
    before, _ = lay(net, read_source(net))
    numbers = np.array(net.NodeNumbers or range(net.NodeCount))
    of_members = numbers[np.asarray(members)]
    of_panels = [numbers[list(panel)] for panel in panels]
    whole = {
        "Members": (before.members, _member_numbers(before.members, of_members)),
        "Panels": (before.panels, _panel_numbers(before.panels, of_panels)),
    }
    places = places_of(before)
    changes = {}
    for what, (groups, found) in whole.items():
        if not found:
            continue
        if net.NodePlaces:
            middles = places.middles([groups[number] for number in found])
            added, name = [App.Vector(*at, 0.0) for at in middles.tolist()], f"Removed{what}"
        else:
            added, name = found, f"Removed{what[:-1]}Numbers"
        changes[name] = [*getattr(net, name), *added]
    return changes


def typical_length(net):
    """Median length of the members of a Net [mm]."""
    return float(np.median([edge.Length for edge in net.Shape.Edges]))


def panels_of_faces(covering, faces):
    """Numbers of the panels that faces of a Covering's shape, counted from 1, belong to."""
    counts = np.cumsum([len(item.Faces) for item in covering.Shape.SubShapes])
    return sorted({int(np.searchsorted(counts, face, side="left")) for face in faces})


def _added(before, keys, height):
    after = dict(before)
    for key in keys:
        after[key] = after.get(key, 0.0) + height
    return after


def _member_numbers(members, picked):
    number_of = {frozenset(pair): number for number, pair in enumerate(np.asarray(members).tolist())}
    return [number_of[frozenset(pair)] for pair in np.asarray(picked).tolist()]


def _panel_numbers(panels, picked):
    """A panel of the net before edits within each of those picked.

    Panels all turn the same way, so that in its direction an edge has one of them.
    """
    number_of = {}
    for number, panel in enumerate(panels):
        for edge in zip(panel, panel[1:] + panel[:1]):
            number_of[tuple(map(int, edge))] = number
    return [
        next(
            number_of[edge] for edge in zip(panel.tolist(), np.roll(panel, -1).tolist()) if edge in number_of
        )
        for panel in picked
    ]
