# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs: errors told against errors measured, files, pictures, and how a study ends."""

import csv
import math

import numpy as np
import pytest

import funicular as fn
from funicular.accuracy import COLUMNS
from funicular.accuracy_picture import length_text, time_text


def sheet(ea=1e5, pattern="quad", held="border", covering=0.0, compression_only=True):
    net = fn.Net.grid(6, 5, 0.5, pattern=pattern)
    nodes = net.border if held == "border" else net.lattice.corners
    effects = [fn.AxialStiffness(ea, compression_only=compression_only), fn.MemberWeight(12.0)]
    if covering:
        effects.append(fn.CoveringWeight(covering))
    return fn.Scene(net, [fn.Fixed(nodes)], effects)


def dome(ea=1e8):
    lattice = fn.lattice(24, 8, closed_u=True, poles=["v_max"])
    turn, rise = 2 * np.pi * lattice.uv[:, 0], np.pi / 2 * lattice.uv[:, 1]
    nodes = 10 * np.column_stack([np.cos(rise) * np.cos(turn), np.cos(rise) * np.sin(turn), np.sin(rise)])
    net = lattice.net(nodes)
    return fn.Scene(
        net, [fn.Fixed(net.border)], [fn.AxialStiffness(ea), fn.MemberWeight(25.0), fn.CoveringWeight(50.0)]
    )


def chain():
    x = np.linspace(0, 10, 41)
    nodes = np.column_stack([x, 0 * x, 0 * x])
    members = np.column_stack([np.arange(40), np.arange(1, 41)])
    return fn.Scene(
        fn.Net(nodes, members), [fn.Fixed([0, 40])], [fn.AxialStiffness(1e4), fn.MemberWeight(10.0)]
    )


SCENES = {
    "soft sheet": lambda: sheet(3e4),
    "sheet": lambda: sheet(),
    "stiff sheet": lambda: sheet(1e7),
    "sheet on corners": lambda: sheet(held="corners"),
    "stiff sheet on corners": lambda: sheet(1e7, held="corners"),
    "covering": lambda: sheet(covering=30.0),
    "two-way": lambda: sheet(compression_only=False),
    "triangles": lambda: sheet(pattern="triangle", covering=30.0),
    "hexagons": lambda: sheet(pattern="hexagon", covering=30.0),
    "kagome": lambda: sheet(pattern="kagome"),
    "diagrid": lambda: sheet(pattern="diagrid", covering=10.0),
    "steel dome": dome,
    "soft dome": lambda: dome(1e6),
    "chain": chain,
}


@pytest.mark.parametrize("name", SCENES)
def test_what_is_told_is_never_half_of_what_is_true(name):
    scene = SCENES[name]()
    study = fn.accuracy_study(scene, methods=("auto", "newton"), coarser=0)
    assert len(study.rows) == 10 and not study.cancelled
    rounding = 1e-11 * scene.net.size
    for row in study.rows:
        assert row["status"] == "converged"
        assert row["estimated_error"] <= row["accuracy"]
        assert row["true_error"] <= 2 * row["estimated_error"] + rounding, row
        assert row["true_error"] <= row["accuracy"]


def test_tighter_is_never_less_accurate_and_every_method_arrives():
    study = fn.accuracy_study(sheet(), accuracies=(1e-4, 1e-2, 1e-3), coarser=0)
    for method in ("auto", "newton", "relaxation"):
        rows = [row for row in study.rows if row["method"] == method]
        assert [row["accuracy"] for row in rows] == [1e-2, 1e-3, 1e-4]
        errors = [row["true_error"] for row in rows]
        assert errors == sorted(errors, reverse=True)
        assert [row["iterations"] for row in rows] == sorted(row["iterations"] for row in rows)
        assert all(row["status"] == "converged" for row in rows), rows
    assert {row["compression_only"] for row in study.rows} <= {True, False}


def test_it_can_be_ended_and_keeps_what_it_has():
    seen = []

    def on_progress(row):
        seen.append(row)
        return len(seen) < 3

    study = fn.accuracy_study(sheet(), on_progress=on_progress)
    assert study.cancelled and study.rows == seen and len(seen) == 3


@pytest.mark.parametrize("end_within, rows", [(None, 0), ("auto", 0), ("relaxation", 2)])
def test_it_can_be_ended_within_a_solve(end_within, rows):
    def on_report(method, accuracy, report):
        assert (method is None) == (accuracy is None) and report.seconds >= 0.0
        return method != end_within

    study = fn.accuracy_study(sheet(), (1e-2, 1e-6), ("auto", "relaxation"), on_report=on_report)
    assert study.cancelled and len(study.rows) == rows
    assert all(row["status"] == "converged" for row in study.rows)


def test_a_limit_of_time_is_told_and_the_method_not_asked_for_more():
    study = fn.accuracy_study(sheet(), methods=("relaxation", "auto"), max_seconds=0.0, coarser=0)
    assert [row["status"] for row in study.rows if row["method"] == "relaxation"] == ["time_limit"]


def test_coarser_nets_are_studied_as_well_and_the_error_of_each_is_told():
    net = fn.Net.grid(8, 6, 0.25)
    scene = fn.Scene(net, [fn.Fixed(net.border)], [fn.AxialStiffness(1e6), fn.CoveringWeight(40.0)])
    study = fn.accuracy_study(scene, accuracies=(1e-2, 1e-4), methods=("auto",))
    steps = [row["step"] for row in study.rows]
    assert steps == pytest.approx([0.25, 0.25, 0.5, 0.5, 1.0, 1.0])
    assert study.rows_of_own_step() == study.rows[:2]
    errors = [row["net_error"] for row in study.rows[::2]]
    assert errors[0] == study.of_net.distance and errors == sorted(errors)
    for row in study.rows:
        assert row["true_error"] <= 2 * row["estimated_error"] + 1e-10, "each against its own net"
    triangles = fn.accuracy_study(sheet(pattern="triangle"), accuracies=(1e-2,), methods=("auto",))
    assert [row["net_error"] for row in triangles.rows] == [None] and triangles.of_net is None


def test_the_file_holds_the_rows(tmp_path):
    study = fn.accuracy_study(chain(), accuracies=(1e-3, 1e-6), methods=("auto",))
    study.write(tmp_path / "study.csv")
    with open(tmp_path / "study.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0]) == list(COLUMNS) and len(rows) == 2
    assert [float(row["true_error"]) for row in rows] == [row["true_error"] for row in study.rows]


def test_the_picture_has_a_curve_for_each_method(tmp_path):
    study = fn.accuracy_study(sheet(), accuracies=(1e-2, 1e-3, 1e-4))
    study.plot(tmp_path / "study.svg", chosen=1e-3)
    drawn = (tmp_path / "study.svg").read_text(encoding="utf-8")
    study.plot(tmp_path / "study.png", chosen=1e-3)
    assert (tmp_path / "study.png").stat().st_size > 20_000
    for colour in ("#1f5fa8", "#2e8b57", "#c0562f"):
        assert drawn.count(colour) >= 4, "two lines with their marks"


@pytest.mark.parametrize("accuracies", [(0.0,), (1e-3, -1e-3), (math.inf,), (math.nan,)])
def test_accuracies_that_cannot_be_meant_are_refused(accuracies):
    with pytest.raises(fn.InvalidInput, match="accuracies holds"):
        fn.accuracy_study(chain(), accuracies=accuracies)


@pytest.mark.parametrize("wrong", [{"accuracies": 1e-3}, {"methods": "auto"}, {"accuracies": "1 mm"}])
def test_what_is_no_list_is_refused(wrong):
    with pytest.raises(fn.InvalidInput, match="accuracies and methods are lists"):
        fn.accuracy_study(chain(), **wrong)


def test_without_an_equilibrium_there_is_nothing_to_measure():
    with pytest.raises(fn.InvalidInput, match="nothing to measure against"):
        fn.accuracy_study(sheet(1.0))


def test_lengths_and_times_as_they_are_read():
    assert [length_text(x) for x in (2.0, 1e-2, 1e-3, 2.5e-5, 3e-9)] == [
        "2 m",
        "1 cm",
        "1 mm",
        "25 µm",
        "3 nm",
    ]
    assert [time_text(x) for x in (12.0, 0.035, 4e-4)] == ["12 s", "35 ms", "0.4 ms"]
