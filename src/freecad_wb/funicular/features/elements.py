# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which nodes of a net lie on which edges and vertices of its source, so that supports can say so."""

import FreeCAD as App
import Part
import numpy as np

# On an edge within this part of the net's size: more than shapes are exact to, less than can be seen.
ON = 1e-6


def nodes_on_elements(body, faces, nodes):
    """{"Edge3": (k,) node numbers in order along it, "Vertex2": …} of the edges and vertices of faces.

    body: Part.Shape whose elements are meant. faces: those of its faces that the net lies on. nodes: (n, 3)
    [mm], as the body stands. Elements without nodes are left out; so are edges without length.
    """
    limit = ON * float(np.linalg.norm(np.ptp(nodes, axis=0)))
    found = {}
    for number, edge in _of_faces(body.Edges, [edge for face in faces for edge in face.Edges]):
        if not edge.Degenerated:
            on_it = _along(edge, nodes, limit)
            if len(on_it):
                found[f"Edge{number}"] = on_it
    vertices = _of_faces(body.Vertexes, [vertex for face in faces for vertex in face.Vertexes])
    return found | _on_vertices(vertices, nodes, limit)


def _on_vertices(vertices, nodes, limit):
    found = {}
    for number, vertex in vertices:
        on_it = np.flatnonzero(np.linalg.norm(nodes - np.array(tuple(vertex.Point)), axis=1) <= limit)
        if len(on_it):
            found[f"Vertex{number}"] = on_it
    return found


def _of_faces(elements, wanted):
    """(number from 1, element) of those elements that are among the wanted ones."""
    by_hash = {}
    for each in wanted:
        by_hash.setdefault(each.hashCode(), []).append(each)
    for number, element in enumerate(elements, 1):
        if any(element.isSame(each) for each in by_hash.get(element.hashCode(), ())):
            yield number, element


def _along(edge, nodes, limit):
    """Nodes on an edge, by their parameter."""
    # Of a copy, which has no triangles: those that a window has drawn would cut off the crests of a curve.
    box = edge.copy().BoundBox
    low = np.array([box.XMin, box.YMin, box.ZMin]) - limit
    high = np.array([box.XMax, box.YMax, box.ZMax]) + limit
    near = np.flatnonzero(((nodes >= low) & (nodes <= high)).all(axis=1))
    first, last = edge.ParameterRange
    curve = edge.Curve
    period = curve.period() if curve.isPeriodic() else 0.0
    slack = 1e-9 * (last - first)
    along = []
    for node in near.tolist():
        point = App.Vector(*nodes[node])
        try:
            at = curve.parameter(point)
        except Part.OCCError:
            # It has no one nearest place on the curve, as the centre of a circle: so it is not on it.
            continue
        if period:
            at += period * np.ceil((first - slack - at) / period)
        at = min(max(at, first), last)
        if (curve.value(at) - point).Length <= limit:
            along.append((at, node))
    return np.array([node for _, node in sorted(along)], dtype=int)


def nodes_on_wires(source, wires):
    """The same of a WireNet on a features.source.Edges, whose edges are named as in their body."""
    if source.elements:
        # Of several shapes the net says which one each edge is of.
        keys = ["Edge1"] if len(source.elements) == 1 else [f"{k}.Edge1" for k in range(len(source.elements))]
        found = {
            element: wires.edge_nodes[key]
            for element, key in zip(source.elements, keys)
            if key in wires.edge_nodes
        }
    else:
        found = dict(wires.edge_nodes)
    limit = ON * float(np.linalg.norm(np.ptp(wires.nodes, axis=0)))
    return found | _on_vertices(enumerate(source.body.Vertexes, 1), wires.nodes, limit)


def kinds_of(body, elements):
    """What each named edge or vertex of a body is, and of how many: another one may come to bear its name."""
    edges, vertices = body.Edges, body.Vertexes
    return [
        f"{type(edges[int(name[4:]) - 1].Curve).__name__} of {len(edges)} edges"
        if name.startswith("Edge")
        else f"one of {len(vertices)} vertices"
        for name in elements
    ]
