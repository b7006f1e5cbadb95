# SPDX-License-Identifier: LGPL-2.1-or-later
"""A form as coin draws it: in place of a gridshell's own shape while it moves, and gone without a trace."""

import numpy as np
from pivy import coin

from funicular.colours import ON_SCREEN
from funicular.gui.drawing.highlight import Highlight

MILLIMETRES = 1e3  # of a metre
LINE_WIDTH = 3.0
NAME = "Funicular_drawing"


class NetDrawing:
    """The members of a form as lines, coloured, below the view provider of a gridshell.

    What stands below it takes the gridshell's placement, is seen in each view of the document, and is counted
    by "fit all". The gridshell's own shape is hidden meanwhile by the node that shows it, not by a property,
    for that would change the document.
    """

    def __init__(self, vobj):
        self._vobj = vobj
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        unpickable = coin.SoPickStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        style = coin.SoDrawStyle()
        style.lineWidth = LINE_WIDTH
        self._vertices = coin.SoVertexProperty()
        self._vertices.materialBinding = coin.SoVertexProperty.PER_FACE
        self._lines = coin.SoIndexedLineSet()
        self._lines.vertexProperty = self._vertices
        for node in (unpickable, light, style, self._lines):
            self._root.addChild(node)
        self._members = self._forces = None
        self.highlight = Highlight(self._root)
        vobj.RootNode.addChild(self._root)
        self._was_shown = vobj.SwitchNode.whichChild.getValue()
        vobj.SwitchNode.whichChild = coin.SO_SWITCH_NONE

    def show(self, form):
        """Draw a Form in place of the one before."""
        if form.members is not self._members:
            # The numbers of another net.
            self._members = form.members
            breaks = np.full(len(form.members), -1)
            indices = np.column_stack([form.members, breaks]).ravel().tolist()
            self._lines.coordIndex.setValues(0, len(indices), indices)
            self._lines.coordIndex.setNum(len(indices))
        # As an array: lists of thousands of lists would have Python look for garbage among all that it holds.
        points = (form.nodes * MILLIMETRES).astype(np.float32)
        self._vertices.vertex.setValues(0, len(points), points)
        self._vertices.vertex.setNum(len(points))
        if form.member_forces is not self._forces:
            self._forces = form.member_forces
            colours = _packed(form).tolist()
            self._vertices.orderedRGBA.setValues(0, len(colours), colours)
            self._vertices.orderedRGBA.setNum(len(colours))
        self.highlight.show(form)

    def remove(self):
        """Take it out of the view, where the gridshell's own shape stands again."""
        try:
            self._vobj.RootNode.removeChild(self._root)
            self._vobj.SwitchNode.whichChild = self._was_shown
        except (ReferenceError, RuntimeError):
            pass  # the gridshell is gone, and what was below it


def _packed(form):
    """(m,) colours 0xRRGGBBAA of the members by their force."""
    ramp = np.array(ON_SCREEN.compression)
    largest = max(-form.member_forces.min(initial=0.0), 1e-300)
    place = np.clip(-form.member_forces / largest, 0.0, 1.0) * (len(ramp) - 1)
    low = np.minimum(place.astype(int), len(ramp) - 2)
    rgb = ramp[low] + (place - low)[:, None] * (ramp[low + 1] - ramp[low])
    red, green, blue = np.rint(255 * rgb).astype(np.uint32).T
    return red << 24 | green << 16 | blue << 8 | 255
