# SPDX-License-Identifier: LGPL-2.1-or-later
"""The house's rules as functions: each takes sources and returns what breaks the rule, one sentence each."""

import ast
import os
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORE = ROOT / "src" / "core"
PACKAGE = ROOT / "src" / "freecad_wb" / "funicular"

WINDOW_MODULES = {"FreeCADGui", "PySide", "PySide2", "PySide6", "PyQt5", "PyQt6", "shiboken2", "shiboken6"}
WINDOW_MODULES |= {"pivy"}
FREECAD_MODULES = {"FreeCAD", "App", "Part", "Mesh", "MeshPart", "Draft", "Arch", "Sketcher"}
# Dots alone, or the package's name: how a module inside the package is addressed.
OURS = re.compile(r"\.+|funicular\.")
SPDX = "SPDX-License-Identifier: LGPL-2.1-or-later"
MOST_LINES = 500


def sources(*suffixes, under=ROOT):
    """Files below `under` whose name ends in one of the suffixes, without what is built or not ours."""
    for folder, folders, names in os.walk(under):
        folders[:] = sorted(set(folders) - {".git", "build", "__pycache__", ".hypothesis", ".pytest_cache"})
        for name in sorted(names):
            if name.endswith(suffixes):
                yield pathlib.Path(folder) / name


def modules_named(text):
    """(line, dotted name) of every module that Python source imports and of every string that could name one.

    Strings count because importlib takes them. Relative imports keep their dots: `from .x import y` is .x.y.
    """
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name
        elif isinstance(node, ast.ImportFrom):
            prefix = "." * node.level + (node.module or "")
            yield node.lineno, prefix
            for alias in node.names:
                yield node.lineno, prefix + ("" if prefix.endswith(".") else ".") + alias.name
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            if re.fullmatch(r"[A-Za-z_][\w.]*", node.value):
                yield node.lineno, node.value


def forbidden_modules(text, forbidden):
    return [
        f"line {line} names {name}" for line, name in modules_named(text) if name.split(".")[0] in forbidden
    ]


def uses_of_window_package(text):
    """Lines that name this project's own gui package."""
    return [
        f"line {line} names {name}"
        for line, name in modules_named(text)
        if OURS.match(name) and OURS.sub("", name, 1).split(".")[0] == "gui"
    ]


def neighbours_named(text, package=PACKAGE):
    """The modules and folders directly in our package that Python source imports."""
    neighbours = {path.stem for path in package.iterdir() if path.suffix == ".py" or path.is_dir()}
    parts = {
        part
        for _, name in modules_named(text)
        if OURS.match(name)
        for part in OURS.sub("", name, 1).split(".")
    }
    return parts & neighbours


def questions_for_window(text):
    """Lines that ask whether FreeCAD has a window (`App.GuiUp`)."""
    return [
        f"line {node.lineno} asks for GuiUp"
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Attribute) and node.attr == "GuiUp"
    ]


def includes(text):
    """(form, name) of every #include: form is '<' or '"'."""
    return re.findall(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', text, re.MULTILINE)


def foreign_includes(text, resolve, in_bindings):
    """Includes that are not the core's, the standard library's or Eigen's; bindings have pybind11 too.

    `resolve` gives the core's file that a quoted name stands for, or None.
    """
    libraries = ("Eigen/", "unsupported/Eigen/") + (("pybind11/",) if in_bindings else ())
    foreign = []
    for form, name in includes(text):
        standard = re.fullmatch(r"[a-z_0-9]+", name) is not None
        if not (resolve(name) if form == '"' else standard or name.startswith(libraries)):
            foreign.append(f"includes {name}")
    return foreign


def include_resolver(core, includer):
    """As the compiler looks: beside the including file first, then from the core's folder."""

    def resolve(name):
        for place in (includer.parent, core):
            if (place / name).is_file():
                return (place / name).resolve().relative_to(core.resolve()).as_posix()
        return None

    return resolve


def include_graph(core=CORE):
    """File → the core's files that it includes, all as paths relative to the core's folder."""
    graph = {}
    for path in sources(".cpp", ".hpp", under=core):
        resolve = include_resolver(core, path)
        quoted = [name for form, name in includes(path.read_text("utf-8")) if form == '"']
        graph[path.relative_to(core).as_posix()] = {resolve(name) for name in quoted} - {None}
    return graph


def reached(graph, starts):
    """Every file that the starts include, directly or through others; the starts too."""
    found, waiting = set(), list(starts)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting.extend(graph[name])
    return found


def include_cycles(graph):
    return [name for name in graph if any(name in reached(graph, [other]) for other in graph[name])]


def licence_missing(text):
    start = "\n".join(text.splitlines()[:3])
    return [] if SPDX in start else [f"does not say '{SPDX}' in its first three lines"]


def too_long(text):
    count = len(text.splitlines())
    return [f"has {count} lines; {MOST_LINES} are the most"] if count > MOST_LINES else []


def make_targets(makefile):
    """The targets that `make help` lists."""
    return re.findall(r"^([a-z-]+):[^#\n]*## ", makefile, re.MULTILINE)


def targets_named(document):
    """What a document tells its reader to `make`, in code: `make x` or an indented or fenced line."""
    return set(re.findall(r"(?:`|^\s*(?:\$ )?)make ([a-z][a-z-]*)", document, re.MULTILINE))


def unfinished(text):
    marks = "|".join(("TO" "DO", "FIX" "ME", "X" "XX", "HA" "CK"))
    return [f"says {mark}" for mark in re.findall(rf"\b(?:{marks})\b", text)]
