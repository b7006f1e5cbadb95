# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt as FreeCAD ships it, PySide2 (0.20, 1.0) or PySide6 (1.1), and the translation of what a user reads."""

import FreeCAD
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # 0.20's PySide merges the widgets into QtGui
    from PySide import QtGui as QtWidgets

__all__ = ["QT_TRANSLATE_NOOP", "QtCore", "QtGui", "QtWidgets", "translate"]

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


def translate(text, context="Funicular"):
    """The text in the language of FreeCAD's window. Texts kept in data are marked with QT_TRANSLATE_NOOP."""
    return FreeCAD.Qt.translate(context, text)
