# SPDX-License-Identifier: LGPL-2.1-or-later
"""Equal-length nets on a face (Chebyshev nets): every member has the length of the step.

Such a net can be assembled flat, from straight laths at right angles, and pushed up into its shape: all that
changes are the angles at its nodes. The Multihalle of Mannheim was built so. It is laid with a compass: two
guides run through a start point as straight as the face lets them, and every further node is where two arcs
of the step's length about its neighbours meet. How much the angles change follows from the curvature that a
part of the net spans; where they would change too much the net stops.

Lengths are millimetres. Numbers only: FreeCAD is behind the chart's `point(a, b)`.
"""

import math
from dataclasses import dataclass

import numpy as np

import funicular as fn

from . import whole_cells
from .compass import MOST_NODES, Laying
from .ground import Ground


@dataclass(frozen=True)
class Stop:
    """A place where the net could not go on, though the face does.

    grid: (steps along the first, along the second direction) of the node that is missing.
    point: (3,) where it would be, or nearly so [mm].
    reason: "shear", "fold", "overlap", "pole" or "no point".
    text: the same in a sentence, with numbers.
    """

    grid: tuple
    point: np.ndarray
    reason: str
    text: str


@dataclass(frozen=True)
class EqualLengthNet:
    """A net of members of one length, in whole cells.

    nodes: (n, 3) [mm]. uv: (n, 2) their parameters in the chart's unit square. grid: (n, 2) int, steps from
    the start along the first and along the second direction.
    members: (m, 2) node numbers, those along the first direction before the others.
    panels: (k, 4) node numbers round each quad, as u turns to v.
    rims: tuple of arrays of node numbers, one for each closed border, the net on its left; the last node is
    joined to the first.
    remarks: sentences on what was left out and why. stopped: tuple of Stop.
    """

    nodes: np.ndarray
    uv: np.ndarray
    grid: np.ndarray
    members: np.ndarray
    panels: np.ndarray
    rims: tuple
    remarks: tuple
    stopped: tuple


def equal_length_net(chart, step, start=(0.5, 0.5), angle=0.0, crossing=90.0, most_shear=60.0, inside=None):
    """The net of members of one length that grows from a start point on a face.

    chart: a `surface.Chart`. step: length of the members, straight between nodes [mm].
    start: parameters of the first node in the unit square.
    angle: from the direction of growing u to the first guide [degrees], as u turns to v.
    crossing: from the first guide to the second [degrees].
    most_shear: how far the angle between two members at a node may be from 90 degrees, at most 80.
    inside: (a, b) -> array of bool, which nodes a trimmed face keeps; the rest of the
        chart is still walked on.

    The net consists of whole cells, so that it ends within a cell of the border, in steps, and once around a
    closed direction at most. Only the part that hangs together with the start is kept.
    Raises InvalidInput that names the argument, and where no whole cell fits.
    """
    start = _checked(chart, step, start, angle, crossing, most_shear)
    laying = Laying(Ground(chart), float(step), float(most_shear))
    laying.begin(start, math.radians(angle), math.radians(crossing))
    laying.lay()
    return _assembled(laying, inside)


def _checked(chart, step, start, angle, crossing, most_shear):
    for name, value, what in (
        ("step", step, "a length in mm"),
        ("angle", angle, "degrees"),
        ("crossing", crossing, "degrees"),
        ("most_shear", most_shear, "degrees"),
    ):
        if not np.ndim(value) == 0 or not math.isfinite(value):
            raise fn.InvalidInput(f"{name} is {value}: give {what}")
    if not step > 0.0:
        raise fn.InvalidInput(f"step is {step:g} mm: give a length greater than zero")
    if not 0.0 < most_shear <= 80.0:
        raise fn.InvalidInput(f"most_shear is {most_shear:g}°: give more than 0° and at most 80°")
    if not abs(crossing - 90.0) <= most_shear:
        raise fn.InvalidInput(
            f"crossing is {crossing:g}°, which most_shear = {most_shear:g}° does not allow: give an "
            f"angle from {90.0 - most_shear:g}° to {90.0 + most_shear:g}°"
        )
    given = np.asarray(start, dtype=float)
    if given.shape != (2,):
        raise fn.InvalidInput(f"start has shape {given.shape}: give two numbers from 0 to 1")
    for index, value in enumerate(given):
        if not 0.0 <= value <= 1.0:
            raise fn.InvalidInput(f"start[{index}] is {value:g}, outside the face: give a number from 0 to 1")
    if step > chart.size:
        raise fn.InvalidInput(
            f"step is {step:g} mm, larger than the face, which measures {chart.size:.6g} mm from corner to "
            "corner of its box: give a smaller step"
        )
    nodes = float(chart.table.lengths_u.mean()) * float(chart.table.lengths_v.mean()) / step**2
    if nodes > MOST_NODES:
        raise fn.InvalidInput(
            f"step = {step:g} mm would make about {nodes:.0f} nodes, more than {MOST_NODES}: "
            "give a larger step"
        )
    return given[None, :]


def _assembled(laying, inside):
    """The net of whole cells on the face, from all nodes that were laid."""
    keep = laying.on_face.copy()
    keep[laying.count :] = False
    keep[: laying.count] &= laying.ids(laying.grid[: laying.count]) == np.arange(laying.count)
    uv = np.clip(laying.uv, 0.0, 1.0)
    laid = np.flatnonzero(keep)
    keep[laid] = _inside(inside, uv[laid])
    if not keep[0]:
        raise fn.InvalidInput(
            f"start ({uv[0, 0]:g}, {uv[0, 1]:g}) is where the face is cut away: start on what is left of it"
        )
    grid = laying.grid[: laying.count]
    low, high = grid.min(axis=0) - 2, grid.max(axis=0) + 2
    numbers = np.full(high - low + 1, -1)
    kept = np.flatnonzero(keep)
    numbers[tuple((laying.grid[kept] - low).T)] = kept
    all_cells = whole_cells.whole_cells(numbers >= 0)
    cells = whole_cells.hanging_together(all_cells, tuple((-low).tolist()))
    if not cells.any():
        raise fn.InvalidInput(
            f"no whole cell of step = {laying.step:g} mm fits on the face at start ({uv[0, 0]:g}, "
            f"{uv[0, 1]:g}): give a smaller step, or start farther from the border" + _why_at_start(laying)
        )

    panels = numbers[tuple(np.moveaxis(whole_cells.corners(cells), -1, 0))]
    members = numbers[tuple(np.moveaxis(whole_cells.members(cells), -1, 0))]
    rims = [numbers[tuple(rim.T)] for rim in whole_cells.rims(cells)]
    used = np.unique(panels)
    used = used[np.lexsort(laying.grid[used].T)]
    renumbered = np.full(len(keep), -1)
    renumbered[used] = np.arange(len(used))

    stopped = _stops(laying, inside)
    dropped = int(all_cells.sum() - cells.sum())
    at_border = laying.left_face or len(kept) < len(laid)
    return EqualLengthNet(
        nodes=laying.points[used],
        uv=uv[used],
        grid=laying.grid[used],
        members=renumbered[members],
        panels=renumbered[panels],
        rims=tuple(renumbered[rim] for rim in rims),
        remarks=_remarks(laying, stopped, at_border, dropped),
        stopped=stopped,
    )


def _inside(inside, uv):
    if inside is None or not len(uv):
        return np.ones(len(uv), dtype=bool)
    answer = np.asarray(inside(uv[:, 0], uv[:, 1]))
    if answer.shape != (len(uv),) or answer.dtype != bool:
        raise fn.InvalidInput(
            f"inside gave {answer.dtype} of shape {answer.shape} for {len(uv)} points: it has to give "
            "a bool for each"
        )
    return answer


def _stops(laying, inside):
    """The stops that lie on the face, in the order of the grid."""
    within = [stop for stop in laying.stops if ((stop[1] >= 0.0) & (stop[1] <= 1.0)).all()]
    keep = _inside(inside, np.array([uv for _, uv, *_ in within]).reshape(-1, 2))
    return tuple(
        Stop(grid, point, reason, _sentence(laying, grid, point, reason, number))
        for (grid, _, point, reason, number), kept in sorted(zip(within, keep), key=lambda each: each[0][0])
        if kept
    )


def _sentence(laying, grid, point, reason, number):
    x, y, z = (point + 0.0).round(1) + 0.0
    least, most = (math.degrees(angle) for angle in (laying.least, laying.most))
    why = {
        "shear": f"its members would meet at {number:.1f}°, outside of {least:g}° to {most:g}°",
        "fold": "its panel would fold over",
        "overlap": "the net would overlap itself",
        "pole": "the face has a tip there that no cell may enclose",
        "no point": "no point of the face is a step away from both neighbours and on ahead",
    }[reason]
    return (
        f"The net stops before node {grid[0]} along the first and {grid[1]} along the second direction, at "
        f"({x:g}, {y:g}, {z:g}) mm: {why}."
    )


def _why_at_start(laying):
    near = [stop for stop in laying.stops if np.abs(stop[0]).max() == 1]
    return f" ({_sentence(laying, *near[0][:1], *near[0][2:])})" if near else ""


def _remarks(laying, stopped, at_border, dropped):
    remarks = []
    if at_border:
        remarks.append(
            f"Cells are whole, as members shorter than {laying.step:g} mm would be needed up to the border: "
            "the net ends within a cell of it, in steps."
        )
    for reason, sentence in (
        ("shear", "Members would meet at too small or too large an angle"),
        ("fold", "Panels would fold over"),
        ("overlap", "The net comes back to where it is already, and does not overlap itself"),
        ("pole", "The face has a tip that no cell may enclose"),
        ("no point", "The face bends too much within a step, or ends in a tip"),
    ):
        places = [stop for stop in stopped if stop.reason == reason]
        if places:
            first = min(places, key=lambda stop: np.abs(stop.grid).sum())
            count = f"{len(places)} places" if len(places) > 1 else "one place"
            remarks.append(f"{sentence}: the net stops at {count}. {first.text}")
    if dropped:
        remarks.append(
            f"{dropped} whole cell{'s' * (dropped != 1)} that no side joins to the cells at the start "
            f"{'are' if dropped != 1 else 'is'} left out."
        )
    return tuple(remarks)
