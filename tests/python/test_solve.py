# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene, solve, certificate and solver from Python: names, units, statuses, threads that scripts rely on."""

import gc
import threading
import time

import numpy as np
import pytest

import funicular as fn

G = 9.80665


def roof(step=1.0, effects=None, compression_only=True):
    net = fn.Net.grid(8.0, 6.0, step=step)
    if effects is None:
        effects = [fn.MemberWeight(12.0), fn.CoveringWeight(30.0), fn.Snow(1000.0)]
    return fn.Scene(
        net,
        supports=[fn.Fixed(net.lattice.corners)],
        effects=[fn.AxialStiffness(100e3, compression_only=compression_only), *effects],
    )


def long_solve(**options):
    """A solve that would take minutes if nothing stopped it."""
    return fn.solve(roof(step=0.25), method="relaxation", tolerance=1e-14, accuracy=1e-14, **options)


def test_result_has_the_promised_arrays():
    scene = roof()
    result = fn.solve(scene)
    n, m = len(scene.net.nodes), len(scene.net.members)
    assert result.status == "converged" and result.method == "newton"
    for name, shape in {
        "nodes": (n, 3),
        "member_forces": (m,),
        "member_lengths": (m,),
        "reactions": (n, 3),
        "centred_nodes": (n, 3),
    }.items():
        array = getattr(result, name)
        assert array.shape == shape and array.dtype == np.float64, name
        assert np.isfinite(array).all(), name
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0
    assert result.residual <= 1e-6 and result.position_error <= 1e-3
    assert result.seconds > 0
    assert len(result.history) == result.iterations + 1
    assert result.history[-1].residual == result.residual


def test_arrays_outlive_the_result():
    forces = fn.solve(roof()).member_forces
    gc.collect()
    np.testing.assert_array_equal(forces, fn.solve(roof()).member_forces)


def test_signs_are_those_of_the_built_structure():
    scene = roof()
    result = fn.solve(scene)
    assert (result.member_forces <= 0).all(), "compression is negative"
    corners = scene.net.lattice.corners
    assert (result.reactions[corners, 2] > 0).all(), "supports push up"
    free = np.setdiff1d(np.arange(len(scene.net.nodes)), corners)
    assert not result.reactions[free].any()
    assert result.nodes[:, 2].max() > 1, "the shell stands"


def test_weight_is_that_of_the_final_shape():
    scene = roof(effects=[fn.MemberWeight(12.0)])
    result = fn.solve(scene, tolerance=1e-10)
    weight = G * 12.0 * result.member_lengths.sum()
    assert result.reactions[:, 2].sum() == pytest.approx(weight, rel=1e-9)
    spans = result.nodes[scene.net.members[:, 1]] - result.nodes[scene.net.members[:, 0]]
    np.testing.assert_allclose(result.member_lengths, np.linalg.norm(spans, axis=1), rtol=1e-13)


def test_costs_name_the_effects_present_and_no_others():
    assert set(fn.solve(roof()).costs) == {"axial", "member_weight", "covering_weight", "snow"}
    result = fn.solve(roof(effects=[fn.MemberWeight(12.0), fn.CoveringWeight(0.0), fn.Snow(0)]))
    assert set(result.costs) == {"axial", "member_weight"}
    for evaluations, seconds in result.costs.values():
        assert evaluations >= result.iterations and seconds > 0


def test_certificate_agrees_with_the_result():
    scene = roof()
    result = fn.solve(scene)
    certificate = fn.certify(scene, result)
    assert certificate.compression_only and certificate.in_equilibrium
    assert certificate.tension_members.size == 0 and certificate.worst_tension == 0
    assert certificate.max_residual == pytest.approx(result.residual, rel=1e-3, abs=1e-10)
    assert certificate.balance < 1e-6 and certificate.moment_balance < 1e-6
    np.testing.assert_allclose(certificate.reaction_sum, result.reactions.sum(axis=0), atol=1e-9)
    np.testing.assert_allclose(certificate.total_load, -certificate.reaction_sum, atol=1e-3)
    assert certificate.summary().startswith("Compression only")
    assert fn.certify(scene, result.nodes, tolerance=1e-6).compression_only
    assert not fn.certify(scene, scene.net.nodes).in_equilibrium


def test_certificate_names_tension():
    lattice = fn.lattice(24, 12, closed_u=True, poles=["v_max"])
    turn, rise = 2 * np.pi * lattice.uv[:, 0], np.pi / 2 * lattice.uv[:, 1]
    nodes = 10 * np.column_stack([np.cos(rise) * np.cos(turn), np.cos(rise) * np.sin(turn), np.sin(rise)])
    net = lattice.net(nodes)
    for compression_only in (True, False):
        effects = [fn.AxialStiffness(1e8, compression_only=compression_only), fn.CoveringWeight(50)]
        scene = fn.Scene(net, [fn.Fixed(lattice.sides["v_min"])], effects)
        certificate = fn.certify(scene, fn.solve(scene))
        assert certificate.compression_only == compression_only
        assert (certificate.tension_members.size > 0) != compression_only
        assert certificate.slack_members.size > 0


def test_supports_and_effects_tell_what_they_are():
    net = fn.Net.grid(2, 2, 1)
    scene = fn.Scene(
        net,
        [
            fn.Fixed(0),
            fn.OnLine([1], direction=(0, 1, 1), stiffness=5),
            fn.OnPlane(np.array([2, 3]), normal=(0, 2, 0)),
        ],
        [
            fn.AxialStiffness(np.full(12, 7.0), compression_only=False),
            fn.PointLoad([4], (1, 2, -3)),
            fn.CoveringWeight(3, share="voronoi"),
            fn.Snow(0),
        ],
    )
    fixed, line, plane = scene.supports
    assert isinstance(fixed, fn.Fixed) and fixed.ids.tolist() == [0] and fixed.stiffness == np.inf
    assert isinstance(line, fn.OnLine) and line.direction == (0, 1, 1) and line.stiffness == 5
    assert isinstance(plane, fn.OnPlane) and plane.normal == (0, 2, 0) and plane.ids.tolist() == [2, 3]
    axial, load, covering = scene.effects
    np.testing.assert_array_equal(axial.stiffness, np.full(12, 7.0))
    assert not axial.compression_only and not axial.per_spring
    assert load.force == (1, 2, -3) and covering.share == "voronoi" and covering.weight == 3
    np.testing.assert_array_equal(scene.rest_lengths, net.source_lengths)


NET = ([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1], [1, 2]])


@pytest.mark.parametrize(
    "make, words",
    [
        (
            lambda net: fn.Scene(net, [fn.Fixed([0, 9])], [fn.AxialStiffness(1)]),
            ["supports[0]", "ids[1] is 9"],
        ),
        (lambda net: fn.Scene(net, [fn.Fixed([0.5])], [fn.AxialStiffness(1)]), ["ids", "integers"]),
        (lambda net: fn.Scene(net, [fn.Fixed([-1])], [fn.AxialStiffness(1)]), ["ids[0]", "-1"]),
        (lambda net: fn.Scene(net, [fn.Fixed(0), 7], [fn.AxialStiffness(1)]), ["supports[1]"]),
        (
            lambda net: fn.Scene(net, [], [fn.AxialStiffness(1)]),
            ["component of 3 nodes has no support", "nodes 0, 1, 2"],
        ),
        (lambda net: fn.Scene(net, [fn.OnLine([0])], [fn.AxialStiffness(1)]), ["vertically"]),
        (lambda net: fn.Scene(net, [fn.OnLine([0], (0, 0))], [fn.AxialStiffness(1)]), ["direction", "three"]),
        (lambda net: fn.Scene(net, [fn.Fixed(0)], []), ["AxialStiffness is missing"]),
        (lambda net: fn.Scene(net, [fn.Fixed(0)], ["snow"]), ["effects[0]"]),
        (
            lambda net: fn.Scene(net, [fn.Fixed(0)], [fn.AxialStiffness(-1)]),
            ["AxialStiffness", "stiffness must be positive"],
        ),
        (lambda net: fn.Scene(net, [fn.Fixed(0)], [fn.AxialStiffness([1, 2, 3])]), ["3 values", "2 members"]),
        (lambda net: fn.Scene(net, [fn.Fixed(0)], [fn.AxialStiffness(1), fn.Snow(5)]), ["Snow", "no panels"]),
        (
            lambda net: fn.Scene(net, [fn.Fixed(0)], [fn.AxialStiffness(1), fn.MemberWeight(-2)]),
            ["MemberWeight"],
        ),
        (lambda net: fn.Scene(net, [fn.Fixed(0)], [fn.AxialStiffness(1)], [1.0, -1.0]), ["rest_lengths[1]"]),
        (lambda net: fn.CoveringWeight(1, share="fair"), ["share 'fair'", "angle", "equal", "voronoi"]),
        (lambda net: fn.PointLoad([0], (0, 0)), ["force", "three"]),
        (lambda net: fn.MemberWeight("12 kg/m"), ["weight", "number", "12 kg/m"]),
        (lambda net: fn.Snow(None), ["pressure", "number"]),
        (lambda net: fn.CoveringWeight([1, 2]), ["weight", "number"]),
        (lambda net: fn.Fixed([0], stiffness="soft"), ["stiffness", "number"]),
        (lambda net: fn.Fixed(np.array([True, False, True])), ["ids", "numpy.flatnonzero"]),
        (lambda net: fn.Fixed(np.array([2**63 + 5], dtype=np.uint64)), ["ids", "9223372036854775813"]),
        (
            lambda net: fn.Scene(net, [fn.Fixed(0)], [fn.AxialStiffness(1), fn.PointLoad([9], (0, 0, 0))]),
            ["ids[0] is 9"],
        ),
        (
            lambda net: fn.Scene(net, [fn.Fixed(0)], [fn.AxialStiffness(1)], [1.0, 1e-310]),
            ["member 1", "rest length"],
        ),
    ],
)
def test_errors_name_the_part_and_the_index(make, words):
    with pytest.raises(fn.InvalidInput) as caught:
        make(fn.Net(*NET))
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize(
    "options, word",
    [
        ({"accuracy": 0}, "accuracy"),
        ({"tolerance": -1}, "tolerance"),
        ({"tolerance": float("nan")}, "tolerance"),
        ({"method": "magic"}, "magic"),
        ({"max_seconds": -1}, "max_seconds"),
        ({"max_iterations": -5}, "max_iterations"),
        ({"start": np.zeros((3, 3))}, "start has 3 nodes"),
        ({"start": np.full((63, 3), np.nan)}, "start[0]"),
        ({"on_progress": 3}, "on_progress"),
        ({"accuracy": None}, "accuracy must be a number"),
        ({"accuracy": float("inf")}, "accuracy"),
        ({"tolerance": "fine"}, "tolerance must be a number"),
        ({"max_iterations": 1.5}, "max_iterations must be a whole number"),
        ({"max_iterations": 2**70}, "max_iterations"),
    ],
)
def test_solve_refuses_what_cannot_be_meant(options, word):
    with pytest.raises(fn.InvalidInput, match=None) as caught:
        fn.solve(roof(), **options)
    assert word in str(caught.value)


def test_limits_are_statuses():
    assert fn.solve(roof(), max_iterations=2).status == "iteration_limit"
    result = long_solve(max_seconds=0.2)
    assert result.status == "time_limit"
    assert "not an equilibrium" in result.message
    strand = fn.Net([[0, 0, 0], [0, 0, 10]], [[0, 1]])
    effects = [fn.AxialStiffness(10), fn.MemberWeight(2.5 / G)]
    assert fn.solve(fn.Scene(strand, [fn.Fixed(0)], effects)).status == "no_equilibrium"


def test_progress_is_told_and_cancels():
    reports = []
    result = fn.solve(roof(), on_progress=reports.append)
    assert result.status == "converged"
    assert [report.iteration for report in reports] == list(range(result.iterations + 1))
    assert reports[-1].position_error == result.position_error

    cancelled = fn.solve(roof(), on_progress=lambda report: report.iteration < 3)
    assert cancelled.status == "cancelled" and cancelled.iterations == 3
    assert np.isfinite(cancelled.nodes).all()
    assert long_solve(on_progress=lambda report: report.seconds < 0.1).status == "cancelled"


@pytest.mark.parametrize("answer, goes_on", [(0, False), ("", False), ([], False), (1, True), (None, True)])
def test_the_answer_to_progress_is_true_or_false_as_python_has_it(answer, goes_on):
    assert (fn.solve(roof(), on_progress=lambda report: answer).status == "converged") == goes_on


def test_an_exception_in_progress_comes_out_as_itself():
    def fail(report):
        raise KeyError("from the callback")

    with pytest.raises(KeyError, match="from the callback"):
        fn.solve(roof(), on_progress=fail)


def test_other_threads_run_during_a_solve():
    stop = threading.Event()
    turns = []

    def count():
        while not stop.is_set():
            turns.append(None)
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    try:
        before = len(turns)
        result = fn.solve(
            roof(step=0.25), method="relaxation", tolerance=1e-14, accuracy=1e-14, max_seconds=0.5
        )
        during = len(turns) - before
    finally:
        stop.set()
        counter.join()
    assert result.status == "time_limit"
    assert during > 10, "the solve held the interpreter"


def test_a_solve_is_cancelled_from_another_thread():
    wish = threading.Event()
    results = []

    def work():
        results.append(long_solve(on_progress=lambda report: not wish.is_set()))

    thread = threading.Thread(target=work)
    thread.start()
    time.sleep(0.1)
    assert thread.is_alive()
    wish.set()
    thread.join(timeout=30)
    assert results[0].status == "cancelled"


def test_two_threads_may_solve_the_same_scene():
    scene = roof(step=0.5)
    expected = fn.solve(scene).nodes
    results = []
    threads = [threading.Thread(target=lambda: results.append(fn.solve(scene).nodes)) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for nodes in results:
        np.testing.assert_array_equal(nodes, expected)


def test_a_warm_start_saves_iterations():
    scene = roof()
    cold = fn.solve(scene)
    warm = fn.solve(scene, start=cold.nodes)
    assert warm.iterations <= 1
    assert np.abs(warm.nodes - cold.nodes).max() < 1e-3


def test_solver_goes_on_and_takes_changed_scenes():
    light, heavy = roof(), roof(effects=[fn.MemberWeight(24.0), fn.CoveringWeight(60.0)])
    solver = fn.Solver(light)
    while not solver.advance(max_seconds=0.0):
        assert np.isfinite(solver.nodes).all()
    first = solver.result()
    assert first.status == "converged"
    np.testing.assert_array_equal(solver.nodes, first.nodes)
    with pytest.raises(ValueError, match="read-only"):
        solver.nodes[0] = 0
    solver.replace(heavy)
    np.testing.assert_allclose(solver.nodes, first.nodes, atol=1e-12)
    while not solver.advance(1.0):
        pass
    assert np.abs(solver.nodes - fn.solve(heavy).nodes).max() < 1e-3
    with pytest.raises(fn.InvalidInput, match="nodes"):
        solver.replace(roof(step=0.5))


def test_a_solver_serves_several_threads():
    solver, scenes = fn.Solver(roof()), [roof(effects=[fn.MemberWeight(12.0 + k)]) for k in range(30)]
    stop = threading.Event()
    torn = []

    def advance():
        while not stop.is_set():
            solver.advance(0.0)

    def read():
        while not stop.is_set():
            result = solver.result()
            spans = result.nodes[scenes[0].net.members[:, 1]] - result.nodes[scenes[0].net.members[:, 0]]
            if not np.allclose(result.member_lengths, np.linalg.norm(spans, axis=1)):
                torn.append(result)

    threads = [threading.Thread(target=work) for work in (advance, advance, read)]
    for thread in threads:
        thread.start()
    for scene in scenes:
        solver.replace(scene)
        assert np.isfinite(solver.nodes).all()
        time.sleep(0.002)
    stop.set()
    for thread in threads:
        thread.join()
    assert not torn


def test_length_matching_keeps_the_best():
    scene = roof()
    once = scene.match_lengths(fn.solve(scene))
    assert isinstance(once, fn.Scene)
    assert not np.allclose(once.rest_lengths, scene.rest_lengths)
    matching = fn.solve_matching_lengths(scene, rounds=6)
    assert matching.result.status == "converged"
    assert matching.deviations[matching.best_round] == min(matching.deviations) < matching.deviations[0]
    assert matching.scene.length_deviation(matching.result) == pytest.approx(min(matching.deviations))
    assert fn.certify(matching.scene, matching.result).compression_only
    assert matching.status == "converged"
    begun = []
    cut = fn.solve_matching_lengths(
        scene, rounds=6, on_progress=lambda report: begun.append(report.iteration) or begun.count(0) < 3
    )
    assert cut.status == "cancelled" and cut.result.status == "converged"
    with pytest.raises(fn.InvalidInput, match="rounds must be a whole number"):
        fn.solve_matching_lengths(scene, rounds=2.5)


def test_far_from_the_origin_the_shape_and_its_certificate_stay():
    def at(shift):
        flat = fn.Net.grid(8.0, 6.0, step=1.0)
        net = flat.lattice.net(flat.nodes + shift)
        effects = [fn.AxialStiffness(1e6), fn.MemberWeight(12.0), fn.CoveringWeight(30.0)]
        return fn.Scene(net, [fn.Fixed(flat.lattice.corners)], effects)

    shift = np.array([1e6, -2e6, 5e5])
    here, there = fn.solve(at(0.0), tolerance=1e-9), fn.solve(at(shift), tolerance=1e-9)
    np.testing.assert_allclose(there.nodes - shift, here.nodes, atol=2e-8)
    assert fn.certify(at(shift), there).compression_only
