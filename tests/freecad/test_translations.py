# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text that a user can read stands in every language that is shipped, in the .ts file and compiled."""

import importlib.util
import pathlib
import string

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SPEC = importlib.util.spec_from_file_location("translations", ROOT / "tools" / "translations.py")
translations = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(translations)

LANGUAGES = {each.language: each for each in translations.languages()}


@pytest.fixture(scope="module")
def texts():
    return translations.texts()


def fields(text):
    """What is put into a text: [(which, how)], in any order. "{} of {}" may become "{1} … {0}"."""
    found = [(name, spec) for _, name, spec, _ in string.Formatter().parse(text) if name is not None]
    return sorted((name or str(place), spec) for place, (name, spec) in enumerate(found))


def test_german_and_italian_are_shipped():
    assert {"de", "it"} <= set(LANGUAGES)


def test_all_kinds_of_text_are_found(texts):
    assert ("Funicular", "Relax slowly") in texts  # of a widget
    assert ("Funicular", "{} from equilibrium") in texts  # of a sentence that a document keeps
    assert ("Funicular_Gridshell", "Gridshell") in texts  # of a command
    assert ("App::Property", "How far from equilibrium the nodes may lie") in texts
    assert ("Funicular", "Along isolines") in texts  # to be chosen
    assert ("Funicular", "the members' weight") in texts  # of a table
    assert ("FunicularPreferences", "New gridshells") in texts  # of a form
    assert ("Workbench", "Turn a surface into a compression-only gridshell") in texts


def test_a_text_is_found_by_whichever_function_translates_it():
    found = translations.texts_of_source(
        "from funicular.gui.qt import translate\n"
        "translate('one'); translate('two', 'Other'); FreeCAD.Qt.translate('Third', 'three')\n"
        "translate('here' if x else 'there'); translate(elsewhere)\n"
    )
    assert found == {
        ("Funicular", "one"),
        ("Other", "two"),
        ("Third", "three"),
        ("Funicular", "here"),
        ("Funicular", "there"),
    }
    without_window = "translate = App.Qt.translate\ntranslate('Funicular', 'four')\n"
    assert translations.texts_of_source(without_window) == {("Funicular", "four")}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_has_an_entry_and_every_entry_a_translation(texts, language):
    messages = LANGUAGES[language].messages
    assert texts - set(messages) == set(), "run `make translations`, then translate what is unfinished"
    assert set(messages) - texts == set(), "run `make translations`"
    assert [key for key, translation in messages.items() if not translation.strip()] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_is_put_into_a_text_is_put_into_its_translation(language):
    for (_, text), translation in LANGUAGES[language].messages.items():
        assert fields(text) == fields(translation), text
        assert text.count("\n") == translation.count("\n"), text
        # A key that is marked in one is marked in the other.
        assert text.count("&") == translation.count("&"), text


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_compiled_file_says_the_same(language):
    try:
        from PySide2 import QtCore
    except ImportError:  # FreeCAD 1.1
        from PySide6 import QtCore

    each, translator = LANGUAGES[language], QtCore.QTranslator()
    assert translator.load(str(each.path.with_suffix(".qm")))
    for (context, text), translation in each.messages.items():
        assert translator.translate(context, text) == translation, "run `make translations`"


def test_what_is_new_is_unfinished_and_what_is_gone_is_kept_aside(tmp_path):
    file = translations.Translations(tmp_path / "Funicular_xx.ts")
    file.take_up({("Funicular", "old"), ("Funicular", "stays")})
    file.messages = {key: key[1].upper() for key in file.messages}
    file.write()
    file = translations.Translations(file.path)
    file.take_up({("Funicular", "stays"), ("Funicular", "new")})
    file.write()
    again = translations.Translations(file.path)
    assert again.messages == {("Funicular", "stays"): "STAYS", ("Funicular", "new"): ""}
    assert again.vanished == {("Funicular", "old"): "OLD"}
    again.take_up({("Funicular", "old")})
    assert again.messages == {("Funicular", "old"): "OLD"}
