# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solve that is watched and changed as it goes, and the pace at which it is shown."""

import threading
import time

import numpy as np
import pytest

import funicular as fn
from funicular.form import form_of_moment, numbers_of
from funicular.live import LiveSolve
from funicular.pace import ARRIVES, Pace

NET = fn.Net.grid(6.0, 4.0, step=0.5)


def scene(covering=30.0, net=NET, stiffness=1e5):
    return fn.Scene(
        net,
        [fn.Fixed(net.border)],
        [fn.AxialStiffness(stiffness), fn.MemberWeight(12.0), fn.CoveringWeight(covering)],
    )


@pytest.fixture
def live():
    made = []

    def begin(*args, **options):
        made.append(LiveSolve(*args, **options))
        return made[-1]

    yield begin
    for each in made:
        each.stop(wait=True)


def wait(condition, live):
    """A safety net against hanging; nothing passes or fails by being slow."""
    end = time.monotonic() + 60.0
    while not condition() and time.monotonic() < end:
        time.sleep(0.002)
    assert condition(), live.latest


def at_rest(live):
    wait(lambda: not live.is_running and live.latest is not None, live)
    return live.latest


def test_it_ends_where_a_plain_solve_ends(live):
    moment = at_rest(live(scene(), accuracy=1e-6))
    assert moment.ended and moment.result.status == "converged" and moment.certificate.compression_only
    assert moment.result.nodes == pytest.approx(fn.solve(scene(), accuracy=1e-6).nodes, abs=2e-6)
    assert 1.0 < moment.covered < 1.2, "it has risen"


def test_its_thread_ends_with_it(live):
    before = threading.active_count()
    at_rest(live(scene()))
    assert threading.active_count() == before


def test_a_change_goes_on_from_the_present_shape(live):
    solve = live(scene())
    steps = at_rest(solve).result.iterations
    solve.change(scene(31.0))
    wait(lambda: solve.latest.scene is not None and not solve.is_running, solve)
    moment = at_rest(solve)
    assert moment.result.nodes == pytest.approx(fn.solve(scene(31.0), accuracy=1e-6).nodes, abs=2e-3)
    assert moment.result.iterations < steps, "a small change takes less than the whole"


def test_the_latest_of_many_changes_is_what_comes(live):
    solve = live(scene())
    for weight in np.linspace(30.0, 90.0, 40):
        solve.change(scene(weight))
    assert at_rest(solve).result.nodes == pytest.approx(fn.solve(scene(90.0)).nodes, abs=2e-3)


def test_a_net_of_other_numbers_begins_as_it_was_laid(live):
    solve = live(scene())
    at_rest(solve)
    other = fn.Net.grid(6.0, 4.0, step=0.4)
    solve.change(scene(net=other))
    wait(lambda: len(solve.latest.result.nodes) == len(other.nodes), solve)
    assert at_rest(solve).result.nodes == pytest.approx(fn.solve(scene(net=other)).nodes, abs=2e-3)


def test_a_net_of_as_many_nodes_in_other_rows_begins_as_it_was_laid(live):
    across, along = (
        lattice.net(np.column_stack([lattice.uv * (6.0, 4.0), 0.0 * lattice.uv[:, 0]]))
        for lattice in (fn.lattice(12, 8), fn.lattice(8, 12))
    )
    solve = live(scene(net=across))
    at_rest(solve)
    solve.pause()
    solve.change(scene(net=along))
    wait(lambda: solve.latest.scene.net is along, solve)
    assert solve.latest.result.nodes == pytest.approx(along.nodes)
    wider = along.lattice.net(along.nodes * (1.5, 1.0, 1.0))
    solve.change(scene(net=wider))
    wait(lambda: solve.latest.scene.net is wider, solve)
    solve.resume()
    at_rest(solve)
    solve.change(scene(net=along))
    wait(lambda: solve.latest.scene.net is along, solve)
    assert solve.latest.result.nodes[:, 2].max() > 0.1, "what is only wider goes on"


def test_paused_it_goes_step_by_step_and_resumed_to_its_end(live):
    solve = live(scene())
    solve.pause()
    at_rest(solve)
    solve.restart()
    wait(lambda: not solve.is_running, solve)
    begun = solve.latest.result.iterations
    counts = []
    for _ in range(3):
        solve.step()
        wait(lambda: not solve.is_running, solve)
        counts.append(solve.latest.result.iterations)
    assert counts == sorted(set(counts)) and counts[0] > begun and not solve.latest.ended
    assert solve.is_paused
    solve.resume()
    wait(lambda: solve.latest.ended, solve)
    assert not solve.is_paused


def test_a_change_while_paused_waits(live):
    solve = live(scene())
    at_rest(solve)
    solve.pause()
    solve.change(scene(60.0))
    wait(lambda: not solve.is_running, solve)
    assert not solve.latest.ended
    solve.resume()
    wait(lambda: solve.latest.ended, solve)
    assert at_rest(solve).result.nodes == pytest.approx(fn.solve(scene(60.0)).nodes, abs=2e-3)


def test_the_relaxation_can_be_watched_and_comes_to_the_same(live):
    solve = live(scene(), 1e-3, "relaxation", watched=True)
    moment = at_rest(solve)
    assert moment.result.nodes == pytest.approx(fn.solve(scene(), accuracy=1e-6).nodes, abs=2e-3)
    looks = solve.chart
    assert len(looks) > 30, "it is seen on its way"
    assert looks[-1][1] < looks[len(looks) // 2][1] and looks[-1][2] < 1e-3


def test_stopped_it_ends_within_an_iteration(live):
    solve = live(scene(), 1e-12, "relaxation")
    solve.stop(wait=True)
    assert not solve.is_running


def test_what_cannot_be_solved_is_told_and_no_crash(live):
    solve = live(scene(stiffness=10.0))
    moment = at_rest(solve)
    assert moment.ended and moment.result.status == "no_equilibrium"
    solve.change(scene())
    wait(lambda: solve.latest.result.status == "converged", solve)
    wrong = live(scene(), method="guess")
    assert "method" in at_rest(wrong).error and wrong.latest.result is None


def test_a_form_bears_its_loads(live):
    form = form_of_moment(at_rest(live(scene(), accuracy=1e-9)))
    down = form.loads()[:, 2]
    assert down.sum() == pytest.approx(
        fn.certify(scene(), fn.solve(scene(), accuracy=1e-9)).total_load[2], rel=1e-6
    )
    numbers = numbers_of(form)
    assert numbers["weight"] == pytest.approx(-down.sum()) and numbers["most_tension"] == 0.0
    assert numbers["rise"] == pytest.approx(form.nodes[:, 2].max(), abs=1e-9)
    assert numbers["mean_deviation"] < numbers["most_deviation"]


def test_an_even_pace():
    """Equal parts of the way in equal times, however fast the solver was there; no overshoot."""
    pace = Pace(np.array([[0.0, 0, 0], [1, 0, 0]]), 0.0)
    target = np.array([[0.0, 0, 1.0], [1, 0, 1.0]])
    heights, now = [], 0.0
    while True:
        now += 1.000001 * ARRIVES / 8
        arrived = pace.toward(target, now, ended=True)
        heights.append(pace.nodes[0, 2])
        if arrived:
            break
    assert np.diff([0.0, *heights]) == pytest.approx(np.full(8, 1 / 8), rel=1e-4)
    assert (pace.nodes == target).all()


def test_what_comes_late_is_followed_without_overshoot():
    pace = Pace(np.array([[0.0, 0, 0], [1, 0, 0]]), 0.0)
    target = np.array([[0.0, 0, 1.0], [1, 0, 1.0]])
    assert not pace.toward(target, 5 * ARRIVES, ended=False)
    heights = []
    for step in range(1, 40):
        arrived = pace.toward(target, 5 * ARRIVES + 0.05 * step, ended=True)
        heights.append(pace.nodes[0, 2])
    assert arrived and heights == sorted(heights) and heights[-1] == 1.0
