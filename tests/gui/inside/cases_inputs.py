# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inputs of the panel that are there for some nets only, and what things cost, told beside them."""

import pytest
from funicular.gui.inputs import SECTIONS
from window import (
    QtCore,
    QtWidgets,
    child,
    edit_again,
    panel_box,
    press,
    result_line,
    settle,
    type_into,
    wait_for_result,
    wait_until,
)


def test_a_net_of_equal_lengths_has_its_own_inputs(opened):
    laying = panel_box("Laying")
    assert {"StepV", "Pattern"} <= visible_inputs() and "Start" not in visible_inputs()
    before = result_line()
    laying.setCurrentIndex(laying.findText("Equal lengths"))
    settle()
    assert "Start" in visible_inputs() and not {"StepV", "Pattern"} & visible_inputs()
    assert wait_for_result(before).startswith("✔")
    before = result_line()
    type_into(
        panel_box("Start").findChildren(QtWidgets.QDoubleSpinBox)[0], "0,4" if decimal_comma() else "0.4"
    )
    assert opened.Net.Start.x == pytest.approx(0.4) and opened.Net.Start.y == pytest.approx(0.5)
    type_into(panel_box("MostShear"), "50")
    wait_for_result(before)
    assert opened.Net.MostShear.Value == pytest.approx(50)
    press("Cancel")


def visible_inputs():
    names = {name for _, rows in SECTIONS for _, name, _ in rows}
    widgets = QtWidgets.QApplication.allWidgets()
    return {widget.objectName() for widget in widgets if widget.isVisible()} & names


def decimal_comma():
    return QtCore.QLocale().decimalPoint() == ","


def test_a_pattern_can_be_shifted_on_its_face(opened):
    before, places = result_line(), opened.Net.SourceNodes
    type_into(panel_box("OffsetU"), "0,5" if decimal_comma() else "0.5")
    wait_for_result(before)
    assert opened.Net.OffsetU == pytest.approx(0.5) and opened.Net.SourceNodes != places


def test_a_mesh_file_has_its_own_inputs(document, tmp_path):
    from funicular.make import make_gridshell

    path = tmp_path / "sheet.obj"
    rows = [f"v {x} {y} 0" for x in range(5) for y in range(5)]
    rows += [f"vt {x / 4} {y / 4}" for x in range(5) for y in range(5)]
    quads = [[5 * x + y + 1 + k for k in (0, 5, 6, 1)] for x in range(4) for y in range(4)]
    rows += ["f " + " ".join(f"{corner}/{corner}" for corner in quad) for quad in quads]
    path.write_text("\n".join(rows))
    shell = make_gridshell(document, File=str(path), SupportRecipe="Corners")
    document.recompute()
    before = edit_again(shell)
    assert shell.Net.NodeCount == 25 and panel_box("FileUnit").isVisible() and panel_box("Weld").isVisible()
    type_into(panel_box("StepU"), "500 mm")
    panel_box("Resampled").setChecked(True)
    wait_for_result(before)
    assert shell.Net.NodeCount == 9 * 5
    press("Ok")


def label(name):
    return child(QtWidgets.QLabel, name)


def test_the_price_of_an_accuracy_is_told_beside_it(opened, pictures):
    wait_until(lambda: "of the smooth form: step" in (label("PriceTag").text() or ""), "a price")
    about, overall = label("PriceTag").text().split("\n")
    assert about.startswith("about ") and overall.startswith("Within 1 mm of the smooth form: step ")
    assert label("PriceTag").height() >= label("PriceTag").heightForWidth(label("PriceTag").width())
    type_into(panel_box("Accuracy"), "20 mm")
    wait_until(lambda: label("PriceTag").text().split("\n")[-1].startswith("Within 20 mm of"), "a new price")
    label("PriceTag").parentWidget().grab().save(str(pictures / "panel_with_price.png"))
    panel_box("Method").setCurrentText("Newton")
    wait_until(lambda: label("PriceTag").text() == "", "no price for another method")
    press("Ok")


def test_what_effects_cost_is_told_at_the_press_of_a_button(opened, pictures):
    before = result_line()
    type_into(panel_box("Snow"), "0.8 kN/m²")
    wait_for_result(before)
    child(QtWidgets.QPushButton, "EffectCosts").click()
    wait_until(lambda: label("EffectList") and "Snow: " in label("EffectList").text(), "what effects cost")
    told = label("EffectList").text().split("\n")
    assert len(told) == 4 and all("calls" in line for line in told)
    assert "Without it" in told[-1] and "the shape moves by" in told[-1]
    assert child(QtWidgets.QPushButton, "EffectCosts").isEnabled()
    settle()
    panel_box("StepU").parentWidget().grab().save(str(pictures / "panel_with_effects.png"))
    before = result_line()
    type_into(panel_box("Snow"), "0.1 kN/m²")
    wait_for_result(before)
    assert label("EffectList") is None, "of the scene before"
    child(QtWidgets.QPushButton, "EffectCosts").click()
    press("Cancel")
