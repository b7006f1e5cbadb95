# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a solve came to its end: residual and distance from equilibrium against time, on a narrow strip."""

import math

from funicular.gui.lengths import length_in_words
from funicular.gui.qt import QtCore, QtGui, QtWidgets, translate
from funicular.wording import time_text

HEIGHT = 64
LEFT, RIGHT, TOP, BOTTOM = 4, 4, 14, 14
# Decades above and below what is asked for.
MOST, LEAST = 6.0, -3.0
LEAST_TOLD = 1e-6  # [m]
TOLERANCE = 1e-6  # of the residual, in mean nodal loads: what the solver asks for unless told otherwise

# Blue and orange, told apart by everyone, and by their dashes.
RESIDUAL, DISTANCE = ("#4a90d9", QtCore.Qt.DashLine), ("#d9822b", QtCore.Qt.SolidLine)


class StripChart(QtWidgets.QWidget):
    """Two curves on a logarithmic height; the line across is what is asked for."""

    def __init__(self):
        super().__init__()
        self.setObjectName("StripChart")
        self.setFixedHeight(HEIGHT)
        self.setToolTip(
            translate(
                "How the solve went, against time. Full line: distance from equilibrium, dashed: largest "
                "unbalanced force. The level line is what is asked for: below it a curve has arrived."
            )
        )
        self._course, self._accuracy = [], 1e-3

    def show_course(self, course, accuracy):
        """course: [(seconds, residual, position error [m])]. accuracy: [m]"""
        self._course, self._accuracy = course, accuracy
        self.setAccessibleName(self._words())
        self.update()

    def _words(self):
        if not self._course:
            return ""
        seconds, residual, distance = self._course[-1]
        words = time_text(max(seconds, 1e-4))
        if distance == distance:
            # What is less is of no use to anyone who builds.
            less = "< " if distance < LEAST_TOLD else ""
            words += " · " + less + length_in_words(max(distance, LEAST_TOLD))
        return words + " · " + translate("residual {:.0e}").format(residual)

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        ink = self.palette().color(QtGui.QPalette.WindowText)
        faint = QtGui.QColor(ink)
        faint.setAlpha(150)
        painter.setPen(QtGui.QPen(faint, 1.0))
        level = self._height_of(0.0)
        painter.drawLine(QtCore.QPointF(LEFT, level), QtCore.QPointF(self.width() - RIGHT, level))
        font = QtGui.QFont(self.font())
        font.setPixelSize(10)
        painter.setFont(font)
        painter.setPen(ink)
        words = self.fontMetrics().elidedText(self._words(), QtCore.Qt.ElideRight, self.width())
        painter.drawText(QtCore.QRect(LEFT, 0, self.width(), TOP), QtCore.Qt.AlignLeft, words)
        painter.setPen(faint)
        asked = translate("asked for: {}").format(length_in_words(self._accuracy))
        place = QtCore.QRect(LEFT, round(level) + 1, self.width() - LEFT - RIGHT, BOTTOM)
        # Where courses begin they are above it.
        painter.drawText(place, QtCore.Qt.AlignLeft, asked)
        for column, asked, (colour, dashes) in ((1, TOLERANCE, RESIDUAL), (2, self._accuracy, DISTANCE)):
            painter.setPen(QtGui.QPen(QtGui.QColor(colour), 1.6, dashes))
            self._draw(painter, column, asked)
        painter.end()

    def _draw(self, painter, column, asked):
        end = max(self._course[-1][0], 1e-9) if self._course else 1.0
        line = QtGui.QPolygonF()
        for moment in self._course:
            if moment[column] == moment[column]:
                share = math.log10(max(moment[column], 1e-300) / asked)
                across = LEFT + (self.width() - LEFT - RIGHT) * moment[0] / end
                line.append(QtCore.QPointF(across, self._height_of(share)))
        if line.count() == 1:
            painter.drawEllipse(line.at(0), 1.5, 1.5)
        else:
            painter.drawPolyline(line)

    def _height_of(self, decades):
        share = (MOST - min(max(decades, LEAST), MOST)) / (MOST - LEAST)
        return TOP + share * (self.height() - TOP - BOTTOM)
