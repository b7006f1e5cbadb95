# SPDX-License-Identifier: LGPL-2.1-or-later
"""What went wrong, where a user reads it: in FreeCAD's report view, and in a panel if no other is open."""

import FreeCAD
import FreeCADGui

from funicular.gui.icons import icon
from funicular.gui.qt import QtGui, QtWidgets, translate
from funicular.gui.texts import WRONG, ResultLine


def report(sentence):
    """Write an error to FreeCAD's report view."""
    FreeCAD.Console.PrintError(f"Funicular: {sentence}\n")


def show_message(sentence):
    """Say what is wrong in the report view and, if no other panel is open, in a panel of its own."""
    report(sentence)
    if not FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.showDialog(MessagePanel(sentence))


class MessagePanel:
    """A sentence and a Close button, where there is nothing to edit."""

    def __init__(self, sentence):
        line = ResultLine()
        line.say(WRONG, sentence)
        self.form = line
        self.form.setWindowTitle(translate("Funicular"))
        self.form.setWindowIcon(QtGui.QIcon(icon("Funicular")))

    def getStandardButtons(self):
        return QtWidgets.QDialogButtonBox.Close

    def reject(self):
        FreeCADGui.Control.closeDialog()
        return True
