# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes, members and panels that were picked on a gridshell, as edits of its net that keep their meaning."""

import FreeCAD as App
import numpy as np
import pytest

import funicular as fn
from documents import array, recompute
from funicular.features.picked_edits import panels_of_faces, raised, taken_out
from funicular.make import make_covering, make_gridshell
from test_net_sources import hill, mesh_object


@pytest.fixture
def shell(doc):
    made = make_gridshell(doc, Width="8 m", Depth="6 m")
    assert recompute(doc) == {}
    return made


@pytest.fixture
def of_mesh(doc):
    made = make_gridshell(doc, mesh_object(doc, *hill()))
    assert recompute(doc) == {}
    return made


def apply(shell, changes):
    for name, value in changes.items():
        setattr(shell.Net, name, value)
    assert recompute(shell.Document) == {}


def middle(shell, member):
    a, b = np.array(shell.Members).reshape(-1, 2)[member]
    return array(shell.Net.SourceNodes)[[a, b]].mean(axis=0)


def test_a_picked_node_rises_and_rises_again_whatever_the_step(shell):
    node = 9 * 3 + 4
    below = shell.Net.SourceNodes[node].z
    for height in (200, 400):
        apply(shell, raised(shell, [shell.NodePositions[node]], 200))
        assert shell.Net.SourceNodes[node].z == pytest.approx(below + height)
        assert len(shell.Net.Raised) == 1
    shell.Net.StepU = shell.Net.StepV = "500 mm"
    assert recompute(shell.Document) == {}
    heights = array(shell.Net.SourceNodes)[:, 2]
    assert np.count_nonzero(heights > 300) == 1


def test_picked_members_and_panels_go_and_stay_away(shell):
    members, panels = shell.Net.MemberCount, shell.Net.PanelCount
    inside = next(k for k in range(members) if (np.abs(middle(shell, k) - (4500, 3000, 0)) < 501).all())
    apply(shell, taken_out(shell, [inside], [0]))
    # The corner panel takes its two members on the border with it, and the member joins two panels.
    assert (shell.Net.MemberCount, shell.Net.PanelCount) == (members - 3, panels - 2)
    again = shell.Net.MemberCount
    apply(shell, taken_out(shell, [again // 2]))
    assert shell.Net.MemberCount < again and len(shell.Net.RemovedMembers) == 2
    assert shell.Status == "converged"


def test_faces_of_a_covering_are_its_panels(doc, shell):
    for kind in ("Faces", "Triangles"):
        covering = make_covering(doc, shell, Kind=kind)
        assert recompute(doc) == {}
        faces = covering.Shape.Faces
        assert panels_of_faces(covering, [1, len(faces)]) == [0, shell.Net.PanelCount - 1]
        per_panel = len(faces) // shell.Net.PanelCount
        assert panels_of_faces(covering, [2 * per_panel]) == [1]


def test_nets_without_places_are_edited_by_number(of_mesh):
    net = of_mesh.Net
    panels = net.PanelCount
    apply(of_mesh, raised(of_mesh, [of_mesh.NodePositions[24]], 100))
    assert (list(net.RaisedNodes), list(net.RaisedHeights)) == ([24], [100.0])
    apply(of_mesh, taken_out(of_mesh, panels=[30]))
    assert list(net.RemovedPanelNumbers) == [30] and net.PanelCount == panels - 1
    inner = next(
        k
        for k, pair in enumerate(np.array(of_mesh.Members).reshape(-1, 2).tolist())
        if sum(set(pair) <= set(panel) for panel in fn_panels(of_mesh)) == 2
    )
    apply(of_mesh, taken_out(of_mesh, members=[inner]))
    assert net.PanelCount == panels - 2
    joined = next(k for k, panel in enumerate(fn_panels(of_mesh)) if len(panel) == 4)
    area = sum(net.OpeningAreas)
    apply(of_mesh, taken_out(of_mesh, panels=[joined]))
    assert net.PanelCount == panels - 3 and sum(net.OpeningAreas) > 2.5 * area, "both that it was made of"


def test_a_panel_that_reaches_round_another_is_the_one_that_goes(doc):
    shell = make_gridshell(doc, Width="7 m", Depth="7 m")
    assert recompute(doc) == {}
    ring = [(2, 2), (3, 2), (4, 2), (4, 3), (4, 4), (3, 4), (2, 4)]
    between = [((a[0] + b[0] + 1) / 2, (a[1] + b[1] + 1) / 2) for a, b in zip(ring, ring[1:])]
    shell.Net.RemovedMembers = [App.Vector(x / 7, y / 7, 0) for x, y in between]
    assert recompute(doc) == {} and shell.Net.PanelCount == 49 - 6
    around = next(k for k, panel in enumerate(fn_panels(shell)) if len(panel) > 4)
    apply(shell, taken_out(shell, panels=[around]))
    assert shell.Net.PanelCount == 49 - 7 and {len(panel) for panel in fn_panels(shell)} == {4}


def fn_panels(shell):
    from funicular.features.net import panels_of

    return panels_of(shell.Panels)


def test_nothing_picked_is_told(shell):
    with pytest.raises(fn.InvalidInput, match="no node is picked"):
        raised(shell, [], 100)
    with pytest.raises(fn.InvalidInput, match="nothing is picked"):
        taken_out(shell)
