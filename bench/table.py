# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the benchmarks' results as tables: table.py results.csv"""

import csv
import sys

# For each kind of benchmark: its heading, and (column's title, what to read, how to write it).
TIMES = [
    ("s", "seconds", "{:.4g}"),
    ("at most", "target_seconds", "{:.4g}"),
    ("min", "seconds_min", "{:.4g}"),
    ("max", "seconds_max", "{:.4g}"),
    ("F s", "F_seconds", "{:.4g}"),
    ("s / F", "ratio", "{:.3g}"),
    ("at most", "target_ratio", "{:.3g}"),
    ("steps", "iterations", "{:.0f}"),
    ("residual", "residual", "{:.1e}"),
    ("error mm", "position_error", "{:.1e}"),
    ("MB", "peak_megabytes", "{:.0f}"),
    ("at most", "target_peak_megabytes", "{:.0f}"),
    ("F by", "backend", "{}"),
]
FACTOR = [
    ("by", "backend", "{}"),
    ("analyse s", "F_analyse", "{:.4g}"),
    ("factorise s", "F_factorise", "{:.4g}"),
    ("solve s", "F_solve", "{:.4g}"),
    ("F s", "F_seconds", "{:.4g}"),
    ("residual", "residual", "{:.1e}"),
    ("MB", "peak_megabytes", "{:.0f}"),
]
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
    "drag": ("A drag step of 1 % of the weights, to 1 mm", TIMES),
    "drag_balanced": ("The same, to 1e-6 as well", TIMES),
    "relaxation": (
        "Relaxation, and what auto takes of its time",
        [
            ("s", "seconds", "{:.4g}"),
            ("auto / s", "ratio", "{:.2e}"),
            ("at most", "target_ratio", "{:.0e}"),
            ("shapes differ m", "shape_distance", "{:.1e}"),
            ("at most", "target_shape_distance", "{:.0e}"),
            ("steps", "iterations", "{:.0f}"),
            ("residual", "residual", "{:.1e}"),
        ],
    ),
    "growth": (
        "Growth of the cost of S with its nodes, from 10⁴ on",
        [("exponent", "growth", "{:.3f}"), ("at most", "target_growth", "{:.2f}")],
    ),
    "factor": ("Factorisations; F is factorise + solve of the best", FACTOR),
    "forces": (
        "An effect's forces",
        [("ns a node", "ns_per_node", "{:.1f}"), ("bytes a node", "bytes_per_node", "{:.0f}")],
    ),
    "tangent": ("An effect's tangent", [("ns a node", "ns_per_node", "{:.1f}")]),
}
WORDS = {
    "kind",
    "scene",
    "backend",
    "status",
    "met",
    "method",
    "compression_only",
    "effect",
    "face",
    "peer",
    "version",
}
WORDS |= {"what", "model", "reason", "sentence", "dispensable"}
UNITS = {"position_error": 1e3}  # millimetres a metre


def read(path):
    """The rows of results, numbers as numbers; empty cells are left out."""
    with open(path, newline="", encoding="utf-8") as file:
        return [
            {name: text if name in WORDS else float(text) for name, text in row.items() if text}
            for row in csv.DictReader(file)
        ]


def cell(row, name, form):
    if name not in row:
        return ""
    return form.format(row[name] * UNITS[name] if name in UNITS else row[name])


def table(rows, columns):
    """Lines of text: scene, nodes, the columns that say anything, and whether what was asked for was met."""
    columns = [("scene", "scene", "{}"), ("nodes", "nodes", "{:.0f}"), *columns, ("met", "met", "{}")]
    columns = [column for column in columns if any(column[1] in row for row in rows)]
    lines = [[title for title, _, _ in columns] + [""]]
    for row in rows:
        trouble = "" if row["status"] in ("converged", "measured") else row["status"]
        lines.append([cell(row, name, form) for _, name, form in columns] + [trouble])
    widths = [max(map(len, column)) for column in zip(*lines)]
    return [
        "  ".join(
            text.ljust(width) if name in WORDS else text.rjust(width)
            for text, width, name in zip(line, widths, [name for _, name, _ in columns] + ["status"])
        ).rstrip()
        for line in lines
    ]


def main(path):
    rows = read(path)
    for kind, (heading, columns) in KINDS.items():
        of_kind = [row for row in rows if row["kind"] == kind]
        order = list(dict.fromkeys(row["scene"] for row in of_kind))
        of_kind.sort(key=lambda row: (order.index(row["scene"]), row["nodes"]))
        if of_kind:
            print(f"\n{heading}")
            print("\n".join(table(of_kind, columns)))
    asked = [row for row in rows if "met" in row]
    print(f"\n{sum(row['met'] == 'yes' for row in asked)} of {len(asked)} targets met")


if __name__ == "__main__":
    main(*sys.argv[1:])
