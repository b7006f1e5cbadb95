# SPDX-License-Identifier: LGPL-2.1-or-later
"""Build both examples without a window: documents, meshes and pictures in build/demo/, a table on stdout.

Leaves with an error unless every gridshell has converged and is compression-only.
"""

import pathlib
import sys

import FreeCAD as App

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "demo"
sys.path[:0] = [str(ROOT), str(ROOT / "src" / "freecad_wb"), str(ROOT / "examples")]

import dome  # noqa: E402
import roof  # noqa: E402
from funicular.export import export_gridshell  # noqa: E402
from funicular.picture import save_picture  # noqa: E402

HEADINGS = (
    "example",
    "nodes",
    "members",
    "method",
    "iterations",
    "seconds",
    "residual",
    "position error",
    "certificate",
    "total weight",
    "sum of reactions",
)


def run(name, example):
    """Build one example and write its files. Returns (row of the table, complaint or None)."""
    doc = App.newDocument(name)
    shell = example.build(doc)
    failed = [f"{obj.Label}: {obj.getStatusString()}" for obj in doc.Objects if not obj.isValid()]
    if failed:
        return (name, *[""] * (len(HEADINGS) - 1)), "; ".join(failed)
    document = FOLDER / f"{name}.FCStd"
    # FreeCAD would keep what an earlier run left as a backup beside it.
    document.unlink(missing_ok=True)
    doc.saveAs(str(document))
    export_gridshell(shell, FOLDER / f"{name}.obj")
    save_picture(shell, FOLDER / f"{name}.png")
    tension = len(shell.TensionMembers)
    row = (
        name,
        str(shell.Net.NodeCount),
        str(shell.Net.MemberCount),
        shell.MethodUsed,
        str(shell.Iterations),
        f"{shell.Seconds:.2f}",
        f"{shell.Residual:.1e}",
        f"{shell.PositionError.Value:.1e} mm",
        "compression only" if shell.CompressionOnly else f"{tension} in tension",
        f"{shell.TotalWeight.getValueAs('kN').Value:.4f} kN",
        f"{shell.ReactionSum.getValueAs('kN').Value:.4f} kN",
    )
    if shell.Status != "converged":
        return row, f"{name}: {shell.Summary}"
    return row, None if shell.CompressionOnly else f"{name}: {shell.Summary}"


def table(rows):
    """Text of the rows under the headings, numbers to the right."""
    rows = [HEADINGS, *rows]
    widths = [max(len(row[column]) for row in rows) for column in range(len(HEADINGS))]
    lines = [
        "  ".join(
            cell.ljust(width) if heading in ("example", "method", "certificate") else cell.rjust(width)
            for heading, cell, width in zip(HEADINGS, row, widths)
        ).rstrip()
        for row in rows
    ]
    lines.insert(1, "  ".join("-" * width for width in widths))
    return "\n".join(lines)


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    results = [run(name, example) for name, example in (("dome", dome), ("roof", roof))]
    print(f"\n{table([row for row, _ in results])}\n\nFiles in {FOLDER.relative_to(ROOT)}/")
    complaints = [complaint for _, complaint in results if complaint]
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
