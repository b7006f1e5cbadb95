# SPDX-License-Identifier: LGPL-2.1-or-later
"""One input widget per property: it shows the property, and hands on what a user enters as a value for it.

Labels are written here; tooltips are the properties' own documentation.
"""

import FreeCAD
import FreeCADGui

from funicular.gui.pattern_icons import pattern_icon
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtGui, QtWidgets, translate
from funicular.gui.input_units import amount_in, as_parsed, fitting, unit_of
from funicular.wording import number

# (heading, ((owner, property, label), …)), in the order of the panel and of the Tab key.
SECTIONS = (
    (
        QT_TRANSLATE_NOOP("Funicular", "Net"),
        (
            ("Sheet", "Width", QT_TRANSLATE_NOOP("Funicular", "Width")),
            ("Sheet", "Depth", QT_TRANSLATE_NOOP("Funicular", "Depth")),
            ("File", "File", QT_TRANSLATE_NOOP("Funicular", "Mesh file")),
            ("File", "FileUnit", QT_TRANSLATE_NOOP("Funicular", "Its unit")),
            ("File", "Resampled", QT_TRANSLATE_NOOP("Funicular", "Lay the pattern")),
            ("Mesh", "Weld", QT_TRANSLATE_NOOP("Funicular", "Weld within")),
            ("Edges", "Chord", QT_TRANSLATE_NOOP("Funicular", "Divide curves")),
            ("Net", "Pattern", QT_TRANSLATE_NOOP("Funicular", "Pattern")),
            ("Net", "Laying", QT_TRANSLATE_NOOP("Funicular", "Laid")),
            ("Net", "StepU", QT_TRANSLATE_NOOP("Funicular", "Step along u")),
            ("Net", "StepV", QT_TRANSLATE_NOOP("Funicular", "Step along v")),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Funicular", "More of the net"),
        (
            ("Net", "CountU", QT_TRANSLATE_NOOP("Funicular", "Cells along u")),
            ("Net", "CountV", QT_TRANSLATE_NOOP("Funicular", "Cells along v")),
            ("Net", "SwapUV", QT_TRANSLATE_NOOP("Funicular", "Turned")),
            ("Net", "Angle", QT_TRANSLATE_NOOP("Funicular", "Angle")),
            ("Net", "OffsetU", QT_TRANSLATE_NOOP("Funicular", "Shift along u")),
            ("Net", "OffsetV", QT_TRANSLATE_NOOP("Funicular", "Shift along v")),
            ("Net", "Spacing", QT_TRANSLATE_NOOP("Funicular", "Equal in")),
            ("Net", "Start", QT_TRANSLATE_NOOP("Funicular", "Start (u, v)")),
            ("Net", "Crossing", QT_TRANSLATE_NOOP("Funicular", "Crossing")),
            ("Net", "MostShear", QT_TRANSLATE_NOOP("Funicular", "Most shear")),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Funicular", "Weights"),
        (
            ("Gridshell", "MemberWeight", QT_TRANSLATE_NOOP("Funicular", "Members")),
            ("Gridshell", "CoveringWeight", QT_TRANSLATE_NOOP("Funicular", "Covering")),
            ("Gridshell", "CoveringShare", QT_TRANSLATE_NOOP("Funicular", "Shared by")),
            ("Gridshell", "Snow", QT_TRANSLATE_NOOP("Funicular", "Snow")),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Funicular", "Members"),
        (
            ("Gridshell", "AxialStiffness", QT_TRANSLATE_NOOP("Funicular", "Stiffness EA")),
            ("Gridshell", "AllowTension", QT_TRANSLATE_NOOP("Funicular", "Allow tension")),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Funicular", "Solution"),
        (
            ("Gridshell", "Accuracy", QT_TRANSLATE_NOOP("Funicular", "Accuracy")),
            ("Gridshell", "Method", QT_TRANSLATE_NOOP("Funicular", "Method")),
            ("Gridshell", "LengthMatching", QT_TRANSLATE_NOOP("Funicular", "Length matching")),
        ),
    ),
)

# Inputs that say nothing unless another property of their object has one of the values given.
ONLY_WHERE = {name: ("Laying", "Equal lengths") for name in ("Start", "Crossing", "MostShear")}
ONLY_WHERE |= {
    name: ("SectionShape", "Round", "Rectangular")
    for name in ("SectionWidth", "CompressiveStrength", "YoungsModulus")
}
ONLY_WHERE["SectionHeight"] = ("SectionShape", "Rectangular")
ONLY_WHERE |= {
    name: ("Laying", "Along isolines")
    for name in ("Pattern", "StepV", "CountU", "CountV", "SwapUV", "OffsetU", "OffsetV", "Spacing")
}


def counts(obj, name):
    """Whether property `name` of `obj` has a say, as its others now are."""
    other, *values = ONLY_WHERE.get(name, (None,))
    return other is None or getattr(obj, other) in values


def expression_of(obj, name):
    """The expression that property `name` of `obj` follows, "" without one."""
    # View providers have none.
    engine = getattr(obj, "ExpressionEngine", ())
    return next((text for path, text in engine if path.lstrip(".") == name), "")


def make_input(obj, name, on_change, on_error):
    """The widget for property `name` of `obj`.

    Parameters
    ----------
    on_change : callable(value)
        Called with a value that can be assigned to the property, each time the user changes it.
    on_error : callable(sentence)
        Called when what the user wrote cannot be read.
    """
    kind = obj.getTypeIdOfProperty(name)
    if kind == "App::PropertyEnumeration":
        widget = _choice(obj, name, on_change)
    elif kind == "App::PropertyBool":
        widget = _check(obj, name, on_change)
    elif kind.startswith("App::PropertyInteger"):
        widget = _count(obj, name, on_change)
    elif kind == "App::PropertyFloat":
        widget = _number(obj, name, on_change)
    elif kind == "App::PropertyVector":
        widget = PlaceField(on_change)
    elif kind == "App::PropertyFile":
        widget = _path(obj, name, on_change)
    elif unit_of(name, getattr(obj, name)):
        widget = QuantityField(unit_of(name, getattr(obj, name)), on_change, on_error)
    else:
        widget = _quantity(obj, name, on_change, on_error)
    widget.setObjectName(name)
    show_value(widget, obj, name)
    if kind != "App::PropertyBool":
        # As narrow as it must be beside the longest label, in a panel of the width that FreeCAD gives it.
        widget.setMinimumWidth(92)
    documentation = translate(obj.getDocumentationOfProperty(name), "App::Property")
    expression = expression_of(obj, name)
    if expression:
        documentation += "\n" + translate("Follows the expression {}").format(expression)
        _make_read_only(widget)
    widget.setToolTip(documentation)
    widget.setStatusTip(documentation)
    widget.setWhatsThis(documentation)
    return widget


class InputLabel(QtWidgets.QLabel):
    """What stands beside an input: it explains it, leads the keyboard there, and a click ticks a box."""

    def __init__(self, text, box):
        super().__init__(text)
        self._box = box
        self.setBuddy(box)
        self.setToolTip(box.toolTip())

    def mousePressEvent(self, event):
        if isinstance(self._box, CheckBox) and event.button() == QtCore.Qt.LeftButton:
            self._box.click()
        else:
            super().mousePressEvent(event)


def show_value(widget, obj, name):
    """Let a widget of make_input() show what the property has become, without taking it for an edit."""
    value = getattr(obj, name)
    blocked = widget.blockSignals(True)
    if isinstance(widget, QtWidgets.QComboBox):
        widget.setCurrentIndex(widget.findData(value))
    elif isinstance(widget, QtWidgets.QCheckBox):
        widget.setChecked(value)
    elif isinstance(widget, (QtWidgets.QSpinBox, QtWidgets.QDoubleSpinBox)):
        widget.setValue(value)
    elif isinstance(widget, QuantityField):
        widget.show_quantity(value)
    elif isinstance(widget, PlaceField):
        widget.show_place(value)
    elif obj.getTypeIdOfProperty(name) == "App::PropertyFile":
        widget.setProperty("fileName", value)
    else:
        widget.setProperty("rawValue", value.Value)
    widget.blockSignals(blocked)


def _make_read_only(widget):
    if hasattr(widget, "setReadOnly"):
        widget.setReadOnly(True)
    else:
        widget.setEnabled(False)


def _choice(obj, name, on_change):
    widget = QtWidgets.QComboBox()
    choices = obj.getEnumerationsOfProperty(name)
    if name == "Pattern":
        widget.setIconSize(QtCore.QSize(24, 24))
    for choice in choices:
        picture = pattern_icon(choice) if name == "Pattern" else QtGui.QIcon()
        widget.addItem(picture, translate(choice), choice)
    widget.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    widget.setMinimumContentsLength(8)
    widget.currentIndexChanged.connect(lambda index: on_change(choices[index]))
    return widget


def _check(obj, name, on_change):
    widget = CheckBox()
    widget.toggled.connect(on_change)
    return widget


def _count(obj, name, on_change):
    widget = QtWidgets.QSpinBox()
    widget.setRange(0, 1000)
    widget.setSpecialValueText(translate("by step") if name.startswith("Count") else translate("off"))
    widget.valueChanged.connect(on_change)
    return widget


def _number(obj, name, on_change):
    widget = QtWidgets.QDoubleSpinBox()
    widget.setRange(-1.0, 1.0)
    widget.setSingleStep(0.1)
    widget.valueChanged.connect(on_change)
    return widget


def _path(obj, name, on_change):
    """FreeCAD's own chooser: a line and a button."""
    widget = FreeCADGui.UiLoader().createWidget("Gui::FileChooser")
    QtCore.QObject.connect(widget, QtCore.SIGNAL("fileNameSelected(QString)"), on_change)
    return widget


def _quantity(obj, name, on_change, on_error):
    """FreeCAD's own box: any unit, the user's unit schema, and the f(x) button for expressions."""
    widget = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
    quantity = getattr(obj, name)
    widget.setProperty("unit", quantity.getUserPreferred()[2])
    if hasattr(obj, "ExpressionEngine"):
        FreeCADGui.ExpressionBinding(widget).bind(obj, name)

    def changed(value):
        if value < 0.0 and obj.getTypeIdOfProperty(name) == "App::PropertyLength":
            # The property would take it for nothing.
            on_error(translate("“{}” is negative: give more than zero.").format(widget.property("text")))
            return
        on_change(FreeCAD.Units.Quantity(value, quantity.Unit))

    def edited(text):
        # The box tells of good values only, and not of one that it has already.
        if widget.property("acceptableInput"):
            changed(widget.property("rawValue"))
        else:
            on_error(_unreadable(text, quantity.getUserPreferred()[2]))

    QtCore.QObject.connect(widget, QtCore.SIGNAL("valueChanged(double)"), changed)
    widget.findChild(QtWidgets.QLineEdit).textEdited.connect(edited)
    return widget


def _unreadable(text, unit):
    return translate("“{}” is not a value in {}. Write for example “12 {}”.").format(text, unit, unit)


class CheckBox(QtWidgets.QCheckBox):
    """A check box that keeps the space bar, which in FreeCAD hides and shows what is selected."""

    def event(self, event):
        if event.type() == QtCore.QEvent.ShortcutOverride and event.key() == QtCore.Qt.Key_Space:
            event.accept()
            return True
        return super().event(event)


class PlaceField(QtWidgets.QWidget):
    """A place (u, v) of a face, in shares of its length: two boxes beside each other."""

    def __init__(self, on_change):
        super().__init__()
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2)
        self._boxes = []
        for _ in "uv":
            box = QtWidgets.QDoubleSpinBox()
            box.setRange(0.0, 1.0)
            box.setSingleStep(0.05)
            box.valueChanged.connect(lambda _: on_change(self._place()))
            row.addWidget(box)
            self._boxes.append(box)
        self.setFocusProxy(self._boxes[0])

    def _place(self):
        return FreeCAD.Vector(*(box.value() for box in self._boxes), 0.0)

    def show_place(self, place):
        for box, share in zip(self._boxes, (place.x, place.y)):
            blocked = box.blockSignals(True)
            box.setValue(share)
            box.blockSignals(blocked)


class QuantityField(QtWidgets.QLineEdit):
    """A quantity written in `unit`; other units of the same kind are understood too."""

    def __init__(self, unit, on_change, on_error):
        super().__init__()
        self._unit = unit
        self._dimension = FreeCAD.Units.Quantity(as_parsed(f"1 {unit}")).Unit
        self._on_change, self._on_error = on_change, on_error
        self.textEdited.connect(self._read)
        self.editingFinished.connect(self._complete)

    def show_quantity(self, quantity):
        unit = fitting(self._unit, quantity)
        self.setText(f"{number(amount_in(quantity, unit), '.6g')} {unit}")

    def _quantity(self):
        """What is written, or None if it is no quantity of this kind. A bare number has the unit shown."""
        text = as_parsed(self.text().strip())
        for candidate in (text, f"({text}) {as_parsed(self._unit)}"):
            try:
                quantity = FreeCAD.Units.Quantity(candidate)
            except (ValueError, ArithmeticError, FreeCAD.Base.FreeCADError):
                continue
            if text and quantity.Unit == self._dimension:
                return quantity
        return None

    def _read(self):
        quantity = self._quantity()
        if quantity is None:
            self._on_error(_unreadable(self.text(), self._unit))
        else:
            self._on_change(quantity)

    def _complete(self):
        quantity = self._quantity()
        if quantity is not None:
            self.show_quantity(quantity)
