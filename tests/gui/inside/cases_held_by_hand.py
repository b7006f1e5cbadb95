# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports by hand in the panel: picked in the 3D view, held, weakened, lifted, taken back."""

import FreeCADGui as Gui
import pytest
from hand import click, drag, key, move, panel, place_of, places, viewport
from window import QtCore, QtWidgets, child, edit_again, names, panel_box, press, settle, wait_until

SHIFT, ALT, CONTROL = QtCore.Qt.ShiftModifier, QtCore.Qt.AltModifier, QtCore.Qt.ControlModifier


@pytest.fixture
def standing(opened):
    """The panel of a roof on its corners, seen at a slant, at rest."""
    opened.SupportRecipe = "Corners"
    panel().session.change()
    view = Gui.ActiveDocument.ActiveView
    view.viewIsometric()
    at_rest()
    view.fitAll()
    settle()
    return opened


def at_rest():
    wait_until(lambda: panel().session.is_settled, "the end of the movement")


def tool(name):
    panel_box(f"Tool{name}").click()


def hold(name):
    panel_box(f"Hold{name}").click()
    at_rest()


def picked():
    return sorted(panel().supports.picks.nodes.tolist())


def support(standing):
    (found,) = standing.Supports
    return found


def test_time(roof):
    log = open("/tmp/sup-times.txt", "w")
    def print(*a): log.write(" ".join(map(str, a)) + chr(10)); log.flush()
    import time, numpy as np
    from funicular.make import make_gridshell
    shell = make_gridshell(roof.Document, source=(roof, ["Face1"]), CountU=20, CountV=20)
    roof.Document.recompute()
    Gui.ActiveDocument.ActiveView.viewIsometric()
    edit_again(shell)
    at_rest()
    Gui.ActiveDocument.ActiveView.fitAll()
    part = panel().supports
    def t(w, f, k=3):
        b = []
        for _ in range(k):
            a = time.perf_counter(); f(); b.append(time.perf_counter() - a)
        print(w, [round(1e3 * x, 1) for x in b])
    t("take_held boundary", part._take_held)
    t("draw", part._draw)
    tool("Nodes")

    click(place_of(50))
    net = shell.Net
    print(net.State, panel().session._changed)
    panel_box("HoldFixed").click()
    print(net.State, panel().session._changed)
    from funicular.make import make_support
    settle()
    print(net.State, panel().session._changed)
    at_rest()
    print(net.State, panel().session._changed)
    make_support(shell.Document, shell, Nodes=[3])
    print(net.State, panel().session._changed)
    assert 0
