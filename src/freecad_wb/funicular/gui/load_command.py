# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that puts a load on nodes, and what is selected to say on which."""

import FreeCADGui

from funicular.gui.command import Command
from funicular.gui.one_step import in_one_step
from funicular.gui.picking import WrongSelection, picks_of, selected_gridshells, the_gridshell
from funicular.gui.qt import QT_TRANSLATE_NOOP, translate


def where_selected(shell, nodes=None):
    """The properties of a PointLoad that say which nodes of a gridshell are selected.

    nodes: (n, 3) [mm], before Placement, where they are not those of its last result. Raises WrongSelection
    where none are.
    """
    from funicular.features.node_choice import at_picks

    elements, points = picks_of(shell)
    if not elements and not points:
        raise WrongSelection(
            translate(
                "No place for the load is selected: select nodes of the gridshell, or edges and vertices of "
                "its source, in the 3D view."
            )
        )
    return at_picks(shell, elements, points, nodes)


class PointLoadCommand(Command):
    """Selected nodes of a Gridshell, or edges and vertices → a PointLoad there, one undo step."""

    NAME = "Funicular_PointLoad"
    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_PointLoad", "Point load")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_PointLoad",
        "Put a load of 1 kN on each of the selected nodes.\n"
        "Select a Gridshell, and with it nodes of its own, or edges and vertices of its source.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_PointLoad",
        "The load is an object of its own below the Gridshell, with Force and Direction as properties, and "
        "keeps its place on the face, whatever the step. The shell is relaxed with it.",
    )
    ACCEL = "G, L"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and len(selected_gridshells()) == 1

    def Activated(self):
        from funicular.gui.messages import show_message
        from funicular.make import make_point_load

        try:
            shell = the_gridshell()
            where = where_selected(shell)
        except WrongSelection as error:
            show_message(str(error))
            return
        made = in_one_step(
            shell.Document, translate("Point load"), lambda: [make_point_load(shell.Document, shell, **where)]
        )
        if made is not None:
            # Its properties are what is wanted next.
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(made[0])
