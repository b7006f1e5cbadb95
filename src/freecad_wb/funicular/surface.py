# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading of a FreeCAD face: its parametrisation, the cells it takes, where the nodes of a lattice lie.

Lengths are millimetres throughout, as in FreeCAD; metres begin where a `funicular.Net` is built.
"""

from dataclasses import dataclass

import numpy as np
import Part

import funicular as fn

# Intervals of the table of arc lengths, per direction (even, for the extrapolation of chords to arcs).
# 192 keeps the fourth-order error of the table below 1e-6 of a cell on surfaces of ordinary curvature.
TABLE_INTERVALS = 192

# What counts as one point, relative to the size of the face: OCCT's own confusion is 1e-7 mm on metres.
COINCIDENT = 1e-7

# Beyond this a step is a slip of the unit rather than a wish.
MOST_NODES = 1_000_000

SIDES = ("u_min", "u_max", "v_min", "v_max")

TRIMMED = (
    "is trimmed (its outline is not the full rectangle of the surface's parameters, or it has a hole), "
    "and trimmed faces are not supported yet: pick an untrimmed face, or rebuild this one as a surface "
    "of its own between its edges, for instance a ruled, lofted, swept or B-spline surface"
)


@dataclass(frozen=True)
class Chart:
    """A face seen as a map from the unit square: `point(a, b)` with a along u and b along v.

    size: diagonal of the bounding box of the sampled face [mm].
    closed_u, closed_v: the side u = 1 (v = 1) coincides with u = 0 (v = 0).
    poles: the sides that are one single point, a subset of SIDES.
    lengths_u, lengths_v: (TABLE_INTERVALS + 1,) lengths of the isolines that run along u (along v) [mm].
    along_u, along_v: square tables, indexed [a, b]: the part of the isoline's length before (a, b).
    """

    point: object
    size: float
    closed_u: bool
    closed_v: bool
    poles: frozenset
    lengths_u: np.ndarray
    lengths_v: np.ndarray
    along_u: np.ndarray
    along_v: np.ndarray


def read_face(face, name="the face"):
    """The chart of an untrimmed face.

    face: Part.Face, placed as it stands in the document. name: how errors call it.
    Raises InvalidInput: not a face, endless, trimmed, or of zero area.
    """
    if face is None or face.isNull() or face.ShapeType != "Face":
        raise fn.InvalidInput(f"{name} is not a face: pick one face of a shape")
    limits = face.ParameterRange
    if max(abs(limit) for limit in limits) > 1e50:
        raise fn.InvalidInput(f"{name} is endless: pick a face with an outline")
    point = _parametrisation(face, limits, name)
    grid = np.linspace(0.0, 1.0, TABLE_INTERVALS + 1)
    a, b = np.meshgrid(grid, grid, indexing="ij")
    points = point(a.ravel(), b.ravel()).reshape(*a.shape, 3)
    if not np.isfinite(points).all():
        raise fn.InvalidInput(
            f"{name} has points that are not finite: check the shape (Part, Check geometry)"
        )
    size = float(np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0)))
    if (
        size == 0.0
        or abs(face.Area) <= COINCIDENT**2 * size**2
        or _area(points) <= COINCIDENT * size**2
    ):
        raise fn.InvalidInput(f"{name} has no area: pick a face that spans a surface")

    poles = frozenset(
        side
        for side, line in zip(SIDES, (points[0], points[-1], points[:, 0], points[:, -1]))
        if _coincide(line, line[:1], size)
    )
    along_u, lengths_u = _shares(points)
    along_v, lengths_v = _shares(points.transpose(1, 0, 2))
    # Asked of the face itself: Surface.isUClosed() speaks of the whole surface, of which the face may be a
    # part, and a loft may close on itself without a seam edge.
    return Chart(
        point=point,
        size=size,
        closed_u=_coincide(points[0], points[-1], size) and not poles & {"u_min", "u_max"},
        closed_v=_coincide(points[:, 0], points[:, -1], size) and not poles & {"v_min", "v_max"},
        poles=poles,
        lengths_u=lengths_u,
        lengths_v=lengths_v,
        along_u=along_u,
        along_v=along_v.T,
    )


def count_cells(chart, step_u, step_v):
    """Cells along u and along v: the mean length of the isolines over the step [mm], rounded.

    At least 1, 2 between two poles and 3 around a closed direction. Raises InvalidInput naming the step.
    """
    cells = []
    for name, step, lengths, closed, ends in (
        ("StepU", step_u, chart.lengths_u, chart.closed_u, {"u_min", "u_max"}),
        ("StepV", step_v, chart.lengths_v, chart.closed_v, {"v_min", "v_max"}),
    ):
        if not step > 0.0:
            raise fn.InvalidInput(f"{name} is {step:g} mm: give a length greater than zero")
        longest = lengths.max()
        if step > longest * (1.0 + 1e-9):
            raise fn.InvalidInput(
                f"{name} is {step:g} mm, larger than the face, whose longest isoline in that direction "
                f"measures {longest:.6g} mm: give a smaller step"
            )
        fewest = 3 if closed else 2 if ends <= chart.poles else 1
        cells.append(max(fewest, round(float(lengths.mean()) / step)))
    if (cells[0] + 1) * (cells[1] + 1) > MOST_NODES:
        raise fn.InvalidInput(
            f"StepU = {step_u:g} mm and StepV = {step_v:g} mm would make {cells[0]} × {cells[1]} cells, "
            f"more than {MOST_NODES} nodes: give larger steps"
        )
    return tuple(cells)


def sample(chart, uv):
    """Points of the face at equal arc-length steps along the isolines: (n, 3) [mm].

    uv: (n, 2) in [0, 1]². The point of (s, t) is the crossing of two isolines of the surface such that s of
    the length of the one along u, and t of the length of the one along v, lie before it.
    Raises InvalidInput where the face folds so much that no such crossing is found.
    """
    s, t = np.asarray(uv, dtype=float).T
    a, b = _crossings(chart, s, t)
    for parameter, share in ((a, s), (b, t)):
        np.clip(parameter, 0.0, 1.0, out=parameter)
        parameter[share == 0.0] = 0.0
        parameter[share == 1.0] = 1.0
    missed = np.maximum(
        np.abs(_interpolate(chart.along_u, a, b)[0] - s), np.abs(_interpolate(chart.along_v, a, b)[0] - t)
    )
    # Shares have no meaning on a side that has no length.
    at_pole = np.zeros(len(s), dtype=bool)
    for side in chart.poles:
        at_pole |= (s if side[0] == "u" else t) == (0.0 if side.endswith("min") else 1.0)
    worst = int(np.argmax(np.where(at_pole, 0.0, missed)))
    if not at_pole[worst] and missed[worst] > 1e-6:
        raise fn.InvalidInput(
            f"the isolines of the face cannot be divided into equal lengths in both directions "
            f"(node {worst}, at {s[worst]:.3g}, {t[worst]:.3g}): the face is too folded or too unevenly "
            "parametrised; rebuild it with fewer, evenly spaced poles"
        )
    return chart.point(a, b)


def _parametrisation(face, limits, name):
    surface = face.Surface
    if not _fills_rectangle(face, limits):
        corners = _rectangle_corners(face)
        if corners is None:
            raise fn.InvalidInput(f"{name} {TRIMMED}")
        origin, along, _, across = corners

        def on_plane(a, b):
            return origin + np.outer(a, along - origin) + np.outer(b, across - origin)

        return on_plane

    u_first, u_last, v_first, v_last = limits

    def on_surface(a, b):
        us = (u_first + (u_last - u_first) * a).tolist()
        vs = (v_first + (v_last - v_first) * b).tolist()
        value = surface.value
        return np.array([(p.x, p.y, p.z) for p in map(value, us, vs)]).reshape(-1, 3)

    return on_surface


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


def _coincide(line, other, size):
    return bool(np.linalg.norm(line - other, axis=1).max() <= COINCIDENT * size)


def _area(points):
    diagonals = points[1:, 1:] - points[:-1, :-1], points[:-1, 1:] - points[1:, :-1]
    return 0.5 * np.linalg.norm(np.cross(*diagonals), axis=2).sum()


def _shares(points):
    """Shares of arc length along axis 0 of a (k, k, 3) grid of points, and the length of each line.

    Chords fall short of arcs by the square of their size, so pairs of chords and the chord across them
    extrapolate (Richardson) to an error of fourth order.
    """
    chords = np.linalg.norm(np.diff(points, axis=0), axis=2)
    pairs = chords[0::2] + chords[1::2]
    across = np.linalg.norm(points[2::2] - points[:-2:2], axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        stretch = np.where(pairs > 0.0, (4.0 * pairs - across) / (3.0 * pairs), 1.0)
    chords *= np.repeat(stretch, 2, axis=0)
    passed = np.vstack([np.zeros(chords.shape[1]), np.cumsum(chords, axis=0)])
    lengths = passed[-1].copy()
    has_length = lengths > COINCIDENT * lengths.max()
    shares = np.empty_like(passed)
    shares[:, has_length] = passed[:, has_length] / lengths[has_length]
    # A side without length (a pole) takes the limit of the lines next to it.
    inner = np.flatnonzero(has_length)
    for line in np.flatnonzero(~has_length):
        nearest = inner[np.argmin(np.abs(inner - line))]
        following = nearest + (1 if nearest > line else -1)
        shares[:, line] = 2.0 * shares[:, nearest] - shares[:, following]
    return shares, lengths


def _crossings(chart, s, t):
    """Parameters (a, b) where along_u = s and along_v = t."""
    grid = np.linspace(0.0, 1.0, TABLE_INTERVALS + 1)
    # Tables of a at (s, b) and of b at (a, t): a share grows along its isoline, so each line inverts alone.
    a_of = np.array([np.interp(grid, column, grid) for column in chart.along_u.T]).T
    b_of = np.array([np.interp(grid, row, grid) for row in chart.along_v])
    a, b = s.copy(), t.copy()
    for turn in range(40):
        # On twisted faces the plain iteration may circle round the crossing; a mean of two turns does not.
        weight = 1.0 if turn < 10 else 0.5
        a_next = a + weight * (_bilinear(a_of, s, b) - a)
        b_next = b + weight * (_bilinear(b_of, a_next, t) - b)
        change = max(np.abs(a_next - a).max(), np.abs(b_next - b).max())
        a, b = a_next, b_next
        if change < 1e-5:
            break
    for _ in range(6):
        su, su_a, su_b = _interpolate(chart.along_u, a, b)
        sv, sv_a, sv_b = _interpolate(chart.along_v, a, b)
        determinant = su_a * sv_b - su_b * sv_a
        with np.errstate(divide="ignore", invalid="ignore"):
            da = np.nan_to_num(((su - s) * sv_b - (sv - t) * su_b) / determinant, posinf=0.0, neginf=0.0)
            db = np.nan_to_num(((sv - t) * su_a - (su - s) * sv_a) / determinant, posinf=0.0, neginf=0.0)
        a = np.clip(a - np.clip(da, -0.05, 0.05), 0.0, 1.0)
        b = np.clip(b - np.clip(db, -0.05, 0.05), 0.0, 1.0)
        if max(np.abs(da).max(), np.abs(db).max()) < 1e-13:
            break
    return a, b


def _cell(parameter, first, last):
    scaled = np.clip(parameter, 0.0, 1.0) * TABLE_INTERVALS
    index = np.clip(scaled.astype(int) - first, 0, TABLE_INTERVALS - last)
    return index, scaled - index


def _bilinear(table, a, b):
    i, x = _cell(a, 0, 1)
    j, y = _cell(b, 0, 1)
    low = table[i, j] * (1 - x) + table[i + 1, j] * x
    high = table[i, j + 1] * (1 - x) + table[i + 1, j + 1] * x
    return low * (1 - y) + high * y


def _interpolate(table, a, b):
    """Bicubic (Lagrange, four points a side) value and derivatives to a and b, table on the unit square."""
    i, x = _cell(a, 1, 3)
    j, y = _cell(b, 1, 3)
    offsets = np.arange(4)
    patch = table[i[:, None, None] + offsets[:, None], j[:, None, None] + offsets]
    wx, dx = _cubic_weights(x)
    wy, dy = _cubic_weights(y)
    along = np.einsum("nij,nj->ni", patch, wy)
    value = (along * wx).sum(axis=1)
    to_a = (along * dx).sum(axis=1) * TABLE_INTERVALS
    to_b = (np.einsum("nij,nj->ni", patch, dy) * wx).sum(axis=1) * TABLE_INTERVALS
    return value, to_a, to_b


def _cubic_weights(x):
    """Lagrange weights at the points 0, 1, 2, 3 and their derivatives: (n, 4) each."""
    p, q, r = x - 1.0, x - 2.0, x - 3.0
    weights = np.stack([-p * q * r / 6, x * q * r / 2, -x * p * r / 2, x * p * q / 6], axis=1)
    slopes = np.stack(
        [
            -(q * r + p * r + p * q) / 6,
            (q * r + x * r + x * q) / 2,
            -(p * r + x * r + x * p) / 2,
            (p * q + x * q + x * p) / 6,
        ],
        axis=1,
    )
    return weights, slopes
