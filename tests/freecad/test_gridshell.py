# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Gridshell in the document: solved, certified, followed through changes, saved, copied, shared."""

import FreeCAD as App
import numpy as np
import pytest

import funicular as fn
from documents import array, assert_refused, edge_ends, recompute, reopened
from funicular.export import lattice_of
from funicular.features.gridshell import result_line, scene_of, solver_options
from funicular.features.net import net_of
from funicular.make import make_gridshell, make_net

V = App.Vector
# Of each object, what a user would miss if it were lost.
RESULTS = ("Status", "Summary", "MethodUsed", "Residual", "CompressionOnly", "Iterations", "LengthDeviation")
LISTS = ("MemberForces", "TensionMembers", "SlackMembers")
VECTORS = ("NodePositions", "Reactions")
QUANTITIES = ("PositionError", "WorstTension", "TotalWeight", "ReactionSum", "MemberWeight", "CoveringWeight")


@pytest.fixture
def shell(doc, dome):
    made = make_gridshell(doc, source=dome, StepU="3 m", StepV="2 m")
    assert recompute(doc) == {}
    return made


def snapshot(shell):
    return {
        **{name: getattr(shell, name) for name in RESULTS},
        **{name: list(getattr(shell, name)) for name in LISTS},
        **{name: array(getattr(shell, name)).tolist() for name in VECTORS},
        **{name: getattr(shell, name).Value for name in QUANTITIES},
        "Edges": edge_ends(shell.Shape).tolist(),
    }


def assert_same(shot, other):
    """Two snapshots agree to the digits with which FreeCAD writes numbers to a file."""
    assert shot.keys() == other.keys()
    for name, value in shot.items():
        if isinstance(value, (list, float)):
            np.testing.assert_allclose(value, other[name], rtol=1e-8, atol=1e-9, err_msg=name)
        else:
            assert value == other[name], name


def test_the_result_is_what_the_numeric_api_finds(shell):
    scene = scene_of(shell)
    result = fn.solve(scene, **solver_options(shell))
    certificate = fn.certify(scene, result)
    assert shell.Status == result.status == "converged"
    np.testing.assert_allclose(array(shell.NodePositions), result.nodes * 1000, rtol=0, atol=1e-9)
    np.testing.assert_allclose(shell.MemberForces, result.member_forces, rtol=1e-12)
    np.testing.assert_allclose(array(shell.Reactions), result.reactions, rtol=1e-12, atol=1e-9)
    assert shell.Residual == result.residual
    assert shell.PositionError.Value == pytest.approx(result.position_error * 1000)
    assert shell.CompressionOnly and certificate.compression_only
    assert list(shell.SlackMembers) == list(certificate.slack_members)
    assert shell.MethodUsed == result.method


def test_the_shape_has_one_edge_per_member_in_member_order(shell):
    ends = edge_ends(shell.Shape)
    members = net_of(shell.Net).members
    assert ends.shape == (shell.Net.MemberCount, 2, 3)
    np.testing.assert_allclose(ends, array(shell.NodePositions)[members], atol=1e-7)


def test_reactions_carry_the_weight(shell):
    """The weights of the relaxed members and panels, summed here by hand, stand on the supports."""
    scene = scene_of(shell)
    nodes = array(shell.NodePositions) / 1000
    members = scene.net.members
    lengths = np.linalg.norm(nodes[members[:, 0]] - nodes[members[:, 1]], axis=1)
    area = sum(fan_area(nodes[list(panel)]) for panel in scene.net.panels)
    weight = 9.80665 * (12.0 * lengths.sum() + 30.0 * area)
    assert shell.TotalWeight.getValueAs("N").Value == pytest.approx(weight, rel=1e-3)
    assert shell.ReactionSum.getValueAs("N").Value == pytest.approx(
        shell.TotalWeight.getValueAs("N").Value, rel=1e-6
    )
    assert array(shell.Reactions)[:, 2].sum() == pytest.approx(shell.ReactionSum.getValueAs("N").Value)


def fan_area(corners):
    centre = corners.mean(axis=0)
    following = np.roll(corners, -1, axis=0)
    return 0.5 * np.linalg.norm(np.cross(corners - centre, following - centre), axis=1).sum()


def test_compression_is_negative_and_the_sentence_says_so(shell):
    assert max(shell.MemberForces) < 1e-6 and min(shell.MemberForces) < -1000
    assert result_line(shell).startswith("Compression only")


def test_a_hemisphere_that_may_pull_is_not_compression_only(doc):
    sphere = doc.addObject("Part::Sphere", "Sphere")
    sphere.Radius, sphere.Angle1 = 10000, 0
    doc.recompute()
    shell = make_gridshell(
        doc,
        source=(sphere, ["Face1"]),
        StepU="1.5 m",
        StepV="1 m",
        AxialStiffness="100 MN",
        AllowTension=True,
    )
    assert recompute(doc) == {}
    assert shell.Status == "converged" and not shell.CompressionOnly
    assert len(shell.TensionMembers) > 50
    assert shell.WorstTension.getValueAs("N").Value == pytest.approx(max(shell.MemberForces))
    assert f"{len(shell.TensionMembers)} of {shell.Net.MemberCount} members in tension" in shell.Summary


class TestFollowing:
    def test_the_face(self, doc, dome, shell):
        before = shell.TotalWeight.Value
        dome.Shape = dome.Shape.scaled(1.2)
        assert recompute(doc) == {}
        assert shell.TotalWeight.Value > 1.2 * before
        assert len(shell.MemberForces) == shell.Net.MemberCount == len(shell.Shape.Edges)

    def test_a_property_of_the_net(self, doc, shell):
        shell.Net.StepV = "1 m"
        assert recompute(doc) == {}
        assert len(shell.NodePositions) == shell.Net.NodeCount == len(shell.Reactions)

    @pytest.mark.parametrize(
        "name, value",
        [
            ("MemberWeight", "0 kg/m"),
            ("CoveringWeight", "90 kg/m^2"),
            ("Snow", "1 kPa"),
            ("AxialStiffness", "1 MN"),
            ("SupportRecipe", "Lowest points"),
        ],
    )
    def test_a_property_of_its_own(self, doc, shell, name, value):
        net_before, before = array(shell.Net.SourceNodes), snapshot(shell)
        setattr(shell, name, value)
        assert recompute(doc) == {}
        assert shell.Status == "converged"
        if name == "SupportRecipe":
            # On a dome the lowest points are the border.
            assert snapshot(shell)["Reactions"] == before["Reactions"]
        else:
            assert snapshot(shell)["NodePositions"] != before["NodePositions"]
        np.testing.assert_array_equal(array(shell.Net.SourceNodes), net_before)

    def test_a_weight_follows_an_expression(self, doc, shell):
        sheet = doc.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("A1", "=60 kg/m^2")
        doc.recompute()
        before = shell.TotalWeight.Value
        shell.setExpression("CoveringWeight", "Sheet.A1")
        assert recompute(doc) == {}
        heavier = shell.TotalWeight.Value
        assert heavier > 1.3 * before
        sheet.set("A1", "=30 kg/m^2")
        assert recompute(doc) == {}
        assert shell.TotalWeight.Value == pytest.approx(before)

    def test_the_loads_of_the_scene_are_in_si_units(self, shell):
        shell.Snow = "1 kPa"
        kinds = [type(effect).__name__ for effect in scene_of(shell).effects]
        assert kinds == ["AxialStiffness", "MemberWeight", "CoveringWeight", "Snow"]
        shell.Snow = shell.MemberWeight = 0
        kinds = [type(effect).__name__ for effect in scene_of(shell).effects]
        assert kinds == ["AxialStiffness", "CoveringWeight"]

    def test_snow_weighs_its_pressure_times_the_plan(self, doc, shell):
        shell.MemberWeight = shell.CoveringWeight = 0
        shell.Snow = "1 kPa"
        assert recompute(doc) == {}
        rim = array(shell.NodePositions)[: shell.Net.CellsU, :2] / 1000
        x, y = rim.T
        plan = 0.5 * abs((x * np.roll(y, -1) - y * np.roll(x, -1)).sum())
        assert shell.TotalWeight.getValueAs("N").Value == pytest.approx(1000 * plan, rel=1e-6)


def test_methods_agree(doc, shell):
    newton = array(shell.NodePositions)
    shell.Method, shell.Accuracy = "Relaxation", "0.001 mm"
    assert recompute(doc) == {}
    assert shell.MethodUsed == "relaxation"
    np.testing.assert_allclose(array(shell.NodePositions), newton, atol=0.01)


def test_length_matching_brings_members_nearer_to_their_lengths(doc, shell):
    before = shell.LengthDeviation
    assert before > 1e-3
    shell.LengthMatching = 3
    assert recompute(doc) == {}
    assert shell.Status == "converged"
    assert shell.LengthDeviation < 0.5 * before
    lengths = np.linalg.norm(np.diff(edge_ends(shell.Shape), axis=1)[:, 0], axis=1) / 1000
    deviation = lengths / net_of(shell.Net).source_lengths - 1
    assert shell.LengthDeviation == pytest.approx(np.sqrt(np.mean(deviation**2)), rel=1e-6)


def test_save_and_reopen(doc, shell, tmp_path):
    before = snapshot(shell)
    again = reopened(doc, tmp_path / "shell.FCStd")
    shell = again.Gridshell
    assert type(shell.Proxy).__module__ == "funicular.features.gridshell"
    assert [obj.State for obj in again.Objects] == [["Up-to-date"]] * 3
    assert again.recompute() == 0
    assert_same(snapshot(shell), before)
    assert str(shell.MemberWeight.Unit) == str(App.Units.Unit("kg/m"))
    shell.CoveringWeight = "60 kg/m^2"
    assert recompute(again) == {}
    assert shell.TotalWeight.Value > 1.3 * before["TotalWeight"]


def test_undo_and_redo(doc, shell):
    before = snapshot(shell)
    doc.UndoMode = 1
    doc.openTransaction("Weight")
    shell.CoveringWeight = "60 kg/m^2"
    doc.recompute()
    doc.commitTransaction()
    after = snapshot(shell)
    assert after["NodePositions"] != before["NodePositions"]
    doc.undo()
    assert snapshot(shell) == before
    doc.recompute()
    assert snapshot(shell)["NodePositions"] == before["NodePositions"]
    doc.redo()
    assert snapshot(shell) == after


def test_two_gridshells_share_a_net(doc, shell):
    other = make_gridshell(doc, net=shell.Net, CoveringWeight="60 kg/m^2")
    assert recompute(doc) == {}
    assert other.Net is shell.Net or other.Net.Name == shell.Net.Name
    assert other.TotalWeight.Value > 1.3 * shell.TotalWeight.Value
    shell.Net.StepU = "4 m"
    assert recompute(doc) == {}
    assert len(other.NodePositions) == len(shell.NodePositions) == shell.Net.NodeCount


def test_a_copy_shares_the_net_and_lives_its_own_life(doc, shell):
    copy = doc.copyObject(shell)
    assert copy.Net.Name == shell.Net.Name
    assert_same(snapshot(copy), snapshot(shell))
    before = snapshot(shell)
    copy.CoveringWeight = "60 kg/m^2"
    assert recompute(doc) == {}
    assert copy.TotalWeight.Value > 1.3 * shell.TotalWeight.Value
    assert snapshot(shell) == before


def test_a_copy_with_its_net_into_another_document(doc, shell):
    other = App.newDocument("Other")
    copies = other.copyObject([shell, shell.Net, shell.Net.Source[0]], False)
    copy = next(obj for obj in copies if obj.FunicularType == "Gridshell")
    assert copy.Net.Document.Name == "Other"
    copy.Net.StepV = "1 m"
    assert recompute(other) == {}
    assert len(copy.NodePositions) == copy.Net.NodeCount > shell.Net.NodeCount


def test_a_net_that_is_moved_takes_the_gridshell_along(doc, shell):
    before = array(shell.NodePositions)
    shell.Net.Placement.Base = V(5000, 0, 1000)
    assert recompute(doc) == {}
    np.testing.assert_allclose(array(shell.NodePositions), before + [5000, 0, 1000], atol=1e-3)


def test_a_placement_that_stays_upright_moves_shape_and_export_alike(doc, shell):
    before = snapshot(shell)
    part = doc.addObject("App::Part", "Part")
    part.addObject(shell)
    part.Placement.Base = V(0, 0, 3000)
    shell.Placement = App.Placement(V(5000, 0, 1000), App.Rotation(V(0, 0, 1), 30))
    assert recompute(doc) == {}
    now = snapshot(shell)
    # Nodes and reactions stay those of the gridshell before it is placed.
    np.testing.assert_allclose(now["NodePositions"], before["NodePositions"], atol=1e-6)
    np.testing.assert_allclose(now["Reactions"], before["Reactions"], atol=1e-6)
    nodes, members, _ = lattice_of(shell)
    np.testing.assert_allclose(nodes[members] * 1000 - [0, 0, 3000], now["Edges"], atol=1e-6)
    place = shell.Placement
    expected = array([place.multVec(V(*node)) for node in before["NodePositions"]])
    np.testing.assert_allclose(nodes * 1000 - [0, 0, 3000], expected, atol=1e-6)


def test_a_net_at_a_tilt_is_relaxed_under_the_vertical(doc, shell):
    shell.SupportRecipe = "Boundary"
    shell.Net.Placement.Rotation = App.Rotation(V(1, 0, 0), 5)
    assert recompute(doc) == {}
    assert shell.ReactionSum.Value == pytest.approx(shell.TotalWeight.Value, rel=1e-6)
    horizontal = array(shell.Reactions).sum(axis=0)[:2]
    assert np.abs(horizontal).max() < 1e-6 * shell.TotalWeight.Value


def test_a_gridshell_on_a_net_of_another_object(doc, box):
    net = make_net(doc, (box, ["Face6"]))
    shell = make_gridshell(doc, net=net, SupportRecipe="Corners", AxialStiffness="300 kN")
    assert recompute(doc) == {}
    held = np.flatnonzero(np.linalg.norm(array(shell.Reactions), axis=1) > 0)
    assert held.tolist() == sorted(net_of(net).lattice.corners)
    # A flat sheet rises into a shell.
    assert array(shell.NodePositions)[:, 2].max() > 3500


def test_progress_cancels_the_solve(doc, shell, monkeypatch):
    """What ESC does: the indicator raises, and the recompute fails with the last shape left."""
    from funicular.features import progress

    class Cancelling:
        def start(self, text, steps):
            assert text == "Relaxing Gridshell" and steps == 100

        def next(self, may_abort):
            raise RuntimeError("abort")

        def stop(self):
            stopped.append(True)

    stopped = []
    before = snapshot(shell)
    monkeypatch.setattr(progress, "SHOWN_AFTER", 0.0)
    monkeypatch.setattr(progress, "Indicator", Cancelling)
    shell.CoveringWeight = "60 kg/m^2"
    assert list(recompute(doc)) == ["Gridshell"]
    assert stopped == [True]
    assert_refused(shell, "the solve was cancelled and the last good shape stays; recompute to solve again")
    assert shell.Status == "cancelled"
    assert snapshot(shell)["NodePositions"] == before["NodePositions"]
    monkeypatch.undo()
    shell.touch()
    assert recompute(doc) == {}
    assert shell.Status == "converged"


def test_a_cancelled_round_of_matching_is_cancelled(doc, dome, monkeypatch):
    from funicular.features import progress

    shell = make_gridshell(doc, source=dome, StepU="3 m", StepV="2 m")
    assert recompute(doc) == {}
    begun = []

    def third_round_is_too_much(self, report):
        begun.append(report.iteration)
        return begun.count(0) < 3

    monkeypatch.setattr(progress.Progress, "__call__", third_round_is_too_much)
    shell.LengthMatching = 5
    assert list(recompute(doc)) == ["Gridshell"]
    assert shell.Status == "cancelled"


def test_the_summary_says_when_members_are_stretched_far(doc, dome):
    shell = make_gridshell(doc, source=dome, StepU="3 m", StepV="2 m", AxialStiffness="20 kN")
    assert recompute(doc) == {}
    assert shell.CompressionOnly and "times as long as on the face" in shell.Summary
    shell.AxialStiffness = "2 MN"
    assert recompute(doc) == {}
    assert "times as long" not in shell.Summary
