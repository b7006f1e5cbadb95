# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window's tests need the real program: the cases in inside/ are run by a pytest within FreeCAD itself.

This outer pytest lists them, starts FreeCAD for those that were chosen, a program for each of two cores, and
passes on what became of each.
"""

import ast
import os
import pathlib

import pytest

import freecad_program

# FreeCAD's modules are there only within FreeCAD.
collect_ignore = ["inside"]

INSIDE = pathlib.Path(__file__).parent / "inside"


def case_names(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    functions = [node.name for node in tree.body if isinstance(node, ast.FunctionDef)]
    return [f"{path.name}::{name}" for name in functions if name.startswith("test_")]


def pytest_generate_tests(metafunc):
    if "case" in metafunc.fixturenames:
        names = [name for path in sorted(INSIDE.glob("cases_*.py")) for name in case_names(path)]
        metafunc.parametrize("case", names)


@pytest.fixture(scope="session")
def outcomes(request, tmp_path_factory):
    """{case: (outcome, report)} with this checkout as FreeCAD's addon; {(None, case): (end, printed)} of the
    program that ran the case."""
    chosen = [item.callspec.params["case"] for item in request.session.items if "case" in item.fixturenames]
    homes = [tmp_path_factory.mktemp("home") for _ in range(min(2, os.cpu_count() or 1))]
    for home in homes:
        freecad_program.link_addon(home)
    return freecad_program.run_cases_side_by_side(homes, chosen)
