# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a result is, in a sentence: in the document, in the panel, in the report view."""

import FreeCAD as App
import numpy as np

import funicular as fn

from ..panels import Cover
from ..wording import force_text, number, short_length_text

translate = App.Qt.translate

# A net that follows its face more loosely than this is hardly what was wanted.
REMARKABLE_STRETCH = 1.5
# Nor one that has fallen together.
REMARKABLE_SHRINKAGE = 0.1
# [m]: what is less is of no use to anyone who builds.
LEAST_TOLD = 1e-6

# What a user can turn where the solver did not arrive.
PROPERTIES_TO_CHANGE = {
    "time_limit": "MaxSeconds, Accuracy",
    "iteration_limit": "Method, Accuracy",
    "no_equilibrium": "AxialStiffness, the weights",
}


def complaint(status, message):
    """What a solve that did not converge tells a user: its own words, and which properties to change."""
    if status == "cancelled":
        return translate(
            "Funicular", "the solve was cancelled and the last good shape stays; recompute to solve again"
        )
    change = translate("Funicular", "Properties to change: {}.").format(PROPERTIES_TO_CHANGE[status])
    return f"{message} {change}"


def sentence_of(scene, result, certificate, left=None):
    """What a converged Result of a Scene is: "Compression only. 0.4 mm from equilibrium. 184 kN total, …".

    left: what panels.Cover.left() says of the result, for who has it already.
    """
    sentences = [_forces(scene, result, certificate), distance_text(result.position_error)]
    sentences.append(
        translate("Funicular", "{} total, balanced to {:.0e}").format(
            force_text(-certificate.total_load[2]), max(certificate.balance, 1e-16)
        )
    )
    stretch = stretch_of(scene, result)
    if stretch > REMARKABLE_STRETCH:
        sentences.append(
            translate(
                "Funicular", "Members up to {} times as long as on the face: stiffer ones stretch less"
            ).format(number(stretch, ".3g"))
        )
    left = Cover(scene.net).left(result.nodes) if left is None else left
    if left < REMARKABLE_SHRINKAGE:
        sentences.append(
            translate(
                "Funicular",
                "But its panels have shrunk to {} % of their area, as where one point holds all: choose "
                "other supports",
            ).format(number(100 * left, ".2g"))
        )
    return ". ".join(sentences) + "."


def distance_text(position_error):
    """0.4 mm from equilibrium. position_error: [m]"""
    if position_error < LEAST_TOLD:
        return translate("Funicular", "Less than {} from equilibrium").format(short_length_text(LEAST_TOLD))
    return translate("Funicular", "{} from equilibrium").format(short_length_text(position_error))


def stretch_of(scene, result):
    """Of the most stretched member, its length over that on the face."""
    return float((result.member_lengths / scene.net.source_lengths).max())


def slack_of(scene, certificate):
    """Numbers of the slack members but those between two fixed nodes, where none could carry anything."""
    fixed = np.zeros(len(scene.net.nodes), dtype=bool)
    for support in scene.supports:
        fixed[support.ids] |= isinstance(support, fn.Fixed)
    slack = np.asarray(certificate.slack_members, dtype=int)
    return slack[~fixed[scene.net.members[slack]].all(axis=1)].tolist()


def _forces(scene, result, certificate):
    if certificate.compression_only:
        words = translate("Funicular", "Compression only, at most {}").format(
            force_text(-result.member_forces.min())
        )
        slack = len(slack_of(scene, certificate))
        return words + (translate("Funicular", ", {} slack").format(slack) if slack else "")
    if len(certificate.tension_members):
        return translate("Funicular", "{} of {} members in tension, at most {}").format(
            len(certificate.tension_members),
            len(result.member_forces),
            force_text(certificate.worst_tension),
        )
    return certificate.summary().rstrip(".")
