# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports by recipe: which nodes of a net are held, and how, said in one word. Knows nothing of FreeCAD."""

import numpy as np

import funicular as fn

from . import topology

# A node counts as lowest within this part of the net's size: less than meets the eye, more than rounding.
LEVEL = 1e-4

# A border that turns by more degrees than this at a node has a corner there.
SHARP = 30.0


def support_recipe(net, name, openings=()):
    """The supports that a recipe makes on a net, from the positions of its nodes.

    openings: borders, as their nodes, that are known to be those of holes; without them every border but the
    longest is one for "opening rims". name, one of
    - "boundary": points on every node of the open border, but for openings;
    - "corners": points on the corners of the net's lattice, or, of a net on no lattice, on the nodes where
      its outer border turns by more than 30 degrees;
    - "corners and border planes": points on the corners, and for every other border node the vertical plane
      that holds the border's tangent there (Brivio et al. 2009, section 5.2);
    - "opening rims": points on every node of the borders but the longest;
    - "lowest points": points on the nodes within 1e-4 of the net's size of the lowest one;
    - "none".

    Returns a list of fn.Fixed and fn.OnPlane. Raises InvalidInput for an unknown name, where the net lacks
    what the recipe speaks of (a border, corners, a border that has a direction on plan), and where no node is
    left to move.
    """
    if name not in RECIPES:
        raise fn.InvalidInput(f"recipe '{name}' is unknown: choose one of {', '.join(RECIPES)}")
    supports = RECIPES[name](net, openings)
    if sum(len(support.ids) for support in supports if isinstance(support, fn.Fixed)) == len(net.nodes):
        raise fn.InvalidInput(
            f"recipe '{name}' holds every node, so nothing is left to relax; choose another, or a finer net"
        )
    return supports


def _boundary(net, openings):
    border = np.setdiff1d(net.border, np.concatenate([np.array([], dtype=int), *openings]))
    if not len(border) and not net.panels:
        raise fn.InvalidInput(
            "recipe 'boundary': the net has no panels, and so no border; choose 'lowest points' instead, and "
            "leave the covering out"
        )
    if not len(border):
        raise fn.InvalidInput(
            "recipe 'boundary': the net is closed and has no border; choose 'lowest points' instead"
        )
    return [fn.Fixed(border)]


def _corners(net, openings):
    return [fn.Fixed(_corner_nodes(net, "corners"))]


def _corners_and_border_planes(net, openings):
    corners = _corner_nodes(net, "corners and border planes")
    sides = (
        net.lattice.sides.values()
        if net.lattice
        else _between(topology.rims(net.nodes, net.panels)[0], corners)
    )
    try:
        return [fn.Fixed(corners), *vertical_planes(net.nodes, sides)]
    except fn.InvalidInput as error:
        raise fn.InvalidInput(
            f"recipe 'corners and border planes': {error}; choose 'corners' or 'boundary' instead"
        ) from None


def _opening_rims(net, openings):
    loops = openings or topology.rims(net.nodes, net.panels)[1:]
    if not loops:
        raise fn.InvalidInput("recipe 'opening rims': the net has no opening; choose 'boundary' instead")
    return [fn.Fixed(np.concatenate(loops))]


def _lowest_points(net, openings):
    z = net.nodes[:, 2]
    return [fn.Fixed(np.flatnonzero(z <= z.min() + LEVEL * net.size))]


def _none(net, openings):
    return []


RECIPES = {
    "boundary": _boundary,
    "corners": _corners,
    "corners and border planes": _corners_and_border_planes,
    "opening rims": _opening_rims,
    "lowest points": _lowest_points,
    "none": _none,
}


def _corner_nodes(net, recipe):
    corners = net.lattice.corners if net.lattice else _turns(net)
    if len(corners):
        return corners
    reason = (
        "the net has no corners (it closes on itself or runs to a pole)"
        if net.lattice
        else "the net's border has no corners (it turns by more than 30 degrees nowhere)"
    )
    other = "boundary" if len(net.border) else "lowest points"
    raise fn.InvalidInput(f"recipe '{recipe}': {reason}; choose '{other}' instead")


def _turns(net):
    """Nodes where the outer border turns sharply."""
    loops = topology.rims(net.nodes, net.panels)
    if not loops:
        return np.array([], dtype=int)
    loop = loops[0]
    along = net.nodes[np.roll(loop, -1)] - net.nodes[loop]
    along /= np.linalg.norm(along, axis=1)[:, None]
    return loop[(along * np.roll(along, 1, axis=0)).sum(axis=1) < np.cos(np.radians(SHARP))]


def _between(loop, corners):
    """The pieces of a closed loop from one corner to the next, both included."""
    at = np.flatnonzero(np.isin(loop, corners))
    turned = np.roll(loop, -at[0])
    ends = [*(at - at[0]), len(loop)]
    closed = np.append(turned, turned[0])
    return [closed[first : last + 1] for first, last in zip(ends, ends[1:])]


def joined_lines(nodes, lines, members):
    """[(line, whether it is closed)]: lines of nodes, those that go on smoothly in each other as one.

    nodes: (n, 3). lines: node numbers in order. members: set of sorted pairs of nodes, which tell whether the
    ends of a line meet.
    """
    open_lines = [list(map(int, line)) for line in lines]
    done = []
    while open_lines:
        line = open_lines.pop()
        while True:
            found = _next_line(nodes, line, open_lines)
            if found is None:
                break
            at, other = found
            open_lines.pop(at)
            line = other
        if line[0] == line[-1] and len(line) > 3 and _is_smooth(nodes, line[-2], line[0], line[1]):
            done.append((np.array(line[:-1]), True))
        elif len(line) > 2 and (min(line[0], line[-1]), max(line[0], line[-1])) in members:
            done.append((np.array(line), True))
        else:
            done.append((np.array(line), False))
    return done


def _next_line(nodes, line, others):
    """(which other line goes on from this one, both as one); None if none does."""
    for at, other in enumerate(others):
        for one in (line, line[::-1]):
            for two in (other, other[::-1]):
                if one[-1] == two[0] and _is_smooth(nodes, one[-2], one[-1], two[1]):
                    return at, one + two[1:]
    return None


def _is_smooth(nodes, before, at, after):
    arriving, leaving = nodes[at] - nodes[before], nodes[after] - nodes[at]
    along = arriving @ leaving / (np.linalg.norm(arriving) * np.linalg.norm(leaving))
    return bool(along > np.cos(np.radians(SHARP)))


def vertical_planes(nodes, lines, closed=False):
    """fn.OnPlane supports of the vertical planes that hold the tangents of lines of nodes.

    nodes: (n, 3). lines: sequences of node numbers; of open ones the two end nodes are not held.
    Raises InvalidInput where a line is vertical.
    """
    nodes_of_normal = {}
    for line in lines:
        line = np.asarray(line)
        whole = np.concatenate([line[-1:], line, line[:1]]) if closed else line
        for node, normal in zip(whole[1:-1], _horizontal_normals(nodes, whole)):
            # One support per direction: a straight border is one plane, not one per node.
            nodes_of_normal.setdefault(tuple(normal.round(12) + 0.0), []).append(int(node))
    return [fn.OnPlane(of_normal, normal=normal) for normal, of_normal in nodes_of_normal.items()]


def _horizontal_normals(nodes, side):
    """(k - 2, 3) unit normals of the vertical planes that hold a side's tangents at its inner nodes."""
    chords = nodes[side[2:]] - nodes[side[:-2]]
    normals = np.column_stack([-chords[:, 1], chords[:, 0], np.zeros(len(chords))])
    on_plan = np.linalg.norm(normals, axis=1)
    upright = np.flatnonzero(on_plan <= 1e-9 * np.linalg.norm(chords, axis=1))
    if len(upright):
        raise fn.InvalidInput(
            f"the border is vertical at node {side[1 + upright[0]]}, where more than one vertical plane "
            "holds it"
        )
    normals /= on_plan[:, None]
    # The sense of a normal has no meaning; making it one keeps equal planes together.
    leading = np.where(np.abs(normals[:, 0]) > 1e-9, normals[:, 0], normals[:, 1])
    return normals * np.where(leading < 0.0, -1.0, 1.0)[:, None]
