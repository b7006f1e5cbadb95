# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Net in the document: a source and how it is divided; its shape is the net before relaxation."""

import FreeCAD as App
import Part
import numpy as np

import funicular as fn

from ..chebyshev import equal_length_net
from ..edits import Edits, Places, edited
from ..lattices import lattice_on
from ..laying import Division, Laid, chart_within_outline, lay_on_face
from ..mesh_source import mesh_of, net_of_mesh, read_mesh_file
from ..several_faces import lay_on_faces
from ..wireframe import net_of_edges
from .elements import nodes_on_elements
from .feature import Feature, amount
from .net_properties import EQUAL_LENGTHS, PATTERNS, PROPERTIES, SPACINGS
from .source import Edges, File, Mesh, read_source

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

    def compute(self, obj):
        source = read_source(obj)
        laid, on_elements = _lay(obj, source)
        laid, openings, numbers = edited(laid, _edits(obj), _places(laid))
        _write(obj, laid)
        own = {int(number): node for node, number in enumerate(numbers)}
        on_elements = {
            element: [own[node] for node in nodes.tolist() if node in own]
            for element, nodes in on_elements.items()
        }
        obj.SourceElements, obj.ElementNodes = list(on_elements), flat_panels(on_elements.values())
        obj.OpeningNodes = flat_panels(opening.nodes for opening in openings)
        obj.OpeningAreas = [opening.area for opening in openings]
        obj.SourceBody = getattr(source, "described", "")


def _lay(obj, source):
    """(Laid, {element of the source: its nodes}) on what a Net lies on."""
    if isinstance(source, Mesh):
        return _of(net_of_mesh(*mesh_of(source.obj, source.name), source.name, _weld(obj))), {}
    if isinstance(source, File):
        try:
            points, facets, lines = read_mesh_file(source.path)
        except OSError as error:
            raise fn.InvalidInput(
                f"File {source.path} cannot be read ({error.strerror}): choose another"
            ) from None
        return _of(net_of_mesh(points, facets, f"File {source.path}", _weld(obj), lines)), {}
    if isinstance(source, Edges):
        wires = net_of_edges(source.shapes, source.name, amount(obj, "Chord", "mm") or None)
        return _of(wires), wires.edge_nodes if len(source.shapes) == 1 else {}
    division = _division(obj)
    if len(source.faces) > 1 and (division.angle or any(division.offset)):
        raise fn.InvalidInput(
            "Angle, OffsetU and OffsetV turn and shift the pattern on one face; on several set them to 0"
        )
    if obj.Laying == EQUAL_LENGTHS:
        laid = _of_equal_lengths(obj, source, division.step_u)
    elif len(source.faces) == 1:
        laid = lay_on_face(source.faces[0], source.names[0], division)
    else:
        laid = lay_on_faces(source, division)
    return laid, nodes_on_elements(source.body, source.faces, laid.nodes)


def _of_equal_lengths(obj, source, step):
    if len(source.faces) > 1:
        raise fn.InvalidInput(
            "Laying: a net of equal lengths lies on one face; pick a single one, or lay along isolines"
        )
    chart, inside = chart_within_outline(source.faces[0], source.names[0], step)
    made = equal_length_net(
        chart,
        step,
        (obj.Start.x, obj.Start.y),
        obj.Angle.Value,
        obj.Crossing.Value,
        obj.MostShear.Value,
        inside,
    )
    panels = tuple(tuple(panel) for panel in made.panels.tolist())
    closed = chart.closed_u, chart.closed_v
    remarks = tuple(remark.rstrip(".") for remark in made.remarks)
    return Laid(made.nodes, made.members, panels, closed=closed, remarks=remarks, uv=made.uv)


def _edits(obj):
    if len(obj.RaisedNodes) != len(obj.RaisedHeights):
        raise fn.InvalidInput(
            f"RaisedNodes names {len(obj.RaisedNodes)} nodes, but RaisedHeights has {len(obj.RaisedHeights)} "
            "values: give one for each"
        )
    raised = [((at.x, at.y), at.z) for at in obj.Raised]
    return Edits(
        raised + list(zip(obj.RaisedNodes, obj.RaisedHeights)),
        [(at.x, at.y) for at in obj.RemovedMembers] + list(obj.RemovedMemberNumbers),
        [(at.x, at.y) for at in obj.RemovedPanels] + list(obj.RemovedPanelNumbers),
    )


def _places(laid):
    """Where the nodes of a net on a lattice are on the face."""
    return Places(laid.uv, laid.closed)


def _weld(obj):
    return amount(obj, "Weld", "mm") or None


def _of(made):
    """The Laid net of a MeshNet or a WireNet."""
    return Laid(
        made.nodes,
        made.members,
        made.panels,
        remarks=tuple(remark.rstrip(".") for remark in made.remarks),
    )


def _division(obj):
    for name in ("CountU", "CountV"):
        if getattr(obj, name) < 0:
            raise fn.InvalidInput(f"{name} is {getattr(obj, name)} cells: give 0 (none) or more")
    return Division(
        amount(obj, "StepU", "mm"),
        amount(obj, "StepV", "mm"),
        _name_of(obj.Pattern),
        obj.CountU,
        obj.CountV,
        obj.SwapUV,
        obj.Spacing == SPACINGS[1],
        obj.Angle.Value,
        (obj.OffsetU, obj.OffsetV),
    )


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
        _name_of(obj.SampledPattern or PATTERNS[0]),
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


def _name_of(pattern):
    return pattern.lower().replace(" ", "_")


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
