# SPDX-License-Identifier: LGPL-2.1-or-later
"""How stiff supports are: a slider from free to rigid, and a box for the number."""

import math

import FreeCAD

from funicular.gui import preferences
from funicular.gui.inputs import QuantityField
from funicular.gui.qt import QtCore, QtWidgets, translate
from funicular.wording import number

STEPS = 200
RIGID, NONE = math.inf, 0.0
# From what yields by a millimetre under a mean nodal load, in multiples of that.
MOST = 1e4
PER_MM = 1e3  # [1/m]
DIGITS = 3


def unit():
    """The unit in which the user reads stiffnesses; FreeCAD's schemas have none."""
    return "lbf/in" if preferences.is_imperial() else "kN/mm"


def stiffness_in_words(stiffness):
    """stiffness: [N/m], RIGID or NONE."""
    if stiffness == RIGID:
        return translate("rigid")
    if stiffness == NONE:
        return translate("free")
    return f"{number(_amount(stiffness), f'.{DIGITS}g')} {unit()}"


def _amount(stiffness):
    return float(FreeCAD.Units.Quantity(f"{stiffness!r} N/m").getValueAs(unit()))


class StiffnessRow(QtWidgets.QWidget):
    """on_change: callable(stiffness [N/m], RIGID or NONE). on_end: callable(), the slider was let go.
    on_error: callable(sentence)."""

    def __init__(self, on_change, on_end, on_error):
        super().__init__()
        self._on_change, self._low = on_change, 1e5
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("SupportStiffnessSlider")
        self.slider.setRange(0, STEPS)
        self.slider.setMinimumWidth(36)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderReleased.connect(on_end)
        self.box = QuantityField(unit(), self._written, on_error)
        self.box.setObjectName("SupportStiffness")
        self.box.setMinimumWidth(76)
        what = translate("How stiff the chosen supports are: at the right end rigid, at the left end free")
        for widget in (self.slider, self.box):
            widget.setToolTip(what)
        self.box.editingFinished.connect(on_end)
        for words, widget in (
            (translate("Free"), None),
            ("", self.slider),
            (translate("Rigid"), None),
            ("", self.box),
        ):
            row.addWidget(widget or QtWidgets.QLabel(words), 1 if widget else 0)

    def set_mean_load(self, newtons):
        """Take the range from the mean load of a node [N]."""
        if newtons > 0.0:
            self._low = newtons * PER_MM

    def show_stiffness(self, stiffness):
        """Stand at a stiffness, without taking it for an edit; None where nothing is chosen."""
        self.setEnabled(stiffness is not None)
        blocked = self.slider.blockSignals(True)
        if not self.slider.isSliderDown():
            self.slider.setValue(self._place(RIGID if stiffness is None else stiffness))
        self.slider.blockSignals(blocked)
        if self.box.hasFocus():
            return
        if stiffness in (None, RIGID, NONE):
            self.box.setText("")
            self.box.setPlaceholderText("" if stiffness is None else stiffness_in_words(stiffness))
        else:
            self.box.setText(stiffness_in_words(stiffness))

    def _place(self, stiffness):
        if stiffness in (RIGID, NONE):
            return STEPS if stiffness == RIGID else 0
        share = math.log(stiffness / self._low) / math.log(MOST)
        return 1 + round((STEPS - 2) * min(max(share, 0.0), 1.0))

    def _slid(self, place):
        if place in (0, STEPS):
            self._on_change(RIGID if place else NONE)
        else:
            stiffness = self._low * MOST ** ((place - 1) / (STEPS - 2))
            self._on_change(float(f"{stiffness:.{DIGITS}g}"))

    def _written(self, quantity):
        self._on_change(float(quantity.getValueAs("N/m")) or RIGID)
