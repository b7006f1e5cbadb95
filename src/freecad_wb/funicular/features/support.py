# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Support in the document: which nodes of a net it holds, said so that it outlives other steps, and how."""

from weakref import WeakKeyDictionary

import FreeCAD as App
import numpy as np
import Part

import funicular as fn

from .. import topology
from ..edits import Places
from ..recipes import joined_lines, support_recipe, vertical_planes
from .feature import Feature, Property, amount
from .net import nodes_of_element, net_of, openings_of, positions_of

# Of a Gridshell: which nodes, and how they are held.
RECIPES = ("Boundary", "Corners", "Corners and border planes", "Lowest points", "Opening rims", "None")

# Of a Support: those that say which nodes; how they are held says Kind.
NODE_RECIPES = ("Corners", "Boundary", "Lowest points", "Opening rims")
ELEMENTS, POINTS, NODES = "Edges and vertices", "Points", "Nodes"
WHERE_BY = {"Elements": ELEMENTS, "Points": POINTS, "Nodes": NODES}
PLACES = (*NODE_RECIPES, ELEMENTS, POINTS, NODES)

FIXED, VERTICAL_PLANE, VERTICAL_LINE = "Fixed", "On its vertical plane", "On its vertical line"
PLANE, LINE, FREE = "On a plane", "On a line", "Free"
KINDS = (FIXED, VERTICAL_PLANE, VERTICAL_LINE, PLANE, LINE, FREE)


class Support(Feature):
    """Proxy of a Support; its shape are the nodes that it holds, as they lie on the net."""

    TYPE = "Support"
    PROPERTIES = (
        Property("App::PropertyLink", "Net", "Support", "The net whose nodes are held"),
        Property("App::PropertyEnumeration", "Where", "Support", "Which nodes are held", "Corners", PLACES),
        Property(
            "App::PropertyStringList",
            "Elements",
            "Support",
            "Edges and vertices of the net's source, such as Edge3 or Vertex1: every node on them",
        ),
        Property(
            "App::PropertyVectorList",
            "Points",
            "Support",
            "(u, v) of the face between 0 and 1 (z is not used): the node nearest to each",
        ),
        Property(
            "App::PropertyIntegerList",
            "Nodes",
            "Support",
            "Numbers of nodes before edits, for a net that keeps them",
        ),
        Property(
            "App::PropertyEnumeration",
            "Kind",
            "Support",
            "How nodes are held; Free takes them from the other supports",
            FIXED,
            KINDS,
        ),
        Property(
            "App::PropertyVector",
            "Direction",
            "Support",
            "Normal of the plane, or direction of the line",
            App.Vector(0, 0, 1),
        ),
        Property(
            "App::PropertyQuantity",
            "Stiffness",
            "Support",
            "Force for each length that the support yields; 0 for one that does not",
            "0 N/m",
            unit="N/m",
        ),
        Property(
            "App::PropertyBool",
            "TakesOver",
            "Support",
            "Take its nodes from the supports before it in the gridshell's list, instead of adding to them",
            False,
        ),
        Property("App::PropertyIntegerList", "HeldNodes", "Support", "What was found", mode=("ReadOnly",)),
        Property(
            "App::PropertyStringList",
            "ElementsWere",
            "Support",
            "What the elements were when they were picked",
            mode=("ReadOnly", "Hidden"),
        ),
    )

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        if name == "Elements" and "Restore" not in obj.State and hasattr(obj, "ElementsWere"):
            # A new pick is trusted; from then on they may not become other ones.
            obj.ElementsWere = []

    def compute(self, obj):
        net = net_of_support(obj)
        held = nodes_of_support(obj, net)
        supports_of(obj, net, held)
        points = positions_of(obj.Net)[held]
        obj.Shape = Part.Compound([Part.Vertex(App.Vector(*point)) for point in points.tolist()])
        obj.HeldNodes = held.tolist()
        obj.ElementsWere = _kinds(obj) if obj.Where == ELEMENTS else []


def at_picks(shell, elements, points):
    """The properties of a Support where something of a gridshell was picked; its border where nothing was.

    elements: names of edges and vertices of the source. points: App.Vector on nodes of the gridshell, as it
    stands in the document. Nodes are kept as places on the face where there are such, else by number.
    """
    if elements:
        return {"Where": ELEMENTS, "Elements": elements}
    if not points:
        return {"Where": "Boundary"}
    return at_nodes(shell.Net, nodes_at(shell, points))


def at_nodes(net, nodes):
    """The properties of a Support on nodes of a Net: kept as places on the face where there are such."""
    places = net.NodePlaces
    if places:
        return {"Where": POINTS, "Points": [places[node] for node in nodes]}
    numbers = net.NodeNumbers or range(net.NodeCount)
    return {"Where": NODES, "Nodes": [int(numbers[node]) for node in nodes]}


def nodes_at(shell, points):
    """Numbers of the nodes of a Gridshell nearest to some points (App.Vector) in the document, each once."""
    placed = shell.getGlobalPlacement()
    nodes = np.array([tuple(placed.multVec(node)) for node in shell.NodePositions])
    picked = [int(np.argmin(np.linalg.norm(nodes - tuple(point), axis=1))) for point in points]
    return list(dict.fromkeys(picked))


def net_of_support(obj):
    """The fn.Net of a Support. Raises InvalidInput without one."""
    if obj.Net is None or getattr(obj.Net, "FunicularType", "") != "Net":
        raise fn.InvalidInput("Net is empty or no Net: set it to the Net whose nodes are held")
    return net_of(obj.Net)


def nodes_of_support(obj, net):
    """(k,) numbers of the nodes that a Support speaks of; those of one edge, or one border, in order.

    Raises InvalidInput naming the property that finds none.
    """
    lines = _lines(obj, net)
    nodes = np.concatenate(lines) if lines else np.array([], dtype=int)
    if not len(nodes):
        raise fn.InvalidInput(f"Where: no node is found by {obj.Where}")
    return np.array(list(dict.fromkeys(nodes.tolist())))


def _lines(obj, net):
    """The nodes of a Support: one array for each edge or border, or for all."""
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


def supports_of(obj, net, nodes):
    """The fn supports of a Support on these nodes; none if it frees them.

    Raises InvalidInput naming Direction, or why there is no vertical plane.
    """
    stiffness = amount(obj, "Stiffness", "N/m") or float("inf")
    if obj.Kind == FIXED:
        return [fn.Fixed(nodes, stiffness=stiffness)]
    if obj.Kind == VERTICAL_LINE:
        return [fn.OnLine(nodes, direction=(0, 0, 1), stiffness=stiffness)]
    if obj.Kind == VERTICAL_PLANE:
        return _on_vertical_planes(obj, net, nodes, stiffness)
    if obj.Kind == FREE:
        return []
    if obj.Direction.Length == 0.0:
        raise fn.InvalidInput("Direction is zero: give the normal of the plane or the direction of the line")
    direction = tuple(obj.Direction)
    if obj.Kind == PLANE:
        return [fn.OnPlane(nodes, normal=direction, stiffness=stiffness)]
    return [fn.OnLine(nodes, direction=direction, stiffness=stiffness)]


def _on_vertical_planes(obj, net, nodes, stiffness):
    """Each node on the vertical plane along its edge or border."""
    if obj.Where in (POINTS, NODES):
        return _along_the_border(net, nodes, stiffness)
    lines = [line for line in _lines(obj, net) if len(line) > 1]
    if obj.Where not in (ELEMENTS, "Boundary", "Opening rims") or not lines:
        raise fn.InvalidInput(
            f"Kind: {obj.Where} have no direction along which a vertical plane could stand; choose "
            f"'{PLANE}' and give its normal as Direction, or say where by {ELEMENTS}"
        )
    joined = [(line, True) for line in lines]
    if obj.Where == ELEMENTS:
        members = {tuple(sorted(member)) for member in net.members.tolist()}
        joined = joined_lines(net.nodes, lines, members)
    planes = []
    for line, is_closed in joined:
        if is_closed:
            planes += vertical_planes(net.nodes, [line], closed=True)
        else:
            planes += vertical_planes(*_lengthened(net.nodes, line))
    return [fn.OnPlane(plane.ids, normal=plane.normal, stiffness=stiffness) for plane in planes]


def _along_the_border(net, nodes, stiffness):
    """Nodes of their own on the vertical planes along the border of the net."""
    rims = topology.rims(net.nodes, net.panels) if net.panels else []
    on_rims = np.concatenate(rims) if rims else np.array([], dtype=int)
    inside = nodes[~np.isin(nodes, on_rims)]
    if len(inside):
        raise fn.InvalidInput(
            f"Kind: node {inside[0]} is not on the border of the net, along which a vertical plane could "
            f"stand; choose '{PLANE}' and give its normal as Direction, or leave the node out"
        )
    planes = vertical_planes(net.nodes, [rim for rim in rims if np.isin(rim, nodes).any()], closed=True)
    planes = [(plane, plane.ids[np.isin(plane.ids, nodes)]) for plane in planes]
    return [fn.OnPlane(ids, normal=plane.normal, stiffness=stiffness) for plane, ids in planes if len(ids)]


def _lengthened(nodes, line):
    """(nodes, [line]) with a point more beyond each end, so that the line goes on there as it came."""
    extra = 2 * nodes[line[[0, -1]]] - nodes[line[[1, -2]]]
    return np.vstack([nodes, extra]), [np.concatenate([[len(nodes)], line, [len(nodes) + 1]])]


def supports_of_gridshell(obj, net):
    """The fn supports of a Gridshell: those of its Supports, and of its recipe on all other nodes.

    Raises InvalidInput naming SupportRecipe or the Support.
    """
    return [support for _, _, supports in held_by_each(obj, net) for support in supports]


def held_by_each(obj, net):
    """[(Support, (k,) its nodes, the fn supports on them)]: what each holds in the end, of a Gridshell.

    The first is its recipe, with None for the Support, on the nodes of which no Support speaks. What a
    Support has lost to others is not among its nodes. Raises InvalidInput naming SupportRecipe or the
    Support.
    """
    if obj.SupportRecipe == "None" and not obj.Supports:
        raise fn.InvalidInput(
            "SupportRecipe is None, and a shell without supports falls: choose "
            + ", ".join(recipe for recipe in RECIPES if recipe != "None")
            + ", or give it Supports"
        )
    try:
        recipe = support_recipe(net, obj.SupportRecipe.lower(), openings_of(obj.Net))
    except fn.InvalidInput as error:
        raise fn.InvalidInput(f"SupportRecipe: {error}") from None
    held, spoken_for, freed = [], set(), set()
    for support in obj.Supports:
        if getattr(support, "FunicularType", "") != "Support" or support.Net != obj.Net:
            raise fn.InvalidInput(
                f"Supports holds {support.Label}, which is no support of the net {obj.Net.Label}: take it "
                "out, or set its Net"
            )
        try:
            nodes = nodes_of_support(support, net)
            made = supports_of(support, net, nodes)
        except fn.InvalidInput as error:
            raise fn.InvalidInput(f"{support.Label}: {error}") from None
        spoken_for.update(nodes.tolist())
        if support.TakesOver:
            held = [_without_nodes(each, set(nodes.tolist())) for each in held]
            freed.difference_update(nodes.tolist())
        held.append((support, nodes, made))
        if support.Kind == FREE:
            freed.update(nodes.tolist())
    # A support that slides or yields would say nothing where the recipe holds its nodes.
    nodes = np.concatenate([support.ids for support in recipe]) if recipe else np.array([], dtype=int)
    by_recipe = _without_nodes((None, nodes, recipe), spoken_for)
    return [by_recipe] + [each if each[0].Kind == FREE else _without_nodes(each, freed) for each in held]


def _without_nodes(held, lost):
    """An entry of held_by_each() without the nodes that it has lost."""
    support, nodes, made = held
    kept = [_without(each, lost) for each in made]
    return support, nodes[~np.isin(nodes, list(lost))], [each for each in kept if each is not None]


def _without(support, freed):
    """The same support of the nodes that are not freed; None where none is left."""
    if not freed.intersection(support.ids.tolist()):
        return support
    ids = [node for node in support.ids.tolist() if node not in freed]
    if not ids:
        return None
    if isinstance(support, fn.OnLine):
        return fn.OnLine(ids, direction=support.direction, stiffness=support.stiffness)
    if isinstance(support, fn.OnPlane):
        return fn.OnPlane(ids, normal=support.normal, stiffness=support.stiffness)
    return fn.Fixed(ids, stiffness=support.stiffness)
