# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be read of each member of a Form, and shown as its colour. Needs numpy only."""

from dataclasses import dataclass

import numpy as np

# Of the largest force: what pulls less is rounding, as the certificate has it.
NEGLIGIBLE = 1e-9

SIGNED, SHARE, AMOUNT, CATEGORY = "signed", "share", "amount", "category"


@dataclass(frozen=True)
class Quantity:
    """One number for each member.

    name: by which files know it. unit: "N", "Pa", "m", or "" for shares. kind: SIGNED, compression negative;
    SHARE of what is borne, to be seen where it exceeds 1; AMOUNT; or CATEGORY, 0 or 1. from_zero: whether its
    range begins at zero. follows_nodes: whether it changes when nodes move and forces stay. needs: "section"
    or "strength" where a CrossSection, or one with a strength or a modulus, is needed, else "".
    """

    name: str
    unit: str
    kind: str
    from_zero: bool = False
    follows_nodes: bool = False
    needs: str = ""

    def is_known(self, section):
        """Whether a CrossSection, or None, tells enough."""
        if self.needs == "strength":
            return section is not None and section.measures_utilisation
        return section is not None or not self.needs

    def of(self, form, section=None):
        """(m,) of the members of a Form, in `unit`; None where the section does not tell enough."""
        return _VALUES[self.name](form, section) if self.is_known(section) else None


FORCE = Quantity("Force", "N", SIGNED)
STRESS = Quantity("Stress", "Pa", SIGNED, needs="section")
UTILISATION = Quantity("Utilisation", "", SHARE, True, True, needs="strength")
LENGTH = Quantity("Length", "m", AMOUNT, follows_nodes=True)
DEVIATION = Quantity("Deviation", "m", AMOUNT, True, True)
SLACK = Quantity("Slack", "", CATEGORY)

QUANTITIES = {each.name: each for each in (FORCE, STRESS, UTILISATION, LENGTH, DEVIATION, SLACK)}
NAMES = tuple(QUANTITIES)


def deviations(form):
    """(m,) [m]: how far a member is from where it was laid, the mean of its two nodes."""
    away = np.linalg.norm(form.nodes - form.source_nodes, axis=1)
    return away[form.members].mean(axis=1)


def are_in_tension(form):
    """(m,) bool: as the certificate says, or before there is one, what is more than rounding."""
    if form.is_certified:
        return _marked(form.tension_members, len(form.members))
    return form.member_forces > _negligible(form)


def are_slack(form):
    """(m,) bool: likewise."""
    if form.is_certified:
        return _marked(form.slack_members, len(form.members))
    # As it was laid, nothing bears anything, and nothing is known yet.
    return (np.abs(form.member_forces) <= _negligible(form)) & form.member_forces.any()


def _negligible(form):
    return NEGLIGIBLE * np.abs(form.member_forces).max(initial=0.0)


def _marked(numbers, count):
    marked = np.zeros(count, dtype=bool)
    marked[numbers[numbers < count]] = True
    return marked


_VALUES = {
    "Force": lambda form, section: form.member_forces,
    "Stress": lambda form, section: section.stresses(form.member_forces),
    "Utilisation": lambda form, section: section.utilisation(form.member_forces, form.member_lengths),
    "Length": lambda form, section: form.member_lengths,
    "Deviation": lambda form, section: deviations(form),
    "Slack": lambda form, section: are_slack(form).astype(float),
}
