# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each effect of a gridshell costs, and how far the shape moves without it, at the press of a button."""

import funicular as fn
from funicular.effect_costs import NAMES
from funicular.gui.background import Background
from funicular.gui.lengths import length_in_words
from funicular.gui.live.buttons import push_button
from funicular.gui.qt import QtWidgets, translate
from funicular.gui.texts import WrappedText
from funicular.wording import number, time_text


class EffectList(QtWidgets.QWidget):
    """A button, and below it what came of it.

    Parameters
    ----------
    scene_of_shell : callable() -> (fn.Scene, accuracy [m])
        What to measure, asked for when the button is pressed. Raises ValueError.
    """

    def __init__(self, scene_of_shell):
        super().__init__()
        self._scene_of_shell = scene_of_shell
        self._background = Background(self, self._show)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._button = push_button(
            "EffectCosts",
            translate("What effects cost"),
            translate(
                "Solve once more without each effect: how much time it takes, and how far the shape moves. "
                "Nothing is left out by this."
            ),
            self._measure,
        )
        column.addWidget(self._button)
        self._text = WrappedText("")
        self._text.setObjectName("EffectList")
        self._text.hide()
        column.addWidget(self._text)

    def stop(self):
        """What was measured no longer holds, or nobody waits for it."""
        self._background.stop()
        self._button.setEnabled(True)
        self._text.hide()

    def end(self):
        """End a measurement that goes on: whether there was one."""
        is_measuring = not self._button.isEnabled()
        if is_measuring:
            self.stop()
        return is_measuring

    def _measure(self):
        try:
            scene, accuracy = self._scene_of_shell()
        except ValueError as error:
            self._show(str(error))
            return
        self._show(translate("Measuring"), busy=True)
        self._background.ask(lambda is_wanted: _effects_in_words(scene, accuracy, is_wanted))

    def _show(self, text, busy=False):
        self._button.setEnabled(not busy)
        self._text.setText(text)
        self._text.show()


def _effects_in_words(scene, accuracy, is_wanted):
    try:
        study = fn.effect_study(
            scene,
            accuracy,
            on_progress=lambda row: is_wanted(),
            on_report=lambda report: is_wanted(),
        )
    except ValueError as error:
        return str(error)
    lines = [_row_in_words(row, accuracy) for row in study.rows]
    if study.too_far_together is not None:
        lines.append(
            translate("Together these may move it by {}: leave out one, then measure again.").format(
                length_in_words(study.too_far_together)
            )
        )
    return "\n".join(lines)


def _row_in_words(row, accuracy):
    """Snow: 3.9 ms, 16 % of the time, 39 calls, 0.1 kB. Without it 22 % faster, 63.2 cm moved."""
    name = translate(NAMES[row["effect"]])
    words = translate("{}: {}, {} % of the time, {} calls, {} kB.").format(
        name[0].upper() + name[1:],
        time_text(row["seconds"]),
        round(100 * row["share"]),
        row["evaluations"],
        number(row["bytes"] / 1e3, ".1f"),
    )
    if row["moved"] is None:
        # It says why there is nothing to compare with; of stiffness nobody asks.
        return words + (f" {row['sentence'][0].upper()}{row['sentence'][1:]}." if row["sentence"] else "")
    percent = round(100 * row["saved"])
    speed = translate("{} % faster") if percent >= 0 else translate("{} % slower")
    words += " " + translate("Without it {}, and the shape moves by {}.").format(
        speed.format(abs(percent)), length_in_words(row["moved"])
    )
    if row["dispensable"]:
        words += " " + translate("That is less than {}: it may be left out.").format(
            length_in_words(accuracy)
        )
    return words
