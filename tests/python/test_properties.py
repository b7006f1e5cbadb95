# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for every scene, and what a change of the input that changes nothing in the shape must leave.

When is a shape unique? Members that carry compression only have, in the sense of form finding, a pull that
never falls with their length and is never negative, so that their energy is a convex function of the nodes.
Under loads that do not depend on the shape an equilibrium is then its minimum, and it is the only one if
the taut members hold every node, directly or through others, to a fixed one: there the energy is strictly
convex. Weights that grow with the shape leave that as it is where strains are small, since solving with the
load of the last shape contracts. A slack member determines nothing: a node that hangs on slack members alone
may be anywhere within their reach, and two-way members have several equilibria. Shapes are compared for the
former only (`convex_cases`, `is_unique`).
"""

import dataclasses
import math
import re

import numpy as np
import pytest
from hypothesis import assume, event, given, settings, strategies as st

import funicular as fn
from strategies import cases, convex_cases, powers

STATUSES = {"converged", "iteration_limit", "time_limit", "cancelled", "no_equilibrium"}
ARGUMENTS = (
    "nodes|members|panels|net|supports|effects|rest_lengths|AxialStiffness|MemberWeight|CoveringWeight|Snow|"
    "PointLoad|accuracy|tolerance|max_seconds|max_iterations|start|method|scene|result|cells_u|cells_v|poles"
)
# Rounding as the result's documentation excuses it: never above this part of the mean nodal load.
MOST_EXCUSED = 1e-3
# Examples, of what is costly or tried in many ways: a quarter of the profile's.
FEWER = settings(max_examples=settings.default.max_examples // 4)


def scene_or_none(case):
    """The scene; None where it is refused, which has to be by a sentence that names an argument."""
    try:
        return case.scene()
    except fn.InvalidInput as refusal:
        assert re.match(f"({ARGUMENTS})\\b.{{12,}}", str(refusal)), f"which argument? {refusal}"
        event("refused: " + str(refusal).split(":")[0].split("[")[0])
        return None


def assert_sound(scene, result):
    """Numbers, a known status, forces that go with the lengths; `converged` is what the certificate says."""
    assert result.status in STATUSES
    assert result.message
    for name in ("nodes", "centred_nodes", "member_forces", "member_lengths", "reactions"):
        assert np.isfinite(getattr(result, name)).all(), f"{name} after {result.status}: {result.message}"
    assert result.residual >= 0 and result.position_error >= 0
    net = scene.net
    spans = result.centred_nodes[net.members[:, 1]] - result.centred_nodes[net.members[:, 0]]
    size = np.abs(result.centred_nodes).max()
    np.testing.assert_allclose(
        result.member_lengths, np.linalg.norm(spans, axis=1), rtol=1e-12, atol=1e-15 * size
    )
    axial = scene.effects[0]
    stiffness = np.asarray(axial.stiffness) / (1 if axial.per_spring else scene.rest_lengths)
    forces = -stiffness * (result.member_lengths - scene.rest_lengths)
    if axial.compression_only:
        forces = np.minimum(forces, 0)
    np.testing.assert_allclose(
        result.member_forces, forces, rtol=1e-9, atol=1e-14 * float(np.max(stiffness)) * size
    )
    certificate = fn.certify(scene, result)
    for name in ("max_residual", "balance", "moment_balance", "worst_tension", "support_error"):
        assert getattr(certificate, name) >= 0, name
    assert certificate.summary()
    if axial.compression_only:
        assert certificate.tension_members.size == 0
    if result.status == "converged":
        assert_converged(result, certificate)


def assert_converged(result, certificate):
    assert certificate.in_equilibrium, f"{certificate.summary()} The result says: {result.message}"
    allowed = 1.001 * certificate.tolerance
    if result.message == "In equilibrium.":
        assert result.residual <= allowed
    else:
        allowed = max(allowed, MOST_EXCUSED)
    assert certificate.max_residual <= max(allowed, MOST_EXCUSED)
    assert math.isfinite(result.position_error)
    assert certificate.balance <= max(1e-6, allowed)
    assert certificate.moment_balance <= max(1e-6, allowed)


def heavier(case, factor):
    """The case with all its weights multiplied."""
    return case.replace(
        effects=[
            (name, *rest) if name in ("AxialStiffness", "PointLoad") else (name, factor * rest[0], *rest[1:])
            for name, *rest in case.effects
        ]
    )


def goal_of(case):
    return {"accuracy": case.options["accuracy"], "tolerance": case.options["tolerance"]}


def assert_same_bits(one, other):
    assert (one.status, one.iterations, one.message) == (other.status, other.iterations, other.message)
    for name in ("nodes", "member_forces", "member_lengths", "reactions"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), err_msg=name)


def is_unique(scene, result):
    """Whether taut members hold every node to a fixed one, directly or through others."""
    forces = result.member_forces
    taut = scene.net.members[forces < 1e-6 * forces.min()]
    held = {int(node) for support in scene.supports if isinstance(support, fn.Fixed) for node in support.ids}
    grown = True
    while grown:
        reached = {int(b) for pair in taut for a, b in (pair, pair[::-1]) if int(a) in held}
        grown = not reached <= held
        held |= reached
    return len(held) == len(result.nodes)


def solved(case):
    """The unique shape of a convex case. It exists, as the energy grows with every member, so it is found."""
    scene = scene_or_none(case)
    assume(scene is not None)
    result = case.solve()
    assert_sound(scene, result)
    assert result.status == "converged", f"{result.status}: {result.message}"
    assume(is_unique(scene, result))
    return result


@given(cases())
def test_every_solve_ends_in_a_refusal_or_a_sound_result(case):
    scene = scene_or_none(case)
    if scene is None:
        return
    result = fn.solve(scene, start=case.start, **case.options)
    event(result.status)
    assert_sound(scene, result)
    assert result.status in ("converged", "iteration_limit", "no_equilibrium")
    assert result.iterations <= case.options["max_iterations"]
    assert_same_bits(result, fn.solve(case.scene(), start=case.start, **case.options))


@given(cases(), st.lists(st.sampled_from([0.0, 1e-5, 1e-3]), min_size=1, max_size=8), st.data())
def test_a_solver_can_be_left_looked_at_and_changed_anywhere(case, slices, data):
    scene = scene_or_none(case)
    if scene is None:
        return
    solver = fn.Solver(scene, start=case.start, method=case.options["method"], **goal_of(case))
    for seconds in slices:
        ended = solver.advance(seconds)
        assert np.isfinite(solver.nodes).all()
        result = solver.result()
        assert_sound(scene, result)
        assert ended or result.status == "iteration_limit"
        if data.draw(st.booleans()):
            scene = heavier(case, 2).scene()
            solver.replace(scene)


@given(cases(), st.integers(0, 6))
def test_a_cancelled_solve_says_so(case, turns):
    scene = scene_or_none(case)
    if scene is None:
        return
    told = []
    result = fn.solve(
        scene,
        start=case.start,
        **case.options,
        on_progress=lambda report: told.append(report) or len(told) <= turns,
    )
    assert_sound(scene, result)
    if len(told) > turns:
        assert result.status == "cancelled"


def turned(case, angle):
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    return moved(case, lambda points: points @ turn.T, lambda force: turn @ force)


def mirrored(case):
    mirror = np.array([-1.0, 1, 1])
    return moved(case, lambda points: points * mirror, lambda force: force * mirror)


def moved(case, move, move_force):
    given = [
        (name, rest[0], tuple(move_force(np.array(rest[1])))) if name == "PointLoad" else (name, *rest)
        for name, *rest in case.effects
    ]
    return case.replace(nodes=move(np.array(case.nodes)), effects=given), move


def scaled(case, scale):
    """EA / (wL s) and EA / (wA s²) stay: the same shape, as large."""
    power = {"MemberWeight": 1, "CoveringWeight": 2}
    given = [
        (name, rest[0] / scale ** power[name], *rest[1:]) if name in power else (name, *rest)
        for name, *rest in case.effects
    ]
    options = {**case.options, "accuracy": case.options["accuracy"] * scale}
    nodes = np.array(case.nodes) * scale
    return case.replace(nodes=nodes, effects=given, options=options), lambda points: points * scale


def renumbered(case, seed):
    """Other numbers, another order of members, members the other way round; a lattice becomes a bare net."""
    random = np.random.default_rng(seed)
    count = len(case.nodes)
    new = random.permutation(count)
    order = random.permutation(len(case.members))
    other = dataclasses.replace(
        case,
        lattice=None,
        nodes=np.array(case.nodes)[np.argsort(new)],
        members=[[int(new[n]) for n in case.members[e]][:: random.choice([1, -1])] for e in order],
        panels=[[int(new[n]) for n in panel] for panel in case.panels],
        supports=[(kind, [int(new[n]) for n in ids], *rest) for kind, ids, *rest in case.supports],
        effects=[
            (e[0], [int(new[n]) for n in e[1]], e[2]) if e[0] == "PointLoad" else e for e in case.effects
        ],
        rest_factors=None if case.rest_factors is None else [case.rest_factors[e] for e in order],
    )
    return other, lambda points: points[np.argsort(new)]


changes = st.one_of(
    st.floats(0.1, 6).map(lambda angle: ("turned", lambda case: turned(case, angle))),
    st.just(("mirrored", mirrored)),
    st.tuples(*[st.floats(-1e6, 1e6)] * 3).map(
        lambda shift: (
            "shifted",
            lambda case: moved(case, lambda points: points + shift, lambda force: force),
        )
    ),
    powers(-6, 3).map(lambda scale: ("scaled", lambda case: scaled(case, scale))),
    st.integers(0, 1000).map(lambda seed: ("renumbered", lambda case: renumbered(case, seed))),
)


@given(convex_cases(), changes)
def test_the_shape_does_not_depend_on_place_size_or_numbering(case, change):
    name, make = change
    event(name)
    result = solved(case)
    other, move = make(case)
    expected = move(result.nodes)
    np.testing.assert_allclose(
        solved(other).nodes, expected, rtol=0, atol=1e-6 * np.ptp(expected, axis=0).max()
    )


@given(convex_cases(), st.lists(st.sampled_from([0.0, 1e-5, 1e-4]), min_size=1, max_size=5))
def test_slices_give_the_bits_of_one_go(case, slices):
    assume(scene_or_none(case) is not None)
    solver = fn.Solver(case.scene(), **goal_of(case))
    for seconds in slices:
        solver.advance(seconds)
    solver.advance(math.inf)
    assert_same_bits(solver.result(), case.solve(max_iterations=None))


@given(convex_cases(), st.integers(0, 6), powers(-1, 1), st.booleans())
def test_a_detour_ends_at_the_shape_of_the_direct_way(case, steps, factor, cancelled):
    """Begun with other weights, left or cancelled after some steps, and gone on with the scene itself."""
    direct = solved(case)
    detour = heavier(case, factor)
    if cancelled:
        begun = detour.solve(on_progress=lambda report: report.iteration < steps)
        result = case.replace(start=begun.nodes).solve()
    else:
        solver = fn.Solver(detour.scene(), **goal_of(case))
        for _ in range(steps):
            solver.advance(0.0)
        solver.replace(case.scene())
        solver.advance(math.inf)
        result = solver.result()
    assert result.status == "converged", result.message
    size = np.ptp(direct.nodes, axis=0).max()
    np.testing.assert_allclose(result.nodes, direct.nodes, rtol=0, atol=1e-6 * size)


@given(convex_cases(), st.sampled_from(["auto", "newton"]))
def test_a_solve_begun_at_the_solution_ends_at_once(case, method):
    result = solved(case)
    again = case.replace(start=result.nodes).solve(method=method)
    assert again.status == "converged" and again.iterations <= 1
    np.testing.assert_allclose(
        again.nodes, result.nodes, rtol=0, atol=2e-8 + 1e-8 * np.abs(result.nodes).max()
    )


@FEWER  # relaxation takes its time
@given(convex_cases())
def test_newton_and_relaxation_find_the_shape_that_auto_finds(case):
    result = solved(case)
    size = np.ptp(result.nodes, axis=0).max()
    for method in ("newton", "relaxation"):
        other = case.solve(method=method)
        assert_sound(case.scene(), other)
        event(f"{method}: {other.status}")
        if other.status == "converged":
            np.testing.assert_allclose(other.nodes, result.nodes, rtol=0, atol=1e-6 * size)


@given(convex_cases(), st.floats(-3, 3), st.integers(0, 9))
def test_the_shape_does_not_depend_on_the_start(case, lift, seed):
    result = solved(case)
    nodes = np.array(case.nodes)
    size = np.ptp(nodes, axis=0).max()
    start = nodes + size * lift * np.sin(seed + 3.7 * np.arange(nodes.size)).reshape(nodes.shape)
    again = solved(case.replace(start=start.tolist()))
    np.testing.assert_allclose(
        again.nodes, result.nodes, rtol=0, atol=1e-6 * np.ptp(result.nodes, axis=0).max()
    )


def put(values, at, value):
    """A copy of a sequence of sequences with one entry replaced."""
    values = [list(row) for row in values]
    row = values[at % len(values)]
    row[at % len(row)] = value
    return values


def fixed(ids, stiffness=math.inf):
    return ("Fixed", ids, (0, 0, 1), stiffness)


NOT_FINITE = [math.nan, math.inf, -math.inf]
# What is wrong: how the case becomes so, wrong values, and how the message begins.
WRONG = {
    "a coordinate": (
        lambda c, at, x: {"nodes": put(c.nodes, at, x), "lattice": None},
        NOT_FINITE,
        r"nodes\[",
    ),
    "a member": (
        lambda c, at, x: {"members": put(c.members, at, x), "lattice": None},
        [-1, 99, 2**40],
        r"members\[",
    ),
    "a panel": (
        lambda c, at, x: {"panels": [[0, 1, x]], "lattice": None},
        [-1, 99, 0, 2**33],
        r"panels\[0\]",
    ),
    "a supported node": (lambda c, at, x: {"supports": [*c.supports, fixed([0, x])]}, [-1, 99, 2**31], ""),
    "a stiffness": (
        lambda c, at, x: {"supports": [*c.supports, fixed([0], x)]},
        [math.nan, -1.0],
        r"supports\[",
    ),
    "a direction": (
        lambda c, at, x: {"supports": [*c.supports, ("OnLine", [0], (x, 0, 0), math.inf)]},
        [0.0, *NOT_FINITE],
        r"supports\[",
    ),
    "EA": (lambda c, at, x: {"effects": [("AxialStiffness", x)]}, [0.0, -1.0, *NOT_FINITE], "AxialStiffness"),
    "no EA": (lambda c, at, x: {"effects": c.effects[1:]}, [None], "effects"),
    "two EA": (lambda c, at, x: {"effects": [c.effects[0], *c.effects]}, [None], "effects"),
    "a weight": (
        lambda c, at, x: {"effects": [*c.effects, ("MemberWeight", x)]},
        [-1.0, *NOT_FINITE],
        "MemberWeight",
    ),
    "a force": (
        lambda c, at, x: {"effects": [*c.effects, ("PointLoad", [0], (0, x, 0))]},
        NOT_FINITE,
        "PointLoad",
    ),
    "a loaded node": (
        lambda c, at, x: {"effects": [*c.effects, ("PointLoad", [x], (0, 0, 1))]},
        [-1, 99, 2**31],
        "PointLoad|ids",
    ),
    "a rest length": (
        lambda c, at, x: {"rest_factors": put([[1.0] * len(c.members)], at, x)[0]},
        [-1.0, 0.0, *NOT_FINITE],
        r"rest_lengths\[",
    ),
    "a start": (lambda c, at, x: {"start": put(c.nodes, at, x)}, NOT_FINITE, r"start\["),
    "a short start": (lambda c, at, x: {"start": c.nodes[:-1]}, [None], "start has"),
    "tolerance": (lambda c, at, x: {"options": {"tolerance": x}}, [0.0, -1.0, *NOT_FINITE], "tolerance"),
    "accuracy": (lambda c, at, x: {"options": {"accuracy": x}}, [0.0, -1.0, *NOT_FINITE], "accuracy"),
    "a limit": (lambda c, at, x: {"options": {"max_iterations": x}}, [-1, 0.5, math.inf], "max_iterations"),
    "a time": (lambda c, at, x: {"options": {"max_seconds": x}}, [-1.0, math.nan], "max_seconds"),
    "a method": (lambda c, at, x: {"options": {"method": x}}, ["", "fast"], "method"),
}


@pytest.mark.parametrize("what", WRONG)
@FEWER  # there are as many of these as of all other properties
@given(convex_cases(), st.data(), st.integers(0, 10_000))
def test_one_wrong_value_is_named(what, case, data, at):
    assume(scene_or_none(case) is not None)
    make, values, begins = WRONG[what]
    wrong = case.replace(**make(case, at, data.draw(st.sampled_from(values))))
    with pytest.raises(fn.InvalidInput, match=f"^({begins})"):
        wrong.solve()
