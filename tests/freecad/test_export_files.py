# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for other programs, read again: the same net, in equilibrium; tables that balance; File > Export."""

import csv
import importlib
import os
import pathlib
import subprocess
import sys

import FreeCAD as App
import numpy as np
import pytest
import roof as roof_example

import funicular as fn
from documents import array, recompute
from funicular.export import export, export_covering, export_gridshell, export_tables, lattice_of
from funicular.features.gridshell import scene_of
from funicular.features.net import net_of
from funicular.files import read_mesh
from funicular.make import make_covering, make_gridshell

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("suffix", ["obj", "ply"])
def test_what_is_read_again_is_the_same_net_in_equilibrium(example, suffix, tmp_path):
    example.Placement.Base = App.Vector(12345.678, -987.654, 321.0)
    assert recompute(example.Document) == {}
    path = tmp_path / f"shell.{suffix}"
    export_gridshell(example, path)
    net = fn.Net.read(path)
    nodes, members, panels = lattice_of(example)
    np.testing.assert_array_equal(net.nodes, nodes)
    np.testing.assert_array_equal(net.members, members)
    assert net.panels == panels

    found = scene_of(example)
    scene = fn.Scene(net, found.supports, found.effects, rest_lengths=found.net.source_lengths)
    certificate = fn.certify(scene, net.nodes, tolerance=1e-5)
    assert certificate.in_equilibrium and certificate.compression_only, certificate.summary()
    assert list(certificate.slack_members) == list(example.SlackMembers)
    moved = net.nodes.copy()
    moved[len(moved) // 2, 2] += 0.001
    assert not fn.certify(scene, moved, tolerance=1e-5).in_equilibrium


class TestPanels:
    @pytest.mark.parametrize("suffix", ["obj", "ply", "off"])
    def test_they_are_the_gridshells_number_by_number(self, example, suffix, tmp_path):
        covering = make_covering(example.Document, example)
        assert recompute(example.Document) == {}
        nodes, members, panels = lattice_of(example)
        for obj in (example, covering):
            path = tmp_path / f"{obj.Name}.{suffix}"
            export_covering(obj, path)
            net = fn.Net.read(path)
            np.testing.assert_array_equal(net.nodes, nodes)
            assert net.panels == panels
            # Each side of a panel is a member of both examples, though in an order of its own.
            assert {frozenset(pair) for pair in net.members.tolist()} == set(map(frozenset, members.tolist()))

    def test_members_on_no_panel_are_left_out(self, doc, box, tmp_path):
        shell = make_gridshell(
            doc, (box, "Face6"), StepU="1 m", StepV="1 m", Pattern="Crossed", AxialStiffness="300 kN"
        )
        assert recompute(doc) == {}
        with pytest.raises(ValueError, match="this format holds only panels"):
            export_gridshell(shell, tmp_path / "shell.off")
        export_covering(shell, tmp_path / "shell.off")
        net = fn.Net.read(tmp_path / "shell.off")
        assert net.panels == net_of(shell.Net).panels and len(net.members) < shell.Net.MemberCount

    def test_triangles_are_written_as_triangles(self, doc, tmp_path):
        shell = roof_example.build(doc)
        covering = make_covering(doc, shell, Kind="Triangles")
        assert recompute(doc) == {} and covering.WarpedPanels
        nodes, _, panels = lattice_of(shell)
        for suffix in ("off", "stl"):
            path = tmp_path / f"roof.{suffix}"
            export_covering(covering, path)
            points, _, cut = read_mesh(path)
            assert len(cut) == sum(map(len, panels))
            corners = points[np.array(cut)]
            normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            area = 0.5 * np.linalg.norm(normals, axis=1).sum()
            assert area == pytest.approx(covering.Area.Value / 1e6, rel=1e-12)
            assert (normals[:, 2] > 0.0).all()
        np.testing.assert_array_equal(read_mesh(tmp_path / "roof.off")[0][: len(nodes)], nodes)

    def test_what_is_not_up_to_date_writes_nothing(self, doc, box, tmp_path):
        shell = make_gridshell(doc, (box, "Face6"), AxialStiffness="300 kN")
        covering = make_covering(doc, shell)
        assert recompute(doc) == {}
        covering.PlanarTolerance = "3 mm"
        with pytest.raises(
            fn.InvalidInput, match="Covering is not that of Gridshell as it is now: recompute"
        ):
            export_covering(covering, tmp_path / "shell.obj")
        shell.Snow = "1 kPa"
        for obj in (shell, covering):
            with pytest.raises(fn.InvalidInput, match="Gridshell has no result for its net as it is now"):
                export_covering(obj, tmp_path / "shell.obj")
        assert list(tmp_path.iterdir()) == []

    def test_a_gridshell_without_panels(self, doc, box, tmp_path):
        shell = make_gridshell(doc, (box, "Face6"), AxialStiffness="300 kN")
        assert recompute(doc) == {}
        shell.Panels = []
        shell.purgeTouched()
        with pytest.raises(fn.InvalidInput, match="Gridshell has no panels: export its members instead"):
            export_covering(shell, tmp_path / "shell.obj")


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def columns(table, *names):
    """(rows, names) array of the numbers in some columns."""
    return np.array([[float(row[name]) for name in names] for row in table])


class TestTables:
    def test_every_number_comes_back_as_the_same_float(self, example, tmp_path):
        paths = export_tables(example, tmp_path / "shell")
        assert paths == (str(tmp_path / "shell-members.csv"), str(tmp_path / "shell-nodes.csv"))
        of_members, of_nodes = map(read_table, paths)
        nodes, members, _ = lattice_of(example)
        assert list(of_members[0])[:3] == ["member", "node a", "node b"]
        assert [int(row["member"]) for row in of_members] == list(range(len(members)))
        np.testing.assert_array_equal(columns(of_members, "node a", "node b"), members)
        np.testing.assert_array_equal(columns(of_members, "force [N]")[:, 0], example.MemberForces)
        np.testing.assert_array_equal(
            columns(of_members, "source length [m]")[:, 0], net_of(example.Net).source_lengths
        )
        np.testing.assert_allclose(
            columns(of_members, "length [m]")[:, 0],
            [edge.Length / 1000 for edge in example.Shape.Edges],
            rtol=1e-9,
        )
        np.testing.assert_array_equal(columns(of_nodes, "x [m]", "y [m]", "z [m]"), nodes)
        reactions = columns(of_nodes, "reaction x [N]", "reaction y [N]", "reaction z [N]")
        np.testing.assert_array_equal(reactions, array(example.Reactions))

    def test_slack_members_and_supports_are_marked(self, example, tmp_path):
        of_members, of_nodes = map(read_table, export_tables(example, tmp_path / "shell"))
        slack = [number for number, row in enumerate(of_members) if row["slack"] == "yes"]
        assert slack == list(example.SlackMembers)
        assert {of_members[number]["force [N]"] for number in slack} <= {"0.0"}
        supported = {number for number, row in enumerate(of_nodes) if row["support"] == "yes"}
        # The dome stands on its whole border, the roof on corners and is held sideways along its borders.
        assert supported == set(net_of(example.Net).border.tolist())
        assert {row["support"] for row in of_nodes} == {"yes", "no"} >= {row["slack"] for row in of_members}

    @pytest.mark.parametrize("allow_tension", [False, True])
    def test_forces_reactions_and_weights_balance_at_every_node(self, doc, dome, allow_tension, tmp_path):
        """From the files alone, and the weights per metre and per square metre that were asked for."""
        shell = make_gridshell(
            doc,
            source=dome,
            StepU="2 m",
            StepV="1.5 m",
            MemberWeight="11 kg/m",
            CoveringWeight="23 kg/m^2",
            CoveringShare="Equal",
            AxialStiffness="200 kN",
            AllowTension=allow_tension,
        )
        shell.Placement = App.Placement(App.Vector(7000, -4000, 1000), App.Rotation(App.Vector(0, 0, 1), 40))
        assert recompute(doc) == {}
        of_members, of_nodes = map(read_table, export_tables(shell, tmp_path / "dome"))
        export_covering(shell, tmp_path / "dome.off")
        _, _, panels = read_mesh(tmp_path / "dome.off")

        nodes = columns(of_nodes, "x [m]", "y [m]", "z [m]")
        a, b = columns(of_members, "node a", "node b").astype(int).T
        lengths = columns(of_members, "length [m]")
        np.testing.assert_allclose(lengths[:, 0], np.linalg.norm(nodes[b] - nodes[a], axis=1), rtol=1e-12)
        loads = np.zeros_like(nodes)
        for end in (a, b):
            np.add.at(loads[:, 2], end, -0.5 * 9.80665 * 11.0 * lengths[:, 0])
        for panel in map(list, panels):
            spokes = nodes[panel] - nodes[panel].mean(axis=0)
            doubled = np.linalg.norm(np.cross(spokes, np.roll(spokes, -1, axis=0)), axis=1).sum()
            loads[panel, 2] -= 9.80665 * 23.0 * 0.5 * doubled / len(panel)
        pulls = columns(of_members, "force [N]") * (nodes[b] - nodes[a]) / lengths
        unbalanced = loads + columns(of_nodes, "reaction x [N]", "reaction y [N]", "reaction z [N]")
        np.add.at(unbalanced, a, pulls)
        np.add.at(unbalanced, b, -pulls)
        mean_load = -loads[:, 2].mean()
        assert np.linalg.norm(unbalanced, axis=1).max() < 1e-5 * mean_load < np.abs(pulls).max()
        assert loads[:, 2].sum() == pytest.approx(-shell.TotalWeight.getValueAs("N").Value, rel=1e-9)

    def test_a_net_that_changed_alone_is_refused(self, doc, box, tmp_path):
        """Its lengths are no longer those that the members had before relaxation."""
        shell = make_gridshell(doc, (box, "Face6"), StepU="1 m", StepV="1 m", AxialStiffness="300 kN")
        assert recompute(doc) == {}
        shell.Net.StepU = "2 m"
        shell.Net.recompute()
        for _ in range(2):
            with pytest.raises(fn.InvalidInput, match="Gridshell has no result for its net as it is now"):
                export_tables(shell, tmp_path / "shell")
            shell.Net.purgeTouched()
            shell.purgeTouched()
        assert list(tmp_path.iterdir()) == []


class TestFileExport:
    """As FreeCAD calls it: export(objects, filename) of the module that Init.py names."""

    @pytest.fixture
    def shell(self, doc, box):
        made = make_gridshell(doc, (box, "Face6"), StepU="1 m", StepV="1 m", AxialStiffness="300 kN")
        make_covering(doc, made)
        assert recompute(doc) == {}
        return made

    @pytest.mark.parametrize("suffix", ["obj", "ply", "stl", "off", "OBJ"])
    def test_a_gridshell_or_its_covering_in_every_mesh_format(self, doc, shell, suffix, tmp_path):
        of_shell, of_covering = (str(tmp_path / f"{name}.{suffix}") for name in ("shell", "covering"))
        module = importlib.import_module("funicular.export")
        module.export([shell], of_shell)
        module.export((doc.Covering,), of_covering)
        assert sorted(os.listdir(tmp_path)) == [f"covering.{suffix}", f"shell.{suffix}"]
        for path, write, obj in (
            (of_shell, export_gridshell, shell),
            (of_covering, export_covering, doc.Covering),
        ):
            same = str(tmp_path / f"same.{suffix}")
            write(obj, same)
            assert pathlib.Path(path).read_bytes() == pathlib.Path(same).read_bytes()

    def test_a_gridshell_as_tables(self, shell, tmp_path):
        export([shell], str(tmp_path / "roof.csv"))
        assert sorted(os.listdir(tmp_path)) == ["roof-members.csv", "roof-nodes.csv"]
        assert len(read_table(tmp_path / "roof-members.csv")) == shell.Net.MemberCount

    @pytest.mark.parametrize(
        "names, file, sentence",
        [
            (["Box"], "roof.obj", "^Box is neither a Gridshell nor a Covering, so roof.obj was not written"),
            (["Gridshell", "Net"], "roof.obj", "^Net is neither a Gridshell nor a Covering"),
            (["Covering"], "roof.csv", "^Covering has no members that roof.csv could list: select its Gri"),
            (["Gridshell", "Covering"], "roof.obj", "^roof.obj takes one .*, but Gridshell, Covering is"),
            ([], "roof.obj", "^roof.obj takes one Gridshell or Covering, but nothing is selected"),
            (["Gridshell"], "roof.dxf", "roof.dxf: the suffix '.dxf' is not one of .obj"),
        ],
    )
    def test_what_cannot_be_written_is_named(self, doc, shell, names, file, sentence, tmp_path):
        with pytest.raises(ValueError, match=sentence):
            export([doc.getObject(name) for name in names], str(tmp_path / file))
        assert os.listdir(tmp_path) == []

    def test_freecad_offers_it_beside_its_own(self, tmp_path):
        script = tmp_path / "types.py"
        script.write_text(TYPES.format(root=str(ROOT), folder=str(tmp_path)), "utf-8")
        run = subprocess.run(
            [sys.executable, str(ROOT / "tools" / "freecad_run.py"), str(script)],
            capture_output=True,
            text=True,
            timeout=120,
        )
        assert run.returncode == 0, run.stderr
        for suffix in ("obj", "ply", "stl", "off", "csv"):
            assert f"OFFERED {suffix} True" in run.stdout
        for suffix in ("obj", "ply", "stl", "off"):
            assert f"MESH {suffix} True" in run.stdout
        assert (tmp_path / "own.obj").read_text().count("\nf ") == 12


TYPES = """
import runpy, sys
import FreeCAD as App, Mesh
sys.path.insert(0, {root!r})
runpy.run_path({root!r} + "/Init.py")
for suffix in ("obj", "ply", "stl", "off", "csv"):
    print("OFFERED", suffix, "funicular.export" in App.getExportType(suffix))
    print("MESH", suffix, "Mesh" in App.getExportType(suffix))
box = App.newDocument().addObject("Part::Box", "Box")
App.ActiveDocument.recompute()
Mesh.export([box], {folder!r} + "/own.obj")
"""
