# SPDX-License-Identifier: LGPL-2.1-or-later
"""The addon's description, the build's version, the packages and the documents agree with what is there."""

import ast
import re
import xml.etree.ElementTree as ElementTree

import pytest
import rules

NAMESPACE = {"p": "https://wiki.freecad.org/Package_Metadata"}
ICON_BYTES = 10_000


@pytest.fixture(scope="module")
def package():
    return ElementTree.parse(rules.ROOT / "package.xml").getroot()


def text_of(package, path):
    element = package.find("/".join(f"p:{part}" for part in path.split("/")), NAMESPACE)
    assert element is not None, f"package.xml has no {path}"
    return element.text.strip()


def test_the_description_has_all_that_the_addon_manager_asks_for(package):
    for path in ("name", "version", "date", "description", "maintainer", "license", "icon"):
        assert text_of(package, path)
    assert "@" in package.find("p:maintainer", NAMESPACE).get("email")
    assert package.find("p:url[@type='repository']", NAMESPACE).get("branch")
    assert text_of(package, "license") == "LGPL-2.1-or-later"
    assert text_of(package, "content/workbench/subdirectory") == "./"


def test_the_licence_file_is_there(package):
    assert (rules.ROOT / package.find("p:license", NAMESPACE).get("file")).is_file()


@pytest.mark.parametrize("path", ["icon", "content/workbench/icon"])
def test_the_icon_is_a_small_svg(package, path):
    icon = rules.ROOT / text_of(package, path)
    assert icon.suffix == ".svg"
    assert ElementTree.parse(icon).getroot().tag == "{http://www.w3.org/2000/svg}svg"
    assert icon.stat().st_size <= ICON_BYTES


def test_the_workbench_class_is_defined_in_init_gui(package):
    init_gui = ast.parse((rules.ROOT / "InitGui.py").read_text("utf-8"))
    classes = {node.name for node in ast.walk(init_gui) if isinstance(node, ast.ClassDef)}
    assert text_of(package, "content/workbench/classname") in classes


def test_the_version_is_the_build_s(package):
    cmake = (rules.ROOT / "CMakeLists.txt").read_text("utf-8")
    assert text_of(package, "version") == re.search(r"project\(Funicular VERSION ([\d.]+)", cmake).group(1)


def test_every_package_is_named_once_with_its_reason():
    lines = (rules.ROOT / "tools" / "packages.txt").read_text("utf-8").splitlines()
    rows = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    assert all(len(row) == 2 for row in rows)
    assert len({row[0] for row in rows}) == len(rows) >= 10


@pytest.fixture(scope="module")
def targets():
    found = rules.make_targets((rules.ROOT / "Makefile").read_text("utf-8"))
    assert {"help", "demo", "test", "build", "gui", "install", "lint"} <= set(found)
    return set(found)


def test_targets_are_found_in_prose_and_in_code():
    document = (
        "Run `make demo`, then\n\n    make test-core\n    $ make gui   # opens it\n\nThese make things clear."
    )
    assert rules.targets_named(document) == {"demo", "test-core", "gui"}


def test_the_readme_names_every_make_target(targets):
    readme = rules.targets_named((rules.ROOT / "README.md").read_text("utf-8"))
    assert targets - readme == set()


@pytest.mark.parametrize("name", ["README.md", "CONTRIBUTING.md"])
def test_documents_name_no_target_that_is_not_there(targets, name):
    assert rules.targets_named((rules.ROOT / name).read_text("utf-8")) - targets == set()
