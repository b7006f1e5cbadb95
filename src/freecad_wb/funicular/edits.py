# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits of a net before it is relaxed: single nodes raised or lowered, members and panels taken out.

What is edited is said by meaning, so that another step keeps it: a place on the face, (u, v), stands for the
node, member or panel that is nearest to it. Nets that keep their numbers are edited by number. Lengths: mm.
"""

from dataclasses import dataclass, field, replace

import numpy as np

import funicular as fn

from . import topology
from .panels import areas


@dataclass(frozen=True)
class Places:
    """Where the nodes of a Laid net are, for what is said by place.

    uv: (n, 2) in the unit square of the face, None where there is none. closed: whether u, v come round.
    """

    uv: np.ndarray = None
    closed: tuple = (False, False)

    def nearest(self, points, place):
        """Index of the (k, 2) points, given in the unit square, that is nearest to a place there."""
        away = np.abs(points - place)
        away = np.where(self.closed, np.minimum(away, np.abs(1.0 - away)), away)
        return int(np.argmin((away**2).sum(axis=1)))

    def middles(self, groups):
        """(k, 2) middles of groups of nodes, also of those that lie across a seam."""
        nodes, sizes = topology.flat(groups)
        begin = np.cumsum(sizes) - sizes
        first = self.uv[nodes[begin]]
        away = self.uv[nodes] - np.repeat(first, sizes, axis=0)
        away -= np.where(self.closed, np.round(away), 0.0)
        middles = first + np.add.reduceat(away, begin) / sizes[:, None]
        return np.where(self.closed, middles % 1.0, middles)


@dataclass(frozen=True)
class Edits:
    """What is changed. Each of raised, members, panels: (where, …) with a number, or (u, v), for where.

    raised: list of (where, height [mm]). panels, members: lists of where they are.
    """

    raised: list = field(default_factory=list)
    members: list = field(default_factory=list)
    panels: list = field(default_factory=list)

    def __bool__(self):
        return bool(self.raised or self.members or self.panels)


@dataclass(frozen=True)
class Opening:
    """A panel that was taken out: the nodes around it, and its area on the source [mm²]."""

    nodes: tuple
    area: float


def edited(laid, edits, places):
    """(Laid, openings, numbers): the net with these edits, and which node of the old each of the new is.

    A member that is taken out joins the two panels beside it, or takes the one with it on the border. Nodes
    that are left without a member go. Raises InvalidInput for a number or a place that there is not, and
    where nothing would be left, or not in one piece.
    """
    nodes = np.array(laid.nodes, dtype=float)
    for where, height in edits.raised:
        nodes[_node(where, nodes, places)] += (0.0, 0.0, height)
    if not (edits.members or edits.panels):
        return replace(laid, nodes=nodes), (), np.arange(len(nodes))

    panels = [tuple(map(int, panel)) for panel in laid.panels]
    out = _found(edits.panels, panels, "panel", places)
    areas_of = areas(nodes, panels)
    openings = tuple(Opening(panels[k], float(areas_of[k])) for k in sorted(out))
    members = [tuple(member) for member in np.asarray(laid.members).tolist()]
    # All are looked up in the net as it was, so that their order does not matter.
    gone = _found(edits.members, members, "member", places)
    kept = [panel for k, panel in enumerate(panels) if k not in out]
    for member in sorted(gone):
        kept = _without_edge(kept, members[member])
    members = [member for k, member in enumerate(members) if k not in gone]
    return _numbered_anew(laid, nodes, members, kept, openings)


def _numbered_anew(laid, nodes, members, panels, openings):
    if not members:
        raise fn.InvalidInput("every member was taken out: leave some")
    numbers = np.unique(np.array(members))
    own = np.full(len(nodes), -1)
    own[numbers] = np.arange(len(numbers))
    members = own[np.array(members)]
    pieces = topology.parts(len(numbers), members)
    if len(set(np.asarray(pieces).tolist())) > 1:
        raise fn.InvalidInput(
            "without the members that were taken out the net falls apart: leave one that holds it together"
        )
    panels = tuple(tuple(own[list(panel)].tolist()) for panel in panels)
    openings = tuple(
        Opening(tuple(own[[node for node in opening.nodes if own[node] >= 0]].tolist()), opening.area)
        for opening in openings
    )
    uv = None if laid.uv is None else laid.uv[numbers]
    made = replace(laid, nodes=nodes[numbers], members=members, panels=panels, lattice=None, uv=uv)
    return made, openings, numbers


def _without_edge(panels, member):
    """The panels once a member is gone: the two beside it are one, a single one goes with it."""
    beside = [k for k, panel in enumerate(panels) if _edge_at(panel, member) is not None]
    if len(beside) == 2:
        one, other = (_opened(panels[k], member) for k in beside)
        # From one end of the member to the other and back.
        joined = (*one, *other[1:-1]) if one[-1] == other[0] else (*one, *other[-2:0:-1])
        panels = [*panels, _without_spikes(joined)]
    return [panel for k, panel in enumerate(panels) if k not in beside]


def _without_spikes(panel):
    """The panel without members that run into it and back: they are on no panel."""
    panel = list(panel)
    while len(panel) > 2:
        tip = next((k for k in range(len(panel)) if panel[k - 1] == panel[(k + 1) % len(panel)]), None)
        if tip is None:
            break
        for k in sorted((tip, (tip + 1) % len(panel)), reverse=True):
            del panel[k]
    return tuple(panel)


def _edge_at(panel, member):
    for k, pair in enumerate(zip(panel, panel[1:] + panel[:1])):
        if set(pair) == set(member):
            return k
    return None


def _opened(panel, member):
    """The panel's nodes from the end of the member around to its beginning."""
    k = _edge_at(panel, member) + 1
    return panel[k:] + panel[:k]


def _node(where, nodes, places):
    if not isinstance(where, tuple):
        return _checked(where, len(nodes), "node")
    return places.nearest(_uv(places), where)


def _found(wheres, groups, what, places):
    """The numbers of the members or panels that are said by number or by place."""
    found = {_checked(where, len(groups), what) for where in wheres if not isinstance(where, tuple)}
    by_place = [where for where in wheres if isinstance(where, tuple)]
    if by_place:
        _uv(places)
        middles = places.middles(groups)
        found.update(places.nearest(middles, where) for where in by_place)
    return found


def _uv(places):
    if places.uv is None:
        raise fn.InvalidInput(
            "places (u, v) are those of one whole face, which this net does not lie on: give numbers"
        )
    return places.uv


def _checked(number, count, what):
    if not 0 <= number < count:
        raise fn.InvalidInput(f"there is no {what} {number}: the net has {what}s 0 to {count - 1}")
    return int(number)
