# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripting API: values with and without units, one undo step, and nothing left behind when it fails."""

import math

import FreeCAD as App
import numpy as np
import pytest

from documents import recompute
from funicular.make import make_gridshell, make_net


def test_values_as_text_quantity_and_plain_number(doc, box):
    for values in (
        {"StepU": "50 cm", "MemberWeight": "8 kg/m", "AxialStiffness": "50 kN", "Snow": "750 Pa"},
        {"StepU": 500, "MemberWeight": 8, "AxialStiffness": 50000, "Snow": 750},
        {
            "StepU": App.Units.Quantity("0.5 m"),
            "MemberWeight": App.Units.Quantity("8 kg/m"),
            "AxialStiffness": App.Units.Quantity("0.05 MN"),
            "Snow": App.Units.Quantity("0.75 kPa"),
        },
        {
            "StepU": np.float32(500),
            "MemberWeight": np.float64(8),
            "AxialStiffness": np.int64(50000),
            "Snow": np.float64(750),
        },
    ):
        shell = make_gridshell(doc, source=(box, "Face6"), **values)
        assert shell.Net.StepU.getValueAs("mm").Value == pytest.approx(500)
        assert shell.MemberWeight.getValueAs("kg/m").Value == pytest.approx(8)
        assert shell.AxialStiffness.getValueAs("N").Value == pytest.approx(50000)
        assert shell.Snow.getValueAs("N/m^2").Value == pytest.approx(750)


def test_numbers_of_numpy_without_a_unit(doc, box):
    shell = make_gridshell(doc, (box, "Face6"), MaxSeconds=np.int64(5), LengthMatching=np.int64(2))
    assert (shell.MaxSeconds, shell.LengthMatching) == (5.0, 2)


def test_defaults(doc, box):
    shell = make_gridshell(doc, source=(box, "Face6"))
    assert (shell.Name, shell.Net.Name) == ("Gridshell", "Net")
    assert shell.MemberWeight.getValueAs("kg/m").Value == pytest.approx(12)
    assert shell.CoveringWeight.getValueAs("kg/m^2").Value == pytest.approx(30)
    assert shell.AxialStiffness.getValueAs("kN").Value == pytest.approx(100)
    assert shell.Accuracy.Value == 1.0
    assert (shell.CoveringShare, shell.SupportRecipe, shell.Method) == ("Angle", "Boundary", "Auto")
    assert (shell.AllowTension, shell.MaxSeconds, shell.LengthMatching) == (False, 60.0, 0)


def test_the_net_gives_way_to_its_gridshell(doc, box):
    shell = make_gridshell(doc, source=(box, "Face6"))
    assert shell.Visibility and not shell.Net.Visibility
    assert make_net(doc, (box, "Face6")).Visibility


def test_every_property_has_a_group_and_a_tooltip(doc, box):
    shell = make_gridshell(doc, source=(box, "Face6"))
    groups = {
        "Net",
        "Sheet",
        "Equal lengths",
        "Edits",
        "Mesh",
        "Edges",
        "Weights",
        "Stiffness",
        "Supports",
        "Solution",
        "Section",
        "Variants",
        "Results",
        "Base",
    }
    for obj in (shell, shell.Net):
        own = [each.name for each in type(obj.Proxy).PROPERTIES]
        assert own
        for name in own:
            assert obj.getGroupOfProperty(name) in groups
            assert len(obj.getDocumentationOfProperty(name)) > 10
    assert shell.getEditorMode("Residual") == ["ReadOnly"]
    assert set(shell.Net.getEditorMode("SourceNodes")) == {"ReadOnly", "Hidden"}
    assert shell.getEditorMode("Snow") == []


@pytest.mark.parametrize(
    "arguments, sentence",
    [
        ({"StepX": 1}, "StepX is not a property of a Gridshell: there are .*Accuracy.*StepU"),
        ({"Residual": 1}, "Residual is not a property of a Gridshell"),
        ({"StepU": "3 kg"}, "StepU = '3 kg' does not do: .*such as '1 m'"),
        ({"StepU": -500}, "StepU = -500 mm|StepU = -500.0 mm"),
        ({"MemberWeight": "-1 kg/m"}, "MemberWeight = '-1 kg/m' does not do: give zero or more"),
        (
            {"MemberWeight": "30"},
            "MemberWeight = '30' does not do: it is not in kg/m, give it with that unit",
        ),
        ({"StepU": "500"}, "StepU = '500' does not do: it is not in mm, give it with that unit.*'1 m'"),
        ({"Snow": App.Units.Quantity(3)}, "Snow = .* does not do: it is not in N/m.2"),
        ({"MemberWeight": np.float64(-8)}, "MemberWeight = -8.0 kg/m does not do: give zero or more"),
        ({"CoveringWeight": math.nan}, "CoveringWeight = nan kg/m.2 does not do: give zero or more"),
        ({"Accuracy": np.inf}, "Accuracy = inf mm does not do: give zero or more"),
        ({"MaxSeconds": np.inf}, "MaxSeconds = inf does not do: give a finite number"),
        ({"MemberWeight": "heavy"}, "MemberWeight = 'heavy' does not do"),
        ({"CoveringWeight": "3 kg/m"}, "CoveringWeight = '3 kg/m' does not do.*such as '30 kg/m.2'"),
        ({"Pattern": "Spiral"}, "Pattern = 'Spiral' does not do: .*there are Quad"),
        (
            {"SupportRecipe": "Everywhere"},
            "SupportRecipe = 'Everywhere' does not do: .*there are Boundary, Corners",
        ),
    ],
)
def test_a_failing_make_leaves_nothing_behind(doc, box, arguments, sentence):
    doc.UndoMode = 1
    with pytest.raises(ValueError, match=sentence):
        make_gridshell(doc, source=(box, ["Face6"]), **arguments)
    assert [obj.Name for obj in doc.Objects] == ["Box"]
    assert doc.UndoNames == [] and App.getActiveTransaction() is None


def test_what_is_no_source_is_refused(doc, box):
    for source in (3, "Box", (box, ["Face1"], 2)):
        with pytest.raises(ValueError, match="source"):
            make_net(doc, source)
    with pytest.raises(ValueError, match="give (either )?source, what to make a net on, or net"):
        make_gridshell(doc)
    with pytest.raises(ValueError, match="net is 'Box', which is not a Net"):
        make_gridshell(doc, net=box)
    assert [obj.Name for obj in doc.Objects] == ["Box"]


def test_a_source_of_another_document_is_refused(doc, box):
    other = App.newDocument("Other")
    with pytest.raises(ValueError, match="source Box is in the document Test: bring it into Other"):
        make_net(other, (box, ["Face6"]))
    assert other.Objects == []


def test_a_net_of_another_document_is_refused(doc, box):
    net = make_net(doc, (box, ["Face6"]))
    other = App.newDocument("Other")
    with pytest.raises(
        ValueError, match="net Net is in the document Test: copy it into Other.*, with its source"
    ):
        make_gridshell(other, net=net)
    assert other.Objects == []


def test_a_shared_net_keeps_its_properties(doc, box):
    net = make_net(doc, (box, ["Face6"]))
    with pytest.raises(
        ValueError, match="StepU: these are properties of the net Net, which is there already"
    ):
        make_gridshell(doc, net=net, StepU=300)
    assert [obj.Name for obj in doc.Objects] == ["Box", "Net"]


def test_one_undo_step(doc, box):
    doc.UndoMode = 1
    make_gridshell(doc, source=(box, "Face6"))
    assert doc.UndoNames == ["Make gridshell"]
    doc.undo()
    assert [obj.Name for obj in doc.Objects] == ["Box"]
    doc.redo()
    assert recompute(doc) == {}
    assert doc.Gridshell.Status == "converged"


def test_a_transaction_of_the_caller_stays_open(doc, box):
    doc.UndoMode = 1
    doc.openTransaction("Mine")
    make_gridshell(doc, source=(box, "Face6"))
    assert App.getActiveTransaction()[0] == "Mine"
    doc.abortTransaction()
    assert [obj.Name for obj in doc.Objects] == ["Box"]
    assert doc.UndoNames == []


def test_a_failure_inside_a_transaction_of_the_caller(doc, box):
    doc.UndoMode = 1
    doc.openTransaction("Mine")
    box.Label = "Block"
    with pytest.raises(ValueError):
        make_gridshell(doc, source=(box, "Face6"), Snow="heavy")
    assert App.getActiveTransaction()[0] == "Mine"
    doc.commitTransaction()
    assert doc.UndoNames == ["Mine"]
    assert [obj.Label for obj in doc.Objects] == ["Block"]


def test_a_square_may_be_written_as_it_is_shown(doc, dome):
    shell = make_gridshell(doc, source=dome, StepU="3 m", StepV="2 m", CoveringWeight="45 kg/m²")
    assert shell.CoveringWeight.getValueAs("kg/m^2").Value == pytest.approx(45)
