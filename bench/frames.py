# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a frame of the live panel takes, in FreeCAD's window: frames.csv.

Run by the freecad program with FUNICULAR_FRAMES naming the file to write; `make bench` does.
"""

import csv
import os
import sys
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore

try:
    from PySide import QtWidgets
except ImportError:  # 0.20's PySide merges the widgets into QtGui
    from PySide import QtGui as QtWidgets

# Sides of the sheet in members of 0.1 m.
SIDES = (49, 99)
LONGEST = 60_000  # [ms]


def wait_until(condition):
    loop, poll = QtCore.QEventLoop(), QtCore.QTimer()
    poll.timeout.connect(lambda: condition() and loop.quit())
    poll.start(10)
    QtCore.QTimer.singleShot(LONGEST, loop.quit)
    (getattr(loop, "exec", None) or loop.exec_)()
    if not condition():
        raise TimeoutError("the form did not come to rest")


def measure(side):
    """Rows of one net: as it rises, and as the covering's weight is dragged."""
    from funicular.make import make_gridshell

    document = FreeCAD.newDocument()
    size = f"{side / 10} m"
    shell = make_gridshell(document, Width=size, Depth=size, StepU="100 mm", StepV="100 mm")
    document.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    shell.ViewObject.Proxy.doubleClicked(shell.ViewObject)
    session = shell.ViewObject.Proxy._panel.session
    wait_until(lambda: session.is_settled)
    yield row(shell, "rising", session)
    widgets = QtWidgets.QApplication.allWidgets()
    slider = next(
        each for each in widgets if each.objectName() == "CoveringWeightSlider" and each.isVisible()
    )
    session.frame_seconds.clear()
    for value in range(20, 180, 4):
        slider.setValue(value)
        QtWidgets.QApplication.processEvents()
        QtCore.QThread.msleep(10)
    wait_until(lambda: session.is_settled)
    yield row(shell, "dragging the covering", session)
    FreeCADGui.Control.closeDialog()
    QtWidgets.QApplication.processEvents()
    FreeCAD.closeDocument(document.Name)


def row(shell, what, session):
    seconds = sorted(session.frame_seconds)
    return {
        "what": what,
        "nodes": shell.Net.NodeCount,
        "frames": len(seconds),
        "median": seconds[len(seconds) // 2],
        "longest": seconds[-1],
    }


def run():
    code = 1
    try:
        FreeCADGui.activateWorkbench("FunicularWorkbench")
        rows = [row for side in SIDES for row in measure(side)]
        with open(os.environ["FUNICULAR_FRAMES"], "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, rows[0])
            writer.writeheader()
            writer.writerows(rows)
        for each in rows:
            print(
                f"{each['nodes']} nodes, {each['what']}: {each['frames']} frames, "
                f"{1e3 * each['median']:.1f} ms, at most {1e3 * each['longest']:.1f} ms"
            )
        code = 0
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    # FreeCAD would ask whether to save.
    os._exit(code)


QtCore.QTimer.singleShot(1500, run)
