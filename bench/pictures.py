# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page's pictures, beside the solver's (plot.py): rows, as table.read gives them, into picture files."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from markdown import count, length_text, power, time_text  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402
from peer_section import GOAL, MODELS, reaching  # noqa: E402
from sections import DOCUMENT  # noqa: E402

from funicular.accuracy_picture import COLOURS, NAMES  # noqa: E402

DPI = 100
BLUE = "#1f5fa8"
PEERS = {
    "funicular": (BLUE, "o", "Funicular"),
    "compas_fd": ("#d9822b", "s", "compas_fd"),
    "compas_tna": ("#8e5ea2", "D", "compas_tna"),
    "jax_fdm": ("#2e8b57", "^", "jax_fdm"),
    "compas_dr": ("#c0392b", "v", "compas_dr"),
    "compas_shapeop": ("#777777", "P", "compas_shapeop"),
}


def prepare(axes, title, x_label):
    axes.set_title(title, fontsize=10, loc="left")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(FuncFormatter(lambda seconds, _: time_text(seconds)))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel(x_label)
    axes.tick_params(labelleft=True)
    axes.grid(True, which="major", color="#dddddd", linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)


def mark_sizes(axes, rows):
    """The nodes that were measured, and no others."""
    sizes = sorted({row["nodes"] for row in rows})
    axes.set_xticks(sizes, [count(size) for size in sizes])
    axes.xaxis.set_minor_formatter(NullFormatter())


def finish(figure, panels, path):
    """One legend for all panels, below them."""
    legend = {}
    for axes in panels:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            legend.setdefault(label, handle)
    below = 0.32 / figure.get_figheight()
    figure.legend(
        legend.values(), legend.keys(), loc="lower center", ncol=len(legend), frameon=False, fontsize=9
    )
    figure.tight_layout(rect=(0, below, 1, 1))
    figure.savefig(path, dpi=DPI)
    plt.close(figure)
    print(f"drawn: {path}")


def accuracy(rows, path):
    """Time against the true distance, a panel for each scene."""
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    figure, panels = plt.subplots(
        1, len(scenes), figsize=(3.6 * len(scenes), 3.4), sharex=True, sharey=True, squeeze=False
    )
    for axes, scene in zip(panels.flat, scenes):
        mine = [row for row in rows if row["scene"] == scene]
        for method in dict.fromkeys(row["method"] for row in mine):
            ended = [row for row in mine if row["method"] == method and row["status"] == "converged"]
            axes.plot(
                [row["true_error"] for row in ended],
                [row["seconds"] for row in ended],
                "o-",
                color=COLOURS[method],
                markersize=4,
                label=NAMES[method],
            )
            for row in mine:
                if row["method"] == method and row["status"] != "converged":
                    axes.plot(
                        row["true_error"], row["seconds"], "x", color=COLOURS[method], label="out of time"
                    )
        prepare(axes, f"{scene}, {count(mine[0]['nodes'])} nodes", "distance from equilibrium")
        axes.xaxis.set_major_formatter(FuncFormatter(lambda metres, _: length_text(metres)))
        axes.xaxis.set_major_locator(LogLocator(numticks=7))
        axes.xaxis.set_minor_locator(LogLocator(subs=(), numticks=7))
        axes.tick_params(axis="x", labelsize=8, labelbottom=True)
    panels[0, 0].invert_xaxis()
    panels[0, 0].set_ylabel("time in the solver")
    finish(figure, panels.flat, path)


def documents(rows, path):
    """Time against nodes, a line for each thing that a document does."""
    figure, axes = plt.subplots(figsize=(6.4, 3.6))
    for name, title in DOCUMENT.items():
        axes.plot(
            [row["nodes"] for row in rows], [row[name] for row in rows], "o-", markersize=4, label=title
        )
    prepare(axes, "In the document", "nodes")
    axes.set_ylabel("CPU time")
    mark_sizes(axes, rows)
    finish(figure, [axes], path)


def peers(rows, path):
    """Time against nodes, and against residual on the largest net that several packages have solved."""
    models = [model for model in MODELS if any(row.get("model") == model for row in rows)]
    figure, panels = plt.subplots(
        2, len(models), figsize=(4.6 * len(models), 6.2), sharey=True, squeeze=False
    )
    for (over, under), model in zip(panels.T, models):
        mine = [row for row in rows if row.get("model") == model]
        size = _common_size(mine)
        for peer, (colour, mark, name) in PEERS.items():
            own = [row for row in mine if row["peer"] == peer]
            style = {"color": colour, "marker": mark, "markersize": 5, "label": name}
            sizes = sorted({row["nodes"] for row in own})
            best = [reaching([row for row in own if row["nodes"] == each]) for each in sizes]
            best = [row for row in best if row]
            if own:
                over.plot([row["nodes"] for row in best], [row["seconds"] for row in best], **style)
                at = sorted((row["residual"], row["seconds"]) for row in own if row["nodes"] == size)
                under.plot([each[0] for each in at], [each[1] for each in at], **style)
        prepare(over, f"{model.capitalize()} given, to a residual of {power(GOAL)}", "nodes")
        mark_sizes(over, mine)
        prepare(under, f"{count(size)} nodes", "residual, smaller to the right")
        under.invert_xaxis()
    for axes in panels[:, 0]:
        axes.set_ylabel("CPU time")
    finish(figure, panels.flat, path)


def _common_size(rows):
    """The largest net on which most packages are to be seen."""
    packages = {
        row["nodes"]: len({each["peer"] for each in rows if each["nodes"] == row["nodes"]}) for row in rows
    }
    return max(size for size, number in packages.items() if number == max(packages.values()))
