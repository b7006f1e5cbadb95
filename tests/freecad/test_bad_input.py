# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input to a Gridshell: a sentence that says what and what to do, and nothing that was good is lost."""

import FreeCAD as App
import Part
import numpy as np
import pytest

import funicular as fn
from documents import array, assert_refused, edge_ends, recompute, reopened
from funicular.export import lattice_of
from funicular.features import gridshell, net
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


# property, expression, what the sentence must say, and a value that is right
WRONG_UNITS = [
    ("CoveringWeight", "0.03 kg/m", "is 3e-05 kg/mm", "kg/m^2", "30 kg/m^2"),
    ("CoveringWeight", "Sheet.A1", "is 45 by the expression 'Sheet.A1'", "kg/m^2", "30 kg/m^2"),
    ("MemberWeight", "1 mm", "is 1 mm", "kg/m", "12 kg/m"),
    ("AxialStiffness", "3 m", "is 3000 mm", "N", "100 kN"),
    ("Snow", "3 kg", "is 3 kg", "N/m^2", "1 kPa"),
    ("Accuracy", "2 kg", "is 2 kg", "mm", "1 mm"),
    ("StepU", "2 kg", "is 2 kg", "mm", "3 m"),
]


@pytest.mark.parametrize("name, expression, what, unit, right", WRONG_UNITS)
def test_an_expression_in_another_unit_is_refused(doc, shell, name, expression, what, unit, right):
    doc.addObject("Spreadsheet::Sheet", "Sheet").set("A1", "45")
    doc.recompute()
    obj = shell.Net if name == "StepU" else shell
    obj.setExpression(name, expression)
    doc.recompute()
    assert_refused(obj, f"{name} {what}", f", which is not in {unit}: give it with that unit")
    assert shell.Status == "failed" and not shell.CompressionOnly

    obj.setExpression(name, None)
    assert getattr(obj, name).Unit == App.Units.Unit(unit)
    if expression != "Sheet.A1":
        # A plain number has left a value in FreeCAD's own unit; any other has left none.
        doc.recompute()
        assert_refused(obj, f"{name} is nan")
    setattr(obj, name, right)
    assert recompute(doc) == {}
    assert shell.Status == "converged"
    assert getattr(obj, name).Value == pytest.approx(App.Units.Quantity(right).Value)


def test_a_plain_number_drives_a_length_in_millimetres(doc, shell):
    shell.Net.setExpression("StepU", "2500 + 500")
    assert recompute(doc) == {}
    assert shell.Net.StepU == App.Units.Quantity("3 m")


@pytest.mark.parametrize("name, value, sentence", REFUSED)
def test_refused_with_the_last_good_result_left(doc, shell, tmp_path, name, value, sentence):
    nodes, edges, forces = array(shell.NodePositions), edge_ends(shell.Shape), list(shell.MemberForces)
    setattr(shell, name, float("nan") if value == "nan" else value)
    doc.recompute()

    assert_refused(shell, sentence)
    assert shell.Status == STATUS_OF_SOLVER.get(value, "failed")
    assert sentence in shell.Summary
    assert not shell.CompressionOnly
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

    uncomputed = make_net(doc, (box, ["Face7"]))
    shell.Net = uncomputed
    doc.recompute()
    assert_refused(uncomputed, "Source Box.Face7 no longer exists")
    assert "Up-to-date" not in shell.State
    assert len(shell.NodePositions) == len(array(shell.Reactions)) > 0


def test_a_deleted_net(doc, shell):
    edges = edge_ends(shell.Shape)
    doc.removeObject("Net")
    doc.recompute()
    assert_refused(shell, "Net is empty (none was given, or it was deleted)")
    np.testing.assert_array_equal(edge_ends(shell.Shape), edges)


def test_a_broken_net_leaves_the_geometry_of_its_gridshell_and_no_certificate(doc, shell):
    edges, nodes, forces = edge_ends(shell.Shape), array(shell.NodePositions), list(shell.MemberForces)
    shell.Net.StepU = 0
    doc.recompute()
    assert_refused(shell.Net, "StepU is 0 mm")
    np.testing.assert_array_equal(edge_ends(shell.Shape), edges)
    np.testing.assert_array_equal(array(shell.NodePositions), nodes)
    assert list(shell.MemberForces) == forces
    assert "Up-to-date" not in shell.State
    assert (shell.Status, shell.CompressionOnly) == ("failed", False)
    assert shell.Summary == "Net: StepU is 0 mm: give a length greater than zero"
    shell.Net.StepU = "2 m"
    assert recompute(doc) == {}
    assert (shell.Status, shell.CompressionOnly) == ("converged", True)
    assert len(shell.Shape.Edges) == shell.Net.MemberCount


@pytest.mark.parametrize("error", [Part.OCCError("BRep_API: command not done"), KeyError("net")])
@pytest.mark.parametrize("name", ["certify", "edges_of"])
def test_whatever_fails_after_the_solve_leaves_no_certificate(doc, shell, monkeypatch, name, error):
    def fail(*_):
        raise error

    monkeypatch.setattr(gridshell if name == "edges_of" else fn, name, fail)
    shell.CoveringWeight = "31 kg/m^2"
    doc.recompute()
    assert "Invalid" in shell.State
    assert (shell.Status, shell.CompressionOnly) == ("failed", False)
    assert shell.Summary in ("BRep_API: command not done", "'net'")


def test_a_net_whose_shape_fails_keeps_its_nodes(doc, shell, monkeypatch):
    def fail(*_):
        raise Part.OCCError("BRep_API: command not done")

    nodes = array(shell.Net.SourceNodes)
    monkeypatch.setattr(net, "edges_of", fail)
    shell.Net.StepU = "2 m"
    doc.recompute()
    assert_refused(shell.Net, "BRep_API: command not done")
    np.testing.assert_array_equal(array(shell.Net.SourceNodes), nodes)


TILT = App.Rotation(App.Vector(1, 0, 0), 10)


def test_a_gridshell_placed_at_a_tilt(doc, shell):
    shell.Placement.Rotation = TILT
    doc.recompute()
    assert_refused(shell, "Placement tilts the gridshell", "turn about z alone", "Placement of Net instead")
    assert (shell.Status, shell.CompressionOnly) == ("failed", False)


@pytest.mark.parametrize("name", ["Gridshell", "Net"])
def test_a_gridshell_or_net_in_a_container_at_a_tilt(doc, shell, name):
    outer, inner = (doc.addObject("App::Part", part) for part in ("Outer", "Inner"))
    outer.addObject(inner)
    inner.addObject(doc.getObject(name))
    # FreeCAD takes along what an object is linked with.
    inner.Group = [doc.getObject(name)]
    outer.Placement.Rotation = TILT
    shell.touch()
    doc.recompute()
    assert_refused(shell, f"{name} lies inside Inner, which is placed at a tilt", "move it out of Inner")


def test_a_container_that_tilted_after_the_solve(doc, shell):
    part = doc.addObject("App::Part", "Part")
    part.addObject(shell)
    assert recompute(doc) == {}
    part.Placement.Rotation = TILT
    part.purgeTouched()
    with pytest.raises(fn.InvalidInput, match="Gridshell lies inside Part, which is placed at a tilt"):
        lattice_of(shell)


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
