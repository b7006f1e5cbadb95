# SPDX-License-Identifier: LGPL-2.1-or-later
"""Match lengths: bring the members back to their lengths on the source, and see how near they came."""

import numpy as np

import funicular as fn
from funicular.gui.background import Background
from funicular.gui.live.buttons import push_button
from funicular.gui.qt import QtWidgets, translate
from funicular.gui.texts import WrappedText
from funicular.wording import number

ROUNDS = 8  # after which little is to be gained; it ends earlier where nothing is


class MatchingPart(QtWidgets.QWidget):
    """A button that matches, one that does without again, and what it came to.

    While the gridshell's property LengthMatching asks for rounds, each form that settles is matched.
    """

    def __init__(self, session, set_rounds):
        super().__init__()
        self._session, self._set_rounds = session, set_rounds
        # The scene that was made of the properties, and that which matching has made of it.
        self._of = self._matched = None
        self._background = Background(self, self._found)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        row = QtWidgets.QHBoxLayout()
        column.addLayout(row)
        row.addWidget(
            push_button(
                "MatchLengths",
                translate("Match lengths"),
                translate(
                    "Shorten what has become longer than on the source and lengthen what has become shorter, "
                    "round by round, as far as equilibrium lets it"
                ),
                lambda: self._ask(ROUNDS),
            )
        )
        self._undo = push_button(
            "UndoMatching",
            translate("Undo matching"),
            translate("Do without, or end it while it goes on"),
            lambda: self._ask(0),
        )
        row.addWidget(self._undo)
        self._text = WrappedText("")
        self._text.setObjectName("MatchingResult")
        column.addWidget(self._text)
        session.came.connect(self._look)
        self._show_buttons()

    def leave(self):
        self._background.stop()

    def end(self):
        """End the rounds that go on, and do without: whether there were any."""
        is_matching = "matching" in self._session.awaited
        if is_matching:
            self._ask(0)
        return is_matching

    def _ask(self, rounds):
        self._set_rounds(rounds)
        self._stop()
        self._of = None
        self._text.setText("")
        self._show_buttons()
        self._session.change()

    def _stop(self):
        self._background.stop()
        self._session.awaited.discard("matching")

    def _show_buttons(self):
        self._undo.setEnabled(self._session.shell.LengthMatching > 0)

    def _look(self):
        """Match a form that has just settled, if that is asked for."""
        moment, rounds = self._session.moment, self._session.shell.LengthMatching
        self._show_buttons()
        if not moment.ended or moment.scene is self._matched or moment.scene is self._of:
            return
        self._of = moment.scene
        self._stop()
        if rounds <= 0 or moment.result.status != "converged":
            self._text.setText(_deviation_text(moment))
            return
        self._text.setText(translate("Matching lengths, {} rounds").format(rounds))
        self._session.awaited.add("matching")
        method, accuracy = self._session.shell.Method.lower(), self._session.accuracy
        self._background.ask(lambda is_wanted: _match(moment, rounds, accuracy, method, is_wanted))

    def _found(self, matched):
        self._session.awaited.discard("matching")
        if isinstance(matched, str):
            self._text.setText(matched)
            return
        if not self._session.solve_scene(matched.scene, self._of):
            # What it was asked of has been changed since: the form that comes of that will be matched.
            self._text.setText("")
            return
        self._matched = matched.scene
        before, after = matched.deviations[0], matched.deviations[matched.best_round]
        self._text.setText(
            translate("Lengths differ by {} % → {} % (rms), best reached after {} rounds").format(
                number(100 * before, ".2g"), number(100 * after, ".2g"), matched.best_round
            )
        )


def _deviation_text(moment):
    result = moment.result
    if result.status != "converged":
        return ""
    apart = result.member_lengths / moment.scene.net.source_lengths - 1.0
    return translate("Lengths differ from those on the source by {} % (rms)").format(
        number(100 * float(np.sqrt(np.mean(apart**2))), ".2g")
    )


def _match(moment, rounds, accuracy, method, is_wanted):
    try:
        return fn.solve_matching_lengths(
            moment.scene,
            rounds=rounds,
            accuracy=accuracy,
            method=method,
            start=moment.result.nodes,
            on_progress=lambda report: is_wanted(),
        )
    except ValueError as error:
        return str(error)
