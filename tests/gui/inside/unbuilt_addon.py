# SPDX-License-Identifier: LGPL-2.1-or-later
"""The addon without a native module that this Python can load."""

import sys

import FreeCADGui as Gui
from window import (
    GRIDSHELL,
    clear_report_view,
    press,
    report_view,
    result_line,
    run_command,
    select_faces,
)


def test_every_place_says_that_the_module_is_not_built(roof):
    assert Gui.activeWorkbench().name() == "FunicularWorkbench"
    select_faces(roof, "Face1")
    assert Gui.isCommandActive(GRIDSHELL)
    clear_report_view()
    run_command()
    assert "not built" in result_line() and "make build" in result_line()
    assert "not built" in report_view() and "Traceback" not in report_view()
    press("Close")
    assert roof.Document.Objects == [roof]


def test_the_command_says_for_which_python_the_module_was_built(roof):
    select_faces(roof, "Face1")
    clear_report_view()
    run_command()
    this = f"{sys.version_info.major}.{sys.version_info.minor}"
    assert "built for Python 3.99" in result_line() and f"this is Python {this}" in result_line()
    assert "3.99" in report_view() and "Traceback" not in report_view()
    press("Close")
    assert roof.Document.Objects == [roof]
