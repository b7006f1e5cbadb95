# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the colours of members stand for; what the mouse reads of them; reactions as arrows."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
from funicular import quantities
from funicular.features.form_of import form_of
from funicular.gui.drawing.on_screen import OnScreen
from funicular.make import make_gridshell
from window import (
    child,
    QtCore,
    QtGui,
    QtWidgets,
    colours_of,
    legends,
    panel_box,
    press,
    session_of,
    settle,
    type_into,
    wait_for_rest,
    wait_until,
)

NEEDS_SECTION = ("Stress", "Utilisation")


@pytest.fixture
def shell(roof):
    """A gridshell on a roof, computed, its panel closed, seen from above and aside."""
    roof.Visibility = False
    shell = make_gridshell(
        roof.Document,
        source=(roof, ["Face1"]),
        StepU="500 mm",
        StepV="500 mm",
        SupportRecipe="Corners",
        SectionWidth="50 mm",
        CompressiveStrength=6,
        YoungsModulus="11 GPa",
    )
    shell.Net.Visibility = False
    roof.Document.recompute()
    assert shell.Status == "converged", shell.Summary
    view().viewIsometric()
    view().fitAll()
    settle()
    return shell


@pytest.fixture
def live(shell):
    """The same with its panel open and at rest."""
    shell.ViewObject.Proxy.doubleClicked(shell.ViewObject)
    wait_for_rest(shell)
    view().viewIsometric()
    view().fitAll()
    settle()
    return shell


def view():
    return Gui.ActiveDocument.ActiveView


def coloured(shell):
    return shell.ViewObject.Proxy.coloured


def hover_of(shell):
    return shell.ViewObject.Proxy._panel.hover


def choose(name, value):
    """Choose from a box of the panel, as its list does."""
    panel_box(name).setCurrentText(value)
    settle()


def viewport():
    return view().graphicsView().viewport()


def move_mouse(place):
    at = QtCore.QPointF(*map(float, place))
    on_screen = QtCore.QPointF(viewport().mapToGlobal(at.toPoint()))
    event = QtGui.QMouseEvent(
        QtCore.QEvent.MouseMove, at, on_screen, QtCore.Qt.NoButton, QtCore.Qt.NoButton, QtCore.Qt.NoModifier
    )
    QtWidgets.QApplication.sendEvent(viewport(), event)


def places_of(form):
    return OnScreen(view()).of(form.nodes * 1e3)[0]


def child_names(group):
    children = [group.getChild(index) for index in range(group.getNumChildren())]
    return [child.getName().getString() for child in children]


def picture_of(path):
    settle(10)
    view().saveImage(str(path), 1000, 700, "Current")
    return colours_of(path)


@pytest.mark.parametrize("name", [*quantities.QUANTITIES, "None"])
def test_each_colouring_has_the_colours_of_its_numbers(shell, pictures, name):
    vobj = shell.ViewObject
    shell.SectionShape = "Round" if name in NEEDS_SECTION else "None"
    vobj.Colours = name
    shown = np.array([colour[:3] for colour in vobj.LineColorArray])
    seen = picture_of(pictures / f"colours_{name.lower()}.png")
    assert len(seen) > 3
    if name == "None":
        assert len(shown) == 1 and legends(shell.Document) == []
        return
    assert legends(shell.Document) == ["Funicular_legend_Gridshell"]
    values = quantities.QUANTITIES[name].of(form_of(shell), coloured(shell).colouring.section)
    assert len(shown) == len(values) == shell.Net.MemberCount
    # FreeCAD keeps each channel in eight bits.
    assert np.abs(shown - coloured(shell).scale.colours()).max() <= 0.5 / 255 + 1e-6
    ends = shown[[values.argmin(), values.argmax()]]
    assert name == "Slack" or np.abs(ends[0] - ends[1]).max() > 0.2, "the ends of the range differ"


def test_stress_without_a_section_is_grey_and_says_what_it_needs(shell, pictures):
    shell.ViewObject.Colours = "Stress"
    (grey,) = {
        tuple(round(channel, 2) for channel in colour[:3]) for colour in shell.ViewObject.LineColorArray
    }
    assert max(grey) - min(grey) < 0.01
    assert "section" in coloured(shell).missing
    picture_of(pictures / "colours_needs_section.png")
    shell.SectionShape = "Round"
    assert coloured(shell).scale is not None and len(shell.ViewObject.LineColorArray) > 100
    shell.SectionWidth = 0
    assert "SectionWidth" in coloured(shell).missing


def test_a_fixed_range_holds_whatever_the_forces(shell, pictures):
    vobj = shell.ViewObject
    least = min(shell.MemberForces)
    vobj.FixedRange, vobj.ForceFrom, vobj.ForceTo = True, App.Units.Quantity(f"{least / 2} N"), 0
    scale = coloured(shell).scale
    assert (scale.low, scale.high) == (pytest.approx(least / 2), 0.0) and scale.is_beyond_low
    picture_of(pictures / "colours_fixed_range.png")
    shell.CoveringWeight = "90 kg/m^2"
    shell.Document.recompute()
    assert min(shell.MemberForces) < least
    assert coloured(shell).scale.low == pytest.approx(least / 2)


def test_a_file_of_before_is_read_with_its_colours_off(shell, tmp_path):
    vobj = shell.ViewObject
    # As it was called, when there was only one quantity to colour by.
    vobj.removeProperty("Colours")
    vobj.addProperty("App::PropertyBool", "ColourByForce", "Gridshell")
    vobj.ColourByForce = False
    path = str(tmp_path / "before.FCStd")
    shell.Document.saveAs(path)
    App.closeDocument(shell.Document.Name)
    document = App.openDocument(path)
    settle()
    try:
        vobj = document.getObject("Gridshell").ViewObject
        assert vobj.Colours == "None" and "ColourByForce" not in vobj.PropertiesList
        assert len(vobj.LineColorArray) == 1 and legends(document) == []
    finally:
        App.closeDocument(document.Name)


def test_the_panel_colours_what_moves_and_the_legend_follows(live, pictures):
    panel_box("SectionColoursAndReadings").click()
    choose("Colours", "Length")
    before = coloured(live).scale
    assert before.quantity is quantities.LENGTH
    live.CoveringWeight = "200 kg/m^2"
    session_of(live).change()
    wait_for_rest(live)
    scale = coloured(live).scale
    assert scale.high > 1.001 * before.high, "heavier, longer"
    assert scale.high == pytest.approx(session_of(live).form.member_lengths.max())
    assert max(live.MemberForces) < 0, "of the document nothing has changed"
    live.SectionShape = "Rectangular"
    for name in ("FixedRange", "ShowReactions"):
        panel_box(name).click()
    panel_box("SectionNet").click()
    panel_box("SectionMoreOfTheNet").click()
    panel_box("SectionWeights").click()
    panel_box("SectionMembersAndSupports").click()
    panel_box("SectionSolution").click()
    wait_until(lambda: child(QtWidgets.QWidget, "SectionHeight") is not None, "the size of the section")
    below = panel_box("ShowReactions")
    scrolls = below.parentWidget()
    while not isinstance(scrolls, QtWidgets.QScrollArea):
        scrolls = scrolls.parentWidget()
    scrolls.ensureWidgetVisible(below)
    settle(10)
    assert Gui.getMainWindow().screen().grabWindow(0).save(str(pictures / "colours_panel.png"))
    press("Cancel")
    assert live.ViewObject.Colours == "Force" and coloured(live).scale.quantity is quantities.FORCE
    assert len(live.ViewObject.LineColorArray) == len(live.MemberForces)


def test_a_section_by_hand_solves_nothing(live):
    panel_box("SectionColoursAndReadings").click()
    moment = session_of(live).moment
    choose("Colours", "Utilisation")
    assert "section" in panel_box("ColoursSay").text()
    choose("SectionShape", "Rectangular")
    type_into(panel_box("SectionHeight"), "70 mm")
    wait_until(lambda: coloured(live).scale is not None, "a scale")
    section = coloured(live).colouring.section
    assert (section.width, section.height, section.strength) == pytest.approx((0.05, 0.07, 6e6))
    assert not [
        box
        for box in QtWidgets.QApplication.allWidgets()
        if box.objectName() == "ColoursSay" and box.isVisible()
    ]
    assert session_of(live).moment is moment and session_of(live).is_settled
    type_into(panel_box("SectionHeight"), "0 mm")
    wait_until(lambda: coloured(live).scale is None, "no scale")
    wait_until(lambda: "SectionHeight" in panel_box("ColoursSay").text(), "what is wrong")
    press("Cancel")
    assert live.SectionShape == "None"


def test_a_range_by_hand_begins_as_that_of_the_members(live):
    panel_box("SectionColoursAndReadings").click()
    least = min(session_of(live).form.member_forces)
    panel_box("FixedRange").click()
    settle()
    assert coloured(live).scale.low == pytest.approx(least)
    type_into(panel_box("ForceFrom"), "-2 kN")
    assert live.ViewObject.ForceFrom.getValueAs("N").Value == pytest.approx(-2000)
    assert coloured(live).scale.low == pytest.approx(-2000)
    press("Ok")
    assert live.ViewObject.FixedRange and coloured(live).scale.low == pytest.approx(-2000)


def test_the_mouse_reads_a_member_and_a_node(live, pictures):
    live.SectionShape = "Round"
    form = session_of(live).form
    places, hover = places_of(form), hover_of(live)
    inside = np.linalg.norm(places - np.array([viewport().width(), viewport().height()]) / 2, axis=1)
    member = int(np.argmin(inside[form.members].max(axis=1)))
    begin, end = places[form.members[member]]
    move_mouse((begin + end) / 2)
    wait_until(lambda: hover.on is not None, "something under the mouse")
    assert hover.on[0] == "member"
    member = hover.on[1]
    length = 1e3 * form.member_lengths[member]
    lines = hover.words.split("\n")
    assert lines[0] == f"Member {member}" and lines[1] == f"Length {length:.0f} mm"
    assert lines[2].startswith("Force −") and lines[2].endswith("compression")
    stress = form.member_forces[member] / (np.pi * 25.0**2)
    assert lines[3] == f"Stress −{abs(stress):.2f} MPa"
    assert lines[4].startswith("Utilisation ") and "%" in lines[4]
    assert QtWidgets.QToolTip.text() == hover.words
    settle(10)
    assert Gui.getMainWindow().screen().grabWindow(0).save(str(pictures / "hover_member.png"))
    held = int(np.argmax(form.reactions[:, 2]))
    move_mouse(places[held])
    wait_until(lambda: hover.on == ("node", held), "a node under the mouse")
    assert "Height 0" in hover.words and "Reaction " in hover.words and "upward" in hover.words
    settle(10)
    assert Gui.getMainWindow().screen().grabWindow(0).save(str(pictures / "hover_node.png"))
    move_mouse((3, viewport().height() - 3))
    wait_until(lambda: hover.on is None, "nothing under the mouse")
    assert hover.words == ""


def test_reactions_are_arrows_in_the_panel_and_after_it(live, pictures):
    panel_box("SectionColoursAndReadings").click()
    root = live.ViewObject.RootNode
    assert "Funicular_reactions" not in child_names(root)
    panel_box("ShowReactions").click()
    settle()
    assert "Funicular_reactions" in child_names(root)
    form = session_of(live).form
    largest = np.linalg.norm(form.reactions, axis=1).max()
    assert f"{largest / 1e3:.1f} kN" in panel_box("LargestReaction").text()
    view().fitAll()
    seen = picture_of(pictures / "reactions.png")
    green = sum(count for (r, g, b), count in seen.items() if g > r + 60 and g > b + 40)
    assert green > 100
    press("Ok")
    assert child_names(root).count("Funicular_reactions") == 1
    assert not {"Funicular_hover", "Funicular_drawing"} & set(child_names(root))
    live.ViewObject.Visibility = False
    assert "Funicular_reactions" not in child_names(root)
    live.ViewObject.Visibility = True
    live.ViewObject.ShowReactions = False
    assert "Funicular_reactions" not in child_names(root)
