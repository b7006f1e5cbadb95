# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outline of a trimmed face: its edges as fine polylines in the plane of a lattice.

That plane has members of length one: x = s · (cells along u) · (extent of a cell along u), and y likewise. In
a closed direction it repeats after its period. Seams and poles are no outline, but tell what lies inside.
"""

from dataclasses import dataclass

import numpy as np

import funicular as fn

from .buckets import Buckets

# Segments of the polylines to the length of a member, and for one edge at least and at most.
FINENESS = 16
FEWEST, MOST = 24, 20_000

# Where the outline turns by more, a vertex is a corner [rad].
SHARP = np.radians(30.0)

# Nearer to a border of the rectangle than this, in members, an edge lies on it.
ON_SIDE = 1e-4

# How far apart the surface over a trimming curve and the edge itself may be [mm]; beyond it the edge counts.
APART = 1e-4

SIDES = ("u_min", "u_max", "v_min", "v_max")

# A share of a segment this near to one is its end.
ROUNDING = 1e-9

# What of the period a ray keeps away from the ends of the rectangle, where edges begin and end.
INDENT = 1e-4


@dataclass(frozen=True)
class Outline:
    """Closed loops of segments, one loop after the other; a place is a segment's number plus a share of it.

    face: the Part.Face. curves: of each edge, in the parameters of the surface.
    start, end: (m, 2) ends of the segments; the end of one is the start of the next in its loop.
    edge, first, last: (m,) index in face.Edges, its parameter at the start and at the end of the segment.
    loops: tuple of ranges of segments.
    corners: segments at whose start the outline turns sharply, ascending.
    joints: {segment at whose start one edge meets the next: (edge before, its parameter there)}
    fence: (starts, ends) of segments that part inside from outside, seams and poles among them.
    extent, period: (2,) size of the rectangle, and after what the plane repeats, inf where it does not.
    """

    face: object
    curves: tuple
    start: np.ndarray
    end: np.ndarray
    edge: np.ndarray
    first: np.ndarray
    last: np.ndarray
    loops: tuple
    corners: np.ndarray
    joints: dict
    fence: tuple
    extent: np.ndarray
    period: np.ndarray

    def loop_of(self, places):
        """Number of the loop that each place lies on."""
        return np.searchsorted([loop.stop for loop in self.loops], places, side="right")

    def parameters(self, places):
        """(edge, parameter of its curve) at each place."""
        segment = np.minimum(np.asarray(places, dtype=float).astype(int), len(self.edge) - 1)
        share = places - segment
        return self.edge[segment], self.first[segment] * (1 - share) + self.last[segment] * share

    def plane(self, places):
        """(n, 2) positions of places in the plane of the lattice."""
        segment = np.minimum(np.asarray(places, dtype=float).astype(int), len(self.edge) - 1)
        share = (places - segment)[:, None]
        return self.start[segment] * (1 - share) + self.end[segment] * share

    def points(self, places):
        """(n, 3) points [mm] on the edges themselves, and on the surface."""
        surface, edges = self.face.Surface, self.face.Edges
        found = []
        for edge, parameter in zip(*(each.tolist() for each in self.parameters(places))):
            uv = self.curves[edge].value(parameter)
            point = surface.value(uv.x, uv.y)
            on_edge = edges[edge].valueAt(parameter)
            if (point - on_edge).Length > APART:
                point = surface.value(*surface.parameter(on_edge))
            found.append(tuple(point))
        return np.array(found).reshape(-1, 3)

    def offset(self, vectors):
        """Differences of positions, in a closed direction the shortest."""
        with np.errstate(invalid="ignore"):
            return vectors - np.where(
                np.isfinite(self.period), self.period * np.round(vectors / self.period), 0.0
            )

    def nearest(self, points):
        """(place, distance) of what is nearest on the outline to each point; inf beyond about 1."""
        buckets = Buckets(self.extent, self.period, points)
        segment, point = buckets.pairs(self.start)
        apart = np.linalg.norm(self.offset(points[point] - self.start[segment]), axis=1)
        order = np.lexsort((segment, apart, point))
        point, segment = point[order], segment[order]
        _, leading = np.unique(point, return_index=True)
        point, segment = point[leading], segment[leading]
        places, distances = np.full(len(points), -1.0), np.full(len(points), np.inf)
        for beside in (self.before(segment), segment):
            along = self.end[beside] - self.start[beside]
            away = self.offset(points[point] - self.start[beside])
            share = np.clip((away * along).sum(axis=1) / np.maximum((along**2).sum(axis=1), 1e-300), 0, 1)
            apart = np.linalg.norm(away - share[:, None] * along, axis=1)
            place = np.where(share < 1.0 - ROUNDING, beside + share, self._after(beside))
            better = apart < distances[point] * (1.0 - 1e-12)
            places[point[better]], distances[point[better]] = place[better], apart[better]
        return places, distances

    def rise(self, place, other):
        """How far the outline goes away from the chord between two places of it, the short way round."""
        loop = self.loops[int(self.loop_of([place])[0])]
        if not loop.start <= other < loop.stop:
            return np.inf
        low, high = sorted((place, other))
        ways = [np.arange(np.ceil(low), np.floor(high) + 1)]
        ways.append(np.concatenate([np.arange(np.ceil(high), loop.stop), np.arange(loop.start, low)]))
        between = min(ways, key=len).astype(int)
        between = np.where(between == loop.stop, loop.start, between)
        if not len(between):
            return 0.0
        first, last = self.plane(np.array([place, other], dtype=float))
        chord = self.offset(last - first)
        away = self.offset(self.start[between] - first)
        share = np.clip(away @ chord / max(chord @ chord, 1e-300), 0.0, 1.0)
        return np.linalg.norm(away - share[:, None] * chord, axis=1).max()

    def long_ways(self, places, rise):
        """Pairs of places that follow each other round a loop, between which it may rise by so much."""
        following = np.roll(places, -1)
        loop = self.loops[int(self.loop_of(places[:1])[0])]
        segments = np.abs(following - places)
        segments = np.minimum(segments, len(loop) - segments) + 1.0
        longest = np.linalg.norm(self.end[list(loop)] - self.start[list(loop)], axis=1).max()
        chords = np.linalg.norm(self.offset(self.plane(following) - self.plane(places)), axis=1)
        # The way from one to the other by a point beside the middle of the chord is the shortest.
        may = (segments * longest) ** 2 >= chords**2 + (2.0 * rise) ** 2
        return np.column_stack([places, following])[may].tolist()

    def nearest_to_side(self, point, axis):
        """(place, distance) of what is nearest to a pole: a point that is all of a side across an axis."""
        apart = np.abs(self.start[:, axis] - point[axis])
        place = int(np.argmin(apart))
        return place, apart[place]

    def crossings(self, ends_a, ends_b):
        """All (line, share of the line, place) at which lines from a to b, at most about 1.5 long, cross."""
        half = 0.5 * self.offset(ends_b - ends_a)
        middle = ends_a + half
        segment, line = Buckets(self.extent, self.period, middle).pairs(0.5 * (self.start + self.end))
        to_start = self.offset(self.start[segment] - middle[line]) + half[line]
        to_end = to_start + self.end[segment] - self.start[segment]
        along = 2.0 * half[line]
        side_start, side_end = _cross(along, to_start), _cross(along, to_end)
        changes = (side_start < 0.0) != (side_end < 0.0)
        segment, line, along = segment[changes], line[changes], along[changes]
        share = side_start[changes] / (side_start[changes] - side_end[changes])
        at = to_start[changes] + share[:, None] * (to_end[changes] - to_start[changes])
        on_line = (at * along).sum(axis=1) / (along**2).sum(axis=1)
        within = (on_line >= 0.0) & (on_line <= 1.0)
        segment, share = segment[within], share[within]
        # What is a start of one segment and an end of another is the start.
        place = np.where(share < 1.0 - ROUNDING, segment + share, self._after(segment))
        return line[within], on_line[within], place

    def inside(self, points):
        """Whether points lie inside, by the parity of what lies below them; beyond the rectangle none."""
        slack = INDENT * self.extent
        beyond = ((points < -slack) | (points > self.extent + slack)) & np.isinf(self.period)
        x, y = points.T.copy()
        extent_x, extent_y = self.extent
        if np.isfinite(self.period[0]):
            x %= self.period[0]
        if np.isfinite(self.period[1]):
            y %= self.period[1]
        # Off the lines on which nodes and vertices meet by design, as their last digits differ.
        x = np.clip(x + 0.123 * INDENT, INDENT * extent_x, (1.0 - INDENT) * extent_x)
        y = np.clip(y, INDENT * extent_y, (1.0 - INDENT) * extent_y)
        start, end = self.fence
        parity = np.zeros(len(x), dtype=bool)
        columns = max(1, int(extent_x))
        width = extent_x / columns
        of_point = np.clip((x / width).astype(int), 0, columns - 1)
        left, right = np.minimum(start[:, 0], end[:, 0]), np.maximum(start[:, 0], end[:, 0])
        for column in np.unique(of_point):
            here = np.flatnonzero(of_point == column)
            below = np.flatnonzero((left <= (column + 1) * width) & (right >= column * width))
            ax, ay, bx, by = (each[below] for each in (*start.T, *end.T))
            at = x[here][:, None]
            spans = (ax <= at) != (bx <= at)
            with np.errstate(divide="ignore", invalid="ignore"):
                height = ay + (by - ay) * ((at - ax) / (bx - ax))
            parity[here] = np.count_nonzero(spans & (height <= y[here][:, None]), axis=1) % 2 == 1
        return parity & ~beyond.any(axis=1)

    def passes(self, first, between, last):
        """Whether a place lies between two others of one loop, the short way round."""
        for loop in self.loops:
            if loop.start <= first < loop.stop:
                break
        if not (loop.start <= between < loop.stop and loop.start <= last < loop.stop):
            return False
        low, high = min(first, last), max(first, last)
        within = low < between < high
        return within if high - low <= len(loop) / 2 else not within and between not in (low, high)

    def width(self, loop):
        """The least extent of a loop over all directions, in members."""
        at = self.start[list(self.loops[loop])]
        steps = self.offset(np.diff(at, axis=0))
        at = np.vstack([np.zeros(2), np.cumsum(steps, axis=0)])
        angles = np.linspace(0.0, np.pi, 36, endpoint=False)
        return np.ptp(at @ [np.cos(angles), np.sin(angles)], axis=0).min()

    def rank(self, loop):
        """What sorts loops: those round a closed direction, then the outer wire's, then the longer ones."""
        segments = list(self.loops[loop])
        steps = self.end[segments] - self.start[segments]
        around = np.abs(steps.sum(axis=0)) > 0.5
        outer = self.face.OuterWire.Edges
        edge = self.face.Edges[self.edge[segments[0]]]
        return (
            not around.any(),
            not any(edge.isSame(each) for each in outer),
            -round(float(np.linalg.norm(steps, axis=1).sum()), 6),
        )

    def before(self, segments):
        return self._turned(segments, -1)

    def _after(self, segments):
        return self._turned(segments, 1)

    def _turned(self, segments, by):
        first = np.array([loop.start for loop in self.loops])[self.loop_of(segments)]
        count = np.array([len(loop) for loop in self.loops])[self.loop_of(segments)]
        return first + (segments - first + by) % count


def _cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def read_outline(face, name, chart, to_square, extent):
    """The Outline of a face in the plane of a lattice that is `extent` (2,) members large.

    chart, to_square: as surface.read_rectangle gives them. Raises InvalidInput where the edges do not close,
    where loops touch, and where there is no outline at all.
    """
    period = np.where([chart.closed_u, chart.closed_v], extent, np.inf)
    curves, lines, fence = _lines(face, name, chart, to_square, extent)
    if not lines:
        raise fn.InvalidInput(f"{name} has no outline: its edges are seams and poles alone")
    pieces, loops, corners, joints = [], [], [], {}
    at = 0
    for chain in _chains(face, lines, chart.size, name):
        begin = at
        for (before, of_before, _), (number, parameters, plane) in zip([chain[-1], *chain], chain):
            joints[at] = (before, float(of_before[-1]))
            arriving = _tangent(face.Edges[before], of_before, -1)
            leaving = _tangent(face.Edges[number], parameters, 0)
            if np.arccos(np.clip(arriving @ leaving, -1.0, 1.0)) > SHARP:
                corners.append(at)
            pieces.append((number, parameters, plane))
            at += len(parameters) - 1
        loops.append(range(begin, at))
    return Outline(
        face=face,
        curves=tuple(curves),
        start=np.concatenate([plane[:-1] for _, _, plane in pieces]),
        end=np.concatenate([plane[1:] for _, _, plane in pieces]),
        edge=np.concatenate([np.full(len(parameters) - 1, number) for number, parameters, _ in pieces]),
        first=np.concatenate([parameters[:-1] for _, parameters, _ in pieces]),
        last=np.concatenate([parameters[1:] for _, parameters, _ in pieces]),
        loops=tuple(loops),
        corners=np.array(corners, dtype=int),
        joints=joints,
        fence=_repeated(fence, period),
        extent=np.asarray(extent, dtype=float),
        period=period,
    )


def _lines(face, name, chart, to_square, extent):
    """(curves, lines, fence): the curve of every edge in the parameters of the surface, (edge, parameters,
    positions in the plane) of those that are outline, and the positions along all of them."""
    closed = np.array([chart.closed_u, chart.closed_v])
    curves, lines, fence = [], [], []
    for number, edge in enumerate(face.Edges):
        found = face.curveOnSurface(edge)
        if found is None:
            raise fn.InvalidInput(
                f"{name} has no trimming curve for Edge{number + 1}: check the shape (Part, Check geometry)"
            )
        curve, first, last = found
        curves.append(curve)
        parameters, plane = _polyline(curve, first, last, chart, to_square, extent, closed)
        on_side = {
            side: np.abs(plane[:, "uv".index(side[0])] - at).max() < ON_SIDE
            for side, at in zip(SIDES, (0.0, extent[0], 0.0, extent[1]))
        }
        is_seam = edge.isSeam(face)
        # A ray downwards meets a seam once only: at the bottom.
        fence.append(plane - [0.0, extent[1]] if is_seam and on_side["v_max"] else plane)
        no_outline = [side for side in SIDES if closed["uv".index(side[0])] or side in chart.poles]
        if not (is_seam or edge.Degenerated or any(on_side[side] for side in no_outline)):
            lines.append((number, parameters, plane))
    return curves, lines, fence


def _polyline(curve, first, last, chart, to_square, extent, closed):
    """(parameters, (n, 2) positions in the plane of the lattice) along an edge, in about equal steps."""
    parameters = np.linspace(first, last, 4 * FEWEST + 1)
    for _ in range(2):
        uv = np.array([(p.x, p.y) for p in map(curve.value, parameters.tolist())])
        plane = _plane(to_square(uv), chart, closed) * extent
        passed = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(plane, axis=0), axis=1))])
        count = int(np.clip(np.ceil(FINENESS * passed[-1]), FEWEST, MOST))
        even = np.interp(np.linspace(0.0, passed[-1], count + 1), passed, parameters)
        even[0], even[-1] = first, last
        parameters, done = even, parameters
    return done, plane


def _plane(square, chart, closed):
    """Shares of arc length of parameters (a, b), which in a closed direction may go on beyond [0, 1]."""
    whole = np.where(closed, np.floor(square), 0.0)
    within = np.clip(square - whole, 0.0, 1.0)
    return np.column_stack(chart.table.shares(*within.T)) + whole


def _repeated(lines, period):
    """(starts, ends) of the segments of lines, and of their like one period on where those reach in."""
    start = np.concatenate([line[:-1] for line in lines])
    end = np.concatenate([line[1:] for line in lines])
    for axis in (0, 1):
        if np.isfinite(period[axis]):
            shift = np.zeros(2)
            shift[axis] = period[axis]
            low, high = np.minimum(start, end)[:, axis], np.maximum(start, end)[:, axis]
            before, after = high > period[axis] * (1 + 1e-9), low < -1e-9 * period[axis]
            start = np.concatenate([start, start[before] - shift, start[after] + shift])
            end = np.concatenate([end, end[before] - shift, end[after] + shift])
    return start, end


def _tangent(edge, parameters, at):
    """Unit tangent [3] of an edge at its first or last parameter, in the sense of the parameters given."""
    tangent = np.array(tuple(edge.tangentAt(float(parameters[at]))))
    return tangent * np.sign(parameters[-1] - parameters[0]) / np.linalg.norm(tangent)


def _chains(face, lines, size, name):
    """Lists of (edge, parameters, plane) that follow each other round each loop, turned where needed.

    By position rather than by the order of a wire, which is not that of the loops on a closed surface.
    """
    ends = np.array([[tuple(face.Edges[n].valueAt(float(t))) for t in (p[0], p[-1])] for n, p, _ in lines])
    flat = ends.reshape(-1, 3)
    near = np.linalg.norm(flat[:, None] - flat[None], axis=2) <= 1e-6 * size
    np.fill_diagonal(near, False)
    for end, others in enumerate(near):
        if np.count_nonzero(others) != 1:
            x, y, z = flat[end].round(3) + 0.0
            what = "touches itself" if others.any() else "is open"
            raise fn.InvalidInput(
                f"{name}: its outline {what} at the end of Edge{lines[end // 2][0] + 1}, at "
                f"({x:g}, {y:g}, {z:g}) mm: mend the shape (Part, Check geometry) or move what touches there"
            )
    partner = near.argmax(axis=1)
    used, chains = set(), []
    for first in range(len(lines)):
        if first in used:
            continue
        chain, at = [], 2 * first
        while at // 2 not in used:
            used.add(at // 2)
            number, parameters, plane = lines[at // 2]
            chain.append(
                (number, parameters, plane) if at % 2 == 0 else (number, parameters[::-1], plane[::-1])
            )
            at = int(partner[at ^ 1])
        chains.append(chain)
    return chains
