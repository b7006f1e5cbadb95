# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window's tests need the real program: the cases in inside/ are run by a pytest within FreeCAD itself.

This outer pytest lists them, starts FreeCAD once for those that were chosen, and passes on what became of
each.
"""

import ast
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
    """{case: (outcome, report)} of one run of FreeCAD with this checkout as its addon."""
    chosen = [item.callspec.params["case"] for item in request.session.items if "case" in item.fixturenames]
    home = tmp_path_factory.mktemp("home")
    freecad_program.link_addon(home)
    return freecad_program.run_cases(home, chosen)
