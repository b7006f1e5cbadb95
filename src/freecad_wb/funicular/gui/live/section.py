# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part of a panel that can be folded away; whether it is, FreeCAD remembers."""

import FreeCAD

from funicular.gui.preferences import GROUP
from funicular.gui.qt import QtCore, QtWidgets


class Section(QtWidgets.QWidget):
    """A title with an arrow, and below it what is folded.

    Parameters
    ----------
    name : str
        By which it is remembered.
    title : str
        As the user reads it.
    content : QWidget
    is_open : bool
        As it comes, until the user says otherwise.
    """

    def __init__(self, name, title, content, is_open=True):
        super().__init__()
        self._key = f"Open{name}"
        self._content = content
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        self._button = QtWidgets.QToolButton()
        self._button.setObjectName(f"Section{name}")
        self._button.setText(title)
        self._button.setCheckable(True)
        self._button.setAutoRaise(True)
        self._button.setFocusPolicy(QtCore.Qt.StrongFocus)
        self._button.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self._button.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
        font = self._button.font()
        font.setBold(True)
        self._button.setFont(font)
        column.addWidget(self._button)
        column.addWidget(content)
        is_open = FreeCAD.ParamGet(GROUP).GetBool(self._key, is_open)
        self._button.setChecked(is_open)
        self._fold(is_open)
        self._button.toggled.connect(self._toggled)

    def open(self):
        """Show what is in it."""
        self._button.setChecked(True)

    def _toggled(self, is_open):
        FreeCAD.ParamGet(GROUP).SetBool(self._key, is_open)
        self._fold(is_open)

    def _fold(self, is_open):
        self._button.setArrowType(QtCore.Qt.DownArrow if is_open else QtCore.Qt.RightArrow)
        self._content.setVisible(is_open)
