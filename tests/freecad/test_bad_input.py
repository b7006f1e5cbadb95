# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input to a Gridshell: a sentence that says what and what to do, and nothing that was good is lost."""

import numpy as np
import pytest

import funicular as fn
from documents import array, assert_refused, edge_ends, recompute, reopened
from funicular.features.net import edges_of
from funicular.make import make_gridshell

# property, value, what the sentence must say
REFUSED = [
    ("MemberWeight", "-12 kg/m", "MemberWeight is -12 kg/m: give zero or more"),
    ("CoveringWeight", "-30 kg/m^2", "CoveringWeight is -30 kg/m²: give zero or more"),
    ("Snow", "-1 kPa", "Snow is -1000 N/m²: give zero or more"),
    ("AxialStiffness", "-1 kN", "AxialStiffness is -1000 N: give zero or more"),
    ("AxialStiffness", "0 N", "AxialStiffness is 0 N: give a force greater than zero"),
    ("CoveringWeight", "nan", "CoveringWeight is nan kg/m²: give zero or more"),
    ("Accuracy", "0 mm", "Accuracy is 0 mm: give a length greater than zero, such as 1 mm"),
    ("MaxSeconds", -1.0, "MaxSeconds is -1 s: give zero or more"),
    ("LengthMatching", -1, "LengthMatching is -1 rounds: give 0 (none) or more"),
    ("SupportRecipe", "None", "SupportRecipe is None, and a shell without supports falls: choose Boundary, "),
    ("SupportRecipe", "Corners", "SupportRecipe: recipe 'corners': the net has no corners"),
    ("SupportRecipe", "Corners and border planes", "choose 'boundary' instead"),
    ("Net", None, "Net is empty (none was given, or it was deleted): set it to a Net of this document"),
    ("CoveringWeight", "3000000 kg/m^2", "Properties to change: AxialStiffness, the weights."),
    ("MaxSeconds", 1e-9, "Properties to change: MaxSeconds, Accuracy."),
]

# What the solver itself ended with, where it was reached.
STATUS_OF_SOLVER = {"3000000 kg/m^2": "no_equilibrium", 1e-9: "time_limit"}


@pytest.fixture
def shell(doc, dome):
    made = make_gridshell(doc, source=dome, StepU="3 m", StepV="2 m")
    assert recompute(doc) == {}
    return made


@pytest.mark.parametrize("name, value, sentence", REFUSED)
def test_refused_with_the_last_good_result_left(doc, shell, tmp_path, name, value, sentence):
    nodes, edges, forces = array(shell.NodePositions), edge_ends(shell.Shape), list(shell.MemberForces)
    setattr(shell, name, float("nan") if value == "nan" else value)
    doc.recompute()

    assert_refused(shell, sentence)
    assert shell.Status == STATUS_OF_SOLVER.get(value, "failed")
    assert sentence in shell.Summary
    np.testing.assert_array_equal(array(shell.NodePositions), nodes)
    np.testing.assert_array_equal(edge_ends(shell.Shape), edges)
    assert list(shell.MemberForces) == forces

    again = reopened(doc, tmp_path / "refused.FCStd").Gridshell
    assert_refused(again, sentence)
    np.testing.assert_allclose(edge_ends(again.Shape), edges, atol=1e-6)


@pytest.mark.parametrize("name, value, sentence", REFUSED)
def test_it_recovers_when_the_value_is_mended(doc, shell, name, value, sentence):
    good, nodes = getattr(shell, name), array(shell.NodePositions)
    setattr(shell, name, float("nan") if value == "nan" else value)
    doc.recompute()
    setattr(shell, name, good)
    assert recompute(doc) == {}
    assert shell.Status == "converged"
    np.testing.assert_allclose(array(shell.NodePositions), nodes, atol=1e-6)


def test_all_weights_zero(doc, shell):
    shell.MemberWeight = shell.CoveringWeight = 0
    doc.recompute()
    assert_refused(shell, "MemberWeight, CoveringWeight and Snow are all zero", "give one of them")


def test_a_net_that_is_no_net(doc, dome, shell):
    shell.Net = dome
    doc.recompute()
    assert_refused(shell, "Net is Dome, which is not a Net: set it to a Net of this document")


def test_a_net_that_never_was_computed(doc, box, shell):
    from funicular.make import make_net

    net = make_net(doc, (box, ["Face7"]))
    shell.Net = net
    doc.recompute()
    assert_refused(net, "Source Box.Face7 no longer exists")
    assert "Up-to-date" not in shell.State
    assert len(shell.NodePositions) == len(array(shell.Reactions)) > 0


def test_a_deleted_net(doc, shell):
    edges = edge_ends(shell.Shape)
    doc.removeObject("Net")
    doc.recompute()
    assert_refused(shell, "Net is empty (none was given, or it was deleted)")
    np.testing.assert_array_equal(edge_ends(shell.Shape), edges)


def test_a_broken_net_leaves_the_gridshell_as_it_was(doc, shell):
    edges = edge_ends(shell.Shape)
    shell.Net.StepU = 0
    doc.recompute()
    assert_refused(shell.Net, "StepU is 0 mm")
    np.testing.assert_array_equal(edge_ends(shell.Shape), edges)
    assert "Up-to-date" not in shell.State
    shell.Net.StepU = "2 m"
    assert recompute(doc) == {}
    assert len(shell.Shape.Edges) == shell.Net.MemberCount


def test_a_closed_net_has_no_border_to_stand_on(doc):
    torus = doc.addObject("Part::Torus", "Torus")
    torus.Radius1, torus.Radius2 = 10000, 3000
    doc.recompute()
    shell = make_gridshell(doc, source=(torus, ["Face1"]), StepU="3 m", StepV="2 m")
    doc.recompute()
    assert_refused(shell, "SupportRecipe: recipe 'boundary': the net is closed", "'lowest points' instead")


def test_a_member_that_shrank_to_nothing_is_named():
    nodes = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 1e-9]])
    with pytest.raises(
        fn.InvalidInput, match=r"member 1 \(nodes 1 and 2\) has shrunk to 1e-09 mm.*larger steps"
    ):
        edges_of(nodes, np.array([[0, 1], [1, 2]]))
