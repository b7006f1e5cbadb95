# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point loads: which nodes they find, what they do to form and reactions, and that none costs nothing."""

import FreeCAD as App
import numpy as np
import pytest

import funicular as fn
from documents import array, assert_refused, recompute, reopened
from funicular.features.gridshell import scene_of
from funicular.features.variants import keep_variant, restore_variant
from funicular.make import make_gridshell, make_point_load

V = App.Vector
MIDDLE = (0.5, 0.5)


@pytest.fixture
def shell(doc, box):
    """On the top of the box, 8 m x 6 m, in steps of 1 m; node 31 is in the middle."""
    made = make_gridshell(doc, source=(box, ["Face6"]), SupportRecipe="Corners")
    assert recompute(doc) == {}
    return made


def vertical_load(shell):
    """[N] of all reactions, upwards."""
    return array(shell.Reactions)[:, 2].sum()


def test_a_load_reaches_the_ground_and_what_bears_it(doc, shell):
    load, more = make_point_load(doc, shell, Points=[MIDDLE]), []
    for force in ("0 N", "1 kN", "2 kN"):
        load.Force = force
        assert recompute(doc) == {}
        assert load.LoadedNodes == [31] and load.Where == "Points"
        total = shell.TotalWeight.getValueAs("N").Value
        assert vertical_load(shell) == pytest.approx(total, rel=1e-5)
        # Of this form all other loads, which follow its shape, and which the certificate counts by itself.
        scene = scene_of(shell)
        others = [each for each in scene.effects if not isinstance(each, fn.PointLoad)]
        result = fn.solve(scene, start=array(shell.NodePositions) / 1e3, accuracy=1e-6)
        weights = -fn.certify(fn.Scene(scene.net, scene.supports, others), result).total_load[2]
        assert total - weights == pytest.approx(load.Force.getValueAs("N").Value, abs=1e-3 * total)
        more.append(float(array(shell.NodePositions)[31, 2]))
    assert more[0] + 50 < more[1] < more[2] - 50, "the hanging model is pulled out there, so that it rises"


def test_without_loads_the_scene_has_none(doc, shell):
    assert shell.PointLoads == []
    assert [type(each).__name__ for each in scene_of(shell).effects] == [
        "AxialStiffness",
        "MemberWeight",
        "CoveringWeight",
    ]
    before = array(shell.NodePositions)
    load = make_point_load(doc, shell, Points=[MIDDLE], Force=0)
    assert recompute(doc) == {}
    assert not any(isinstance(each, fn.PointLoad) for each in scene_of(shell).effects)
    assert "point_load" not in fn.solve(scene_of(shell)).costs
    assert np.array_equal(array(shell.NodePositions), before)
    load.Force = "1 N"
    assert fn.solve(scene_of(shell)).costs["point_load"][0] > 0


def test_a_load_keeps_its_place_edge_and_direction(doc, box, shell):
    aside = make_point_load(doc, shell, Points=[(0.25, 0.5)], Force="300 N", Direction=(0, 5, 0))
    along = make_point_load(doc, shell, Elements=[shell.Net.SourceElements[0]], Force="50 N")
    for step in ("1 m", "500 mm"):
        shell.Net.StepU = shell.Net.StepV = step
        assert recompute(doc) == {}
        (node,) = aside.LoadedNodes
        assert shell.Net.SourceNodes[node].isEqual(V(2000, 3000, 3000), 1e-6)
        loads = [each for each in scene_of(shell).effects if isinstance(each, fn.PointLoad)]
        assert [each.ids.tolist() for each in loads] == [[node], along.LoadedNodes]
        assert np.allclose(loads[0].force, (0, 300, 0)) and np.allclose(loads[1].force, (0, 0, -50))
    assert array(shell.Reactions)[:, 1].sum() == pytest.approx(-300, rel=1e-4)


def test_a_load_alone_is_a_load(doc, shell):
    shell.MemberWeight, shell.CoveringWeight = "0 kg/m", "0 kg/m^2"
    recompute(doc)
    assert_refused(shell, "all zero", "or a PointLoad")
    places = array(shell.Net.SourceNodes)
    is_corner = np.isin(places[:, 0], (0, 8000)) & np.isin(places[:, 1], (0, 6000))
    nodes = np.flatnonzero(~is_corner).tolist()
    make_point_load(doc, shell, Nodes=nodes, Force="500 N")
    assert recompute(doc) == {}
    assert vertical_load(shell) == pytest.approx(500 * len(nodes), rel=1e-4)


@pytest.mark.parametrize(
    "properties, sentences",
    [
        ({}, ["no node is found by Points"]),
        ({"Nodes": [3, 63]}, ["Nodes holds 63, but the net has nodes 0 to 62"]),
        (
            {"Points": [MIDDLE], "Direction": (0, 0, 0)},
            ["Direction is (0.0, 0.0, 0.0)", "(0, 0, -1) for down"],
        ),
    ],
)
def test_bad_input_is_named(doc, shell, properties, sentences):
    load = make_point_load(doc, shell, **properties)
    recompute(doc)
    assert_refused(load, *sentences)
    assert shell.Status == "failed" and shell.Summary.startswith("PointLoad: ")


def test_a_force_below_zero_and_loads_of_others_are_refused(doc, box, shell):
    with pytest.raises(ValueError, match="Force = '-2 kN' does not do: give zero or more"):
        make_point_load(doc, shell, Points=[MIDDLE], Force="-2 kN")
    with pytest.raises(ValueError, match="gridshell is 'Box', which is no Gridshell"):
        make_point_load(doc, box)
    assert shell.PointLoads == []
    load = make_point_load(doc, shell, Points=[MIDDLE])
    load.Force = "-2 kN"
    recompute(doc)
    assert_refused(load, "Force is -2000 N: give zero or more")
    load.Force, load.Net = "2 kN", None
    recompute(doc)
    assert_refused(load, "Net is empty")
    other = make_gridshell(doc, source=(box, ["Face5"]), SupportRecipe="Corners")
    load.Net = other.Net
    recompute(doc)
    assert_refused(shell, "PointLoads holds PointLoad, which is no point load on the net Net")


def test_a_load_is_undone_kept_restored_and_saved(doc, shell, tmp_path):
    doc.UndoMode = 1
    keep_variant(shell, "Bare")
    load = make_point_load(doc, shell, Points=[MIDDLE], Force="3 kN", Direction=(0, 1, -2))
    assert doc.UndoNames[0] == "Make point load"
    assert recompute(doc) == {}
    loaded = array(shell.NodePositions)
    keep_variant(shell, "Loaded")
    assert restore_variant(shell, "Bare") == [] and shell.PointLoads == [] and load not in doc.Objects
    assert restore_variant(shell, "Loaded") == []
    assert recompute(doc) == {}
    assert array(shell.NodePositions) == pytest.approx(loaded, abs=1e-6)
    again = reopened(doc, tmp_path / "loads.FCStd")
    (load,) = again.Gridshell.PointLoads
    assert load.Direction == V(0, 1, -2) and load.Force.getValueAs("kN").Value == pytest.approx(3)
    load.Force = "1 kN"
    assert recompute(again) == {}
    assert array(again.Gridshell.NodePositions) != pytest.approx(loaded, abs=1e-3)
