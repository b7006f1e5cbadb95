# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a Gridshell with its members coloured by force, made without a window."""

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure

from .colours import ForceScale
from .export import lattice_of
from .features.gridshell import result_line

PAPER = "#f4f3ef"
INK = "#22262b"
QUIET = "#6b7178"
SHADOW = "#dfddd6"
PANEL = (1.0, 1.0, 1.0, 0.5)
INCHES = (14.0, 8.5)
DOTS_PER_INCH = 160

# Distance of the eye from the middle, in diagonals of the gridshell: depth without distortion.
EYE = 3.0

# How much nearer than its panels a member counts, in the same measure.
IN_FRONT = 0.02


def save_picture(shell, path, azimuth=-62.0, elevation=24.0):
    """Draw a Gridshell in perspective into a PNG, PDF or SVG file, by the suffix of the path.

    azimuth, elevation: where the eye stands, degrees (azimuth from +x towards +y). Raises InvalidInput if the
    gridshell has no result.
    """
    nodes, members, panels = lattice_of(shell)
    scale = ForceScale(shell.MemberForces, shell.TensionMembers)
    figure = Figure(figsize=INCHES, dpi=DOTS_PER_INCH, facecolor=PAPER)
    FigureCanvasAgg(figure)
    view = _View(nodes, azimuth, elevation)
    axes = figure.add_axes([0.02, 0.02, 0.83, 0.82])
    _draw_ground(axes, view, nodes, members)
    _draw_lattice(axes, view, nodes, members, panels, scale.member_colours())
    _draw_supports(axes, view.flat(nodes), np.array([tuple(reaction) for reaction in shell.Reactions]))
    axes.set_aspect("equal")
    axes.margins(0.03)
    axes.axis("off")
    _draw_legend(figure.add_axes([0.858, 0.17, 0.018, 0.55]), scale)
    figure.text(0.035, 0.945, shell.Label, size=21, weight="bold", color=INK, va="center")
    figure.text(0.035, 0.903, result_line(shell), size=13, color=INK, va="center")
    figure.text(0.035, 0.868, _measures(shell, nodes, members), size=11.5, color=QUIET, va="center")
    figure.savefig(path, facecolor=PAPER)


def _measures(shell, nodes, members):
    width, depth, rise = np.ptp(nodes, axis=0)
    return "   ·   ".join(
        (
            f"{width:.1f} m × {depth:.1f} m on plan, {rise:.1f} m high",
            f"{len(nodes)} nodes, {len(members)} members",
            f"{shell.TotalWeight.getValueAs('kN').Value:.1f} kN in all",
        )
    )


def _draw_ground(axes, view, nodes, members):
    """The plan of the gridshell at the height of its lowest node: what tells the eye how it stands."""
    ground = nodes.copy()
    ground[:, 2] = nodes[:, 2].min()
    axes.add_collection(LineCollection(view.flat(ground)[members], colors=SHADOW, linewidths=0.8, zorder=1))


def _draw_lattice(axes, view, nodes, members, panels, colours):
    flat, depth = view.flat(nodes), view.depth(nodes)
    # One list from back to front, so that what is near veils what is far.
    items = [(depth[list(panel)].mean(), flat[list(panel)], PANEL, "none", 0.0) for panel in panels]
    # A member lies in front of the panels that it bounds.
    in_front = IN_FRONT * view.size
    width = _shrunk(2.1, len(members))
    items += [
        (depth[member].mean() + in_front, flat[member], "none", colour, width)
        for member, colour in zip(members, colours)
    ]
    _, shapes, faces, edges, widths = zip(*sorted(items, key=lambda item: item[0]))
    axes.add_collection(
        PolyCollection(
            shapes,
            facecolors=faces,
            edgecolors=edges,
            linewidths=widths,
            capstyle="round",
            closed=False,
            zorder=2,
        )
    )


def _shrunk(width, count):
    """A line width that keeps the members of a fine net apart."""
    return width * min(1.0, (1500 / max(count, 1)) ** 0.4)


def _draw_supports(axes, flat, reactions):
    size = np.linalg.norm(reactions, axis=1)
    held = size > 0.0
    stands = held & (np.abs(reactions[:, 2]) > 1e-6 * size.max())
    sideways = held & ~stands
    for nodes, text, style in (
        (stands, "stands here", {"s": 26, "color": INK, "linewidths": 0}),
        (
            sideways,
            "held sideways only",
            {"s": _shrunk(11, 8 * sideways.sum()), "facecolor": PAPER, "edgecolor": INK, "linewidths": 0.6},
        ),
    ):
        if nodes.any():
            axes.scatter(*flat[nodes].T, zorder=3, label=text, **style)
    if held.any():
        axes.legend(loc="lower left", frameon=False, fontsize=11, labelcolor=QUIET, handletextpad=0.2)


class _View:
    """A perspective from one point on the middle of the gridshell."""

    def __init__(self, nodes, azimuth, elevation):
        low, high = nodes.min(axis=0), nodes.max(axis=0)
        self.size = float(np.linalg.norm(high - low))
        self._middle = (low + high) / 2
        turn, rise = np.radians([azimuth, elevation])
        self._towards_eye = np.array([np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)])
        self._right = np.array([-np.sin(turn), np.cos(turn), 0.0])
        self._up = np.cross(self._towards_eye, self._right)

    def depth(self, points):
        return (points - self._middle) @ self._towards_eye

    def flat(self, points):
        away = points - self._middle
        nearness = EYE * self.size / (EYE * self.size - away @ self._towards_eye)
        return np.column_stack([away @ self._right, away @ self._up]) * nearness[:, None]


def _draw_legend(axes, scale):
    heights = np.linspace(0.0, 1.0, 256)
    colours = np.array([[scale.bar_colour(height)] for height in heights])
    axes.imshow(colours, origin="lower", extent=(0.0, 1.0, 0.0, 1.0), aspect="auto")
    marks = scale.marks()
    axes.set_xticks([])
    axes.yaxis.tick_right()
    axes.set_yticks([position for position, _ in marks])
    axes.set_yticklabels([scale.text(force) for _, force in marks], size=12, color=INK)
    axes.tick_params(length=4, color=QUIET)
    for spine in axes.spines.values():
        spine.set_edgecolor(QUIET)
        spine.set_linewidth(0.6)
    axes.text(0.0, 1.085, f"Member force [{scale.unit}]", size=12, weight="bold", color=INK)
    if scale.largest_tension > 0.0:
        axes.text(0.0, 1.035, "tension +", size=10.5, color=QUIET)
    axes.text(0.0, -0.055, "compression \u2212", size=10.5, color=QUIET)
