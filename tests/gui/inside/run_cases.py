# SPDX-License-Identifier: LGPL-2.1-or-later
"""Given to the freecad program: runs the ordered cases once its window stands, and ends it."""

import json
import os
import sys

from PySide import QtCore


class Recorder:
    """Writes each outcome as it falls: a crash in one case must not hide those before it."""

    def __init__(self, path):
        self._path = path

    def pytest_runtest_logreport(self, report):
        if report.when == "call" or report.outcome != "passed":
            record = dict(case=report.nodeid, outcome=report.outcome, report=report.longreprtext)
            if report.skipped:
                record["report"] = str(report.longrepr[2])
            with open(self._path, "a", encoding="utf-8") as results:
                results.write(json.dumps(record) + "\n")


def run():
    code = 1
    try:
        import pytest

        order = json.loads(os.environ["FUNICULAR_GUI_CASES"])
        inside = order["inside"]
        cases = [os.path.join(inside, case) for case in order["cases"]]
        # Files that are named are collected; a pattern for all would have pytest rewrite every library too.
        options = ["-p", "no:cacheprovider", "--rootdir", inside, "-c", os.devnull]
        code = pytest.main(options + ["--tb=short", "-q"] + cases, plugins=[Recorder(order["results"])])
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        # FreeCAD would ask whether to save, and turn the exit code to 0.
        os._exit(int(code))


QtCore.QTimer.singleShot(0, run)
