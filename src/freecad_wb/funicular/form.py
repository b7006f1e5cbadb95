# SPDX-License-Identifier: LGPL-2.1-or-later
"""A gridshell as it stands at one moment: what there is to draw of it and to read from it. Only numpy."""

from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache

import numpy as np

NOBODY = np.zeros(0, dtype=int)


@dataclass(frozen=True)
class Form:
    """Lengths in m, forces in N, compression negative; nodes and members in the numbering of the net.

    nodes, source_nodes: (n, 3), as it stands and as it was laid. members: (m, 2). panels: tuples of nodes.
    member_forces: (m,). reactions: (n, 3), zero where unsupported. tension_members, slack_members: as the
    certificate counts them, empty while a solve goes on. exaggeration: by which the way of the nodes from the
    source is drawn larger than it is. is_certified: whether there is a certificate.
    """

    nodes: np.ndarray
    source_nodes: np.ndarray
    members: np.ndarray
    panels: tuple
    member_forces: np.ndarray
    reactions: np.ndarray
    tension_members: np.ndarray = field(default_factory=lambda: NOBODY)
    slack_members: np.ndarray = field(default_factory=lambda: NOBODY)
    exaggeration: float = 1.0
    is_certified: bool = False

    @cached_property
    def drawn_nodes(self):
        """(n, 3) [m]: where the nodes are drawn, their way from the source `exaggeration` times as long.

        What is drawn over the net, or picked from it, goes by these; what is measured goes by `nodes`.
        """
        if self.exaggeration == 1.0:
            return self.nodes
        return self.source_nodes + self.exaggeration * (self.nodes - self.source_nodes)

    @property
    def member_lengths(self):
        """(m,) [m]"""
        return np.linalg.norm(self.nodes[self.members[:, 1]] - self.nodes[self.members[:, 0]], axis=1)

    def loads(self):
        """(n, 3) [N]: what each node bears, as what its members and its support hold up."""
        ends = self.nodes[self.members[:, 1]] - self.nodes[self.members[:, 0]]
        lengths = np.maximum(np.linalg.norm(ends, axis=1), 1e-300)
        pulls = ends * (self.member_forces / lengths)[:, None]
        loads = -np.array(self.reactions, dtype=float)
        for corner, sign in ((0, -1.0), (1, 1.0)):
            for axis in range(3):
                loads[:, axis] += sign * np.bincount(
                    self.members[:, corner], pulls[:, axis], minlength=len(self.nodes)
                )
        return loads


@lru_cache(maxsize=1)
def _as_laid(net):
    """(nodes, members) of a net: the same objects each time, which say that nothing has changed."""
    return net.nodes, net.members


def form_of_moment(moment):
    """The Form of a live.Moment, which has a result; a dataclasses.replace() away from those on the way."""
    result, net, certificate = moment.result, moment.scene.net, moment.certificate
    return Form(
        result.nodes,
        *_as_laid(net),
        moment.panels,
        result.member_forces,
        result.reactions,
        np.array(certificate.tension_members if certificate else (), dtype=int),
        np.array(certificate.slack_members if certificate else (), dtype=int),
        is_certified=certificate is not None,
    )


def form_as_laid(net):
    """The Form of a Net that bears nothing yet."""
    nothing = np.zeros_like(net.nodes)
    return Form(net.nodes, net.nodes, net.members, net.panels, np.zeros(len(net.members)), nothing)


def other_form(form, nodes, member_forces, reactions):
    """The Form of the same net with other nodes, and the forces that belong to them.

    Forces are none where those that are given are not of as many members and nodes.
    """
    fits = len(member_forces) == len(form.members) and len(reactions) == len(form.nodes)
    return replace(
        form,
        nodes=nodes,
        member_forces=member_forces if fits else np.zeros(len(form.members)),
        reactions=reactions if fits else np.zeros_like(form.nodes),
        tension_members=NOBODY,
        slack_members=NOBODY,
        is_certified=False,
    )


def numbers_of(form):
    """What forms are compared by: a dict of numbers.

    rise, longest_member, mean_deviation, most_deviation (of the nodes, from where they were laid) in m;
    weight, most_compression, most_tension in N.
    """
    away = np.linalg.norm(form.nodes - form.source_nodes, axis=1)
    return {
        "rise": float(np.ptp(form.nodes[:, 2])),
        "weight": float(-form.loads()[:, 2].sum()),
        "longest_member": float(form.member_lengths.max()),
        "most_compression": float(max(-form.member_forces.min(), 0.0)) + 0.0,
        "most_tension": float(max(form.member_forces.max(), 0.0)) + 0.0,
        "mean_deviation": float(away.mean()),
        "most_deviation": float(away.max()),
    }
