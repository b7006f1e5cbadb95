# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Support in the document: which nodes of a net it holds, and how."""

import FreeCAD as App
import numpy as np

import funicular as fn

from .. import topology
from ..recipes import joined_lines, support_recipe, vertical_planes
from .feature import Property, amount
from .net import openings_of
from .node_choice import ELEMENTS, NODES, POINTS, NodeFeature, lines_of, node_properties, nodes_of

# Of a Gridshell: which nodes, and how they are held.
RECIPES = ("Boundary", "Corners", "Corners and border planes", "Lowest points", "Opening rims", "None")

FIXED, VERTICAL_PLANE, VERTICAL_LINE = "Fixed", "On its vertical plane", "On its vertical line"
PLANE, LINE, FREE = "On a plane", "On a line", "Free"
KINDS = (FIXED, VERTICAL_PLANE, VERTICAL_LINE, PLANE, LINE, FREE)


class Support(NodeFeature):
    """Proxy of a Support; its shape are the nodes that it holds, as they lie on the net."""

    TYPE = "Support"
    PROPERTIES = (
        *node_properties("Support", "Corners"),
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
    )
    FOUND = "HeldNodes"

    def check(self, obj, net, nodes):
        supports_of(obj, net, nodes)


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
    lines = [line for line in lines_of(obj, net) if len(line) > 1]
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
            nodes = nodes_of(support, net)
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
