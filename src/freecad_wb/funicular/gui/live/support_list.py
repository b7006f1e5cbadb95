# SPDX-License-Identifier: LGPL-2.1-or-later
"""The supports of a gridshell, one a line: what holds how many nodes, how, and how stiffly."""

from funicular.features.support import FIXED, FREE, LINE, PLANE, VERTICAL_LINE, VERTICAL_PLANE
from funicular.gui.drawing import mark_shapes
from funicular.gui.live.stiffness_row import RIGID, NONE, stiffness_in_words
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtGui, QtWidgets, translate

SHAPES = {
    FIXED: mark_shapes.POINT,
    VERTICAL_LINE: mark_shapes.LINE,
    VERTICAL_PLANE: mark_shapes.PLANE,
    LINE: mark_shapes.LINE,
    PLANE: mark_shapes.PLANE,
    FREE: mark_shapes.FREE,
}
KIND_WORDS = {
    FIXED: QT_TRANSLATE_NOOP("Funicular", "fixed"),
    VERTICAL_LINE: QT_TRANSLATE_NOOP("Funicular", "on its vertical line"),
    VERTICAL_PLANE: QT_TRANSLATE_NOOP("Funicular", "on its vertical plane"),
    LINE: QT_TRANSLATE_NOOP("Funicular", "on a line"),
    PLANE: QT_TRANSLATE_NOOP("Funicular", "on a plane"),
    FREE: QT_TRANSLATE_NOOP("Funicular", "free"),
}
SHOWN_ROWS = 5


def stiffness_of(support):
    """[N/m], RIGID or NONE, of a Support; that of the recipe, None, is RIGID."""
    if support is None:
        return RIGID
    if support.Kind == FREE:
        return NONE
    return float(support.Stiffness.getValueAs("N/m")) or RIGID


def words_of(shell, support, count):
    """One of the supports in words, as a tooltip tells it. support: None for the recipe."""
    if support is None:
        return translate("Recipe {}: {} nodes").format(translate(shell.SupportRecipe), count)
    words = translate("{}: {}, {} nodes").format(support.Label, translate(KIND_WORDS[support.Kind]), count)
    stiffness = stiffness_of(support)
    return words if stiffness in (NONE, RIGID) else f"{words}, {stiffness_in_words(stiffness)}"


class SupportList(QtWidgets.QTreeWidget):
    """The recipe first. Each row is known by the Name of its Support, the recipe by ""."""

    chosen = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.setObjectName("SupportList")
        self.setColumnCount(3)
        self.setHeaderLabels([translate("Support"), translate("Nodes"), translate("Stiffness")])
        self.setRootIsDecorated(False)
        self.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.setToolTip(translate("What is chosen here is ringed in the 3D view, and changed below"))
        header = self.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(0, QtWidgets.QHeaderView.Stretch)
        for column in (1, 2):
            header.setSectionResizeMode(column, QtWidgets.QHeaderView.ResizeToContents)
        rows = SHOWN_ROWS * (self.fontMetrics().height() + 5)
        self.setFixedHeight(rows + header.sizeHint().height())
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Minimum)
        self.itemSelectionChanged.connect(self.chosen)

    def names(self):
        """Of the rows that are chosen, in order."""
        return [item.data(0, QtCore.Qt.UserRole) for item in self._items() if item.isSelected()]

    def show_held(self, shell, held):
        """Show what each holds, as held_by_each(); what was chosen stays so."""
        kept = self.names()
        blocked = self.blockSignals(True)
        self.clear()
        for support, nodes, _ in held:
            if support is None and not len(nodes):
                continue
            self.addTopLevelItem(_item(shell, support, len(nodes)))
        self.choose(kept)
        self.blockSignals(blocked)

    def choose(self, names):
        for item in self._items():
            item.setSelected(item.data(0, QtCore.Qt.UserRole) in names)
            if item.isSelected():
                self.scrollToItem(item)

    def mark(self, name):
        """Let a row stand out while the mouse is on its mark; None for no row."""
        shade = self.palette().color(QtGui.QPalette.Highlight)
        shade.setAlpha(70)
        for item in self._items():
            brush = QtGui.QBrush(shade) if item.data(0, QtCore.Qt.UserRole) == name else QtGui.QBrush()
            for column in range(3):
                item.setBackground(column, brush)

    def _items(self):
        return [self.topLevelItem(row) for row in range(self.topLevelItemCount())]


def _item(shell, support, count):
    stiffness = stiffness_of(support)
    if support is None:
        name, label, shape = "", translate("Recipe: {}").format(translate(shell.SupportRecipe)), None
    else:
        name, label, shape = support.Name, support.Label, SHAPES[support.Kind]
        shape = mark_shapes.YIELDS if stiffness not in (RIGID, NONE) else shape
        label = f"{label}, {translate(KIND_WORDS[support.Kind])}"
    item = QtWidgets.QTreeWidgetItem([label, str(count), stiffness_in_words(stiffness)])
    item.setData(0, QtCore.Qt.UserRole, name)
    item.setTextAlignment(1, QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
    if shape:
        item.setIcon(0, mark_shapes.mark_icon(shape))
    for column in range(3):
        item.setToolTip(column, words_of(shell, support, count))
    return item
