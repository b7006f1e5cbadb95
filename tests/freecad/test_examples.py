# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples stand as they should, and the demo tells it."""

import FreeCAD as App
import Part
import dome as dome_example
import numpy as np
import pytest
import roof as roof_example
import run_demo
from documents import array
from funicular.features.net import net_of


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
    assert shell.Net.CellsU == 32


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


@pytest.fixture
def demo_folder(doc, tmp_path, monkeypatch):
    monkeypatch.setattr(run_demo, "ROOT", tmp_path)
    monkeypatch.setattr(run_demo, "FOLDER", tmp_path / "demo")
    return tmp_path / "demo"


def test_the_demo_writes_its_files_and_one_table(demo_folder, capfd):
    assert run_demo.main() == 0
    written = {path.name for path in demo_folder.iterdir()}
    assert written == {f"{name}.{kind}" for name in ("dome", "roof") for kind in ("FCStd", "obj", "png")}
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
