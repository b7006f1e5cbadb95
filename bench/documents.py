# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a document takes: its recompute, saving, opening, and a Covering, in headless FreeCAD.

    /usr/bin/python3 tools/freecad_run.py bench/documents.py results.csv quick|full
"""

import pathlib
import statistics
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "src" / "freecad_wb"))

import FreeCAD as App  # noqa: E402
from funicular.make import make_covering, make_gridshell  # noqa: E402
from measuring import Rows, timed  # noqa: E402

# Cells a side, and how often.
EXTENTS = {"quick": ((20, 32), 1), "full": ((32, 63, 100, 199), 3)}
COLUMNS = (
    "nodes",
    "net_seconds",
    "gridshell_seconds",
    "solver_seconds",
    "save_seconds",
    "megabytes",
    "open_seconds",
    "covering_seconds",
)


def measure(cells, folder):
    """The columns of one document: a flat sheet of 10 m × 10 m on its border."""
    document = App.newDocument("Bench")
    step = f"{10000 / cells} mm"
    shell = make_gridshell(document, Width="10 m", Depth="10 m", StepU=step, StepV=step)
    _, net = timed(lambda: document.recompute([shell.Net]))
    _, gridshell = timed(document.recompute)
    solver, count = shell.Seconds, shell.Net.NodeCount
    if shell.Status != "converged":
        raise RuntimeError(f"{cells} cells: {shell.Summary or shell.getStatusString()}")
    path = pathlib.Path(folder) / "bench.FCStd"
    _, save = timed(lambda: document.saveAs(str(path)))
    covering = make_covering(document, shell)
    _, covered = timed(document.recompute)
    if covering.PanelCount != cells**2:
        raise RuntimeError(f"{cells} cells: {covering.PanelCount} panels are covered")
    App.closeDocument(document.Name)
    opened, opening = timed(lambda: App.openDocument(str(path)))
    App.closeDocument(opened.Name)
    size = path.stat().st_size * 1e-6
    return count, net, gridshell, solver, save, size, opening, covered


def main(path, extent):
    rows = Rows(path, COLUMNS)
    sides, runs = EXTENTS[extent]
    with tempfile.TemporaryDirectory() as folder:
        for cells in sides:
            samples = [measure(cells, folder) for _ in range(runs)]
            rows.add(dict(zip(COLUMNS, map(statistics.median, zip(*samples)))))


if __name__ == "__main__":
    main(*sys.argv[1:])
