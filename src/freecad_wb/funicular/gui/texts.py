# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences in panels and docks: how well things are, headings, texts that need more than one line."""

from funicular.gui.qt import QtCore, QtGui, QtWidgets

# A symbol, and its colour on a light and on a dark window.
GOOD = ("✔", "#2e7d32", "#81c784")
DOUBTFUL = ("⚠", "#945200", "#ffb74d")
WRONG = ("✖", "#c62828", "#ff8a80")
BUSY = ("…", "#555555", "#bbbbbb")


class WrappedText(QtWidgets.QLabel):
    """Text as wide as where it stands, and never cut off: it insists on the height that it needs."""

    LEAST_LINES = 1

    def __init__(self, text=""):
        self._kind = None
        super().__init__(text)
        self.setWordWrap(True)
        self.setTextFormat(QtCore.Qt.PlainText)
        self._make_room()
        self.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.MinimumExpanding)
        self.setAlignment(QtCore.Qt.AlignTop | QtCore.Qt.AlignLeft)

    def set_colour(self, kind):
        """The colour of GOOD, DOUBTFUL, WRONG or BUSY, as it can be read on this window.

        None: that of other text.
        """
        self._kind = kind
        self._colour()

    def _colour(self):
        style = ""
        if self._kind is not None:
            _, on_light, on_dark = self._kind
            # By the ink: a style sheet tells the palette nothing of the paper. The parent's: ours has one.
            ink = (self.parentWidget() or self).palette().color(QtGui.QPalette.WindowText)
            style = f"color: {on_dark if ink.lightness() > 127 else on_light}"
        if style != self.styleSheet():
            self.setStyleSheet(style)

    def showEvent(self, event):
        super().showEvent(event)
        # It may have been coloured before it stood anywhere.
        self._colour()

    def changeEvent(self, event):
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.PaletteChange, QtCore.QEvent.StyleChange):
            self._colour()

    def setText(self, text):
        super().setText(text)
        self._make_room()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._make_room()

    def _make_room(self):
        """A panel that scrolls gives a label no more height than it insists on."""
        lines = self.LEAST_LINES * self.fontMetrics().lineSpacing()
        self.setMinimumHeight(max(lines, self.heightForWidth(self.width())))


class ResultLine(WrappedText):
    """One sentence with a symbol and a colour, so that neither is needed to read the other."""

    # Room for three lines or more, so that inputs below seldom jump.
    LEAST_LINES = 3

    def __init__(self):
        super().__init__()
        self.setObjectName("ResultLine")
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)

    def say(self, kind, sentence):
        self.set_colour(kind)
        self.setText(f"{kind[0]} {sentence}")


class Heading(QtWidgets.QLabel):
    """Title of a group of inputs."""

    def __init__(self, text):
        super().__init__(text)
        font = self.font()
        font.setBold(True)
        self.setFont(font)
        self.setContentsMargins(0, 2, 0, 0)
