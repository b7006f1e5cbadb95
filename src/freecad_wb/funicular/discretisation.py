# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a net is from the smooth surface it stands for: Richardson's extrapolation over nets of step h, 2h
and 4h. Lengths are metres.

Where members are the straight beams that will be built, the net is the structure itself and this is no error:
it says by how much the shape would be another one if the beams were shorter and closer.
"""

from dataclasses import dataclass, replace

import numpy as np

import funicular as fn

# Second order is what straight members give where nothing is singular. First is what is taken where too few
# nets are there to measure it, as corners and free edges have no more.
FULL_ORDER, UNMEASURED_ORDER = 2.0, 1.0

# Below this order differences hardly shrink from net to net, and their sum is of no use.
LEAST_ORDER = 0.5

# Of shapes that others are measured against: accuracy relative to the net's size, and residual.
ACCURACY, TOLERANCE = 1e-12, 1e-10


@dataclass(frozen=True)
class NetError:
    """Estimated distance of a net from its smooth surface.

    distance: the largest over its nodes [m]. order: with which it falls with the step, measured on three
    nets; None where there were two. is_smooth: False where the order is below LEAST_ORDER, as beside corners
    and free edges it may be, or was not measured: then finer nets may move by more.
    """

    distance: float
    order: float
    is_smooth: bool

    def at(self, factor):
        """The estimated distance of a net of `factor` times the step [m]."""
        return self.distance * factor**self.order_used

    @property
    def order_used(self):
        """The order that the estimate counts on, between LEAST_ORDER and FULL_ORDER."""
        return UNMEASURED_ORDER if self.order is None else float(np.clip(self.order, LEAST_ORDER, FULL_ORDER))

    def __str__(self):
        if not self.is_smooth:
            return f"{1e3 * self.distance:.3g} mm or more from a smooth surface"
        return f"{1e3 * self.distance:.3g} mm from the smooth surface it stands for"


def net_error(scene, result=None, max_seconds=60.0):
    """The NetError of the net of a scene.

    scene: a Scene on a lattice of quads or ribs. result: of solving it, as accurately as one has it; without
    it the scene is solved. Nets of twice and, where there are cells enough, four times the step are solved as
    well, which takes about a third of the scene's own time. max_seconds: for each.

    Raises InvalidInput for a result of another net, as `Scene.coarsened` does, and where a net has no
    equilibrium that is found.
    """
    if result is None:
        shape = solved_far(scene, max_seconds)
    elif result.status != "converged":
        raise fn.InvalidInput(
            f"result did not converge ({result.status}): solve the scene first, or give none"
        )
    else:
        shape = np.asarray(result.nodes, dtype=float)
        if shape.shape != scene.net.nodes.shape:
            raise fn.InvalidInput(
                f"result has {len(shape)} nodes, the scene's net has {len(scene.net.nodes)}: give the result "
                "of solving this scene"
            )
    nets = coarser(scene, 2)
    return from_shapes([shape, *(solved_far(net.scene, max_seconds) for net in nets)], nets)


@dataclass(frozen=True)
class CoarserNet:
    """A scene of a multiple of the step, and (k,) the nodes of the next finer one that it keeps."""

    scene: object
    kept: np.ndarray


def coarser(scene, most):
    """CoarserNets of twice, four times, … the step, `most` of them or as many as there can be, one at least.

    Raises InvalidInput as Scene.coarsened does where there is none.
    """
    nets = []
    for _ in range(most):
        try:
            scene, kept = scene.coarsened()
        except fn.InvalidInput:
            if not nets:
                raise
            break
        nets.append(CoarserNet(scene, np.array(kept)))
    return nets


def from_shapes(shapes, nets):
    """The NetError of the finest of some shapes. shapes: (n, 3) [m], from h to 4h; nets: of 2h, 4h."""
    apart = [
        np.linalg.norm(finer[net.kept] - shape, axis=1) for finer, shape, net in zip(shapes, shapes[1:], nets)
    ]
    order = None
    if len(apart) > 1 and apart[0].any() and apart[1].any():
        # Of the whole net rather than of its worst node, which need not be the same one each time.
        order = float(np.log2(np.sqrt((apart[1] ** 2).mean() / (apart[0] ** 2).mean())))
    if not apart[0].any():
        raise fn.InvalidInput(
            "scene: no node that a net of twice the step keeps can move: there is no telling"
        )
    change = NetError(float(apart[0].max()), order, order is not None and order >= LEAST_ORDER)
    # What all finer nets are still to change: a geometric series.
    return replace(change, distance=change.distance / (2.0**change.order_used - 1.0))


def is_length(value):
    """Whether a value is a finite number, and no truth value."""
    is_number = isinstance(value, (int, float, np.number)) and not isinstance(value, bool)
    return is_number and bool(np.isfinite(value))


class Cancelled(Exception):
    """A solve was ended from outside."""


def solved_far(scene, max_seconds=600.0, on_progress=None):
    """(n, 3) the shape in equilibrium [m], as far as rounding lets one tell.

    on_progress: as of fn.solve. Raises InvalidInput where there is no shape that is found, and Cancelled.
    """
    result = fn.solve(
        scene,
        accuracy=ACCURACY * scene.net.size,
        tolerance=TOLERANCE,
        max_seconds=max_seconds,
        on_progress=on_progress,
    )
    if result.status == "cancelled":
        raise Cancelled
    if result.status != "converged" and not result.residual <= 1e-8:
        raise fn.InvalidInput(f"there is nothing to measure against: {result.message}")
    return np.array(result.nodes)
