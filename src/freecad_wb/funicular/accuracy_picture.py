# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of an accuracy study: time against error, one colour a method."""

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from .wording import length_text, time_text

PAPER, INK, QUIET = "#f4f3ef", "#22262b", "#6b7178"
COLOURS = {"auto": "#1f5fa8", "newton": "#2e8b57", "relaxation": "#c0562f"}
NAMES = {"auto": "Auto", "newton": "Newton, factorised", "relaxation": "Relaxation (Brivio et al. 2009)"}

# What rounding leaves is drawn here, as a logarithm has no zero.
SMALLEST = 1e-12  # [m]


def draw(study, path, chosen=None, method=None):
    """Draws a Study; see Study.plot."""
    by_step = study.of_net is not None and len(study.rows_of_own_step()) < len(study.rows)
    figure = Figure(figsize=(14.0 if by_step else 9.0, 5.6), dpi=140, facecolor=PAPER)
    FigureCanvasAgg(figure)
    # The same place on the paper whether or not there is a second picture beside it.
    share = 9.0 / 14.0 if by_step else 1.0
    axes = figure.add_axes([0.13 * share, 0.12, 0.84 * share, 0.68], facecolor="white")
    # Room for what is written beside points.
    axes.margins(x=0.12, y=0.1)
    draw_on(axes, study.rows_of_own_step(), chosen, method)
    heading(
        figure,
        0.13 * share,
        "What accuracy costs",
        (f"{len(study.reference)} nodes; full: measured against the shape at 1e-12; dashed: as it was told"),
    )
    if by_step:
        axes = figure.add_axes([0.715, 0.12, 0.265, 0.68], facecolor="white", sharey=axes)
        draw_steps_on(axes, study.rows, chosen)
        axes.set_ylabel("")
        heading(figure, 0.715, "What the step costs", f"the net is {study.of_net}")
    figure.savefig(path, facecolor=PAPER)


def heading(figure, x, title, below):
    """A title and a quiet line below it, from x of the figure on."""
    figure.text(x, 0.93, title, fontsize=15, color=INK, weight="bold")
    figure.text(x, 0.89, below, fontsize=9, color=QUIET)


def draw_steps_on(axes, rows, chosen=None, in_words=None):
    """Draws what nets of the steps studied take to come to an accuracy, and how far from smooth they are.

    chosen: the accuracy [m], or else the middle one of the study.
    """
    in_words = in_words or length_text
    asked = sorted({row["accuracy"] for row in rows})
    accuracy = chosen if chosen in asked else asked[len(asked) // 2]
    rows = [row for row in rows if row["accuracy"] == accuracy and row["status"] == "converged"]
    own = rows[0]["step"] if rows else None
    for method in dict.fromkeys(row["method"] for row in rows):
        of_method = [row for row in rows if row["method"] == method]
        errors = [row["net_error"] for row in of_method]
        seconds = [row["seconds"] for row in of_method]
        axes.plot(errors, seconds, "o-", color=COLOURS.get(method, INK), zorder=3)
    for step in dict.fromkeys(row["step"] for row in rows):
        # Above all curves, where none can run.
        row = max((row for row in rows if row["step"] == step), key=lambda row: row["seconds"])
        axes.annotate(
            f"step {in_words(step)}",
            (row["net_error"], row["seconds"]),
            xytext=(-4, 9),
            textcoords="offset points",
            ha="right",
            fontsize=9,
            color=INK,
            weight="bold" if step == own else "normal",
        )
    axes.margins(x=0.34, y=0.1)
    _prepare(axes, in_words)
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.set_xlabel(f"distance from the smooth surface, solved to {in_words(accuracy)}", color=INK)


def draw_on(axes, rows, chosen=None, method=None, in_words=None, columns=3):
    """Draws the rows of a Study that converged on matplotlib's axes.

    chosen, method: see Study.plot. in_words(metres): how lengths are written; length_text unless given.
    columns: of the legend.
    """
    in_words = in_words or length_text
    for name in dict.fromkeys(row["method"] for row in rows):
        arrived = [row for row in rows if row["method"] == name and row["status"] == "converged"]
        if arrived:
            _draw_method(axes, name, arrived, chosen if method in (None, name) else None, in_words)
    _prepare(axes, in_words)
    axes.set_xlabel("distance from equilibrium, more accurate to the right", color=INK)
    if axes.get_legend_handles_labels()[1]:
        # Above the axes, where no curve can run.
        axes.legend(frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.01), ncol=columns, fontsize=9)


def _prepare(axes, in_words):
    """Logarithms of lengths, smaller to the right, and of times."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.xaxis.set_inverted(True)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda metres, _: in_words(metres)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda seconds, _: time_text(seconds)))
    axes.set_ylabel("time in the solver", color=INK)
    axes.grid(True, which="major", color="#e3e1da")
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def place_of(row):
    """(distance from equilibrium [m], time [s]) at which a row of a Study is drawn."""
    return max(row["true_error"], SMALLEST), row["seconds"]


def mark(axes, row):
    """Draws a ring around the point of a row."""
    axes.plot(
        *([value] for value in place_of(row)), "o", markersize=15, fillstyle="none", color=INK, zorder=4
    )


def _draw_method(axes, method, rows, chosen, in_words):
    colour = COLOURS.get(method, INK)
    true, seconds = zip(*map(place_of, rows))
    told = [max(row["estimated_error"], SMALLEST) for row in rows]
    axes.plot(true, seconds, "o-", color=colour, label=NAMES.get(method, method), zorder=3)
    axes.plot(told, seconds, "s--", color=colour, markersize=4, linewidth=1, alpha=0.7, zorder=2)
    for row, error, time in zip(rows, true, seconds):
        if row["accuracy"] == chosen:
            mark(axes, row)
            axes.annotate(
                f"{in_words(chosen)} asked: {time_text(time)}",
                (error, time),
                xytext=(0, -22),
                textcoords="offset points",
                ha="center",
                fontsize=9,
                color=INK,
            )
