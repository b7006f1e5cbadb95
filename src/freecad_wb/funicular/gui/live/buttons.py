# SPDX-License-Identifier: LGPL-2.1-or-later
"""Buttons of the panel, which may stand beside each other in one of the width that FreeCAD gives it."""

from funicular.gui.qt import QtWidgets

NARROW = 40  # [px], to which a button with a short word may shrink


def push_button(name, words, what, pressed):
    """A QPushButton. name: of the object. what: its tooltip. pressed: callable()"""
    button = QtWidgets.QPushButton(words)
    button.setObjectName(name)
    button.setToolTip(what)
    button.setMinimumWidth(NARROW)
    button.clicked.connect(lambda: pressed())
    return button
