# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets of equal lengths in the document: laid, relaxed, changed, refused by name."""

import FreeCAD as App
import numpy as np
import pytest

from documents import array, assert_refused, recompute, reopened
from faces import FACES
from funicular.features.net import net_of
from funicular.make import make_gridshell, make_net

V = App.Vector


@pytest.fixture
def shell(doc):
    source = doc.addObject("Part::Feature", "Roof")
    source.Shape = FACES["B-spline"][0]()
    made = make_gridshell(doc, source, Laying="Equal lengths", StepU="2 m", SupportRecipe="Boundary")
    assert recompute(doc) == {}
    return made


def test_every_member_has_the_length_of_the_step(doc, shell, tmp_path):
    for step in (2000, 1500):
        shell.Net.StepU = step
        assert recompute(doc) == {}
        lengths = [edge.Length for edge in shell.Net.Shape.Edges]
        assert max(abs(length - step) for length in lengths) < 1e-6 * step
        assert {len(panel) for panel in net_of(shell.Net).panels} == {4}
        assert shell.Status == "converged" and shell.CompressionOnly
    count = shell.Net.NodeCount
    again = reopened(doc, tmp_path / "equal.FCStd")
    assert len(net_of(again.Net).nodes) == count


def test_it_grows_from_another_place_in_another_direction(doc, shell):
    before = array(shell.Net.SourceNodes)
    shell.Net.Start, shell.Net.Angle = V(0.3, 0.4, 0), 30
    assert recompute(doc) == {}
    after = array(shell.Net.SourceNodes)
    assert before.shape != after.shape or np.abs(before - after).max() > 100
    assert shell.Status == "converged"


def test_a_dome_says_where_it_cannot_go_on(doc, dome):
    net = make_net(doc, (dome, ["Face1"]), Laying="Equal lengths", StepU="1 m", Start=V(0.1, 0.4, 0))
    assert recompute(doc) == {}
    assert net.Remarks != ""
    lengths = [edge.Length for edge in net.Shape.Edges]
    assert max(abs(length - 1000) for length in lengths) < 1e-3


def test_what_does_not_do_is_named(doc, box, shell):
    shell.Net.Start = V(1.5, 0, 0)
    recompute(doc)
    assert_refused(shell.Net, "start[0] is 1.5, outside the face")
    shell.Net.Start, shell.Net.MostShear = V(0.5, 0.5, 0), 85
    recompute(doc)
    assert_refused(shell.Net, "most_shear is 85")
    shell.Net.MostShear, shell.Net.Source = 60, (box, ["Face2", "Face6"])
    recompute(doc)
    assert_refused(shell.Net, "Laying: a net of equal lengths lies on one face")
