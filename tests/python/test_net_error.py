# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a net is from its smooth surface, against integrals of that surface, and the scenes between."""

import numpy as np
import pytest

import funicular as fn
from funicular.discretisation import coarser

GRAVITY = 9.80665


def vault(cells, span, rest, ea, weight):
    """Arches side by side, of arc length `rest` over `span`, that weigh `weight` newtons a metre."""
    lattice = fn.lattice(cells, 3, pattern="ribs_u")
    u, v = lattice.uv.T
    net = lattice.net(np.column_stack([span * u, 6 * v, 0 * u]))
    springers = np.flatnonzero((u == 0) | (u == 1))
    effects = [fn.AxialStiffness(ea), fn.MemberWeight(weight / GRAVITY)]
    lengths = np.full(len(net.members), rest / cells)
    return fn.Scene(net, [fn.Fixed(springers)], effects, rest_lengths=lengths)


def rib_dome(bays):
    """Twelve ribs of no rest length with a horizontal thrust of 20 N, under their covering."""
    lattice = fn.lattice(12, bays, pattern="ribs_v", closed_u=True, poles=["v_max"])
    azimuth, radius = 2 * np.pi * lattice.uv[:, 0], 10 * (1 - lattice.uv[:, 1])
    net = lattice.net(np.column_stack([radius * np.cos(azimuth), radius * np.sin(azimuth), 0 * radius]))
    effects = [
        fn.AxialStiffness(20 / (10 / bays), per_spring=True),
        fn.CoveringWeight(1 / GRAVITY, share="equal"),
    ]
    base = np.flatnonzero(lattice.uv[:, 1] == 0)
    return fn.Scene(net, [fn.Fixed(base)], effects, rest_lengths=np.zeros(len(net.members)))


# Scene, rise of the smooth one: a catenary that hardly stretches, the paper's law, a dome of ribs.
SMOOTH = {
    "catenary": (lambda: vault(64, 10, 10.5, 1e7, 1), 1.393042066),
    "barrel vault, soft": (lambda: vault(64, 10, 12, 100, 1), 3.428745739),
    "barrel vault": (lambda: vault(64, 10, 12, 1000, 1), 2.979343367),
    "rib dome": (lambda: rib_dome(64), 4.692433429),
}


@pytest.mark.parametrize("name", SMOOTH)
def test_of_second_order_and_as_far_as_it_truly_is(name):
    make, rise = SMOOTH[name]
    scene = make()
    result = fn.solve(scene, accuracy=1e-9, tolerance=1e-8)
    error = fn.net_error(scene, result)
    assert error.is_smooth and abs(error.order - 2.0) < 0.15
    true = abs(result.nodes[:, 2].max() - rise)
    # The largest distance need not be that of the apex.
    assert true < 1.1 * error.distance < 2.0 * true
    assert f"{1e3 * error.distance:.3g} mm from the smooth surface" in str(error)


def test_a_sheet_of_odd_cells_tells_what_the_finer_net_then_shows():
    def sheet(step):
        net = fn.Net.grid(8.25, 6.75, step)
        return fn.Scene(net, [fn.Fixed(net.border)], [fn.AxialStiffness(1e6 * step), fn.CoveringWeight(40.0)])

    coarse, fine = sheet(0.75), sheet(0.375)
    shapes = [fn.solve(scene, accuracy=1e-9, tolerance=1e-8) for scene in (coarse, fine)]
    told = fn.net_error(coarse, shapes[0]).distance
    assert coarse.net.lattice.cells == (11, 9)
    seen = np.abs(shapes[0].nodes[:, 2].max() - shapes[1].nodes[:, 2].max())
    assert 0.4 * seen < told < 6 * seen


def test_a_net_on_corners_is_told_to_be_of_lower_order():
    net = fn.Net.grid(16, 16, 0.5)
    scene = fn.Scene(net, [fn.Fixed(net.lattice.corners)], [fn.AxialStiffness(1e5), fn.MemberWeight(12.0)])
    error = fn.net_error(scene)
    assert error.order < 1.5
    first, second = coarser(scene, 2)
    shapes = [fn.solve(each, accuracy=1e-9, tolerance=1e-8).nodes for each in (scene, first.scene)]
    apart = np.linalg.norm(shapes[0][first.kept] - shapes[1], axis=1).max()
    assert error.distance > 0.99 * apart / (2 ** min(error.order, 2) - 1), "more than a third of it"
    if not error.is_smooth:
        assert "or more" in str(error)


def test_the_coarser_scene_weighs_and_holds_the_same():
    net = fn.Net.grid(8, 6, 0.5)
    effects = [
        fn.AxialStiffness(1e5),
        fn.MemberWeight(12.0),
        fn.CoveringWeight(30.0),
        fn.Snow(500.0),
        fn.PointLoad([net.lattice.corners[0] + 20], (0, 0, -300.0)),
    ]
    scene = fn.Scene(net, [fn.Fixed(net.border)], effects)
    weights = []
    for _ in range(3):
        result = fn.solve(scene, accuracy=1e-9, tolerance=1e-8)
        assert fn.certify(scene, result).compression_only
        weights.append(result.reactions[:, 2].sum())
        scene = scene.coarsened()[0]
    assert scene.net.lattice.cells == (2, 3)
    assert np.ptp(weights[:2]) < 0.05 * weights[0] and np.ptp(weights) < 0.12 * weights[0]


def test_what_has_no_coarser_net_says_why():
    net = fn.Net.grid(6, 5, 0.5, pattern="triangle")
    triangles = fn.Scene(net, [fn.Fixed(net.border)], [fn.AxialStiffness(1e5), fn.MemberWeight(12.0)])
    with pytest.raises(fn.InvalidInput, match="no lattice of quads or ribs"):
        triangles.coarsened()
    net = fn.Net.grid(8, 8, 1)
    held = fn.Scene(net, [fn.Fixed([0, 8, 40, 31])], [fn.AxialStiffness(1e5), fn.MemberWeight(12.0)])
    with pytest.raises(fn.InvalidInput, match="node 31 is supported"):
        fn.net_error(held)
    other = fn.solve(triangles)
    whole = fn.Scene(net, [fn.Fixed(net.border)], [fn.AxialStiffness(1e5), fn.MemberWeight(12.0)])
    with pytest.raises(fn.InvalidInput, match="result has .* nodes, the scene's net has 81"):
        fn.net_error(whole, other)


def test_a_net_with_an_opening_is_refused_where_its_panels_bear_loads():
    whole = fn.Net.grid(8, 8, 0.5)
    panels = [panel for k, panel in enumerate(whole.panels) if k != 120]
    net = fn.Net(whole.nodes, whole.members, panels)
    effects = [fn.AxialStiffness(1e5), fn.CoveringWeight(30.0)]
    with pytest.raises(fn.InvalidInput, match="its net has openings"):
        fn.net_error(fn.Scene(net, [fn.Fixed(net.border)], effects))
    bare = fn.Scene(net, [fn.Fixed(whole.border)], [fn.AxialStiffness(1e5), fn.MemberWeight(12.0)])
    assert fn.net_error(bare).is_smooth, "where they bear none they do not matter"


def test_a_border_may_be_held_by_several_supports():
    net = fn.Net.grid(8, 8, 0.5)
    effects = [fn.AxialStiffness(1e5), fn.CoveringWeight(30.0)]
    left = net.lattice.sides["u_min"]
    rest = np.setdiff1d(net.border, left)
    errors = [
        fn.net_error(fn.Scene(net, supports, effects)).distance
        for supports in ([fn.Fixed(net.border)], [fn.Fixed(left), fn.Fixed(rest)])
    ]
    assert errors[0] == pytest.approx(errors[1], rel=1e-6)


def test_what_two_nets_say_is_not_taken_for_an_order():
    net = fn.Net.grid(6, 6, 1)
    effects = [fn.AxialStiffness(1e5), fn.CoveringWeight(30.0)]
    scene = fn.Scene(net, [fn.Fixed(net.border)], effects)
    first = coarser(scene, 2)
    assert len(first) == 1
    error = fn.net_error(scene)
    shapes = [fn.solve(each, accuracy=1e-9, tolerance=1e-8).nodes for each in (scene, first[0].scene)]
    apart = np.linalg.norm(shapes[0][first[0].kept] - shapes[1], axis=1).max()
    assert error.order is None and not error.is_smooth and "or more" in str(error)
    assert error.distance == pytest.approx(apart, rel=1e-6)
    even = [k for k, node in enumerate(net.nodes) if (node[:2] % 2 == 0).all()]
    with pytest.raises(fn.InvalidInput, match="there is no telling"):
        fn.net_error(fn.Scene(net, [fn.Fixed(even)], effects))
    with pytest.raises(fn.InvalidInput, match="result did not converge"):
        fn.net_error(scene, fn.solve(scene, max_iterations=1))
