# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh objects of a document become nets, vertex for vertex, where they stand."""

import FreeCAD as App
import Mesh
import numpy as np
import pytest

import funicular as fn
from documents import array
from funicular.mesh_source import mesh_of, net_of_mesh


def dome_mesh(rings=6, around=16, radius=8000.0):
    """(points, facets) of a spherical cap above 20 degrees, in triangles; first its rim, last its pole."""
    heights = np.radians(20.0 + 70.0 * np.arange(rings) / rings)
    angles = 2.0 * np.pi * np.arange(around) / around
    points = [
        (radius * np.cos(h) * np.cos(a), radius * np.cos(h) * np.sin(a), radius * np.sin(h))
        for h in heights
        for a in angles
    ]
    facets = []
    for k in range(rings - 1):
        for i in range(around):
            a, b = k * around + i, k * around + (i + 1) % around
            facets += [(a, b, b + around), (a, b + around, a + around)]
    last = (rings - 1) * around
    facets += [(last + i, last + (i + 1) % around, rings * around) for i in range(around)]
    return np.array([*points, (0.0, 0.0, radius)]), facets


def mesh_object(doc, points, facets):
    obj = doc.addObject("Mesh::Feature", "Roof")
    mesh = Mesh.Mesh()
    mesh.addFacets(([App.Vector(*point) for point in points], facets))
    obj.Mesh = mesh
    return obj


@pytest.fixture
def roof(doc):
    return mesh_object(doc, *dome_mesh())


def test_a_mesh_keeps_its_numbering(roof):
    points, facets = dome_mesh()
    read_points, read_facets = mesh_of(roof, "Source Roof")
    # FreeCAD's meshes are in single precision.
    np.testing.assert_allclose(read_points, points, atol=1e-3)
    assert [tuple(facet) for facet in read_facets] == facets
    mesh = net_of_mesh(read_points, read_facets, "Source Roof")
    np.testing.assert_array_equal(mesh.numbers, range(97))
    assert mesh.panels == tuple(facets) and mesh.remarks == []
    assert len(mesh.members) == 97 + 176 - 1  # a disk: V - E + F = 1
    assert [rim.tolist() for rim in mesh.rims] == [list(range(16))]


def test_a_mesh_is_read_where_it_stands_in_its_container(doc, roof):
    points, _ = mesh_of(roof, "Source Roof")
    roof.Placement = App.Placement(App.Vector(10.0, 20.0, 30.0), App.Rotation(App.Vector(0, 0, 1), 90))
    part = doc.addObject("App::Part", "Part")
    part.addObject(roof)
    part.Placement = App.Placement(App.Vector(0.0, 0.0, 5000.0), App.Rotation(App.Vector(1, 0, 0), 180))
    doc.recompute()
    placed, _ = mesh_of(roof, "Source Roof")
    # A quarter turn about z, a shift, half a turn about x, a lift.
    turned = np.column_stack([-points[:, 1], points[:, 0], points[:, 2]]) + [10.0, 20.0, 30.0]
    np.testing.assert_allclose(placed, turned * [1, -1, -1] + [0, 0, 5000], atol=1e-9)
    np.testing.assert_allclose(array(roof.Mesh.Topology[0]), turned, atol=1e-9)


def test_a_mesh_with_points_that_no_facet_has_loses_them(doc):
    points, facets = dome_mesh()
    shifted = [tuple(corner + (corner >= 5) for corner in facet) for facet in facets]
    obj = mesh_object(doc, np.vstack([points[:5], [[0, 0, -1e4]], points[5:]]), shifted)
    mesh = net_of_mesh(*mesh_of(obj, "Source Roof"), "Source Roof")
    np.testing.assert_array_equal(mesh.numbers, [*range(5), *range(6, 98)])
    assert mesh.panels == tuple(facets)
    assert mesh.remarks == ["1 vertex on no facet is left out (first: 5)."]


def test_what_is_no_mesh_is_refused(doc, box):
    for wrong in (box, None):
        with pytest.raises(fn.InvalidInput, match="Source Box is not a mesh"):
            mesh_of(wrong, "Source Box")
    with pytest.raises(fn.InvalidInput, match="Source Empty has no facets"):
        mesh_of(doc.addObject("Mesh::Feature", "Empty"), "Source Empty")


def test_a_mesh_in_pieces_is_refused(doc):
    points, facets = dome_mesh()
    mesh = Mesh.Mesh()
    for shift in (0.0, 3e4):
        piece = Mesh.Mesh()
        piece.addFacets(([App.Vector(x + shift, y, z) for x, y, z in points], facets))
        mesh.addMesh(piece)
    obj = doc.addObject("Mesh::Feature", "Two")
    obj.Mesh = mesh
    with pytest.raises(fn.InvalidInput, match="has 2 components, of 97 and 97 vertices"):
        net_of_mesh(*mesh_of(obj, "Source Two"), "Source Two")


def test_a_dome_of_triangles_stands_on_its_rim(roof):
    mesh = net_of_mesh(*mesh_of(roof, "Source Roof"), "Source Roof")
    net = fn.Net(mesh.nodes * 1e-3, mesh.members, mesh.panels)
    loads = [fn.AxialStiffness(1e6), fn.MemberWeight(12.0), fn.CoveringWeight(30.0)]
    scene = fn.Scene(net, [fn.Fixed(mesh.rims[0])], loads)
    result = fn.solve(scene)
    certificate = fn.certify(scene, result)
    assert result.status == "converged" and certificate.compression_only
    assert result.reactions[mesh.rims[0], 2].sum() == pytest.approx(result.reactions[:, 2].sum())
    assert result.nodes[:, 2].max() > 7.0
