# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compass method: points of a face at a given distance from two points found before, and the net that
grows of them, front by front.

Lengths are millimetres. Numbers only: FreeCAD is behind the ground's chart.
"""

import math
from collections import defaultdict

import numpy as np

import funicular as fn

# Beyond this a step is a slip of the unit rather than a wish.
MOST_NODES = 250_000

# How far a distance may be from the step, relative to it: sought, and at most.
SOUGHT = 1e-12
MOST_ERROR = 3e-10
# Outside the face, where nodes are left out in the end.
SOUGHT_OUTSIDE = 1e-10

MOST_TURNS = 15

# Differences of the parameters in Newton's method, which forgives an error of this size in its slopes.
NEWTON_DIFFERENCE = 1e-6

# Two panels that overlap have nodes within 0.71 steps of each other; none that do not may look so.
NEAREST = 0.75

# Nodes nearer to the border than this part of a step lie on it.
ON_BORDER = 1e-8

# The directions in which the face is looked for from outside of it are wider than the members' by this.
WIDER = math.radians(10.0)

ARMS = np.array([[1, 0], [-1, 0], [0, 1], [0, -1]])


class Laying:
    """A net while it grows, front by front: all nodes at the same number of steps from the start at once."""

    def __init__(self, ground, step, most_shear):
        self.ground, self.step = ground, step
        self.least, self.most = math.radians(90.0 - most_shear), math.radians(90.0 + most_shear)
        self.count = 0
        room = 1024
        self.uv, self.points, self.slopes = np.empty((room, 2)), np.empty((room, 3)), np.empty((room, 2, 3))
        # Parameters that do not jump where the face closes.
        self.lifted = np.empty((room, 2))
        self.grid, self.on_face = np.empty((room, 2), dtype=int), np.empty(room, dtype=bool)
        self.reach = 64
        self._ids = np.full((2 * self.reach + 1,) * 2, -1)
        self._boxes, self._spoilt = defaultdict(list), set()
        # What lies this near along the grid is its own surroundings, however sheared.
        self._own = math.ceil(NEAREST / (2.0 * math.sin(0.5 * self.least))) + 1
        self.stops, self.left_face = [], False

    def ids(self, grid):
        """(n,) node numbers at grid places, -1 where there is none."""
        return self._ids[grid[:, 0] + self.reach, grid[:, 1] + self.reach]

    def begin(self, uv, angle, crossing):
        points = self.ground.at(uv)
        slopes = self.ground.slopes(uv, points)
        along = self.ground.along_u(uv, slopes)
        normal = np.cross(slopes[0, 0], slopes[0, 1])
        lengths = np.linalg.norm(slopes[0], axis=1)
        if not np.linalg.norm(normal) > 1e-9 * lengths.max() ** 2 or self.ground.at_end(uv)[0]:
            raise fn.InvalidInput(
                f"start ({uv[0, 0]:g}, {uv[0, 1]:g}) is at a pole or an edge of the face where it has no "
                "tangent plane: start elsewhere"
            )
        along = unit(along)
        across = np.cross(unit(normal), along)
        first, second = (math.cos(a) * along + math.sin(a) * across for a in (angle, angle + crossing))
        self._first_steps = np.array([first, -first, second, -second])
        first = self._store(np.zeros((1, 2), dtype=int), uv, points, slopes, uv, np.array([True]))
        self._clear_of_others(first)
        self._ids[self.reach, self.reach] = 0

    def lay(self):
        front = np.array([0])
        while len(front):
            if self.count > 2 * MOST_NODES:
                raise fn.InvalidInput(
                    f"step = {self.step:g} mm makes more than {MOST_NODES} nodes: give a larger step"
                )
            front = self._next_front(front)

    def _next_front(self, front):
        """Places what follows on a front, and returns it."""
        grid, a, b, o = self._candidates(front)
        if not len(grid):
            return grid[:, 0]
        guide = b < 0
        away = np.where(guide[:, None], 0.0, self.points[b] - self.points[o])
        away[guide] = self.step * unit(self._tangents(grid[guide], a[guide]))
        # Straight on is in the plane of the last member and the normal.
        plane = np.zeros((len(grid), 3))
        plane[guide] = unit(np.cross(self._normals(a[guide]), away[guide]))
        uv = self.ground.moved(self.uv[a], towards(self.slopes[a], away))
        uv, points, error = meet(self.ground, uv, self.points[a], self.points[b], plane, self.step)
        slopes = self.ground.slopes(uv, points)
        beyond = self.ground.beyond(uv, slopes)
        on_face = beyond <= ON_BORDER * self.step
        self.left_face |= not on_face.all()

        met = error <= MOST_ERROR
        ahead = np.einsum("ij,ij->i", points - self.points[a], away) > 0.0
        cell = ~guide
        ahead[cell] = self._on_far_side(points[cell], a[cell], b[cell], o[cell])
        reasons = np.where(met & ahead, "", np.where(self.ground.at_end(uv), "pole", "no point")).astype(
            "<U8"
        )
        numbers = np.full(len(grid), np.nan)
        rows = np.flatnonzero(cell & (reasons == ""))
        reasons[rows], numbers[rows] = self._judged_cells(
            grid[rows], uv[rows], points[rows], slopes[rows], a[rows], b[rows], o[rows]
        )
        useful = on_face | (beyond <= self.ground.chart.size)
        rows = np.flatnonzero(cell & ~on_face)
        useful[rows] &= self._face_ahead(uv[rows], self.uv[a[rows]], self.uv[b[rows]])

        lifted = self.lifted[a] + _short_way(uv - self.uv[a], self.ground.closed)
        rows = np.flatnonzero((reasons == "") & useful)
        stored = self._store(grid[rows], uv[rows], points[rows], slopes[rows], lifted[rows], on_face[rows])
        clear = self._clear_of_others(stored)
        reasons[rows[~clear]] = "overlap"
        placed = stored[clear]
        self._ids[tuple((self.grid[placed] + self.reach).T)] = placed
        for row in np.flatnonzero(reasons != "").tolist():
            met_at = points[row] if met[row] else self.points[a[row]] + away[row]
            self.stops.append((tuple(grid[row].tolist()), uv[row], met_at, str(reasons[row]), numbers[row]))
        return placed

    def _candidates(self, front):
        """(grid, a, b, o) of nodes that can follow on a front: a and b its neighbours, one step back along
        the first and along the second direction, o the corner opposite. A guide's next node has b = o = -1,
        and a the last one."""
        grid = self.grid[front]
        k = int(np.abs(grid[0]).sum()) + 1
        if k >= self.reach:
            self._ids = np.pad(self._ids, self.reach, constant_values=-1)
            self.reach *= 2
        found = []
        ends = self.ids((k - 1) * ARMS)
        arms = np.flatnonzero(ends >= 0)
        none = np.full(len(arms), -1)
        found.append((k * ARMS[arms], ends[arms], none, none))
        for si in (1, -1):
            for sj in (1, -1):
                rows = (si * grid[:, 0] >= 0) & (sj * grid[:, 1] >= 1)
                place, a = grid[rows] + (si, 0), front[rows]
                b, o = self.ids(place - (0, sj)), self.ids(place - (si, sj))
                both = (b >= 0) & (o >= 0)
                found.append((place[both], a[both], b[both], o[both]))
        return tuple(np.concatenate(parts) for parts in zip(*found))

    def _tangents(self, grid, a):
        """(n, 3) the direction in which a guide comes to its last node."""
        sign = np.sign(grid)
        before = self.ids(grid - 2 * sign)
        first = np.abs(grid).sum(axis=1) == 1
        arm = (ARMS[None] == sign[:, None]).all(axis=2).argmax(axis=1)
        return np.where(first[:, None], self._first_steps[arm], self.points[a] - self.points[before])

    def _normals(self, ids):
        return unit(np.cross(self.slopes[ids, 0], self.slopes[ids, 1]))

    def _on_far_side(self, points, a, b, o):
        middle = 0.5 * (self.points[a] + self.points[b])
        return np.einsum("ij,ij->i", points - middle, middle - self.points[o]) > 0.0

    def _judged_cells(self, grid, uv, points, slopes, a, b, o):
        """(reason, number) why cells do not do: "" and nan where they do, the angle [degrees] of a shear."""
        corners = np.stack([self.points[o], self.points[b], points, self.points[a]], axis=1)
        sides = unit(np.roll(corners, -1, axis=1) - corners)
        back = -np.roll(sides, 1, axis=1)
        angles = np.arccos(np.clip(np.einsum("nkj,nkj->nk", sides, back), -1.0, 1.0))
        numbers = np.degrees(
            np.where(angles.min(axis=1) < self.least, angles.min(axis=1), angles.max(axis=1))
        )
        # A hair's breadth, so that a crossing at the limit is not refused by rounding.
        sheared = (angles.min(axis=1) < self.least - 1e-9) | (angles.max(axis=1) > self.most + 1e-9)

        sense = np.where(np.sign(grid).prod(axis=1) > 0, 1.0, -1.0)[:, None, None]
        turning = sense * np.cross(sides, back)
        there = np.cross(slopes[:, 0], slopes[:, 1])
        normals = np.stack([self._normals(o), self._normals(b), unit(there), self._normals(a)], axis=1)
        whole = turning.sum(axis=1)
        folded = (np.einsum("nkj,nkj->nk", turning, normals) <= 0.0).any(axis=1)
        folded |= (np.einsum("nkj,nj->nk", turning, whole) <= 0.0).any(axis=1)

        round_it = np.stack([self.uv[o], self.uv[b], uv, self.uv[a]], axis=1)
        turns = _short_way(np.roll(round_it, -1, axis=1) - round_it, self.ground.closed).sum(axis=1)
        around = (np.abs(turns) > 0.5).any(axis=1) & (not self.ground.caps)
        reasons = np.select([around, sheared, folded], ["pole", "shear", "fold"], "")
        return reasons, np.where(sheared, numbers, np.nan)

    def _face_ahead(self, uv, uv_a, uv_b):
        """Whether places outside the face have it before them, in the directions of their cells."""
        scale, closed = self.ground.extent, self.ground.closed
        first, second = (_short_way(uv - before, closed) * scale for before in (uv_a, uv_b))
        low, high = ((np.where(closed, side, end - uv)) * scale for side, end in ((-10.0, 0.0), (10.0, 1.0)))
        middle = _direction(0.5 * (low + high))
        corners = np.stack(
            [_direction(np.stack([x[:, 0], y[:, 1]], axis=1)) for x in (low, high) for y in (low, high)]
        )
        seen = _wrapped(corners - middle)
        turn = _wrapped(_direction(second) - _direction(first))
        aim = _wrapped(_direction(first) + 0.5 * turn - middle - 0.5 * (seen.min(axis=0) + seen.max(axis=0)))
        return np.abs(aim) <= 0.5 * (np.abs(turn) + np.ptp(seen, axis=0)) + WIDER

    def _store(self, grid, uv, points, slopes, lifted, on_face):
        """(n,) the numbers of new nodes, which are in the net once they stand in its grid."""
        new = slice(self.count, self.count + len(grid))
        while new.stop > len(self.uv):
            for name in ("grid", "uv", "points", "slopes", "lifted", "on_face"):
                old = getattr(self, name)
                setattr(self, name, np.concatenate([old, np.empty_like(old)]))
        self.grid[new], self.uv[new], self.points[new], self.slopes[new] = grid, uv, points, slopes
        self.lifted[new], self.on_face[new] = lifted, on_face
        self.count = new.stop
        return np.arange(new.start, new.stop)

    def _clear_of_others(self, numbers):
        """(n,) whether new nodes on the face keep their distance from those before them.

        In boxes of two such distances, those within one of a point are in the eight boxes around it.
        """
        numbers = numbers.tolist()
        place = self.points[numbers] / (2.0 * NEAREST * self.step)
        own = np.floor(place).astype(int).tolist()
        corners = np.floor(place - 0.5).astype(int)[:, None] + np.indices((2, 2, 2)).reshape(3, 8).T
        pairs = []
        for number, on_face, box, around in zip(numbers, self.on_face[numbers], own, corners.tolist()):
            if on_face:
                pairs += [(number, n) for each in around for n in self._boxes.get(tuple(each), ())]
                self._boxes[tuple(box)].append(number)
        for number, other in self._overlapping(np.array(pairs, dtype=int).reshape(-1, 2)).tolist():
            if other not in self._spoilt:
                self._spoilt.add(number)
        return np.array([number not in self._spoilt for number in numbers], dtype=bool)

    def _overlapping(self, pairs):
        """Those pairs of nodes that are too near to each other, as neighbours or as others."""
        new, old = pairs.T
        far = np.abs(self.grid[old] - self.grid[new]).max(axis=1, initial=0) > self._own
        if not self.ground.caps and self.ground.closed.any():
            # Around a narrow face a few steps are enough to come back.
            turns = np.abs(self.lifted[old] - self.lifted[new])[:, self.ground.closed]
            far |= turns.max(axis=1) > 0.5
        # Neighbours across a cell that is missing may be as near as they like, but for this.
        least = np.where(far, NEAREST, math.sin(0.5 * self.least)) * self.step
        pairs = pairs[_length(self.points[old] - self.points[new]) < least]
        new, old = pairs.T
        # Near in space may be far on the face, across a fold.
        by = self.ground.apart(self.uv[old], self.uv[new])
        return pairs[_length((by[:, None] @ self.slopes[old])[:, 0]) < 2.0 * NEAREST * self.step]


def meet(ground, uv, first, second, plane, step):
    """Places at the step's distance from two points each, by Newton's method.

    uv: (n, 2) where to begin. first, second: (n, 3) centres of the spheres [mm]. plane: (n, 3) unit normals
    where the second sphere is replaced by the plane through the first centre, zero where it is not.
    Returns (uv, points, error): error (n,) relative to the step, beyond MOST_ERROR where there is no such
    place or it was not found.
    """
    uv = ground.moved(uv, np.zeros_like(uv))
    on_plane = plane.any(axis=1)
    points, error = np.empty((len(uv), 3)), np.full(len(uv), np.inf)
    slopes, frames = np.empty((len(uv), 2, 3)), np.full(len(uv), -1.0)
    active = np.arange(len(uv))
    for turn in range(MOST_TURNS):
        here = ground.at(uv[active])
        to_first, to_second = here - first[active], here - second[active]
        flat = on_plane[active]
        across = np.where(flat[:, None], plane[active], to_second)
        misses = np.stack([_length(to_first) - step, _length(to_second) - step], axis=1)
        misses[flat, 1] = np.einsum("ij,ij->i", to_first, across)[flat]
        points[active], error[active] = here, np.abs(misses).max(axis=1) / step
        outside = ((uv[active] < 0.0) | (uv[active] > 1.0)).any(axis=1)
        sought = np.where(outside, SOUGHT_OUTSIDE, SOUGHT) + 4e-16 * np.abs(here).max(axis=1) / step
        going = ~(error[active] <= sought)
        active = active[going]
        if not len(active):
            break
        # The slopes of the turn before do, once it is near.
        frame = ground.frames(uv[active])
        stale = active[~(error[active] < 1e-3) | (frame != frames[active])]
        frames[active] = frame
        if len(stale):
            slopes[stale] = _rough_slopes(ground, uv[stale], points[stale])
        rows = unit(np.stack([to_first[going], across[going]], axis=1))
        matrix = rows @ slopes[active].transpose(0, 2, 1)
        uv[active] = ground.moved(uv[active], _bounded(_solved(matrix, -misses[going]), slopes[active], step))
    return uv, points, error


def _length(vectors):
    return np.sqrt(np.einsum("...i,...i->...", vectors, vectors))


def _rough_slopes(ground, uv, points):
    n, h = len(uv), NEWTON_DIFFERENCE
    by = np.zeros((2, n, 2))
    by[0, :, 0], by[1, :, 1] = np.where(uv > 0.5, -h, h).T
    there = ground.at(ground.moved(np.vstack([uv, uv]), by.reshape(-1, 2))).reshape(2, n, 3)
    return np.stack([(there[k] - points) / by[k, :, k, None] for k in (0, 1)], axis=1)


def _solved(matrix, right):
    """(n, 2) solutions of n pairs of equations, zero where they have none."""
    (p, q), (r, s) = matrix.transpose(1, 2, 0)
    determinant = p * s - q * r
    solution = np.stack([s * right[:, 0] - q * right[:, 1], p * right[:, 1] - r * right[:, 0]], axis=1)
    return solution / np.where(determinant == 0.0, np.inf, determinant)[:, None]


def _bounded(by, slopes, step):
    """Moves of half a step at most: farther off the slopes say nothing."""
    lengths = _length((by[:, None] @ slopes)[:, 0])
    return by * np.minimum(1.0, 0.5 * step / np.maximum(lengths, 1e-300))[:, None]


def towards(slopes, away):
    """(n, 2) moves that come nearest to displacements. slopes: (n, 2, 3); away: (n, 3) [mm]."""
    return _solved(slopes @ slopes.transpose(0, 2, 1), (slopes @ away[:, :, None])[:, :, 0])


def unit(vectors):
    """Vectors of length one, along the last axis."""
    return vectors / np.maximum(_length(vectors), 1e-300)[..., None]


def _short_way(by, closed):
    """Differences of parameters, the short way round."""
    return by - np.where(closed, by.round(), 0.0)


def _direction(plan):
    return np.arctan2(plan[..., 1], plan[..., 0])


def _wrapped(turn):
    return turn - 2.0 * np.pi * np.round(turn / (2.0 * np.pi))
