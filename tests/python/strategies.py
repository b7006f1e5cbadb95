# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random nets, supports, effects, starts and options, for hypothesis.

A `Case` holds plain values, so that what hypothesis prints of a failure is a script that repeats it.
"""

import dataclasses
import math

import numpy as np
from hypothesis import strategies as st

import funicular as fn


@dataclasses.dataclass(frozen=True)
class Case:
    """The arguments of one solve. Rest lengths are factors of the source lengths."""

    nodes: list
    members: list
    panels: list
    supports: list  # (kind, ids, direction, stiffness)
    effects: list  # (class name, *arguments)
    rest_factors: list | None = None
    start: list | None = None
    options: dict = dataclasses.field(default_factory=dict)
    lattice: dict | None = None

    def net(self):
        if self.lattice is not None:
            return fn.lattice(**self.lattice).net(self.nodes)
        return fn.Net(self.nodes, np.array(self.members, dtype=int), self.panels)

    def scene(self):
        net = self.net()
        rest = None if self.rest_factors is None else net.source_lengths * self.rest_factors
        return fn.Scene(
            net, [support_of(*s) for s in self.supports], [effect_of(*e) for e in self.effects], rest
        )

    def solve(self, **changed):
        return fn.solve(self.scene(), start=self.start, **{**self.options, **changed})

    def replace(self, **changed):
        return dataclasses.replace(self, **changed)


def support_of(kind, ids, direction, stiffness):
    if kind == "Fixed":
        return fn.Fixed(ids, stiffness=stiffness)
    return getattr(fn, kind)(ids, direction, stiffness=stiffness)


def effect_of(name, *arguments):
    return getattr(fn, name)(*arguments)


def powers(least, most):
    """10**k, k real: sizes of things that are known to an order of magnitude only."""
    return st.floats(least, most, allow_nan=False, width=32).map(lambda power: float(f"{10.0**power:.4g}"))


def jitter(size):
    return st.floats(-size, size, allow_nan=False, width=16)


@st.composite
def lattices(draw, least_cells=1):
    """A lattice with positions that suit it: a sheet, a tube, a torus, a dome; exact, or a little off."""
    recipe = {"cells_u": draw(st.integers(least_cells, 5)), "cells_v": draw(st.integers(least_cells, 5))}
    form = draw(st.sampled_from(["sheet", "tube", "torus", "dome", "sphere"]))
    if form != "sheet":
        recipe["closed_u"] = True
        recipe["cells_u"] = max(3, recipe["cells_u"])
    if form == "torus":
        recipe["closed_v"] = True
        recipe["cells_v"] = max(3, recipe["cells_v"])
    if form in ("dome", "sphere"):
        recipe["poles"] = ["v_max"] if form == "dome" else ["v_min", "v_max"]
        recipe["cells_v"] = max(2, recipe["cells_v"])
    uv = fn.lattice(**recipe).uv
    u, v = 2 * np.pi * uv[:, 0], uv[:, 1]
    if form == "sheet":
        nodes = [3 * uv[:, 0], 2 * v, 0 * v]
    elif form == "tube":
        nodes = [np.cos(u), np.sin(u), v]
    elif form == "torus":
        radius = 2 + np.cos(2 * np.pi * v)
        nodes = [radius * np.cos(u), radius * np.sin(u), np.sin(2 * np.pi * v)]
    else:
        height = np.pi * (v / 2 if form == "dome" else v - 0.5)
        nodes = [np.cos(height) * np.cos(u), np.cos(height) * np.sin(u), np.sin(height)]
    nodes = np.column_stack(nodes)
    shake = draw(st.sampled_from([0.0, 0.02]))
    if shake:
        nodes += shake * np.sin(7.1 * np.arange(nodes.size) + draw(st.integers(0, 9))).reshape(nodes.shape)
    net = fn.lattice(**recipe).net(nodes)
    return recipe, nodes, net.members.tolist(), [list(panel) for panel in net.panels]


def edges_of(panels):
    edges = {}
    for panel in panels:
        for a, b in zip(panel, panel[1:] + panel[:1]):
            edges.setdefault((min(a, b), max(a, b)), [a, b])
    return list(edges.values())


@st.composite
def triangle_meshes(draw):
    """A bare mesh grown triangle by triangle on its edges: a strip, a fan, a Möbius band, no manifold."""
    panels, count = [[0, 1, 2]], 3
    for _ in range(draw(st.integers(0, 14))):
        edge = draw(st.sampled_from(edges_of(panels)))
        third = draw(st.one_of(st.just(count), st.integers(0, count)))
        if third not in edge:
            panels.append([*edge, third])
            count = max(count, third + 1)
    return None, draw(positions(count)), edges_of(panels), panels


@st.composite
def graphs(draw):
    """Chains, trees and graphs with cycles, in one part or several."""
    count = draw(st.integers(2, 24))
    kind = draw(st.sampled_from(["chain", "tree", "graph", "parts"]))
    members = {}
    for node in range(1, count):
        if kind == "parts" and node % 4 == 0:
            continue
        before = node - 1 if kind in ("chain", "parts") else draw(st.integers(0, node - 1))
        members[(before, node)] = [before, node]
    if kind == "graph":
        ends = st.tuples(st.integers(0, count - 1), st.integers(0, count - 1))
        for a, b in draw(st.lists(ends, max_size=count)):
            if a != b:
                members.setdefault((min(a, b), max(a, b)), [a, b])
    panels = []
    if draw(st.booleans()):
        corners = st.lists(st.integers(0, count - 1), min_size=3, max_size=6, unique=True)
        panels = draw(st.lists(corners, max_size=3)) if count >= 3 else []
    return None, draw(positions(count)), list(members.values()), panels


@st.composite
def positions(draw, count):
    """On a line, in a plane, in space; one in ten nets has a node on top of another."""
    line = np.column_stack([np.arange(count), np.zeros(count), np.zeros(count)])
    shake = draw(st.sampled_from([(0, 0, 0), (0.3, 0.9, 0), (0.3, 0.9, 0.7), (3, 3, 3)]))
    nodes = line + shake * np.array([[draw(jitter(1)) for _ in range(3)] for _ in range(count)])
    if draw(st.integers(0, 9)) == 9:
        nodes[draw(st.integers(0, count - 1))] = nodes[draw(st.integers(0, count - 1))]
    return nodes


nets = st.one_of(lattices(), triangle_meshes(), graphs())

directions = st.one_of(
    st.sampled_from([(0, 0, 1), (1, 0, 0), (0, 1, 0), (1, 0, 1e-5)]),
    st.tuples(*[jitter(1)] * 3).map(lambda d: d if any(d) else (0, 0, 1)),
)


@st.composite
def supports(draw, count):
    given = []
    for _ in range(draw(st.integers(1, 4))):
        kind = draw(st.sampled_from(["Fixed", "Fixed", "OnLine", "OnPlane"]))
        ids = draw(st.lists(st.integers(0, count - 1), min_size=1, max_size=6))
        stiffness = draw(st.one_of(st.just(math.inf), st.just(math.inf), st.just(0.0), powers(-2, 9)))
        given.append((kind, ids, draw(directions), stiffness))
    if draw(st.booleans()):
        # Most parts held somewhere: else most scenes of several parts are refused.
        given.append(("Fixed", list(range(0, count, 4)), (0, 0, 1), math.inf))
    return given


@st.composite
def effects(draw, count, panels, size):
    given = [("AxialStiffness", draw(powers(-2, 12)), draw(st.booleans()))]
    if draw(st.booleans()):
        given.append(("MemberWeight", draw(powers(-3, 3)) / size))
    if draw(st.booleans()) and panels:
        share = draw(st.sampled_from(["angle", "equal", "voronoi"]))
        given.append(("CoveringWeight", draw(powers(-3, 3)) / size**2, share))
    if draw(st.booleans()) and panels:
        given.append(("Snow", draw(powers(-2, 4)) / size**2))
    for _ in range(draw(st.integers(0, 2))):
        ids = draw(st.lists(st.integers(0, count - 1), min_size=1, max_size=4, unique=True))
        strength = draw(powers(-2, 4))
        given.append(("PointLoad", ids, tuple(strength * c for c in draw(directions))))
    if draw(st.integers(0, 9)) == 9:
        given.append(("MemberWeight", 0.0))
    return given


@st.composite
def starts(draw, nodes):
    """None, the wrong sign, or anything."""
    kind = draw(st.sampled_from(["none", "none", "none", "other way up", "anywhere", "a point"]))
    if kind == "none":
        return None
    size = float(np.ptp(nodes, axis=0).max())
    centre = nodes.mean(axis=0)
    if kind == "other way up":
        return (nodes - [0, 0, size * draw(st.sampled_from([0.1, 1.0, 30.0]))]).tolist()
    if kind == "a point":
        return np.tile(centre, (len(nodes), 1)).tolist()
    far = size * draw(st.sampled_from([0.01, 1.0, 100.0]))
    return (
        centre + far * np.sin(3.7 * np.arange(nodes.size) + draw(st.integers(0, 9))).reshape(nodes.shape)
    ).tolist()


@st.composite
def options(draw, size):
    """Every solve is bounded by its iterations, and not by the clock: the same input then does the same."""
    return {
        "tolerance": draw(st.sampled_from([1e-3, 1e-6, 1e-9])),
        "accuracy": size * draw(st.sampled_from([1e-2, 1e-4, 1e-7])),
        "method": draw(st.sampled_from(["auto", "auto", "newton", "relaxation"])),
        "max_iterations": draw(st.sampled_from([0, 1, 7, 300, 1000])),
    }


@st.composite
def cases(draw):
    """Anything that one may ask for, sensible or not."""
    recipe, nodes, members, panels = draw(nets)
    count = len(nodes)
    scale = draw(st.sampled_from([1e-6, 1e-3, 1.0, 1.0, 1.0, 1e3]))
    offset = draw(st.sampled_from([0.0, 0.0, 0.0, 1e6]))
    nodes = nodes * scale + offset
    rest = None
    if draw(st.integers(0, 2)) == 2:
        rest = [draw(powers(-1.5, 1.5)) for _ in members]
    return Case(
        nodes=nodes.tolist(),
        members=members,
        panels=panels,
        supports=draw(supports(count)),
        effects=draw(effects(count, panels, scale)),
        rest_factors=rest,
        start=draw(starts(nodes)),
        options=draw(options(scale)),
        lattice=recipe,
    )


@st.composite
def convex_cases(draw):
    """Scenes whose shape is unique wherever taut members hold every node (`test_properties` tells when).

    Members carry compression only, every one has a weight, and no load is so large for the stiffness that its
    growth with the shape would matter: the strain stays in the per cents.
    """
    recipe, nodes, members, panels = draw(nets)
    count = len(nodes)
    load = draw(powers(0, 2))
    stiffness = load * count * draw(powers(2, 5))
    given = [("AxialStiffness", stiffness, True), ("MemberWeight", load / 10)]
    if panels and draw(st.booleans()):
        given.append(("CoveringWeight", load / 10, draw(st.sampled_from(["angle", "equal", "voronoi"]))))
    if draw(st.booleans()):
        sideways, down = draw(jitter(0.5)), draw(jitter(1))
        given.append(
            ("PointLoad", [draw(st.integers(0, count - 1))], (sideways * load, 0.1 * load, -abs(down) * load))
        )
    held = draw(st.lists(st.integers(0, count - 1), min_size=1, max_size=6, unique=True))
    if draw(st.booleans()):
        held = sorted({*held, *range(0, count, 4)})
    rest = None
    if draw(st.booleans()):
        rest = [draw(st.sampled_from([0.9, 0.97, 1.0, 1.1, 1.2])) for _ in members]
    return Case(
        nodes=nodes.tolist(),
        members=members,
        panels=panels,
        supports=[("Fixed", held, (0, 0, 1), math.inf)],
        effects=given,
        rest_factors=rest,
        options={"tolerance": 1e-9, "accuracy": 1e-8, "max_iterations": 20_000},
        lattice=recipe,
    )
