# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel while several things happen at once, or with what cannot be solved: what it shows is so."""

import FreeCAD as App
import FreeCADGui as Gui
import hand
import pytest
from cases_live import click, panel_of, sheet, text_of  # noqa: F401 (sheet is a fixture)
from funicular.features.variants import variants_of
from funicular.gui.live import session as session_module
from window import (
    QtCore,
    QtWidgets,
    clear_report_view,
    panel_box,
    press,
    press_key,
    report_view,
    result_line,
    session_of,
    settle,
    type_into,
    wait_for_rest,
    wait_until,
)


def test_matched_lengths_of_what_has_changed_since_are_left(opened):
    wait_for_rest(opened)
    session, found = session_of(opened), panel_of(opened).matching._background._poll
    click(QtWidgets.QPushButton, "MatchLengths")
    wait_until(lambda: text_of("MatchingResult").startswith("Matching"), "rounds")
    found.stop()
    click(QtWidgets.QToolButton, "Pause")
    panel_box("CoveringWeightSlider").setValue(195)
    wait_until(lambda: not (panel_of(opened)._pause.isActive() or session._timer.isActive()), "the change")
    found.start()
    wait_until(lambda: not found.isActive(), "the end of the rounds")
    click(QtWidgets.QToolButton, "Pause")
    wait_until(lambda: "best reached" in text_of("MatchingResult"), "matched lengths")
    wait_for_rest(opened)
    shown = -session.moment.certificate.total_load[2]
    press("Ok")
    assert shown == pytest.approx(float(opened.TotalWeight.getValueAs("N")), rel=1e-3)


def test_buttons_while_the_net_cannot_be_laid(opened):
    wait_for_rest(opened)
    type_into(panel_box("StepU"), "0 mm")
    wait_until(lambda: "StepU is 0 mm" in result_line(), "a sentence")
    click(QtWidgets.QToolButton, "Restart")
    panel_box("AxialStiffnessSlider").setValue(120)
    click(QtWidgets.QCheckBox, "RelaxSlowly")
    assert "StepU is 0 mm" in result_line()
    type_into(panel_box("StepU"), "400 mm")
    click(QtWidgets.QCheckBox, "RelaxSlowly")
    wait_until(lambda: result_line().startswith("✔"), "a form")
    press("Cancel")


def test_a_slider_that_is_nudged_changes_little(sheet):  # noqa: F811
    """Its range is that of the scene, which is not known as the panel comes and changes with each load."""
    wait_for_rest(sheet)
    for name, value in (("CoveringWeight", 195), ("AxialStiffness", None), ("Accuracy", None)):
        slider = panel_box(f"{name}Slider")
        before = getattr(sheet, name).Value
        slider.setValue(slider.value() + 1 if value is None else value)
        if value is None:
            assert 0.8 * before < getattr(sheet, name).Value < 1.25 * before, name
        wait_for_rest(sheet)
    press("Cancel")


def test_a_vast_net_is_laid_once_the_user_has_been_told(opened, monkeypatch):
    wait_for_rest(opened)
    monkeypatch.setattr(session_module, "MOST_NODES", 1500)
    type_into(panel_box("StepU"), "100 mm")
    type_into(panel_box("StepV"), "100 mm")
    wait_until(lambda: "make about 5,900 nodes" in result_line(), "a sentence")
    assert len(session_of(opened).source_net.nodes) == 945
    press_key(panel_box("StepV"), QtCore.Qt.Key_Return)
    assert len(wait_for_rest(opened).nodes) == pytest.approx(5900, rel=0.1)
    press("Cancel")


@pytest.mark.parametrize(
    "name, value", [("Accuracy", 0), ("AxialStiffness", float("inf")), ("Snow", float("nan"))]
)
def test_the_panel_opens_on_what_is_no_amount_and_mends_it(opened, name, value):
    press("Ok")
    setattr(opened, name, value)
    opened.Document.recompute()
    clear_report_view()
    opened.ViewObject.Proxy.doubleClicked(opened.ViewObject)
    wait_until(lambda: result_line().startswith("✖"), "what is wrong")
    assert name in result_line()
    panel_box(f"{name}Slider").setValue(100)
    wait_until(lambda: result_line().startswith("✔"), "a form")
    press("Ok")
    assert opened.Status == "converged"


def test_slack_members_cannot_be_left_out_before_they_are_known(sheet):  # noqa: F811
    wait_for_rest(sheet)
    type_into(panel_box("AxialStiffness"), "100000 kN")
    wait_until(lambda: "slack" in text_of("Warning0"), "a warning")
    wait_for_rest(sheet)
    members = sheet.Net.MemberCount
    click(QtWidgets.QToolButton, "Pause")
    panel_box("CoveringWeightSlider").setValue(150)
    wait_until(lambda: not session_of(sheet).moment.ended, "a solve that waits")
    click(QtWidgets.QPushButton, "Warning0_leave_out")
    assert len(sheet.Net.RemovedMembers), "those that were warned of"
    click(QtWidgets.QToolButton, "Pause")
    wait_until(lambda: sheet.Net.MemberCount < members, "a net without them")
    press("Cancel")


def test_an_alternative_is_what_the_form_has_come_to_and_bears_its_own_forces(sheet):  # noqa: F811
    session, low = session_of(sheet), wait_for_rest(sheet)
    click(QtWidgets.QToolButton, "SectionAlternatives")
    panel_box("CoveringWeightSlider").setValue(195)
    before = session.moment
    wait_until(lambda: session.moment is not before and session.moment.ended, "a solve that has ended")
    click(QtWidgets.QPushButton, "KeepThis")
    type_into(panel_box("CoveringWeight"), "30")
    click(QtWidgets.QPushButton, "KeepThis")
    assert variants_of(sheet) == [] and "settled" in text_of("VariantSays")
    wait_until(lambda: session.is_result, "a form at rest")
    click(QtWidgets.QPushButton, "KeepThis")
    (kept,) = variants_of(sheet)
    assert kept.nodes == pytest.approx(low.nodes, abs=2e-3)
    panel_box("CoveringWeightSlider").setValue(195)
    wait_until(lambda: session.is_result, "a form at rest")
    present, strip, table = session.form, panel_box("Variants"), panel_box_of_numbers()
    strip.item(0).setSelected(True)
    settle()
    seen = session.form
    assert seen.member_forces == pytest.approx(kept.member_forces) and not seen.is_certified
    assert seen.loads() == pytest.approx(low.loads(), abs=1e-2 * abs(low.loads()).max())
    told = table.item(1, 1).text()
    panel_box("CoveringWeightSlider").setValue(100)
    wait_until(lambda: session.is_result, "a form at rest")
    assert not strip.selectedItems(), "the present form is what is seen"
    assert session.form.nodes != pytest.approx(present.nodes, abs=1e-2)
    strip.item(0).setSelected(True)
    settle()
    assert table.item(1, 1).text() not in ("", told)
    press("Cancel")


def panel_box_of_numbers():
    """The table of alternatives, which is there to be seen once one is chosen."""
    return next(
        widget for widget in QtWidgets.QApplication.allWidgets() if widget.objectName() == "VariantNumbers"
    )


def test_restoring_leaves_nothing_of_what_was_before(opened):
    from funicular.make import make_point_load

    wait_for_rest(opened)
    click(QtWidgets.QToolButton, "SectionAlternatives")
    wait_until(lambda: session_of(opened).is_result, "a form at rest")
    click(QtWidgets.QPushButton, "KeepThis")
    press("Ok")
    load = make_point_load(opened.Document, opened, Points=[(0.5, 0.5)])
    opened.Document.recompute()
    name = load.Name
    opened.ViewObject.Proxy.doubleClicked(opened.ViewObject)
    wait_for_rest(opened)
    supports = panel_of(opened).supports
    supports.picks.add([0, 1])
    supports.hold("Fixed")
    assert supports.steps.can_undo
    type_into(panel_box("CoveringWeight"), "heavy")
    wait_until(lambda: "heavy" in result_line(), "a sentence")
    # A change that is still on its way would show the present form again, and then nothing is chosen.
    wait_for_rest(opened)
    variants = panel_box("Variants")
    variants.item(0).setSelected(True)
    settle()
    variants.clearSelection()
    assert "heavy" in result_line(), "it is still unreadable"
    variants.item(0).setSelected(True)
    click(QtWidgets.QPushButton, "RestoreVariant")
    wait_until(lambda: result_line().startswith("✔"), "what was kept")
    assert panel_box("CoveringWeight").text() == "30 kg/m²" and not panel_of(opened)._unreadable
    assert opened.Supports == opened.PointLoads == []
    assert not supports.steps.can_undo, "of supports that there are no more"
    press("Cancel")
    load = opened.Document.getObject(name)
    assert opened.PointLoads == [load] and not load.ViewObject.Proxy.is_led, "its arrows follow the document"


def test_keys_of_another_document_are_its_own(opened):
    wait_for_rest(opened)
    supports = panel_of(opened).supports
    supports.picks.add([0, 1])
    supports.hold("Fixed")
    other = App.newDocument("Other")
    settle()
    hand.shortcut(hand.viewport(), QtCore.Qt.Key_Z)
    assert len(opened.Supports) == 1
    App.closeDocument(other.Name)
    App.setActiveDocument(opened.Document.Name)
    Gui.ActiveDocument = Gui.getDocument(opened.Document.Name)
    settle()
    hand.shortcut(hand.viewport(), QtCore.Qt.Key_Z)
    assert opened.Supports == []
    press("Cancel")


def test_what_cannot_be_edited_leaves_no_transaction_open(opened):
    press("Ok")
    opened.Net = opened.Document.addObject("Part::Box", "Box")
    clear_report_view()
    opened.ViewObject.Proxy.doubleClicked(opened.ViewObject)
    settle()
    assert not Gui.Control.activeDialog() and App.getActiveTransaction() is None
    assert "Net is Box, which is not a Net" in report_view()


def test_what_is_changed_and_recomputed_beside_the_panel_is_followed(opened):
    wait_for_rest(opened)
    before = opened.Net.NodeCount
    opened.Net.StepU, opened.CoveringWeight = "700 mm", "60 kg/m^2"
    opened.Document.getObject("Roof").Placement.Base.z = 5000.0
    opened.Document.recompute()
    assert opened.Net.NodeCount != before
    form = wait_for_rest(opened)
    assert len(form.nodes) == opened.Net.NodeCount and form.nodes[:, 2].min() == pytest.approx(5.0)
    assert panel_box("CoveringWeight").text() == "60 kg/m²"
    type_into(panel_box("StepU"), "400 mm")
    # Before the typing has ended.
    opened.Document.recompute()
    wait_until(lambda: session_of(opened).is_result, "a form at rest")
    assert len(session_of(opened).form.nodes) == opened.Net.NodeCount
    shown = result_line().split("total")[0]
    press("Ok")
    assert opened.Summary.startswith(shown[2:])
