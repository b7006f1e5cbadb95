# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench."""

import math

import FreeCADGui

from funicular.gui.icons import icon
from funicular.gui.qt import QT_TRANSLATE_NOOP, translate

# Cells along the diagonal of the picked face: enough to see the form, few enough to see every member.
CELLS_ACROSS = 24


class WrongSelection(Exception):
    """What is selected does not say what to build on; the text says what to select instead."""


class GridshellCommand:
    """Selected face (or Net) → Net, Gridshell and the gridshell's panel, all of it one undo step."""

    NAME = "Funicular_Gridshell"

    def GetResources(self):
        what = QT_TRANSLATE_NOOP(
            "Funicular_Gridshell",
            "Turn the selected face into a compression-only gridshell.\n"
            "Select one face in the 3D view, or a Net in the tree, then run this command.",
        )
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("Funicular_Gridshell", "Gridshell"),
            "ToolTip": what,
            "WhatsThis": self.NAME,
            "StatusTip": what,
            "Accel": "G, S",
        }

    def IsActive(self):
        if FreeCADGui.Control.activeDialog():
            return False
        faces, nets = selected_sources()
        return bool(faces or nets)

    def Activated(self):
        from funicular.gui.task_panel import show_message

        try:
            source, net = the_source()
        except WrongSelection as error:
            show_message(str(error))
            return
        document = (net or source[0]).Document
        document.openTransaction(translate("Gridshell"))
        try:
            shell = _make(document, source, net)
        except Exception as error:
            # Whatever went wrong: no half of an object stays behind, and the user reads why.
            document.abortTransaction()
            show_message(str(error))
            return
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.getDocument(document.Name).setEdit(shell.Name)
        if source is not None and not shell.Shape.isNull():
            # As FreeCAD's Part features do with what they are made of. A face that failed stays in sight.
            source[0].Visibility = False


def selected_sources():
    """What is selected that a gridshell can be built on.

    Returns
    -------
    (faces, nets)
        `faces`: list of (object, sub-element name); an object picked as a whole counts with each of its
        faces. `nets`: list of Net objects.
    """
    faces, nets = [], []
    for selected in FreeCADGui.Selection.getSelectionEx():
        obj = selected.Object
        if getattr(obj, "FunicularType", "") == "Net":
            nets.append(obj)
        elif selected.SubElementNames:
            faces += [(obj, name) for name in selected.SubElementNames if name.startswith("Face")]
        elif hasattr(obj, "Shape") and not hasattr(obj, "FunicularType"):
            faces += [(obj, f"Face{index + 1}") for index in range(obj.Shape.countElement("Face"))]
    return faces, nets


def the_source():
    """The one thing that is selected: ((object, [face name]), None) or (None, net).

    Raises WrongSelection when nothing fits, or more than one thing does.
    """
    faces, nets = selected_sources()
    if not faces and not nets:
        raise WrongSelection(
            translate(
                "Nothing to build on is selected. Select one face in the 3D view, then run Gridshell again."
            )
        )
    if len(faces) + len(nets) > 1:
        raise WrongSelection(
            translate(
                "{} faces or nets are selected, and a gridshell stands on one. "
                "Select a single face in the 3D view, then run Gridshell again."
            ).format(len(faces) + len(nets))
        )
    if nets:
        return None, nets[0]
    return (faces[0][0], [faces[0][1]]), None


def _make(document, source, net):
    from funicular import _native
    from funicular.make import make_gridshell

    # Where the module is missing this raises a sentence, before there are objects that could only fail.
    _native.load()
    if net is not None:
        shell = make_gridshell(document, net=net)
        net.Visibility = False
    else:
        step = f"{starting_step(source[0].getSubObject(source[1][0]))} mm"
        shell = make_gridshell(document, source=source, StepU=step, StepV=step)
    return shell


def starting_step(face):
    """A round step in mm that gives a face of this size a few dozen cells across, to begin with."""
    diagonal = face.BoundBox.DiagonalLength
    if not 0.0 < diagonal < math.inf:
        return 1000.0
    wanted = diagonal / CELLS_ACROSS
    decade = 10.0 ** math.floor(math.log10(wanted))
    return max(factor * decade for factor in (1.0, 2.0, 2.5, 5.0) if factor * decade <= wanted * 1.0001)


COMMANDS = {GridshellCommand.NAME: GridshellCommand()}
