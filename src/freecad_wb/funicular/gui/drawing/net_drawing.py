# SPDX-License-Identifier: LGPL-2.1-or-later
"""A form as coin draws it: in place of a gridshell's own shape or around it, and gone without a trace."""

import FreeCAD
import numpy as np
from pivy import coin

from funicular.gui.drawing.ground import Ground
from funicular.gui.drawing.highlight import Highlight
from funicular.gui.drawing.look import look_of
from funicular.gui.drawing.members import Members
from funicular.gui.drawing.shapes import set_points
from funicular.gui.drawing.surfaces import Covering, Source
from funicular.gui.drawing.words import Words
from funicular.gui.qt import QtCore, translate
from funicular.shadows import toward_sun
from funicular.wording import number

NAME = "Funicular_drawing"
SUNLIGHT, SHADE = 0.32, 0.30


class NetDrawing:
    """A form, below the view provider of a gridshell, as its view properties say.

    What stands below it takes the gridshell's placement, is seen in each view of the document, and is counted
    by "fit all". There are coin nodes for what is asked for alone. The properties are read with each form.

    Parameters
    ----------
    vobj : view provider of a gridshell
    instead : bool
        The gridshell's own shape is out of date: nothing of it is to be seen or picked. It is hidden by the
        node that shows it, not by a property, for that would change the document. Otherwise the shape stays
        for picking, and draws plain lines.
    """

    def __init__(self, vobj, instead=True):
        self._vobj, self._instead = vobj, instead
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        unpickable = coin.SoPickStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        self._root.addChild(unpickable)
        # From the sun, beside the light that FreeCAD has at the eye: what that one only grazes is not black.
        self._light = coin.SoDirectionalLight()
        self._light.intensity = SUNLIGHT
        shade = coin.SoEnvironment()
        shade.ambientIntensity = SHADE
        self._root.addChild(self._light)
        self._root.addChild(shade)
        self._points = coin.SoCoordinate3()
        # What there is now of what can be drawn, by its kind.
        self._parts = {}
        self._form = self._look = self._sun = self._filling = self._hiding = self._coloured_by = None
        self._turns = QtCore.QTimer()
        self._turns.setInterval(0)
        self._turns.timeout.connect(self._fill)
        self.highlight = Highlight(self._root) if instead else None
        # Before the shape: what hides that would hide all that follows.
        vobj.RootNode.insertChild(self._root, vobj.RootNode.findChild(vobj.SwitchNode))
        if instead:
            self._was_shown = vobj.SwitchNode.whichChild.getValue()
            vobj.SwitchNode.whichChild = coin.SO_SWITCH_NONE

    @property
    def drawn_nodes(self):
        """(n, 3) [m]: where the nodes are drawn, None before the first form."""
        return None if self._form is None else self._form.drawn_nodes

    def show(self, form, coloured):
        """Draw a Form in place of the one before; of many bars lines stand in for new ones until rest().

        coloured: colouring.Coloured
        """
        self._stop_filling()
        self._form, self._look = form, look_of(self._vobj).fit_for(form)
        look = self._look
        left_to_shape = not self._instead and look.is_left_to_shape
        set_points(self._points, form.drawn_nodes)
        if self._asked(Members, look.members and not left_to_shape, self._points):
            self._parts[Members].show(form, self._vobj.LineWidth, look)
            self._colour(coloured)
        if self._asked(Covering, look.covering, self._points):
            self._parts[Covering].show(form)
        if self._asked(Source, look.source):
            self._parts[Source].show(form)
        # What stands below the view provider turns with the gridshell; the sun does not.
        turned = self._vobj.Object.getGlobalPlacement().Rotation.inverted()
        sun = turned.multVec(FreeCAD.Vector(*toward_sun(look.azimuth, look.altitude)))
        self._sun = np.array(sun)
        self._light.direction = (-self._sun).tolist()
        if self._asked(Ground, look.ground):
            self._show_ground()
        if self._asked(Words, form.exaggeration != 1.0):
            text = translate("Displacement × {}").format(number(form.exaggeration, ".3g"))
            self._parts[Words].show(form.drawn_nodes, text)
        if not self._instead:
            self._hide_shape(not left_to_shape, form.exaggeration != 1.0)
        if self.highlight:
            self.highlight.show(form)

    def rest(self, at_once=False):
        """The form stays as it is for now: fill in what was left out, bit by bit unless at once."""
        members = self._parts.get(Members)
        if self._filling or members is None or not members.is_to_fill(self._form, self._look):
            return
        self._filling = members.fill(self._form, self._look)
        if at_once:
            while self._filling:
                self._fill()
        else:
            self._turns.start()

    def remove(self):
        """Take it out of the view, where the gridshell's own shape stands again."""
        self._stop_filling()
        try:
            self._vobj.RootNode.removeChild(self._root)
            self._hide_shape(False, False)
            if self._instead:
                self._vobj.SwitchNode.whichChild = self._was_shown
        except (ReferenceError, RuntimeError):
            pass  # the gridshell is gone, and what was below it

    def _asked(self, kind, is_asked, *points):
        """Have a part or have none; returns whether there is one."""
        if is_asked and kind not in self._parts:
            self._parts[kind] = kind(*points)
            self._root.addChild(self._parts[kind].node)
            self._coloured_by = None
        elif not is_asked and kind in self._parts:
            self._root.removeChild(self._parts.pop(kind).node)
        return bool(is_asked)

    def _colour(self, coloured):
        plain = tuple(self._vobj.LineColor[:3])
        if (coloured, plain) != self._coloured_by:
            self._parts[Members].colour(coloured.packed(plain))
            self._coloured_by = coloured, plain

    def _show_ground(self):
        throwing = [self._parts[kind].group for kind in (Members, Covering) if kind in self._parts]
        self._parts[Ground].show(self._form, throwing, self._sun)

    def _fill(self):
        try:
            next(self._filling)
        except StopIteration:
            self._stop_filling()
            if Ground in self._parts:
                self._show_ground()

    def _stop_filling(self):
        self._turns.stop()
        self._filling = None

    def _hide_shape(self, is_hidden, is_elsewhere):
        """Let the gridshell's own shape not be drawn and, where it is elsewhere than drawn, not be picked."""
        root = self._vobj.RootNode
        if self._hiding:
            root.removeChild(self._hiding)
            self._hiding = None
        if not is_hidden:
            return
        self._hiding = coin.SoGroup()
        style = coin.SoDrawStyle()
        style.style = coin.SoDrawStyle.INVISIBLE
        style.setOverride(True)
        self._hiding.addChild(style)
        if is_elsewhere:
            unpickable = coin.SoPickStyle()
            unpickable.style = coin.SoPickStyle.UNPICKABLE
            unpickable.setOverride(True)
            self._hiding.addChild(unpickable)
        root.insertChild(self._hiding, root.findChild(self._vobj.SwitchNode))
