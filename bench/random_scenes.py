# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random scenes of the kinds that architects make: what predictions are fitted to, and tried on."""

import numpy as np

import funicular as fn

KINDS, SHARES = ("flat", "dome", "barrel", "hill", "tube"), (0.45, 0.2, 0.1, 0.2, 0.05)
SIDES = {"u_min": (1, 0, 0), "u_max": (1, 0, 0), "v_min": (0, 1, 0), "v_max": (0, 1, 0)}

# Powers of ten between which are: nodes, size [m], stiffness [N], weights [kg/m, kg/m²], snow [N/m²],
# accuracy [m].
NODES, SIZE, STIFFNESS = (2.0, 4.2), (0.7, 1.8), (4.0, 9.0)
MEMBER, COVERING, SNOW, ACCURACY = (0.5, 1.7), (1.0, 2.0), (2.0, 3.3), (-6.0, -2.0)


def random_scene(rng):
    """(Scene, accuracy [m]) of a numpy Generator."""
    power = lambda limits: 10.0 ** rng.uniform(*limits)  # noqa: E731
    kind = rng.choice(KINDS, p=SHARES)
    patterns = [pattern for pattern in fn.patterns() if not pattern.startswith("ribs")]
    pattern = "quad" if rng.random() < 0.55 else rng.choice(patterns)
    size, aspect = power(SIZE), rng.uniform(0.5, 1.0)
    lattice = _lattice(power(NODES), aspect, pattern, kind)
    net = lattice.net(size * _surface(kind, *lattice.uv.T, aspect, rng))
    held = "border" if kind in ("dome", "tube") else rng.choice(["border", "corners", "planes"])
    effects = [fn.AxialStiffness(power(STIFFNESS), compression_only=bool(rng.random() < 0.85))]
    if rng.random() < 0.8:
        effects.append(fn.MemberWeight(power(MEMBER)))
    if rng.random() < 0.7 or len(effects) == 1:
        effects.append(fn.CoveringWeight(power(COVERING)))
    if rng.random() < 0.3:
        effects.append(fn.Snow(power(SNOW)))
    return fn.Scene(net, _supports(held, net, lattice), effects), power(ACCURACY)


def _lattice(nodes, aspect, pattern, kind):
    per_cell = len(fn.lattice(8, 8, pattern=pattern).uv) / 64.0
    along_u, along_v = fn.cell_extent(pattern)
    cells_u = max(4, round(np.sqrt(nodes / per_cell / aspect * along_v / along_u)))
    cells_v = max(4, round(nodes / per_cell / cells_u))
    poles = ["v_max"] if kind == "dome" else []
    return fn.lattice(cells_u, cells_v, pattern=pattern, closed_u=kind in ("dome", "tube"), poles=poles)


def _surface(kind, u, v, aspect, rng):
    """(n, 3) points of a surface of about the size one."""
    around = 2 * np.pi * u
    if kind == "dome":
        rise = np.radians(rng.uniform(0, 60))
        rise = rise + (np.pi / 2 - rise) * v
        flat = np.cos(rise)
        return 0.5 * np.column_stack([flat * np.cos(around), flat * np.sin(around), np.sin(rise)])
    if kind == "tube":
        return 0.5 * np.column_stack([np.cos(around), np.sin(around), 1.5 * v])
    if kind == "barrel":
        across = np.pi * (u - 0.5) * rng.uniform(0.3, 1)
        return np.column_stack([np.sin(across) / 2, aspect * v, np.cos(across) / 2])
    height = rng.uniform(0.02, 0.3) if kind == "hill" else 0.0
    return np.column_stack([u, aspect * v, height * np.sin(np.pi * u) * np.sin(np.pi * v)])


def _supports(held, net, lattice):
    if held == "border":
        return [fn.Fixed(net.border)]
    supports = [fn.Fixed(lattice.corners)]
    if held == "planes":
        for side, nodes in lattice.sides.items():
            inner = np.setdiff1d(nodes, lattice.corners)
            supports.append(fn.OnPlane(inner, SIDES[side]))
    return supports
