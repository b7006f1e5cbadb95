# SPDX-License-Identifier: LGPL-2.1-or-later
"""A price tag before the solve: how long it will take, and how much memory. Needs numpy only.

On a lattice of quads or ribs the scene is solved on a net of twice the step or more, with a quarter of the
nodes or fewer, and what that takes is carried over to the whole: how the steps of the solver grow in number
and in price depends on the scene in ways that no formula of its weights and supports tells as well. Elsewhere
a few steps of the solve itself are made, and the rest is a power of what they take, of the nodes, of the
stiffness in loads and of the like, and a factor for the machine.

The exponents are in prediction.json, fitted by bench/prediction.py to random scenes on one machine. The
factors of another one are measured once, by a few small solves (`calibrate`), kept in the user's cache, and
corrected by what solves then really take (`Prediction.observe`).
"""

import json
import pathlib
import time
from dataclasses import dataclass

import numpy as np

import funicular as fn

from . import prediction_cache
from .discretisation import is_length
from .panels import areas

GRAVITY = 9.80665

# Bytes: a node where multigrid solves the steps, and what loads on its panels take more; a member of what is
# factorised, as stiff and small lattices are too.
BYTES_OF_NODE, BYTES_OF_PANELS, BYTES_OF_MEMBER = 1600.0, 800.0, 2200.0

# The coarser net has no more nodes than this, or than this part of the scene's.
PROBE_NODES, PROBE_PART = 200, 0.3
# What a probe may take of the time that is being asked for: where it takes more, that says enough.
PROBE_ITERATIONS, PROBE_SECONDS = 300, 1.0
# Where there is no coarser net, the first steps of the solve itself tell what one takes, and how far it is.
FIRST_STEPS = 4

# Powers of the nodes that time grows with, near where it is told.
GROWTH = {"lattice": 1.15, "factorised": 1.35}

SHORTEST = 2e-4  # [s], what the clock tells well

LATTICE, FACTORISED = "lattice", "factorised"

# Where the solver goes another way (docs/solver.md): stiffness in all loads, and nodes.
STIFFNESS_OF_PATH, NODES_FOR_MULTIGRID, NODES_FOR_MULTIGRID_ON_PATH = 15.0, 300, 5000


@dataclass(frozen=True)
class Prediction:
    """What a solve is expected to take.

    seconds: in the solver. memory: [bytes], on top of the scene. way: that the solver is expected to go, as a
    kind of net, "lattice" or "factorised", and a method.
    """

    seconds: float
    memory: float
    way: tuple

    def __str__(self):
        return f"about {_rounded(self.seconds)}, {max(1.0, self.memory / 1e6):.0f} MB"

    def of_step(self, factor):
        """The Prediction of a net of `factor` times the step, all else being the same."""
        nodes = factor**-2.0
        return Prediction(self.seconds * nodes ** GROWTH[self.way[0]], self.memory * nodes, self.way)

    def observe(self, seconds):
        """Tells what the solve really took [s], so that the next prediction on this machine is nearer."""
        prediction_cache.observe(self.way[0], seconds / self.seconds)


def predict(scene, accuracy=1e-3):
    """The Prediction of fn.solve(scene, accuracy), by its method "auto".

    scene: a Scene. accuracy: [m]. This takes about a third of the solve itself, of a long one not more than a
    second; the first call on a machine a second or two more, see `calibrate`. Raises InvalidInput for an
    accuracy that cannot be meant.
    """
    accuracy = checked_accuracy(accuracy, "accuracy")
    way, features = features_of(scene, accuracy)
    if not prediction_cache.is_calibrated():
        calibrate()
    seconds = by_exponents(way, features) * prediction_cache.factor(way[0])
    net = scene.net
    if "multigrid" in way[1] and way[0] == LATTICE:
        on_panels = any(isinstance(effect, (fn.CoveringWeight, fn.Snow)) for effect in scene.effects)
        memory = (BYTES_OF_NODE + BYTES_OF_PANELS * on_panels) * len(net.nodes)
    else:
        memory = BYTES_OF_MEMBER * len(net.members)
    return Prediction(seconds, memory, way)


def checked_accuracy(value, name):
    """A length [m]. Raises InvalidInput for one that cannot be meant."""
    if not (is_length(value) and value > 0.0):
        raise fn.InvalidInput(f"{name} is {value!r}: give a length in metres, such as 1e-3")
    return float(value)


def by_exponents(way, features):
    """Seconds on the machine that the exponents were fitted on."""
    return max(SHORTEST, float(np.exp(np.dot(_exponents()[" ".join(way)], features))))


def calibrate(on_progress=None):
    """Measures this machine: some small solves of both kinds, a second or two, kept in the user's cache.

    on_progress(done, of) is called after each; returning False ends it, and nothing is kept.
    """
    scenes = list(_calibration_scenes())
    ratios = {LATTICE: [], FACTORISED: []}
    for done, scene in enumerate(scenes, 1):
        way, features = features_of(scene, 1e-3)
        best = min(_processor_seconds(scene, 1e-3) for _ in range(3))
        ratios[way[0]].append(best / by_exponents(way, features))
        if on_progress is not None and on_progress(done, len(scenes)) is False:
            return
    prediction_cache.keep({path: float(np.median(each)) for path, each in ratios.items()})


def _processor_seconds(scene, accuracy):
    """What a solve takes of this thread's own time [s]: other programs may run beside, and the window."""
    begun = time.thread_time()
    fn.solve(scene, accuracy=accuracy)
    return time.thread_time() - begun


def features_of(scene, accuracy):
    """(way, features) that time depends on; an array for `by_exponents`."""
    net = scene.net
    nodes = len(net.nodes)
    probe = _probe(scene, accuracy)
    axial = next(effect for effect in scene.effects if isinstance(effect, fn.AxialStiffness))
    # In loads that a member bears: the pull of a net falls with the number of its lines.
    stiffness = np.median(axial.stiffness) * (np.median(scene.rest_lengths) if axial.per_spring else 1.0)
    # Within what there are figures for: a scene without loads has none.
    in_loads = np.clip(np.log(max(stiffness, 1e-300) / max(_load(scene), 1e-300) / STIFFNESS_OF_PATH), -8, 16)
    stiff = in_loads + 0.5 * np.log(nodes)
    over, under = max(in_loads, 0.0), max(-in_loads - 3.0, 0.0)
    size = np.log(nodes / 1e3)
    held = np.log(sum(len(support.ids) for support in scene.supports) / np.sqrt(nodes))
    digits = -np.log10(accuracy / net.size) - 5.0
    common = [1.0, size, size**2, stiff, over, under, held, digits]
    if probe is not None:
        of_nodes, steps, seconds = probe
        growth, steps, seconds = np.log(nodes / of_nodes), np.log(steps + 1.0), np.log(max(seconds, SHORTEST))
        price = seconds - steps - np.log(of_nodes)
        rest = [seconds, steps, growth, growth * steps, growth * price, growth * over]
        return (LATTICE, _method(nodes, in_loads > 0.0, axial.compression_only)), np.array(common + rest)
    flat = float(np.ptp(net.nodes[:, 2]) < 1e-3 * net.size)
    valence = len(net.members) / nodes
    steps, seconds, residual = _first_steps(scene, accuracy)
    rest = [
        np.log(max(seconds, SHORTEST)),
        np.log(steps + 1.0),
        float(steps < FIRST_STEPS),
        np.log10(np.clip(residual, 1e-9, 1e3)),
        over * size,
        held * over,
        flat,
        flat * over,
        np.log(valence),
        abs(valence - 2.0),
        abs(valence - 3.0),
    ]
    # Without coarser nets there is one way less, and that by factors.
    method = _method(0, in_loads > 0.0, axial.compression_only)
    return (FACTORISED, method), np.array(common + rest)


def _method(nodes, is_stiff, one_way):
    if is_stiff and one_way:
        return "path_by_multigrid" if nodes >= NODES_FOR_MULTIGRID_ON_PATH else "path"
    method = "multigrid" if nodes >= NODES_FOR_MULTIGRID else "factors"
    return method if one_way else method + "_two_way"


def _probe(scene, accuracy):
    """(nodes, steps, seconds) of solving a coarser net, None where there is none that is small enough."""
    most = max(PROBE_NODES, PROBE_PART * len(scene.net.nodes))
    coarse = scene
    while coarse is scene or len(coarse.net.nodes) > most:
        try:
            coarse, _ = coarse.coarsened()
        except fn.InvalidInput:
            break
    if coarse is scene or len(coarse.net.nodes) > 2 * most:
        return None
    begun = time.thread_time()
    result = fn.solve(coarse, accuracy=accuracy, max_iterations=PROBE_ITERATIONS, max_seconds=PROBE_SECONDS)
    return len(coarse.net.nodes), result.iterations, time.thread_time() - begun


def _first_steps(scene, accuracy):
    """(steps, seconds, residual) of the first steps of a solve."""
    begun = time.thread_time()
    result = fn.solve(scene, accuracy=accuracy, max_iterations=FIRST_STEPS, max_seconds=PROBE_SECONDS)
    return result.iterations, time.thread_time() - begun, result.residual


def _load(scene):
    """All that a scene weighs as it was laid [N]."""
    net, load = scene.net, 0.0
    for effect in scene.effects:
        if isinstance(effect, fn.MemberWeight):
            load += GRAVITY * effect.weight * net.source_lengths.sum()
        elif isinstance(effect, fn.CoveringWeight):
            load += GRAVITY * effect.weight * areas(net.nodes, net.panels).sum()
        elif isinstance(effect, fn.Snow):
            load += effect.pressure * areas(net.nodes * [1.0, 1.0, 0.0], net.panels).sum()
        elif isinstance(effect, fn.PointLoad):
            load += len(effect.ids) * float(np.linalg.norm(effect.force))
    return load


def _calibration_scenes():
    for pattern, step in (
        ("quad", 0.5),
        ("quad", 0.25),
        ("triangle", 0.6),
        ("triangle", 0.4),
        ("hexagon", 0.3),
    ):
        net = fn.Net.grid(12.0, 10.0, step, pattern=pattern)
        for stiffness in (1e5, 1e7):
            effects = [fn.AxialStiffness(stiffness), fn.MemberWeight(12.0), fn.CoveringWeight(30.0)]
            yield fn.Scene(net, [fn.Fixed(net.border)], effects)


def _exponents():
    """{path: exponents of the features}."""
    path = pathlib.Path(__file__).with_suffix(".json")
    return {name: np.array(each) for name, each in json.loads(path.read_text("utf-8")).items()}


def _rounded(seconds):
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if seconds >= 0.095 * size:
            return f"{seconds / size:.0f} {unit}" if seconds >= 9.5 * size else f"{seconds / size:.1g} {unit}"
    return "less than 0.1 ms"
