# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the form found by hand stands: one line in words, how it came there, and what may not be wanted."""

from funicular.gui.live.strip_chart import StripChart
from funicular.gui.live.warnings_list import WarningsList
from funicular.gui.qt import QtWidgets, translate
from funicular.gui.texts import BUSY, DOUBTFUL, GOOD, WRONG, ResultLine


class StatePart(QtWidgets.QWidget):
    """The line of words, the strip chart, and the warnings.

    Parameters
    ----------
    session : live.session.Session
    show_these : callable(nodes, members)
        Shows nodes and members, by their numbers, in the 3D view.
    do : callable(change)
        As for WarningsList.
    """

    def __init__(self, session, show_these, do):
        super().__init__()
        self._session = session
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        self.line = ResultLine()
        column.addWidget(self.line)
        self.warnings = WarningsList(session, show_these, do)
        column.addWidget(self.warnings)
        self._chart = StripChart()
        column.addWidget(self._chart)

    def show_moment(self):
        """Say what the latest moment is."""
        session = self._session
        if session.moment is None or session.moment.error:
            return
        self.line.say(*self._words())
        self._chart.show_course(session.chart, session.accuracy)
        if session.moment.ended:
            self.warnings.show_moment(session.moment)

    def show_failure(self, sentence):
        """Say why there is nothing new."""
        kept = "" if self._session.form is None else " " + translate("(The last good shape stays.)")
        self.line.say(WRONG, sentence + self._remedy(sentence) + kept)
        self.warnings.clear()

    def _words(self):
        """(kind, sentence)"""
        from funicular.features.result_words import complaint, distance_text, sentence_of

        moment, net = self._session.moment, self._session.net
        result = moment.result
        if not moment.ended:
            words = translate("Paused") if self._session.is_paused else translate("Solving")
            words = translate("{}, {} iterations").format(words, result.iterations)
            if result.position_error < float("inf"):
                words += ". " + distance_text(result.position_error)
            return BUSY, words
        if result.status != "converged":
            return WRONG, complaint(result.status, result.message)
        sentence = sentence_of(moment.scene, result, moment.certificate, moment.covered)
        if net.Remarks:
            # What came out otherwise than it was asked for.
            sentence += " " + net.Remarks
        return (GOOD if moment.certificate.compression_only else DOUBTFUL), sentence

    def _remedy(self, sentence):
        if "pick" not in sentence:
            return ""
        return translate(". Select another face and press “Use selected faces”.")
