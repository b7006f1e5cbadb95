# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the gridshell is seen: members or covering, source, ground and sun, exaggeration, and from where."""

import FreeCADGui
import numpy as np

from funicular.gui import legend
from funicular.gui.drawing.look import (
    LEAST_EXAGGERATION,
    MOST_EXAGGERATION,
    RECTANGULAR,
    ROUND,
    is_as_section,
)
from funicular.gui.drawing.reaction_arrows import reaction_points
from funicular.gui.drawing.shapes import MILLIMETRES
from funicular.gui.drawing.standpoint import STANDPOINTS, look_from
from funicular.gui.inputs import CheckBox, InputLabel, make_input, show_value
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from funicular.gui.texts import WrappedText
from funicular.wording import number

LABELS = {
    "Display": QT_TRANSLATE_NOOP("Funicular", "Display"),
    "BarWidth": QT_TRANSLATE_NOOP("Funicular", "Bar width"),
    "BarHeight": QT_TRANSLATE_NOOP("Funicular", "Bar height"),
    "ShowSource": QT_TRANSLATE_NOOP("Funicular", "Source, pale"),
    "ShowGround": QT_TRANSLATE_NOOP("Funicular", "Ground, shadow"),
    "SunAzimuth": QT_TRANSLATE_NOOP("Funicular", "Sun azimuth"),
    "SunAltitude": QT_TRANSLATE_NOOP("Funicular", "Sun altitude"),
    "Exaggeration": QT_TRANSLATE_NOOP("Funicular", "Exaggeration"),
}

# (from, to, steps for one) of the sliders.
SLIDERS = {
    "SunAzimuth": (0.0, 360.0, 1),
    "SunAltitude": (5.0, 90.0, 1),
    "Exaggeration": (LEAST_EXAGGERATION, MOST_EXAGGERATION, 2),
}


LIST_MARGIN = 24  # [px], for the bar that scrolls


class LookPart(QtWidgets.QWidget):
    """Inputs of the view properties of a gridshell: nothing is solved for them.

    Parameters
    ----------
    session : live.session.Session
    """

    def __init__(self, session):
        super().__init__()
        self._session, self._vobj = session, session.shell.ViewObject
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addLayout(self._standpoints())
        self._form = QtWidgets.QFormLayout()
        self._form.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
        self._form.setVerticalSpacing(1)
        column.addLayout(self._form)
        # Of each property its box, its slider if there is one, and the row that holds both.
        self._boxes, self._sliders, self._rows = {}, {}, {}
        for name in LABELS:
            self._add(name)
        self._as_section = WrappedText(translate("Bars are as large as the section below."))
        self._as_section.setObjectName("BarsAsSection")
        column.addWidget(self._as_section)
        self._said = QtWidgets.QLabel()
        self._said.setObjectName("ExaggerationSaid")
        self._said.setWordWrap(True)
        column.addWidget(self._said)
        # Undo, a script or FreeCAD's own editor may change them too.
        session.moved.connect(self.follow)
        self.follow()

    def _standpoints(self):
        row = QtWidgets.QHBoxLayout()
        row.setSpacing(2)
        for name, (_, _, words, picture) in STANDPOINTS.items():
            button = QtWidgets.QToolButton()
            button.setObjectName(f"Look{name}")
            button.setIcon(FreeCADGui.getIcon(picture))
            button.setIconSize(QtCore.QSize(24, 24))
            button.setFocusPolicy(QtCore.Qt.StrongFocus)
            button.setAccessibleName(translate(words))
            button.setToolTip(
                translate("Turn the view, and let it hold the whole net: {}").format(translate(words))
            )
            button.clicked.connect(lambda _=False, name=name: self._look_from(name))
            row.addWidget(button)
        row.addStretch(1)
        return row

    def _add(self, name):
        box = make_input(self._vobj, name, self._setter(name), lambda sentence: None)
        if isinstance(box, QtWidgets.QDoubleSpinBox):
            box.setRange(LEAST_EXAGGERATION, MOST_EXAGGERATION)
            box.setSingleStep(0.5)
            box.setPrefix("× ")
            show_value(box, self._vobj, name)
        elif isinstance(box, QtWidgets.QComboBox):
            # The list may be wider than the panel leaves room for.
            box.view().setMinimumWidth(box.view().sizeHintForColumn(0) + LIST_MARGIN)
        elif name in SLIDERS:
            box.setProperty("minimum", SLIDERS[name][0])
            box.setProperty("maximum", SLIDERS[name][1])
            show_value(box, self._vobj, name)
        self._boxes[name] = self._rows[name] = box
        if name in SLIDERS:
            self._rows[name] = QtWidgets.QWidget()
            line = QtWidgets.QVBoxLayout(self._rows[name])
            line.setContentsMargins(0, 0, 0, 0)
            line.setSpacing(0)
            line.addWidget(box)
            line.addWidget(self._slider(name, box.toolTip()))
        self._form.addRow(InputLabel(translate(LABELS[name]), box), self._rows[name])

    def _slider(self, name, tooltip):
        low, high, steps = SLIDERS[name]
        slider = self._sliders[name] = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        slider.setObjectName(f"{name}Slider")
        slider.setRange(round(low * steps), round(high * steps))
        slider.setPageStep(15 if name == "SunAzimuth" else 5)
        slider.setToolTip(tooltip)
        slider.valueChanged.connect(lambda step: self._set(name, step / steps))
        return slider

    def _setter(self, name):
        return lambda value: self._set(name, value)

    def _set(self, name, value):
        try:
            if getattr(self._vobj, name) != value:
                # The view provider is told of it, and asks the session to show the form again.
                setattr(self._vobj, name, value)
            self.follow()
        except ReferenceError:
            pass  # the gridshell is gone, and the panel ends

    def follow(self):
        """Show what the properties have become, unless it is just being typed."""
        for name, box in self._boxes.items():
            if not _is_typed_in(box):
                show_value(box, self._vobj, name)
        for name, slider in self._sliders.items():
            value = getattr(self._vobj, name)
            blocked = slider.blockSignals(True)
            slider.setValue(round(getattr(value, "Value", value) * SLIDERS[name][2]))
            slider.blockSignals(blocked)
        display = self._vobj.Display
        as_section = is_as_section(self._vobj)
        self._show_row("BarWidth", (ROUND in display or RECTANGULAR in display) and not as_section)
        self._show_row("BarHeight", RECTANGULAR in display and not as_section)
        self._as_section.setVisible(as_section)
        for name in ("SunAzimuth", "SunAltitude"):
            self._show_row(name, self._vobj.ShowGround)
        factor = self._boxes["Exaggeration"].value()
        self._said.setVisible(factor != 1.0)
        self._said.setText(
            translate("The way from the source is drawn {} times as long. Figures are the true ones.").format(
                number(factor, ".3g")
            )
        )

    def _show_row(self, name, shown):
        self._rows[name].setVisible(shown)
        self._form.labelForField(self._rows[name]).setVisible(shown)

    def _look_from(self, name):
        form = self._session.form
        active = FreeCADGui.activeDocument()
        view = active.ActiveView if active else None
        if form is None or not hasattr(view, "getCameraNode"):
            return
        matrix = np.array(self._session.shell.getGlobalPlacement().toMatrix().A).reshape(4, 4)
        points = form.drawn_nodes
        if self._vobj.ShowReactions:
            points = np.concatenate([points, reaction_points(form)])
        points = points * MILLIMETRES @ matrix[:3, :3].T + matrix[:3, 3]
        look_from(view, name, points, legend.room_in(view))


def _is_typed_in(box):
    """Whether a key may be on its way into a box: what it shows is then the user's."""
    if isinstance(box, (QtWidgets.QComboBox, CheckBox)):
        return False
    focus = QtWidgets.QApplication.focusWidget()
    return focus is not None and (focus is box or box.isAncestorOf(focus))
