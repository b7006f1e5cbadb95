# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cheapest settings for a wished accuracy, the net's step among them. Lengths are metres."""

from dataclasses import dataclass

import numpy as np

import funicular as fn

from .discretisation import LEAST_ORDER, coarser, from_shapes, solved_far
from .prediction import checked_accuracy, predict
from .wording import length_text, time_text

# Of the wish what the net may take; the solver, for which digits are cheap, has the rest.
PART_OF_NET = 0.9

# Below this multiple of the scene's step an estimate by its own coarser nets says nothing.
FINEST = 1.0 / 16.0


@dataclass(frozen=True)
class Settings:
    """What to ask for, and what it will cost.

    overall: the wish [m]. step: mean length of members [m]. lines: by which EA and weight of members are to
    be multiplied, since each stands for as many of the scene's lines; 1 for ribs. accuracy: of the solver
    [m]. net_error: estimated distance of the net from the smooth surface it stands for [m]. seconds:
    predicted.
    """

    overall: float
    step: float
    lines: float
    accuracy: float
    net_error: float
    seconds: float

    def __str__(self):
        members = "" if self.lines == 1.0 else f"EA and weight of members times {self.lines:.3g}, "
        return (
            f"{length_text(self.overall)} overall: step {length_text(self.step)}, {members}"
            f"{time_text(self.seconds)}"
        )


def cheapest(scene, overall, max_seconds=60.0):
    """The Settings by which net and solver together are estimated to be within `overall` [m] of the surface.

    scene: a Scene on a lattice of quads or ribs; what it weighs and how it is held is what counts, its step
    is only where to begin. Nets of twice, four and eight times the step are solved, none of the scene's own,
    which takes about a tenth of its time. Where members are the straight beams that will be built there is no
    such smooth surface, and any step is right.

    Raises InvalidInput for a length that cannot be meant, for nets as `Scene.coarsened` does and such as have
    fewer than three coarser ones, where differences do not fall with the step, as beside free edges, and for
    a step much finer than the scene's.
    """
    overall = checked_accuracy(overall, "overall")
    nets = coarser(scene, 3)
    if len(nets) < 3:
        raise fn.InvalidInput(
            "scene: its net has too few cells to be halved three times and tell a step: refine it"
        )
    shapes = [solved_far(net.scene, max_seconds) for net in nets]
    error = from_shapes(shapes, nets[1:])
    if not error.is_smooth or error.distance == 0.0:
        raise fn.InvalidInput(
            f"scene: nets of larger steps come nearer to no smooth surface (order {error.order or 0.0:.2g}, "
            f"{LEAST_ORDER:g} at least), as where edges or corners hang free, or where nets of four and "
            "eight times the step are too coarse: no step can be told, unless a finer net tells one"
        )
    own = float(np.mean(scene.net.source_lengths))
    # Its distance is that of the net of twice the step.
    factor = 2.0 * (PART_OF_NET * overall / error.distance) ** (1.0 / error.order_used)
    if factor < FINEST:
        raise fn.InvalidInput(
            f"scene: {length_text(overall)} takes a step of less than {length_text(FINEST * own)}, too far "
            "from its own to be told: give a finer net, or a larger length"
        )
    # No wider than the coarsest net that was looked at.
    factor = float(min(factor, 2.0 ** len(nets)))
    told = error.at(factor / 2.0)
    accuracy = max(overall - told, (1.0 - PART_OF_NET) * overall)
    price = predict(scene, accuracy).of_step(factor)
    of_ribs = scene.net.lattice is not None and scene.net.lattice.pattern.startswith("ribs")
    lines = 1.0 if of_ribs else factor
    return Settings(overall, factor * own, lines, accuracy, told, price.seconds)
