# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that edit the net of a gridshell where it is picked."""

import FreeCADGui

from funicular.gui.command import Command
from funicular.gui.one_step import in_one_step
from funicular.gui.picking import WrongSelection, picked_parts
from funicular.gui.qt import QT_TRANSLATE_NOOP, translate


class TakeOutCommand(Command):
    """Selected members of a Gridshell, or faces of its Covering → openings in its net, one undo step."""

    NAME = "Funicular_TakeOut"

    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_TakeOut", "Take out")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_TakeOut",
        "Take the selected members out of the net, or the panels whose faces are selected.\n"
        "Select members of a Gridshell, or faces of its Covering. Their place on the face is kept.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_TakeOut",
        "The covering of an opening stands on its rim. The gridshell is relaxed again. Undo "
        "takes it back.",
    )
    ACCEL = "G, T"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and bool(FreeCADGui.Selection.getSelection())

    def Activated(self):
        from funicular.features.picked_edits import taken_out

        _edit_picked(
            translate("Take out"), lambda shell, members, panels, points: taken_out(shell, members, panels)
        )


class RaiseCommand(Command):
    """Selected nodes of a Gridshell → nodes of its net that are higher by a part of a step, one undo step."""

    NAME = "Funicular_Raise"

    # A part of the net's step: to be seen, and repeated for more.
    PART_OF_STEP = 0.25

    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_Raise", "Raise")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_Raise",
        "Raise the selected nodes of the net by a quarter of a member, and again for more.\n"
        "Select nodes of a Gridshell. The height of each is in the property Raised of its Net.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_Raise",
        "The gridshell is relaxed again on the net that was changed. Undo takes it back.",
    )
    ACCEL = "G, R"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and bool(FreeCADGui.Selection.getSelection())

    def Activated(self):
        from funicular.features.picked_edits import raised, typical_length

        def changes(shell, members, panels, points):
            return raised(shell, points, self.PART_OF_STEP * typical_length(shell.Net))

        _edit_picked(translate("Raise"), changes)


def _edit_picked(title, changes):
    """Sets what changes(*picked parts) says of the Net, recomputed, in one undo step; or says why not."""
    from funicular.gui.messages import show_message

    try:
        parts = picked_parts()
        shell, found = parts[0], changes(*parts)
    except (WrongSelection, ValueError) as error:
        show_message(str(error))
        return

    def change():
        for name, value in found.items():
            setattr(shell.Net, name, value)
        return shell.Net, shell

    if in_one_step(shell.Document, title, change) is not None:
        FreeCADGui.Selection.clearSelection()
