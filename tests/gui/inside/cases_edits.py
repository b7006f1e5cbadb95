# SPDX-License-Identifier: LGPL-2.1-or-later
"""Raising nodes and taking members and panels out, by what is selected."""

import FreeCADGui as Gui
import pytest
from funicular.gui.edit_commands import RaiseCommand, TakeOutCommand
from funicular.make import make_covering, make_gridshell
from window import press, report_view, settle


@pytest.fixture
def shell(document):
    made = make_gridshell(document, Width="6 m", Depth="5 m")
    document.recompute()
    document.clearUndos()
    settle()
    return made


def run(command, *picks):
    Gui.Selection.clearSelection()
    for obj, element in picks:
        Gui.Selection.addSelection(obj, element)
    Gui.runCommand(command.NAME)
    settle()


def test_a_selected_node_rises_in_one_undo_step(shell):
    run(RaiseCommand, (shell, "Vertex20"))
    assert [round(at.z) for at in shell.Net.Raised] == [250], report_view()
    assert shell.Document.UndoCount == 1 and not Gui.Selection.getSelection()
    shell.Document.undo()
    shell.Document.recompute()
    assert not shell.Net.Raised and shell.Status == "converged"


def test_selected_members_and_faces_of_the_covering_go(shell):
    members, panels = shell.Net.MemberCount, shell.Net.PanelCount
    run(TakeOutCommand, (shell, "Edge20"))
    assert shell.Net.MemberCount == members - 1 and len(shell.Net.RemovedMembers) == 1, report_view()
    covering = make_covering(shell.Document, shell)
    shell.Document.recompute()
    run(TakeOutCommand, (covering, "Face1"))
    assert len(shell.Net.RemovedPanels) == 1 and shell.Net.PanelCount < panels - 1, report_view()
    assert shell.isValid() and covering.isValid()


def test_what_would_leave_nothing_is_taken_back_and_told(shell):
    run(TakeOutCommand, *((shell, f"Edge{k + 1}") for k in range(shell.Net.MemberCount)))
    assert not shell.Net.RemovedMembers and shell.isValid()
    assert "every member was taken out" in report_view()
    press("Close")
    run(RaiseCommand, (shell, "Edge3"))
    assert "no node is picked" in report_view()
    press("Close")
