# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each case of inside/ as it went within the running FreeCAD, and FreeCAD with an addon that is not built."""

import re

import freecad_program
import pytest


def require_passed(outcomes, case):
    end, printed = outcomes.get((None, case)) or outcomes[None]
    outcome, report = outcomes.get(
        case, ("not reached", f"FreeCAD ended before it: {end}\n{printed[-4000:]}")
    )
    if outcome == "skipped":
        pytest.skip(report)
    assert outcome == "passed", f"{outcome} within FreeCAD:\n{report}"


def test_within_freecad(case, outcomes):
    require_passed(outcomes, case)


def test_freecad_starts_with_the_workbench(tmp_path):
    freecad_program.link_addon(tmp_path)
    name = "startup.py::test_workbench_loads_without_a_word_in_the_report_view"
    require_passed(freecad_program.run_cases(tmp_path, [name]), name)


def test_without_the_native_module(tmp_path):
    freecad_program.copy_addon_without_core(tmp_path)
    name = "unbuilt_addon.py::test_every_place_says_that_the_module_is_not_built"
    require_passed(freecad_program.run_cases(tmp_path, [name]), name)


def test_with_a_native_module_for_another_python(tmp_path):
    folder = freecad_program.copy_addon_without_core(tmp_path)
    (folder / "_core.cpython-399-x86_64-linux-gnu.so").write_bytes(b"")
    name = "unbuilt_addon.py::test_the_command_says_for_which_python_the_module_was_built"
    require_passed(freecad_program.run_cases(tmp_path, [name]), name)


def test_every_case_was_listed_by_the_name_that_freecad_runs_it_by(outcomes):
    names = [name for name in outcomes if isinstance(name, str)]
    assert names and all(re.fullmatch(r"\w+\.py::test_\w+", name) for name in names)
