# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pause, step, begin again, and watch the paper's relaxation."""

from funicular.gui.qt import QtWidgets, translate


class MotionPart(QtWidgets.QWidget):
    """A row of buttons that lead the session."""

    def __init__(self, session):
        super().__init__()
        self._session = session
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2)
        style = self.style()
        self._icons = {
            paused: style.standardIcon(
                QtWidgets.QStyle.SP_MediaPlay if paused else QtWidgets.QStyle.SP_MediaPause
            )
            for paused in (False, True)
        }
        self._pause = self._button(row, "Pause", self._icons[False], self._pause_or_resume)
        self._step = self._button(
            row, "Step", style.standardIcon(QtWidgets.QStyle.SP_MediaSkipForward), self._one_step
        )
        self._step.setToolTip(translate("One iteration of the solver more, then a pause"))
        restart = self._button(
            row, "Restart", style.standardIcon(QtWidgets.QStyle.SP_MediaSkipBackward), self._restart
        )
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
        session.came.connect(self._show)
        self._show()

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
        self._show()

    def _one_step(self):
        self._session.step()
        self._show()

    def _restart(self):
        self._session.restart()
        self._show()

    def _relax_slowly(self, slowly):
        self._session.relax_slowly(slowly)
        self._show()

    def _show(self):
        paused = self._session.is_paused
        self._pause.setIcon(self._icons[paused])
        words = translate("Resume") if paused else translate("Pause")
        self._pause.setToolTip(words)
        self._pause.setAccessibleName(words)
