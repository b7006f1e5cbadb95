# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where curved edges meet each other, straight edges and their ends. Lengths are mm.

FreeCAD's own `distToShape` misses crossings of some arcs, so the curves are followed here: sampled, and from
every place where the samples come near each other to the nearest points by Gauss and Newton's method.
"""

import numpy as np

from .crossings import overlapping_boxes

# Chords that a curve is sampled by, and for each pole of a spline.
SAMPLES, SAMPLES_A_POLE, MOST_SAMPLES = 32, 4, 800

MOST_STEPS = 40

# Of the size of the wireframe: curves that run together for longer do not cross there, they overlap.
TOGETHER = 0.02


class Course:
    """An edge as a curve of a parameter from `first` to `last`. Its samples are no nodes of a net."""

    def __init__(self, edge, curved):
        self.curved = curved
        self.first, self.last = edge.FirstParameter, edge.LastParameter
        self._value, self._derivative = edge.valueAt, edge.derivative1At
        count = 1
        if curved:
            poles = getattr(edge.Curve, "NbPoles", 0)
            count = min(max(SAMPLES, SAMPLES_A_POLE * poles), MOST_SAMPLES)
        self.parameters = np.linspace(self.first, self.last, count + 1)
        self.samples = np.array([self.at(parameter) for parameter in self.parameters.tolist()])

    def at(self, parameter):
        return np.array(tuple(self._value(parameter)))

    def along(self, parameter):
        return np.array(tuple(self._derivative(parameter)))

    def clipped(self, parameter):
        return min(max(parameter, self.first), self.last)

    def boxes(self, tolerance):
        """(low, high) of boxes around the pieces between samples."""
        begin, end = self.samples[:-1], self.samples[1:]
        bulge = np.zeros((len(begin), 1))
        if self.curved:
            middle = 0.5 * (self.parameters[:-1] + self.parameters[1:])
            middle = np.array([self.at(parameter) for parameter in middle.tolist()])
            bulge = 2.0 * np.linalg.norm(middle - 0.5 * (begin + end), axis=1, keepdims=True)
        return np.minimum(begin, end) - bulge - tolerance, np.maximum(begin, end) + bulge + tolerance


def met_inside(edges, curved, size, tolerance):
    """For each edge the parameters at which other edges meet it, if it is curved; unordered, ends included.

    edges: Part edges. curved: whether each is. size: of them all. tolerance: how near is met.
    """
    courses = [Course(edge, bends) for edge, bends in zip(edges, curved)]
    boxes = [course.boxes(tolerance) for course in courses]
    ends = np.array([course.samples[end] for course in courses for end in (0, -1)])
    low = np.vstack([*(low for low, _ in boxes), ends])
    high = np.vstack([*(high for _, high in boxes), ends])
    pieces = [len(course.samples) - 1 for course in courses]
    edge_of = np.concatenate([np.repeat(np.arange(len(courses)), pieces), np.arange(len(ends)) // 2])
    middle = np.concatenate([(c.parameters[1:] + c.parameters[:-1]) / 2 for c in courses])
    bends, count = np.array(curved)[edge_of], len(middle)

    knots = [[] for _ in courses]
    near = {}
    for i, j in overlapping_boxes(low, high):
        wanted = (edge_of[i] != edge_of[j]) & (i < count) & (bends[i] | (bends[j] & (j < count)))
        for a, b in zip(i[wanted].tolist(), j[wanted].tolist()):
            one, other = int(edge_of[a]), int(edge_of[b])
            if b < count:
                one, other, a, b = (one, other, a, b) if one < other else (other, one, b, a)
                near.setdefault((one, other), []).append((middle[a], middle[b]))
                continue
            parameter, distance = _nearest(courses[one], low[b], middle[a])
            if distance <= tolerance:
                knots[one].append(parameter)
    for (one, other), starts in near.items():
        for parameters in _crossings(courses[one], courses[other], starts, size, tolerance):
            for edge, parameter in zip((one, other), parameters):
                if courses[edge].curved:
                    knots[edge].append(parameter)
    return knots


def _nearest(course, point, start):
    """(parameter, distance) of the place on a course that is nearest to a point, from a start near it."""
    parameter = start
    for _ in range(MOST_STEPS):
        along = course.along(parameter)
        step = along @ (point - course.at(parameter)) / max(along @ along, 1e-300)
        before, parameter = parameter, course.clipped(parameter + step)
        if abs(parameter - before) <= 1e-13 * (course.last - course.first):
            break
    return parameter, np.linalg.norm(point - course.at(parameter))


def _crossings(one, other, starts, size, tolerance):
    """Pairs of parameters at which two courses meet, found from the starts."""
    found = []
    for s, t in starts:
        s, t, distance = _nearest_pair(one, other, s, t)
        if distance <= tolerance:
            found.append((s, t))
    groups = []
    for s, t in sorted(found):
        if groups:
            before = groups[-1][-1]
            between = one.at((before[0] + s) / 2.0)
            # Where courses touch they are near for a while, and every start ends at a place of its own.
            if _nearest(other, between, (before[1] + t) / 2.0)[1] <= tolerance:
                groups[-1].append((s, t))
                continue
        groups.append([(s, t)])
    crossings = []
    for group in groups:
        if np.linalg.norm(one.at(group[0][0]) - one.at(group[-1][0])) <= TOGETHER * size:
            s = (group[0][0] + group[-1][0]) / 2.0
            crossings.append((s, _nearest(other, one.at(s), group[0][1])[0]))
    return crossings


def _nearest_pair(one, other, s, t):
    """(s, t, distance) of nearest places on two courses, from a start near them."""
    for _ in range(MOST_STEPS):
        apart = one.at(s) - other.at(t)
        of_one, of_other = one.along(s), -other.along(t)
        a, b, c = of_one @ of_one, of_one @ of_other, of_other @ of_other
        # What is added lets courses that touch come near, though by halves only.
        a, c = a * (1.0 + 1e-9), c * (1.0 + 1e-9)
        determinant = a * c - b * b
        if determinant <= 0.0:
            break
        along_one, along_other = of_one @ apart, of_other @ apart
        before = s, t
        s = one.clipped(s + (b * along_other - c * along_one) / determinant)
        t = other.clipped(t + (b * along_one - a * along_other) / determinant)
        if abs(s - before[0]) <= 1e-13 * (one.last - one.first):
            if abs(t - before[1]) <= 1e-13 * (other.last - other.first):
                break
    return s, t, np.linalg.norm(one.at(s) - other.at(t))
