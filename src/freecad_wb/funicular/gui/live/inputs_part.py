# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inputs of a gridshell and its net: properties, each with its box, and what it was when the panel came."""

from funicular.gui.inputs import InputLabel, counts, expression_of, make_input, show_value
from funicular.gui.live.slider import WITH_SLIDERS, AmountSlider, ResetButton
from funicular.gui.qt import QtWidgets, translate


class InputsPart(QtWidgets.QWidget):
    """A column of inputs.

    Parameters
    ----------
    session : live.session.Session
    rows : sequence of (object, property, label)
    unreadable : dict
        {property: sentence} of what was written and cannot be read, shared by all columns of a panel.
    on_edit : callable(is_typed)
        Called after each edit, readable or not. What was typed is for it to hand to session.change(), once
        the typing has ended; what was chosen has been.
    change : callable(), optional
        Called after a choice, and when an object has gone, instead of session.change(): for what is solved by
        nothing.
    """

    def __init__(self, session, rows, unreadable, on_edit, change=None):
        super().__init__()
        self._change = change or session.change
        self._session, self._unreadable, self._on_edit = session, unreadable, on_edit
        self.form = QtWidgets.QFormLayout(self)
        self.form.setContentsMargins(0, 0, 0, 0)
        self.form.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
        self.form.setVerticalSpacing(1)
        # (label, row, object, property) of all inputs; of each property what it was, and how it goes back.
        self._rows, self._first, self._resets, self._sliders, self._set = [], {}, {}, {}, {}
        # (widget, object, property) of the inputs that follow an expression.
        self._driven = []
        for obj, name, label in rows:
            # A number is typed digit by digit, and a step of 5 mm on the way to 500 would make a vast net.
            at_once = obj.getTypeIdOfProperty(name) in ("App::PropertyEnumeration", "App::PropertyBool")
            widget = make_input(obj, name, self._setter(obj, name, at_once), self._unread(name))
            row = self._row(widget, obj, name)
            label = InputLabel(translate(label), widget)
            self.form.addRow(label, row)
            self._rows.append((label, row, obj, name))
            if expression_of(obj, name):
                self._driven.append((widget, obj, name))
        self.show_what_counts()
        session.came.connect(self.follow_expressions)
        session.rested.connect(self._follow_scene)

    def leave(self):
        """Hold nothing of the panel: PySide keeps what FreeCAD's own boxes were connected to."""
        self._session, self._change, self._on_edit, self._unreadable, self._set = None, None, None, {}, {}
        self._rows, self._driven = [], []

    def set_value(self, name, value):
        """Set a property as if the user had, and show it."""
        self._set[name](value)

    def show_all(self):
        """Show what the properties have become by other hands."""
        for label, row, obj, name in self._rows:
            # With what could not be read goes that it could not.
            self._unreadable.pop(name, None)
            show_value(row.findChild(QtWidgets.QWidget, name), obj, name)
            self._follow(obj, name)
        self.show_what_counts()

    def row_of(self, name):
        """Number of the row of a property in the form."""
        row = next(row for _, row, _, each in self._rows if each == name)
        return self.form.getWidgetPosition(row)[0]

    def _row(self, widget, obj, name):
        """The box, its slider if it is an amount, and the way back."""
        row = QtWidgets.QWidget()
        line = QtWidgets.QGridLayout(row)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(0)
        line.setColumnStretch(0, 1)
        line.addWidget(widget, 0, 0)
        if expression_of(obj, name):
            return row
        value = getattr(obj, name)
        set_and_show = self._set[name] = self._shower(widget, obj, name)
        if name in WITH_SLIDERS:
            self._sliders[name] = AmountSlider(name, value, self._session, set_and_show)
            self._sliders[name].setToolTip(widget.toolTip())
            line.addWidget(self._sliders[name], 1, 0)
        text = getattr(widget, "text", lambda: str(value))() if name in WITH_SLIDERS else str(value)
        self._resets[name] = ResetButton(name, text or str(value), lambda: set_and_show(value))
        line.addWidget(self._resets[name], 0, 1)
        self._first[name] = value
        return row

    def _shower(self, widget, obj, name):
        """Sets a property and lets its box show it."""
        set_property = self._setter(obj, name, at_once=True)

        def set_and_show(value):
            set_property(value)
            show_value(widget, obj, name)

        return set_and_show

    def show_what_counts(self):
        """Hide the inputs that have no say as the others are."""
        try:
            for label, widget, obj, name in self._rows:
                for each in (label, widget):
                    each.setVisible(counts(obj, name))
        except ReferenceError:
            pass  # the object is gone, and what depends on it says so

    def follow_expressions(self):
        try:
            for widget, obj, name in self._driven:
                show_value(widget, obj, name)
        except ReferenceError:
            pass  # the object is gone, and what depends on it says so

    def _follow_scene(self):
        """Let sliders stand where the amounts are, in the ranges that the scene has now."""
        try:
            for _, _, obj, name in self._rows:
                self._follow(obj, name)
        except ReferenceError:
            pass  # the object is gone, and what depends on it says so

    def _setter(self, obj, name, at_once):
        def set_property(value):
            self._unreadable.pop(name, None)
            if self._session is None:
                return
            try:
                # A property that follows an expression is the expression's to set.
                if not expression_of(obj, name) and getattr(obj, name) != value:
                    setattr(obj, name, value)
                    if at_once:
                        self._change()
                self._follow(obj, name)
            except ReferenceError:
                # The object is gone, and what depended on it says so when it is solved.
                self._change()
            except (TypeError, ValueError) as error:
                self._unreadable[name] = f"{name}: {error}"
            self._on_edit(not at_once)

        return set_property

    def _follow(self, obj, name):
        """Let slider and way back show what a property has become."""
        if name in self._sliders and not self._sliders[name].isSliderDown():
            self._sliders[name].show_amount(getattr(obj, name).Value)
        if name in self._resets:
            self._resets[name].setVisible(getattr(obj, name) != self._first[name])

    def _unread(self, name):
        def keep(sentence):
            self._unreadable[name] = sentence
            if self._on_edit is not None:
                self._on_edit(True)

        return keep
