# SPDX-License-Identifier: LGPL-2.1-or-later
"""A price tag before the solve: what it says, what it is kept by, and what it is corrected by.

How near it comes to the times of a machine is for bench/prediction.py to tell: a test does not time.
"""

import json
import subprocess
import sys

import numpy as np
import pytest

import funicular as fn
from funicular import prediction, prediction_cache
from test_net_error import vault


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    """A cache of a machine that is as fast as the one the exponents were fitted on."""
    monkeypatch.setenv("FUNICULAR_CACHE", str(tmp_path / "cache"))
    prediction_cache.forget()
    prediction_cache.keep({prediction.LATTICE: 1.0, prediction.FACTORISED: 1.0})
    yield tmp_path / "cache" / "prediction.json"
    prediction_cache.forget()


def sheet(step, pattern="quad", ea=1e5, size=12.0):
    net = fn.Net.grid(size, size, step, pattern=pattern)
    return fn.Scene(net, [fn.Fixed(net.border)], [fn.AxialStiffness(ea), fn.MemberWeight(12.0)])


@pytest.mark.parametrize("pattern, path", [("quad", "lattice"), ("triangle", "factorised")])
def test_larger_nets_cost_more(pattern, path):
    prices = [fn.predict(sheet(step, pattern)) for step in (0.6, 0.3, 0.15)]
    assert [price.way[0] for price in prices] == [path] * 3
    for coarse, fine in zip(prices, prices[1:]):
        assert coarse.memory < fine.memory
        assert coarse.of_step(0.5).memory == pytest.approx(fine.memory, rel=0.1)
        if path == "factorised":
            # On a lattice the time of a coarser net is measured, which is no thing to test.
            assert coarse.seconds < fine.seconds
            assert fine.seconds / 3.0 < coarse.of_step(0.5).seconds < 3.0 * fine.seconds
    assert str(prices[0]).startswith("about ") and str(prices[0]).endswith(" MB")


@pytest.fixture
def still_clock(monkeypatch):
    """The first steps of each solve take the same time, as on a machine that is never disturbed."""
    first_steps = prediction._first_steps

    def timed(scene, accuracy):
        steps, _, residual = first_steps(scene, accuracy)
        return steps, 1e-6 * steps * len(scene.net.members), residual

    monkeypatch.setattr(prediction, "_first_steps", timed)


def test_more_digits_never_cost_less_by_much(still_clock):
    scene = sheet(0.3, "triangle")
    seconds = [fn.predict(scene, accuracy).seconds for accuracy in (1e-2, 1e-4, 1e-6)]
    # The fit is to within a factor of two, and digits are what it depends on least.
    assert all(more > 0.8 * fewer for fewer, more in zip(seconds, seconds[1:]))


def test_memory_is_what_a_solve_then_takes():
    script = (
        "import re, sys; sys.path.insert(0, {path!r}); import funicular as fn\n"
        "net = fn.Net.grid(20, 20, {step}, pattern={pattern!r})\n"
        "scene = fn.Scene(net, [fn.Fixed(net.border)], [fn.AxialStiffness({ea}), fn.MemberWeight(12.0)])\n"
        # Unlike getrusage, which knows of the process that started this one.
        "peak = lambda: int(re.search(r'VmHWM:\\s+(\\d+)', open('/proc/self/status').read())[1])\n"
        "before = peak(); fn.solve(scene); print(1024 * (peak() - before))"
    )
    # The stiff lattice of less than 5000 nodes is factorised.
    for step, pattern, ea in ((0.12, "quad", 1e5), (0.35, "quad", 1e8), (0.25, "triangle", 1e5)):
        path = next(each for each in sys.path if each.endswith("freecad_wb"))
        code = script.format(path=path, step=step, pattern=pattern, ea=ea)
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
        taken = int(run.stdout)
        net = fn.Net.grid(20, 20, step, pattern=pattern)
        scene = fn.Scene(net, [fn.Fixed(net.border)], [fn.AxialStiffness(ea), fn.MemberWeight(12.0)])
        assert 0.5 * taken < fn.predict(scene).memory < 2.0 * taken


def test_the_machine_is_measured_once_and_remembered(cache):
    prediction_cache.forget()
    seen = []
    assert not prediction_cache.is_calibrated()
    fn.calibrate(on_progress=lambda done, of: seen.append((done, of)))
    assert seen[-1][0] == seen[-1][1] == len(seen)
    kept = json.loads(cache.read_text())["factors"]
    assert set(kept) == {"lattice", "factorised"} and all(value > 0 for value in kept.values())
    prediction_cache._factors.clear()
    assert prediction_cache.is_calibrated() and prediction_cache.factor("lattice") == kept["lattice"]
    fn.calibrate(on_progress=lambda done, of: False)
    assert json.loads(cache.read_text())["factors"] == kept, "what was ended keeps nothing"


@pytest.mark.parametrize(
    "content",
    ["", "{", "[]", '{"version": 1}', '{"version": 1, "machine": "x", "factors": {"lattice": "fast"}}'],
)
def test_a_cache_that_says_nothing_is_made_anew(cache, content):
    prediction_cache._factors.clear()
    cache.write_text(content)
    assert not prediction_cache.is_calibrated()


def test_one_of_another_machine_and_one_that_cannot_be_written_are_no_error(cache, monkeypatch, tmp_path):
    assert "core " in json.loads(cache.read_text())["machine"]
    content = json.loads(cache.read_text()) | {"machine": "another"}
    cache.write_text(json.dumps(content))
    prediction_cache._factors.clear()
    assert not prediction_cache.is_calibrated()
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("FUNICULAR_CACHE", str(tmp_path / "file" / "below"))
    prediction_cache.keep({"lattice": 2.0, "factorised": 1.0})
    assert prediction_cache.factor("lattice") == 2.0


def test_what_solves_really_take_corrects_what_is_told(cache, still_clock):
    scene = sheet(0.6, "triangle")
    price = fn.predict(scene)
    for _ in range(30):
        fn.predict(scene).observe(4.0 * price.seconds)
    assert fn.predict(scene).seconds == pytest.approx(4.0 * price.seconds, rel=0.01)
    before = fn.predict(scene)
    before.observe(1e6)
    assert fn.predict(scene).seconds < 1.3 * before.seconds, "a disturbed solve counts for little"
    before.observe(float("nan"))
    assert np.isfinite(fn.predict(scene).seconds)
    assert json.loads(cache.read_text())["factors"]["factorised"] > 3.0


@pytest.mark.parametrize("accuracy", [0.0, -1.0, float("nan"), float("inf"), "1 mm", None])
def test_accuracies_that_cannot_be_meant_are_refused(accuracy):
    with pytest.raises(fn.InvalidInput, match="accuracy is .*: give a length in metres"):
        fn.predict(sheet(1.0), accuracy)
    with pytest.raises(fn.InvalidInput, match="overall is .*: give a length in metres"):
        fn.cheapest(sheet(1.0), accuracy)


@pytest.mark.parametrize("overall", [1e-2, 1e-3, 1e-4])
def test_the_step_that_is_told_brings_the_net_as_near_as_it_says(overall):
    rise = 2.979343367
    settings = fn.cheapest(vault(64, 10, 12, 1000, 1), overall)
    # Of an even number, so that a node stands at the apex.
    cells = 2 * round(5 / settings.step)
    found = fn.solve(vault(cells, 10, 12, 1000, 1), accuracy=settings.accuracy, tolerance=1e-3)
    error = abs(found.nodes[:, 2].max() - rise)
    assert 0.3 * overall < error <= overall, "near enough, and not much nearer than was asked for"
    assert settings.net_error + settings.accuracy <= overall * (1 + 1e-9)
    assert "overall: step " in str(settings)


def test_a_surface_keeps_its_stiffness_and_weight_by_width():
    def sheet_of(step, lines=1.0):
        net = fn.Net.grid(16, 16, step)
        effects = [fn.AxialStiffness(2.5e5 * lines), fn.MemberWeight(20.0 * lines), fn.CoveringWeight(40.0)]
        return fn.Scene(net, [fn.Fixed(net.border)], effects)

    settings = fn.cheapest(sheet_of(0.25), 2e-2)
    assert settings.lines == pytest.approx(settings.step / 0.25) and "EA and weight" in str(settings)
    step = 16 / np.ceil(16 / settings.step)
    shapes = [fn.solve(sheet_of(h, h / 0.25), accuracy=1e-6, tolerance=1e-6).nodes for h in (step, 0.125)]
    rises = [shape[:, 2].max() for shape in shapes]
    assert abs(rises[0] - rises[1]) < 2e-2
    unscaled = fn.solve(sheet_of(step), accuracy=1e-6, tolerance=1e-6).nodes[:, 2].max()
    assert abs(unscaled - rises[1]) > 5e-2


def test_what_has_no_step_to_tell_says_why():
    with pytest.raises(fn.InvalidInput, match="no lattice of quads or ribs"):
        fn.cheapest(sheet(0.5, "triangle"), 1e-2)
    with pytest.raises(fn.InvalidInput, match="too few cells to be halved three times"):
        fn.cheapest(sheet(2.0), 1e-2)
    with pytest.raises(fn.InvalidInput, match="takes a step of less than .*: give a finer net"):
        fn.cheapest(vault(64, 10, 12, 1000, 1), 1e-9)
    assert (
        fn.cheapest(vault(64, 10, 12, 1000, 1), 100.0).step <= 8.001 * 10 / 64
    ), "no wider than was looked at"


def test_no_home_is_no_error(monkeypatch):
    monkeypatch.delenv("FUNICULAR_CACHE")
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setenv("HOME", "/nowhere/at/all")
    prediction_cache.keep({"lattice": 2.0, "factorised": 1.0})
    assert prediction_cache.factor("lattice") == 2.0
