# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock that measures what accuracy costs: rows as they come, a click on one, Cancel, ways to go."""

import threading

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from funicular.accuracy import ACCURACIES, METHODS
from funicular.gui import accuracy_dock
from funicular.gui.accuracy_plot import row_in_words
from funicular.gui.lengths import length_in_words
from funicular.gui.commands import COMMANDS
from funicular.make import make_gridshell
from window import (
    QtCore,
    QtGui,
    QtWidgets,
    child,
    clear_report_view,
    press,
    report_view,
    run_command,
    settle,
    wait_until,
)

STUDY = "Funicular_AccuracyStudy"
ALL = len(METHODS) * len(ACCURACIES)


def dock():
    return child(QtWidgets.QDockWidget, "FunicularAccuracy")


def line():
    return child(QtWidgets.QLabel, "AccuracyLine").text()


def button(name):
    return child(QtWidgets.QPushButton, name)


def plot():
    return child(QtWidgets.QWidget, "AccuracyPlot")


def threads():
    return [thread for thread in threading.enumerate() if thread.name == "Funicular accuracy study"]


def nothing_is_left():
    """Whether no thread runs, and a change of the document reaches no dock."""
    made = accuracy_dock._dock
    return not threads() and not made._poll.isActive() and made._shell is None


@pytest.fixture
def shell(document):
    """A small sheet that every method solves in milliseconds."""
    shell = make_gridshell(document, Width="4 m", Depth="3 m", StepU="500 mm", StepV="500 mm")
    document.recompute()
    document.clearUndos()
    yield shell
    if dock():
        dock().close()
    wait_until(lambda: not threads(), "the end of the thread")


@pytest.fixture
def slow(shell):
    """The same with so many nodes that relaxation goes on for minutes."""
    shell.Net.StepU = shell.Net.StepV = "125 mm"
    shell.SupportRecipe, shell.MaxSeconds = "Corners", 300.0
    shell.Document.recompute()
    assert shell.Status == "converged", shell.Summary
    return shell


def open_dock(shell):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(shell)
    settle()
    assert Gui.isCommandActive(STUDY)
    run_command(STUDY)


def measured(shell):
    """The rows, once all are there."""
    open_dock(shell)
    wait_until(lambda: "Click a point" in line(), "the end of the study")
    return dock()._rows


def mouse(kind, row, button, buttons):
    place = QtCore.QPointF(plot().place_of(row))
    event = QtGui.QMouseEvent(kind, place, button, buttons, QtCore.Qt.NoModifier)
    QtWidgets.QApplication.sendEvent(plot(), event)


def click(row):
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    mouse(QtCore.QEvent.MouseMove, row, none, none)
    mouse(QtCore.QEvent.MouseButtonPress, row, left, left)
    mouse(QtCore.QEvent.MouseButtonRelease, row, left, none)
    settle()


def tooltip_over(row):
    mouse(QtCore.QEvent.MouseMove, row, QtCore.Qt.NoButton, QtCore.Qt.NoButton)
    return QtWidgets.QToolTip.text()


def ring():
    """(distance, time) of the marked point, None if none is."""
    rings = [each for each in plot().figure.axes[0].lines if each.get_markersize() == 15]
    assert len(rings) <= 1
    return (*rings[0].get_xdata(), *rings[0].get_ydata()) if rings else None


def row_of(rows, method, accuracy):
    (row,) = [row for row in rows if (row["method"], row["accuracy"]) == (method, accuracy)]
    return row


def place(row):
    return row["true_error"], row["seconds"]


def test_rows_come_while_the_window_lives(shell, pictures):
    clear_report_view()
    seen = []
    ticks = QtCore.QTimer()
    ticks.timeout.connect(lambda: seen.append(len(dock()._rows)) if dock() else None)
    ticks.start(5)
    rows = measured(shell)
    ticks.stop()
    assert seen == sorted(seen) and len(set(seen)) > ALL // 2, "the rows are seen one by one"
    assert [(row["method"], row["accuracy"]) for row in rows] == [(m, a) for m in METHODS for a in ACCURACIES]
    assert ring() == place(row_of(rows, "auto", 1e-3)), "the gridshell's own accuracy is marked"
    assert shell.Document.UndoCount == 0 and report_view() == ""
    assert not button("CancelStudy").isEnabled() and button("SaveStudy").isEnabled()
    for label in dock().findChildren(QtWidgets.QLabel):
        assert label.height() >= label.heightForWidth(label.width()), f"cut off: {label.text()}"
    # The last point of its line, which no other comes near to.
    row = row_of(rows, "relaxation", 1e-6)
    assert tooltip_over(row) == row_in_words(row) and row_in_words(row).startswith("1 µm by Relaxation: ")
    settle()
    dock().grab().save(str(pictures / "accuracy.png"))


def test_a_click_chooses_and_undo_takes_it_back(shell):
    rows, document = measured(shell), shell.Document
    chosen = row_of(rows, "relaxation", 1e-4)
    click(chosen)
    assert shell.Accuracy.Value == pytest.approx(0.1, rel=1e-12) and shell.Method == "Relaxation"
    assert shell.Status == "converged" and shell.MethodUsed == "relaxation" and "Touched" not in shell.State
    assert document.UndoNames == ["Accuracy"] and not document.HasPendingTransaction
    assert ring() == place(chosen) and line().startswith("✔") and "Chosen" in line()
    click(chosen)
    assert document.UndoCount == 1 and "has this accuracy" in line()
    document.undo()
    settle()
    assert (shell.Accuracy.Value, shell.Method) == (1.0, "Auto")
    assert ring() == place(row_of(rows, "auto", 1e-3))
    shell.Accuracy = "0.5 mm"
    assert ring() is None, "nobody has measured that"


def test_lengths_are_in_the_user_s_units():
    before = App.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("UserSchema", 0)
    try:
        App.Units.setSchema(3)
        assert length_in_words(1e-3) == "0.0394 in"
        App.Units.setSchema(0)
        assert length_in_words(1e-5) == "10 µm"
    finally:
        App.Units.setSchema(before)


def test_cancel_stops_within_a_solve_and_keeps_the_rows(slow):
    open_dock(slow)
    wait_until(lambda: "by Relaxation" in line(), "the method that goes on for minutes")
    assert "11 of 15" in line()
    slow.Snow = "0.1 kPa"
    button("CancelStudy").click()
    wait_until(lambda: "Cancelled" in line(), "the end of the study")
    assert "has changed since" in line(), "and it tells that its rows are of another load"
    assert len(dock()._rows) == 10 and button("SaveStudy").isEnabled() and not threads()
    click(row_of(dock()._rows, "newton", 1e-5))
    assert slow.Method == "Newton" and slow.Status == "converged"


@pytest.mark.parametrize("how", ["dock", "object", "document", "undo of another"])
def test_it_can_go_while_it_measures(shell, how):
    document = shell.Document
    document.openTransaction("Another")
    another = make_gridshell(document, net=shell.Net)
    document.recompute()
    document.commitTransaction()
    clear_report_view()
    open_dock(shell)
    assert threads()
    if how == "dock":
        dock().close()
    elif how == "object":
        document.removeObject(shell.Name)
    elif how == "document":
        App.closeDocument(document.Name)
    else:
        open_dock(another)
        assert dock().windowTitle() == "What accuracy costs: Gridshell001"
        assert document.UndoNames == ["Another"]
        document.undo()
    wait_until(lambda: not threads(), "the end of the thread")
    assert dock() is None and nothing_is_left()
    if how == "dock":
        shell.Accuracy = "2 mm"
    settle()
    assert report_view() == ""


def test_what_cannot_be_measured_is_a_sentence(shell):
    shell.AxialStiffness = "10 N"
    clear_report_view()
    open_dock(shell)
    wait_until(lambda: line().startswith("✖"), "the error")
    assert "No equilibrium" in line() and "155 N" not in line() and "Traceback" not in report_view()
    assert dock()._rows == [] and not button("SaveStudy").isEnabled()
    shell.AxialStiffness, shell.Accuracy = "100 kN", 0
    button("MeasureAgain").click()
    assert "Accuracy is 0 mm" in line() and report_view() == ""
    shell.Accuracy = 1
    button("MeasureAgain").click()
    wait_until(lambda: "Click a point" in line(), "the end of the study")
    shell.CoveringWeight = "50 kg/m^2"
    assert "has changed since" in line()


def test_it_writes_a_table_and_a_picture(shell, tmp_path, monkeypatch):
    measured(shell)
    table, picture = tmp_path / "roof.csv", tmp_path / "roof.png"
    picture.write_text("theirs")
    paths = iter([str(table), str(table), str(tmp_path / "none" / "roof"), ""])
    answers = iter([QtWidgets.QMessageBox.No, QtWidgets.QMessageBox.Yes])
    monkeypatch.setattr(QtWidgets.QFileDialog, "getSaveFileName", lambda *_: (next(paths), ""))
    monkeypatch.setattr(QtWidgets.QMessageBox, "question", lambda *_: next(answers))
    button("SaveStudy").click()
    assert not table.exists() and picture.read_text() == "theirs"
    button("SaveStudy").click()
    assert {path.name for path in tmp_path.iterdir()} == {"roof.csv", "roof.png"}
    assert len(table.read_text(encoding="utf-8").splitlines()) == ALL + 1
    assert picture.read_bytes().startswith(b"\x89PNG") and "roof.csv and roof.png" in line()
    button("SaveStudy").click()
    assert line().startswith("✖") and "No such file" in line()
    button("SaveStudy").click()


def test_a_choice_that_cannot_be_made_changes_nothing(shell):
    row = row_of(measured(shell), "relaxation", 1e-4)
    Gui.ActiveDocument.setEdit(shell.Name)
    settle()
    click(row)
    assert "Close the panel" in line() and shell.Method == "Auto" and App.getActiveTransaction()
    press("Cancel")
    shell.MaxSeconds = 1e-9
    click(row)
    assert line().startswith("✖") and "MaxSeconds" in line() and "as before" in line()
    assert (shell.Accuracy.Value, shell.Method) == (1.0, "Auto") and shell.Document.UndoCount == 0
    shell.setExpression("Accuracy", "2 mm")
    click(row)
    assert "Accuracy follows the expression" in line() and shell.Method == "Auto"


def test_the_command_waits_for_one_gridshell(shell):
    Gui.Selection.clearSelection()
    assert not Gui.isCommandActive(STUDY)
    Gui.Selection.addSelection(shell.Net)
    assert not Gui.isCommandActive(STUDY)
    COMMANDS[STUDY].Activated()
    settle()
    press("Close")
    assert dock() is None
