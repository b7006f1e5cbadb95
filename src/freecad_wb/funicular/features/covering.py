# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Covering in the document: the panels of a Gridshell as faces."""

import Part
import numpy as np

import funicular as fn

from ..panels import areas, best_planes, triangles
from .feature import Feature, Property, amount
from .gridshell import panels_of
from .net import SHORTEST_EDGE, to_vectors

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
        panels = panels_of(shell)
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
    for number, panel in enumerate(panels):
        corners = nodes[list(panel)]
        sides = np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1)
        if sides.min() <= SHORTEST_EDGE:
            side = int(np.argmin(sides))
            raise fn.InvalidInput(
                f"panel {number} has a side without length, between nodes {panel[side - 1]} and "
                f"{panel[side]}: give the net larger steps, or the gridshell other supports"
            )


def _items(nodes, panels, planes, planar, kind):
    """One shape for each panel, all with their normals on the side from which the corners run around."""
    items = []
    for number, panel in enumerate(panels):
        corners = nodes[list(panel)]
        quad, cut = len(panel) == 4, kind == "Triangles" and len(panel) > 3
        item = None
        if planar[number] and not cut and not (quad and kind == "Ruled faces"):
            item = _plane_face(corners, planes[0][number], planes[1][number])
        elif quad and not cut:
            item = _ruled_face(corners)
        items.append(item or _fan(corners))
    return items


def _plane_face(corners, centre, normal):
    """The face between the corners' projections on a plane; None where its outline crosses itself."""
    spokes = corners - centre
    spokes -= np.outer(spokes @ normal, normal)
    face = _polygon_face(centre + spokes, centre, normal)
    # An outline that runs around its centre cannot cross itself, and asking FreeCAD takes long.
    runs_around = (np.cross(spokes, np.roll(spokes, -1, axis=0)) @ normal > 0.0).all()
    return face if runs_around or face.isValid() else None


def _polygon_face(corners, centre, normal):
    vectors = to_vectors(np.vstack([corners, corners[:1], centre, normal]))
    *outline, centre, normal = vectors
    return Part.Face(Part.Plane(centre, normal), Part.makePolygon(outline))


def _ruled_face(corners):
    a, b, c, d = to_vectors(corners)
    return Part.makeRuledSurface(Part.makeLine(a, b), Part.makeLine(d, c))


def _fan(corners):
    """Compound of the triangles between the edges and the mean of the corners, of those that have an area."""
    points, cut = triangles(corners, [range(len(corners))])
    faces = []
    for triangle in cut:
        a, b, c = three = points[list(triangle)]
        normal = np.cross(b - a, c - a)
        length = np.linalg.norm(normal)
        if length > SHORTEST_EDGE * np.linalg.norm(b - a):
            faces.append(_polygon_face(three, a, normal / length))
    return Part.Compound(faces)
