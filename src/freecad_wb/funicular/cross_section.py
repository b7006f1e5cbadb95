# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a member is made of across: its shape, its size, and what its material bears. Needs numpy only."""

import math
from dataclasses import dataclass

import numpy as np

import funicular as fn


@dataclass(frozen=True)
class CrossSection:
    """A solid section, round or rectangular, the same for all members.

    Parameters
    ----------
    width : float
        [m]: the diameter of a round one.
    height : float, optional
        [m], of a rectangular one.
    strength : float, optional
        [Pa]: the stress that the material bears, counted alike in compression and in tension.
    modulus : float, optional
        [Pa]: Young's modulus, for buckling.

    Raises InvalidInput that names the argument for what is not finite or not greater than zero.
    """

    width: float
    height: float = None
    strength: float = None
    modulus: float = None

    def __post_init__(self):
        for name in ("width", "height", "strength", "modulus"):
            value = getattr(self, name)
            if value is not None and not (math.isfinite(value) and value > 0.0):
                raise fn.InvalidInput(f"{name} is {value:g}: give a number greater than zero, or none")

    @property
    def area(self):
        """[m²]"""
        if self.height is None:
            return math.pi * self.width**2 / 4.0
        return self.width * self.height

    @property
    def least_moment(self):
        """Second moment of area about the weak axis [m⁴]."""
        if self.height is None:
            return math.pi * self.width**4 / 64.0
        return max(self.width, self.height) * min(self.width, self.height) ** 3 / 12.0

    @property
    def measures_utilisation(self):
        """Whether anything is given that a member can use up."""
        return self.strength is not None or self.modulus is not None

    def stresses(self, forces):
        """Forces [N] as stresses [Pa], compression negative."""
        return np.asarray(forces) / self.area

    def utilisation(self, forces, lengths):
        """Shares of what members of these forces [N] and lengths [m] bear; 1 is all of it.

        The larger of stress over strength and, in compression, force over Euler's load of a member with
        pinned ends, each where it is known.
        """
        share = np.zeros(len(forces))
        if self.strength is not None:
            share = np.abs(self.stresses(forces)) / self.strength
        if self.modulus is not None:
            share = np.maximum(share, self.buckling(forces, lengths))
        return share

    def buckling(self, forces, lengths):
        """Forces [N] over Euler's loads π²EI/L² of members of these lengths [m]; 0 in tension."""
        return np.maximum(-np.asarray(forces), 0.0) * np.asarray(lengths) ** 2 / self.stiffness

    @property
    def stiffness(self):
        """π²EI [N m²]"""
        return math.pi**2 * self.modulus * self.least_moment
