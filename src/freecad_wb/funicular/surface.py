# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading of a FreeCAD face: its parametrisation, the cells it takes, where the nodes of a lattice lie.

Lengths are millimetres throughout, as in FreeCAD; metres begin where a `funicular.Net` is built.
"""

from dataclasses import dataclass

import numpy as np
import Part

import funicular as fn

from .arc_lengths import FEWEST, Axis, Table

# How far a share of arc length may be from the one that is asked for: sought, and at most.
SHARE_ERROR = 1e-6
LARGEST_SHARE_ERROR = 1e-4

# Points of a table: what bounds its time (1 µs a point) and its memory.
MOST_POINTS = 400_000
MOST_KNOTS = 240

# Nodes whose shares are measured again, along the isolines themselves.
PROBES = 24

# What counts as one point, relative to the size of the face: OCCT's own confusion is 1e-7 mm on metres.
COINCIDENT = 1e-7

# Beyond this a step is a slip of the unit rather than a wish.
MOST_NODES = 1_000_000

SIDES = ("u_min", "u_max", "v_min", "v_max")

TRIMMED = (
    "is trimmed (its outline is not the full rectangle of the surface's parameters, or it has a hole), and "
    "nets on several faces need whole ones: pick it alone, or rebuild it as a surface of its own between its "
    "edges, for instance a ruled, lofted, swept or B-spline surface"
)


@dataclass(frozen=True)
class Chart:
    """A face seen as a map from the unit square: `point(a, b)` with a along u and b along v.

    size: diagonal of the bounding box of the sampled face [mm].
    closed_u, closed_v: the side u = 1 (v = 1) coincides with u = 0 (v = 0).
    poles: the sides that are one single point, a subset of SIDES.
    table: of arc lengths along the isolines.
    measure: (a, b) -> (share along u, share along v) by FreeCAD's own integration, slow; None on a plane.
    """

    point: object
    size: float
    closed_u: bool
    closed_v: bool
    poles: frozenset
    table: Table
    measure: object


def read_face(face, name="the face"):
    """The chart of an untrimmed face.

    face: Part.Face, placed as it stands in the document. name: how errors call it.
    Raises InvalidInput: not a face, endless, trimmed, or of zero area.
    """
    limits = _limits(face, name)
    if _fills_rectangle(face, limits):
        return make_chart(face.Area, name, *_on_surface(face.Surface, limits))
    corners = _rectangle_corners(face)
    if corners is None:
        raise fn.InvalidInput(f"{name} {TRIMMED}")
    origin, along, _, across = corners
    return make_chart(face.Area, name, *_on_plane(origin, along - origin, across - origin))


def is_trimmed(face, name="the face"):
    """Whether a face is less than the rectangle of its parameters, so that read_face() refuses it.

    Raises InvalidInput as read_face() does for what is no face, or endless.
    """
    limits = _limits(face, name)
    return not _fills_rectangle(face, limits) and _rectangle_corners(face) is None


def read_rectangle(face, name="the face"):
    """(chart, to_square) of the whole rectangle of parameters that a face, trimmed or not, lies in.

    Of a plane face it is the smallest one along its longest straight edge, or along the axes of the plane.
    to_square: (n, 2) parameters (u, v) of the surface -> (n, 2) parameters (a, b) of the chart, which lie
    beyond [0, 1] where u and v lie beyond the rectangle. Raises InvalidInput as read_face, but for trimming.
    """
    limits = _limits(face, name)
    surface = face.Surface
    if not isinstance(surface, Part.Plane):
        low, span = np.array(limits[::2]), np.array(limits[1::2]) - limits[::2]
        chart = make_chart(face.Area, name, *_on_surface(surface, limits))
        return chart, lambda uv: (uv - low) / span

    axes = _plane_axes(face)
    turned = _outline_points(face, 1025) @ axes
    low, span = turned.min(axis=0), np.ptp(turned, axis=0)
    origin, along, across = (
        np.array(tuple(surface.value(*at))) for at in (low @ axes.T, *((low + np.diag(span)) @ axes.T))
    )
    chart = make_chart(face.Area, name, *_on_plane(origin, along - origin, across - origin))
    return chart, lambda uv: (uv @ axes - low) / span


def _limits(face, name):
    if face is None or face.isNull() or face.ShapeType != "Face":
        raise fn.InvalidInput(f"{name} is not a face: pick one face of a shape")
    limits = face.ParameterRange
    if max(abs(limit) for limit in limits) > 1e50:
        raise fn.InvalidInput(f"{name} is endless: pick a face with an outline")
    return limits


def make_chart(area, name, point, measure, knots):
    """The Chart of a map from the unit square. area: of the surface [mm²]; name: how errors call it.

    knots: ascending in (0, 1), along u and along v, between which the map is smooth; None for a flat one.
    measure: as in a Chart. Raises InvalidInput for points that are not finite and for zero area.
    """
    axes = [Axis(intervals=FEWEST)] * 2 if knots is None else [Axis(of_one) for of_one in knots]
    points = _grid(point, *axes)
    if not np.isfinite(points).all():
        raise fn.InvalidInput(
            f"{name} has points that are not finite: check the shape (Part, Check geometry)"
        )
    size = float(np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0)))
    if size == 0.0 or abs(area) <= COINCIDENT**2 * size**2 or _area(points) <= COINCIDENT * size**2:
        raise fn.InvalidInput(f"{name} has no area: pick a face that spans a surface")

    poles = frozenset(
        side
        for side, line in zip(SIDES, (points[0], points[-1], points[:, 0], points[:, -1]))
        if _coincide(line, line[:1], size)
    )
    table = _refined(Table.of(*axes, points), point, measure, knots)
    # Asked of the face itself: Surface.isUClosed() speaks of the whole surface, of which the face may be a
    # part, and a loft may close on itself without a seam edge.
    return Chart(
        point=point,
        size=size,
        closed_u=_coincide(points[0], points[-1], size) and not poles & {"u_min", "u_max"},
        closed_v=_coincide(points[:, 0], points[:, -1], size) and not poles & {"v_min", "v_max"},
        poles=poles,
        table=table,
        measure=measure,
    )


def _grid(point, axis_u, axis_v):
    a, b = np.meshgrid(axis_u.lines, axis_v.lines, indexing="ij")
    return point(a.ravel(), b.ravel()).reshape(*a.shape, 3)


def _refined(table, point, measure, knots):
    """The table, or a finer one where it errs: a busy face has more between knots than four lines hold."""
    fineness = 1
    # Spread without a pattern of their own, apart from the lines of any table.
    a, b = (np.arange(1, PROBES + 1)[:, None] * [0.7548776662466927, 0.5698402909980532] % 1.0).T
    while measure is not None:
        errors = np.abs(np.subtract(table.shares(a, b), measure(a, b)))
        error = np.nanmax(errors, initial=0.0)
        if error <= 0.1 * SHARE_ERROR or 4 * table.along_u.size > MOST_POINTS:
            break
        fineness *= 2
        axes = [Axis(of_one, fineness) for of_one in knots]
        table = Table.of(*axes, _grid(point, *axes))
    return table


def count_cells(chart, step_u, step_v, pattern="quad", counts=(0, 0), swapped=False):
    """Cells along u and along v: the mean length of the isolines over that of a cell [mm], rounded.

    step_u, step_v: lengths of members along u and along v, of which the pattern makes its cells. counts:
    cells along u and along v that are wanted whatever the steps; 0 for none. swapped: the pattern's u runs
    along v. At least 1, 2 between two poles and 3 around a closed direction. Raises InvalidInput naming the
    step.
    """
    cells = []
    along_u, along_v = fn.cell_extent(pattern)[:: -1 if swapped else 1]
    for name, step, count, extent, lengths, closed, ends in (
        ("StepU", step_u, counts[0], along_u, chart.table.lengths_u, chart.closed_u, SIDES[:2]),
        ("StepV", step_v, counts[1], along_v, chart.table.lengths_v, chart.closed_v, SIDES[2:]),
    ):
        if not count:
            count = _cells_of_step(name, step, extent, lengths)
        cells.append(max(count, 3 if closed else 2 if set(ends) <= chart.poles else 1))
    if (cells[0] + 1) * (cells[1] + 1) > MOST_NODES:
        given = (
            f"Count{axis} = {count}" if count else f"Step{axis} = {step:g} mm"
            for axis, count, step in zip("UV", counts, (step_u, step_v))
        )
        raise fn.InvalidInput(
            f"{' and '.join(given)} would make {cells[0]} × {cells[1]} cells, "
            f"more than {MOST_NODES} nodes: give larger steps"
        )
    return tuple(cells)


def _cells_of_step(name, step, extent, lengths):
    if not step > 0.0:
        raise fn.InvalidInput(f"{name} is {step:g} mm: give a length greater than zero")
    longest = lengths.max()
    if step > longest * (1.0 + 1e-9):
        raise fn.InvalidInput(
            f"{name} is {step:g} mm, larger than the face, whose longest isoline in that direction "
            f"measures {longest:.6g} mm: give a smaller step"
        )
    return round(float(lengths.mean()) / (extent * step))


def sample(chart, uv):
    """Points of the face at equal arc-length steps along the isolines: (n, 3) [mm].

    uv: (n, 2) in [0, 1]². The point of (s, t) is the crossing of two isolines of the surface such that s of
    the length of the one along u, and t of the length of the one along v, lie before it.
    Raises InvalidInput where the face folds so much that no such crossing is found.
    """
    s, t = np.asarray(uv, dtype=float).T
    a, b = chart.table.crossings(s, t)
    for parameter, share in ((a, s), (b, t)):
        np.clip(parameter, 0.0, 1.0, out=parameter)
        parameter[share == 0.0] = 0.0
        parameter[share == 1.0] = 1.0
    along_u, along_v = chart.table.shares(a, b)
    missed = np.maximum(np.abs(along_u - s), np.abs(along_v - t))
    # Shares have no meaning on a side that has no length.
    at_pole = np.zeros(len(s), dtype=bool)
    for side in chart.poles:
        at_pole |= (s if side[0] == "u" else t) == (0.0 if side.endswith("min") else 1.0)
    missed[at_pole] = 0.0
    if chart.measure is not None:
        probes = np.flatnonzero(~at_pole)
        probes = probes[np.linspace(0, len(probes) - 1, min(PROBES, len(probes))).astype(int)]
        along_u, along_v = chart.measure(a[probes], b[probes])
        measured = np.maximum(np.abs(along_u - s[probes]), np.abs(along_v - t[probes]))
        missed[probes] = np.where(measured > LARGEST_SHARE_ERROR, measured, missed[probes])
    worst = int(np.argmax(missed))
    if missed[worst] > SHARE_ERROR:
        raise fn.InvalidInput(
            f"the isolines of the face cannot be divided into equal lengths in both directions "
            f"(node {worst}, at {s[worst]:.3g}, {t[worst]:.3g}): the face is too folded or too unevenly "
            "parametrised; rebuild it with fewer, evenly spaced poles"
        )
    return chart.point(a, b)


def _on_plane(origin, along, across):
    """(point, measure, knots) as _on_surface, of the rectangle of two vectors from a corner: no knots."""

    def on_plane(a, b):
        return origin + np.outer(a, along) + np.outer(b, across)

    return on_plane, None, None


def _on_surface(surface, limits):
    """(point, measure) as in a Chart, and the inner knots along u and along v, in (0, 1)."""
    u_first, u_last, v_first, v_last = limits
    if isinstance(surface, Part.Plane):
        corners = (u_first, v_first), (u_last, v_first), (u_first, v_last)
        origin, along, across = (np.array(tuple(surface.value(*corner))) for corner in corners)
        return _on_plane(origin, along - origin, across - origin)

    def on_surface(a, b):
        us = (u_first + (u_last - u_first) * a).tolist()
        vs = (v_first + (v_last - v_first) * b).tolist()
        value = surface.value
        return np.array([(p.x, p.y, p.z) for p in map(value, us, vs)]).reshape(-1, 3)

    def measure(a, b):
        us, vs = u_first + (u_last - u_first) * a, v_first + (v_last - v_first) * b
        along_u = [_share(surface.vIso(v), u_first, u, u_last) for u, v in zip(us.tolist(), vs.tolist())]
        along_v = [_share(surface.uIso(u), v_first, v, v_last) for u, v in zip(us.tolist(), vs.tolist())]
        return np.array(along_u), np.array(along_v)

    of_u, of_v = _knots(surface)
    return on_surface, measure, (_inner(of_u, u_first, u_last), _inner(of_v, v_first, v_last))


def _share(curve, first, at, last):
    """Of the curve's length before a parameter; nan where it has none."""
    whole = curve.length(first, last)
    return curve.length(first, at) / whole if whole > 0.0 else np.nan


def _knots(surface):
    """Knots along u and along v, where the surface or what it is made from has them."""
    if isinstance(surface, Part.OffsetSurface):
        return _knots(surface.BasisSurface)
    if hasattr(surface, "getUKnots"):
        return surface.getUKnots(), surface.getVKnots()
    curve = getattr(surface, "BasisCurve", None)
    of_curve = curve.getKnots() if hasattr(curve, "getKnots") else ()
    return ((), of_curve) if isinstance(surface, Part.SurfaceOfRevolution) else (of_curve, ())


def _inner(knots, first, last):
    """The knots within a range, mapped to (0, 1), thinned where a table could not hold as many."""
    inner = np.unique((np.array(knots, dtype=float) - first) / (last - first))
    inner = inner[(inner > 1e-9) & (inner < 1.0 - 1e-9)]
    if len(inner) <= MOST_KNOTS:
        return inner
    return inner[np.linspace(0, len(inner) - 1, MOST_KNOTS).astype(int)]


def _fills_rectangle(face, limits):
    """Whether the face has one outline and each of its edges lies on a side of the parameter rectangle."""
    if len(face.Wires) != 1:
        return False
    low = np.array([limits[0], limits[2]])
    span = np.array([limits[1], limits[3]]) - low
    if not span.all():
        return False
    for edge in face.OuterWire.OrderedEdges:
        in_parameters = face.curveOnSurface(edge)
        if in_parameters is None:
            return False
        curve, first, last = in_parameters
        at = np.array([(p.x, p.y) for p in map(curve.value, np.linspace(first, last, 17).tolist())])
        at = (at - low) / span
        if not (np.ptp(at, axis=0) < 1e-6).any() or not (np.abs(at.round() - at) < 1e-6).all(axis=0).any():
            return False
    return True


def _rectangle_corners(face):
    """(4, 3) corners of a plane rectangle, None for any other face.

    A plane has no axes of its own, so a rectangle is untrimmed whichever way it is turned on its plane.
    """
    vertices = face.OuterWire.OrderedVertexes
    if not isinstance(face.Surface, Part.Plane) or len(face.Wires) != 1 or len(vertices) != 4:
        return None
    if not all(isinstance(edge.Curve, (Part.Line, Part.LineSegment)) for edge in face.Edges):
        return None
    corners = np.array([tuple(vertex.Point) for vertex in vertices])
    sides = np.roll(corners, -1, axis=0) - corners
    size2 = (sides**2).sum()
    if np.abs(sides[0] + sides[2]).max() ** 2 > 1e-14 * size2 or abs(sides[0] @ sides[1]) > 1e-7 * size2:
        return None
    return corners


def _outline_points(face, count):
    """(n, 2) parameters (u, v) along all edges of a face, count of each."""
    points = []
    for edge in face.Edges:
        curve, first, last = face.curveOnSurface(edge)
        points += [(p.x, p.y) for p in map(curve.value, np.linspace(first, last, count).tolist())]
    return np.array(points)


def _plane_axes(face):
    """(2, 2): columns along and across the longest straight edge of a plane face, in its parameters.

    Of the two the one nearer to the plane's own first axis comes first; of edges of one length, the one that
    turns the axes least; without straight edges they are the plane's own.
    """
    straight = []
    for edge in face.Edges:
        if isinstance(edge.Curve, (Part.Line, Part.LineSegment)):
            curve, first, last = face.curveOnSurface(edge)
            along = curve.value(last) - curve.value(first)
            angle = np.arctan2(along.y, along.x)
            straight.append((np.hypot(along.x, along.y), angle - np.pi / 2 * np.round(angle / (np.pi / 2))))
    longest = max((length for length, _ in straight), default=0.0)
    turns = [angle for length, angle in straight if length >= longest * (1.0 - 1e-6)]
    turn = min(turns, key=lambda angle: (round(abs(angle), 9), -angle), default=0.0)
    return np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])


def _coincide(line, other, size):
    return bool(np.linalg.norm(line - other, axis=1).max() <= COINCIDENT * size)


def _area(points):
    diagonals = points[1:, 1:] - points[:-1, :-1], points[:-1, 1:] - points[1:, :-1]
    return 0.5 * np.linalg.norm(np.cross(*diagonals), axis=2).sum()
