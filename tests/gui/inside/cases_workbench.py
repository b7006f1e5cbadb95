# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench and its command in FreeCAD's window."""

import FreeCADGui as Gui
from funicular.gui.commands import COMMANDS
from window import (
    QtWidgets,
    GRIDSHELL,
    clear_report_view,
    command_action,
    press,
    report_view,
    result_line,
    run_command,
    select_faces,
    settle,
    wait_for_result,
    wait_until,
)

TITLES = [
    "Gridshell",
    "Flat sheet",
    "Support",
    "Point load",
    "Covering",
    "Raise",
    "Take out",
    "What accuracy costs",
]

GUIDE = "Funicular guide"


def test_workbench_has_an_icon_a_toolbar_and_a_menu(workbench):
    window = Gui.getMainWindow()
    toolbar = window.findChild(QtWidgets.QToolBar, "Funicular")
    assert toolbar is not None and toolbar.isVisible()
    assert [action.text().replace("&", "") for action in toolbar.actions()] == TITLES
    assert not any(action.icon().isNull() for action in toolbar.actions())
    menus = [
        menu for menu in window.findChildren(QtWidgets.QMenu) if menu.title().replace("&", "") == "Funicular"
    ]
    assert len(menus) == 1
    assert [action.text().replace("&", "") for action in menus[0].actions()] == [*TITLES, GUIDE]
    with open(workbench.Icon, encoding="utf-8") as icon:
        assert "<svg" in icon.read()


def test_command_has_a_shortcut_and_says_what_it_needs(workbench):
    action = command_action()
    assert action.shortcut().toString() == "G, S"
    assert "Select a face" in action.toolTip()
    assert GRIDSHELL in Gui.listCommands()


def test_command_waits_for_a_face(roof):
    Gui.Selection.clearSelection()
    assert not Gui.isCommandActive(GRIDSHELL)
    select_faces(roof, "Edge1")
    assert not Gui.isCommandActive(GRIDSHELL)
    select_faces(roof, "Face1")
    assert Gui.isCommandActive(GRIDSHELL)
    wait_until(command_action().isEnabled, "the tool bar's button enabled")


def test_command_takes_an_object_that_is_one_face(roof):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(roof)
    assert Gui.isCommandActive(GRIDSHELL)


def test_without_a_selection_it_says_what_to_select(document):
    clear_report_view()
    # FreeCAD lets nobody press an inactive command, but a script may call it.
    COMMANDS[GRIDSHELL].Activated()
    settle()
    assert "Select a face" in result_line()
    assert "Select a face" in report_view()
    assert document.Objects == []
    press("Close")
    assert not Gui.Control.activeDialog()


def test_with_faces_of_several_bodies_it_says_how_many_and_makes_nothing(document, roof):
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    before = document.Objects
    select_faces(box, "Face6")
    Gui.Selection.addSelection(roof, "Face1")
    clear_report_view()
    run_command()
    assert "2 bodies" in result_line() and "single body" in result_line()
    assert "2 bodies" in report_view()
    assert document.Objects == before
    press("Close")


def test_with_a_whole_solid_it_asks_for_faces(document):
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(box)
    run_command()
    assert "Box is selected as a whole, with 6 faces" in result_line()
    assert document.Objects == [box]
    press("Close")


def test_with_several_faces_of_one_body_it_makes_one_net(document):
    box = document.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 8000, 6000, 3000
    document.recompute()
    select_faces(box, "Face2", "Face6")
    run_command()
    assert wait_for_result().startswith("✔")
    assert list(document.Net.Source[1]) == ["Face2", "Face6"]
    press("Ok")


def test_workbench_can_be_left_and_entered_again(workbench):
    clear_report_view()
    Gui.activateWorkbench("PartWorkbench")
    settle()
    Gui.activateWorkbench("FunicularWorkbench")
    settle()
    assert len(Gui.getMainWindow().findChildren(QtWidgets.QToolBar, "Funicular")) == 1
    assert report_view() == ""
