# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the benchmarks' results as tables: table.py results.csv"""

import csv
import sys

# For each kind of benchmark: its heading, and (column's title, what to read, how to write it).
TIMES = [
    ("s", "seconds", "{:.4g}"),
    ("min", "seconds_min", "{:.4g}"),
    ("max", "seconds_max", "{:.4g}"),
    ("F s", "F_seconds", "{:.4g}"),
    ("s / F", "ratio", "{:.3g}"),
    ("target", "target_ratio", "{:.3g}"),
    ("steps", "iterations", "{:.0f}"),
    ("residual", "residual", "{:.1e}"),
    ("error mm", "position_error", "{:.1e}"),
    ("MB", "peak_megabytes", "{:.0f}"),
]
FACTOR = [
    ("analyse s", "F_analyse", "{:.4g}"),
    ("factorise s", "F_factorise", "{:.4g}"),
    ("solve s", "F_solve", "{:.4g}"),
    ("F s", "F_seconds", "{:.4g}"),
    ("residual", "residual", "{:.1e}"),
    ("MB", "peak_megabytes", "{:.0f}"),
]
ABSOLUTE = [("s", "seconds", "{:.4g}"), ("target s", "target_seconds", "{:.4g}")] + TIMES[1:4] + TIMES[6:]
KINDS = {
    "rise": (
        "Rises, against another code's",
        [
            ("rise m", "rise", "{:.6f}"),
            ("differs by", "rise_error", "{:.1e}"),
            ("steps", "iterations", "{:.0f}"),
        ],
    ),
    "cold": ("Cold solves to 1e-6 and 0.1 mm", TIMES),
    "warm": ("After a change of the weights by 5 %, to 0.1 mm", TIMES),
    "warm_balanced": ("The same, to 1e-6 as well", TIMES),
    "drag": ("A drag step of 1 % of the weights, to 1 mm", ABSOLUTE),
    "drag_balanced": ("The same, to 1e-6 as well", ABSOLUTE),
    "relaxation": (
        "Relaxation; the ratio is that of auto to it",
        TIMES[:1]
        + [("auto / s", "ratio", "{:.2e}"), TIMES[5]]
        + [("shapes differ m", "shape_distance", "{:.1e}")]
        + TIMES[6:9],
    ),
    "growth": (
        "Growth of the cost of S with its nodes, from 10⁴ on",
        [("exponent", "growth", "{:.3f}"), ("target", "target_growth", "{:.2f}")],
    ),
    "factor": ("Factorisations; F is factorise + solve of the best", FACTOR),
    "forces": (
        "An effect's forces",
        [("ns a node", "ns_per_node", "{:.1f}"), ("bytes a node", "bytes_per_node", "{:.0f}")],
    ),
    "tangent": ("An effect's tangent", [("ns a node", "ns_per_node", "{:.1f}")]),
}
FACTORS = {"position_error": 1e3}  # metres to millimetres


def read(path):
    """The rows of results, numbers as numbers; empty cells are left out."""
    words = {"kind", "scene", "backend", "status", "met"}
    with open(path, newline="", encoding="utf-8") as file:
        return [
            {name: text if name in words else float(text) for name, text in row.items() if text}
            for row in csv.DictReader(file)
        ]


def cell(row, name, form):
    return form.format(row[name] * FACTORS.get(name, 1)) if name in row else ""


def table(rows, columns):
    """Lines of text: the scene, its nodes, the columns, and whether it met what was asked for."""
    lines = [["scene", "nodes"] + [title for title, _, _ in columns] + ["met", ""]]
    for row in rows:
        name = row["scene"] + (f" {row['backend']}" if "backend" in row else "")
        trouble = "" if row["status"] in ("converged", "measured") else row["status"]
        lines.append(
            [name, cell(row, "nodes", "{:.0f}")]
            + [cell(row, name, form) for _, name, form in columns]
            + [row.get("met", ""), trouble]
        )
    widths = [max(map(len, column)) for column in zip(*lines)]
    return [
        "  ".join(
            [line[0].ljust(widths[0])] + [text.rjust(w) for text, w in zip(line[1:], widths[1:])]
        ).rstrip()
        for line in lines
    ]


def main(path):
    rows = read(path)
    for kind, (heading, columns) in KINDS.items():
        of_kind = [row for row in rows if row["kind"] == kind]
        if of_kind:
            print(f"\n{heading}")
            print("\n".join(table(of_kind, columns)))
    asked = [row for row in rows if "met" in row]
    print(f"\n{sum(row['met'] == 'yes' for row in asked)} of {len(asked)} targets met")


if __name__ == "__main__":
    main(*sys.argv[1:])
