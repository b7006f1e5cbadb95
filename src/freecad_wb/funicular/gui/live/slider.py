# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sliders for amounts, over ranges that a scene makes sensible, and the way back to what was there."""

import math

import FreeCAD

from funicular.gui.qt import QtCore, QtWidgets, translate

STEPS = 200

# Amounts that start at nothing: the least that the slider reaches to [unit], and in multiples of what it was
# when the panel came.
UP_TO = {
    "MemberWeight": (40.0, "kg/m"),
    "CoveringWeight": (120.0, "kg/m^2"),
    "Snow": (3000.0, "N/m^2"),
}
TIMES = 4.0

# Amounts that count in multiples: from and to, in multiples of a measure of the scene.
STIFFNESS = (1.0, 1e4)  # of all loads: what is softer hardly stands, what is stiffer hardly stretches
ACCURACY = (1e-7, 3e-3)  # of the size of the net
# Where neither the scene nor what they were says anything, in FreeCAD's own units: 1 kN to 100 MN, 1 µm to
# 1 cm.
WITHOUT_MEASURE = {"AxialStiffness": (1e6, 1e11), "Accuracy": (1e-3, 10.0)}

# Amounts that start at nothing, and reach to a part of all loads as they are first known.
PART_OF_LOAD = {"Force": 0.1}

WITH_SLIDERS = (*UP_TO, *PART_OF_LOAD, "AxialStiffness", "Accuracy")


class AmountSlider(QtWidgets.QSlider):
    """A slider for a quantity.

    Parameters
    ----------
    name : str
        The property, for the range of the amount.
    value : FreeCAD.Units.Quantity
        What it is as the panel comes.
    session : live.session.Session
        Knows the scene that makes a range sensible.
    on_change : callable(FreeCAD.Units.Quantity)
    """

    def __init__(self, name, value, session, on_change):
        super().__init__(QtCore.Qt.Horizontal)
        self.setObjectName(f"{name}Slider")
        self.setRange(0, STEPS)
        self.setMinimumWidth(48)
        self._name, self._session, self._on_change = name, session, on_change
        # What a script or an expression has made of it need be no amount.
        first = value.Value if math.isfinite(value.Value) and value.Value > 0.0 else 0.0
        self._unit, self._first, self._load = value.Unit, first, 0.0
        self.show_amount(value.Value)
        self.valueChanged.connect(self._changed)

    def show_amount(self, amount):
        """Stand where `amount` is, in FreeCAD's own unit, without taking it for an edit."""
        blocked = self.blockSignals(True)
        low, high = self._range()
        if not math.isfinite(amount):
            share = 0.0
        elif low == 0.0:
            share = amount / high
        else:
            share = math.log(max(amount, low) / low) / math.log(high / low)
        self.setValue(round(STEPS * min(max(share, 0.0), 1.0)))
        self.blockSignals(blocked)

    def _changed(self, step):
        low, high = self._range()
        share = step / STEPS
        amount = share * high if low == 0.0 else low * (high / low) ** share
        # Two digits: a slider says no more.
        amount = float(f"{amount:.3g}")
        self._on_change(FreeCAD.Units.Quantity(amount, self._unit))

    def _range(self):
        """(low, high) in FreeCAD's own unit."""
        if self._name in UP_TO:
            least, unit = UP_TO[self._name]
            return 0.0, max(FreeCAD.Units.Quantity(f"{least} {unit}").Value, TIMES * self._first)
        load, size = self._session.load_and_size
        if self._name in PART_OF_LOAD:
            # Once: what the slider sets is a load itself, and would move its own end.
            self._load = self._load or load
            return 0.0, max(1e3 * self._load * PART_OF_LOAD[self._name], TIMES * self._first) or 1.0
        low, high = (
            (1e3 * load * STIFFNESS[0], 1e3 * load * STIFFNESS[1])
            if self._name == "AxialStiffness"
            else (1e3 * size * ACCURACY[0], 1e3 * size * ACCURACY[1])
        )
        if not 0.0 < low < high:
            low, high = self._first / 100.0, self._first * 100.0
        if not 0.0 < low < high:
            low, high = WITHOUT_MEASURE[self._name]
        return min(low, self._first or low), max(high, self._first)


class ResetButton(QtWidgets.QToolButton):
    """Back to the value that a property had when the panel came; to be seen once it has another."""

    def __init__(self, name, text, reset):
        super().__init__()
        self.setObjectName(f"{name}Reset")
        self.setText("↺")
        self.setAutoRaise(True)
        self.setFixedWidth(14)
        self.setToolTip(translate("Back to {}").format(text))
        self.setAccessibleName(translate("Reset"))
        policy = self.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.setSizePolicy(policy)
        self.setVisible(False)
        self.clicked.connect(lambda: reset())
