# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a Net in the document may lie on besides faces: a flat sheet, a mesh, a mesh file, edges."""

import random

import FreeCAD as App
import Mesh
import numpy as np
import Part
import pytest

import funicular as fn
from documents import array, assert_refused, recompute, reopened
from funicular.features.net import net_of
from funicular.make import make_gridshell, make_net, make_support

V = App.Vector


def mesh_object(doc, points, facets):
    obj = doc.addObject("Mesh::Feature", "Mesh")
    mesh = Mesh.Mesh()
    mesh.addFacets(([V(*point) for point in points.tolist()], facets))
    obj.Mesh = mesh
    return obj


def hill(side=7):
    """(points [mm], triangles) of a low hill."""
    sheet = fn.Net.grid(6, 6, 6 / (side - 1))
    points = sheet.nodes * 1000
    points[:, 2] = 800 * np.sin(np.pi * points[:, 0] / 6000) * np.sin(np.pi * points[:, 1] / 6000)
    facets = [corner for a, b, c, d in sheet.panels for corner in ((a, b, c), (a, c, d))]
    return points, facets


def grid_of_lines(count=4):
    lines = [Part.makeLine((k * 1000, 0, 0), (k * 1000, count * 1000, 0)) for k in range(count + 1)]
    lines += [Part.makeLine((0, k * 1000, 0), (count * 1000, k * 1000, 0)) for k in range(count + 1)]
    return Part.Compound(lines)


class TestSheet:
    def test_a_flat_sheet_of_given_size(self, doc):
        net = make_net(doc, Width="8 m", Depth="6 m")
        assert recompute(doc) == {}
        assert (net.CellsU, net.CellsV) == (8, 6)
        size = array(net.SourceNodes).ptp(axis=0)
        assert size.tolist() == [8000, 6000, 0]
        net.Width, net.StepV = "4 m", "2 m"
        assert recompute(doc) == {}
        assert (net.CellsU, net.CellsV) == (4, 3)

    @pytest.mark.parametrize("pattern", ["Quad", "Triangle", "Kagome"])
    def test_it_rises_into_a_shell_and_its_edges_can_be_held(self, doc, pattern):
        shell = make_gridshell(doc, Width="8 m", Depth="6 m", Pattern=pattern, SupportRecipe="Corners")
        make_support(doc, shell, Where="Edges and vertices", Elements=["Edge1"])
        assert recompute(doc) == {}
        assert shell.Status == "converged" and shell.CompressionOnly
        assert shell.Shape.BoundBox.ZMax > 500

    def test_half_a_size_is_named(self, doc):
        net = make_net(doc, Width="8 m")
        recompute(doc)
        assert_refused(net, "Depth is 0 mm: a flat sheet needs a Width and a Depth")


class TestMesh:
    def test_a_mesh_is_taken_vertex_by_vertex_and_edge_by_edge(self, doc):
        points, facets = hill()
        net = make_net(doc, mesh_object(doc, points, facets))
        assert recompute(doc) == {}
        made = net_of(net)
        assert np.abs(made.nodes * 1000 - points).max() < 1e-3, "FreeCAD's meshes hold single precision"
        assert [tuple(panel) for panel in made.panels] == facets
        edges = {tuple(sorted(pair)) for a, b, c in facets for pair in ((a, b), (b, c), (c, a))}
        assert {tuple(sorted(member)) for member in made.members.tolist()} == edges
        assert len(made.members) == len(edges) and net.Remarks == ""

    def test_it_stands_and_follows_its_mesh(self, doc, tmp_path):
        points, facets = hill()
        source = mesh_object(doc, points, facets)
        shell = make_gridshell(doc, source)
        assert recompute(doc) == {}
        assert shell.Status == "converged" and shell.CompressionOnly
        source.Placement.Base = V(0, 0, 5000)
        assert recompute(doc) == {}
        assert min(node.z for node in shell.NodePositions) == pytest.approx(5000, abs=1)
        again = reopened(doc, tmp_path / "mesh.FCStd")
        assert len(again.Gridshell.Shape.Edges) == len(net_of(again.Net).members)

    def test_nodes_keep_their_numbers_for_supports(self, doc):
        points, facets = hill()
        shell = make_gridshell(doc, mesh_object(doc, points, facets), SupportRecipe="None")
        make_support(doc, shell, Where="Nodes", Nodes=[0, 6, 42, 48])
        assert recompute(doc) == {}
        moved = np.linalg.norm(array(shell.NodePositions) - array(shell.Net.SourceNodes), axis=1)
        assert np.flatnonzero(moved < 1e-9).tolist() == [0, 6, 42, 48]

    def test_what_was_repaired_is_told(self, doc):
        points, facets = hill()
        facets[3] = facets[3][::-1]
        net = make_net(doc, mesh_object(doc, points, facets))
        assert recompute(doc) == {}
        assert "turned" in net.Remarks

    def test_a_mesh_in_two_parts_is_refused_with_their_sizes(self, doc):
        points, facets = hill()
        both = np.vstack([points, points + (0, 9000, 0)])
        more = [tuple(corner + len(points) for corner in facet) for facet in facets]
        net = make_net(doc, mesh_object(doc, both, facets + more))
        recompute(doc)
        assert_refused(net, "2 components", "49")


class TestFile:
    @pytest.mark.parametrize("suffix", ["obj", "ply", "off"])
    def test_quads_stay_quads(self, doc, tmp_path, suffix):
        sheet = fn.Net.grid(6, 4, 1)
        path = str(tmp_path / f"sheet.{suffix}")
        sheet.write(path)
        shell = make_gridshell(doc, File=path, SupportRecipe="Corners")
        assert recompute(doc) == {}
        made = net_of(shell.Net)
        assert {len(panel) for panel in made.panels} == {4} and len(made.nodes) == 35
        np.testing.assert_allclose(made.nodes, sheet.nodes, atol=1e-12)
        assert shell.Status == "converged"

    def test_a_wrong_file_names_itself(self, doc, tmp_path):
        path = tmp_path / "wrong.obj"
        path.write_text("v 0 0 0\nv 1 0 0\nf 1 2 9\n")
        net = make_net(doc, File=str(path))
        recompute(doc)
        assert_refused(net, "wrong.obj:3: face 0 names vertex 8")
        net.File = str(tmp_path / "none.obj")
        recompute(doc)
        assert_refused(net, "none.obj")

    def test_damaged_files_end_in_a_sentence_and_never_in_a_crash(self, doc, tmp_path):
        rng = random.Random(2009)
        sheet = fn.Net.grid(3, 2, 1)
        whole = {}
        for suffix in ("obj", "ply", "off", "stl"):
            path = tmp_path / f"whole.{suffix}"
            sheet.write(str(path))
            whole[suffix] = path.read_bytes()
        net = make_net(doc, File=str(tmp_path / "whole.obj"))
        assert recompute(doc) == {}
        refused = 0
        for number in range(120):
            suffix = rng.choice(list(whole))
            content = bytearray(whole[suffix])
            for _ in range(rng.randint(1, 4)):
                at = rng.randrange(len(content))
                change = rng.randrange(3)
                if change == 0:
                    content[at] = rng.randrange(256)
                elif change == 1:
                    del content[at : at + rng.randint(1, 40)]
                else:
                    content[at:at] = rng.choice([b"9", b"-", b" nan ", b"\n", b"1e400 ", bytes(3)])
            path = tmp_path / f"damaged{number}.{suffix}"
            path.write_bytes(bytes(content))
            net.File = str(path)
            doc.recompute()
            if net.isValid():
                assert net.NodeCount == len(net_of(net).nodes) > 1
            else:
                refused += 1
                assert path.name in net.getStatusString(), net.getStatusString()
        assert 30 < refused < 120


class TestEdges:
    def test_lines_that_cross_become_a_net_with_panels(self, doc):
        source = doc.addObject("Part::Feature", "Lines")
        source.Shape = grid_of_lines()
        shell = make_gridshell(doc, source)
        assert recompute(doc) == {}
        assert (shell.Net.NodeCount, shell.Net.MemberCount, shell.Net.PanelCount) == (25, 40, 16)
        assert "where edges cross" in shell.Net.Remarks
        assert shell.Status == "converged" and shell.CompressionOnly

    def test_an_edge_of_the_source_can_be_held(self, doc):
        source = doc.addObject("Part::Feature", "Lines")
        source.Shape = grid_of_lines()
        shell = make_gridshell(doc, source, SupportRecipe="Corners")
        support = make_support(doc, shell, Where="Edges and vertices", Elements=["Edge3"])
        assert recompute(doc) == {}
        assert (array(shell.Net.SourceNodes)[support.HeldNodes][:, 0] == 2000).all()

    def test_curves_are_divided_by_chords(self, doc):
        arc = Part.Arc(V(0, 0, 0), V(3000, 0, 1000), V(6000, 0, 0)).toShape()
        source = doc.addObject("Part::Feature", "Arc")
        source.Shape = Part.Compound([arc])
        net = make_net(doc, source)
        assert recompute(doc) == {} and net.MemberCount == 1
        net.Chord = "500 mm"
        assert recompute(doc) == {}
        assert net.MemberCount == 13
        lengths = [edge.Length for edge in net.Shape.Edges]
        assert max(lengths) <= 500 and max(lengths) < 1.001 * min(lengths)

    def test_some_edges_of_a_body(self, doc, box):
        top = [
            f"Edge{k}"
            for k, edge in enumerate(box.Shape.Edges, 1)
            if all(vertex.Z == 3000 for vertex in edge.Vertexes)
        ]
        net = make_net(doc, (box, top))
        assert recompute(doc) == {}
        assert (net.NodeCount, net.MemberCount, net.PanelCount) == (4, 4, 1)


def test_a_net_may_change_what_it_lies_on(doc, box):
    shell = make_gridshell(doc, (box, ["Face6"]), SupportRecipe="Corners")
    assert recompute(doc) == {}
    points, facets = hill()
    source = mesh_object(doc, points, facets)
    for other, count in ((source, 49), ((box, ["Face6"]), 63), (None, 63), (source, 49)):
        if other is None:
            shell.Net.Source, shell.Net.Width, shell.Net.Depth = None, 8000, 6000
        else:
            shell.Net.Source = other if isinstance(other, tuple) else (other, [""])
        assert recompute(doc) == {}
        assert shell.Net.NodeCount == len(shell.NodePositions) == count
        assert shell.Status == "converged"
