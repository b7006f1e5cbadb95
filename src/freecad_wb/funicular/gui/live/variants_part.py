# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alternatives: keep what is there, flick between what was kept, compare two in numbers, take one again."""

from funicular.features.variants import (
    keep_variant,
    remove_variant,
    rename_variant,
    restore_variant,
    variants_of,
)
from funicular.form import numbers_of, other_form
from funicular.gui.lengths import length_in_words
from funicular.gui.live.buttons import push_button
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtGui, QtWidgets, translate
from funicular.gui.texts import WrappedText
from funicular.wording import force_text

THUMBNAIL = (128, 96)

# (number, short label, what it is, words)
ROWS = (
    ("rise", QT_TRANSLATE_NOOP("Funicular", "Rise"), "", length_in_words),
    ("weight", QT_TRANSLATE_NOOP("Funicular", "Weight"), "", force_text),
    (
        "longest_member",
        QT_TRANSLATE_NOOP("Funicular", "Longest"),
        QT_TRANSLATE_NOOP("Funicular", "Length of the longest member"),
        length_in_words,
    ),
    (
        "most_compression",
        QT_TRANSLATE_NOOP("Funicular", "Force −"),
        QT_TRANSLATE_NOOP("Funicular", "Largest compression in a member"),
        force_text,
    ),
    (
        "most_tension",
        QT_TRANSLATE_NOOP("Funicular", "Force +"),
        QT_TRANSLATE_NOOP("Funicular", "Largest tension in a member"),
        force_text,
    ),
    (
        "mean_deviation",
        QT_TRANSLATE_NOOP("Funicular", "Off, mean"),
        QT_TRANSLATE_NOOP("Funicular", "How far the nodes are from where they were laid, on the average"),
        length_in_words,
    ),
    (
        "most_deviation",
        QT_TRANSLATE_NOOP("Funicular", "Off, most"),
        QT_TRANSLATE_NOOP("Funicular", "How far the farthest node is from where it was laid"),
        length_in_words,
    ),
)
ONLY = QT_TRANSLATE_NOOP("Funicular", "Pure")
ONLY_TIP = QT_TRANSLATE_NOOP("Funicular", "Whether it stands in compression only")


class VariantsPart(QtWidgets.QWidget):
    """A strip of pictures with names, buttons, and a table of numbers.

    Parameters
    ----------
    session : live.session.Session
    thumbnail : callable(width, height) -> bytes
        A PNG picture of the form that is shown.
    on_look : callable(name)
        Called when an alternative is shown in place of the present form; with "" when that is shown again.
    after_restore : callable()
        Called after properties have been set, for boxes that show them.
    """

    def __init__(self, session, thumbnail, on_look, after_restore):
        super().__init__()
        self._session, self._thumbnail, self._after_restore = session, thumbnail, after_restore
        self._on_look, self._looked_at = on_look, ""
        # The fn.Scene of the present form when an alternative was chosen beside it.
        self._scene = None
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        buttons = QtWidgets.QHBoxLayout()
        column.addLayout(buttons)
        for name, words, tip, pressed in (
            ("KeepThis", translate("Keep this"), translate("Keep this form under a name"), self._keep),
            (
                "RestoreVariant",
                translate("Restore"),
                translate("Go on from the inputs of the chosen alternative"),
                self._restore,
            ),
            (
                "DeleteVariant",
                translate("Delete"),
                translate("Forget the chosen alternative"),
                self._delete,
            ),
        ):
            buttons.addWidget(push_button(name, words, tip, pressed))
        self.strip = QtWidgets.QListWidget()
        self.strip.setObjectName("Variants")
        self.strip.setViewMode(QtWidgets.QListView.IconMode)
        self.strip.setFlow(QtWidgets.QListView.LeftToRight)
        self.strip.setWrapping(False)
        self.strip.setMovement(QtWidgets.QListView.Static)
        self.strip.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.strip.setIconSize(QtCore.QSize(96, 72))
        self.strip.setFixedHeight(112)
        self.strip.setToolTip(
            translate(
                "Choose one to see it, two (with Ctrl) to compare them; F2 renames. Without a choice the "
                "present form is shown."
            )
        )
        self.strip.itemSelectionChanged.connect(self._chosen)
        self.strip.itemChanged.connect(self._renamed)
        column.addWidget(self.strip)
        self.table = QtWidgets.QTableWidget(len(ROWS) + 1, 3)
        self.table.setObjectName("VariantNumbers")
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.setFocusPolicy(QtCore.Qt.TabFocus)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        self.table.verticalHeader().setDefaultSectionSize(20)
        small = QtGui.QFont(self.table.font())
        small.setPixelSize(10)
        for each in (self.table, self.table.horizontalHeader(), self.table.verticalHeader()):
            each.setFont(small)
        for row, (label, tip) in enumerate([*((row[1], row[2] or row[1]) for row in ROWS), (ONLY, ONLY_TIP)]):
            item = QtWidgets.QTableWidgetItem(translate(label))
            item.setToolTip(translate(tip))
            self.table.setVerticalHeaderItem(row, item)
        self.table.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.table.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        column.addWidget(self.table)
        self.says = WrappedText("")
        self.says.setObjectName("VariantSays")
        column.addWidget(self.says)
        self._list()
        session.came.connect(self._came)
        session.rested.connect(self._compare)

    def look_away(self):
        """Choose nothing, which shows the present form again: whether something was chosen."""
        is_chosen = bool(self.strip.selectedItems())
        self.strip.clearSelection()
        return is_chosen

    # What the buttons do

    def _keep(self):
        session = self._session
        if not session.is_result:
            self.says.setText(translate("Wait until the form has settled, then keep it."))
            return
        self.strip.clearSelection()
        names = [variant.name for variant in variants_of(session.shell)]
        number = next(n for n in range(1, len(names) + 2) if translate("Variant {}").format(n) not in names)
        keep_variant(
            session.shell,
            translate("Variant {}").format(number),
            session.form,
            session.moment.certificate.compression_only,
            self._thumbnail(*THUMBNAIL),
        )
        self._session.is_changed = True
        self._list()
        self.says.setText("")

    def _restore(self):
        chosen = self._selected()
        if len(chosen) != 1:
            self.says.setText(translate("Choose one alternative, then restore it."))
            return
        remarks = restore_variant(self._session.shell, chosen[0].name)
        self.strip.clearSelection()
        self._after_restore()
        self._session.change()
        self.says.setText(". ".join(remarks))

    def _delete(self):
        for variant in self._selected():
            remove_variant(self._session.shell, variant.name)
            self._session.is_changed = True
        self._list()

    def _renamed(self, item):
        before = item.data(QtCore.Qt.UserRole)
        if item.text() == before:
            return
        try:
            rename_variant(self._session.shell, before, item.text())
            self._session.is_changed = True
            self.says.setText("")
        except ValueError as error:
            self.says.setText(str(error))
        self._list()

    # What is seen

    def _list(self):
        blocked = self.strip.blockSignals(True)
        self.strip.clear()
        for variant in variants_of(self._session.shell):
            picture = QtGui.QPixmap()
            picture.loadFromData(QtCore.QByteArray(variant.thumbnail))
            item = QtWidgets.QListWidgetItem(QtGui.QIcon(picture), variant.name)
            item.setData(QtCore.Qt.UserRole, variant.name)
            item.setFlags(item.flags() | QtCore.Qt.ItemIsEditable)
            self.strip.addItem(item)
        self.strip.blockSignals(blocked)
        self._chosen()

    def _selected(self):
        names = {item.data(QtCore.Qt.UserRole) for item in self.strip.selectedItems()}
        return [variant for variant in variants_of(self._session.shell) if variant.name in names]

    def _came(self):
        """The present form has changed, and is what is shown again."""
        if self._session.moment.scene is not self._scene and len(self.strip.selectedItems()) == 1:
            self.strip.clearSelection()

    def _chosen(self):
        chosen, moment = self._selected(), self._session.moment
        self._scene = None if moment is None else moment.scene
        self._show(chosen[-1] if len(chosen) == 1 else None)
        self._compare()

    def _compare(self):
        """Fill the table with the numbers of what is chosen."""
        chosen = self._selected()
        form = self._session.own_form
        if len(chosen) == 1 and form is not None and self._session.moment.certificate is not None:
            present = {
                **numbers_of(form),
                "compression_only": self._session.moment.certificate.compression_only,
            }
            self._fill((chosen[0].name, chosen[0].numbers), (translate("present"), present))
        else:
            self._fill(*((variant.name, variant.numbers) for variant in chosen[:2]))

    def _show(self, variant):
        """See a variant in place of the present form, where its nodes are those of the same net."""
        form, name = self._session.own_form, ""
        self.says.setText("")
        if variant is None or form is None:
            self._session.look_at(None)
        elif len(variant.nodes) == len(form.nodes):
            self._session.look_at(other_form(form, variant.nodes, variant.member_forces, variant.reactions))
            name = variant.name
        else:
            self._session.look_at(None)
            self.says.setText(translate("{} has another net: restore it to see it.").format(variant.name))
        if name != self._looked_at:
            self._looked_at = name
            self._on_look(name)

    def _fill(self, *columns):
        self.table.setVisible(bool(columns))
        names = [name for name, _ in columns]
        both = len(columns) == 2
        self.table.setColumnCount(3 if both else 1)
        self.table.setHorizontalHeaderLabels(names + ([translate("change")] if both else []))
        for row, (key, _, _, in_words) in enumerate(ROWS):
            values = [numbers[key] for _, numbers in columns]
            texts = [in_words(value) for value in values]
            if both:
                difference = values[1] - values[0]
                texts.append(("−" if difference < 0 else "+") + in_words(abs(difference)))
            self._write(row, texts)
        only = [
            translate("yes") if numbers["compression_only"] else translate("no") for _, numbers in columns
        ]
        self._write(len(ROWS), only + ([""] if both else []))
        height = self.table.horizontalHeader().sizeHint().height() + 20 * (len(ROWS) + 1) + 4
        self.table.setFixedHeight(height)

    def _write(self, row, texts):
        for column, text in enumerate(texts):
            item = QtWidgets.QTableWidgetItem(text)
            item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            self.table.setItem(row, column, item)
