# SPDX-License-Identifier: LGPL-2.1-or-later
"""What effects cost, what the shape is without each, and which of them a scene does not call for."""

import csv

import numpy as np
import pytest

import funicular as fn
from funicular.effect_costs import COLUMNS


def sheet(*effects, ea=1e5, pattern="quad"):
    net = fn.Net.grid(6, 5, 0.5, pattern=pattern)
    return fn.Scene(net, [fn.Fixed(net.border)], [fn.AxialStiffness(ea), *effects])


def test_each_effect_has_a_row_and_the_shape_without_it_is_measured():
    scene = sheet(fn.MemberWeight(12.0), fn.Snow(800.0), fn.PointLoad([40], (0, 0, -1.0)))
    seen = []
    study = fn.effect_study(scene, on_progress=seen.append)
    rows = {row["effect"]: row for row in study.rows}
    assert list(rows) == ["axial", "member_weight", "point_load", "snow"] and seen == study.rows
    for row in study.rows:
        assert list(row) == list(COLUMNS)
        assert row["evaluations"] > 0 and row["bytes"] > 0 and 0 <= row["share"] <= 1
    assert rows["axial"]["moved"] is None and not rows["axial"]["sentence"]
    bare = sheet(fn.MemberWeight(12.0), fn.PointLoad([40], (0, 0, -1.0)))
    shapes = [fn.solve(each, accuracy=1e-9, tolerance=1e-8).nodes for each in (scene, bare)]
    true = np.linalg.norm(shapes[0] - shapes[1], axis=1).max()
    assert abs(rows["snow"]["moved"] - true) < 2e-3
    assert rows["snow"]["sentence"].startswith("without snow: ")


def test_only_what_moves_the_shape_by_less_than_the_accuracy_is_said_to_be_dispensable():
    scene = sheet(fn.MemberWeight(12.0), fn.PointLoad([40], (0, 0, -0.5)), ea=1e6)
    assert [row["dispensable"] for row in fn.effect_study(scene, accuracy=1e-2).rows] == [False, False, True]
    (suggestion,) = fn.effect_study(scene, accuracy=1e-2).suggestions()
    assert "without point loads" in suggestion and "it may be left out" in suggestion
    assert "less than the accuracy of 1 cm" in suggestion
    assert fn.effect_study(scene, accuracy=1e-6).suggestions() == []
    assert len(scene.effects) == 3, "nothing is ever left out by itself"


def test_the_last_load_and_what_stands_by_its_load_alone_are_told():
    study = fn.effect_study(sheet(fn.CoveringWeight(30.0)))
    assert study.rows[1]["sentence"] == "the covering: all the load there is"
    assert study.rows[1]["moved"] is None and not study.rows[1]["dispensable"]


def test_memory_is_counted_and_absent_effects_have_none():
    quads = sheet(fn.MemberWeight(12.0), fn.CoveringWeight(30.0)).effect_memory()
    assert set(quads) == {"axial", "member_weight", "covering_weight"}
    net = sheet(fn.MemberWeight(12.0)).net
    # The diagonals of quads are coupled by the covering alone: two a panel, there and back.
    blocks = 4 * len(net.panels) * (9 * 8 + 4)
    assert 0 <= quads["covering_weight"] - blocks < 200
    assert quads["axial"] >= 16 * len(net.members)
    triangles = sheet(fn.MemberWeight(12.0), fn.CoveringWeight(30.0), pattern="triangle").effect_memory()
    assert triangles["covering_weight"] < 200, "its couplings are those of the members"


def test_files_tables_and_how_a_study_ends(tmp_path):
    scene = sheet(fn.MemberWeight(12.0), fn.Snow(800.0))
    study = fn.effect_study(scene, on_progress=lambda row: row["effect"] != "member_weight")
    assert study.cancelled and [row["effect"] for row in study.rows] == ["axial", "member_weight"]
    study.write(tmp_path / "effects.csv")
    with open(tmp_path / "effects.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["effect"] for row in rows] == ["axial", "member_weight"]
    assert str(study).count("\n") == 2 and "without the members' weight" in str(study)
    with pytest.raises(fn.InvalidInput, match="no shape to measure against"):
        fn.effect_study(sheet(fn.MemberWeight(12.0), ea=1.0))


def test_what_may_go_alone_need_not_go_together():
    scene = sheet(fn.CoveringWeight(30.0), fn.Snow(3.0), fn.MemberWeight(0.1))
    moved = {row["effect"]: row["moved"] for row in fn.effect_study(scene).rows}
    accuracy = 1.05 * max(moved["snow"], moved["member_weight"])
    assert moved["snow"] + moved["member_weight"] > accuracy
    suggestions = fn.effect_study(scene, accuracy).suggestions()
    assert len(suggestions) == 3 and suggestions[-1].startswith("together these may move it by")
