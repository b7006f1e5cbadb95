# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clipping of panels by an outline, of which only signs are known: what is left of each, as rings of nodes.

A node is inside (1), on the outline (0) or outside (-1); an edge between inside and outside is cut once. So
two panels always agree on what is left of the edge between them. Numbers only: knows nothing of FreeCAD.
"""

from dataclasses import dataclass
from itertools import chain

import numpy as np


@dataclass(frozen=True)
class Rings:
    """Panels as one list of nodes, and the edges between them.

    nodes: of all panels, one after the other. first: (p + 1,) where each panel begins. panel: of each entry.
    edges: (k, 2) pairs of nodes, the lower first, once each. edge: of each entry, to the next.
    """

    nodes: np.ndarray
    first: np.ndarray
    panel: np.ndarray
    edges: np.ndarray
    edge: np.ndarray

    @classmethod
    def of(cls, panels):
        """panels: sequence of sequences of node numbers."""
        counts = np.fromiter(map(len, panels), dtype=np.int64, count=len(panels))
        first = np.concatenate([[0], np.cumsum(counts)])
        nodes = np.fromiter(chain.from_iterable(panels), dtype=np.int64, count=first[-1])
        panel = np.repeat(np.arange(len(counts)), counts)
        following = np.arange(len(nodes)) + 1
        following[first[1:] - 1] = first[:-1]
        after = nodes[following]
        keys = np.minimum(nodes, after) * (nodes.max(initial=0) + 1) + np.maximum(nodes, after)
        keys, edge = np.unique(keys, return_inverse=True)
        edges = np.column_stack(np.divmod(keys, nodes.max(initial=0) + 1))
        return cls(nodes, first, panel, edges, edge)

    def select(self, panels):
        """Tuples of the nodes of some panels."""
        nodes = self.nodes.tolist()
        return [
            tuple(nodes[a:b]) for a, b in zip(self.first[panels].tolist(), self.first[panels + 1].tolist())
        ]


def clip(rings, sign, cut_node, gap):
    """(whole, pieces, doubtful): panels that stay as they are, and what is left of others.

    sign: (n,) of each node. cut_node: (k,) number of the node on each edge that is cut, -1 elsewhere.
    whole: numbers of panels. pieces: list of (panel, ring). doubtful: list of (panel, rings as one,
    rings apart), of which only positions can tell: panels that the outline crosses twice, where it may be
    what lies between the crossings or what lies beyond them, and those without an inner node.
    """
    count = len(rings.first) - 1
    of_entry = sign[rings.nodes]
    inner = np.bincount(rings.panel[of_entry > 0], minlength=count) > 0
    outer = np.bincount(rings.panel[of_entry < 0], minlength=count) > 0
    on = np.bincount(rings.panel[of_entry == 0], minlength=count)
    cuts = cut_node[rings.edge]
    crossed = np.bincount(rings.panel[cuts >= 0], minlength=count)
    whole = np.flatnonzero(inner & ~outer & (crossed == 0))
    pieces, doubtful = [], []
    partly = (inner & outer) | (inner & (crossed > 0)) | (~inner & (on + crossed >= 3))
    for panel in np.flatnonzero(partly).tolist():
        entries = slice(rings.first[panel], rings.first[panel + 1])
        runs = _runs(*(each[entries].tolist() for each in (rings.nodes, of_entry, cuts, gap[rings.edge])))
        joined = tuple(chain.from_iterable(runs))
        if not inner[panel]:
            doubtful.append((panel, joined, ()))
        elif len(runs) == 1:
            if len(joined) >= 3:
                pieces.append((panel, joined))
        else:
            doubtful.append((panel, joined, tuple(tuple(run) for run in runs if len(run) >= 3)))
    return whole, pieces, doubtful


def _runs(nodes, signs, cuts, gaps):
    """The nodes that stay of one ring, in runs between those that are gone."""
    runs = [[]]
    for node, sign, cut, gap in zip(nodes, signs, cuts, gaps):
        if sign >= 0:
            runs[-1].append(node)
        elif runs[-1]:
            runs.append([])
        if cut >= 0 and gap:
            runs += [[cut]] if sign == 0 else [[]]
            runs[-2] += [cut] if sign != 0 else []
        elif cut >= 0:
            runs[-1].append(cut)
    # The ring is closed: what comes last goes on in what came first, unless a node between is gone.
    if len(runs) > 1 and signs[0] >= 0:
        runs[0] = runs.pop() + runs[0]
    return [run for run in runs if run]


def border(panels):
    """(edges, twice): directed edges (k, 2) of panels that no other panel has, and edges that more than one
    panel has the same way round."""
    rings = Rings.of(panels)
    following = np.arange(len(rings.nodes)) + 1
    following[rings.first[1:] - 1] = rings.first[:-1]
    ahead = rings.nodes < rings.nodes[following]
    count = len(rings.edges)
    forwards = np.bincount(rings.edge[ahead], minlength=count)
    backwards = np.bincount(rings.edge[~ahead], minlength=count)
    twice = np.flatnonzero((forwards > 1) | (backwards > 1))
    alone = (forwards + backwards == 1)[rings.edge]
    return np.column_stack([rings.nodes, rings.nodes[following]])[alone], rings.edges[twice]


def loops(edges):
    """(loops, ambiguous): closed chains of directed edges (k, 2), and the nodes that more than one leaves."""
    order = np.argsort(edges[:, 0], kind="stable")
    starts, counts = np.unique(edges[:, 0], return_counts=True)
    ambiguous = starts[counts > 1]
    following = dict(edges[order].tolist())
    found, seen = [], set()
    for start in starts.tolist():
        if start in seen:
            continue
        loop, at = [], start
        while at not in seen and at in following:
            seen.add(at)
            loop.append(at)
            at = following[at]
        found.append(np.array(loop))
    return found, ambiguous
