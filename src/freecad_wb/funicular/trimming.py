# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets on trimmed faces: a lattice on the whole rectangle of parameters, cut along the face's outline.

All is decided in the plane of the lattice, in which members are about one long (see `outline`). Nodes that
the outline passes nearer than a third of their shortest member are moved onto it, and each corner of it takes
the node that is nearest, of like ones rather one outside; both are decided for all nodes from where they lay,
so that the numbering has no say. Then every edge between a node inside and one outside is cut once, and
panels are clipped between the cuts. What the net has no room for is refused by the name of the edge.

In that plane no panel is smaller than LEAST_AREA of the whole panel that it was cut from, no angle less than
LEAST_ANGLE, and no member shorter than LEAST_LENGTH of a step; what would be is refused. Panels round a pole
have no shape in that plane and are left out.
"""

from dataclasses import dataclass

import numpy as np

import funicular as fn

from . import surface
from .clipping import Rings, border, clip, loops
from .lattices import lattice_on, turned_lattice
from .outline import read_outline
from .placing import place_nodes, pole_nodes
from .shapes import areas_and_centres, shape_faults

# What is left of a panel that has no node inside counts from this part of it.
LEAST_PIECE = 0.12

LEAST_AREA = 0.04
LEAST_ANGLE = np.radians(8.0)
LEAST_LENGTH = 0.15

# How far, in members, the outline may go away from a member of the border.
LARGEST_RISE = 0.6

# An opening this many members wide holds nodes that no third of a member brings onto its outline.
ROOM = 2.5


@dataclass(frozen=True)
class TrimmedNet:
    """A net on a trimmed face, in mm and before any relaxation.

    nodes: (n, 3) [mm]. uv: (n, 2) where they lie in the rectangle of the lattice, in [0, 1]². closed, poles:
    as in its Chart. members: (m, 2) node numbers. panels: list of tuples of node numbers, all round the same
    way. rims: the closed borders, each an array of node numbers in order with the net to the left, the outer
    one first, then one for each opening. edge_nodes: {"Edge3": the nodes on that edge of the face, in order
    along it, those at its ends included}. corners: the nodes where the outer rim turns by more than 30
    degrees, ascending.
    """

    nodes: np.ndarray
    uv: np.ndarray
    closed: tuple
    poles: frozenset
    members: np.ndarray
    panels: list
    rims: tuple
    edge_nodes: dict
    corners: np.ndarray


def trimmed_net(
    face, name, step_u, step_v, pattern="quad", counts=(0, 0), swapped=False, angle=0.0, offset=(0.0, 0.0)
):
    """The TrimmedNet of a face in a pattern of fn.patterns().

    face: Part.Face, trimmed or not, placed as it stands. name: how errors call it. step_u, step_v: lengths of
    members along u and v [mm], unless counts gives cells; swapped: the pattern's u runs along v. Of a plane
    face u is the axis that `surface.read_rectangle` finds. angle: by which the pattern is turned in the plane
    of the lattice [degrees], about its middle; offset: by which it is shifted along its own u and v, in
    cells. Raises InvalidInput for a turn or a shift on a face that closes or has a pole, as
    surface.read_rectangle, count_cells and sample do, for a face without an outline, and for what is smaller
    than a cell: it names the edges and says what steps to give.
    """
    chart, to_square = surface.read_rectangle(face, name)
    cells = surface.count_cells(chart, step_u, step_v, pattern, counts, swapped)
    if angle or any(offset):
        _refuse_to_turn(chart, name)
        lattice, uv, extent = turned_lattice(cells, pattern, angle + 90.0 * swapped, offset)
        swapped = False
    else:
        lattice, uv = lattice_on(cells, (chart.closed_u, chart.closed_v), chart.poles, pattern, swapped)
        extent = np.array(lattice.cells) * fn.cell_extent(pattern)
        extent = extent[::-1] if swapped else extent
    outline = read_outline(face, name, chart, to_square, extent)
    refusal = _Refusal(name, outline, chart, extent, any(counts))
    # All that follows counts on panels that turn as u turns to v.
    rings = Rings.of([panel[::-1] for panel in lattice.panels] if swapped else lattice.panels)
    poles = pole_nodes(uv, chart.poles)
    xy = uv * extent
    placed = place_nodes(xy, rings.edges, outline, poles)
    if len(placed.lost):
        raise refusal("the outline", placed.lost)
    panels, origin = _panels(rings, placed, xy, outline)
    if not panels:
        raise refusal("the face", [loop.start for loop in outline.loops])
    rims, loops_of_rims = _rims(panels, placed.place, outline, refusal)
    shortest = np.linalg.norm(outline.offset(xy[rings.edges[:, 0]] - xy[rings.edges[:, 1]]), axis=1).max()
    for ring, fault in shape_faults(
        panels,
        placed.xy,
        areas_and_centres(rings.select(origin), xy, outline)[0],
        outline,
        poles,
        (LEAST_AREA, LEAST_ANGLE, LEAST_LENGTH * min(1.0, shortest)),
    ):
        at = [place for place in placed.place[list(ring)] if place >= 0.0]
        raise refusal(f"a sliver (by its {fault})", at)
    return _assembled(panels, rims, loops_of_rims, (lattice, uv), rings, placed, chart, outline)


def _refuse_to_turn(chart, name):
    if chart.closed_u or chart.closed_v or chart.poles:
        raise fn.InvalidInput(
            f"{name} closes on itself or runs to a pole, where a turned or shifted pattern would not meet "
            "itself: set Angle, OffsetU and OffsetV to 0, or turn the pattern with SwapUV"
        )


class _Refusal:
    """Makes the InvalidInput of what is smaller than a cell."""

    def __init__(self, name, outline, chart, extent, by_count):
        self._name, self._outline, self._by_count = name, outline, by_count
        lengths = chart.table.lengths_u.mean(), chart.table.lengths_v.mean()
        self._step = min(float(length) / members for length, members in zip(lengths, extent))

    def __call__(self, what, places, room=0.5):
        """what: does not fit. places: of the outline there. room: the part of the step that would do."""
        edges = self._outline.parameters(np.asarray(places, dtype=float))[0] if len(places) else ()
        around = ", ".join(f"Edge{edge + 1}" for edge in sorted(set(map(int, edges)))[:4]) or "its outline"
        step = room * self._step
        unit = 10.0 ** (np.floor(np.log10(step)) - 1.0)
        wish = "larger CountU, CountV, for steps" if self._by_count else "StepU, StepV"
        return fn.InvalidInput(
            f"{self._name}: {what} around {around} is smaller than a cell: give {wish} of at most "
            f"about {np.floor(step / unit) * unit:.10g} mm"
        )


def _panels(rings, placed, xy, outline):
    """(panels, the panel of the lattice that each was cut from)."""
    whole, clipped, doubtful = clip(rings, placed.sign, placed.cut_node, placed.gap)
    sign, place = placed.sign.tolist(), placed.place.tolist()
    pieces = []
    for panel, ring in clipped:
        for part in _split(ring, place, outline):
            if any(sign[node] > 0 for node in part):
                pieces.append((panel, part))
            else:
                doubtful.append((panel, part, ()))
    if doubtful:
        of = np.array([panel for panel, _, _ in doubtful])
        areas, centres = areas_and_centres([joined for _, joined, _ in doubtful], placed.xy, outline)
        full, _ = areas_and_centres(rings.select(of), xy, outline)
        for (panel, joined, apart), within, share in zip(doubtful, outline.inside(centres), areas / full):
            if within and (apart or share >= LEAST_PIECE):
                pieces.append((panel, joined))
            elif not within:
                pieces += [(panel, ring) for ring in apart]
    return (
        rings.select(whole) + [ring for _, ring in pieces],
        np.concatenate([whole, [panel for panel, _ in pieces]]).astype(int),
    )


def _split(ring, place, outline):
    """A ring that the outline closes, in parts between those of its nodes that the outline passes there."""
    last, first = place[ring[-1]], place[ring[0]]
    at = [k for k in range(1, len(ring) - 1) if place[ring[k]] >= 0.0]
    at = [0, *(k for k in at if outline.passes(last, place[ring[k]], first)), len(ring) - 1]
    return [ring[a : b + 1] for a, b in zip(at, at[1:]) if b - a >= 2]


def _rims(panels, place, outline, refusal):
    """(rims, number of the loop of the outline that each follows), the outer one first.

    Raises InvalidInput unless each loop of the outline is followed once round, past all of its corners.
    """
    edges, twice = border(panels)
    found, ambiguous = loops(edges)
    used = np.unique(edges)
    on_border = used[place[used] >= 0.0]
    reached = np.bincount(outline.loop_of(place[on_border]), minlength=len(outline.loops))
    for number, loop in enumerate(outline.loops):
        if reached[number] < 3:
            width = outline.width(number)
            raise refusal("the opening", sorted({*_edge_starts(outline, loop)}), min(0.7, width / ROOM))
    for nodes, what in ((twice.ravel(), "what lies between"), (ambiguous, "what lies between")):
        if len(nodes):
            raise refusal(what, [at for at in place[nodes] if at >= 0.0])
    strangers = used[place[used] < 0.0]
    if len(strangers):
        raise refusal("what lies between", place[on_border])
    missed = np.setdiff1d(outline.corners, place[used])
    if len(missed):
        raise refusal("a spike or corner", [missed[0], outline.before(missed[:1])[0]])
    loops_of_rims = [int(outline.loop_of(place[rim[:1]])[0]) for rim in found]
    for rim, number in zip(found, loops_of_rims):
        at = place[rim]
        steps = np.diff(np.append(at, at[0]))
        backwards = np.count_nonzero(steps < 0) > np.count_nonzero(steps > 0)
        turned = np.flatnonzero((steps >= 0) if backwards else (steps <= 0))
        if (outline.loop_of(at) != number).any() or len(turned) != 1:
            raise refusal("what lies between", at[turned] if len(turned) else at)
        for a, b in outline.long_ways(at, LARGEST_RISE):
            if outline.rise(a, b) > LARGEST_RISE:
                raise refusal("what lies between", [a, b])
    if len(set(loops_of_rims)) != len(found):
        raise refusal("what lies between", [loop.start for loop in outline.loops])
    order = sorted(range(len(found)), key=lambda k: outline.rank(loops_of_rims[k]))
    return [found[k] for k in order], [loops_of_rims[k] for k in order]


def _edge_starts(outline, loop):
    return [at for at in outline.joints if at in loop]


def _assembled(panels, rims, loops_of_rims, laid, rings, placed, chart, outline):
    lattice, uv = laid
    final = Rings.of(panels)
    used = np.unique(final.nodes)
    number = np.full(len(placed.place), -1)
    number[used] = np.arange(len(used))
    nodes = np.empty((len(used), 3))
    at_border = placed.place[used] >= 0.0
    places = placed.place[used[at_border]]
    nodes[at_border] = outline.points(places)
    if not at_border.all():
        nodes[~at_border] = surface.sample(chart, uv[used[~at_border]])
    members = _members(final, rims, lattice, rings, placed)
    renumbered = Rings(number[final.nodes], final.first, final.panel, final.edges, final.edge)
    corners = np.flatnonzero(np.isin(placed.place[used], outline.corners) & at_border)
    of_outer = outline.loop_of(placed.place[used[corners]]) == loops_of_rims[0]
    return TrimmedNet(
        nodes=nodes,
        uv=placed.xy[used] / outline.extent,
        closed=(chart.closed_u, chart.closed_v),
        poles=chart.poles,
        members=number[members],
        panels=renumbered.select(np.arange(len(panels))),
        rims=tuple(number[rim] for rim in rims),
        edge_nodes=_edge_nodes(np.flatnonzero(at_border), places, outline),
        corners=corners[of_outer],
    )


def _members(final, rims, lattice, rings, placed):
    """(m, 2) edges of panels that are members of the lattice, or parts of those, or on the border."""
    count = len(placed.place)
    key = np.sort(np.asarray(lattice.members), axis=1).astype(np.int64) @ [count, 1]
    parents = rings.edges @ [count, 1]
    is_member = np.isin(parents, key)
    of_cut = np.zeros(count, dtype=bool)
    cut = placed.cut_node >= 0
    of_cut[placed.cut_node[cut]] = is_member[cut]
    low, high = final.edges.T
    kept = np.where(high < len(lattice.uv), np.isin(final.edges @ [count, 1], key), of_cut[high])
    around = np.concatenate([np.sort(np.column_stack([rim, np.roll(rim, -1)]), axis=1) for rim in rims])
    kept |= np.isin(final.edges @ [count, 1], around @ [count, 1])
    members = [final.edges[kept]]
    across = np.setdiff1d(key, parents)
    if len(across):
        # Members across a panel stay where all of it does.
        squares = final.first[:-1][np.diff(final.first) == 4]
        diagonals = np.concatenate(
            [np.column_stack([final.nodes[squares + k], final.nodes[squares + k + 2]]) for k in (0, 1)]
        )
        diagonals = np.sort(diagonals, axis=1)
        members.append(diagonals[np.isin(diagonals @ [count, 1], across)])
    return np.concatenate(members)


def _edge_nodes(nodes, places, outline):
    """{"Edge3": nodes on that edge in order along it}."""
    found = {}
    edges, parameters = outline.parameters(places)
    for node, place, edge, parameter in zip(
        nodes.tolist(), places.tolist(), edges.tolist(), parameters.tolist()
    ):
        found.setdefault(edge, []).append((parameter, node))
        before = outline.joints.get(place)
        if before is not None and before[0] != edge:
            found.setdefault(before[0], []).append((before[1], node))
    return {
        f"Edge{edge + 1}": np.array([node for _, node in sorted(on_it)])
        for edge, on_it in sorted(found.items())
    }
