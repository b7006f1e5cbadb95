# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Covering in the document: the panels of a Gridshell as faces."""

import Part
import numpy as np

import funicular as fn

from ..panels import areas, best_planes, turned
from .feature import Feature, Property, amount
from .net import SHORTEST_EDGE, panels_of, to_vectors

KINDS = ("Faces", "Ruled faces", "Triangles")


def _result(kind, name, tooltip):
    return Property(kind, name, "Results", tooltip, mode=("ReadOnly",))


class Covering(Feature):
    """Proxy of a Covering: one item of the shape for each panel of the gridshell, in the order of its panels.

    An item is a face or, where a panel is cut into triangles, a compound of them. Panels are numbered from 0.
    """

    TYPE = "Covering"
    PROPERTIES = (
        Property("App::PropertyLink", "Gridshell", "Covering", "The gridshell whose panels these are"),
        Property(
            "App::PropertyEnumeration",
            "Kind",
            "Covering",
            "Faces: plane where a panel is plane, ruled on warped quads, triangles on other warped panels; "
            "Ruled faces: ruled on every quad; Triangles: between edges and the mean of the corners",
            "Faces",
            KINDS,
        ),
        Property(
            "App::PropertyLength",
            "PlanarTolerance",
            "Covering",
            "How far a corner may lie from the best plane of a panel that counts as plane",
            "1 mm",
            unit="mm",
        ),
        _result("App::PropertyInteger", "PanelCount", "Number of panels"),
        _result("App::PropertyInteger", "PlanarPanels", "Number of panels that are plane"),
        _result(
            "App::PropertyLength", "LargestOutOfPlane", "Largest distance of a corner from its best plane"
        ),
        _result("App::PropertyIntegerList", "WarpedPanels", "Panels that are not plane, counted from 0"),
        _result(
            "App::PropertyArea",
            "Area",
            "Area that the covering's weight counts: of triangles about the mean of each panel's corners",
        ),
    )

    def compute(self, obj):
        shell = gridshell_of(obj)
        # OCCT could not tell a smaller distance from none.
        tolerance = max(amount(obj, "PlanarTolerance", "mm"), SHORTEST_EDGE)
        nodes = np.array([tuple(node) for node in shell.NodePositions])
        panels = panels_of(shell.Panels)
        area = areas(nodes, panels)
        _refuse_collapsed(nodes, panels, area)
        planes = best_planes(nodes, panels)
        planar = planes[2] <= tolerance

        # The shape first: it is what may fail, and then no number has changed.
        shape = Part.Compound(_items(nodes, panels, planes, planar, obj.Kind))
        obj.Placement = _place(obj, shell)
        obj.Shape = shape
        obj.PanelCount, obj.PlanarPanels = len(panels), int(planar.sum())
        obj.LargestOutOfPlane = float(planes[2].max())
        obj.WarpedPanels = np.flatnonzero(~planar).tolist()
        obj.Area = float(area.sum())


def gridshell_of(obj):
    """The Gridshell of a Covering, with a result and panels. Raises InvalidInput that says what is amiss."""
    shell = obj.Gridshell
    if shell is None:
        raise fn.InvalidInput(
            "Gridshell is empty (none was given, or it was deleted): set it to a Gridshell of this document"
        )
    if getattr(shell, "FunicularType", "") != "Gridshell":
        raise fn.InvalidInput(
            f"Gridshell is {shell.Label}, which is not a Gridshell: set it to a Gridshell of this document"
        )
    if shell.Status != "converged":
        raise fn.InvalidInput(f"{shell.Label} has no result: {shell.Summary or 'recompute it first'}")
    if not shell.Panels:
        raise fn.InvalidInput(
            f"{shell.Label} has no panels that could be covered: give its net another Pattern or smaller "
            "steps"
        )
    return shell


def _place(obj, shell):
    """The Placement with which the covering stands where the gridshell stands, in whatever container."""
    container = obj.getParentGeoFeatureGroup()
    if container == shell.getParentGeoFeatureGroup():
        return shell.Placement
    place = shell.getGlobalPlacement()
    return place if container is None else container.getGlobalPlacement().inverse().multiply(place)


def _refuse_collapsed(nodes, panels, area):
    # A panel that is no wider than what FreeCAD takes for one point.
    for number in np.flatnonzero(area <= SHORTEST_EDGE * np.sqrt(area.max())):
        raise fn.InvalidInput(
            f"panel {number} (nodes {', '.join(map(str, panels[number]))}) has no area, its corners lie on "
            "one line: give the net larger steps, or the gridshell other supports"
        )
    sides = [(number, *side) for number, panel in enumerate(panels) for side in zip(panel, turned(panel))]
    numbers, starts, ends = np.array(sides).T
    lengths = np.linalg.norm(nodes[starts] - nodes[ends], axis=1)
    for side in np.flatnonzero(lengths <= SHORTEST_EDGE):
        raise fn.InvalidInput(
            f"panel {numbers[side]} has a side without length, between nodes {starts[side]} and "
            f"{ends[side]}: give the net larger steps, or the gridshell other supports"
        )


def _items(nodes, panels, planes, planar, kind):
    """One shape for each panel, all with their normals on the side from which the corners run around."""
    vectors, centres, normals = (to_vectors(points) for points in (nodes, *planes[:2]))
    items = []
    for number, panel in enumerate(panels):
        corners = [vectors[node] for node in panel]
        quad, cut = len(panel) == 4, kind == "Triangles" and len(panel) > 3
        item = None
        if planar[number] and not cut and not (quad and kind == "Ruled faces"):
            item = _plane_face(corners, centres[number], normals[number])
        elif quad and not cut:
            item = _ruled_face(*corners)
        items.append(item or _fan(corners, centres[number]))
    return items


def _plane_face(corners, centre, normal):
    """The face between the corners' projections on a plane; None where its outline crosses itself."""
    corners = [corner - normal * (corner - centre).dot(normal) for corner in corners]
    face = _polygon_face(corners, normal)
    # An outline that runs around its centre cannot cross itself, and asking FreeCAD takes long.
    runs_around = all(
        (a - centre).cross(b - centre).dot(normal) > 0.0 for a, b in zip(corners, turned(corners))
    )
    return face if runs_around or face.isValid() else None


def _polygon_face(corners, normal):
    return Part.Face(Part.Plane(corners[0], normal), Part.makePolygon([*corners, corners[0]]))


def _ruled_face(a, b, c, d):
    return Part.makeRuledSurface(Part.makeLine(a, b), Part.makeLine(d, c))


def _fan(corners, middle):
    """Compound of the triangles between the edges and the mean of the corners, of those that have an area."""
    faces = []
    for a, b in zip(corners, turned(corners)):
        normal = (b - a).cross(middle - a)
        if normal.Length > SHORTEST_EDGE * (b - a).Length:
            faces.append(_polygon_face((a, b, middle), normal))
    return Part.Compound(faces)
