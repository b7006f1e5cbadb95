# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every command of the workbench tells FreeCAD of itself."""

from funicular.gui.icons import icon


class Command:
    """A command of FreeCAD's: a subclass has the texts, marked for translation under its NAME, and acts.

    NAME: by which FreeCAD knows it, and the name of its icon. MENU_TEXT: a word or two. TOOL_TIP: what it
    does, and what to select first. WHATS_THIS: what comes of it and what to do next; FreeCAD shows it below
    the tip, and at Shift+F1. ACCEL: its keys.
    """

    NAME = MENU_TEXT = TOOL_TIP = WHATS_THIS = ACCEL = ""

    def GetResources(self):
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": self.MENU_TEXT,
            "ToolTip": self.TOOL_TIP,
            "StatusTip": self.TOOL_TIP,
            "WhatsThis": self.WHATS_THIS,
            "Accel": self.ACCEL,
        }

    def IsActive(self):
        return True
