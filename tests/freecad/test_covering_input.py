# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a Covering is given: by make_covering, and wrong; the last good shape stays."""

import FreeCAD as App
import numpy as np
import pytest

from documents import array, assert_refused, recompute
from funicular.features.net import panels_of
from funicular.make import make_covering, make_gridshell


@pytest.fixture
def shell(doc, dome):
    made = make_gridshell(doc, source=dome, StepU="3 m", StepV="2 m")
    assert recompute(doc) == {}
    return made


def put(sheet, nodes):
    sheet.NodePositions = [App.Vector(*node) for node in nodes.tolist()]
    sheet.purgeTouched()


class TestBadInput:
    @pytest.fixture
    def covering(self, doc, shell):
        made = make_covering(doc, shell)
        assert recompute(doc) == {}
        return made

    @pytest.fixture(autouse=True)
    def last_good_shape_stays(self, covering):
        faces, area = len(covering.Shape.Faces), covering.Area.Value
        yield
        assert len(covering.Shape.Faces) == covering.PanelCount == faces and covering.Area.Value == area

    def test_no_gridshell(self, doc, covering):
        covering.Gridshell = None
        doc.recompute()
        assert_refused(covering, "Gridshell is empty", "set it to a Gridshell of this document")

    def test_a_deleted_gridshell(self, doc, covering):
        doc.removeObject("Gridshell")
        doc.recompute()
        assert_refused(covering, "Gridshell is empty (none was given, or it was deleted)")

    def test_what_is_no_gridshell(self, doc, covering, shell):
        covering.Gridshell = shell.Net
        doc.recompute()
        assert_refused(covering, "Gridshell is Net, which is not a Gridshell")

    def test_a_gridshell_without_a_result(self, doc, covering, dome):
        covering.Gridshell = make_gridshell(doc, source=dome)
        covering.recompute()
        assert_refused(covering, "Gridshell001 has no result: recompute it first")

    def test_a_gridshell_that_failed(self, doc, covering, shell):
        shell.CoveringWeight = "3000000 kg/m^2"
        doc.recompute()
        assert not shell.isValid() and "Touched" in covering.State
        covering.recompute()
        assert_refused(covering, "Gridshell has no result: No equilibrium")
        shell.CoveringWeight = "30 kg/m^2"
        assert recompute(doc) == {}

    def test_no_panels(self, covering, shell):
        shell.Panels = []
        covering.recompute()
        assert_refused(covering, "Gridshell has no panels that could be covered", "another Pattern")

    def test_a_panel_on_one_line(self, covering, shell):
        panel = panels_of(shell.Panels)[7]
        nodes = array(shell.NodePositions)
        nodes[list(panel)] = nodes[panel[0]] + np.arange(len(panel))[:, None] * [300.0, 200.0, 100.0]
        put(shell, nodes)
        covering.recompute()
        assert_refused(
            covering, f"panel 7 (nodes {', '.join(map(str, panel))}) has no area", "give the net larger steps"
        )

    def test_a_side_without_length(self, covering, shell):
        nodes, (a, b, *_) = array(shell.NodePositions), panels_of(shell.Panels)[3]
        nodes[b] = nodes[a]
        put(shell, nodes)
        covering.recompute()
        assert_refused(covering, "has a side without length, between nodes")
        (first, second) = covering.getStatusString().split("between nodes ")[1].split(":")[0].split(" and ")
        assert {int(first), int(second)} == {a, b}

    def test_a_tolerance_of_another_unit(self, doc, covering):
        covering.setExpression("PlanarTolerance", "2 kg")
        doc.recompute()
        assert_refused(covering, "PlanarTolerance is ", "give it with that unit")


class TestMake:
    def test_one_undo_step(self, doc, shell):
        doc.UndoMode = 1
        covering = make_covering(doc, shell, Kind="Triangles", PlanarTolerance="5 mm")
        assert doc.UndoNames == ["Make covering"]
        assert (covering.Name, covering.Kind, covering.PlanarTolerance.Value) == (
            "Covering",
            "Triangles",
            5.0,
        )
        doc.undo()
        assert doc.getObject("Covering") is None and shell.InList == []
        doc.redo()
        assert recompute(doc) == {} and doc.Covering.Gridshell == shell

    def test_defaults(self, doc, shell):
        covering = make_covering(doc, shell)
        assert (covering.Kind, covering.PlanarTolerance.Value) == ("Faces", 1.0)
        assert shell.Visibility and covering.Visibility

    @pytest.mark.parametrize(
        "properties, sentence",
        [
            ({"Colour": "red"}, "Colour is not a property of a Covering: there are Kind, PlanarTolerance"),
            ({"Area": 3}, "Area is not a property of a Covering"),
            ({"Gridshell": None}, "Gridshell is not a property of a Covering"),
            ({"Kind": "Glass"}, "Kind = 'Glass' does not do: .*there are Faces, Ruled faces, Triangles"),
            ({"PlanarTolerance": "1 kg"}, "PlanarTolerance = '1 kg' does not do: it is not in mm"),
            ({"PlanarTolerance": -1}, "PlanarTolerance = -1 mm does not do: give zero or more"),
        ],
    )
    def test_a_failing_make_leaves_nothing_behind(self, doc, shell, properties, sentence):
        doc.UndoMode = 1
        before = [obj.Name for obj in doc.Objects]
        with pytest.raises(ValueError, match=sentence):
            make_covering(doc, shell, **properties)
        assert [obj.Name for obj in doc.Objects] == before and doc.UndoNames == []

    def test_what_is_no_gridshell_of_the_document(self, doc, shell):
        for wrong, named in ((shell.Net, "'Net'"), (None, "None"), ("Gridshell", "'Gridshell'")):
            with pytest.raises(ValueError, match=f"gridshell is {named}, which is not a Gridshell"):
                make_covering(doc, wrong)
        other = App.newDocument("Other")
        with pytest.raises(
            ValueError, match="gridshell Gridshell is in the document Test: make its covering"
        ):
            make_covering(other, shell)
        assert other.Objects == []

    def test_every_property_has_a_group_and_a_tooltip(self, doc, shell):
        covering = make_covering(doc, shell)
        for each in type(covering.Proxy).PROPERTIES:
            assert covering.getGroupOfProperty(each.name) in ("Covering", "Results")
            assert len(covering.getDocumentationOfProperty(each.name)) > 10
        assert covering.getEditorMode("Area") == ["ReadOnly"]
