# SPDX-License-Identifier: LGPL-2.1-or-later
"""Support recipes: which nodes are held and how, and what is said where a recipe has nothing to hold."""

import numpy as np
import pytest

import funicular as fn
from funicular.recipes import RECIPES, support_recipe

UPRIGHT = np.array([0.0, 0.0, 1.0])


def patch(cells_u=4, cells_v=3, height=lambda x, y: 0.0 * x, turn=0.0):
    """A net on a lattice over 8 m x 6 m, turned about z by an angle."""
    lattice = fn.lattice(cells_u, cells_v)
    x, y = lattice.uv[:, 0] * 8.0, lattice.uv[:, 1] * 6.0
    c, s = np.cos(turn), np.sin(turn)
    return lattice.net(np.column_stack([c * x - s * y, s * x + c * y, height(x, y)]))


def dome():
    """Closed along u, with a pole on top."""
    lattice = fn.lattice(8, 4, closed_u=True, poles=["v_max"])
    turn, rise = 2.0 * np.pi * lattice.uv[:, 0], 0.5 * np.pi * lattice.uv[:, 1]
    return lattice.net(
        np.column_stack([np.cos(rise) * np.cos(turn), np.cos(rise) * np.sin(turn), np.sin(rise)])
    )


def torus():
    lattice = fn.lattice(8, 6, closed_u=True, closed_v=True)
    u, v = 2.0 * np.pi * lattice.uv.T
    return lattice.net(np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)]))


def held(supports):
    """Ids of all supported nodes, ascending."""
    return sorted(int(node) for support in supports for node in support.ids)


def test_boundary_holds_the_border_at_points():
    net = patch()
    supports = support_recipe(net, "boundary")
    assert [type(support) for support in supports] == [fn.Fixed]
    on_border = [i for i, (u, v) in enumerate(net.lattice.uv) if u in (0.0, 1.0) or v in (0.0, 1.0)]
    assert held(supports) == on_border


def test_boundary_of_a_dome_is_its_base():
    net = dome()
    assert held(support_recipe(net, "boundary")) == np.flatnonzero(net.lattice.uv[:, 1] == 0.0).tolist()


def test_boundary_needs_no_lattice():
    around = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    panels = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    members = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 4], [2, 4], [3, 4]]
    net = fn.Net([*around, [0.5, 0.5, 0.2]], members, panels)
    assert held(support_recipe(net, "boundary")) == [0, 1, 2, 3]


def test_corners_are_those_of_the_lattice():
    net = patch()
    supports = support_recipe(net, "corners")
    assert [type(support) for support in supports] == [fn.Fixed]
    positions = {tuple(net.nodes[node]) for node in held(supports)}
    assert positions == {(0, 0, 0), (8, 0, 0), (8, 6, 0), (0, 6, 0)}


@pytest.mark.parametrize("turn", [0.0, 0.7, 2.5])
def test_border_planes_hold_the_tangent_and_stand_upright(turn):
    net = patch(turn=turn, height=lambda x, y: 0.2 * x * y)
    corners, *planes = support_recipe(net, "corners and border planes")
    assert isinstance(corners, fn.Fixed) and held([corners]) == sorted(net.lattice.corners)
    # Straight borders, opposite ones parallel: two directions in all.
    assert len(planes) == 2
    assert held([corners, *planes]) == net.border.tolist()
    along = np.array([np.cos(turn), np.sin(turn), 0.0])
    across = np.cross(UPRIGHT, along)
    sides = net.lattice.sides
    for plane in planes:
        assert isinstance(plane, fn.OnPlane)
        assert plane.normal @ UPRIGHT == 0.0
        of_u_sides = set(held([plane])) <= set(sides["u_min"].tolist() + sides["u_max"].tolist())
        assert abs(plane.normal @ (along if of_u_sides else across)) == pytest.approx(1.0)


def test_border_planes_follow_a_curved_border():
    net = dome_quarter()
    _, *planes = support_recipe(net, "corners and border planes")
    nodes = net.nodes
    side = net.lattice.sides["v_min"]
    normals = {int(node): plane.normal for plane in planes for node in plane.ids}
    for before, node, after in zip(side, side[1:], side[2:]):
        assert normals[int(node)] @ (nodes[after] - nodes[before]) == pytest.approx(0.0, abs=1e-12)
        # On a circle the plane is at right angles to the radius.
        assert abs(normals[int(node)] @ nodes[node]) == pytest.approx(np.linalg.norm(nodes[node][:2]))


def dome_quarter():
    """A band of a sphere over a quarter of a circle."""
    lattice = fn.lattice(6, 3)
    turn, rise = 0.5 * np.pi * lattice.uv[:, 0], 0.3 * np.pi * lattice.uv[:, 1]
    return lattice.net(
        np.column_stack([np.cos(rise) * np.cos(turn), np.cos(rise) * np.sin(turn), np.sin(rise)])
    )


def test_lowest_points_are_level_with_the_lowest():
    net = patch(height=lambda x, y: x * (8 - x))
    assert held(support_recipe(net, "lowest points")) == [
        i for i, (u, _) in enumerate(net.lattice.uv) if u in (0.0, 1.0)
    ]
    tilted = patch(height=lambda x, y: x * (8 - x) + 0.5 * y)
    assert held(support_recipe(tilted, "lowest points")) == [
        i for i, (u, v) in enumerate(tilted.lattice.uv) if u in (0.0, 1.0) and v == 0.0
    ]


def test_lowest_points_do_not_depend_on_the_origin_or_the_size():
    net = patch(height=lambda x, y: x * (8 - x))
    expected = held(support_recipe(net, "lowest points"))
    for moved in (net.nodes + 1e6, net.nodes * 1e-3, net.nodes * 1e3):
        assert held(support_recipe(net.lattice.net(moved), "lowest points")) == expected


def test_a_recipe_that_leaves_nothing_to_move_is_refused():
    with pytest.raises(fn.InvalidInput, match="recipe 'lowest points' holds every node.*choose another"):
        support_recipe(patch(), "lowest points")
    with pytest.raises(fn.InvalidInput, match="recipe 'boundary' holds every node.*or a finer net"):
        support_recipe(patch(1, 1), "boundary")


def test_none_holds_nothing():
    assert support_recipe(patch(), "none") == []


@pytest.mark.parametrize(
    "make_net, recipe, sentence",
    [
        (torus, "boundary", "recipe 'boundary': the net is closed and has no border; choose 'lowest points'"),
        (torus, "corners", "recipe 'corners': the net has no corners .* choose 'lowest points' instead"),
        (dome, "corners", "recipe 'corners': the net has no corners .* choose 'boundary' instead"),
        (dome, "corners and border planes", "recipe 'corners and border planes': the net has no corners"),
        (
            patch,
            "edges",
            "recipe 'edges' is unknown: choose one of boundary, corners, corners and border planes",
        ),
    ],
)
def test_a_recipe_without_anything_to_hold_says_what_to_choose(make_net, recipe, sentence):
    with pytest.raises(fn.InvalidInput, match=sentence):
        support_recipe(make_net(), recipe)


def test_corners_of_a_net_without_lattice_are_where_its_border_turns():
    sheet = fn.Net.grid(4, 3, 1)
    bare = fn.Net(sheet.nodes, sheet.members, sheet.panels)
    assert sorted(support_recipe(bare, "corners")[0].ids) == sorted(sheet.lattice.corners)
    assert held(support_recipe(bare, "corners and border planes")) == sheet.border.tolist()


def test_corners_of_a_round_net_without_lattice_are_refused():
    lattice = fn.lattice(24, 2, closed_u=True, poles=["v_max"])
    turn, inwards = 2 * np.pi * lattice.uv[:, 0], 1 - lattice.uv[:, 1]
    disc = np.column_stack([inwards * np.cos(turn), inwards * np.sin(turn), 0 * turn])
    net = fn.Net(disc, lattice.members, lattice.panels)
    with pytest.raises(fn.InvalidInput, match="border has no corners .* choose 'boundary' instead"):
        support_recipe(net, "corners")


def test_a_vertical_border_has_no_one_plane():
    lattice = fn.lattice(2, 2)
    u, v = lattice.uv.T
    wall = lattice.net(np.column_stack([u, 0.0 * u, v]))
    with pytest.raises(
        fn.InvalidInput, match="the border is vertical at node .*choose 'corners' or 'boundary'"
    ):
        support_recipe(wall, "corners and border planes")


@pytest.mark.parametrize("recipe", [name for name in RECIPES if name != "none"])
def test_every_recipe_makes_a_shell_that_stands(recipe):
    net = patch(6, 5, height=lambda x, y: 0.05 * x * (8 - x) * (1 + 0.1 * y))
    if recipe == "opening rims":
        inner = int(np.argmin(np.linalg.norm(net.nodes - net.nodes.mean(axis=0), axis=1)))
        members = [pair for pair in net.members.tolist() if inner not in pair]
        net = fn.Net(
            np.delete(net.nodes, inner, axis=0),
            [[node - (node > inner) for node in pair] for pair in members],
            [[node - (node > inner) for node in panel] for panel in net.panels if inner not in panel],
        )
    scene = fn.Scene(
        net,
        supports=support_recipe(net, recipe),
        effects=[fn.AxialStiffness(100e3), fn.CoveringWeight(30.0)],
    )
    result = fn.solve(scene)
    assert result.status == "converged", result.message
    assert fn.certify(scene, result).compression_only
