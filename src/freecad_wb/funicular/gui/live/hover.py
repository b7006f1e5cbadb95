# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the mouse is on in the 3D view: the member or node stands out, and a tooltip reads it."""

from pivy import coin

from funicular.gui.colouring import section_or_fault
from funicular.gui.drawing.highlight import Highlight
from funicular.gui.drawing.on_screen import REACH
from funicular.gui.drawing.shapes import MILLIMETRES
from funicular.gui.live.readings import read_member, read_node
from funicular.gui.qt import QtCore

NAME = "Funicular_hover"
# Seen on white as on dark blue, beside blue, orange and violet.
COLOUR = (0.16, 0.72, 0.10)

# The mouse moves more often than anyone reads; and where it stands still, views may turn below it.
PAUSE_MS, AGAIN_MS = 40, 250
# Of a member's length on the screen: that near its end it is the node that is meant.
NEAR_END = 0.25


class Hover(QtCore.QObject):
    """Takes part in a Pointer, and takes no event for itself.

    on: ("member" or "node", number) of what the mouse is on, None for nothing. words: what the tooltip says.
    """

    def __init__(self, session, pointer, parent=None):
        super().__init__(parent)
        self._session, self._pointer = session, pointer
        self._vobj = session.shell.ViewObject
        self.on, self.words, self._at = None, "", None
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        unpickable, light = coin.SoPickStyle(), coin.SoLightModel()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        self._root.addChild(unpickable)
        self._root.addChild(light)
        self._highlight = Highlight(self._root, COLOUR)
        self._vobj.RootNode.addChild(self._root)
        self._pause = QtCore.QTimer(self)
        self._pause.setSingleShot(True)
        self._pause.timeout.connect(self._look)
        session.moved.connect(self._follow)
        pointer.add(self)

    def leave(self):
        """Nothing stands out, and nothing is listened to."""
        self._pause.stop()
        self._pointer.remove(self)
        self._pointer.tip.say(self, "")
        self._session, self._at = None, None
        self.deleteLater()
        try:
            self._vobj.RootNode.removeChild(self._root)
        except (ReferenceError, RuntimeError):
            pass  # the gridshell is gone, and what was below it

    # What the pointer asks

    def moved(self, at):
        if at.buttons:
            self._rest()
        else:
            self._at = at
            if not self._pause.isActive() or self._pause.remainingTime() > PAUSE_MS:
                self._pause.start(PAUSE_MS)
        return False

    def pressed(self, at):
        self._rest()
        return False

    def left(self):
        self._rest()
        return False

    # What follows

    def _rest(self):
        self._at = None
        self._pause.stop()
        self._show(None)

    def _follow(self):
        """The net moves below a mouse that may stand still."""
        if self.on is not None:
            self._highlight.show(self._session.form)

    def _look(self):
        form, at = self._session.form, self._at
        if form is None or at is None:
            return
        try:
            self._show(_under(form, at))
            self._pause.start(AGAIN_MS)
        except (ReferenceError, RuntimeError):
            self._rest()  # the view has gone since

    def _show(self, on):
        form, before = self._session.form, (self.on, self.words)
        if on is None:
            self.words = ""
        else:
            kind, number = on
            section, _ = section_or_fault(self._session.shell)
            if kind == "member":
                self.words = read_member(form, number, section)
            else:
                self.words = read_node(form, number, self._session.shell.getGlobalPlacement())
        if on != self.on:
            self.on = on
            kind, number = on or ("", 0)
            self._highlight.choose([number] if kind == "node" else (), [number] if kind == "member" else ())
            if form is not None:
                self._highlight.show(form)
        if (self.on, self.words) != before:
            self._pointer.tip.say(self, self.words, self._at)


def _under(form, at):
    """As Hover.on."""
    points, screen = form.drawn_nodes * MILLIMETRES, at.screen()
    member = screen.nearest_member(points, form.members, at.place)
    if member is None:
        node = screen.nearest_node(points, at.place)
        return None if node is None else ("node", node)
    ends = form.members[member]
    places, _ = screen.of(points[ends])
    length = float(((places[0] - places[1]) ** 2).sum() ** 0.5)
    near = screen.nearest_node(points[ends], at.place, min(REACH, NEAR_END * length))
    return ("member", member) if near is None else ("node", int(ends[near]))
