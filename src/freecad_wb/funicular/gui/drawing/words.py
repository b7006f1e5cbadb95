# SPDX-License-Identifier: LGPL-2.1-or-later
"""A line of words in the 3D view, above what is drawn."""

from pivy import coin

from funicular.gui.drawing.shapes import MILLIMETRES

SIZE = 16.0  # [pt]
ABOVE = 0.06  # of the size of what is drawn
# Seen on white as on FreeCAD's blue.
COLOUR = (0.96, 0.50, 0.12)
FONT = "Arial,Helvetica,FreeSans,DejaVu Sans:Bold"


class Words:
    def __init__(self):
        # Words are as large as they are, however far away: "fit all" leaves them out.
        self.node = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
        separator, colour, font = coin.SoSeparator(), coin.SoBaseColor(), coin.SoFont()
        colour.rgb, font.name, font.size = COLOUR, FONT, SIZE
        self._place, self._text = coin.SoTranslation(), coin.SoText2()
        self._text.justification = coin.SoText2.CENTER
        for node in (colour, font, self._place, self._text):
            separator.addChild(node)
        self.node.addChild(separator)

    def show(self, nodes, text):
        """nodes: (n, 3) [m], above whose middle the text is to stand."""
        low, high = nodes.min(axis=0), nodes.max(axis=0)
        top = 0.5 * (low + high)
        top[2] = high[2] + ABOVE * max((high - low).max(), 1e-3)
        self._place.translation = (top * MILLIMETRES).tolist()
        self._text.string = text
