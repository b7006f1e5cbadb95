# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Net in the document: a source and how it is divided; its shape is the net before relaxation."""

import FreeCAD as App
import Part
import numpy as np

import funicular as fn

from ..edits import Edits, Places, edited
from ..lattices import lattice_on
from .elements import kinds_of
from .feature import Feature
from .net_laying import lay
from .net_properties import PATTERNS, PROPERTIES, pattern_of
from .source import read_source

# OCCT takes points within 1e-7 mm of each other for one.
SHORTEST_EDGE = 1e-7


class Net(Feature):
    """Proxy of a Net: lays a pattern on its source. Lengths in mm."""

    TYPE = "Net"
    PROPERTIES = PROPERTIES

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        if name == "Source" and "Restore" not in obj.State and hasattr(obj, "SourceBody"):
            # A new pick is trusted; from then on the body may not become another one.
            obj.SourceBody = ""
            if obj.Source is not None:
                # Or a net whose source is deleted would be the sheet that it was before.
                obj.Width, obj.Depth, obj.File = 0.0, 0.0, ""

    def compute(self, obj):
        source = read_source(obj)
        laid, on_elements = lay(obj, source)
        laid, openings, numbers = edited(laid, _edits(obj), places_of(laid))
        _write(obj, laid)
        obj.NodeNumbers = numbers.tolist() if len(numbers) and (openings or laid.lattice is None) else []
        own = {int(number): node for node, number in enumerate(numbers)}
        on_elements = {
            element: [own[node] for node in nodes.tolist() if node in own]
            for element, nodes in on_elements.items()
        }
        obj.SourceElements, obj.ElementNodes = list(on_elements), flat_panels(on_elements.values())
        obj.ElementKinds = kinds_of(source.body, on_elements) if on_elements else []
        obj.OpeningRims = flat_panels(laid.openings)
        obj.OpeningNodes = flat_panels(opening.nodes for opening in openings)
        obj.OpeningAreas = [opening.area for opening in openings]
        obj.SourceBody = getattr(source, "described", "")


def _edits(obj):
    if len(obj.RaisedNodes) != len(obj.RaisedHeights):
        raise fn.InvalidInput(
            f"RaisedNodes names {len(obj.RaisedNodes)} nodes, but RaisedHeights has {len(obj.RaisedHeights)} "
            "values: give one for each"
        )
    for name in ("Raised", "RemovedPanels", "RemovedMembers"):
        for k, at in enumerate(getattr(obj, name)):
            if not (_is_share(at.x) and _is_share(at.y) and np.isfinite(at.z)):
                raise fn.InvalidInput(
                    f"{name}[{k}] is ({at.x:g}, {at.y:g}, {at.z:g}): give u and v between 0 and 1, shares of "
                    "the face's length"
                )
    for k, height in enumerate(obj.RaisedHeights):
        if not np.isfinite(height):
            raise fn.InvalidInput(f"RaisedHeights[{k}] is {height:g}: give a length in mm")
    raised = [((at.x, at.y), at.z) for at in obj.Raised]
    return Edits(
        raised + list(zip(obj.RaisedNodes, obj.RaisedHeights)),
        [(at.x, at.y) for at in obj.RemovedMembers] + list(obj.RemovedMemberNumbers),
        [(at.x, at.y) for at in obj.RemovedPanels] + list(obj.RemovedPanelNumbers),
    )


def _is_share(value):
    return -1e-9 <= value <= 1.0 + 1e-9


def places_of(laid):
    """Where the nodes of a Laid net are on the face."""
    return Places(laid.uv, laid.closed, laid.poles)


def _write(obj, laid):
    # The shape first: it is what may fail, and then no number has changed.
    obj.Shape = edges_of(laid.nodes, laid.members)
    obj.SourceNodes = to_vectors(laid.nodes)
    obj.SampledPattern, obj.SampledSwap = obj.Pattern, obj.SwapUV
    obj.CellsU, obj.CellsV = laid.cells
    obj.ClosedU, obj.ClosedV, obj.Poles = *laid.closed, sorted(laid.poles)
    obj.Members = [] if laid.lattice else np.asarray(laid.members).ravel().tolist()
    obj.Panels = [] if laid.lattice else flat_panels(laid.panels)
    obj.NodePlaces = to_vectors(np.column_stack([laid.uv, 0 * laid.uv[:, 0]])) if laid.uv is not None else []
    obj.NodeCount, obj.MemberCount, obj.PanelCount = len(laid.nodes), len(laid.members), len(laid.panels)
    obj.Remarks = "; ".join(laid.remarks)


def net_of(obj):
    """The fn.Net (metres) of a Net object as it was last computed, placed as it stands.

    Raises InvalidInput if it was never computed.
    """
    if not obj.SourceNodes:
        raise fn.InvalidInput(f"Net {obj.Label} has no nodes: {obj.getStatusString()}; mend its source first")
    nodes = positions_of(obj) * 1e-3
    if obj.Members:
        return fn.Net(nodes, np.array(obj.Members).reshape(-1, 2), panels_of(obj.Panels))
    lattice, _ = lattice_on(
        (obj.CellsU, obj.CellsV),
        (obj.ClosedU, obj.ClosedV),
        obj.Poles,
        # Files of before hold no other pattern than the first.
        pattern_of(obj.SampledPattern or PATTERNS[0]),
        obj.SampledSwap,
    )
    return lattice.net(nodes)


def positions_of(obj):
    """(n, 3) nodes [mm] of a Net object, placed as it stands."""
    place = obj.Placement.Matrix
    return np.array([tuple(place.multVec(node)) for node in obj.SourceNodes])


def nodes_of_element(obj, element):
    """(k,) nodes of a Net on an edge or vertex of its source ("Edge3", "Vertex1"), those of an edge in order.

    Raises InvalidInput that lists the elements that there are.
    """
    if element not in obj.SourceElements:
        raise fn.InvalidInput(
            f"{obj.Label} has no nodes on '{element}': there are {', '.join(obj.SourceElements) or 'none'}"
        )
    return np.array(panels_of(obj.ElementNodes)[obj.SourceElements.index(element)], dtype=int)


def openings_of(obj):
    """The borders of a Net, as their nodes, that are those of holes."""
    return [np.array(rim, dtype=int) for rim in panels_of(obj.OpeningRims)]


def flat_panels(panels):
    """What a document can hold of panels: of each how many nodes, then their numbers."""
    return [number for panel in panels for number in (len(panel), *map(int, panel))]


def panels_of(numbers):
    """The panels of flat_panels()."""
    panels, start = [], 0
    while start < len(numbers):
        end = start + 1 + numbers[start]
        panels.append(tuple(numbers[start + 1 : end]))
        start = end
    return tuple(panels)


def to_vectors(points):
    return [App.Vector(*point) for point in points.tolist()]


def edges_of(nodes, members):
    """Part compound of one edge per member, in member order. nodes: (n, 3) [mm].

    Raises InvalidInput for a member shorter than what FreeCAD takes for a line.
    """
    lengths = np.linalg.norm(nodes[members[:, 0]] - nodes[members[:, 1]], axis=1)
    shortest = int(np.argmin(lengths))
    if lengths[shortest] <= SHORTEST_EDGE:
        raise fn.InvalidInput(
            f"member {shortest} (nodes {members[shortest, 0]} and {members[shortest, 1]}) has shrunk to "
            f"{lengths[shortest]:.1g} mm, too short for a line: give larger steps or other supports"
        )
    vectors = to_vectors(nodes)
    return Part.Compound([Part.makeLine(vectors[i], vectors[j]) for i, j in members.tolist()])
