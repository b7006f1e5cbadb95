# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits of a net before it is relaxed: kept by meaning, and the weight of openings stands on their rims."""

import FreeCAD as App
import numpy as np
import pytest

import funicular as fn
from documents import array, assert_refused, recompute, reopened
from funicular.edits import Edits, Places, edited
from funicular.features.gridshell import scene_of
from funicular.features.net import net_of, panels_of
from funicular.laying import Laid
from funicular.make import make_gridshell, make_support
from funicular.topology import rims

V = App.Vector


@pytest.fixture
def shell(doc, box):
    """On the top of the box, 8 m x 6 m, cells of 1 m."""
    made = make_gridshell(doc, source=(box, ["Face6"]), SupportRecipe="Boundary")
    assert recompute(doc) == {}
    return made


def sheet(cells=4):
    net = fn.Net.grid(cells, cells, 1)
    laid = Laid(net.nodes * 1000, net.members, net.panels, net.lattice, uv=net.lattice.uv)
    return laid, Places(laid.uv)


def euler(net):
    edges = {tuple(sorted(pair)) for panel in net.panels for pair in zip(panel, panel[1:] + panel[:1])}
    return len(net.nodes) - len(edges) + len(net.panels)


def test_a_junction_is_raised_and_another_lowered_whatever_the_step(doc, shell):
    shell.Net.Raised = [V(0.5, 0.5, 700), V(0.25, 1 / 3, -200)]
    for step in ("1 m", "500 mm"):
        shell.Net.StepU = shell.Net.StepV = step
        assert recompute(doc) == {}
        nodes = array(shell.Net.SourceNodes)
        raised = nodes[np.abs(nodes[:, 2] - 3000) > 1e-9]
        assert sorted(raised.round(6).tolist()) == [[2000, 2000, 2800], [4000, 3000, 3700]]
        assert shell.Status == "converged"
    assert net_of(shell.Net).lattice is not None, "it is solved as fast as before"


def test_members_have_the_lengths_of_the_edited_net(doc, shell):
    flat = array(shell.NodePositions)[:, 2].max()
    shell.Net.Raised = [V(0.5, 0.5, 1500)]
    assert recompute(doc) == {}
    assert array(shell.NodePositions)[:, 2].max() > flat + 300


def test_a_panel_becomes_an_opening_whose_weight_stands_on_its_rim(doc, shell):
    whole = shell.TotalWeight.Value
    shell.Net.RemovedPanels = [V(0.44, 0.58, 0)]
    shell.AxialStiffness = "100 MN"
    assert recompute(doc) == {}
    assert shell.Status == "converged" and shell.CompressionOnly
    net = net_of(shell.Net)
    assert shell.Net.PanelCount == 47 and shell.Net.MemberCount == 110
    outer, rim = rims(net.nodes, net.panels)
    assert sorted(rim) == sorted(panels_of(shell.Net.OpeningNodes)[0])
    place = net.nodes[rim].mean(axis=0)
    assert place[:2] == pytest.approx([3.5, 3.5])
    loads = [effect for effect in scene_of(shell).effects if isinstance(effect, fn.PointLoad)]
    assert len(loads) == 1
    assert loads[0].force[2] * 4 == pytest.approx(-30 * 9.80665 * 1.0)
    assert shell.TotalWeight.Value == pytest.approx(whole, rel=0.05)


def test_an_opening_without_covering_weighs_nothing(doc, shell):
    shell.Net.RemovedPanels = [V(0.44, 0.58, 0)]
    shell.CoveringWeight = 0
    assert recompute(doc) == {}
    assert not any(isinstance(effect, fn.PointLoad) for effect in scene_of(shell).effects)


def test_an_opening_keeps_its_place_with_another_step_and_its_rim_can_be_held(doc, shell, tmp_path):
    shell.Net.RemovedPanels = [V(0.5, 0.5, 0)]
    shell.Net.CountU, shell.Net.CountV = 5, 5
    support = make_support(doc, shell, Where="Opening rims", Kind="On its vertical line")
    for count in (5, 7, 9):
        shell.Net.CountU = shell.Net.CountV = count
        assert recompute(doc) == {}
        held = array(shell.Net.SourceNodes)[support.HeldNodes]
        assert held.mean(axis=0) == pytest.approx([4000, 3000, 3000])
        moved = array(shell.NodePositions)[support.HeldNodes] - held
        assert np.abs(moved[:, :2]).max() < 1e-9
    again = reopened(doc, tmp_path / "opening.FCStd")
    again.Net.CountU = 5
    assert recompute(again) == {}
    assert len(again.Support.HeldNodes) == 4


def test_a_member_is_taken_out_and_its_panels_become_one(doc, shell):
    shell.Net.RemovedMembers = [V(0.5, 0.58, 0)]
    assert recompute(doc) == {}
    net = net_of(shell.Net)
    assert (shell.Net.MemberCount, shell.Net.PanelCount) == (109, 47)
    assert sorted(len(panel) for panel in net.panels)[-2:] == [4, 6]
    assert euler(net) == 1 and shell.Status == "converged"


def test_numbers_edit_a_net_that_keeps_them(doc, tmp_path):
    path = str(tmp_path / "sheet.obj")
    fn.Net.grid(4, 4, 1).write(path)
    shell = make_gridshell(doc, File=path, SupportRecipe="Corners")
    shell.Net.RaisedNodes, shell.Net.RaisedHeights = [12], [500.0]
    shell.Net.RemovedPanelNumbers = [5]
    assert recompute(doc) == {}
    assert shell.Net.SourceNodes[12].z == 500 and shell.Net.PanelCount == 15
    shell.Net.RaisedHeights = []
    recompute(doc)
    assert_refused(shell.Net, "RaisedNodes names 1 nodes, but RaisedHeights has 0 values")
    shell.Net.RaisedNodes = []
    shell.Net.RemovedPanelNumbers = [16]
    recompute(doc)
    assert_refused(shell.Net, "there is no panel 16: the net has panels 0 to 15")
    shell.Net.RemovedPanelNumbers, shell.Net.Raised = [], [V(0.5, 0.5, 100)]
    recompute(doc)
    assert_refused(shell.Net, "places (u, v) are those of one whole face")


def test_an_edit_across_the_seam_of_a_dome(doc, dome):
    shell = make_gridshell(doc, source=(dome, ["Face1"]), StepU="1 m", StepV="1 m")
    shell.Net.RemovedPanels = [V(1 - 1e-6, 0.5, 0)]
    assert recompute(doc) == {}
    net = net_of(shell.Net)
    rim = rims(net.nodes, net.panels)[1]
    turn = np.arctan2(net.nodes[rim][:, 1], net.nodes[rim][:, 0])
    assert np.abs(turn).max() < 0.3 and shell.Status == "converged"


class TestByNumbers:
    def test_all_members_of_a_node_make_one_panel_and_no_node(self):
        laid, places = sheet()
        gone = [k for k, member in enumerate(laid.members.tolist()) if 12 in member]
        made, openings, numbers = edited(laid, Edits(members=gone), places)
        assert len(made.nodes) == 24 and 12 not in numbers and openings == ()
        assert sorted(len(panel) for panel in made.panels) == [4] * 12 + [8]
        assert euler(fn.Net(made.nodes, made.members, made.panels)) == 1

    def test_three_of_four_leave_a_member_that_juts_into_the_panel(self):
        laid, places = sheet()
        gone = [k for k, member in enumerate(laid.members.tolist()) if 12 in member][:3]
        made, _, _ = edited(laid, Edits(members=gone), places)
        net = fn.Net(made.nodes, made.members, made.panels)
        assert len(net.nodes) == 25 and sorted(len(panel) for panel in net.panels)[-1] == 8

    def test_the_order_of_edits_does_not_matter(self):
        laid, places = sheet()
        one, _, _ = edited(laid, Edits(members=[3, 9, 17], panels=[2, 8]), places)
        other, _, _ = edited(laid, Edits(members=[17, 3, 9], panels=[8, 2]), places)
        assert one.panels == other.panels and np.array_equal(one.members, other.members)

    def test_a_net_that_falls_apart_is_refused(self):
        laid, places = sheet(2)
        cut = [k for k, (a, b) in enumerate(laid.members.tolist()) if {a // 3, b // 3} == {0, 1}]
        with pytest.raises(fn.InvalidInput, match="the net falls apart"):
            edited(laid, Edits(members=cut), places)

    def test_nothing_is_copied_where_nothing_is_edited(self):
        laid, places = sheet()
        made, openings, numbers = edited(laid, Edits(), places)
        assert made.lattice is laid.lattice and made.panels is laid.panels and openings == ()
        assert not Edits()
