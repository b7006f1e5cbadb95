# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench."""

import math

import FreeCAD
import FreeCADGui

from funicular.gui import preferences
from funicular.gui.edit_commands import RaiseCommand, TakeOutCommand
from funicular.gui.command import Command
from funicular.gui.load_command import PointLoadCommand
from funicular.gui.one_step import in_one_step
from funicular.gui.picking import (
    WrongSelection,
    clicked_object,
    picks_of,
    selected_gridshells,
    selected_sources,
    the_gridshell,
    the_source,
)
from funicular.gui.qt import QT_TRANSLATE_NOOP, translate

# Cells along the diagonal of the picked face: enough to see the form, few enough to see every member. A
# narrow face gets no fewer than a few across.
CELLS_ACROSS = 24
FEWEST_CELLS = 4


class GridshellCommand(Command):
    """Selected face (or Net) → Net, Gridshell and the gridshell's panel, all of it one undo step."""

    NAME = "Funicular_Gridshell"

    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_Gridshell", "Gridshell")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_Gridshell",
        "Turn the selected face into a compression-only gridshell.\n"
        "Select a face in the 3D view, several of one body, or a Net in the tree, then run this command.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_Gridshell",
        "A net is laid on the face and relaxed until each member is compressed. The panel "
        "that opens has its steps, weights and supports. Shape and numbers follow the face "
        "from then on.",
    )
    ACCEL = "G, S"

    def IsActive(self):
        if FreeCADGui.Control.activeDialog():
            return False
        faces, nets = selected_sources()
        return bool(faces or nets)

    def Activated(self):
        from funicular.gui.messages import show_message
        from funicular.gui.task_panel import active_transaction

        try:
            source, net = the_source()
        except WrongSelection as error:
            show_message(str(error))
            return
        document = (net or source[0]).Document
        document.openTransaction(translate("Gridshell"))
        transaction = active_transaction()
        try:
            shell = _make(document, source, net)
        except Exception as error:
            # Whatever went wrong: no half of an object stays behind, and the user reads why.
            document.abortTransaction()
            show_message(str(error))
            return
        FreeCADGui.Selection.clearSelection()
        shell.ViewObject.Proxy.edit(shell.ViewObject, transaction)
        if source is not None and not shell.Net.Shape.isNull():
            # As FreeCAD's Part features do with what they are made of. A face that failed stays in sight.
            clicked_object(source).Visibility = False


class SheetCommand(Command):
    """A flat sheet on four corners, its gridshell and the gridshell's panel, all of it one undo step."""

    NAME = "Funicular_Sheet"

    # A hall of moderate size; the panel that opens has both as inputs.
    WIDTH, DEPTH, STEP = "12 m", "9 m", "500 mm"

    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_Sheet", "Flat sheet")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_Sheet",
        "Start from a flat sheet of given size, which rises between its four corners.\n"
        "Nothing needs to be selected.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_Sheet",
        "The sheet stands on its four corners and rises between them. The panel that opens "
        "has its width, its depth and all else that a gridshell has.",
    )
    ACCEL = "G, F"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        from funicular.gui.messages import show_message
        from funicular.gui.task_panel import active_transaction
        from funicular.make import make_gridshell

        document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
        document.openTransaction(translate("Flat sheet"))
        transaction = active_transaction()
        try:
            shell = make_gridshell(
                document,
                Width=self.WIDTH,
                Depth=self.DEPTH,
                StepU=self.STEP,
                StepV=self.STEP,
                SupportRecipe="Corners",
                Accuracy=f"{preferences.accuracy()} mm",
            )
        except Exception as error:
            document.abortTransaction()
            show_message(str(error))
            return
        proxy = shell.ViewObject.Proxy
        proxy.edit(shell.ViewObject, transaction)
        view = FreeCADGui.getDocument(document.Name).ActiveView
        if len(document.Objects) == len((shell, shell.Net)):
            # Nobody has chosen a view yet, and from above nothing is seen to rise.
            view.viewIsometric()
        view.fitAll()
        proxy.fit_at_rest()


class SupportCommand(Command):
    """Selected Gridshell, and edges or vertices → a Support there, one undo step."""

    NAME = "Funicular_Support"

    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_Support", "Support")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_Support",
        "Hold the selected gridshell at its border, or where edges and vertices are selected too.\n"
        "Select a Gridshell, and with it nodes of its own, or edges and vertices of its source.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_Support",
        "The new Support stands in the tree, and its properties say how it holds its nodes: "
        "fixed, sliding in a plane or on a line, yielding, or not at all. It outlives other "
        "steps of the net.",
    )
    ACCEL = "G, P"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and len(selected_gridshells()) == 1

    def Activated(self):
        from funicular.features.node_choice import at_picks
        from funicular.gui.messages import show_message
        from funicular.make import make_support

        try:
            shell = the_gridshell()
            picks = picks_of(shell)
        except WrongSelection as error:
            show_message(str(error))
            return
        made = in_one_step(
            shell.Document,
            translate("Support"),
            lambda: [make_support(shell.Document, shell, **at_picks(shell, *picks))],
        )
        if made is not None:
            # Its properties are what is wanted next.
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(made[0])


class CoveringCommand(Command):
    """Selected Gridshell → Covering of its panels, one undo step."""

    NAME = "Funicular_Covering"

    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_Covering", "Covering")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_Covering",
        "Cover the panels of the selected gridshell with faces.\n"
        "Select one Gridshell in the tree or in the 3D view, then run this command.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_Covering",
        "Each panel becomes a face that other commands of FreeCAD can use and that STEP files "
        "take. The Covering says which panels are warped and by how much, and follows the "
        "gridshell.",
    )
    ACCEL = "G, C"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and len(selected_gridshells()) == 1

    def Activated(self):
        from funicular.gui.messages import show_message
        from funicular.make import make_covering

        try:
            shell = the_gridshell()
        except WrongSelection as error:
            show_message(str(error))
            return
        in_one_step(shell.Document, translate("Covering"), lambda: [make_covering(shell.Document, shell)])


class AccuracyStudyCommand(Command):
    """Selected Gridshell → the dock that measures what accuracy costs it; the document stays as it is."""

    NAME = "Funicular_AccuracyStudy"

    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_AccuracyStudy", "What accuracy costs")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_AccuracyStudy",
        "Measure how long the selected gridshell takes at several accuracies, and choose one.\n"
        "Select one Gridshell in the tree or in the 3D view, then run this command.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_AccuracyStudy",
        "A plot grows beside the 3D view, and nothing waits for it. Click a point of it, and "
        "the gridshell takes that accuracy and method.",
    )
    ACCEL = "G, A"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and len(selected_gridshells()) == 1

    def Activated(self):
        from funicular.gui.messages import show_message

        try:
            shell = the_gridshell()
            # Matplotlib is not loaded before it is needed, and may be missing.
            from funicular.gui import accuracy_dock
        except (WrongSelection, ImportError) as error:
            show_message(str(error))
            return
        accuracy_dock.show(shell)


class GuideCommand(Command):
    """The guide, in a window of its own."""

    NAME = "Funicular_Guide"

    MENU_TEXT = QT_TRANSLATE_NOOP("Funicular_Guide", "Funicular guide")
    TOOL_TIP = QT_TRANSLATE_NOOP(
        "Funicular_Guide",
        "Two pages with pictures: from a face to a gridshell and out.",
    )
    WHATS_THIS = QT_TRANSLATE_NOOP(
        "Funicular_Guide",
        "The guide opens in a window of its own and needs no network.",
    )
    ACCEL = "G, H"

    def Activated(self):
        from funicular.gui import guide

        guide.show()


def _make(document, source, net):
    from funicular import _native
    from funicular.make import make_gridshell

    # Where the module is missing this raises a sentence, before there are objects that could only fail.
    _native.load()
    accuracy = f"{preferences.accuracy()} mm"
    if net is not None:
        shell = make_gridshell(document, net=net, Accuracy=accuracy)
        net.Visibility = False
    else:
        root, paths = source
        face = root.getSubObject(paths[0])
        face = face.Faces[0] if getattr(face, "Faces", None) else None
        step_u, step_v = (f"{step} mm" for step in starting_steps(face))
        shell = make_gridshell(document, source=source, StepU=step_u, StepV=step_v, Accuracy=accuracy)
    return shell


def starting_steps(face):
    """Round steps in mm, along u and v, that give a face of this size a few dozen cells to begin with."""
    import funicular as fn
    from funicular import surface

    try:
        chart = surface.read_rectangle(face)[0] if surface.is_trimmed(face) else surface.read_face(face)
    except fn.InvalidInput:
        # No net can be made on it, and the net says why.
        return 1000.0, 1000.0
    wanted = chart.size / CELLS_ACROSS
    return tuple(_round_down(min(wanted, _mean_isoline(chart, axis) / FEWEST_CELLS)) for axis in ("u", "v"))


def _mean_isoline(chart, axis):
    """Mean length [mm] of a few isolines along u or along v, by their chords."""
    import numpy as np

    line, count = np.linspace(0.0, 1.0, 33), 5
    along, across = np.tile(line, count), np.repeat(np.linspace(0.0, 1.0, count), len(line))
    points = chart.point(along, across) if axis == "u" else chart.point(across, along)
    steps = np.diff(points.reshape(count, len(line), 3), axis=1)
    return float(np.linalg.norm(steps, axis=2).sum()) / count


def _round_down(length):
    decade = 10.0 ** math.floor(math.log10(length))
    return max(factor * decade for factor in (1.0, 2.0, 2.5, 5.0) if factor * decade <= length * 1.0001)


COMMANDS = {
    command.NAME: command()
    for command in (
        GridshellCommand,
        SheetCommand,
        SupportCommand,
        PointLoadCommand,
        CoveringCommand,
        RaiseCommand,
        TakeOutCommand,
        AccuracyStudyCommand,
        GuideCommand,
    )
}

# Of these, what belongs in FreeCAD's own help menu.
HELP = [GuideCommand.NAME]
