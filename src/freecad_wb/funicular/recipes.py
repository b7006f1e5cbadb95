# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports by recipe: which nodes of a net are held, and how, said in one word. Knows nothing of FreeCAD."""

import numpy as np

import funicular as fn

# A node counts as lowest within this part of the net's size: less than meets the eye, more than rounding.
LEVEL = 1e-4


def support_recipe(net, name):
    """The supports that a recipe makes on a net, from the positions of its nodes.

    name, one of
    - "boundary": points on every node of the open border;
    - "corners": points on the four corners of the net's lattice;
    - "corners and border planes": points on the corners, and for every other border node the vertical plane
      that holds the border's tangent there (Brivio et al. 2009, section 5.2);
    - "lowest points": points on the nodes within 1e-4 of the net's size of the lowest one;
    - "none".

    Returns a list of fn.Fixed and fn.OnPlane. Raises InvalidInput for an unknown name, where the net lacks
    what the recipe speaks of (a border, corners, a border that has a direction on plan), and where no node is
    left to move.
    """
    if name not in RECIPES:
        raise fn.InvalidInput(f"recipe '{name}' is unknown: choose one of {', '.join(RECIPES)}")
    supports = RECIPES[name](net)
    if sum(len(support.ids) for support in supports if isinstance(support, fn.Fixed)) == len(net.nodes):
        raise fn.InvalidInput(
            f"recipe '{name}' holds every node, so nothing is left to relax; choose another, or a finer net"
        )
    return supports


def _boundary(net):
    if not len(net.border):
        raise fn.InvalidInput(
            "recipe 'boundary': the net is closed and has no border; choose 'lowest points' instead"
        )
    return [fn.Fixed(net.border)]


def _corners(net):
    return [fn.Fixed(_corner_nodes(net, "corners"))]


def _corners_and_border_planes(net):
    corners = _corner_nodes(net, "corners and border planes")
    nodes_of_normal = {}
    for side in net.lattice.sides.values():
        for node, normal in zip(side[1:-1], _horizontal_normals(net.nodes, side)):
            # One support per direction: a straight border is one plane, not one per node.
            nodes_of_normal.setdefault(tuple(normal.round(12) + 0.0), []).append(int(node))
    planes = [fn.OnPlane(nodes, normal=normal) for normal, nodes in nodes_of_normal.items()]
    return [fn.Fixed(corners), *planes]


def _lowest_points(net):
    z = net.nodes[:, 2]
    return [fn.Fixed(np.flatnonzero(z <= z.min() + LEVEL * net.size))]


def _none(net):
    return []


RECIPES = {
    "boundary": _boundary,
    "corners": _corners,
    "corners and border planes": _corners_and_border_planes,
    "lowest points": _lowest_points,
    "none": _none,
}


def _corner_nodes(net, recipe):
    if net.lattice is None:
        reason = "the net was not made on a lattice"
    elif not len(net.lattice.corners):
        reason = "the net has no corners (it closes on itself or runs to a pole)"
    else:
        return net.lattice.corners
    other = "boundary" if len(net.border) else "lowest points"
    raise fn.InvalidInput(f"recipe '{recipe}': {reason}; choose '{other}' instead")


def _horizontal_normals(nodes, side):
    """(k - 2, 3) unit normals of the vertical planes that hold a side's tangents at its inner nodes."""
    chords = nodes[side[2:]] - nodes[side[:-2]]
    normals = np.column_stack([-chords[:, 1], chords[:, 0], np.zeros(len(chords))])
    on_plan = np.linalg.norm(normals, axis=1)
    upright = np.flatnonzero(on_plan <= 1e-9 * np.linalg.norm(chords, axis=1))
    if len(upright):
        raise fn.InvalidInput(
            "recipe 'corners and border planes': the border is vertical at node "
            f"{side[1 + upright[0]]}, where more than one vertical plane holds it; choose 'corners' or "
            "'boundary' instead"
        )
    normals /= on_plan[:, None]
    # The sense of a normal has no meaning; making it one keeps equal planes together.
    leading = np.where(np.abs(normals[:, 0]) > 1e-9, normals[:, 0], normals[:, 1])
    return normals * np.where(leading < 0.0, -1.0, 1.0)[:, None]
