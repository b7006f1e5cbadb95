# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a gridshell stands by recipe: one click, a picture for each."""

from funicular.features.support import RECIPES
from funicular.gui.drawn_icons import draw_dots, drawn_icon
from funicular.gui.inputs import expression_of
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtGui, QtWidgets, translate

WORDS = {
    "Boundary": QT_TRANSLATE_NOOP("Funicular", "Every node of the border stands"),
    "Corners": QT_TRANSLATE_NOOP("Funicular", "It stands on its corners"),
    "Corners and border planes": QT_TRANSLATE_NOOP(
        "Funicular", "It stands on its corners, and its borders stay in vertical planes"
    ),
    "Lowest points": QT_TRANSLATE_NOOP("Funicular", "The lowest nodes stand"),
    "Opening rims": QT_TRANSLATE_NOOP("Funicular", "The rims of openings stand"),
    "None": QT_TRANSLATE_NOOP("Funicular", "It stands on its own supports alone"),
}
SHOWN = 24
BACK = (QtCore.Qt.Key_Left, QtCore.Qt.Key_Up)
ON = (QtCore.Qt.Key_Right, QtCore.Qt.Key_Down)


class RecipeButtons(QtWidgets.QWidget):
    """One stop of the Tab key: arrows choose. on_choice: callable(recipe)."""

    def __init__(self, shell, on_choice):
        super().__init__()
        self.setObjectName("SupportRecipe")
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        documentation = translate(shell.getDocumentationOfProperty("SupportRecipe"), "App::Property")
        self.setToolTip(documentation + ": " + translate("a recipe for all nodes that no support speaks of"))
        self._shell, self._on_choice, self._buttons = shell, on_choice, {}
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(2, 2, 2, 2)
        row.setSpacing(2)
        for recipe in RECIPES:
            button = QtWidgets.QToolButton()
            button.setObjectName("Recipe" + recipe.title().replace(" ", ""))
            button.setIcon(drawn_icon(lambda painter, ink, recipe=recipe: _paint(painter, ink, recipe)))
            button.setIconSize(QtCore.QSize(SHOWN, SHOWN))
            button.setCheckable(True)
            button.setAutoRaise(True)
            button.setFocusPolicy(QtCore.Qt.NoFocus)
            button.setToolTip(f"{translate(recipe)}: {translate(WORDS[recipe])}")
            button.setAccessibleName(translate(recipe))
            button.clicked.connect(lambda _=False, recipe=recipe: self._choose(recipe))
            row.addWidget(button)
            self._buttons[recipe] = button
        row.addStretch(1)
        self.setEnabled(not expression_of(shell, "SupportRecipe"))
        self.show_recipe()

    def show_recipe(self):
        for recipe, button in self._buttons.items():
            button.setChecked(recipe == self._shell.SupportRecipe)

    def keyPressEvent(self, event):
        step = (event.key() in ON) - (event.key() in BACK)
        if not step:
            super().keyPressEvent(event)
            return
        at = RECIPES.index(self._shell.SupportRecipe) + step
        if 0 <= at < len(RECIPES):
            self._choose(RECIPES[at])

    def paintEvent(self, event):
        if self.hasFocus():
            painter, option = QtWidgets.QStylePainter(self), QtWidgets.QStyleOptionFocusRect()
            option.initFrom(self)
            painter.drawPrimitive(QtWidgets.QStyle.PE_FrameFocusRect, option)

    def _choose(self, recipe):
        self._on_choice(recipe)
        self.show_recipe()


def _paint(painter, ink, recipe):
    """A square on plan: what stands is thick."""
    thin, thick, dashed = (QtGui.QPen(ink, width) for width in (4.0, 12.0, 9.0))
    thick.setJoinStyle(QtCore.Qt.MiterJoin)
    dashed.setStyle(QtCore.Qt.DotLine)
    square, hole = QtCore.QRectF(14, 14, 68, 68), QtCore.QRectF(34, 34, 28, 28)
    corners = [(x, y) for x in (14, 82) for y in (14, 82)]
    painter.setPen(thick if recipe == "Boundary" else thin)
    if recipe == "Lowest points":
        # Seen from the side.
        painter.drawArc(QtCore.QRectF(14, 26, 68, 100), 0, 180 * 16)
        corners = [(x, 76) for x in (14, 82)]
    else:
        painter.drawRect(square)
    if recipe == "Opening rims":
        painter.setPen(thick)
        painter.drawEllipse(hole)
    if recipe == "Corners and border planes":
        painter.setPen(dashed)
        painter.drawRect(square)
    if recipe in ("Corners", "Corners and border planes", "Lowest points"):
        draw_dots(painter, ink, corners)
