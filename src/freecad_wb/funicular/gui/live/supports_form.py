# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons and boxes with which a gridshell is held by hand, as they lie in the panel."""

from funicular.features.support import FIXED, FREE, LINE, PLANE, VERTICAL_LINE, VERTICAL_PLANE
from funicular.gui.drawing.mark_shapes import mark_icon
from funicular.gui.live import pick_tools
from funicular.gui.live.buttons import push_button
from funicular.gui.live.directions import CHOICES
from funicular.gui.live.recipe_buttons import RecipeButtons
from funicular.gui.live.stiffness_row import StiffnessRow
from funicular.gui.live.support_list import SHAPES, SupportList
from funicular.gui.live.tool_icons import tool_icon
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from funicular.gui.texts import WrappedText

TOOLS = (
    (
        pick_tools.OFF,
        QT_TRANSLATE_NOOP("Funicular", "No tool (Esc): a click on a mark chooses its support in the list"),
    ),
    (
        pick_tools.NODES,
        QT_TRANSLATE_NOOP(
            "Funicular",
            "Pick nodes: click one, or drag a box; with Alt a lasso. Shift adds to what is picked",
        ),
    ),
    (pick_tools.BOX, QT_TRANSLATE_NOOP("Funicular", "Pick the nodes in a box. Shift adds to what is picked")),
    (
        pick_tools.LASSO,
        QT_TRANSLATE_NOOP(
            "Funicular", "Pick the nodes within a line drawn by hand. Shift adds to what is picked"
        ),
    ),
    (
        pick_tools.EDGES,
        QT_TRANSLATE_NOOP("Funicular", "Pick all nodes on an edge of the source: click near it"),
    ),
    (
        pick_tools.RAISE,
        QT_TRANSLATE_NOOP("Funicular", "Raise or lower a node: drag it along z, and the net is laid anew"),
    ),
)
KIND_BUTTONS = (
    (
        FIXED,
        QT_TRANSLATE_NOOP("Funicular", "Fixed"),
        QT_TRANSLATE_NOOP("Funicular", "Hold it where it was laid, on the source; the green arrow raises it"),
    ),
    (
        VERTICAL_LINE,
        QT_TRANSLATE_NOOP("Funicular", "Upright line"),
        QT_TRANSLATE_NOOP("Funicular", "Let it slide up and down"),
    ),
    (
        VERTICAL_PLANE,
        QT_TRANSLATE_NOOP("Funicular", "Upright plane"),
        QT_TRANSLATE_NOOP("Funicular", "Let it slide in the vertical plane of its edge or of the border"),
    ),
    (
        LINE,
        QT_TRANSLATE_NOOP("Funicular", "Line along"),
        QT_TRANSLATE_NOOP("Funicular", "Let it slide on a line in the direction that is chosen below"),
    ),
    (
        PLANE,
        QT_TRANSLATE_NOOP("Funicular", "Plane across"),
        QT_TRANSLATE_NOOP("Funicular", "Let it slide in the plane across the direction that is chosen below"),
    ),
    (
        FREE,
        QT_TRANSLATE_NOOP("Funicular", "Free"),
        QT_TRANSLATE_NOOP("Funicular", "Hold it nowhere, whatever the recipe or other supports say"),
    ),
)
# Two, for a panel of the width that FreeCAD gives it.
COLUMNS, SHOWN, MARK = 2, 19, 14


class SupportsForm(QtWidgets.QWidget):
    """What it is to do is said by the methods of whoever derives from it: use_tool, hold, lift, weaken, …"""

    def __init__(self, shell):
        super().__init__()
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        self.recipes = RecipeButtons(shell, lambda recipe: self.choose_recipe(recipe))
        column.addWidget(self.recipes)
        column.addLayout(self._tool_row())
        self.words = WrappedText()
        # What stands below does not jump with each pick.
        self.words.LEAST_LINES = 2
        self.words.setObjectName("SupportWords")
        self.words.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Minimum)
        column.addWidget(self.words)
        column.addLayout(self._kind_grid())
        column.addLayout(self._direction_row())
        self.list = SupportList()
        column.addWidget(self.list)
        self.stiffness = StiffnessRow(
            lambda stiffness: self.weaken(stiffness),
            lambda: self.end_weakening(),
            lambda sentence: self.say_what_is_wrong(sentence),
        )
        column.addWidget(self.stiffness)
        column.addLayout(self._step_row())

    def show_tool(self, tool):
        self._tool_buttons[tool].setChecked(True)

    def show_steps(self, steps):
        self._undo_button.setEnabled(steps.can_undo)
        self._redo_button.setEnabled(steps.can_redo)

    def enable_changes(self, is_chosen, is_picked):
        """Whether there is something to be held in another way, or let go."""
        for button in self._kind_buttons:
            button.setEnabled(is_chosen or is_picked)
        self._lift_button.setEnabled(is_chosen or is_picked)
        self._clear_button.setEnabled(is_picked)

    def _tool_row(self):
        row = QtWidgets.QHBoxLayout()
        row.setSpacing(2)
        group = QtWidgets.QButtonGroup(self)
        self._tool_buttons = {}
        for tool, words in TOOLS:
            button = _tool_button(f"Tool{tool}", translate(words))
            button.setIcon(tool_icon(tool))
            button.setCheckable(True)
            button.clicked.connect(lambda _=False, tool=tool: self.use_tool(tool))
            group.addButton(button)
            row.addWidget(button)
            self._tool_buttons[tool] = button
        row.addStretch(1)
        self._clear_button = push_button(
            "ClearPicks", translate("Clear"), translate("Pick nothing"), lambda: self.clear_picks()
        )
        row.addWidget(self._clear_button)
        self.show_tool(pick_tools.OFF)
        return row

    def _kind_grid(self):
        grid = QtWidgets.QGridLayout()
        grid.setSpacing(2)
        for column in range(COLUMNS):
            grid.setColumnStretch(column, 1)
        self._kind_buttons = []
        for number, (kind, words, what) in enumerate(KIND_BUTTONS):
            name = "Hold" + words.title().replace(" ", "")
            button = push_button(name, translate(words), translate(what), lambda kind=kind: self.hold(kind))
            button.setIcon(mark_icon(SHAPES[kind]))
            button.setIconSize(QtCore.QSize(MARK, MARK))
            grid.addWidget(button, number // COLUMNS, number % COLUMNS)
            self._kind_buttons.append(button)
        return grid

    def _direction_row(self):
        row = QtWidgets.QHBoxLayout()
        self.direction = QtWidgets.QComboBox()
        self.direction.setObjectName("SupportDirection")
        self.direction.setToolTip(
            translate(
                "The direction of a line, or the normal of a plane: an axis, or a straight edge or plane "
                "face that is selected"
            )
        )
        for choice, words in CHOICES:
            self.direction.addItem(translate(words), choice)
        label = QtWidgets.QLabel(translate("Direction"))
        label.setBuddy(self.direction)
        row.addWidget(label)
        row.addWidget(self.direction, 1)
        return row

    def _step_row(self):
        row = QtWidgets.QHBoxLayout()
        row.setSpacing(2)
        for name, words, what, do in (
            (
                "Lift",
                translate("Lift"),
                translate("Let go of what is chosen in the list, or free the nodes that are picked"),
                lambda: self.lift(),
            ),
            (
                "Undo",
                translate("Undo"),
                translate("Take back the last step in this section"),
                lambda: self.undo(),
            ),
            ("Redo", translate("Redo"), translate("Do again what was taken back"), lambda: self.redo()),
        ):
            button = push_button(f"Support{name}", words, what, do)
            row.addWidget(button)
            setattr(self, f"_{name.lower()}_button", button)
        return row


def _tool_button(name, tooltip):
    button = QtWidgets.QToolButton()
    button.setObjectName(name)
    button.setToolTip(tooltip)
    button.setAccessibleName(tooltip)
    button.setIconSize(QtCore.QSize(SHOWN, SHOWN))
    button.setAutoRaise(True)
    button.setFocusPolicy(QtCore.Qt.StrongFocus)
    return button
