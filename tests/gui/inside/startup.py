# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD fresh from its start: the report view holds all that was said since."""

import FreeCADGui as Gui
from window import report_view, settle


def test_workbench_loads_without_a_word_in_the_report_view():
    Gui.activateWorkbench("FunicularWorkbench")
    settle()
    assert Gui.activeWorkbench().name() == "FunicularWorkbench"
    assert Gui.activeWorkbench().MenuText == "Funicular"
    # FreeCAD itself complains of parts of it that a bare machine lacks, so it is our name that is looked for.
    assert [line for line in report_view().splitlines() if "unicular" in line] == []
    assert "rror" not in report_view() and "Traceback" not in report_view()
