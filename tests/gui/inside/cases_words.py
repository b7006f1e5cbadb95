# SPDX-License-Identifier: LGPL-2.1-or-later
"""What commands and inputs say of themselves, in which language, in which units, and on a dark window."""

import pathlib
import re
import xml.etree.ElementTree as ElementTree

import FreeCAD as App
import FreeCADGui as Gui
import funicular_locate
import hand
import pytest
from funicular.gui import preferences
from funicular.gui.commands import COMMANDS
from window import (
    QtCore,
    QtGui,
    QtWidgets,
    child,
    close_panel,
    command_action,
    edit_again,
    panel_box,
    press,
    result_line,
    run_command,
    settle,
    type_into,
    wait_for_result,
)

GERMAN = QtCore.QLocale(QtCore.QLocale.German, QtCore.QLocale.Germany)
IN_FEET, IN_FEET_AND_INCHES = 7, 5


@pytest.fixture
def language():
    """A function that sets FreeCAD's language, and with it the locale of numbers."""
    before = QtCore.QLocale()

    def choose(name, locale):
        Gui.setLocale(name)
        QtCore.QLocale.setDefault(locale)
        # Widgets take it from those that they stand in; at FreeCAD's start there is none yet.
        Gui.getMainWindow().setLocale(locale)
        settle()

    yield choose
    close_panel()
    choose("English", before)


@pytest.fixture
def schema():
    before = App.Units.getSchema()
    yield App.Units.setSchema
    close_panel()
    App.Units.setSchema(before)


@pytest.fixture
def settings():
    """The parameters of the preferences page, as they were afterwards."""
    group = App.ParamGet(preferences.GROUP)
    yield group
    for name in ("ForceUnit", "Palette", "FrameBudget"):
        group.RemInt(name)
    group.RemFloat("Accuracy")
    group.RemBool("Animate")


def panel():
    """The widget of the open panel; not by way of parentWidget(), or PySide takes its labels for dead."""
    return hand.panel().form


def shown(widget):
    """Visible widgets below a widget."""
    return [
        each for each in QtWidgets.QApplication.allWidgets() if widget.isAncestorOf(each) and each.isVisible()
    ]


def all_below(widget):
    """Widgets below a widget, those in folded sections too."""
    return [each for each in QtWidgets.QApplication.allWidgets() if widget.isAncestorOf(each)]


def picture_of_panel(path):
    """The whole panel, also what would have to be scrolled to."""
    settle()
    panel().grab().save(str(path))


# Commands


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_an_icon_and_explains_itself(workbench, name):
    told = COMMANDS[name].GetResources()
    icon = ElementTree.parse(told["Pixmap"]).getroot()
    assert icon.tag.endswith("svg") and icon.get("viewBox") == "0 0 64 64"
    assert all(told[key] for key in ("MenuText", "ToolTip", "StatusTip", "WhatsThis", "Accel"))
    assert len(told["MenuText"]) <= 20 and len(told["WhatsThis"].split()) >= 8
    assert told["WhatsThis"].endswith(".") and told["ToolTip"].endswith(".")
    actions = [each for each in Gui.getMainWindow().findChildren(QtGui.QAction) if each.objectName() == name]
    actions = actions or [
        each
        for each in Gui.getMainWindow().findChildren(QtWidgets.QAction)
        if each.text() == told["MenuText"]
    ]
    assert actions and actions[0].whatsThis() == told["WhatsThis"]
    assert actions[0].shortcut().toString() == told["Accel"]


def test_no_two_commands_have_the_same_keys(workbench):
    keys = [command.GetResources()["Accel"] for command in COMMANDS.values()]
    assert len(set(keys)) == len(keys)


# The panel by keys


def test_every_input_says_what_it_is(opened):
    for widget in shown(panel()):
        if widget.objectName() in opened.PropertiesList + opened.Net.PropertiesList:
            assert widget.whatsThis() and widget.toolTip(), widget.objectName()
    press("Cancel")


def test_the_tab_key_goes_down_the_panel(opened):
    begin = first = panel()
    reached = []
    widget = first.nextInFocusChain()
    while widget is not begin and len(reached) < 500:
        if widget.isVisible() and first.isAncestorOf(widget) and widget.focusPolicy() & QtCore.Qt.TabFocus:
            if widget.isEnabled() and widget.focusProxy() is None:
                reached.append(widget)
        widget = widget.nextInFocusChain()
    inputs = [
        each
        for each in shown(first)
        if isinstance(each, (QtWidgets.QAbstractButton, QtWidgets.QComboBox, QtWidgets.QAbstractSpinBox))
        and each.isEnabled()
    ]
    # Arrow keys go on within what is one stop of the Tab key.
    missing = [
        each
        for each in inputs
        if each not in reached
        and each.parentWidget() not in reached
        and not isinstance(each.parentWidget(), QtWidgets.QAbstractSpinBox)
    ]
    assert [each.objectName() or str(each) for each in missing] == []
    places = [
        (each.objectName(), each.mapTo(first, QtCore.QPoint(0, each.height() // 2))) for each in reached
    ]
    for (before, above), (after, below) in zip(places, places[1:]):
        same_row = abs(above.y() - below.y()) < 14
        assert below.x() >= above.x() if same_row else below.y() > above.y(), f"{before} before {after}"
    press("Cancel")


# Preferences and the guide


def in_preferences(act):
    """Open the page, call act(dialog), and press OK."""
    raised = []

    def drive():
        dialog = QtWidgets.QApplication.activeModalWidget()
        try:
            act(dialog)
        except BaseException as error:
            raised.append(error)
        finally:
            dialog.accept()

    QtCore.QTimer.singleShot(500, drive)
    Gui.showPreferences("Funicular", 0)
    if raised:
        raise raised[0]


def box_of(dialog, name):
    return next(each for each in dialog.findChildren(QtWidgets.QWidget, name) if each.isVisible())


def test_what_is_set_on_the_page_of_preferences_counts(workbench, settings, pictures):
    assert preferences.force_units() == ("N", "kN") and preferences.accuracy() == 1.0
    assert preferences.animates() and preferences.frame_ms() == 33

    def act(dialog):
        assert box_of(dialog, "Accuracy").property("rawValue") == pytest.approx(1.0)
        box_of(dialog, "ForceUnit").setCurrentIndex(4)
        box_of(dialog, "Palette").setCurrentIndex(1)
        box_of(dialog, "Accuracy").setProperty("rawValue", 0.25)
        box_of(dialog, "FrameBudget").setValue(50)
        box_of(dialog, "Animate").setChecked(False)
        settle()
        dialog.grab().save(str(pictures / "preferences.png"))

    in_preferences(act)
    assert preferences.force_units() == ("kip",) and preferences.accuracy() == pytest.approx(0.25)
    assert preferences.ramps() is preferences.PALETTES[1]
    assert preferences.frame_ms() == 50 and not preferences.animates()


def test_a_new_gridshell_takes_what_was_set(document, settings, pictures):
    settings.SetFloat("Accuracy", 0.5)
    settings.SetInt("ForceUnit", preferences.FORCE_UNITS.index("N"))
    settings.SetInt("Palette", 1)
    settings.SetBool("Animate", False)
    run_command("Funicular_Sheet")
    line = wait_for_result()
    shell = document.Gridshell
    assert shell.Accuracy.Value == pytest.approx(0.5)
    assert re.search(r"at most \d+ N\b", line) and "kN" not in line
    assert panel_box("AxialStiffness").text() == "100000 N"
    press("Ok")
    assert "kN" not in shell.Summary
    Gui.ActiveDocument.ActiveView.viewAxonometric()
    Gui.SendMsgToActiveView("ViewFit")
    Gui.ActiveDocument.ActiveView.saveImage(str(pictures / "one_ramp.png"), 800, 600, "Current")


def test_letters_of_the_page_do_not_clash_in_any_language(workbench, language):
    for name, locale in (
        ("English", QtCore.QLocale.c()),
        ("German", GERMAN),
        ("Italian", QtCore.QLocale("it_IT")),
    ):
        language(name, locale)

        def act(dialog):
            page = box_of(dialog, "ForceUnit").window().findChild(QtWidgets.QWidget, "FunicularPreferences")
            page = page or box_of(dialog, "ForceUnit").parentWidget().parentWidget()
            texts = [each.text() for each in page.findChildren(QtWidgets.QLabel)]
            texts += [each.text() for each in page.findChildren(QtWidgets.QCheckBox)]
            letters = [re.search("&(.)", text).group(1).lower() for text in texts if "&" in text]
            assert len(letters) == 5 and len(set(letters)) == 5, letters

        in_preferences(act)


def test_the_guide_opens_from_the_help_menu_with_its_pictures(workbench, pictures):
    (menu,) = [
        each for each in Gui.getMainWindow().menuBar().actions() if each.text().replace("&", "") == "Help"
    ]
    (action,) = [each for each in menu.menu().actions() if each.text() == "Funicular guide"]
    action.trigger()
    settle()
    page = child(QtWidgets.QTextBrowser, "GuidePage")
    assert page.toPlainText().startswith("Funicular")
    named = re.findall(r"!\[[^]]*\]\(([^)]+)\)", pathlib.Path(funicular_locate.GUIDE).read_text("utf-8"))
    assert len(named) >= 4
    for name in named:
        picture = page.loadResource(QtGui.QTextDocument.ImageResource, QtCore.QUrl(name))
        assert picture is not None and (pathlib.Path(funicular_locate.GUIDE).parent / name).is_file(), name
        size = QtGui.QImage(str(pathlib.Path(funicular_locate.GUIDE).parent / name)).size()
        assert not size.isEmpty() and size.width() <= page.viewport().width() - 48, f"{name} is cut off"
    page.window().grab().save(str(pictures / "guide.png"))
    page.window().reject()
    assert child(QtWidgets.QTextBrowser, "GuidePage") is None


# Languages


def texts_of(widgets):
    """{text: widget} of all that is to be read on widgets, tooltips included."""
    found = {}
    for each in widgets:
        for ask in ("text", "title", "toolTip", "statusTip", "whatsThis"):
            told = getattr(each, ask, str)()
            if told:
                found[told] = f"{type(each).__name__} {each.objectName()}, {ask}"
        if isinstance(each, QtWidgets.QComboBox):
            found.update(
                {each.itemText(place): f"item of {each.objectName()}" for place in range(each.count())}
            )
    return found


class Marking(QtCore.QTranslator):
    """Translates what can be translated into itself, in marks."""

    def __init__(self):
        super().__init__()
        self._german = QtCore.QTranslator()
        assert self._german.load(str(pathlib.Path(funicular_locate.TRANSLATION_FOLDER) / "Funicular_de.qm"))

    def translate(self, context, text, disambiguation=None, n=-1):
        return f"«{text}»" if self._german.translate(context, text) else ""


# What is the same in every language: numbers, symbols, units, names of what a user named.
SAME_IN_ALL = re.compile(r"[^A-Za-zÀ-ÖØ-öø-ÿ]*|[\d.,\-+]+ ?(mm|m|kN|N|M?Pa|kg/m²?|kN/m²|deg|°|ms?|cm|in|ft)")


def test_nothing_in_the_panel_escapes_translation(opened):
    press("Ok")
    marking = Marking()
    QtWidgets.QApplication.installTranslator(marking)
    try:
        edit_again(opened)
        texts = texts_of(all_below(panel()))
        press("Cancel")
    finally:
        QtWidgets.QApplication.removeTranslator(marking)
    assert len(texts) > 40
    plain = {
        text: where for text, where in texts.items() if "«" not in text and not SAME_IN_ALL.fullmatch(text)
    }
    plain = {text: where for text, where in plain.items() if text not in ("m", "cm", "mm", "ft", "in")}
    assert plain == {}


@pytest.mark.parametrize("name, locale", [("German", "de_DE"), ("Italian", "it_IT")])
def test_the_panel_speaks_another_language(opened, language, pictures, name, locale):
    press("Ok")
    in_english = {text: text for text in ("Pattern", "Stiffness EA", "Alternatives", "Keep this")}
    language(name, QtCore.QLocale(locale))
    assert command_action("Gitterschale" if name == "German" else "Gridshell")
    line = edit_again(opened)
    texts = texts_of(shown(panel()))
    assert not set(in_english) & set(texts)
    assert ("Nur Druck" if name == "German" else "Solo compressione") in line
    assert not re.search(r"\d\.\d", line), f"{line} has a decimal point"
    picture_of_panel(pictures / f"panel_{locale}.png")
    assert opened.Method == "Auto" and opened.Net.Pattern == "Quad"
    panel_box("Pattern").setCurrentIndex(panel_box("Pattern").findData("Triangle"))
    assert opened.Net.Pattern == "Triangle"
    press("Cancel")


def test_numbers_with_a_decimal_comma_are_read_in_each_kind_of_box(opened, language):
    press("Ok")
    language("English", GERMAN)
    edit_again(opened)
    type_into(panel_box("StepU"), "1,25 m")
    type_into(panel_box("CoveringWeight"), "32,5")
    type_into(panel_box("Snow"), "0,75 kN/m²")
    type_into(panel_box("AxialStiffness"), "120,5 kN")
    type_into(panel_box("OffsetU"), "0,25")
    type_into(panel_box("Accuracy"), "0,5 mm")
    assert opened.Net.StepU.Value == pytest.approx(1250.0)
    assert opened.CoveringWeight.getValueAs("kg/m^2").Value == pytest.approx(32.5)
    assert opened.Snow.getValueAs("Pa").Value == pytest.approx(750.0)
    assert opened.AxialStiffness.getValueAs("kN").Value == pytest.approx(120.5)
    assert opened.Net.OffsetU == pytest.approx(0.25)
    assert opened.Accuracy.Value == pytest.approx(0.5)
    assert panel_box("OffsetU").text() == "0,25"
    press("Cancel")
    edit_again(opened)
    assert panel_box("CoveringWeight").text() == "30 kg/m²"
    press("Cancel")


# Units


@pytest.mark.parametrize("number", [IN_FEET, IN_FEET_AND_INCHES])
def test_the_panel_in_feet_and_pounds(opened, schema, pictures, number):
    press("Ok")
    schema(number)
    line = edit_again(opened)
    assert panel_box("MemberWeight").text() == "8.06363 lb/ft"
    assert panel_box("CoveringWeight").text() == "6.14448 lb/ft²"
    assert panel_box("AxialStiffness").text() == "22.4809 kip"
    assert panel_box("Snow").text() == "0 psf"
    assert panel_box("Accuracy").text() == "0.0393701 in" and " in from equilibrium" in line
    assert re.search(r"at most [\d.]+ (lbf|kip)", line) and "kN" not in line
    type_into(panel_box("Accuracy"), "1/16 in")
    assert opened.Accuracy.Value == pytest.approx(25.4 / 16)
    type_into(panel_box("Snow"), "20")
    assert opened.Snow.getValueAs("Pa").Value == pytest.approx(20 * 47.880259, rel=1e-5)
    type_into(panel_box("CoveringWeight"), "7.5 lb/ft²")
    assert opened.CoveringWeight.getValueAs("kg/m^2").Value == pytest.approx(7.5 * 4.882428, rel=1e-5)
    type_into(panel_box("CoveringWeight"), "30 kg/m²")
    type_into(panel_box("AxialStiffness"), "30 kip")
    assert opened.AxialStiffness.getValueAs("kN").Value == pytest.approx(30 * 4.4482216, rel=1e-5)
    type_into(panel_box("AxialStiffness"), "500 lbf")
    assert opened.AxialStiffness.getValueAs("lbf").Value == pytest.approx(500.0, rel=1e-5)
    assert "not a value" not in result_line()
    picture_of_panel(pictures / f"panel_imperial_{number}.png")
    press("Cancel")


def test_forces_are_read_in_each_schema_for_buildings(opened, schema):
    press("Ok")
    # Its own box would show 100 kN as "100000000.00 mm*kg/s^2".
    schema(4)
    edit_again(opened)
    assert panel_box("AxialStiffness").text() == "100 kN"
    type_into(panel_box("AxialStiffness"), "80")
    assert opened.AxialStiffness.getValueAs("kN").Value == pytest.approx(80.0)
    press("Cancel")


# A dark window


def test_the_panel_can_be_read_on_a_dark_window(opened, pictures):
    press("Ok")
    application = QtWidgets.QApplication.instance()
    folder = pathlib.Path(App.getResourceDir()) / "Gui" / "Stylesheets"
    before = application.styleSheet()
    application.setStyleSheet((folder / "Behave-dark.qss").read_text("utf-8"))
    try:
        edit_again(opened)
        settle()
        picture_of_panel(pictures / "panel_dark.png")
        line = child(QtWidgets.QLabel, "ResultLine")
        # Of the panel: a label has no paper of its own.
        place = QtCore.QRect(line.mapTo(panel(), QtCore.QPoint(0, 0)), line.size())
        picture = panel().grab(place).toImage()
        lights = [
            picture.pixelColor(x, y).lightness()
            for x in range(0, picture.width(), 2)
            for y in range(picture.height())
        ]
        # Text that is lighter than what it stands on, and far from it.
        assert sorted(lights)[len(lights) // 2] < 110 and max(lights) > sorted(lights)[len(lights) // 2] + 80
        press("Cancel")
    finally:
        application.setStyleSheet(before)
        settle()
