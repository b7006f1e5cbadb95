# SPDX-License-Identifier: LGPL-2.1-or-later
"""A PointLoad in the document: which nodes of a net bear a force besides all weights, and which force."""

import FreeCAD as App

import funicular as fn

from .feature import Property, amount
from .node_choice import POINTS, NodeFeature, node_properties, nodes_of


class PointLoad(NodeFeature):
    """Proxy of a PointLoad; its shape are the nodes that bear it, as they lie on the net."""

    TYPE = "PointLoad"
    PROPERTIES = (
        *node_properties("Point load", POINTS),
        Property("App::PropertyForce", "Force", "Point load", "Force on each node", "1 kN", unit="N"),
        Property(
            "App::PropertyVector",
            "Direction",
            "Point load",
            "Where the force points to; its length plays no part",
            App.Vector(0, 0, -1),
        ),
        Property(
            "App::PropertyIntegerList", "LoadedNodes", "Point load", "What was found", mode=("ReadOnly",)
        ),
    )
    FOUND = "LoadedNodes"

    def check(self, obj, net, nodes):
        force_of(obj)


def force_of(obj):
    """(3,) force [N] of a PointLoad on each of its nodes. Raises InvalidInput naming Force or Direction."""
    force, direction = amount(obj, "Force", "N"), App.Vector(obj.Direction)
    if not 0.0 < direction.Length < float("inf"):
        raise fn.InvalidInput(
            f"Direction is {tuple(direction)}: give a vector that points where the force does, such as "
            "(0, 0, -1) for down"
        )
    direction.normalize()
    return tuple(force * each for each in direction)


def loads_of_gridshell(obj, net):
    """The fn.PointLoads of a Gridshell: those of its PointLoads, but for forces of zero.

    Raises InvalidInput naming the PointLoad.
    """
    loads = []
    for load in obj.PointLoads:
        if getattr(load, "FunicularType", "") != PointLoad.TYPE or load.Net != obj.Net:
            raise fn.InvalidInput(
                f"PointLoads holds {load.Label}, which is no point load on the net {obj.Net.Label}: take it "
                "out, or set its Net"
            )
        try:
            nodes, force = nodes_of(load, net), force_of(load)
        except fn.InvalidInput as error:
            raise fn.InvalidInput(f"{load.Label}: {error}") from None
        if any(force):
            loads.append(fn.PointLoad(nodes, force))
    return loads
