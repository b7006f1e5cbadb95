# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every pattern on one sheet, relaxed under its own weight and that of a covering. Needs no FreeCAD.

    python3 examples/gallery.py build/gallery/patterns.png
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "src" / "freecad_wb"))

import funicular as fn  # noqa: E402

WIDTH, DEPTH, STEP = 9.0, 7.0, 0.75  # m
PAPER, INK, COVER, COVER_LINE = "#f4f3ef", "#22262b", "#dfe6ec", "#c6cfd7"
AZIMUTH, ELEVATION = np.radians(-62.0), np.radians(32.0)


def relaxed(net):
    """Positions of the net in equilibrium on its border, in compression only."""
    scene = fn.Scene(
        net, [fn.Fixed(net.border)], [fn.AxialStiffness(40e3), fn.MemberWeight(12.0), fn.CoveringWeight(30.0)]
    )
    result = fn.solve(scene, accuracy=1e-4)
    certificate = fn.certify(scene, result)
    if result.status != "converged" or not certificate.compression_only:
        raise RuntimeError(f"{net.lattice.pattern}: {result.message}")
    return result.nodes


def seen(nodes):
    """(n, 2) on the picture, and (n,) how near the eye."""
    nodes = nodes - 0.5 * (nodes.max(axis=0) + nodes.min(axis=0))
    along = np.array([-np.sin(AZIMUTH), np.cos(AZIMUTH), 0.0])
    towards = np.array(
        [np.cos(AZIMUTH) * np.cos(ELEVATION), np.sin(AZIMUTH) * np.cos(ELEVATION), np.sin(ELEVATION)]
    )
    return np.column_stack([nodes @ along, nodes @ np.cross(towards, along)]), nodes @ towards


def draw(axes, nodes, members, panels):
    """Panels from the farthest to the nearest, and on them the members."""
    flat, near = seen(nodes)
    order = sorted(panels, key=lambda panel: near[list(panel)].mean())
    axes.add_collection(
        PolyCollection(
            [flat[list(panel)] for panel in order],
            facecolors=COVER,
            edgecolors=COVER_LINE,
            linewidths=0.4,
        )
    )
    axes.add_collection(LineCollection(flat[members], colors=INK, linewidths=0.8, capstyle="round"))
    axes.set_aspect("equal", adjustable="datalim")
    axes.autoscale_view()
    axes.axis("off")


def sheet_of(lattices, path, columns=4):
    """One sheet of {title: (nodes, members, panels)} into a picture file."""
    lines = -(-len(lattices) // columns)
    figure, places = plt.subplots(lines, columns, figsize=(4.0 * columns, 2.5 * lines), facecolor=PAPER)
    for axes, (title, (nodes, members, panels)) in zip(places.flat, lattices.items()):
        draw(axes, nodes, members, panels)
        axes.set_title(f"{title}   {len(members)} members", fontsize=11, color=INK, loc="left")
    for axes in places.flat[len(lattices) :]:
        axes.set_visible(False)
    figure.tight_layout(pad=1.2)
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110, facecolor=PAPER)
    print(f"drawn: {path}")


def main(path):
    nets = {
        name.replace("_", " ").capitalize(): fn.Net.grid(WIDTH, DEPTH, step=STEP, pattern=name)
        for name in fn.patterns()
    }
    sheet_of({title: (relaxed(net), net.members, net.panels) for title, net in nets.items()}, path)


if __name__ == "__main__":
    main(*sys.argv[1:])
