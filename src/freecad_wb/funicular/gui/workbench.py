# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the workbench holds: its commands, in a toolbar and in menus, and its page of preferences."""

import FreeCADGui

from funicular.gui import preferences
from funicular.gui.commands import COMMANDS, HELP
from funicular.gui.qt import QT_TRANSLATE_NOOP

TITLE = QT_TRANSLATE_NOOP("Workbench", "Funicular")


def fill(workbench):
    """Register the commands and give the workbench its toolbar and its menu. FreeCAD calls for it once."""
    for name, command in COMMANDS.items():
        FreeCADGui.addCommand(name, command)
    workbench.appendToolbar(TITLE, [name for name in COMMANDS if name not in HELP])
    workbench.appendMenu(TITLE, list(COMMANDS))
    workbench.appendMenu(["&Help"], HELP)
    preferences.install()
