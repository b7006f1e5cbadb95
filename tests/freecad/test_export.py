# SPDX-License-Identifier: LGPL-2.1-or-later
"""What leaves the document: meshes and pictures of a gridshell as it is now, and of no other."""

import FreeCAD as App
import dome as dome_example
import matplotlib.image
import numpy as np
import pytest
import roof as roof_example
from matplotlib.collections import LineCollection, PolyCollection

import funicular as fn
from documents import array, recompute
from funicular import picture as picture_module
from funicular.export import export_gridshell, lattice_of
from funicular.features.net import net_of
from funicular.files import read_mesh
from funicular.make import make_gridshell
from funicular.picture import save_picture


def test_export_is_the_relaxed_lattice_in_metres(example, tmp_path):
    example.Placement.Base = App.Vector(1000, 0, 0)
    assert recompute(example.Document) == {}
    path = tmp_path / "shell.obj"
    export_gridshell(example, path)
    nodes, members, panels = read_mesh(path)
    np.testing.assert_allclose(nodes, array(example.NodePositions) / 1000 + [1, 0, 0], atol=1e-12)
    np.testing.assert_array_equal(members, net_of(example.Net).members)
    assert tuple(map(tuple, panels)) == net_of(example.Net).panels


def test_nothing_to_export_before_the_first_result(doc, box, tmp_path):
    shell = make_gridshell(doc, source=(box, "Face6"))
    for _ in range(2):
        with pytest.raises(
            fn.InvalidInput, match="Gridshell has no result for its net as it is now: recompute"
        ):
            export_gridshell(shell, tmp_path / "shell.obj")
        shell.Net.recompute()
    assert not (tmp_path / "shell.obj").exists()


class TestStaleResults:
    """Eight by six cells and six by eight have as many nodes, but not the same members."""

    @pytest.fixture
    def shell(self, doc, box):
        made = make_gridshell(doc, (box, "Face6"), StepU="1 m", StepV="1 m", AxialStiffness="300 kN")
        assert recompute(doc) == {} and made.Net.CellsU == 8
        made.Net.StepU, made.Net.StepV = 8000 / 6, 6000 / 8
        return made

    def test_a_net_that_changed_alone(self, shell, tmp_path):
        shell.Net.recompute()
        assert shell.Net.NodeCount == len(shell.NodePositions) and shell.Net.CellsU == 6
        with pytest.raises(fn.InvalidInput, match="no result for its net as it is now: recompute it first"):
            export_gridshell(shell, tmp_path / "shell.obj")
        shell.Net.purgeTouched()
        export_gridshell(shell, tmp_path / "shell.obj")
        nodes, members, _ = read_mesh(tmp_path / "shell.obj")
        lengths = np.linalg.norm(nodes[members[:, 0]] - nodes[members[:, 1]], axis=1)
        np.testing.assert_allclose(lengths, [edge.Length / 1000 for edge in shell.Shape.Edges], rtol=1e-9)

    def test_a_gridshell_that_failed(self, doc, shell, tmp_path):
        shell.CoveringWeight = "3000000 kg/m^2"
        doc.recompute()
        assert shell.Net.CellsU == 6 and len(shell.NodePositions) == shell.Net.NodeCount
        for write in (export_gridshell, save_picture):
            with pytest.raises(fn.InvalidInput, match="Gridshell has no result: No equilibrium"):
                write(shell, tmp_path / "shell.png")

    def test_a_net_that_failed(self, doc, shell):
        shell.Net.StepU = 0
        doc.recompute()
        with pytest.raises(fn.InvalidInput, match="Gridshell has no result: Net: StepU is 0 mm"):
            lattice_of(shell)

    def test_what_waits_for_a_recompute(self, shell):
        with pytest.raises(fn.InvalidInput, match="as it is now: recompute it first"):
            lattice_of(shell)


def test_the_picture_shows_the_forces(example, tmp_path):
    path = tmp_path / "shell.png"
    save_picture(example, path)
    picture = matplotlib.image.imread(path)[:, :, :3]
    assert picture.shape[0] > 1000 and picture.shape[1] > 1500
    blues = (picture[:, :, 2] > picture[:, :, 0] + 0.25).mean()
    oranges = (picture[:, :, 0] > picture[:, :, 2] + 0.35).mean()
    assert blues > 0.005
    assert oranges < 1e-4


def test_tension_is_orange_in_the_picture(doc, tmp_path):
    sphere = doc.addObject("Part::Sphere", "Sphere")
    sphere.Radius, sphere.Angle1 = 10000, 0
    doc.recompute()
    shell = make_gridshell(
        doc, source=(sphere, ["Face1"]), StepU="2 m", StepV="2 m", AxialStiffness="100 MN", AllowTension=True
    )
    assert recompute(doc) == {} and not shell.CompressionOnly
    save_picture(shell, tmp_path / "shell.png")
    picture = matplotlib.image.imread(tmp_path / "shell.png")[:, :, :3]
    assert (picture[:, :, 0] > picture[:, :, 2] + 0.35).mean() > 0.005


@pytest.fixture
def drawn(monkeypatch):
    """What is drawn of a gridshell: a function that returns the matplotlib figure."""

    def draw(shell, **view):
        figures = []
        monkeypatch.setattr(picture_module.Figure, "savefig", lambda figure, *_, **__: figures.append(figure))
        save_picture(shell, "shell.png", **view)
        return figures[0]

    return draw


def collections_of(figure, kind):
    return [each for each in figure.axes[0].collections if type(each) is kind]


def test_no_panel_lies_on_a_member_that_it_bounds(example, drawn):
    """A veil over half of a stroke would show two forces where there is one."""
    figure = drawn(example)
    members = [each for each in collections_of(figure, LineCollection) if each.get_zorder() > 1]
    panels = collections_of(figure, PolyCollection)
    assert sum(len(each.get_segments()) for each in members) == example.Net.MemberCount
    assert sum(len(each.get_paths()) for each in panels) == example.Net.PanelCount
    behind, front = sorted(panels, key=lambda each: each.get_zorder())
    assert len(front.get_paths()) > len(behind.get_paths()) > 0
    layers = {each.get_zorder() for each in members}
    assert len(layers) == 2
    assert behind.get_zorder() < min(layers) < front.get_zorder() < max(layers)


def test_from_above_all_of_a_roof_lies_in_front(doc, drawn):
    figure = drawn(roof_example.build(doc), elevation=90.0)
    behind, front = sorted(collections_of(figure, PolyCollection), key=lambda each: each.get_zorder())
    assert len(behind.get_paths()) == 0 and len(front.get_paths()) > 0


def test_supports_behind_the_shell_are_veiled_by_it(doc, drawn):
    figure = drawn(dome_example.build(doc))
    front_panels = max(each.get_zorder() for each in collections_of(figure, PolyCollection))
    supports = [each for each in figure.axes[0].collections if each.get_offsets().shape[0] > 1]
    below = [each for each in supports if each.get_zorder() < front_panels]
    assert sum(len(each.get_offsets()) for each in supports) == 32
    assert 4 <= sum(len(each.get_offsets()) for each in below) <= 16


def test_slack_members_are_dashed_and_the_key_says_so(doc, drawn):
    shell = dome_example.build(doc)
    assert len(shell.SlackMembers) == 32
    figure = drawn(shell)
    solid = (0.0, None)
    dashed = [each for each in collections_of(figure, LineCollection) if each.get_linestyle() != [solid]]
    assert sum(len(each.get_segments()) for each in dashed) == 32
    keys = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert keys == ["stands here", "slack, without force"]


def test_without_slack_members_the_key_has_none(doc, drawn):
    shell = roof_example.build(doc)
    assert list(shell.SlackMembers) == []
    keys = [text.get_text() for text in drawn(shell).axes[0].get_legend().get_texts()]
    assert keys == ["stands here", "held sideways only"]


def test_long_sentences_stay_within_the_picture(doc, drawn):
    shell = roof_example.build(doc)
    shell.Label = "Roof of the hall that stands between the two courtyards of the school at the river"
    figure = drawn(shell)
    renderer = figure.canvas.get_renderer()
    extents = [text.get_window_extent(renderer) for text in figure.texts]
    assert len(extents) == 4
    assert max(extent.x1 for extent in extents) < figure.bbox.width
    assert all(low.y1 < high.y0 for high, low in zip(extents, extents[1:]))
    assert figure.axes[0].get_position().y1 * figure.bbox.height < extents[-1].y0 + 1
