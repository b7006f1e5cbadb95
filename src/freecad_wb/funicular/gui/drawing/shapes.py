# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines, bars and panels as groups of coin nodes that hold a shape and no colour, so that a shadow can be
drawn of the same nodes. Lengths in m go in, and coin has them in FreeCAD's mm."""

import numpy as np
from pivy import coin

from funicular.arrows import POINTS, arrow_lines
from funicular.bars import bar_faces, bar_points, rectangular_section, round_section
from funicular.gui.drawing.look import RECTANGULAR
from funicular.panels import are_convex

MILLIMETRES = 1e3  # of a metre

# Sides of a round bar: in a small net each bar is seen, in a large one none.
FINE, COARSE, MANY = 8, 6, 1000
SMOOTH = 0.9  # [rad]: less than that between two sides of a round bar is drawn round; its ends stay sharp

# Bars that are filled in at once: as many as a frame has time for.
BLOCK = 3000


def set_field(field, values):
    """Let a multiple field of coin hold these values and no others. values: list, or array of integers."""
    values = values if isinstance(values, list) else values.tolist()
    field.setValues(0, len(values), values)
    field.setNum(len(values))


def set_points(coordinates, points):
    """points: (n, 3) [m]"""
    numbers = iter((points * MILLIMETRES).ravel().tolist())
    # Tuples, for lists of lists would call Python's collector of garbage again and again.
    coordinates.point.setValues(0, len(points), list(zip(numbers, numbers, numbers)))
    coordinates.point.setNum(len(points))


def longest_side(nodes):
    """Of the box that holds nodes (n, 3)."""
    # By columns, for along rows of three numpy takes ten times as long.
    return max((float(np.ptp(column)) for column in nodes.T), default=0.0)


class Arrows:
    """Forces as lines; a colour is one for all."""

    def __init__(self):
        self.group = coin.SoGroup()
        self._points, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        self._lines.coordIndex.setNum(0)
        self.group.addChild(self._points)
        self.group.addChild(self._lines)
        self._count = 0

    def show(self, points):
        """points: as funicular.arrows.arrow_points() makes them, in mm."""
        count = len(points) // POINTS
        is_new, self._count = count != self._count, count
        if is_new:
            # No line may name a point that is not there any more.
            self._lines.coordIndex.setNum(0)
        points = points.astype(np.float32)
        self._points.point.setValues(0, len(points), points)
        self._points.point.setNum(len(points))
        if is_new:
            lines = arrow_lines(count)
            set_field(self._lines.coordIndex, np.column_stack([lines, np.full(len(lines), -1)]).ravel())


class Lines:
    """One line a member between the points of a coordinate node; a colour is one a line, in their order."""

    def __init__(self, points):
        self.group = coin.SoGroup()
        self._lines = coin.SoIndexedLineSet()
        self.group.addChild(points)
        self.group.addChild(self._lines)
        self._members = None

    def show(self, members):
        if members is not self._members:
            self._members = members
            breaks = np.full(len(members), -1)
            set_field(self._lines.coordIndex, np.column_stack([members, breaks]).ravel())


class Bars:
    """One closed prism a member; a colour is one a bar, by its index."""

    def __init__(self):
        self.group = coin.SoGroup()
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.shapeType = coin.SoShapeHints.SOLID
        hints.faceType = coin.SoShapeHints.CONVEX
        hints.creaseAngle = SMOOTH
        self._normals = coin.SoNormalBinding()
        self.group.addChild(hints)
        self.group.addChild(self._normals)
        self._blocks, self._members, self._sides = [], None, 0
        self._filled = None

    def are_of(self, nodes, members, look):
        """Whether these very bars are filled in."""
        if self._filled is None:
            return False
        of_nodes, of_members, size = self._filled
        return of_nodes is nodes and of_members is members and size == _size(look)

    def show(self, nodes, members, look):
        """All at once."""
        for _ in self.fill(nodes, members, look):
            pass

    def fill(self, nodes, members, look):
        """An iterator that fills in BLOCK bars each turn."""
        section = _section(look, len(members))
        if members is not self._members or len(section) != self._sides:
            self._lay(members, len(section))
        smooth = coin.SoNormalBinding.PER_VERTEX_INDEXED, coin.SoNormalBinding.PER_FACE
        self._normals.value = smooth[look.members == RECTANGULAR]
        self._filled = None
        for number, (points, bars) in enumerate(self._blocks):
            of_block = members[number * BLOCK : (number + 1) * BLOCK]
            set_points(points, bar_points(nodes, of_block, section / MILLIMETRES))
            if bars.coordIndex.getNum() == 0:
                self._connect(bars, number * BLOCK, len(of_block))
            yield
        self._filled = nodes, members, _size(look)

    def _lay(self, members, sides):
        for nodes in self._blocks:
            for node in nodes:
                self.group.removeChild(node)
        self._members, self._sides = members, sides
        count = -(-len(members) // BLOCK)
        self._blocks = [(coin.SoCoordinate3(), coin.SoIndexedFaceSet()) for _ in range(count)]
        for points, bars in self._blocks:
            # Nothing until its turn has come, where coin has one index to begin with.
            bars.coordIndex.setNum(0)
            self.group.addChild(points)
            self.group.addChild(bars)

    def _connect(self, bars, first, count):
        faces = bar_faces(self._sides)
        pattern = np.array([number for face in faces for number in (*face, -1)])
        steps = 2 * self._sides * np.arange(count)[:, None]
        set_field(bars.coordIndex, np.where(pattern < 0, -1, pattern + steps).ravel())
        set_field(bars.materialIndex, np.repeat(np.arange(first, first + count), len(faces)))


def _size(look):
    return look.members, look.width, look.height


def _section(look, count):
    if look.members == RECTANGULAR:
        return rectangular_section(look.width, look.height)
    return round_section(look.width, FINE if count <= MANY else COARSE)


class Panels:
    """The panels as faces between the points of a coordinate node, each with a shading of its own."""

    def __init__(self, points):
        self.group = coin.SoGroup()
        self._hints = coin.SoShapeHints()
        # Ordered, and no solid: lit on both sides.
        self._hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        self._hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        # Coin finds the normals, much sooner than they would come to it from here.
        binding = coin.SoNormalBinding()
        binding.value = coin.SoNormalBinding.PER_FACE
        self._faces = coin.SoIndexedFaceSet()
        for node in (self._hints, binding, points, self._faces):
            self.group.addChild(node)
        self._panels = None

    def show(self, nodes, panels):
        """nodes: where the points are, for whether a panel has a corner that looks inwards."""
        if panels is self._panels:
            return
        self._panels = panels
        convex = bool(are_convex(nodes, panels).all())
        # What is convex coin need not cut up with each form.
        self._hints.faceType = coin.SoShapeHints.CONVEX if convex else coin.SoShapeHints.UNKNOWN_FACE_TYPE
        set_field(self._faces.coordIndex, np.array([node for panel in panels for node in (*panel, -1)]))
