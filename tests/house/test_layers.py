# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who may know whom. Each rule is first shown to catch what breaks it."""

import pytest
import rules

GUI = rules.PACKAGE / "gui"
NUMERIC = [rules.PACKAGE / "__init__.py", rules.PACKAGE / "_native.py", rules.PACKAGE / "recipes.py"]
NUMERIC += rules.sources(".py", under=rules.PACKAGE / "files")
MESHES_AND_WIRES = "topology wording mesh_repair mesh_source crossings curves cycles wireframe"
NUMERIC += [rules.PACKAGE / f"{name}.py" for name in MESHES_AND_WIRES.split()]
PRICES = "accuracy accuracy_picture cheapest_settings discretisation effect_costs prediction prediction_cache"
NUMERIC += [
    rules.PACKAGE / f"{name}.py"
    for name in ("panels", "form", "bars", "shadows", "live", "pace", *PRICES.split())
]
SOLVER = {"equilibrium", "newton", "relaxation", "solve", "solver"}


# What films the window, or takes its pictures, needs one.
OF_THE_WINDOW = ("InitGui.py", "film.py", "guide.py")


def without_window():
    """Python that must run where there is no window: all but gui/, OF_THE_WINDOW and the tests."""
    places = ["src", "examples", "tools"]
    files = [path for place in places for path in rules.sources(".py", under=rules.ROOT / place)]
    files += list(rules.ROOT.glob("*.py"))
    return [path for path in files if GUI not in path.parents and path.name not in OF_THE_WINDOW]


def broken(files, rule):
    return [
        f"{path.relative_to(rules.ROOT)}: {fault}"
        for path in files
        for fault in rule(path.read_text("utf-8"))
    ]


@pytest.mark.parametrize(
    "text",
    [
        "import FreeCADGui",
        "import FreeCADGui as Gui",
        "def f():\n    from PySide import QtCore",
        "from pivy import coin",
        "import PySide2.QtCore",
        "importlib.import_module('FreeCADGui')",
    ],
)
def test_naming_a_window_module_is_caught(text):
    assert rules.forbidden_modules(text, rules.WINDOW_MODULES)


def test_prose_and_longer_names_are_not_caught():
    text = "'''FreeCADGui is not used here.'''\nimport FreeCADGuide\nx = 'see PySide docs'"
    assert rules.forbidden_modules(text, rules.WINDOW_MODULES) == []


def test_only_the_gui_folder_names_window_modules():
    files = without_window()
    assert len(files) >= 10
    faults = broken(files, lambda text: rules.forbidden_modules(text, rules.WINDOW_MODULES))
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize(
    "text", ["from .gui import x", "from . import gui", "import funicular.gui.panel", "from ..gui import x"]
)
def test_naming_our_gui_is_caught(text):
    assert rules.uses_of_window_package(text)


def test_only_make_reaches_into_the_gui_folder():
    files = [path for path in without_window() if path != rules.PACKAGE / "make.py"]
    faults = broken(files, rules.uses_of_window_package)
    assert not faults, "\n".join(faults)


def test_asking_for_a_window_is_caught():
    assert rules.questions_for_window("import FreeCAD as App\nif App.GuiUp:\n    pass")


def test_only_make_asks_whether_there_is_a_window():
    files = [path for path in without_window() if path != rules.PACKAGE / "make.py"]
    faults = broken(files, rules.questions_for_window)
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize("text", ["import FreeCAD as App", "import Part", "from FreeCAD import Base"])
def test_naming_freecad_is_caught(text):
    assert rules.forbidden_modules(text, rules.FREECAD_MODULES)


@pytest.mark.parametrize("path", NUMERIC, ids=lambda path: path.relative_to(rules.PACKAGE).as_posix())
def test_the_numeric_package_does_not_know_freecad(path):
    assert not rules.forbidden_modules(path.read_text("utf-8"), rules.FREECAD_MODULES | rules.WINDOW_MODULES)


@pytest.mark.parametrize(
    "text",
    [
        "from . import surface",
        "from .surface import read",
        "from ..surface import x",
        "import funicular.surface",
    ],
)
def test_reaching_out_of_the_numeric_package_is_caught(text):
    assert rules.neighbours_named(text) == {"surface"}


def test_the_numeric_package_imports_only_itself():
    """`from . import surface` would bring FreeCAD in by the back door."""
    own = {path.relative_to(rules.PACKAGE).parts[0].removesuffix(".py") for path in NUMERIC}
    faults = [(path.name, rules.neighbours_named(path.read_text("utf-8")) - own) for path in NUMERIC]
    assert not [fault for fault in faults if fault[1]]


@pytest.mark.parametrize(
    "text, in_bindings",
    [
        ("#include <App/Document.h>", False),
        ("#include <QString>", False),
        ("  #  include <gp_Pnt.hxx>", False),
        ('#include "Base/Vector3D.h"', False),
        ("#include <pybind11/pybind11.h>", False),
        ("#include <Python.h>", True),
    ],
)
def test_a_foreign_include_is_caught(text, in_bindings):
    assert rules.foreign_includes(text, {"net.hpp": "net.hpp"}.get, in_bindings)


def test_own_standard_and_eigen_includes_are_allowed():
    text = '#include "net.hpp"\n#include <vector>\n#include <Eigen/Sparse>\n#include <cstdint>'
    assert rules.foreign_includes(text, {"net.hpp": "net.hpp"}.get, False) == []


# What is built only where its libraries were found, and they are named nowhere else; the core needs neither.
OPTIONAL = {"sparse_cholesky_cholmod.cpp": ["includes cholmod.h", "includes omp.h"]}


def test_the_core_knows_only_itself_the_standard_library_and_eigen():
    files = list(rules.sources(".cpp", ".hpp", under=rules.CORE))
    faults = []
    for path in files:
        resolve = rules.include_resolver(rules.CORE, path)
        in_bindings = path.parent.name == "bindings"
        found = rules.foreign_includes(path.read_text("utf-8"), resolve, in_bindings)
        name = str(path.relative_to(rules.CORE))
        faults += [f"{name} {fault}" for fault in found if fault not in OPTIONAL.get(name, [])]
    assert len(files) >= 10
    assert not faults, "\n".join(faults)


def test_an_include_cycle_is_caught(tmp_path):
    (tmp_path / "a.hpp").write_text('#include "b.hpp"\n')
    (tmp_path / "b.hpp").write_text('#include <vector>\n#include "c.hpp"\n')
    (tmp_path / "c.hpp").write_text('#include "a.hpp"\n')
    (tmp_path / "d.cpp").write_text('#include "a.hpp"\n')
    assert rules.include_cycles(rules.include_graph(tmp_path)) == ["a.hpp", "b.hpp", "c.hpp"]


def test_the_core_has_no_include_cycles():
    assert rules.include_cycles(rules.include_graph()) == []


def test_the_core_does_not_know_its_bindings():
    graph = rules.include_graph()
    core = {name for name in graph if not name.startswith("bindings/")}
    assert not [name for name in rules.reached(graph, core) if name.startswith("bindings/")]


def certificate_sources(graph):
    return {name for name in graph if name.split("/")[-1].startswith("certificate")}


def solver_files(names):
    return sorted(
        name for name in names if name.split("/")[-1].split(".")[0] in SOLVER or name.startswith("effects/")
    )


def test_a_certificate_that_includes_the_solver_is_caught():
    graph = {"certificate.hpp": {"scene.hpp"}, "scene.hpp": {"solve.hpp"}, "solve.hpp": set()}
    graph["effects/snow.hpp"] = set()
    assert solver_files(rules.reached(graph, certificate_sources(graph))) == ["solve.hpp"]
    assert solver_files(graph) == ["effects/snow.hpp", "solve.hpp"]


def test_the_certificate_shares_no_code_with_the_solver():
    graph = rules.include_graph()
    certificate = certificate_sources(graph)
    assert {"certificate.cpp", "certificate.hpp"} <= certificate
    assert solver_files(rules.reached(graph, certificate)) == []
