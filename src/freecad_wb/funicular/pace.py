# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a shape that is shown comes to the one that was found: at an even pace, without overshoot."""

import numpy as np

ARRIVES = 0.8  # [s] after the last change
FOLLOWS = 0.12  # [s], within which what is shown catches up with a solve that goes on after that
NEAR = 1e-4  # of the size of the net: from there on what is shown is what was found


class Pace:
    """Shown nodes on their way to where a solver is.

    The solver may be there within milliseconds, or arrive much later: until ARRIVES after the last change
    what is shown covers equal parts of what is left in equal times, later it follows.
    """

    def __init__(self, nodes, now):
        self.nodes = np.array(nodes, dtype=float)
        self._size = max(float(np.ptp(self.nodes, axis=0).max()), 1e-300)
        self._arrival, self._last = now + ARRIVES, now

    def change(self, now):
        """Something was changed: the way to what comes of it begins now."""
        self._arrival = now + ARRIVES

    def restart(self, nodes, now):
        """Show these nodes, and go on from there."""
        self.nodes = np.array(nodes, dtype=float)
        self._last = now
        self.change(now)

    def toward(self, target, now, ended):
        """Goes on to `target` (n, 3); returns whether it has arrived. ended: the target stays as it is."""
        passed, left = now - self._last, self._arrival - self._last
        self._last = now
        share = passed / left if left > passed else 1.0 - np.exp(-passed / FOLLOWS)
        if left > 0.0 and left <= passed:
            share = 1.0
        away = target - self.nodes
        if ended and (share >= 1.0 or np.abs(away).max(initial=0.0) < NEAR * self._size):
            self.nodes = np.array(target)
            return True
        self.nodes = self.nodes + share * away
        return False
