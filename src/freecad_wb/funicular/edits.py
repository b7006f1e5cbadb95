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
    """Where the nodes of a net are, for what is said by place.

    uv: (n, 2) in the unit square of the face, None where there is none. closed: whether u, v come round.
    poles: names of sides that are one point, such as "v_max": a node there is everywhere along that side.
    """

    uv: np.ndarray = None
    closed: tuple = (False, False)
    poles: frozenset = frozenset()

    def nearest_node(self, place):
        """The node nearest to a place (u, v)."""
        return self._nearest(self.uv, place, self._anywhere())

    def nearest_groups(self, groups, places):
        """Of groups of nodes, the one whose middle is nearest to each of some places (u, v)."""
        middles = self.middles(groups)
        return [self._nearest(middles, place, np.zeros(middles.shape, dtype=bool)) for place in places]

    def _anywhere(self):
        """(n, 2) bool: the node is a pole, and everywhere in that direction."""
        found = np.zeros(self.uv.shape, dtype=bool)
        for side in self.poles:
            axis, end = "uv".index(side[0]), 1.0 if side.endswith("max") else 0.0
            found[np.abs(self.uv[:, axis] - end) < 1e-9, 1 - axis] = True
        return found

    def _nearest(self, points, place, anywhere):
        away = np.abs(points - place)
        away = np.where(self.closed, np.minimum(away, np.abs(1.0 - away)), away)
        return int(np.argmin((np.where(anywhere, 0.0, away) ** 2).sum(axis=1)))

    def middles(self, groups):
        """(k, 2) middles of groups of nodes, also across a seam; a pole counts in one direction only."""
        nodes, sizes = topology.flat(groups)
        begin, group = np.cumsum(sizes) - sizes, np.repeat(np.arange(len(sizes)), sizes)
        counts = ~self._anywhere()[nodes]
        middles = np.empty((len(sizes), 2))
        for axis in (0, 1):
            at = self.uv[nodes, axis]
            # The first of each group that counts; that of a group of poles alone is as good as any.
            first = np.full(len(sizes), -1)
            of = np.flatnonzero(counts[:, axis])[::-1]
            first[group[of]] = of
            base = at[np.where(first < 0, begin, first)]
            away = at - base[group]
            if self.closed[axis]:
                away -= np.round(away)
            weight = counts[:, axis].astype(float)
            total = np.add.reduceat(weight, begin)
            middles[:, axis] = base + np.add.reduceat(away * weight, begin) / np.maximum(total, 1.0)
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

    A member that is taken out joins the two panels beside it, or takes the one with it on the border; beside
    an opening it makes that larger. A panel that is taken out on the border takes its members there with it.
    Nodes that are left without a member go. Raises InvalidInput for a number or a place that there is not,
    and where nothing would be left, or not in one piece.
    """
    nodes = np.array(laid.nodes, dtype=float)
    for where, height in edits.raised:
        nodes[_node(where, nodes, places)] += (0.0, 0.0, height)
    if not (edits.members or edits.panels):
        return replace(laid, nodes=nodes), (), np.arange(len(nodes))

    panels = [tuple(map(int, panel)) for panel in laid.panels]
    members = [tuple(member) for member in np.asarray(laid.members).tolist()]
    out = _found(edits.panels, panels, "panel", places)
    gone = _found(edits.members, members, "member", places)
    cover = _Cover(panels, areas(nodes, panels), out)
    rim = [k for k, member in enumerate(members) if len(cover.beside(member)) == 1]
    for member in sorted(gone):
        cover.join_across(members[member])
    # What was the border of an opened panel would hang loose there.
    gone |= {k for k in rim if cover.is_open_beside(members[k])}
    members = [member for k, member in enumerate(members) if k not in gone]
    return _numbered_anew(laid, nodes, members, cover.panels(), cover.openings())


class _Cover:
    """The panels of a net while members between them are taken out."""

    def __init__(self, panels, areas_of, out):
        self._around = dict(enumerate(panels))
        self._area = dict(enumerate(map(float, areas_of)))
        self._open = set(out)
        self._beside = {}
        for number, panel in self._around.items():
            for edge in _edges(panel):
                self._beside.setdefault(edge, set()).add(number)

    def beside(self, member):
        """Numbers of the panels on both sides of a member."""
        return sorted(self._beside.get(_key(member), ()))

    def is_open_beside(self, member):
        return any(number in self._open for number in self.beside(member))

    def join_across(self, member):
        """Makes the two panels beside a member one, which is open if one of them is; a single one goes."""
        numbers = self.beside(member)
        if len(numbers) > 2 or not numbers:
            return
        panels = [self._around.pop(number) for number in numbers]
        for number, panel in zip(numbers, panels):
            for edge in _edges(panel):
                self._beside[edge].discard(number)
        if len(numbers) == 1:
            return
        one, other = (_opened(panel, member) for panel in panels)
        # From one end of the member to the other and back.
        joined = (*one, *other[1:-1]) if one[-1] == other[0] else (*one, *other[-2:0:-1])
        joined, first = _without_spikes(joined), numbers[0]
        self._around[first] = joined
        self._area[first] += self._area[numbers[1]]
        if self._open & set(numbers):
            self._open.add(first)
        for edge in _edges(joined):
            self._beside.setdefault(edge, set()).add(first)

    def panels(self):
        return [panel for number, panel in sorted(self._around.items()) if number not in self._open]

    def openings(self):
        return tuple(
            Opening(panel, self._area[number])
            for number, panel in sorted(self._around.items())
            if number in self._open
        )


def _key(member):
    return (min(member), max(member))


def _edges(panel):
    return [_key(pair) for pair in zip(panel, panel[1:] + panel[:1])]


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
    # Borders that consist of nodes around openings alone, be those of the face or taken out of the net.
    around = {int(own[node]) for rim in laid.openings for node in rim}
    around.update(node for opening in openings for node in opening.nodes)
    rims = topology.rims(nodes[numbers], panels)[1:] if panels else ()
    made = replace(
        laid,
        nodes=nodes[numbers],
        members=members,
        panels=panels,
        lattice=None,
        uv=uv,
        openings=tuple(rim for rim in rims if around.issuperset(rim.tolist())),
    )
    return made, openings, numbers


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
    _uv(places)
    return places.nearest_node(where)


def _found(wheres, groups, what, places):
    """The numbers of the members or panels that are said by number or by place."""
    found = {_checked(where, len(groups), what) for where in wheres if not isinstance(where, tuple)}
    by_place = [where for where in wheres if isinstance(where, tuple)]
    if by_place:
        _uv(places)
        found.update(places.nearest_groups(groups, by_place))
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
