# SPDX-License-Identifier: LGPL-2.1-or-later
"""Level ground below a gridshell, and its shadow on it."""

from pivy import coin

from funicular.gui.drawing.shapes import MILLIMETRES, set_points
from funicular.shadows import ground_below, shadow_matrix

GROUND = (0.80, 0.80, 0.77)
# As dark where two members shade it as where one does, and so it is no veil but a colour.
SHADOW = (0.50, 0.51, 0.54)


class Ground:
    """A rectangle of ground with the shadow of groups of coin nodes; these nodes, flattened."""

    def __init__(self):
        # "Fit all" leaves out what is in a group of this kind.
        self.node = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.OVERALL
        # The group is no separator itself.
        separator = coin.SoSeparator()
        for node in (light, binding, self._plane(), self._shadow()):
            separator.addChild(node)
        self.node.addChild(separator)

    def _plane(self):
        plane = coin.SoSeparator()
        colour = coin.SoBaseColor()
        colour.rgb = GROUND
        # Behind the shadow, which lies in it.
        behind = coin.SoPolygonOffset()
        behind.factor, behind.units = 2.0, 4.0
        hints = coin.SoShapeHints()
        # From below it is not there: one looks up into the shell.
        hints.vertexOrdering, hints.shapeType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.SOLID
        self._corners, face = coin.SoCoordinate3(), coin.SoFaceSet()
        face.numVertices = 4
        for node in (colour, behind, hints, self._corners, face):
            plane.addChild(node)
        return plane

    def _shadow(self):
        shadow = coin.SoSeparator()
        colour = coin.SoBaseColor()
        colour.rgb = SHADOW
        self._flatten, self._of, self._groups = coin.SoMatrixTransform(), coin.SoGroup(), []
        for node in (colour, self._flatten, self._of):
            shadow.addChild(node)
        return shadow

    def show(self, form, groups, sun):
        """groups: of coin nodes that throw the shadow. sun: (3,) towards it."""
        nodes = form.drawn_nodes
        # The lowest support, or what hangs below it: nothing throws a shadow upward.
        level = nodes[:, 2].min()
        set_points(self._corners, ground_below(nodes, sun, level))
        matrix = shadow_matrix(sun, level * MILLIMETRES)
        # Coin multiplies rows, from the left.
        self._flatten.matrix = coin.SbMatrix(*matrix.T.ravel().tolist())
        if groups != self._groups:
            self._groups = groups
            self._of.removeAllChildren()
            for group in groups:
                self._of.addChild(group)
