# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section on other packages: rows, as table.read gives them, to lines of Markdown."""

from markdown import count, grid, length_text, paragraph, power, time_text

GOAL = 1e-6
MODELS = ("force densities", "springs")
NAMES = {"funicular": "**Funicular**"}
INTRODUCTION = """\
Other packages on the same net, each to the same residual: a flat square net of 10 m × 10 m, its border
fixed, all other nodes pulled by the same load. The residual is computed apart from all of them, from
positions alone: the largest of Σ force density · edge + load over the free nodes, as a share of the
load. Every package that iterates is run with tolerances of its own from 10⁻² to 10⁻⁸, and the quickest
run that reaches the residual counts. Times are CPU time on one thread, medians of repeated runs in one
process. A second table tells what is apart from that on the largest net that each package has solved:
making its input of arrays, which for Funicular and jax_fdm is more than a change of form; the first run,
which compiles where there is something to compile; and how far a node lies from the shape that the first
package found."""
COMPARED = {
    "force densities": """\
**Force densities given.** compas_fd and jax_fdm solve one linear system; compas_tna finds heights alone,
over a plan that stays as it is, and its time includes reading and writing its diagram. Funicular knows
springs only: it gets springs of EA 100 kN with the rest lengths that pull as much in the shape that the
first package found, and starts from the flat net. It is the same equilibrium, of a problem that is no
longer linear.""",
    "springs": """\
**Springs given.** EA 100 kN, as long at rest as in the flat net, which pull and push: the same problem
for all. compas_dr is run with its own damping and without its second criterion, which stops wherever a
swing turns. ShapeOp has loads in its dynamic mode alone; its supports are springs of 10⁷ EA, and time
step, damping and projections a step were chosen by trial on the smallest net, so that a better choice
may be faster; its set-up is part of each run, as it cannot be set back. Where a solve takes too long,
larger nets are not tried.""",
}
NOT_COMPARABLE = """\
What is not compared: jax_fdm is made for gradients, compas_tna for form and force diagrams, ShapeOp for
many kinds of constraints; none of that is asked here. Neither is what Funicular is made for: members
that go slack, loads that follow the shape, and a distance from equilibrium that is told."""


def peers(rows, told):
    """The section; told: of the machine, see machine.py."""
    if not rows:
        return [
            "## Other packages",
            "",
            *paragraph(
                "Not measured here; `make bench-peers` adds compas_fd, compas_tna, jax_fdm, compas_dr and",
                "compas_shapeop.",
            ),
        ]
    lines = ["## Other packages", "", *paragraph(INTRODUCTION)]
    if told:
        lines += paragraph(f"Measured on {told['date']} at commit {told['commit']} by `make bench-peers`.")
    for model in MODELS:
        mine = [row for row in rows if row.get("model") == model]
        if mine:
            lines += [*paragraph(COMPARED[model]), *_times(mine), *_apart(mine)]
    picture = "![Time against nodes and against residual, by package](performance-peers.png)"
    lines += [picture, "", *paragraph(NOT_COMPARABLE)]
    for row in rows:
        if row["status"] in ("not installed", "failed"):
            lines += paragraph(f"{row['peer']} was left out, {row['status']}: {row['reason']}")
    return lines


def reaching(rows):
    """The cheapest row that reaches the goal, or None."""
    reached = [row for row in rows if row["residual"] <= GOAL]
    return min(reached, key=lambda row: row["seconds"], default=None)


def _times(rows):
    """A line for each package, a column for each size."""
    sizes = sorted({row["nodes"] for row in rows})
    lines = []
    for peer in dict.fromkeys(row["peer"] for row in rows):
        mine = [row for row in rows if row["peer"] == peer]
        name = f"{NAMES.get(peer, peer)} {mine[0].get('version', '')}".strip()
        lines.append([name, *(_time([row for row in mine if row["nodes"] == size]) for size in sizes)])
    titles = [f"to a residual of {power(GOAL)}", *(f"{count(size)} nodes" for size in sizes)]
    return grid(titles, lines)


def _time(rows):
    if not rows:
        return "not tried"
    best = reaching(rows)
    if best:
        return time_text(best["seconds"])
    nearest = min(rows, key=lambda row: row["residual"])
    longest = max(row["seconds"] for row in rows)
    return f"{power(nearest['residual'])} after {time_text(longest)}"


def _apart(rows):
    """On the largest net that each has solved: making its input, the first run, and what it found."""
    lines = []
    for peer in dict.fromkeys(row["peer"] for row in rows):
        reached = [row for row in rows if row["peer"] == peer and row["residual"] <= GOAL]
        if not reached:
            continue
        row = reaching([each for each in reached if each["nodes"] == max(each["nodes"] for each in reached)])
        lines.append(
            [
                NAMES.get(peer, peer),
                count(row["nodes"]),
                time_text(row["setup_seconds"]),
                time_text(row["first_seconds"]),
                power(row["residual"]),
                _distance(row.get("shape_distance")),
            ]
        )
    titles = ["on its largest net", "nodes", "set-up", "first run", "residual reached", "differs by"]
    return grid(titles, lines)


def _distance(metres):
    if metres is None:
        return ""
    return length_text(metres) if metres >= 1e-12 else "less than 1 pm"
