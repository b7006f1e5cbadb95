# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pause, step, begin again, and watch the paper's relaxation."""

from funicular.gui.drawn_icons import drawn_icon, polygon
from funicular.gui.qt import QtCore, QtWidgets, translate


class MotionPart(QtWidgets.QWidget):
    """A row of buttons that lead the session."""

    def __init__(self, session):
        super().__init__()
        self._session = session
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2)
        self._icons = {False: drawn_icon(_two_bars), True: drawn_icon(_arrow)}
        self._pause = self._button(row, "Pause", self._icons[False], self._pause_or_resume)
        self._step = self._button(row, "Step", drawn_icon(_arrow_to_bar), self._one_step)
        self._step.setToolTip(translate("One iteration of the solver more, then a pause"))
        restart = self._button(row, "Restart", drawn_icon(_bar_and_arrow_back), self._restart)
        restart.setToolTip(translate("Begin again from the net as it lies on its source"))
        self._slowly = QtWidgets.QCheckBox(translate("Relax slowly"))
        self._slowly.setObjectName("RelaxSlowly")
        self._slowly.setToolTip(
            translate(
                "Watch how the net comes to hang by the relaxation of Brivio et al. (2009), step by step, "
                "instead of the fast solver. What it comes to is the same."
            )
        )
        self._slowly.toggled.connect(self._relax_slowly)
        row.addWidget(self._slowly)
        row.addStretch(1)
        session.came.connect(self.show_motion)
        self.show_motion()

    def leave(self):
        """Hold nothing of the panel: PySide keeps some of what buttons were connected to."""
        self._session = None

    def _button(self, row, name, icon, pressed):
        button = QtWidgets.QToolButton()
        button.setObjectName(name)
        button.setIcon(icon)
        button.clicked.connect(lambda: pressed())
        row.addWidget(button)
        return button

    def _pause_or_resume(self):
        (self._session.resume if self._session.is_paused else self._session.pause)()
        self.show_motion()

    def _one_step(self):
        self._session.step()
        self.show_motion()

    def _restart(self):
        self._session.restart()
        self.show_motion()

    def _relax_slowly(self, slowly):
        self._session.relax_slowly(slowly)
        self.show_motion()

    def show_motion(self):
        paused = self._session.is_paused
        self._pause.setIcon(self._icons[paused])
        words = translate("Resume") if paused else translate("Pause")
        self._pause.setToolTip(words)
        self._pause.setAccessibleName(words)


def _arrow(painter, ink):
    _fill(painter, ink, polygon((26, 14), (26, 82), (80, 48)))


def _two_bars(painter, ink):
    _fill(painter, ink, *(polygon((x, 16), (x, 80), (x + 20, 80), (x + 20, 16)) for x in (22, 54)))


def _arrow_to_bar(painter, ink):
    _fill(
        painter, ink, polygon((16, 18), (16, 78), (62, 48)), polygon((66, 18), (66, 78), (80, 78), (80, 18))
    )


def _bar_and_arrow_back(painter, ink):
    _fill(
        painter, ink, polygon((80, 18), (80, 78), (34, 48)), polygon((16, 18), (16, 78), (30, 78), (30, 18))
    )


def _fill(painter, ink, *shapes):
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(ink)
    for shape in shapes:
        painter.drawPolygon(shape)
