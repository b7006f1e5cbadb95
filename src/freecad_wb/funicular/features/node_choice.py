# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which nodes of a net a Support or a PointLoad speaks of, said so that it outlives other steps: by recipe,
element of the source, place on the face or number."""

from weakref import WeakKeyDictionary

import numpy as np
import Part

import funicular as fn

from .. import topology
from ..edits import Places
from ..recipes import support_recipe
from .feature import Feature, Property
from .net import nodes_of_element, net_of, openings_of, positions_of, to_vectors

# Recipes, of those of a Gridshell, that say which nodes.
NODE_RECIPES = ("Corners", "Boundary", "Lowest points", "Opening rims")
ELEMENTS, POINTS, NODES = "Edges and vertices", "Points", "Nodes"
WHERE_BY = {"Elements": ELEMENTS, "Points": POINTS, "Nodes": NODES}
PLACES = (*NODE_RECIPES, ELEMENTS, POINTS, NODES)


def node_properties(group, default):
    """The Properties that say which nodes. default: of Where."""
    return (
        Property("App::PropertyLink", "Net", group, "The net whose nodes are meant"),
        Property("App::PropertyEnumeration", "Where", group, "Which nodes are meant", default, PLACES),
        Property(
            "App::PropertyStringList",
            "Elements",
            group,
            "Edges and vertices of the net's source, such as Edge3 or Vertex1: every node on them",
        ),
        Property(
            "App::PropertyVectorList",
            "Points",
            group,
            "(u, v) of the face between 0 and 1 (z is not used): the node nearest to each",
        ),
        Property(
            "App::PropertyIntegerList",
            "Nodes",
            group,
            "Numbers of nodes before edits, for a net that keeps them",
        ),
        Property(
            "App::PropertyStringList",
            "ElementsWere",
            group,
            "What the elements were when they were picked",
            mode=("ReadOnly", "Hidden"),
        ),
    )


class NodeFeature(Feature):
    """Proxy of an object with node_properties(); its shape are its nodes, as they lie on the net.

    FOUND is the property that takes their numbers; `check(obj, net, nodes)` raises InvalidInput for what else
    the object says wrongly.
    """

    FOUND = None

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        if name == "Elements" and "Restore" not in obj.State and hasattr(obj, "ElementsWere"):
            # A new pick is trusted; from then on they may not become other ones.
            obj.ElementsWere = []

    def compute(self, obj):
        net = net_of_object(obj)
        nodes = nodes_of(obj, net)
        self.check(obj, net, nodes)
        points = positions_of(obj.Net)[nodes]
        obj.Shape = Part.Compound([Part.Vertex(point) for point in to_vectors(points)])
        setattr(obj, self.FOUND, nodes.tolist())
        obj.ElementsWere = _kinds(obj) if obj.Where == ELEMENTS else []

    def check(self, obj, net, nodes):
        """Here there is nothing."""


def is_used(obj):
    """Whether something has use for an object, besides the group or part that holds it."""
    holders = (obj.getParentGeoFeatureGroup(), obj.getParentGroup())
    return any(user not in holders for user in obj.InList)


def at_picks(shell, elements, points, nodes=None):
    """The properties that say which nodes, where something of a gridshell was picked; else its border.

    elements: names of edges and vertices of the source. points: App.Vector on nodes of the gridshell, as it
    stands in the document. nodes: as for nodes_at(). Nodes are kept as places on the face where there are
    such, else by number.
    """
    if elements:
        return {"Where": ELEMENTS, "Elements": elements}
    if not points:
        return {"Where": "Boundary"}
    return at_nodes(shell.Net, nodes_at(shell, points, nodes))


def at_nodes(net, nodes):
    """The properties that say which nodes, of a Net: kept as places on the face where there are such."""
    places = net.NodePlaces
    if places:
        return {"Where": POINTS, "Points": [places[node] for node in nodes]}
    numbers = net.NodeNumbers or range(net.NodeCount)
    return {"Where": NODES, "Nodes": [int(numbers[node]) for node in nodes]}


def nodes_at(shell, points, nodes=None):
    """Numbers of the nodes of a Gridshell nearest to some points (App.Vector) in the document, each once.

    nodes: (n, 3) [mm], before Placement, where they are not those of its last result.
    """
    placed = shell.getGlobalPlacement()
    nodes = shell.NodePositions if nodes is None else to_vectors(nodes)
    nodes = np.array([tuple(placed.multVec(node)) for node in nodes])
    picked = [int(np.argmin(np.linalg.norm(nodes - tuple(point), axis=1))) for point in points]
    return list(dict.fromkeys(picked))


def net_of_object(obj):
    """The fn.Net whose nodes an object speaks of. Raises InvalidInput without one."""
    if obj.Net is None or getattr(obj.Net, "FunicularType", "") != "Net":
        raise fn.InvalidInput("Net is empty or no Net: set it to the Net whose nodes are meant")
    return net_of(obj.Net)


def nodes_of(obj, net):
    """(k,) numbers of the nodes that an object speaks of; those of one edge, or one border, in order.

    Raises InvalidInput naming the property that finds none.
    """
    lines = lines_of(obj, net)
    nodes = np.concatenate(lines) if lines else np.array([], dtype=int)
    if not len(nodes):
        raise fn.InvalidInput(f"Where: no node is found by {obj.Where}: give some, or choose another Where")
    return np.array(list(dict.fromkeys(nodes.tolist())))


def lines_of(obj, net):
    """The nodes of an object: one array for each edge or border, or for all."""
    if obj.Where in ("Boundary", "Opening rims"):
        # Asked of the recipe, which says why there is none.
        held = support_recipe(net, obj.Where.lower(), openings_of(obj.Net))[0].ids
        return [rim for rim in topology.rims(net.nodes, net.panels) if np.isin(rim, held).all()]
    if obj.Where in NODE_RECIPES:
        return [np.asarray(support_recipe(net, obj.Where.lower(), openings_of(obj.Net))[0].ids)]
    if obj.Where == ELEMENTS:
        if not obj.Elements:
            raise fn.InvalidInput("Elements is empty: name edges or vertices of the source, such as Edge1")
        lines = [nodes_of_element(obj.Net, element) for element in obj.Elements]
        for element, was, now in zip(obj.Elements, obj.ElementsWere, _kinds(obj)):
            if was != now:
                raise fn.InvalidInput(
                    f"Elements: {element} may be another than the one that was picked, because the source "
                    f"has changed (then: {was}; now: {now}): set Elements again"
                )
        return lines
    if obj.Where == POINTS:
        return [_nearest(obj, net)]
    numbers = obj.Net.NodeNumbers or range(len(net.nodes))
    own = {number: node for node, number in enumerate(numbers)}
    wrong = next((node for node in obj.Nodes if node not in own), None)
    if wrong is not None and obj.Net.NodeNumbers:
        raise fn.InvalidInput(
            f"Nodes holds {wrong}, which edits of the net have taken out: correct it, or leave its members"
        )
    if wrong is not None:
        raise fn.InvalidInput(
            f"Nodes holds {wrong}, but the net has nodes 0 to {len(net.nodes) - 1}: correct it, or pick "
            "points or edges, which another step leaves where they are"
        )
    return [np.array([own[node] for node in obj.Nodes], dtype=int)]


def _kinds(obj):
    kinds = dict(zip(obj.Net.SourceElements, obj.Net.ElementKinds))
    return [kinds.get(element, "") for element in obj.Elements]


def _nearest(obj, net):
    """The node nearest to each of Points, on the unit square of the face."""
    # Whoever moves a form asks again and again of one net, each time for the same places.
    points = obj.Points
    asked = tuple(tuple(point) for point in points)
    found = _NEAREST.setdefault(net, {})
    if asked not in found:
        found[asked] = _nearest_of(obj, points)
    return found[asked]


_NEAREST = WeakKeyDictionary()


def _nearest_of(obj, points):
    node_places = obj.Net.NodePlaces
    if not node_places:
        raise fn.InvalidInput(
            "Points are (u, v) of one whole face, which this net does not lie on: choose "
            f"{ELEMENTS} or {NODES}"
        )
    uv = [(at.x, at.y) for at in node_places]
    places = Places(np.array(uv), (obj.Net.ClosedU, obj.Net.ClosedV), frozenset(obj.Net.Poles))
    # As picked, places are those of nodes; only with another step are they between them.
    node_at = dict(zip(reversed(uv), range(len(uv) - 1, -1, -1)))
    found = []
    for at, point in enumerate(points):
        if not (-1e-9 <= point.x <= 1 + 1e-9 and -1e-9 <= point.y <= 1 + 1e-9):
            raise fn.InvalidInput(
                f"Points[{at}] is ({point.x:g}, {point.y:g}): give u and v between 0 and 1, shares of the "
                "face's length"
            )
        own = node_at.get((point.x, point.y))
        found.append(places.nearest_node((point.x, point.y)) if own is None else own)
    return np.array(found, dtype=int)
