# SPDX-License-Identifier: LGPL-2.1-or-later
"""A line on a 3D view that follows the mouse: the box or lasso within which nodes are picked."""

from pivy import coin

from funicular.gui.drawing.on_screen import size_of

NAME = "Funicular_outline"
LINE_WIDTH = 2.0
# Dark dashes on light: seen on any background.
DARK, LIGHT, DASHES = (0.1, 0.1, 0.1), (1.0, 1.0, 1.0), 0x0F0F


class ScreenOutline:
    """In front of one view at a time; nothing of it is left when it is hidden."""

    def __init__(self):
        self._graph = None
        # FreeCAD's own group: without it "fit all" would zoom to the line too.
        self._root = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
        # Made by its type, it would go with the graph that lets it go.
        self._root.ref()
        self._root.setName(NAME)
        self._points, self._line = coin.SoCoordinate3(), coin.SoLineSet()
        separator = coin.SoSeparator()
        for node in (
            *_in_front(),
            self._points,
            *_style(LIGHT),
            self._line,
            *_style(DARK, DASHES),
            self._line,
        ):
            separator.addChild(node)
        self._root.addChild(separator)

    def show(self, view, outline):
        """outline: (k, 2) places in the widget of the view."""
        graph = view.getSceneGraph()
        if self._graph is None:
            self._graph = graph
            graph.addChild(self._root)
        width, height = size_of(view)
        points = [(2.0 * x / width - 1.0, 1.0 - 2.0 * y / height, 0.0) for x, y in outline]
        self._points.point.setValues(0, len(points), points)
        self._points.point.setNum(len(points))
        self._line.numVertices = len(points)

    def remove(self):
        """It is needed no more."""
        self.hide()
        self._root.unref()
        self._root = None

    def hide(self):
        if self._graph is not None:
            self._graph.removeChild(self._root)
            self._graph = None


def _in_front():
    unpickable, light, depth = coin.SoPickStyle(), coin.SoLightModel(), coin.SoDepthBuffer()
    unpickable.style = coin.SoPickStyle.UNPICKABLE
    light.model = coin.SoLightModel.BASE_COLOR
    depth.test = False
    camera = coin.SoOrthographicCamera()
    # The window always spans [-1, 1] in both directions.
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.aspectRatio, camera.height = 1.0, 2.0
    camera.position = (0.0, 0.0, 1.0)
    camera.nearDistance, camera.farDistance = 0.0, 2.0
    return unpickable, light, depth, camera


def _style(rgb, pattern=0xFFFF):
    colour, style = coin.SoBaseColor(), coin.SoDrawStyle()
    colour.rgb = rgb
    style.lineWidth, style.linePattern = LINE_WIDTH, pattern
    return colour, style
