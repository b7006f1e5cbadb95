# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bring Resources/translations/Funicular_*.ts up to what a user can read, and compile them.

    freecad_run.py translations.py          all languages that are there
    freecad_run.py translations.py fr       begin French

Qt's own lupdate knows neither our translate(text), whose context is the same everywhere, nor what properties
say of themselves in tables: sources are read by `ast`, and tables by importing them, which takes
FreeCAD. Translations that are there stay; what is new is unfinished, what is gone is marked as vanished. Qt's
Linguist opens the files.
"""

import ast
import importlib
import pathlib
import pkgutil
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "src" / "freecad_wb" / "funicular"
FOLDER = ROOT / "Resources" / "translations"
FORMS = ROOT / "Resources" / "ui"

CONTEXT = "Funicular"
OF_PROPERTIES = "App::Property"

# Tables of words that modules without a window keep: module, attribute.
TABLES = (("funicular.effect_costs", "NAMES"), ("funicular.quantities", "NAMES"))

LRELEASE = ("lrelease", "/usr/lib/qt5/bin/lrelease")


def texts():
    """{(context, text)} of all that is translated."""
    found = set()
    for path in (ROOT / "InitGui.py", *sorted(PACKAGE.rglob("*.py"))):
        found |= texts_of_source(path.read_text("utf-8"))
    for path in sorted(FORMS.glob("*.ui")):
        found |= texts_of_form(path)
    return found | texts_of_properties() | texts_of_tables()


def texts_of_source(source):
    """{(context, text)} of the calls of translate and QT_TRANSLATE_NOOP in Python source."""
    tree = ast.parse(source)
    # The window's own function has the text first; FreeCAD.Qt.translate the context.
    text_first = any(
        isinstance(node, ast.ImportFrom)
        and (node.module or "").split(".")[-1] == "qt"
        and "translate" in [alias.name for alias in node.names]
        for node in ast.walk(tree)
    )
    found = set()
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        name = getattr(node.func, "id", getattr(node.func, "attr", ""))
        if name not in ("translate", "QT_TRANSLATE_NOOP") or not node.args:
            continue
        arguments = list(node.args)
        if name == "translate" and isinstance(node.func, ast.Name) and text_first:
            arguments = [arguments[1] if len(arguments) > 1 else ast.Constant(CONTEXT), arguments[0]]
        # Others are variables, whose text is marked where it is written.
        if len(arguments) == 2 and isinstance(arguments[0], ast.Constant):
            found |= {(arguments[0].value, text) for text in _strings(arguments[1])}
    return found


def _strings(node):
    """The text that an expression is, or the two that it may be."""
    if isinstance(node, ast.IfExp):
        return _strings(node.body) | _strings(node.orelse)
    return {node.value} if isinstance(node, ast.Constant) and isinstance(node.value, str) else set()


def texts_of_form(path):
    """{(context, text)} of a form of Qt's Designer."""
    root = ElementTree.parse(path).getroot()
    strings = [each for each in root.iter("string") if each.get("notr") != "true"]
    return {(root.findtext("class"), each.text) for each in strings if each.text}


def texts_of_properties():
    """{(context, text)} of the documentation of all properties, and of what can be chosen."""
    import funicular.features
    from funicular.features.feature import COMMON, Feature

    for module in pkgutil.iter_modules(funicular.features.__path__):
        importlib.import_module(f"funicular.features.{module.name}")
    found = set()
    for properties in (COMMON, *(kind.PROPERTIES for kind in Feature.__subclasses__())):
        for each in properties:
            found.add((OF_PROPERTIES, each.tooltip))
            # Units are the same in every language.
            found |= {(CONTEXT, choice) for choice in each.choices if len(choice) > 2}
    return found


def texts_of_tables():
    found = set()
    for module, attribute in TABLES:
        table = getattr(importlib.import_module(module), attribute)
        found |= {(CONTEXT, text) for text in (table.values() if isinstance(table, dict) else table)}
    return found


class Translations:
    """The translations of one .ts file. messages: {(context, text): translation}, "" where there is none."""

    def __init__(self, path):
        self.path, self.language = path, path.stem.partition("_")[2]
        self.messages, self.vanished = {}, {}
        if not path.exists():
            return
        for context in ElementTree.parse(path).getroot().iter("context"):
            for message in context.iter("message"):
                key = context.findtext("name"), message.findtext("source")
                translation = message.find("translation")
                gone = translation.get("type") == "vanished"
                (self.vanished if gone else self.messages)[key] = translation.text or ""

    def take_up(self, wanted):
        """Have an entry for each of {(context, text)}, and mark the others as vanished."""
        known = {**self.vanished, **self.messages}
        self.messages = {key: known.get(key, "") for key in wanted}
        self.vanished = {key: text for key, text in known.items() if key not in wanted and text}

    def write(self):
        root = ElementTree.Element("TS", version="2.1", language=self.language, sourcelanguage="en")
        contexts = {}
        for key, translation in sorted({**self.messages, **self.vanished}.items()):
            context, text = key
            if context not in contexts:
                contexts[context] = ElementTree.SubElement(root, "context")
                ElementTree.SubElement(contexts[context], "name").text = context
            message = ElementTree.SubElement(contexts[context], "message")
            ElementTree.SubElement(message, "source").text = text
            element = ElementTree.SubElement(message, "translation")
            element.text = translation
            if key in self.vanished or not translation:
                element.set("type", "vanished" if key in self.vanished else "unfinished")
        ElementTree.indent(root, "    ")
        self.path.write_text(
            '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
            "<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->\n"
            + ElementTree.tostring(root, encoding="unicode")
            + "\n",
            "utf-8",
        )

    def compile(self):
        program = next((found for found in map(shutil.which, LRELEASE) if found), None)
        if program is None:
            sys.exit("lrelease is missing: run `make setup`, or install Qt's Linguist tools.")
        subprocess.run([program, "-silent", self.path, "-qm", self.path.with_suffix(".qm")], check=True)


def languages():
    """The Translations that are there."""
    return [Translations(path) for path in sorted(FOLDER.glob("Funicular_*.ts"))]


def main(arguments):
    wanted = texts()
    begun = [Translations(FOLDER / f"Funicular_{language}.ts") for language in arguments]
    for each in [*languages(), *begun]:
        each.take_up(wanted)
        each.write()
        each.compile()
        missing = sum(not text for text in each.messages.values())
        print(
            f"{each.path.name}: {len(each.messages)} texts, {missing} to translate, "
            f"{len(each.vanished)} vanished"
        )


if __name__ == "__main__":
    main(sys.argv[1:])
