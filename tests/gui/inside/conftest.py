# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a case needs of the running FreeCAD."""

import json
import os
import pathlib
import sys
import traceback

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from window import (
    QtGui,
    clear_report_view,
    close_panel,
    report_view,
    run_command,
    select_faces,
    settle,
    wait_for_result,
)


@pytest.fixture(autouse=True)
def nothing_is_raised_in_a_slot(monkeypatch):
    """Qt goes on after an exception in Python that it called, and the report view does not get it here."""
    raised = []

    def take(*error):
        text = "".join(traceback.format_exception(*error))
        # FreeCAD's own modules raise things of their own, as Tux does of its main window.
        if "funicular" in text.lower():
            raised.append(text)

    monkeypatch.setattr(sys, "excepthook", take)
    yield
    assert not raised, "\n".join(raised)


@pytest.fixture
def pictures():
    """Folder for pictures that people look at."""
    return pathlib.Path(json.loads(os.environ["FUNICULAR_GUI_CASES"])["pictures"])


@pytest.fixture
def workbench():
    # The screen's own pointer stays out of the way of the mouse that cases move, and of its tooltips.
    QtGui.QCursor.setPos(1, 1)
    Gui.activateWorkbench("FunicularWorkbench")
    settle()
    return Gui.activeWorkbench()


@pytest.fixture
def document(workbench):
    """An empty document with undo, shown in a 3D view."""
    document = App.newDocument("Case")
    document.UndoMode = 1
    Gui.Selection.clearSelection()
    preferences = App.ParamGet("User parameter:BaseApp/Preferences/Mod/Funicular")
    for folded in preferences.GetBools():
        preferences.RemBool(folded)
    preferences.SetBool("OpenMoreOfTheNet", True)
    view = Gui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    clear_report_view()
    name = document.Name
    yield document
    close_panel()
    if name in App.listDocuments():
        App.closeDocument(name)
    settle()


@pytest.fixture
def roof(document):
    """A shallow spherical roof: one untrimmed B-spline face over 8 m × 6 m, 1.5 m high."""
    poles = [
        [
            App.Vector(
                8000 * i / 3, 6000 * j / 3, 3400 * (1 - (2 * i / 3 - 1) ** 2) * (1 - (2 * j / 3 - 1) ** 2)
            )
            for j in range(4)
        ]
        for i in range(4)
    ]
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(poles, [4, 4], [4, 4], [0, 1], [0, 1], False, False, 3, 3)
    roof = document.addObject("Part::Feature", "Roof")
    roof.Shape = surface.toShape()
    document.recompute()
    return roof


@pytest.fixture
def opened(roof):
    """The gridshell of a roof, made by the command, with its panel open and its first result shown."""
    roof.Document.clearUndos()
    select_faces(roof, "Face1")
    run_command()
    shell = roof.Document.getObject("Gridshell")
    assert shell is not None, report_view()
    wait_for_result()
    return shell
