# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `make soak` and the properties found: each one a plain test, so that it stays mended."""

import math

import funicular as fn
from strategies import Case

FIXED_0 = [("Fixed", [0], (0, 0, 1), math.inf)]


def assert_certified(case):
    result = case.solve()
    assert result.status == "converged", result.message
    certificate = fn.certify(case.scene(), result)
    assert certificate.in_equilibrium, certificate.summary()


def test_a_net_without_load_or_stretch_is_in_equilibrium():
    """Member forces that are rounding were measured by their own mean: a residual of 7, and denied."""
    nodes = [[0, 0, 0], [1e-6, 0, 0], [2e-6, 6.75e-7, 0], [3e-6, 0, 0], [4e-6, 0, 0]]
    members = [[0, 1], [1, 2], [2, 0], [1, 3], [3, 0], [1, 4], [4, 0]]
    assert_certified(Case(nodes, members, [], FIXED_0, [("AxialStiffness", 1.0, False)]))


def test_the_certificate_knows_the_area_of_a_panel_that_hangs_in_a_line():
    """From its three sides, a triangle without area had 1e-8 of the square of its length."""
    effects = [("AxialStiffness", 600.0, True), ("MemberWeight", 0.1), ("CoveringWeight", 0.1)]
    sheet = fn.lattice(1, 2)
    nodes = [[3 * u, 2 * v, 0] for u, v in sheet.uv]
    options = {"tolerance": 1e-9, "accuracy": 1e-8}
    members, panels = sheet.members.tolist(), list(sheet.panels)
    assert_certified(Case(nodes, members, panels, FIXED_0, effects, options=options))


def test_a_node_that_two_supports_hold_wholly_has_no_residual():
    """Where no node can move, rounding in the sum of the held directions counted against nothing."""
    nodes = [[k * 1e-6, 0, 0] for k in range(5)]
    members = [[0, 1], [1, 2], [2, 0], [1, 3], [3, 0], [1, 4], [4, 0]]
    supports = [("OnLine", [0], (0.0, 0.5, 1.0), math.inf), ("Fixed", [0, 1, 2, 3, 4], (0, 0, 1), math.inf)]
    effects = [("AxialStiffness", 1.0, False), ("MemberWeight", 1e6)]
    assert_certified(Case(nodes, members, [], supports, effects))


def test_moments_are_measured_by_the_shape_and_not_by_the_source():
    """A shape eleven times as large as its net had eleven times the moment of the same residual."""
    effects = [("AxialStiffness", 1.0, False), ("PointLoad", [1], (0.0, 0.0, 10.0))]
    options = {"tolerance": 1e-3, "accuracy": 1e-8, "method": "relaxation"}
    assert_certified(Case([[0, 0, 0], [1e-6, 0, 0]], [[0, 1]], [], FIXED_0, effects, options=options))


def test_rounding_that_is_excused_at_a_node_is_excused_in_the_sum():
    """Where a covering collapses with its weight, rounding of the members was held against the balance.

    The load vanishes with the panel's area as the net swings into line, so that a residual relative to it may
    never fall: then the solver has to say so.
    """
    nodes = [[0, 0, 0], [1e-6, 0, 0], [2e-6, 9e-7, 0]]
    effects = [("AxialStiffness", 1e9, False), ("CoveringWeight", 1e12)]
    options = {"tolerance": 1e-6, "accuracy": 1e-8, "max_iterations": 300}
    case = Case(nodes, [[0, 1], [1, 2]], [[0, 2, 1]], FIXED_0, effects, [1.0, 0.2371], options=options)
    result = case.solve()
    assert result.status in ("converged", "iteration_limit")
    assert fn.certify(case.scene(), result).in_equilibrium == (result.status == "converged")


def test_two_lines_that_count_as_one_leave_the_node_on_its_support():
    """Lines at less than 1.4e-4 count as one, but the node moved along their mean, off both of them."""
    lines = [("OnLine", [1], (0, 0, 1), math.inf), ("OnLine", [1], (0.0, 6.1e-5, 1.0), math.inf)]
    effects = [("AxialStiffness", 1.0, False), ("PointLoad", [1], (0.0, 0.0, 1.0))]
    options = {"tolerance": 1e-3, "accuracy": 1e-8}
    assert_certified(Case([[0, 0, 0], [1e-6, 0, 0]], [[0, 1]], [], FIXED_0 + lines, effects, options=options))


def test_a_line_almost_in_a_plane_leaves_one_direction_to_solver_and_certificate():
    """It leaves the plane by 1e-5: the solver freed the direction between them, the certificate another."""
    held = [("OnPlane", [0], (0, 0, 1), math.inf), ("OnLine", [0], (1, 0, 1e-5), math.inf)]
    effects = [("AxialStiffness", 1.0, False), ("PointLoad", [0], (0.0, 0.0, 1.0))]
    nodes = [[k * 1e-6, 0, 0] for k in range(20)]
    members = [[k, k + 1] for k in range(19)]
    options = {"accuracy": 1e-8, "max_iterations": 1}
    supports = [*held, ("Fixed", [1], (0, 0, 1), math.inf)]
    assert_certified(Case(nodes, members, [], supports, effects, options=options))


def test_solver_and_certificate_excuse_the_same_rounding_at_an_elastic_support():
    """The solver counted its stiffness three times (the trace), the certificate once."""
    nodes = [[k * 1000.0, 0, 0] for k in range(5)]
    supports = [("Fixed", [2], (0, 0, 1), 100.0), ("Fixed", [0, 4], (0, 0, 1), math.inf)]
    effects = [("AxialStiffness", 0.1, False), ("PointLoad", [1], (0.0, 0.0, 1.0))]
    case = Case(nodes, [[0, 1], [1, 2], [2, 3]], [], supports, effects, [1.0, 3.162, 1.0])
    solver = fn.Solver(case.scene(), method="relaxation", tolerance=1e-9, accuracy=10.0)
    while not solver.advance(1.0):
        pass
    result = solver.result()
    assert result.status == "converged"
    assert fn.certify(case.scene(), result).in_equilibrium
