# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds a form, as marks in the 3D view: one for each kind, as large at any zoom, with its direction."""

import numpy as np
from pivy import coin

from funicular.gui.drawing.mark_shapes import (
    COLOURS,
    DOT,
    FREE,
    HOVER,
    LINE,
    PLANE,
    POINT,
    RING,
    YIELDS,
    marker,
)
from funicular.gui.drawing.shapes import MILLIMETRES, set_field
from funicular.held import square_in

NAME = "Funicular_support_marks"
LINE_WIDTH = 3.0
# Of a member's length: half a line, and from the middle of a square to its corner.
ALONG, ACROSS = 0.6, 0.4
# More marks than this of one kind are plain points: only its colour could be read, and bitmaps are slow.
MANY = 500
PLAIN, PLAIN_HALO = 5.0, 1.5  # [px]

KINDS = (PLANE, LINE, POINT, YIELDS, FREE)


class SupportMarks:
    """Coin nodes below the view provider of a gridshell, in front of all that is drawn there."""

    def __init__(self, vobj):
        self._vobj = vobj
        # After all else, so that no line hides a mark.
        self._root = coin.SoAnnotation()
        self._root.setName(NAME)
        self._marks = {kind: _Marks(kind) for kind in (RING, *KINDS, DOT, HOVER)}
        unpickable = coin.SoPickStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        style = coin.SoDrawStyle()
        style.lineWidth = LINE_WIDTH
        self._switch = coin.SoSwitch()
        self._switch.whichChild = coin.SO_SWITCH_ALL
        self._root.addChild(self._switch)
        for node in (unpickable, light, style, *(each.root for each in self._marks.values())):
            self._switch.addChild(node)
        vobj.RootNode.addChild(self._root)

    @property
    def is_shown(self):
        return self._switch.whichChild.getValue() == coin.SO_SWITCH_ALL

    def set_shown(self, is_shown):
        wanted = coin.SO_SWITCH_ALL if is_shown else coin.SO_SWITCH_NONE
        if is_shown != self.is_shown:
            self._switch.whichChild = wanted

    def hold(self, held, free):
        """Mark other nodes, from the next form on. held: as funicular.held.held_of(). free: (k,) nodes."""
        yielding = [held[kind].nodes[held[kind].yields] for kind in (POINT, LINE, PLANE)]
        for kind in (POINT, LINE, PLANE):
            part = held[kind]
            self._marks[kind].place(part.nodes[~part.yields], *_directions(kind, part, ~part.yields))
        directions = [_directions(kind, held[kind], held[kind].yields) for kind in (LINE, PLANE)]
        self._marks[YIELDS].place(np.concatenate(yielding), *_joined(directions))
        self._marks[FREE].place(free)

    def choose(self, nodes):
        """Put rings around nodes, from the next form on."""
        self._marks[RING].place(nodes)

    def hover(self, nodes):
        """Put dark rings around nodes, from the next form on."""
        self._marks[HOVER].place(nodes)

    def pick(self, nodes):
        """Put dots on nodes, from the next form on."""
        self._marks[DOT].place(nodes)

    def show(self, form, are_small=False, only=None):
        """Draw everything where it is in a Form.

        are_small: for they stand close on the screen. only: nothing but one of RING, HOVER, DOT.
        """
        some = form.members[:: max(1, len(form.members) // 500)]
        ends = form.drawn_nodes[some[:, 1]] - form.drawn_nodes[some[:, 0]]
        size = float(np.median(np.linalg.norm(ends, axis=1))) if len(ends) else 0.0
        for each in self._marks.values() if only is None else [self._marks[only]]:
            each.show(form, size, are_small)

    def count(self, kind):
        """How many nodes have a mark of a kind."""
        return len(self._marks[kind].nodes)

    def remove(self):
        """Take all of it out of the view."""
        try:
            self._vobj.RootNode.removeChild(self._root)
        except (ReferenceError, RuntimeError):
            pass  # the gridshell is gone, and what was below it


def _directions(kind, held, chosen):
    """[(nodes (k,), polylines (k, j, 3) around each, in members' lengths)] along which they may slide."""
    nodes, directions = held.nodes[chosen], held.directions[chosen]
    if kind == LINE:
        return [(nodes, ALONG * np.stack([-directions, directions], axis=1))]
    if kind == PLANE:
        square = square_in(directions)
        return [(nodes, ACROSS * np.concatenate([square, square[:, :1]], axis=1))]
    return []


def _joined(parts):
    return [each for part in parts for each in part]


class _Marks:
    """The nodes of one kind: their marks, with a halo, and the lines that tell a direction."""

    def __init__(self, kind):
        self.nodes, self._polylines, self._kind = np.zeros(0, dtype=int), (), kind
        self.root, self._index = coin.SoSeparator(), None
        colour, white = coin.SoBaseColor(), coin.SoBaseColor()
        colour.rgb = _rgb(COLOURS[kind])
        white.rgb = (1.0, 1.0, 1.0)
        line_points, points, lines = coin.SoCoordinate3(), coin.SoCoordinate3(), coin.SoLineSet()
        halos, marks = coin.SoMarkerSet(), coin.SoMarkerSet()
        large, small = coin.SoDrawStyle(), coin.SoDrawStyle()
        large.pointSize, small.pointSize = PLAIN + 2 * PLAIN_HALO, PLAIN
        halo_dots, dots = coin.SoPointSet(), coin.SoPointSet()
        for each in (colour, line_points, lines, points, white, halos, large, halo_dots):
            self.root.addChild(each)
        for each in (colour, marks, small, dots):
            self.root.addChild(each)
        # Fields by themselves: to ask their node for them takes longer than to set them.
        self._line_points, self._counts, self._points = line_points.point, lines.numVertices, points.point
        self._as_marks = (
            (halos.numPoints, halos.markerIndex, True),
            (marks.numPoints, marks.markerIndex, False),
        )
        self._as_dots = halo_dots.numPoints, dots.numPoints
        set_field(self._counts, [])
        set_field(self._points, [])
        self._number(0, False)

    def place(self, nodes, *polylines):
        self.nodes, self._polylines = np.asarray(nodes, dtype=int), polylines

    def show(self, form, size, is_small):
        nodes = self.nodes
        if len(nodes) and nodes.max() >= len(form.nodes):
            # Of another net, until it is said which of this one are held.
            nodes, self._polylines = nodes[:0], ()
        if not len(nodes) and not self._points.getNum():
            return
        points, counts = [], []
        for of_these, around in self._polylines:
            points.append((form.drawn_nodes[of_these][:, None, :] + size * around).reshape(-1, 3))
            counts += [around.shape[1]] * len(of_these)
        set_field(self._line_points, _millimetres(np.concatenate(points)) if points else [])
        set_field(self._counts, counts)
        set_field(self._points, _millimetres(form.drawn_nodes[nodes]))
        self._number(len(nodes), is_small)

    def _number(self, count, is_small):
        as_dots = self._kind == DOT or count > MANY
        for number in self._as_dots:
            number.setValue(count if as_dots else 0)
        count = 0 if as_dots else count
        index = max(count, 1), is_small
        for number, markers, with_halo in self._as_marks:
            number.setValue(count)
            if index != self._index:
                # One for each: coin reads as many.
                set_field(markers, [marker(self._kind, with_halo, is_small)] * index[0])
        self._index = index


def _millimetres(points):
    return (points * MILLIMETRES).tolist()


def _rgb(text):
    return tuple(int(text[at : at + 2], 16) / 255.0 for at in (1, 3, 5))
