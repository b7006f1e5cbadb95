# SPDX-License-Identifier: LGPL-2.1-or-later
"""One connected net on several faces of a body: as many cells on both sides of each edge that they share.

Lengths are millimetres, as in FreeCAD.
"""

from collections import defaultdict, deque
from dataclasses import dataclass

import numpy as np

import funicular as fn

from . import surface, topology
from .lattices import ACROSS, lattice_on
from .laying import Laid, cells_of, place, refuse_pinches

# Nodes of two faces on their common edge are one if nearer than this part of the step.
SAME_NODE = 1e-3

# What periods of patterns can ask for: each round makes a count larger.
MOST_ROUNDS = 8


@dataclass
class _Part:
    """One of the faces: its chart, its cells along u and v, and what was laid on it."""

    name: str
    chart: object
    side_of: dict  # number of an edge of the body → the name of the side that it is
    cells: list
    lattice: object = None
    nodes: np.ndarray = None


def lay_on_faces(source, division):
    """The Laid net on the faces of a features.source.Faces.

    The number of cells is one along all faces that face each other across common edges: the mean of what each
    would have. Raises InvalidInput naming a face or an edge.
    """
    parts = [_read(face, name, source.body, division) for face, name in zip(source.faces, source.names)]
    shared = _shared_edges(parts)
    wanted = [tuple(part.cells) for part in parts]
    _agree(parts, shared)
    for _ in range(MOST_ROUNDS):
        for part in parts:
            part.lattice, uv = _lattice(part, division)
            part.uv = uv
        if not _grow(parts, division):
            break
        _agree(parts, shared, larger=True)
    for part in parts:
        part.nodes = place(part.chart, part.uv, division)
        refuse_pinches(part.nodes, part.lattice.members, part.chart.size, part.name)
    return _welded(parts, shared, division, tuple(_changed(parts, wanted)))


def _read(face, name, body, division):
    chart = surface.read_face(face, name)
    cells = cells_of(chart, division)
    return _Part(name, chart, _sides(face, chart, body), list(cells))


def _sides(face, chart, body):
    """Which side of the chart each edge of a face is, by the number of the edge in the body.

    Seams, where the face meets itself, and edges without length are left out.
    """
    share = np.linspace(0.0, 1.0, 65)
    ends = {"u_min": (0.0 * share, share), "u_max": (0.0 * share + 1.0, share)}
    ends |= {"v_min": (share, 0.0 * share), "v_max": (share, 0.0 * share + 1.0)}
    lines = {side: chart.point(*uv) for side, uv in ends.items() if side not in chart.poles}
    side_of = {}
    for edge in face.Edges:
        if edge.Degenerated or edge.isSeam(face):
            continue
        first, last = edge.ParameterRange
        middle = np.array(tuple(edge.valueAt(0.5 * (first + last))))
        side_of[_number(edge, body)] = min(lines, key=lambda side: _distance(middle, lines[side]))
    return side_of


def _distance(point, line):
    """To the nearest segment of a line of points."""
    start, along = line[:-1], np.diff(line, axis=0)
    length2 = np.maximum((along**2).sum(axis=1), 1e-300)
    at = np.clip(((point - start) * along).sum(axis=1) / length2, 0.0, 1.0)
    return np.linalg.norm(start + at[:, None] * along - point, axis=1).min()


def _number(edge, body):
    return next(number for number, other in enumerate(body.Edges, 1) if other.isSame(edge))


def _shared_edges(parts):
    """[(edge, (part, side), (part, side))] of the edges that two parts share.

    Raises InvalidInput where three do, where an edge is the whole of one side and part of another, and where
    the parts do not hang together.
    """
    users = defaultdict(list)
    for at, part in enumerate(parts):
        for edge, side in part.side_of.items():
            users[edge].append((at, side))
    shared = []
    for edge, of_edge in sorted(users.items()):
        names = ", ".join(_short(parts[at].name) for at, _ in of_edge)
        if len(of_edge) > 2:
            raise fn.InvalidInput(f"{len(of_edge)} of the faces meet in Edge{edge} ({names}): leave one out")
        if len(of_edge) < 2:
            continue
        for at, side in of_edge:
            others = [other for other, its in parts[at].side_of.items() if its == side and other != edge]
            if others:
                raise fn.InvalidInput(
                    f"Edge{edge} between {names} is only a part of a side of {_short(parts[at].name)}, and "
                    f"Edge{others[0]} another: nodes would not meet there; split that face at their common "
                    "vertex"
                )
        shared.append((edge, *of_edge))
    reached = _walk(len(parts), shared)
    if len(reached) < len(parts):
        lonely = next(at for at in range(len(parts)) if at not in reached)
        raise fn.InvalidInput(
            f"{_short(parts[lonely].name)} shares no edge with {_short(parts[0].name)} and what hangs on it: "
            "pick faces that are neighbours, or make a net on each part"
        )
    return shared


def _short(name):
    return name.rpartition(".")[2]


def _walk(count, shared):
    """{part: (edge, the part that it was reached from)} from the first part over shared edges."""
    reached, queue = {0: None}, deque([0])
    while queue:
        at = queue.popleft()
        for edge, (one, _), (other, _) in shared:
            if at in (one, other):
                next_one = other if at == one else one
                if next_one not in reached:
                    reached[next_one] = (edge, at)
                    queue.append(next_one)
    return reached


def _agree(parts, shared, larger=False):
    """Gives all sides that face each other one number of cells: the mean, or the largest."""
    groups = {(at, axis): {(at, axis)} for at in range(len(parts)) for axis in (0, 1)}
    for _, *ends in shared:
        # Along the sides of u the cells of v are counted.
        one, other = ((at, 1 if side.startswith("u") else 0) for at, side in ends)
        joined = groups[one] | groups[other]
        for each in joined:
            groups[each] = joined
    for group in groups.values():
        counts = [parts[at].cells[axis] for at, axis in group]
        count = max(counts) if larger else max(round(sum(counts) / len(counts)), 1)
        for at, axis in group:
            closed = (parts[at].chart.closed_u, parts[at].chart.closed_v)[axis]
            parts[at].cells[axis] = max(count, 3) if closed else count


def _lattice(part, division):
    closed = part.chart.closed_u, part.chart.closed_v
    return lattice_on(part.cells, closed, part.chart.poles, division.pattern, division.swapped)


def _grow(parts, division):
    """Takes over the counts that patterns have forced on closed faces; whether there were any."""
    grown = False
    for part in parts:
        made = part.lattice.cells[::-1] if division.swapped else part.lattice.cells
        grown |= list(made) != part.cells
        part.cells = list(made)
    return grown


def _changed(parts, wanted):
    for part, asked in zip(parts, wanted):
        for axis, count, had in zip("uv", part.cells, asked):
            if count != had:
                yield (
                    f"{count} cells along {axis} of {_short(part.name)}, not {had}, to meet its neighbours"
                )


def _welded(parts, shared, division, remarks):
    """The Laid net of all parts, whose nodes on shared edges become one."""
    starts = np.cumsum([0] + [len(part.nodes) for part in parts])
    limit = SAME_NODE * min(_shortest(part) for part in parts)
    turned = {0: False}
    pairs, met = {}, [np.empty((0, 2), dtype=int)]
    for edge, (one, side), (other, across) in shared:
        mine, yours = _on_side(parts[one], side, division), _on_side(parts[other], across, division)
        forwards = _matches(parts[one].nodes[mine], parts[other].nodes[yours], limit)
        backwards = not forwards and _matches(parts[one].nodes[mine], parts[other].nodes[yours[::-1]], limit)
        if not (forwards or backwards):
            raise fn.InvalidInput(
                f"the nodes of {_short(parts[one].name)} and {_short(parts[other].name)} do not meet along "
                f"Edge{edge} ({len(mine)} and {len(yours)} of them): choose another Pattern, such as Quad"
            )
        pairs[edge] = mine, yours if forwards else yours[::-1]
        met.append(np.column_stack([starts[one] + mine, starts[other] + pairs[edge][1]]))
    kept, number = np.unique(topology.parts(starts[-1], np.vstack(met)), return_inverse=True)
    for at, step in _walk(len(parts), shared).items():
        if step is not None:
            turned[at] = _runs_alike(parts, step, at, pairs, shared) ^ turned[step[1]]
    members, panels = {}, []
    for at, part in enumerate(parts):
        for a, b in number[starts[at] + part.lattice.members].tolist():
            members.setdefault((min(a, b), max(a, b)), (a, b))
        for panel in part.lattice.panels:
            around = number[starts[at] + np.array(panel)].tolist()
            panels.append(tuple(around[::-1] if turned[at] else around))
    nodes = np.concatenate([part.nodes for part in parts])[kept]
    return Laid(nodes, np.array(list(members.values())), tuple(panels), remarks=remarks)


def _shortest(part):
    ends = part.nodes[part.lattice.members]
    return np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).min()


def _on_side(part, side, division):
    """Nodes along a side of a part, in order; the first once more at the end of a closed one."""
    return np.asarray(part.lattice.sides[ACROSS[side] if division.swapped else side])


def _matches(points, others, limit):
    return len(points) == len(others) and bool((np.linalg.norm(points - others, axis=1) <= limit).all())


def _runs_alike(parts, step, at, pairs, shared):
    """Whether the panels on both sides of an edge run along it the same way round, so that one set turns."""
    edge, before = step
    _, (one, _), _ = next(each for each in shared if each[0] == edge)
    mine, yours = pairs[edge]
    first, second = (mine, yours) if one == before else (yours, mine)
    return _first_run(parts[before], first) == _first_run(parts[at], second)


def _first_run(part, side):
    """Whether the panel on the first member of a side runs along it; panels of a part all turn alike."""
    along = {(int(a), int(b)) for a, b in zip(side, side[1:])}
    for panel in part.lattice.panels:
        for a, b in zip(panel, panel[1:] + panel[:1]):
            if (a, b) in along:
                return True
            if (b, a) in along:
                return False
    return True
