# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a Gridshell with its members coloured by force, made without a window."""

from textwrap import wrap

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure

from .export import lattice_of
from .features.form_of import form_of
from .features.gridshell import result_line
from .quantities import FORCE, are_in_tension
from .scale import Scale

PAPER = "#f4f3ef"
INK = "#22262b"
QUIET = "#6b7178"
SHADOW = "#dfddd6"
SLACK = "#9b9a95"
PANEL = (1.0, 1.0, 1.0, 0.5)
INCHES = (14.0, 8.5)
DOTS_PER_INCH = 160

# Distance of the eye from the middle, in diagonals of the gridshell: depth without distortion.
EYE = 3.0

# Layers: panels, on them members, on those supports.
BEHIND, IN_FRONT = 2, 5

# Dashes of a slack member, in line widths.
DASHES = (0, (2.5, 2.0))


def save_picture(shell, path, azimuth=-62.0, elevation=24.0):
    """Draw a Gridshell in perspective into a PNG, PDF or SVG file, by the suffix of the path.

    azimuth, elevation: where the eye stands, degrees (azimuth from +x towards +y). Raises InvalidInput if the
    gridshell has no result.
    """
    nodes, members, panels = lattice_of(shell)
    form = form_of(shell)
    scale = Scale(form.member_forces, FORCE, are_in_tension(form))
    figure = Figure(figsize=INCHES, dpi=DOTS_PER_INCH, facecolor=PAPER)
    FigureCanvasAgg(figure)
    view = _View(nodes, azimuth, elevation)
    top = _write_heading(figure, shell, nodes, members)
    axes = figure.add_axes([0.02, 0.02, 0.83, top - 0.02])
    _draw_ground(axes, view, nodes, members)
    front = _front_panels(view, nodes, panels)
    _draw_lattice(axes, view, nodes, members, panels, front, scale.colours(), set(shell.SlackMembers))
    reactions = np.array([tuple(reaction) for reaction in shell.Reactions])
    _draw_supports(axes, view.flat(nodes), reactions, _touched_by(front, panels, len(nodes)))
    _draw_key(axes, bool(shell.SlackMembers))
    axes.set_aspect("equal")
    axes.margins(0.03)
    axes.axis("off")
    _draw_legend(figure.add_axes([0.858, 0.17, 0.018, 0.55]), scale)
    figure.savefig(path, facecolor=PAPER)


def _write_heading(figure, shell, nodes, members):
    """Write label, result and measures; returns the height at which they end, as a part of the figure's."""
    texts = (
        (shell.Label, 60, {"size": 21, "weight": "bold", "color": INK}, 0.042),
        (result_line(shell), 125, {"size": 13, "color": INK}, 0.035),
        (_measures(shell, nodes, members), 140, {"size": 11.5, "color": QUIET}, 0.03),
    )
    height = 0.945
    for text, width, style, step in texts:
        for line in wrap(text, width):
            figure.text(0.035, height, line, va="center", **style)
            height -= step
    return height


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


def _front_panels(view, nodes, panels):
    """Whether the eye sees the outer side of each panel: what it sees from inside lies behind."""
    corners = [nodes[list(panel)] for panel in panels]
    centres = np.array([ring.mean(axis=0) for ring in corners]).reshape(-1, 3)
    normals = np.array(
        [np.cross(ring - c, np.roll(ring, -1, axis=0) - c).sum(axis=0) for ring, c in zip(corners, centres)]
    ).reshape(-1, 3)
    # The panels of a lattice turn alike; outside is where they look away from the middle of the ground.
    ground = np.array([*nodes[:, :2].mean(axis=0), nodes[:, 2].min()])
    outwards = 1.0 if (normals * (centres - ground)).sum() >= 0.0 else -1.0
    return outwards * (normals * (view.eye - centres)).sum(axis=1) > 0.0


def _touched_by(front, panels, count):
    """Whether each node bounds a panel in front, or none at all."""
    of_front, of_any = np.zeros(count, dtype=bool), np.zeros(count, dtype=bool)
    for panel, is_front in zip(panels, front):
        of_any[list(panel)] = True
        of_front[list(panel)] |= is_front
    return of_front | ~of_any


def _bounds_front(front, panels, members):
    """Whether each member bounds a panel in front, or none at all."""
    of_front, of_any = set(), set()
    for panel, is_front in zip(panels, front):
        ring = {frozenset(pair) for pair in zip(panel, (*panel[1:], panel[0]))}
        of_any |= ring
        if is_front:
            of_front |= ring
    pairs = [frozenset(pair) for pair in members.tolist()]
    return np.array([pair in of_front or pair not in of_any for pair in pairs], dtype=bool)


def _draw_lattice(axes, view, nodes, members, panels, front, colours, slack):
    """What is behind, then what is in front: panels veil the members behind them and none that they bound,
    whose colours would lie otherwise."""
    flat, depth = view.flat(nodes), view.depth(nodes)
    width = _shrunk(2.1, len(members))
    in_front = _bounds_front(front, panels, members)
    from_back = np.argsort(depth[members].mean(axis=1))
    for layer, is_front in ((BEHIND, False), (IN_FRONT, True)):
        shapes = [flat[list(panel)] for panel, of_front in zip(panels, front) if of_front == is_front]
        axes.add_collection(PolyCollection(shapes, facecolors=[PANEL], edgecolors="none", zorder=layer))
        for dashed in (True, False):
            drawn = [i for i in from_back if in_front[i] == is_front and (int(i) in slack) == dashed]
            axes.add_collection(
                LineCollection(
                    flat[members[drawn]],
                    colors=SLACK if dashed else [colours[i] for i in drawn],
                    linewidths=0.7 * width if dashed else width,
                    linestyles=[DASHES] if dashed else "solid",
                    capstyle="butt" if dashed else "round",
                    zorder=layer + 1,
                )
            )


def _shrunk(width, count):
    """A line width that keeps the members of a fine net apart."""
    return width * min(1.0, (1500 / max(count, 1)) ** 0.4)


def _draw_supports(axes, flat, reactions, in_front):
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
        for layer, of_layer, label in ((BEHIND, ~in_front, None), (IN_FRONT, in_front, text)):
            # Even none in front gives the key its entry.
            if nodes.any():
                axes.scatter(*flat[nodes & of_layer].T, zorder=layer + 2, label=label, **style)


def _draw_key(axes, has_slack):
    if has_slack:
        axes.plot([], [], color=SLACK, linewidth=1.5, linestyle=DASHES, label="slack, without force")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="lower left", frameon=False, fontsize=11, labelcolor=QUIET)


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
        self.eye = self._middle + EYE * self.size * self._towards_eye

    def depth(self, points):
        return (points - self._middle) @ self._towards_eye

    def flat(self, points):
        away = points - self._middle
        nearness = EYE * self.size / (EYE * self.size - away @ self._towards_eye)
        return np.column_stack([away @ self._right, away @ self._up]) * nearness[:, None]


def _draw_legend(axes, scale):
    heights = np.linspace(0.0, 1.0, 256)
    colours = scale.bar_colours(heights)[:, None]
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
    if scale.has_upper:
        axes.text(0.0, 1.035, "tension +", size=10.5, color=QUIET)
    axes.text(0.0, -0.055, "compression \u2212", size=10.5, color=QUIET)
