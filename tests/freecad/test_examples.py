# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples, their pictures and their meshes."""

import FreeCAD as App
import Part
import dome as dome_example
import matplotlib.image
import numpy as np
import pytest
import roof as roof_example
import run_demo

import funicular as fn
from documents import array, recompute
from funicular.export import export_gridshell, lattice_of
from funicular.features.net import net_of
from funicular.files import read_mesh
from funicular.make import make_gridshell
from funicular.picture import save_picture

EXAMPLES = {"dome": dome_example, "roof": roof_example}


@pytest.fixture(params=EXAMPLES)
def example(request, doc):
    shell = EXAMPLES[request.param].build(doc)
    assert recompute(doc) == {}
    return shell


def test_examples_stand_in_compression(example):
    assert example.Status == "converged"
    assert example.CompressionOnly and list(example.TensionMembers) == []
    assert example.PositionError.getValueAs("mm").Value < 1.0
    assert example.ReactionSum.Value == pytest.approx(example.TotalWeight.Value, rel=1e-6)


def test_the_dome_is_round(doc):
    shell = dome_example.build(doc)
    nodes = array(shell.NodePositions)
    radius, height = np.hypot(nodes[:, 0], nodes[:, 1]), nodes[:, 2]
    for ring in np.unique(np.round(height, 3)):
        assert np.ptp(radius[np.abs(height - ring) < 0.01]) < 0.01
    assert radius.max() == pytest.approx(dome_example.SPAN / 2, rel=1e-9)
    assert shell.Net.Poles == ["v_max"] and shell.Net.ClosedU


def test_the_roof_stands_on_its_corners_and_its_borders_stay_in_their_planes(doc):
    shell = roof_example.build(doc)
    nodes, reactions = array(shell.NodePositions), array(shell.Reactions)
    lattice = net_of(shell.Net).lattice
    corners = sorted(lattice.corners)
    upwards = np.flatnonzero(np.abs(reactions[:, 2]) > 1e-6)
    assert upwards.tolist() == corners
    for side, axis, value in (
        ("u_min", 0, 0.0),
        ("u_max", 0, roof_example.LENGTH),
        ("v_min", 1, 0.0),
        ("v_max", 1, roof_example.WIDTH),
    ):
        np.testing.assert_allclose(nodes[lattice.sides[side], axis], value, atol=1e-6)
        # A plane holds at right angles to itself only.
        assert np.abs(reactions[lattice.sides[side][1:-1], 1 - axis]).max() < 1e-6


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
def demo_folder(doc, tmp_path, monkeypatch):
    monkeypatch.setattr(run_demo, "ROOT", tmp_path)
    monkeypatch.setattr(run_demo, "FOLDER", tmp_path / "demo")
    return tmp_path / "demo"


def test_the_demo_writes_its_files_and_one_table(demo_folder, capfd):
    assert run_demo.main() == 0
    written = {path.name for path in demo_folder.iterdir()}
    assert written == {f"{name}.{kind}" for name in EXAMPLES for kind in ("FCStd", "obj", "png")}
    lines = [
        line for line in capfd.readouterr().out.splitlines() if line.startswith(("example", "dome", "roof"))
    ]
    assert [line.split()[0] for line in lines] == ["example", "dome", "roof"]
    assert all(len(line) == len(lines[0]) and "compression only" in line for line in lines[1:])


def test_the_demo_fails_when_an_example_does(demo_folder, capfd, monkeypatch):
    def build(doc):
        shell = dome_example.build(doc)
        shell.Net.StepU = 0
        doc.recompute()
        return shell

    monkeypatch.setattr(run_demo, "dome", type("Broken", (), {"build": staticmethod(build)}))
    assert run_demo.main() == 1
    assert "Net: StepU is 0 mm: give a length greater than zero" in capfd.readouterr().err
    assert not (demo_folder / "dome.obj").exists() and (demo_folder / "roof.obj").exists()


def test_the_demo_fails_when_a_shell_pulls(demo_folder, capfd, monkeypatch):
    def build(doc):
        shell = dome_example.build(doc)
        shell.AllowTension, shell.AxialStiffness = True, "100 MN"
        shell.Net.Source[0].Shape = hemisphere()
        doc.recompute()
        return shell

    monkeypatch.setattr(run_demo, "dome", type("Pulling", (), {"build": staticmethod(build)}))
    assert run_demo.main() == 1
    assert "members in tension" in capfd.readouterr().err


def hemisphere():
    return Part.makeSphere(10000, App.Vector(), App.Vector(0, 0, 1), 0, 90, 360).Faces[0]
