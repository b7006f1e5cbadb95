# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reactions of a form as arrows in the 3D view, below the view provider of its gridshell."""

import numpy as np
from pivy import coin

from funicular.arrows import LONGEST, arrow_points
from funicular.gui.drawing.shapes import MILLIMETRES, Arrows, longest_side

# Unlike any force, and seen on white as on dark blue.
COLOUR = (0.13, 0.62, 0.25)
LINE_WIDTH = 2.0
NAME = "Funicular_reactions"


def reaction_points(form):
    """(k, 3) [m] points of the arrows of a Form's reactions, as funicular.arrows.arrow_points() has them."""
    held = np.flatnonzero(np.abs(form.reactions).sum(axis=1))
    longest = LONGEST * longest_side(form.drawn_nodes)
    return arrow_points(form.drawn_nodes[held], form.reactions[held], longest)


class ReactionArrows:
    """One arrow a reaction, its tip at the node that is held; the largest is a fifth of the net's size."""

    def __init__(self, vobj):
        self._vobj = vobj
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        unpickable, light = coin.SoPickStyle(), coin.SoLightModel()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        colour, style = coin.SoBaseColor(), coin.SoDrawStyle()
        colour.rgb, style.lineWidth = COLOUR, LINE_WIDTH
        self._arrows = Arrows()
        for node in (unpickable, light, colour, style, self._arrows.group):
            self._root.addChild(node)
        # Before the shape, for what hides that hides what follows too.
        vobj.RootNode.insertChild(self._root, max(vobj.RootNode.findChild(vobj.SwitchNode), 0))

    def show(self, form):
        """Those of a Form in place of the ones before."""
        self._arrows.show(reaction_points(form) * MILLIMETRES)

    def remove(self):
        try:
            self._vobj.RootNode.removeChild(self._root)
        except (ReferenceError, RuntimeError):
            pass  # the gridshell is gone, and what was below it
