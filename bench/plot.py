# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws time against nodes, a panel for each scene: plot.py results.csv picture.png"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import table  # noqa: E402

TITLES = {
    "S": "S: flat net, border fixed",
    "C": "C: flat net, four corners",
    "S100": "S100: S, 100 × as stiff",
    "S_bare": "S_bare: S without its lattice",
    "S_gap": "S_gap: S without lattice and one member",
    "D": "D: dome",
    "T": "T: roof of triangles",
}
PANEL_HEIGHT = 3.1  # inches
SOLVE, YARDSTICK, WARM, MISSED = "#1f5fa8", "#777777", "#d9822b", "#c0392b"


def draw(axes, scene, rows):
    cold = sorted((r for r in rows if r["kind"] == "cold" and "seconds" in r), key=lambda r: r["nodes"])
    nodes = [row["nodes"] for row in cold]
    axes.plot(nodes, [row["seconds"] for row in cold], "-", color=SOLVE, label="cold solve", zorder=2)
    for row in cold:
        ended = row["status"] == "converged"
        axes.plot(
            row["nodes"],
            row["seconds"],
            "o" if ended else "X",
            color=SOLVE if ended else MISSED,
            markersize=5 if ended else 8,
            label=None if ended else "did not converge",
            zorder=3,
        )
    factored = [row for row in cold if "F_seconds" in row]
    axes.plot(
        [row["nodes"] for row in factored],
        [row["F_seconds"] for row in factored],
        "s--",
        color=YARDSTICK,
        markersize=4,
        label="F: factorise + solve",
        zorder=2,
    )
    for row in cold:
        target = (
            row["target_ratio"] * row["F_seconds"] if "target_ratio" in row else row.get("target_seconds")
        )
        if target:
            axes.plot(
                row["nodes"],
                target,
                "_",
                color="black",
                markersize=22,
                markeredgewidth=2,
                label="target",
                zorder=4,
            )
    for row in rows:
        if row["kind"] == "warm":
            axes.plot(row["nodes"], row["seconds"], "D", color=WARM, markersize=5, label="weights + 5 %")
    axes.set_title(TITLES.get(scene, scene), fontsize=10, loc="left")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, which="major", color="#dddddd", linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)


def main(results, picture):
    rows = [row for row in table.read(results) if row["kind"] in ("cold", "warm")]
    scenes = [scene for scene in TITLES if any(row["scene"] == scene for row in rows)]
    if not scenes:
        print(f"{picture}: no cold solves to draw")
        return
    columns = min(4, len(scenes))
    lines = -(-len(scenes) // columns)
    figure, panels = plt.subplots(
        lines, columns, figsize=(3.5 * columns, PANEL_HEIGHT * lines), squeeze=False, sharex=True, sharey=True
    )
    for axes in panels.flat[len(scenes) :]:
        axes.set_visible(False)
    legend = {}
    for axes, scene in zip(panels.flat, scenes):
        draw(axes, scene, [row for row in rows if row["scene"] == scene])
        for handle, label in zip(*axes.get_legend_handles_labels()):
            legend.setdefault(label, handle)
    # The last one of each column, which need not be in the last line.
    for axes in panels.flat[max(0, len(scenes) - columns) : len(scenes)]:
        axes.set_xlabel("nodes")
        axes.tick_params(labelbottom=True)
    for axes in panels[:, 0]:
        axes.set_ylabel("CPU time [s]")
    figure.legend(
        legend.values(), legend.keys(), loc="lower center", ncol=len(legend), frameon=False, fontsize=9
    )
    figure.tight_layout(rect=(0, 0.3 / (PANEL_HEIGHT * lines), 1, 1))
    figure.savefig(picture, dpi=100)
    print(f"drawn: {picture}")


if __name__ == "__main__":
    main(*sys.argv[1:])
