# SPDX-License-Identifier: LGPL-2.1-or-later
"""The covering: its command, how it looks, undo, File > Export."""

import importlib

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from funicular.gui.commands import COMMANDS
from funicular.make import make_covering, make_gridshell
from window import (
    COVERING,
    clear_report_view,
    colours_of,
    command_action,
    names,
    press,
    report_view,
    result_line,
    run_command,
    settle,
    wait_until,
)


@pytest.fixture
def shell(roof):
    roof.Visibility = False
    shell = make_gridshell(roof.Document, source=(roof, ["Face1"]), StepU="500 mm", StepV="500 mm")
    roof.Document.recompute()
    assert shell.Status == "converged", shell.Summary
    roof.Document.clearUndos()
    settle()
    return shell


def select(*objects, element=""):
    Gui.Selection.clearSelection()
    for obj in objects:
        Gui.Selection.addSelection(obj, element)
    settle()


def test_the_command_waits_for_one_gridshell(shell):
    select()
    assert not Gui.isCommandActive(COVERING)
    select(shell.Net)
    assert not Gui.isCommandActive(COVERING)
    for element in ("", "Edge3"):
        select(shell, element=element)
        assert Gui.isCommandActive(COVERING)
    wait_until(command_action("Covering").isEnabled, "the tool bar's button enabled")
    second = make_gridshell(shell.Document, net=shell.Net)
    select(shell, second)
    assert not Gui.isCommandActive(COVERING)
    # A script may call it all the same.
    COMMANDS[COVERING].Activated()
    settle()
    assert "2 gridshells are selected" in result_line()
    press("Close")


def test_it_covers_the_gridshell_in_one_undo_step(shell):
    document = shell.Document
    clear_report_view()
    select(shell)
    run_command(COVERING)
    covering = document.Covering
    assert covering.isValid() and covering.PanelCount == shell.Net.PanelCount == len(covering.Shape.Faces)
    assert covering.Visibility and shell.Visibility
    assert document.UndoNames == ["Covering"] and not document.HasPendingTransaction
    document.undo()
    assert names(document) == ["Roof", "Net", "Gridshell"]
    document.redo()
    settle()
    assert type(document.Covering.ViewObject.Proxy).__name__ == "ViewProviderCovering"
    assert document.Covering.ViewObject.Transparency == 30
    assert report_view() == ""


def test_what_cannot_be_covered_is_a_sentence_and_leaves_nothing(shell):
    shell.Panels = []
    shell.purgeTouched()
    before = names(shell.Document)
    clear_report_view()
    select(shell)
    run_command(COVERING)
    assert "Gridshell has no panels" in result_line() and "Gridshell has no panels" in report_view()
    press("Close")
    assert names(shell.Document) == before and shell.Document.UndoCount == 0


def test_it_is_a_light_veil_under_the_members(shell, pictures):
    vobj = make_covering(shell.Document, shell).ViewObject
    shell.Document.recompute()
    assert (vobj.Transparency, vobj.DisplayMode) == (30, "Shaded")
    assert vobj.Proxy.getIcon().endswith("Funicular_Covering.svg")
    assert vobj.claimChildren() == [] and shell.ViewObject.claimChildren() == [shell.Net]
    view = Gui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    settle()
    path = pictures / "covering.png"
    view.saveImage(str(path), 1200, 800, "White")
    colours = colours_of(path)
    timber = sum(count for (r, g, b), count in colours.items() if 10 < r - b < 120 and r >= g >= b)
    assert timber > 0.1 * sum(colours.values()), "the panels are seen"
    blue = sum(count for (r, g, b), count in colours.items() if b > r + 40 and b > g)
    assert blue > 0.005 * sum(colours.values()), "and the members with their forces"


def test_it_comes_back_from_a_file_as_it_looked(shell, tmp_path):
    make_covering(shell.Document, shell).ViewObject.Transparency = 60
    shell.Document.recompute()
    path = str(tmp_path / "roof.FCStd")
    shell.Document.saveAs(path)
    App.closeDocument(shell.Document.Name)
    document = App.openDocument(path)
    settle()
    try:
        vobj = document.Covering.ViewObject
        assert type(vobj.Proxy).__name__ == "ViewProviderCovering" and vobj.Transparency == 60
        assert not Gui.getDocument(document.Name).Modified, "opening a file changes nothing in it"
    finally:
        App.closeDocument(document.Name)


def test_freecads_file_dialog_offers_it_beside_its_own_formats(shell, tmp_path):
    (module,) = [name for name in App.getExportType("csv") if name.startswith("funicular")]
    for suffix in ("obj", "ply", "stl", "off"):
        assert {module, "Mesh"} <= set(App.getExportType(suffix))
    # What FreeCAD does once a file type was chosen.
    importlib.import_module(module).export([shell], str(tmp_path / "roof.csv"))
    assert {path.name for path in tmp_path.iterdir()} == {"roof-members.csv", "roof-nodes.csv"}
