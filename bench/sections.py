# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sections on Funicular itself: functions of rows, as table.read gives them, to lines of Markdown."""

import math

from markdown import count, grid, length_text, paragraph, time_text, two_digits

SCENES = {
    "S": "flat net of 10 m × 10 m on its border, EA 100 kN, members of 500 N/m",
    "C": "the same on its four corners",
    "S100": "S, a hundred times as stiff",
    "S_bare": "S as nodes and members alone, its lattice not told",
    "S_gap": "S_bare without one member, so that it is no lattice",
    "D": "hemisphere of steel (EA 100 MN), compression only, members of 250 N/m and a covering of 500 N/m²",
    "T": "free-form roof of triangles, as D, no lattice",
}
KINDS = {
    "cold": "cold",
    "warm": "weights + 5 %",
    "warm_balanced": "weights + 5 %, residual too",
    "drag": "drag step",
    "drag_balanced": "drag step, residual too",
    "relaxation": "auto against the relaxation",
    "growth": "growth of time with nodes",
}
# How far node counts of different scenes may differ to stand in one line of a table.
SAME_SIZE = 1.2


def scenes(rows):
    """What the letters in the tables stand for."""
    named = [scene for scene in SCENES if any(row["scene"] == scene for row in rows)]
    listed = [f"- **{scene}**: {SCENES[scene]}." for scene in named]
    return ["The scenes of the tables:", "", *listed, ""] if named else []


def of_kind(rows, *kinds):
    return [row for row in rows if row["kind"] in kinds]


def is_well(row):
    return row["status"] in ("converged", "measured")


def targets(rows):
    """Every target of the project, and whether it is met."""
    lines, asked, met = [], 0, 0
    for row in sorted(rows, key=_order):
        for name in row:
            if not name.startswith("target_") or row["kind"] == "rise":
                continue
            what = name.removeprefix("target_")
            reached = is_well(row) and row.get(what, float("inf")) <= row[name]
            asked, met = asked + 1, met + reached
            lines.append(
                [
                    f"{row['scene']}, {KINDS[row['kind']]}",
                    count(row["nodes"]),
                    _against(row["kind"], what, row[what]) if what in row else row["status"],
                    _against(row["kind"], what, row[name]),
                    "met" if reached else "missed",
                ]
            )
    rises = of_kind(rows, "rise")
    if rises:
        worst = max(rises, key=lambda row: row["rise_error"])
        reached = all(row.get("met") == "yes" for row in rises)
        asked, met = asked + 1, met + reached
        lines.append(
            [
                f"rises of {len(rises)} nets, against another code's",
                count(worst["nodes"]),
                length_text(worst["rise_error"]),
                length_text(worst["target_rise_error"]),
                "met" if reached else "missed",
            ]
        )
    if not lines:
        return []
    # Of the first scene alone: it is another's tangent elsewhere, and about as long.
    yardsticks = [
        f"{time_text(row['F_seconds'])} at {count(row['nodes'])} nodes"
        for row in sorted(of_kind(rows, "cold"), key=lambda row: row["nodes"])
        if row["scene"] == "S" and row["nodes"] > 10_000 and "F_seconds" in row
    ]
    sentence = (
        f"{met} of {asked} targets that the project set itself are met. F is the time of one factorisation "
        "and solution of the tangent by the fastest code at hand, on one thread"
        + (f" (S: {', '.join(yardsticks)})" if yardsticks else "")
        + "; a target is the most that is allowed."
    )
    return [
        "## Targets",
        "",
        *paragraph(sentence),
        *grid(["scene, what", "nodes", "measured", "target", ""], lines),
    ]


def _order(row):
    """By kind, size and scene; sizes that differ by less than a tenth are one."""
    kind = list(KINDS).index(row["kind"]) if row["kind"] in KINDS else len(KINDS)
    scene = list(SCENES).index(row["scene"]) if row["scene"] in SCENES else len(SCENES)
    return kind, round(math.log10(row["nodes"]), 1), scene


def _against(kind, what, value):
    if what == "ratio":
        return f"1/{count(1 / value)}" if kind == "relaxation" else f"{two_digits(value)} F"
    if what == "peak_megabytes":
        return f"{count(value)} MB"
    if what == "growth":
        return f"n^{value:.2f}"
    return time_text(value) if what == "seconds" else length_text(value)


def solving(rows):
    """Cold solves, a line for each size and a column for each scene."""
    cold = of_kind(rows, "cold")
    if not cold:
        return []
    scenes = [scene for scene in SCENES if any(row["scene"] == scene for row in cold)]
    sizes = []
    for row in sorted(cold, key=lambda row: (-row["nodes"])):
        if all(size / row["nodes"] > SAME_SIZE for size in sizes):
            sizes.append(row["nodes"])
    lines = []
    for size in reversed(sizes):
        cells = [_solved(cold, scene, size) for scene in scenes]
        lines.append([count(size), *cells])
    largest = max(cold, key=lambda row: row["nodes"])
    return [
        "## Solving from the source",
        "",
        *paragraph(
            "From the net as it was laid to a residual of 10⁻⁶ and 0.1 mm; in brackets as multiples of F.",
            f"{count(largest['nodes'])} nodes take {count(largest['peak_megabytes'])} MB at most.",
        ),
        *grid(["nodes", *scenes], lines),
        "![Time against nodes, a panel for each scene](performance-solver.png)",
        "",
    ]


def _solved(rows, scene, size):
    for row in rows:
        if row["scene"] == scene and 1 / SAME_SIZE < row["nodes"] / size < SAME_SIZE:
            if not is_well(row):
                return row["status"].replace("_", " ")
            share = f" ({two_digits(row['ratio'])} F)" if "ratio" in row else ""
            return time_text(row["seconds"]) + share
    return ""


def changes(rows):
    """Solves from a shape that is there."""
    lines = []
    for row in of_kind(rows, "warm", "drag"):
        both = [each for each in of_kind(rows, f"{row['kind']}_balanced") if each["scene"] == row["scene"]]
        lines.append(
            [
                f"{row['scene']}, {KINDS[row['kind']]}",
                count(row["nodes"]),
                time_text(row["seconds"]),
                f"{two_digits(row['ratio'])} F",
                time_text(both[0]["seconds"]) if both else "",
            ]
        )
    if not lines:
        return []
    sentence = (
        "The weights are changed and the solver goes on from the shape that it has: by 5 % to 0.1 mm, and "
        "by 1 % to 1 mm as in a drag. The last column asks for a residual of 10⁻⁶ as well."
    )
    titles = ["scene, what", "nodes", "time", "of F", "with the residual"]
    return ["## After a change", "", *paragraph(sentence), *grid(titles, lines)]


def factorisations(rows):
    """F by every code, a column for each scene and size."""
    measured = of_kind(rows, "factor")
    if not measured:
        return []
    columns = sorted({(row["nodes"] > 20_000, row["scene"], row["nodes"]) for row in measured})
    lines = []
    for backend in dict.fromkeys(row["backend"] for row in measured):
        times = {
            (row["scene"], row["nodes"]): time_text(row["F_seconds"])
            for row in measured
            if row["backend"] == backend
        }
        lines.append([backend.replace("_", " "), *(times.get(key[1:], "") for key in columns)])
    titles = ["by", *(f"{scene}, {count(nodes)}" for _, scene, nodes in columns)]
    sentence = (
        "One factorisation and solution of each scene's tangent, the analysis of its pattern not counted."
    )
    return ["## Factorisations", "", *paragraph(sentence), *grid(titles, lines)]


def accuracy(rows):
    """Time to each accuracy, by every method."""
    if not rows:
        return []
    accuracies = sorted({row["accuracy"] for row in rows}, reverse=True)
    lines = []
    for scene, method in dict.fromkeys((row["scene"], row["method"]) for row in rows):
        mine = {row["accuracy"]: row for row in rows if (row["scene"], row["method"]) == (scene, method)}
        nodes = count(next(iter(mine.values()))["nodes"])
        cells = [_arrived(mine.get(each)) for each in accuracies]
        lines.append([f"{scene}, {nodes} nodes", method, *cells])
    ended = [row for row in rows if row["status"] == "converged"]
    off = max(row["true_error"] / row["estimated_error"] for row in ended if row["true_error"] > 1e-10)
    sentence = (
        "One net solved to each distance from equilibrium by every method; time in the solver, by the "
        "clock. Newton factorises; relaxation is that of Brivio et al. (2009); a method that runs out of "
        "time is not asked for more. The true distance, from a shape at 10⁻¹² of the net's size, was at "
        f"most {off:.1f} times the one that was told."
    )
    titles = ["scene", "method", *(length_text(each) for each in accuracies)]
    picture = "![Time against distance from equilibrium, a panel for each scene](performance-accuracy.png)"
    return ["## What accuracy costs", "", *paragraph(sentence), *grid(titles, lines), picture, ""]


def _arrived(row):
    if row is None:
        return "not asked"
    if row["status"] != "converged":
        return f"{row['status'].replace('_', ' ')} after {time_text(row['seconds'])}"
    return time_text(row["seconds"])


def effects(rows, costs):
    """What an effect costs by itself, and in a solve."""
    lines = []
    for force in of_kind(rows, "forces"):
        tangents = [row for row in of_kind(rows, "tangent") if row["scene"] == force["scene"]]
        lines.append(
            [
                force["scene"].replace("_", " "),
                *(
                    two_digits(row["ns_per_node"]) if row["ns_per_node"] > 0.05 else "0"
                    for row in (force, *tangents)
                ),
                two_digits(force["bytes_per_node"]),
            ]
        )
    titles = ["effect", "forces, ns a node", "tangent, ns a node", "bytes a node"]
    sentence = (
        "Once over a warped sheet of 10⁴ nodes; the bytes are what a scene and its solver hold more with "
        "the effect (of the first, what they hold at all), corners' shares of panels included, which effects "
        "on panels have in common. An effect that is absent costs none of it."
    )
    alone = ["## What effects cost", "", *paragraph(sentence), *grid(titles, lines)] if lines else []
    if not costs:
        return alone
    lines = [
        [
            row["effect"].replace("_", " "),
            count(row["evaluations"]),
            time_text(row["seconds"]),
            f"{100 * row['share']:.0f} %",
            count(row["bytes"]),
            f"{100 * row['saved']:.0f} %" if "saved" in row else "",
            length_text(row["moved"]) if "moved" in row else "",
        ]
        for row in costs
    ]
    sentence = (
        f"In a whole solve of a flat net of {count(costs[0]['nodes'])} nodes on its border to 0.1 mm, as "
        "`fn.effect_study` measures it by the clock: what each effect takes of it, what a solve without it "
        "would save, and how far the shape would move. The bytes here are those that the effect holds "
        "itself, and the blocks of the tangent that are its alone. A solve may take longer without an "
        "effect: other loads take other numbers of steps, and the clock scatters by a few milliseconds."
    )
    titles = ["effect", "evaluations", "time", "of the solve", "bytes held", "saved without", "moved by"]
    return [*alone, *paragraph(sentence), *grid(titles, lines)]


def laying(rows):
    """Laying nets on faces."""
    if not rows:
        return []
    lines = [
        [row["face"], count(row["nodes"]), time_text(row["seconds"]), two_digits(_per_node(row) * 1e6)]
        for row in rows
    ]
    sentence = (
        "Reading a face in headless FreeCAD and laying a net of quads on it in equal steps, cut along its "
        "edges where it is trimmed."
    )
    titles = ["face", "nodes", "time", "µs a node"]
    return ["## Laying a net on a face", "", *paragraph(sentence), *grid(titles, lines)]


def _per_node(row):
    return row["seconds"] / row["nodes"]


DOCUMENT = {
    "net_seconds": "Net",
    "gridshell_seconds": "Gridshell",
    "solver_seconds": "of it, solver",
    "save_seconds": "save",
    "open_seconds": "open",
    "covering_seconds": "Covering",
}


def documents(rows):
    """A document's recompute, saving and opening."""
    if not rows:
        return []
    lines = [
        [count(row["nodes"]), *(time_text(row[name]) for name in DOCUMENT), f"{row['megabytes']:.1f} MB"]
        for row in rows
    ]
    sentence = (
        "A flat sheet on its border in a document of headless FreeCAD: its objects recomputed one after "
        "the other, the document saved and opened again without its Covering, which has a face for each "
        "panel."
    )
    titles = ["nodes", *DOCUMENT.values(), "file"]
    picture = "![Time in the document against nodes](performance-documents.png)"
    return ["## In the document", "", *paragraph(sentence), *grid(titles, lines), picture, ""]


def frames(rows):
    """What a frame of the live panel takes."""
    if not rows:
        return []
    lines = [
        [
            row["what"],
            count(row["nodes"]),
            count(row["frames"]),
            time_text(row["median"]),
            time_text(row["longest"]),
        ]
        for row in rows
    ]
    sentence = (
        "A flat sheet on its border in FreeCAD's window: what a frame takes of the window's processor time, "
        "taking up what has changed, moving and drawing included, but not what FreeCAD takes to show it. The "
        "solver runs beside it."
    )
    titles = ["while", "nodes", "frames", "median", "longest"]
    return ["## Frames of the live panel", "", *paragraph(sentence), *grid(titles, lines)]
