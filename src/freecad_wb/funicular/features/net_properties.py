# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a Net. Their names are written into users' files: they never change."""

from .feature import Property

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
    "Zigzag",
    "Brick",
)

ISOLINES, EQUAL_LENGTHS = "Along isolines", "Equal lengths"

# Millimetres in each.
FILE_UNITS = {"m": 1000.0, "cm": 10.0, "mm": 1.0, "ft": 304.8, "in": 25.4}

SPACINGS = ("Length", "Parameter")

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
    Property(
        "App::PropertyEnumeration",
        "Laying",
        "Net",
        "Along the isolines of the face, or with a compass, so that all members have the length of StepU",
        ISOLINES,
        (ISOLINES, EQUAL_LENGTHS),
    ),
    Property(
        "App::PropertyVector",
        "Start",
        "Equal lengths",
        "(u, v) of the face, between 0 and 1, that a net of equal lengths grows from",
        (0.5, 0.5, 0.0),
    ),
    Property("App::PropertyAngle", "Angle", "Net", "By which the pattern is turned on the face", 0.0),
    Property("App::PropertyFloat", "OffsetU", "Net", "By how many cells the pattern is shifted along u", 0.0),
    Property("App::PropertyFloat", "OffsetV", "Net", "By how many cells the pattern is shifted along v", 0.0),
    Property("App::PropertyAngle", "Crossing", "Equal lengths", "Between members at the start", 90.0),
    Property(
        "App::PropertyAngle",
        "MostShear",
        "Equal lengths",
        "How far the angle between members may be from a right one; there the net ends",
        60.0,
    ),
    Property("App::PropertyInteger", "CountU", "Net", "Cells along u, in place of StepU; 0 for none", 0),
    Property("App::PropertyInteger", "CountV", "Net", "Cells along v, in place of StepV; 0 for none", 0),
    Property("App::PropertyBool", "SwapUV", "Net", "Turn the pattern: what ran along u runs along v", False),
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
        "A mesh file (obj, ply, stl, off) that is taken as it is, where there is no source",
    ),
    Property(
        "App::PropertyEnumeration", "FileUnit", "Mesh", "Unit of the lengths in File", "m", tuple(FILE_UNITS)
    ),
    Property(
        "App::PropertyBool",
        "Resampled",
        "Mesh",
        "Lay the pattern over the mesh of File by its UV coordinates, instead of taking its own edges",
        False,
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
            ("App::PropertyStringList", "ElementKinds", "What each of SourceElements is"),
            (
                "App::PropertyIntegerList",
                "OpeningRims",
                "Of each border of a hole how many nodes, then these",
            ),
            (
                "App::PropertyIntegerList",
                "OpeningNodes",
                "Of each opening how many nodes, then their numbers",
            ),
            ("App::PropertyFloatList", "OpeningAreas", "Area of each opening on the source [mm²]"),
            (
                "App::PropertyIntegerList",
                "NodeNumbers",
                "Which node each was before edits; empty if the same",
            ),
            ("App::PropertyVectorList", "NodePlaces", "(u, v) of each node that is on no lattice"),
            ("App::PropertyString", "SourceBody", "What the face belonged to when it was picked"),
        )
    ),
)


def pattern_of(name):
    """The name in fn.patterns() of one of PATTERNS."""
    return name.lower().replace(" ", "_")
