# SPDX-License-Identifier: LGPL-2.1-or-later
"""What colours stand for, in which range; the section that stress is of; reactions as arrows."""

import numpy as np

from funicular.gui.colouring import FROM, RANGES, TO, limits_of, section_or_fault, set_limits
from funicular.gui.inputs import CheckBox, InputLabel, make_input, show_value
from funicular.gui.live.inputs_part import InputsPart
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from funicular.gui.texts import DOUBTFUL, WrappedText
from funicular.gui.units import in_words
from funicular.quantities import QUANTITIES

# The legend is painted anew at most this often, and so is what is told in words.
PAUSE_MS = 250

LABELS = {
    "Colours": QT_TRANSLATE_NOOP("Funicular", "Colour by"),
    "ShowLegend": QT_TRANSLATE_NOOP("Funicular", "Legend"),
    "FixedRange": QT_TRANSLATE_NOOP("Funicular", "Fixed range"),
    FROM: QT_TRANSLATE_NOOP("Funicular", "from"),
    TO: QT_TRANSLATE_NOOP("Funicular", "to"),
    "ShowReactions": QT_TRANSLATE_NOOP("Funicular", "Reactions"),
}
SECTION = (
    ("SectionShape", QT_TRANSLATE_NOOP("Funicular", "Section")),
    ("SectionWidth", QT_TRANSLATE_NOOP("Funicular", "Width")),
    ("SectionHeight", QT_TRANSLATE_NOOP("Funicular", "Height")),
    ("CompressiveStrength", QT_TRANSLATE_NOOP("Funicular", "Strength")),
    ("YoungsModulus", QT_TRANSLATE_NOOP("Funicular", "Young's modulus")),
)


class ColoursPart(QtWidgets.QWidget):
    """Inputs of view properties and of the section: nothing is solved for them.

    Parameters
    ----------
    session : live.session.Session
    unreadable : dict
        As for InputsPart.
    """

    def __init__(self, session, unreadable):
        super().__init__()
        self._session, self._vobj, self._unreadable = session, session.shell.ViewObject, unreadable
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        self._form = QtWidgets.QFormLayout()
        self._form.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
        self._form.setVerticalSpacing(1)
        column.addLayout(self._form)
        self._boxes, self._labels = {}, {}
        for name in ("Colours", "ShowLegend", "FixedRange"):
            self._add(name, LABELS[name])
        for name in RANGES:
            for end in (FROM, TO):
                self._add(name + end, LABELS[end])
        self._says = WrappedText()
        self._says.setObjectName("ColoursSay")
        self._says.set_colour(DOUBTFUL)
        self._form.addRow(self._says)
        rows = [(session.shell, name, label) for name, label in SECTION]
        self.section = InputsPart(session, rows, unreadable, self._section_edited, self._section_edited)
        column.addWidget(self.section)
        below = QtWidgets.QFormLayout()
        below.setVerticalSpacing(1)
        column.addLayout(below)
        self._add("ShowReactions", LABELS["ShowReactions"], below)
        self._reactions = WrappedText()
        self._reactions.setObjectName("LargestReaction")
        below.addRow(self._reactions)
        self._pause = QtCore.QTimer(self)
        self._pause.setSingleShot(True)
        self._pause.setInterval(PAUSE_MS)
        self._pause.timeout.connect(self._catch_up)
        # A script or FreeCAD's own editor may change the properties too, and then the form is shown again.
        session.moved.connect(self._moved)
        self._shown = None
        self._show_properties()

    def leave(self):
        """Hold nothing of the panel: PySide keeps what FreeCAD's own boxes were connected to."""
        self._pause.stop()
        self.section.leave()
        self._session, self._unreadable, self._boxes, self._labels = None, {}, {}, {}

    # As all columns of inputs

    def show_all(self):
        self._show_properties()

    def show_what_counts(self):
        self.section.show_what_counts()

    # The form

    def _add(self, name, label, form=None):
        form = form or self._form
        box = make_input(self._vobj, name, lambda value: self._set(name, value), self._unread(name))
        if isinstance(box, QtWidgets.QDoubleSpinBox):
            blocked = box.blockSignals(True)
            box.setRange(0.0, 1e4)
            box.setSingleStep(10.0)
            box.setDecimals(0)
            box.setSuffix(" %")
            box.blockSignals(blocked)
        self._boxes[name] = box
        self._labels[name] = InputLabel(translate(label), box)
        form.addRow(self._labels[name], box)

    def _set(self, name, value):
        self._unreadable.pop(name, None)
        try:
            if getattr(self._vobj, name) != value:
                # The view provider is told of it, and has the session show the form again.
                setattr(self._vobj, name, value)
            self._begin_range()
            self._show_properties()
        except ReferenceError:
            pass  # the gridshell is gone, and the panel ends
        except (TypeError, ValueError) as error:
            self._unreadable[name] = f"{name}: {error}"
            self._tell()

    def _unread(self, name):
        def keep(sentence):
            self._unreadable[name] = sentence
            self._tell()

        return keep

    def _section_edited(self, is_typed=True):
        self.section.show_what_counts()
        self._tell()

    def _begin_range(self):
        """A range that is to be fixed, and is none yet, is that of the members."""
        quantity, coloured = QUANTITIES.get(self._vobj.Colours), self._vobj.Proxy.coloured
        if not self._vobj.FixedRange or quantity is None or quantity.name not in RANGES:
            return
        if limits_of(self._vobj, quantity) is None and coloured is not None and coloured.scale is not None:
            set_limits(self._vobj, quantity, coloured.scale.low, coloured.scale.high)

    # What is shown

    def _moved(self):
        if not self._pause.isActive():
            self._pause.start()

    def _catch_up(self):
        """Some time after the form has moved."""
        try:
            if self._values() != self._shown:
                self._show_properties()
            else:
                self._tell()
        except ReferenceError:
            pass  # the gridshell is gone, and the panel ends

    def _values(self):
        shell = self._session.shell
        return [
            *(getattr(self._vobj, name) for name in self._boxes),
            *(getattr(shell, name) for name, _ in SECTION),
        ]

    def _show_properties(self):
        """Show what the properties are, unless one is just being typed."""
        for name, box in self._boxes.items():
            if isinstance(box, (QtWidgets.QComboBox, CheckBox)) or not _is_typed_in(box):
                show_value(box, self._vobj, name)
        if not _is_typed_in(self.section):
            self.section.show_all()
        self._shown = self._values()
        colours, is_fixed = self._vobj.Colours, self._vobj.FixedRange
        self._show_row("FixedRange", colours in RANGES)
        self._show_row("ShowLegend", colours in QUANTITIES)
        for name in RANGES:
            for end in (FROM, TO):
                self._show_row(name + end, is_fixed and name == colours)
        self._tell()

    def _show_row(self, name, shown):
        self._boxes[name].setVisible(shown)
        self._labels[name].setVisible(shown)

    def _tell(self):
        """Legend and words, as what is shown has become."""
        try:
            vobj = self._vobj
            if self._session.form is not None:
                vobj.Proxy.refresh_legend(vobj)
            self._say(self._doubt())
            self._reactions.setVisible(vobj.ShowReactions)
            if vobj.ShowReactions:
                self._reactions.setText(self._largest_reaction())
        except ReferenceError:
            pass  # the gridshell is gone, and the panel ends

    def _doubt(self):
        """What is wrong with an input of this part, or missing for the colours that are chosen."""
        of_section = [name for name, _ in SECTION]
        for name, sentence in self._unreadable.items():
            if name in self._boxes or name in of_section:
                return sentence
        wrong = section_or_fault(self._session.shell)[1]
        coloured = self._vobj.Proxy.coloured
        return wrong or (coloured.missing if coloured is not None else "")

    def _say(self, sentence):
        self._says.setVisible(bool(sentence))
        self._says.setText(f"{DOUBTFUL[0]} {sentence}" if sentence else "")

    def _largest_reaction(self):
        form = self._session.form
        sizes = np.linalg.norm(form.reactions, axis=1) if form is not None else np.zeros(0)
        if not sizes.max(initial=0.0) > 0.0:
            return translate("There are no reactions yet.")
        return translate("The longest arrow is {}, at node {}.").format(
            in_words(float(sizes.max()), "N"), int(sizes.argmax())
        )


def _is_typed_in(box):
    """Whether a key may be on its way into a box: what it shows is then the user's."""
    focus = QtWidgets.QApplication.focusWidget()
    return focus is not None and (focus is box or box.isAncestorOf(focus))
