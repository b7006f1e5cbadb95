# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the form found by hand stands: one line in words, and why it may not be what is wanted."""

from funicular.gui.qt import QtWidgets, translate
from funicular.gui.texts import BUSY, DOUBTFUL, GOOD, WRONG, ResultLine


class StatePart(QtWidgets.QWidget):
    """The line of words."""

    def __init__(self, session):
        super().__init__()
        self._session = session
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.line = ResultLine()
        column.addWidget(self.line)
        session.came.connect(self.show_moment)
        session.failed.connect(self.show_failure)

    def show_moment(self):
        """Say what the latest moment is."""
        self.line.say(*self._words())

    def show_failure(self, sentence):
        kept = "" if self._session.form is None else " " + translate("(The last good shape stays.)")
        self.line.say(WRONG, sentence + self._remedy(sentence) + kept)

    def _words(self):
        """(kind, sentence)"""
        from funicular.features.gridshell import complaint, sentence_of

        moment, net = self._session.moment, self._session.net
        result = moment.result
        if not moment.ended:
            words = translate("Paused") if self._session.is_paused else translate("Solving")
            return BUSY, words + " " + translate("({} iterations)").format(result.iterations)
        if result.status != "converged":
            return WRONG, complaint(result.status, result.message)
        sentence = sentence_of(moment.scene, result, moment.certificate)
        if net.Remarks:
            # What came out otherwise than it was asked for.
            sentence += ". " + net.Remarks
        return (GOOD if moment.certificate.compression_only else DOUBTFUL), sentence

    def _remedy(self, sentence):
        if "pick" not in sentence:
            return ""
        return translate(". Select another face and press “Use selected faces”.")
