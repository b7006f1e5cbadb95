# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel while the form moves: motion, pause, sliders, warnings, alternatives, matched lengths."""

import threading

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
from funicular.features.variants import variants_of
from window import (
    QtCore,
    QtGui,
    QtWidgets,
    child,
    clear_report_view,
    close_panel,
    edit_again,
    names,
    panel_box,
    press,
    press_key,
    report_view,
    result_line,
    run_command,
    select_faces,
    session_of,
    settle,
    type_into,
    wait_for_rest,
    wait_for_result,
    wait_until,
)


def click(kind, name):
    button = child(kind, name)
    assert button is not None and button.isEnabled(), f"{name} cannot be pressed"
    button.click()
    settle()


def text_of(name):
    label = child(QtWidgets.QLabel, name)
    return label.text() if label else ""


def drawings(shell):
    """Names of what is drawn below a gridshell beside its shape."""
    root = shell.ViewObject.RootNode
    found = [root.getChild(index).getName().getString() for index in range(root.getNumChildren())]
    return [name for name in found if name.startswith("Funicular")]


class Watch:
    """Every form that is shown."""

    def __init__(self, shell):
        self._session = session_of(shell)
        self.heights = []
        self._session.moved.connect(self._moved)

    def _moved(self):
        self.heights.append(float(self._session.form.nodes[:, 2].max()))


def picture(path):
    assert Gui.getMainWindow().screen().grabWindow(0).save(str(path))


@pytest.fixture
def sheet(document):
    """The panel of a flat sheet on its corners, which rises farther than a roof does."""
    run_command("Funicular_Sheet")
    return document.getObject("Gridshell")


def test_the_net_is_seen_to_rise_and_settles(sheet, pictures):
    watch = Watch(sheet)
    wait_until(lambda: watch.heights and watch.heights[-1] > 0.5, "the net on its way")
    picture(pictures / "live_rising.png")
    wait_for_rest(sheet)
    heights = watch.heights
    # How many frames there are is the machine's; that they are at an even pace is tested by the pace itself.
    assert heights[0] < 0.9 * heights[-1], "it is seen on its way"
    assert heights == sorted(heights), "without overshoot"
    assert result_line().startswith("✔")
    picture(pictures / "live_settled.png")
    press("Cancel")


def test_an_existing_one_rises_again_and_nothing_is_written(opened):
    press("Ok")
    positions, steps = opened.NodePositions, opened.Document.UndoCount
    Gui.Selection.clearSelection()
    opened.ViewObject.Proxy.doubleClicked(opened.ViewObject)
    watch = Watch(opened)
    wait_for_rest(opened)
    assert len(watch.heights) > 3
    assert opened.NodePositions == positions and "Touched" not in opened.State
    press("Cancel")
    assert opened.NodePositions == positions and opened.Document.UndoCount == steps


def test_pause_step_resume_and_restart(sheet, pictures):
    session = session_of(sheet)
    # Of which there are enough steps to be seen.
    click(QtWidgets.QCheckBox, "RelaxSlowly")
    click(QtWidgets.QToolButton, "Pause")
    assert session.is_paused
    wait_until(lambda: not session._live.is_running and session.moment is not None, "the pause")
    counts = []
    for _ in range(3):
        before = session.moment
        click(QtWidgets.QToolButton, "Step")
        wait_until(lambda: session.moment is not before, "a step")
        counts.append(session.moment.result.iterations)
    assert counts == sorted(set(counts)) and "Paused" in result_line()
    picture(pictures / "live_paused.png")
    click(QtWidgets.QCheckBox, "RelaxSlowly")
    assert not session.is_paused, "what is asked for begins"
    wait_for_rest(sheet)
    assert result_line().startswith("✔")
    click(QtWidgets.QToolButton, "Pause")
    click(QtWidgets.QToolButton, "Pause")
    assert not session.is_paused
    watch = Watch(sheet)
    click(QtWidgets.QToolButton, "Restart")
    wait_until(lambda: watch.heights, "a frame")
    assert watch.heights[0] < 0.3 * session.moment.result.nodes[:, 2].max(), "from the source"
    wait_for_rest(sheet)
    press("Cancel")


def test_relax_slowly(document):
    from funicular.make import make_gridshell

    sheet = make_gridshell(document, Width="3 m", Depth="3 m", StepU="500 mm", StepV="500 mm")
    document.recompute()
    edit_again(sheet)
    fast = wait_for_rest(sheet).nodes
    watch = Watch(sheet)
    click(QtWidgets.QCheckBox, "RelaxSlowly")
    wait_until(lambda: len(watch.heights) > 10, "frames")
    assert session_of(sheet).moment.result.iterations > 0
    slow = wait_for_rest(sheet).nodes
    assert session_of(sheet).moment.result.method == "relaxation"
    assert np.abs(slow - fast).max() < 3e-3, "it comes to the same"
    press("Cancel")


def test_the_view_and_the_panel_can_be_used_meanwhile(sheet):
    session = session_of(sheet)
    click(QtWidgets.QCheckBox, "RelaxSlowly")
    view = Gui.ActiveDocument.ActiveView
    for turn in (view.viewTop, view.viewFront, view.viewIsometric, view.fitAll):
        before = len(session.frame_seconds)
        turn()
        panel_box("CoveringWeightSlider").setValue(panel_box("CoveringWeightSlider").value() + 5)
        wait_until(lambda: len(session.frame_seconds) > before + 1, "frames go on")
    press("Cancel")


@pytest.mark.parametrize("side", ["4900 mm", "9900 mm"])
def test_frames_are_short(document, side):
    """Of processor time, which other programs on the machine do not lengthen: the median of a drag."""
    from funicular.make import make_gridshell

    shell = make_gridshell(document, Width=side, Depth=side, StepU="100 mm", StepV="100 mm")
    document.recompute()
    edit_again(shell)
    wait_for_rest(shell)
    assert shell.Net.NodeCount in (2500, 10000)
    session = session_of(shell)
    session.frame_seconds.clear()
    slider = panel_box("CoveringWeightSlider")
    for value in range(20, 120, 5):
        slider.setValue(value)
        settle(1)
    wait_for_rest(shell)
    frames = np.array(session.frame_seconds)
    assert len(frames) > 10
    assert np.median(frames) < 0.05
    press("Cancel")


def test_a_slider_is_followed_at_once_and_reset_brings_back(sheet):
    low = wait_for_rest(sheet).nodes[:, 2].max()
    slider = panel_box("CoveringWeightSlider")
    watch = Watch(sheet)
    slider.setValue(slider.maximum())
    assert float(sheet.CoveringWeight.getValueAs("kg/m^2")) == pytest.approx(120.0)
    assert panel_box("CoveringWeight").text() == "120 kg/m²"
    assert wait_for_rest(sheet).nodes[:, 2].max() > 1.1 * low
    assert watch.heights[0] > 0.9 * low, "from the present shape"
    click(QtWidgets.QToolButton, "CoveringWeightReset")
    assert panel_box("CoveringWeight").text() == "30 kg/m²"
    assert wait_for_rest(sheet).nodes[:, 2].max() == pytest.approx(low, abs=2e-3)
    assert child(QtWidgets.QToolButton, "CoveringWeightReset") is None, "nothing to bring back"
    press("Cancel")


@pytest.mark.parametrize("name", ["MemberWeight", "CoveringWeight", "Snow", "AxialStiffness", "Accuracy"])
def test_every_amount_has_a_slider_of_sensible_range(sheet, name):
    wait_for_rest(sheet)
    slider, value = panel_box(f"{name}Slider"), getattr(sheet, name)
    assert slider.minimum() < slider.value() < slider.maximum() or value.Value == 0.0
    for place in (slider.maximum(), slider.minimum(), slider.maximum() // 2):
        slider.setValue(place)
        settle()
        assert np.isfinite(getattr(sheet, name).Value)
        type_back = getattr(sheet, name)
        slider.setValue(place)
        assert getattr(sheet, name) == type_back, "a slider that stays sets nothing"
    assert wait_for_result("").startswith(("✔", "✖"))
    press("Cancel")


def test_warnings_have_buttons_that_mend(opened, pictures):
    sheet = opened
    # Lower than they would be without: members that are too long for the flat form they are held in.
    sheet.AxialStiffness, sheet.Net.Pattern = "100 MN", "Triangle"
    session_of(sheet).change()
    wait_for_rest(sheet)
    before = result_line()
    panel_box("AllowTension").click()
    wait_until(lambda: "in tension" in text_of("Warning0"), "a warning")
    assert wait_for_result(before).startswith("⚠")
    click(QtWidgets.QPushButton, "Warning0_show")
    shown = session_of(sheet).moment.certificate.tension_members
    assert len(shown) and list(panel_of(sheet).drawing.highlight._members) == list(shown)
    Gui.ActiveDocument.ActiveView.viewIsometric()
    Gui.ActiveDocument.ActiveView.fitAll()
    picture(pictures / "live_warning.png")
    click(QtWidgets.QPushButton, "Warning0_compression")
    assert not sheet.AllowTension
    wait_until(lambda: result_line().startswith("✔"), "compression only again")
    type_into(panel_box("AxialStiffness"), "5 N")
    wait_until(lambda: "cannot carry" in text_of("Warning0"), "a warning")
    click(QtWidgets.QPushButton, "Warning0_stiffen")
    assert float(sheet.AxialStiffness.getValueAs("N")) == pytest.approx(50.0)
    press("Cancel")


def panel_of(shell):
    return shell.ViewObject.Proxy._panel


def test_slack_members_can_be_left_out(sheet):
    wait_for_rest(sheet)
    slack = len(session_of(sheet).moment.certificate.slack_members)
    if not slack:
        type_into(panel_box("AxialStiffness"), "100000 kN")
        wait_until(lambda: "slack" in text_of("Warning0"), "a warning")
        slack = len(session_of(sheet).moment.certificate.slack_members)
    members = sheet.Net.MemberCount
    click(QtWidgets.QPushButton, "Warning0_leave_out")
    wait_until(lambda: sheet.Net.MemberCount < members, "a net without them")
    wait_for_rest(sheet)
    left = sheet.Net.MemberCount
    wait_until(lambda: child(QtWidgets.QPushButton, "Warning0_take_back") is not None, "a way back")
    click(QtWidgets.QPushButton, "Warning0_take_back")
    wait_for_rest(sheet)
    assert sheet.Net.MemberCount == members
    click(QtWidgets.QPushButton, "SupportUndo")
    wait_for_rest(sheet)
    assert sheet.Net.MemberCount == left
    press("Ok")
    assert sheet.Status == "converged" and len(sheet.MemberForces) == sheet.Net.MemberCount


def test_alternatives_are_kept_seen_compared_and_restored(sheet, pictures):
    low = wait_for_rest(sheet).nodes
    click(QtWidgets.QToolButton, "SectionAlternatives")
    click(QtWidgets.QPushButton, "KeepThis")
    panel_box("CoveringWeightSlider").setValue(150)
    high = wait_for_rest(sheet).nodes
    click(QtWidgets.QPushButton, "KeepThis")
    kept = variants_of(sheet)
    assert [variant.name for variant in kept] == ["Variant 1", "Variant 2"]
    for variant in kept:
        image = QtGui.QImage.fromData(QtCore.QByteArray(variant.thumbnail))
        ink = [
            (x, y)
            for x in range(image.width())
            for y in range(image.height())
            if image.pixelColor(x, y) != QtGui.QColor("white")
        ]
        assert (
            min(min(at) for at in ink) > 0 and max(x for x, _ in ink) < image.width() - 1
        ), "all of the form"
        assert max(x for x, _ in ink) - min(x for x, _ in ink) > 0.8 * image.width()
    strip = panel_box("Variants")
    strip.item(0).setSelected(True)
    settle()
    assert session_of(sheet).form.nodes == pytest.approx(low, abs=1e-5), "seen at once"
    assert result_line().startswith("… Variant 1 is shown") and not panel_of(sheet).supports.marks.is_shown
    press_key(strip, QtCore.Qt.Key_Escape)
    settle()
    assert Gui.Control.activeDialog(), "Esc returns to the present form alone"
    assert session_of(sheet).form.nodes == pytest.approx(high, abs=1e-9)
    assert result_line().startswith("✔") and panel_of(sheet).supports.marks.is_shown
    strip.item(0).setSelected(True), strip.item(1).setSelected(True)
    press_key(strip, QtCore.Qt.Key_Escape)
    assert Gui.Control.activeDialog() and not strip.selectedItems(), "nor does it with two"
    strip.item(0).setSelected(True), strip.item(1).setSelected(True)
    settle()
    table = panel_box("VariantNumbers")
    assert [table.horizontalHeaderItem(k).text() for k in range(3)] == ["Variant 1", "Variant 2", "change"]
    assert table.item(0, 2).text().startswith("+") and table.item(1, 2).text().startswith("+")
    for scroll in QtWidgets.QApplication.allWidgets():
        if isinstance(scroll, QtWidgets.QScrollArea) and scroll.isVisible() and scroll.isAncestorOf(table):
            scroll.ensureWidgetVisible(table)
    settle()
    picture(pictures / "live_alternatives.png")
    strip.clearSelection()
    strip.item(0).setSelected(True)
    click(QtWidgets.QPushButton, "RestoreVariant")
    assert panel_box("CoveringWeight").text() == "30 kg/m²"
    assert wait_for_rest(sheet).nodes == pytest.approx(low, abs=2e-3)
    strip.item(1).setText("Tall")
    settle()
    assert [variant.name for variant in variants_of(sheet)] == ["Variant 1", "Tall"]
    press("Ok")
    assert [variant.name for variant in variants_of(sheet)] == ["Variant 1", "Tall"]
    assert sheet.Document.UndoCount == 1, "all of it is one step"


def test_lengths_are_matched_and_ok_writes_what_was_seen(sheet):
    wait_for_rest(sheet)
    click(QtWidgets.QPushButton, "MatchLengths")
    wait_until(lambda: "best reached after" in text_of("MatchingResult"), "matched lengths")
    before, after = (float(word.split()[-1]) for word in text_of("MatchingResult").split(" %")[:2])
    assert after < 0.5 * before
    seen = wait_for_rest(sheet).nodes
    press("Ok")
    written = np.array([tuple(node) for node in sheet.NodePositions]) * 1e-3
    assert sheet.LengthMatching > 0
    assert written == pytest.approx(seen, abs=4e-3)
    assert 100 * sheet.LengthDeviation == pytest.approx(after, rel=0.2)
    edit_again(sheet)
    wait_until(lambda: "best reached after" in text_of("MatchingResult"), "matched again")
    click(QtWidgets.QPushButton, "UndoMatching")
    assert sheet.LengthMatching == 0
    wait_until(lambda: "on the source by" in text_of("MatchingResult"), "unmatched lengths")
    assert np.abs(wait_for_rest(sheet).nodes - seen).max() > 10e-3
    press("Cancel")


@pytest.mark.parametrize("end", ["Ok", "Cancel", "close", "delete", "undo", "source"])
def test_in_mid_run_everything_ends_safely(roof, end):
    document, threads = roof.Document, threading.active_count()
    clear_report_view()
    select_faces(roof, "Face1")
    run_command()
    shell = document.getObject("Gridshell")
    click(QtWidgets.QCheckBox, "RelaxSlowly")
    session = session_of(shell)
    wait_until(lambda: session.form is not None, "motion")
    if end in ("Ok", "Cancel"):
        press(end)
    elif end == "close":
        App.closeDocument(document.Name)
    elif end == "delete":
        document.removeObject("Gridshell")
    elif end == "undo":
        Gui.runCommand("Std_Undo")
    else:
        document.removeObject("Roof")
        type_into(panel_box("StepU"), "400 mm")
        wait_until(lambda: result_line().startswith("✖") and "Source" in result_line(), "a sentence")
        close_panel()
    settle()
    assert not Gui.Control.activeDialog()
    wait_until(lambda: threading.active_count() <= threads, "the end of the thread")
    assert not session._live.is_running
    # That a net cannot be computed FreeCAD itself tells with all that it knows.
    assert end == "source" or "Traceback" not in report_view()
    if end == "Ok":
        assert shell.Status == "converged" and drawings(shell) == []
        assert shell.ViewObject.SwitchNode.whichChild.getValue() >= 0, "its own shape is seen again"
    elif end in ("Cancel", "undo"):
        assert names(document) == ["Roof"]


def test_nothing_runs_at_rest(opened):
    wait_for_rest(opened)
    session = session_of(opened)
    frames = len(session.frame_seconds)
    QtCore.QThread.msleep(200)
    settle()
    assert len(session.frame_seconds) == frames and not session._timer.isActive()
    assert not session._live.is_running


def test_the_strip_chart_tells_how_it_went(sheet):
    wait_for_rest(sheet)
    chart = child(QtWidgets.QWidget, "StripChart")
    words = chart.accessibleName()
    assert "residual" in words and "ms" in words or " s" in words
    shades = set()
    image = chart.grab().toImage()
    for x in range(0, image.width(), 2):
        for y in range(0, image.height(), 1):
            shades.add(image.pixelColor(x, y).name())
    assert any(is_near(shade, "#d9822b") for shade in shades), "the distance is drawn"
    assert any(is_near(shade, "#4a90d9") for shade in shades), "the residual is drawn"
    assert result_line().startswith("✔ Compression only") and "balanced to" in result_line()
    press("Cancel")


def is_near(one, other):
    parts = zip(*(tuple(int(name[k : k + 2], 16) for k in (1, 3, 5)) for name in (one, other)))
    return max(abs(a - b) for a, b in parts) < 25
