# SPDX-License-Identifier: LGPL-2.1-or-later
"""A member or a node of a form in figures, line by line, as the user's unit schema writes them."""

import FreeCAD
import numpy as np

from funicular.gui.drawing.shapes import MILLIMETRES
from funicular.gui.qt import translate
from funicular.gui.units import in_words
from funicular.quantities import DEVIATION, LENGTH, are_in_tension, are_slack

# Of the largest there is: what is smaller is rounding.
NOTHING = 1e-6


def read_member(form, number, section=None):
    """Lines on a member of a Form. section: CrossSection, where one is given."""
    force, length = form.member_forces[number], LENGTH.of(form)[number]
    lines = [
        translate("Member {}").format(number),
        translate("Length {}").format(in_words(length, "m")),
        translate("Force {}").format(in_words(force, "N")) + _sense(form, number),
    ]
    if section is not None:
        stress = section.stresses(np.array([force]))
        lines.append(translate("Stress {}").format(in_words(float(stress[0]), "Pa")))
        if section.measures_utilisation:
            forces, lengths = np.array([force]), np.array([length])
            used = float(section.utilisation(forces, lengths)[0])
            words = translate("Utilisation {}").format(in_words(used, ""))
            if section.modulus is not None and used > 0.0:
                if used == float(section.buckling(forces, lengths)[0]):
                    words += ", " + translate("by buckling")
            lines.append(words)
    if form.source_nodes is not form.nodes:
        lines.append(translate("{} from the source").format(in_words(DEVIATION.of(form)[number], "m")))
    return "\n".join(lines)


def _sense(form, number):
    if are_slack(form)[number]:
        return ": " + translate("slack, carries nothing")
    return ", " + (translate("tension") if are_in_tension(form)[number] else translate("compression"))


def read_node(form, number, placement):
    """Lines on a node of a Form. placement: FreeCAD.Placement of the gridshell in the document."""
    height = placement.multVec(FreeCAD.Vector(*(form.nodes[number] * MILLIMETRES))).z / MILLIMETRES
    lines = [translate("Node {}").format(number), translate("Height {}").format(in_words(height, "m"))]
    loads, reactions = form.loads(), form.reactions
    largest = max(np.abs(loads).max(), np.abs(reactions).max())
    for words, force in (
        (translate("Load {}"), loads[number]),
        (translate("Reaction {}"), reactions[number]),
    ):
        if np.linalg.norm(force) > NOTHING * largest:
            lines.append(words.format(_in_parts(force, largest)))
    return "\n".join(lines)


def _in_parts(force, largest):
    """1.2 kN upward, 300 N sideways"""
    level, up = float(np.hypot(*force[:2])), float(force[2])
    parts = []
    if abs(up) > NOTHING * largest:
        parts.append(
            (translate("{} upward") if up > 0.0 else translate("{} downward")).format(in_words(abs(up), "N"))
        )
    if level > NOTHING * largest:
        parts.append(translate("{} sideways").format(in_words(level, "N")))
    return ", ".join(parts)
