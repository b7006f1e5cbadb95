# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the page of results, and its pictures beside it: page.py build/bench [page.md]

The folder holds the CSV files of the benchmarks; what is missing is left out. Without a page named, one of
full runs becomes docs/performance.md, and any other stays in the folder.
"""

import json
import pathlib
import sys

import peer_section
import pictures
import plot
import sections
import table
from markdown import paragraph

ROOT = pathlib.Path(__file__).resolve().parents[1]
EXTENTS = {
    "quick": "A quick run: the larger nets are missing. ",
    "part": "A part of the run alone: numbers of several runs may stand beside each other. ",
    "full": "",
}


def rows_in(folder, name):
    path = folder / f"{name}.csv"
    return table.read(path) if path.exists() else []


def facts_in(folder, name):
    path = folder / f"{name}.json"
    return json.loads(path.read_text("utf-8")) if path.exists() else {}


def heading(told):
    """What was measured on."""
    made_with = ", ".join(
        f"{what} {told[what]}" for what in ("Eigen", "CHOLMOD", "FreeCAD", "Python", "numpy")
    )
    return [
        "# Performance",
        "",
        "Written by `make bench`, which measures everything anew; nothing here is written by hand.",
        "",
        *paragraph(
            f"{EXTENTS[told['extent']]}Measured on {told['date']} at commit {told['commit']}: "
            f"{told['processor']}, {told['memory']} of memory; {told['compiler']}, {made_with}. The load of "
            f"the machine was {told['load']} when it began; much more than 0 means that other programs ran "
            "beside it, and that what is small may be off by a third. Times are CPU time on one thread, "
            "medians of up to five runs, where nothing else is said."
        ),
    ]


def write(folder, page):
    """Writes the page of a folder's results, and its pictures into the page's folder."""
    solver = rows_in(folder, "results")
    accuracy, documents = rows_in(folder, "accuracy"), rows_in(folder, "documents")
    peers = rows_in(folder, "peers")
    lines = [
        *heading(facts_in(folder, "machine")),
        *sections.scenes(solver),
        *sections.targets(solver),
        *sections.solving(solver),
        *sections.changes(solver),
        *sections.factorisations(solver),
        *sections.accuracy(accuracy),
        *sections.effects(solver, rows_in(folder, "costs")),
        *sections.laying(rows_in(folder, "sampling")),
        *sections.documents(documents),
        *sections.frames(rows_in(folder, "frames")),
        *peer_section.peers(peers, facts_in(folder, "peers")),
    ]
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text("\n".join(lines).rstrip() + "\n", "utf-8")
    print(f"written: {page}")
    for rows, draw, name in (
        (accuracy, pictures.accuracy, "accuracy"),
        (documents, pictures.documents, "documents"),
        ([row for row in peers if "residual" in row], pictures.peers, "peers"),
    ):
        if rows:
            draw(rows, page.parent / f"performance-{name}.png")
    if any(row["kind"] == "cold" for row in solver):
        plot.main(folder / "results.csv", page.parent / "performance-solver.png")


def place_of(folder):
    """Where the page of a folder goes: into docs/ if all that is in it was measured in full."""
    extents = {told["extent"] for name in ("machine", "peers") if (told := facts_in(folder, name))}
    return ROOT / "docs" / "performance.md" if extents == {"full"} else folder / "performance.md"


def main(folder, page=None):
    folder = pathlib.Path(folder)
    if not facts_in(folder, "machine"):
        sys.exit(f"{folder} has no results: run make bench first, or make bench BENCH_QUICK=1")
    write(folder, pathlib.Path(page) if page else place_of(folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
