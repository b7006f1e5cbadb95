# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces between the members: the covering, and the net as it was laid, pale as a ghost."""

from pivy import coin

from funicular.gui.drawing.shapes import Lines, Panels, set_points

# Of light timber.
TIMBER = (0.87, 0.77, 0.60)
UNDER_TWO_LIGHTS = 0.74
PALE, SEE_THROUGH = (0.62, 0.66, 0.72), 0.72
PALE_WIDTH = 1.0


class Covering:
    """The panels in timber, between the points of a coordinate node. node: to be drawn; group: without the
    colour, for a shadow of it."""

    def __init__(self, points):
        self.node = coin.SoSeparator()
        self._panels = Panels(points)
        self.group = self._panels.group
        for node in (_material(TIMBER), _behind(), self.group):
            self.node.addChild(node)

    def show(self, form):
        self._panels.show(form.drawn_nodes, form.panels)


class Source:
    """Where the net was laid: its panels, seen through, or its members where it has none."""

    def __init__(self):
        self.node, self._points = coin.SoSeparator(), coin.SoCoordinate3()
        self._shape = self._shown = None

    def show(self, form):
        if self._shown is not None and self._shown[0] is form.source_nodes and self._shown[1] is form.panels:
            return
        self._shown = form.source_nodes, form.panels
        kind = Panels if len(form.panels) else Lines
        if not isinstance(self._shape, kind):
            self._shape = kind(self._points)
            self.node.removeAllChildren()
            for node in self._around(kind):
                self.node.addChild(node)
            self.node.addChild(self._shape.group)
        set_points(self._points, form.source_nodes)
        if kind is Panels:
            self._shape.show(form.source_nodes, form.panels)
        else:
            self._shape.show(form.members)

    def _around(self, kind):
        if kind is Panels:
            # Further back still than a covering that has not risen yet.
            return _material(PALE, SEE_THROUGH), _behind(3.0)
        light, style = coin.SoLightModel(), coin.SoDrawStyle()
        light.model = coin.SoLightModel.BASE_COLOR
        style.lineWidth = PALE_WIDTH
        return light, style, _material(PALE)


def _material(colour, transparency=0.0):
    material = coin.SoMaterial()
    # Under the sun and the light at the eye together it has the colour; in the shade it is not black.
    material.diffuseColor = [UNDER_TWO_LIGHTS * channel for channel in colour]
    material.ambientColor = colour
    material.transparency = transparency
    return material


def _behind(steps=1.0):
    """Faces draw back from the lines that lie in them."""
    offset = coin.SoPolygonOffset()
    offset.factor = offset.units = steps
    return offset
