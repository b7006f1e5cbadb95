# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Net in the document: a face and how it is divided; its shape is the net before relaxation."""

import FreeCAD as App
import Part
import numpy as np

import funicular as fn

from .. import surface
from .feature import Feature, Property, amount

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

# OCCT takes points within 1e-7 mm of each other for one.
SHORTEST_EDGE = 1e-7


class Net(Feature):
    """Proxy of a Net: samples the face at equal arc-length steps along its isolines. Lengths in mm."""

    TYPE = "Net"
    PROPERTIES = (
        Property("App::PropertyLinkSub", "Source", "Net", "The face that the net lies on"),
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
                (
                    "App::PropertyVectorList",
                    "SourceNodes",
                    "Nodes on the face, in the numbering of the lattice",
                ),
                ("App::PropertyString", "SampledPattern", "The pattern that the nodes were laid in"),
                ("App::PropertyBool", "ClosedU", "The last cell along u joins the first"),
                ("App::PropertyBool", "ClosedV", "The last cell along v joins the first"),
                ("App::PropertyStringList", "Poles", "Sides of the face that are one point"),
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
        face, name, body = read_source(obj)
        chart = surface.read_face(face, name)
        pattern = _name_of(obj.Pattern)
        lattice = fn.lattice(
            *surface.count_cells(chart, amount(obj, "StepU", "mm"), amount(obj, "StepV", "mm"), pattern),
            pattern=pattern,
            closed_u=chart.closed_u,
            closed_v=chart.closed_v,
            poles=sorted(chart.poles),
        )
        nodes = surface.sample(chart, lattice.uv)
        _refuse_pinches(nodes, lattice.members, chart.size, name)
        net = lattice.net(nodes * 1e-3)

        # The shape first: it is what may fail, and then no number has changed.
        obj.Shape = edges_of(nodes, net.members)
        obj.SourceNodes = to_vectors(nodes)
        obj.SourceBody = body
        obj.SampledPattern = obj.Pattern
        obj.ClosedU, obj.ClosedV, obj.Poles = chart.closed_u, chart.closed_v, sorted(chart.poles)
        obj.CellsU, obj.CellsV = lattice.cells
        obj.NodeCount, obj.MemberCount, obj.PanelCount = len(nodes), len(net.members), len(net.panels)


def net_of(obj):
    """The fn.Net (metres, with its lattice) of a Net object as it was last computed, placed as it stands.

    Raises InvalidInput if it was never computed.
    """
    if not obj.SourceNodes:
        raise fn.InvalidInput(f"Net {obj.Label} has no nodes: {obj.getStatusString()}; mend its source first")
    lattice = fn.lattice(
        obj.CellsU,
        obj.CellsV,
        # Files of before hold no other pattern than the first.
        pattern=_name_of(obj.SampledPattern or PATTERNS[0]),
        closed_u=obj.ClosedU,
        closed_v=obj.ClosedV,
        poles=obj.Poles,
    )
    place = obj.Placement.Matrix
    return lattice.net(np.array([tuple(place.multVec(node)) for node in obj.SourceNodes]) * 1e-3)


def _name_of(pattern):
    return pattern.lower().replace(" ", "_")


def read_source(obj):
    """(face, its name in sentences, what body it belongs to) of a Net's Source.

    Raises InvalidInput that says why there is not one face there, and what to do.
    """
    if obj.Source is None:
        raise fn.InvalidInput(
            "Source is empty (no face was picked, or its object was deleted): set it to one face, "
            'such as (object, ["Face1"])'
        )
    source, subs = obj.Source
    if source in obj.InListRecursive:
        raise fn.InvalidInput(
            f"{obj.Label} lies inside {source.Label}, which holds its own face: move it out of {source.Label}"
        )
    subs = [sub for sub in subs if sub] or [""]
    if len(subs) > 1:
        raise fn.InvalidInput(
            f"Source names {len(subs)} elements of {source.Label} ({', '.join(subs)}): a net lies on one "
            "face, so pick one and make a net of its own for each other"
        )
    path, _, element = subs[0].rpartition(".")
    path = path and path + "."
    body = source.getSubObject(path) if path else getattr(source, "Shape", None)
    if body is None or body.isNull():
        raise fn.InvalidInput(
            f"Source {source.Label}{path and '.' + path[:-1]} has no shape: recompute or mend it, "
            "or pick another face"
        )
    faces = len(body.Faces)
    if not element:
        if faces != 1:
            raise fn.InvalidInput(f"Source {source.Label} has {faces} faces: pick one of them")
        element = "Face1"
    name = f"Source {source.Label}.{path}{element}"
    if not element.lstrip("?").startswith("Face"):
        raise fn.InvalidInput(f"{name} is not a face: pick a face")
    # 1.0 and later write '?Face3' for a face that is gone.
    face = None if element.startswith("?") else source.getSubObject(path + element)
    if face is None or face.isNull():
        raise fn.InvalidInput(
            f"{name} no longer exists ({source.Label} has {faces} face{'s' * (faces != 1)} now): "
            "pick the face again"
        )
    described = "one face" if faces == 1 else f"{faces} faces, {element} a {type(face.Surface).__name__}"
    if obj.SourceBody and obj.SourceBody != described and not _faces_keep_their_names():
        raise fn.InvalidInput(
            f"{name} may be another face than the one that was picked, because {source.Label} has "
            f"changed (then: {obj.SourceBody}; now: {described}): pick the face again"
        )
    return face, name, described


def _refuse_pinches(nodes, members, size, name):
    """Raises InvalidInput where nodes coincide though the lattice tells them apart. nodes, size: [mm]."""
    lengths = np.linalg.norm(nodes[members[:, 0]] - nodes[members[:, 1]], axis=1)
    shortest = int(np.argmin(lengths))
    if lengths[shortest] <= surface.COINCIDENT * size:
        x, y, z = (nodes[members[shortest, 0]] + 0.0).round(3)
        raise fn.InvalidInput(
            f"{name} pinches to a point inside, at ({x:g}, {y:g}, {z:g}) mm: split the face there and make a "
            "net on each part"
        )


def _faces_keep_their_names():
    """From 1.0 on FreeCAD follows a face through changes of its body; before, Face3 is just the third."""
    return int(App.Version()[0]) >= 1


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
