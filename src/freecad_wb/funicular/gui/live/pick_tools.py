# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools for the mouse in the 3D view: nodes, boxes, lassos, edges are picked, and a node is raised."""

import FreeCAD
import numpy as np

from funicular.features.net import nodes_of_element
from funicular.gui.drawing.raise_drawing import RaiseDrawing
from funicular.gui.drawing.screen_outline import ScreenOutline
from funicular.gui.drawing.shapes import MILLIMETRES
from funicular.gui.qt import QtCore, translate

OFF, NODES, BOX, LASSO, EDGES, RAISE = "Off", "Nodes", "Box", "Lasso", "Edges", "Raise"
MOVED = 4.0  # [px] from where it was pressed: what is nearer is a click
# Of a member's length: what a height is rounded to, for nobody drags by the micrometre.
FINEST_HEIGHT = 0.01


class PickTools(QtCore.QObject):
    """Takes the left button in the 3D view while a tool is on; all else stays FreeCAD's.

    held: callable() that gives the (k,) nodes of a form with a mark, which can be clicked without a tool.
    """

    hovered = QtCore.Signal(object, object)
    """What the mouse is on, by its nodes, and the At: [] for nothing."""

    clicked_mark = QtCore.Signal(int)
    """The mark of this node was clicked."""

    raised = QtCore.Signal(int, float)
    """A node was let go at this height [m] above where it was."""

    changed = QtCore.Signal()
    """Another tool is on."""

    def __init__(self, session, picks, held, vobj):
        super().__init__()
        self._session, self._picks, self._held = session, picks, held
        self.tool = OFF
        self._drag = None
        self.outline, self._raise = ScreenOutline(), RaiseDrawing(vobj)
        # The edges of a net, made when they are first asked for.
        self._edges_of, self._edges = None, None

    def use(self, tool):
        """Take up a tool, or lay it down with OFF."""
        self.tool = tool
        self._end_drag()
        self.hovered.emit([], None)
        self.changed.emit()

    def leave(self):
        self._end_drag()
        self.outline.remove()
        # With it go its connections, which hold whoever listens.
        self.deleteLater()

    # What the pointer asks

    def moved(self, at):
        if self._drag is not None:
            self._drag.to(at)
            return True
        if not at.buttons and self._session.form is not None and self._session.net is not None:
            self.hovered.emit(self._under(at), at)
        return False

    def pressed(self, at):
        # With another button held it is FreeCAD's own way to turn the view.
        if at.button != QtCore.Qt.LeftButton or at.buttons != QtCore.Qt.LeftButton:
            return False
        if self._session.form is None or self._session.net is None:
            return False
        under = self._under(at)
        self.hovered.emit([], None)
        if self.tool in (NODES, BOX, LASSO):
            self._drag = _Pull(self, at)
        elif self.tool == RAISE and len(under):
            self._drag = _Raise(self, at, int(under[0]))
        elif len(under):
            self._drag = _Click(self, at)
        return self._drag is not None

    def released(self, at):
        if self._drag is None or at.button != QtCore.Qt.LeftButton:
            return False
        drag = self._drag
        self._end_drag()
        drag.end(at)
        return True

    def left(self):
        self.hovered.emit([], None)
        return False

    def _end_drag(self):
        self._drag = None
        self.outline.hide()
        self._raise.hide()

    # What is where

    def _points(self):
        return self._session.form.drawn_nodes * MILLIMETRES

    def _under(self, at):
        """The nodes that the mouse is on, as the tool counts them."""
        points, screen = self._points(), at.screen()
        if self.tool == OFF:
            held = self._held()
            held = held[held < len(points)]
            found = screen.nearest_node(points[held], at.place) if len(held) else None
            return [] if found is None else [int(held[found])]
        if self.tool == EDGES:
            name = self._edge_under(at, screen, points)
            return nodes_of_element(self._session.net, name).tolist() if name else []
        found = screen.nearest_node(points, at.place)
        return [] if found is None else [found]

    def _edge_under(self, at, screen, points):
        """Name of the edge of the source that the mouse is on, "" for none."""
        net = self._session.net
        if self._edges_of is not self._session.source_net:
            self._edges_of = self._session.source_net
            names = [name for name in net.SourceElements if name.startswith("Edge")]
            lines = [nodes_of_element(net, name) for name in names]
            # A closed edge has its last piece between its last node and its first: nobody misses it.
            pieces = [np.column_stack([line[:-1], line[1:]]) for line in lines]
            self._edges = [name for name, each in zip(names, pieces) for _ in each], _stacked(pieces)
        names, pieces = self._edges
        if not names or pieces.max() >= len(points):
            return ""
        found = screen.nearest_member(points, pieces, at.place)
        return "" if found is None else names[found]

    # What drags and clicks do

    def click(self, at):
        under = self._under(at)
        if not len(under):
            return
        if self.tool == OFF:
            self.clicked_mark.emit(under[0])
        elif self.tool == EDGES:
            self._picks.add_element(self._session.net, self._edge_under(at, at.screen(), self._points()))
        elif at.modifiers & QtCore.Qt.ShiftModifier:
            self._picks.add(under)
        else:
            self._picks.toggle(under[0])

    def pick_within(self, at, outline):
        nodes = at.screen().inside(self._points(), np.array(outline, dtype=float))
        if at.modifiers & QtCore.Qt.ShiftModifier:
            self._picks.add(nodes.tolist())
        else:
            self._picks.replace(nodes.tolist())

    def show_raised(self, node, base, height):
        form = self._session.form
        ends = form.members[(form.members == node).any(axis=1)]
        others = ends[ends != node]
        sign = "+" if height >= 0.0 else "−"
        now = form.nodes[node, 2] * MILLIMETRES
        words = translate("{}, at {}").format(sign + _length(abs(height)), _length(now + height))
        self._raise.show(base, height, form.drawn_nodes[others] * MILLIMETRES, words)


class _Click:
    """A press that has to be let go where it was."""

    def __init__(self, tools, at):
        self._tools, self._first = tools, at

    def to(self, at):
        pass

    def end(self, at):
        if np.hypot(*np.subtract(at.place, self._first.place)) <= MOVED:
            self._tools.click(self._first)


class _Pull:
    """A click, or once it has gone far enough a box or a lasso."""

    def __init__(self, tools, at):
        self._tools, self._first, self._way, self._is_pulled = tools, at, [at.place], False
        with_alt = tools.tool == NODES and bool(at.modifiers & QtCore.Qt.AltModifier)
        self._is_lasso = with_alt or tools.tool == LASSO

    def to(self, at):
        self._way.append(at.place)
        self._is_pulled |= np.hypot(*np.subtract(at.place, self._first.place)) > MOVED
        if self._is_pulled:
            outline = self._outline()
            self._tools.outline.show(at.view, [*outline, outline[0]])

    def end(self, at):
        if self._is_pulled:
            self._way.append(at.place)
            self._tools.pick_within(at, self._outline())
        else:
            self._tools.click(self._first)

    def _outline(self):
        if self._is_lasso:
            return self._way
        (x0, y0), (x1, y1) = self._way[0], self._way[-1]
        return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


class _Raise:
    """A node that is dragged along its vertical."""

    def __init__(self, tools, at, node):
        self._tools, self._node, self._height = tools, node, 0.0
        form = tools._session.form
        self._base = form.drawn_nodes[node] * MILLIMETRES
        self._finest = FINEST_HEIGHT * MILLIMETRES * float(np.median(form.member_lengths))
        self._begun = at.screen().height_at(self._base, at.place)
        self.to(at)

    def to(self, at):
        there = at.screen().height_at(self._base, at.place)
        if there is None or self._begun is None:
            return
        digits = -int(np.floor(np.log10(self._finest)))
        self._height = round(there - self._begun, digits)
        self._tools.show_raised(self._node, self._base, self._height)

    def end(self, at):
        if self._height:
            self._tools.raised.emit(self._node, self._height / MILLIMETRES)


def _length(millimetres):
    return FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length).UserString


def _stacked(pieces):
    return np.concatenate(pieces) if pieces else np.zeros((0, 2), dtype=int)
