# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Net in the document: a source and how it is divided; its shape is the net before relaxation."""

import FreeCAD as App
import Part
import numpy as np

import funicular as fn

from ..edits import Edits, Places, edited
from ..laying import Division, Laid, lattice_on, lay_on_face
from ..mesh_source import mesh_of, net_of_mesh, read_mesh_file
from ..several_faces import lay_on_faces
from ..wireframe import net_of_edges
from .elements import nodes_on_elements
from .feature import Feature, Property, amount
from .source import Edges, File, Mesh, read_source

# fn.patterns() as an architect reads them; written out, as this module has to load without the core.
PATTERNS = (
    "Quad",
    "Diagonal",
    "Other diagonal",
    "Alternating",
    "Crossed",
    "Centred",
    "Diagrid",
    "Triangle",
    "Hexagon",
    "Kagome",
    "Ribs u",
    "Ribs v",
)

SPACINGS = ("Length", "Parameter")

# OCCT takes points within 1e-7 mm of each other for one.
SHORTEST_EDGE = 1e-7


class Net(Feature):
    """Proxy of a Net: lays a pattern on its source. Lengths in mm."""

    TYPE = "Net"
    PROPERTIES = (
        Property("App::PropertyLinkSub", "Source", "Net", "The face or faces that the net lies on"),
        Property(
            "App::PropertyEnumeration", "Pattern", "Net", "How members are laid on the face", "Quad", PATTERNS
        ),
        Property(
            "App::PropertyLength",
            "StepU",
            "Net",
            "Length of members along u, measured on the face",
            "1 m",
            unit="mm",
        ),
        Property(
            "App::PropertyLength",
            "StepV",
            "Net",
            "Length of members along v, measured on the face",
            "1 m",
            unit="mm",
        ),
        Property("App::PropertyInteger", "CountU", "Net", "Cells along u, in place of StepU; 0 for none", 0),
        Property("App::PropertyInteger", "CountV", "Net", "Cells along v, in place of StepV; 0 for none", 0),
        Property(
            "App::PropertyBool", "SwapUV", "Net", "Turn the pattern: what ran along u runs along v", False
        ),
        Property(
            "App::PropertyEnumeration",
            "Spacing",
            "Net",
            "What is equal from cell to cell: the length on the face, or the surface's parameters",
            SPACINGS[0],
            SPACINGS,
        ),
        Property(
            "App::PropertyLength",
            "Width",
            "Sheet",
            "Of a flat sheet, where there is no source",
            0.0,
            unit="mm",
        ),
        Property(
            "App::PropertyLength",
            "Depth",
            "Sheet",
            "Of a flat sheet, where there is no source",
            0.0,
            unit="mm",
        ),
        Property(
            "App::PropertyFile",
            "File",
            "Mesh",
            "A mesh file (obj, ply, stl, off; metres) that is taken as it is, where there is no source",
        ),
        Property(
            "App::PropertyLength",
            "Weld",
            "Mesh",
            "Vertices of a mesh as near as this are one node; 0 for 1e-6 of its size",
            0.0,
            unit="mm",
        ),
        Property(
            "App::PropertyLength",
            "Chord",
            "Edges",
            "Curved edges are divided into parts no longer than this; 0 for one member each",
            0.0,
            unit="mm",
        ),
        *(
            Property(kind, name, "Edits", tooltip)
            for kind, name, tooltip in (
                (
                    "App::PropertyVectorList",
                    "Raised",
                    "(u, v, height in mm): the node nearest to (u, v) on the face is raised, or lowered",
                ),
                (
                    "App::PropertyVectorList",
                    "RemovedPanels",
                    "(u, v) on the face: the nearest panel becomes an opening",
                ),
                (
                    "App::PropertyVectorList",
                    "RemovedMembers",
                    "(u, v) on the face: the nearest member is taken out, and the panels beside it are one",
                ),
                ("App::PropertyIntegerList", "RaisedNodes", "Numbers of nodes, for nets that keep them"),
                ("App::PropertyFloatList", "RaisedHeights", "By how much each of RaisedNodes is raised [mm]"),
                ("App::PropertyIntegerList", "RemovedPanelNumbers", "Panels that become openings, by number"),
                ("App::PropertyIntegerList", "RemovedMemberNumbers", "Members that are taken out, by number"),
            )
        ),
        Property("App::PropertyString", "Remarks", "Net", "What came out otherwise", mode=("ReadOnly",)),
        *(
            Property("App::PropertyInteger", name, "Net", tooltip, mode=("ReadOnly",))
            for name, tooltip in (
                ("CellsU", "Number of cells along u"),
                ("CellsV", "Number of cells along v"),
                ("NodeCount", "Number of nodes"),
                ("MemberCount", "Number of members"),
                ("PanelCount", "Number of panels"),
            )
        ),
        *(
            Property(kind, name, "Net", tooltip, mode=("ReadOnly", "Hidden"))
            for kind, name, tooltip in (
                ("App::PropertyVectorList", "SourceNodes", "Nodes on the face, in the numbering of the net"),
                ("App::PropertyString", "SampledPattern", "The pattern that the nodes were laid in"),
                ("App::PropertyBool", "SampledSwap", "Whether that was turned"),
                ("App::PropertyBool", "ClosedU", "The last cell along u joins the first"),
                ("App::PropertyBool", "ClosedV", "The last cell along v joins the first"),
                ("App::PropertyStringList", "Poles", "Sides of the face that are one point"),
                ("App::PropertyIntegerList", "Members", "Two nodes a member; empty for a lattice"),
                ("App::PropertyIntegerList", "Panels", "Of each panel how many nodes, then their numbers"),
                (
                    "App::PropertyStringList",
                    "SourceElements",
                    "Edges and vertices of the source that hold nodes",
                ),
                ("App::PropertyIntegerList", "ElementNodes", "Of each how many nodes, then their numbers"),
                (
                    "App::PropertyIntegerList",
                    "OpeningNodes",
                    "Of each opening how many nodes, then their numbers",
                ),
                ("App::PropertyFloatList", "OpeningAreas", "Area of each opening on the source [mm²]"),
                ("App::PropertyVectorList", "NodePlaces", "(u, v) of each node that is on no lattice"),
                ("App::PropertyString", "SourceBody", "What the face belonged to when it was picked"),
            )
        ),
    )

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
    if len(source.faces) == 1:
        laid = lay_on_face(source.faces[0], source.names[0], division)
    else:
        laid = lay_on_faces(source, division)
    return laid, nodes_on_elements(source.body, source.faces, laid.nodes)


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
