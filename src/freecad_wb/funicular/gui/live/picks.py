# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a gridshell is picked by hand: nodes, and whole edges of its source."""

import numpy as np

from funicular.features.net import nodes_of_element
from funicular.features.node_choice import ELEMENTS, at_nodes


class Picks:
    """Nodes in the order in which they were picked. on_change: callable()."""

    def __init__(self, on_change):
        self._on_change = on_change
        self._nodes, self._elements = {}, []

    def __len__(self):
        return len(self._nodes)

    @property
    def nodes(self):
        """(k,) numbers."""
        return np.array(list(self._nodes), dtype=int)

    @property
    def elements(self):
        """Names of the edges that were picked, if nothing else was."""
        return tuple(self._elements)

    def add(self, nodes):
        self._take(nodes, [])

    def replace(self, nodes):
        self._nodes = {}
        self._take(nodes, [])

    def toggle(self, node):
        if node in self._nodes:
            del self._nodes[node]
            self._elements = []
            self._on_change()
        else:
            self.add([node])

    def add_element(self, net, name):
        """All nodes of an edge of the source of a Net; once more takes it out again."""
        nodes = nodes_of_element(net, name).tolist()
        if name in self._elements:
            self._elements.remove(name)
            kept = {node for each in self._elements for node in nodes_of_element(net, each).tolist()}
            self._nodes = {node: None for node in self._nodes if node in kept or node not in nodes}
            self._on_change()
            return
        elements = [*self._elements, name] if self._elements or not self._nodes else []
        self._take(nodes, elements)

    def clear(self):
        if self._nodes:
            self.replace([])

    def where(self, net):
        """The properties of a Support there: edges by their names, so that they outlive another step."""
        if self._elements:
            return {"Where": ELEMENTS, "Elements": list(self._elements)}
        return at_nodes(net, list(self._nodes))

    def _take(self, nodes, elements):
        self._nodes.update(dict.fromkeys(int(node) for node in nodes))
        self._elements = elements
        self._on_change()
