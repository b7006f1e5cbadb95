# SPDX-License-Identifier: LGPL-2.1-or-later
"""The members of a form, coloured: as lines or as bars, and as lines for bars that there is no time for."""

from pivy import coin

from funicular.gui.drawing import shapes
from funicular.gui.drawing.shapes import Bars, Lines, set_field


class Members:
    """points: the coordinate node that holds the nodes. node: to be drawn. group: what is drawn now, without
    its colours, for a shadow of it."""

    def __init__(self, points):
        self._points = points
        self.node = coin.SoSeparator()
        self._light, self._style = coin.SoLightModel(), coin.SoDrawStyle()
        self._colours, self._binding = coin.SoPackedColor(), coin.SoMaterialBinding()
        self._place = coin.SoGroup()
        for node in (self._light, self._style, self._colours, self._binding, self._place):
            self.node.addChild(node)
        self._lines = self._bars = self._used = None

    @property
    def group(self):
        return self._used.group

    def colour(self, colours):
        """colours: (m,) packed as 0xRRGGBBAA."""
        set_field(self._colours.orderedRGBA, colours)

    def show(self, form, line_width, look):
        """Lines stand in for more than BLOCK new bars."""
        self._style.lineWidth = line_width
        nodes, members = form.drawn_nodes, form.members
        if not look.bars:
            self._bars = None
        elif self._bars is None:
            self._bars = Bars()
        if self._bars and len(members) <= shapes.BLOCK and not self._bars.are_of(nodes, members, look):
            self._bars.show(nodes, members, look)
        if self._bars and self._bars.are_of(nodes, members, look):
            self._use_bars()
            return
        self._lines = self._lines or Lines(self._points)
        self._lines.show(members)
        self._use(self._lines, coin.SoLightModel.BASE_COLOR, coin.SoMaterialBinding.PER_FACE)

    def is_to_fill(self, form, look):
        """Whether lines stand in for bars."""
        return look.bars and not self._bars.are_of(form.drawn_nodes, form.members, look)

    def fill(self, form, look):
        """An iterator that fills in the bars, some each turn, and in the end shows them."""
        yield from self._bars.fill(form.drawn_nodes, form.members, look)
        self._use_bars()

    def _use_bars(self):
        self._lines = None
        self._use(self._bars, coin.SoLightModel.PHONG, coin.SoMaterialBinding.PER_FACE_INDEXED)

    def _use(self, shape, light, binding):
        if shape is not self._used:
            self._used = shape
            self._light.model, self._binding.value = light, binding
            self._place.removeAllChildren()
            self._place.addChild(shape.group)
