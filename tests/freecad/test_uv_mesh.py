# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh file whose UV coordinates carry a pattern, instead of its own edges."""

import numpy as np
import pytest

import funicular as fn
from documents import array, assert_refused, recompute
from funicular.features.net import net_of
from funicular.make import make_gridshell, make_net

SURFACES = {
    "roof": lambda u, v: (8 * u, 6 * v, 1.5 * np.sin(3 * u) * np.cos(2 * v)),
    "tube": lambda u, v: (4 * np.cos(2 * np.pi * u), 4 * np.sin(2 * np.pi * u), 5 * v),
    "cap": lambda u, v: (
        4 * np.cos(2 * np.pi * u) * np.cos(np.pi / 2 * v),
        4 * np.sin(2 * np.pi * u) * np.cos(np.pi / 2 * v),
        4 * np.sin(np.pi / 2 * v),
    ),
}


def unwrapped(surface, columns=12, rows=9, jitter=0.0):
    """(points [m], quads, uvs) of a grid of facets on a surface; its inner (u, v) may be irregular."""
    u, v = np.meshgrid(np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1), indexing="ij")
    uvs = np.column_stack([u.ravel(), v.ravel()])
    inner = ((uvs > 0) & (uvs < 1)).all(axis=1)
    moved = np.random.default_rng(4).uniform(-jitter, jitter, (len(uvs), 2)) / (columns, rows)
    uvs[inner] += moved[inner]
    points = np.column_stack(np.broadcast_arrays(*SURFACES[surface](*uvs.T)))
    first = [i * (rows + 1) + j for i in range(columns) for j in range(rows)]
    return points, [(k, k + rows + 1, k + rows + 2, k + 1) for k in first], uvs


def written(path, points, facets, uvs, corners=None):
    """The path of an .obj file; corners: for each facet the numbers of its uvs, None for none."""
    rows = ["v {!r} {!r} {!r}".format(*point) for point in points.tolist()]
    rows += ["vt {!r} {!r}".format(*uv) for uv in uvs.tolist()]
    for facet, named in zip(facets, facets if corners is None else corners):
        texts = (f"/{uv + 1}" for uv in named) if named else [""] * len(facet)
        rows.append("f " + " ".join(f"{corner + 1}{text}" for corner, text in zip(facet, texts)))
    path.write_text("\n".join(rows) + "\n")
    return str(path)


def distance_to(points, triangles, queries):
    """Of each query to the nearest triangle's plane, among those it projects into [same unit]."""
    a, b, c = (points[np.array(triangles)[:, k]] for k in range(3))
    e, f = b - a, c - a
    normal = np.cross(e, f)
    doubled = (normal**2).sum(axis=1)
    best = []
    for query in queries:
        to = query - a
        s = (np.cross(to, f) * normal).sum(axis=1) / doubled
        t = (np.cross(e, to) * normal).sum(axis=1) / doubled
        inside = (s > -1e-6) & (t > -1e-6) & (s + t < 1 + 1e-6)
        best.append(np.abs((to * normal).sum(axis=1) / np.sqrt(doubled))[inside].min(initial=np.inf))
    return np.array(best)


@pytest.mark.parametrize("jitter", [0.0, 0.3])
@pytest.mark.parametrize("surface", SURFACES)
def test_nodes_lie_on_the_facets_in_equal_steps(doc, tmp_path, surface, jitter):
    points, facets, uvs = unwrapped(surface, jitter=jitter)
    path = written(tmp_path / "mesh.obj", points, facets, uvs)
    net = make_net(doc, File=path, Resampled=True, StepU="700 mm", StepV="700 mm")
    assert recompute(doc) == {} and net.Remarks == ""
    nodes = array(net.SourceNodes)
    # At the pole triangles of the cap have no area.
    triangles = [t for a, b, c, d in facets for t in ((a, b, c), (a, c, d))]
    sound = [t for t in triangles if np.linalg.norm(np.cross(*(points[list(t[1:])] - points[t[0]]))) > 1e-12]
    assert distance_to(points * 1000, sound, nodes).max() < 1e-6
    assert (net.ClosedU, net.ClosedV) == (surface != "roof", False)
    assert net.Poles == (["v_max"] if surface == "cap" else [])
    if surface == "roof":
        # Along u the isolines of the sheet are parallel lines in plan; what is equal are lengths on facets.
        along = nodes.reshape(net.CellsV + 1, net.CellsU + 1, 3)[0]
        steps = np.linalg.norm(np.diff(along, axis=0), axis=1)
        assert 0.9 * 700 < steps.mean() < 1.1 * 700 and np.ptp(steps) < 0.02 * steps.mean()


def test_a_pattern_on_it_becomes_a_shell_and_follows_the_step(doc, tmp_path):
    path = written(tmp_path / "mesh.obj", *unwrapped("roof"))
    shell = make_gridshell(
        doc, File=path, Resampled=True, Pattern="Triangle", SupportRecipe="Corners", StepU="1 m", StepV="1 m"
    )
    assert recompute(doc) == {}
    assert shell.Status == "converged" and shell.CompressionOnly
    before = shell.Net.NodeCount
    shell.Net.StepU = "500 mm"
    assert recompute(doc) == {} and shell.Net.NodeCount > 1.8 * before
    shell.Net.Resampled = False
    assert recompute(doc) == {} and shell.Net.NodeCount == 13 * 10, "its own vertices again"


def test_equal_lengths_are_laid_on_it_too(doc, tmp_path):
    path = written(tmp_path / "mesh.obj", *unwrapped("roof", 24, 18))
    net = make_net(doc, File=path, Resampled=True, Laying="Equal lengths", StepU="500 mm")
    assert recompute(doc) == {}
    made = net_of(net)
    lengths = np.linalg.norm(np.subtract(*(made.nodes[made.members[:, k]] for k in (0, 1))), axis=1)
    assert len(made.nodes) > 100 and np.abs(lengths - 0.5).max() < 1e-9


def test_what_cannot_carry_a_pattern_is_refused(doc, tmp_path):
    points, facets, uvs = unwrapped("roof")
    net = make_net(doc, File=written(tmp_path / "0.obj", points, facets, uvs), Resampled=True)
    assert recompute(doc) == {}

    def refused(*sentences, points=points, facets=facets, uvs=uvs, corners=None, suffix=".obj"):
        path = tmp_path / f"{len(list(tmp_path.iterdir()))}{suffix}"
        if suffix == ".obj":
            net.File = written(path, points, facets, uvs, corners)
        else:
            fn.Net(points, [(0, 1)], facets).write(str(path))
            net.File = str(path)
        recompute(doc)
        assert_refused(net, *sentences)

    refused("has no UV coordinates", "take the mesh as it is", uvs=uvs[:0], corners=[None] * len(facets))
    refused("has no UV coordinates", suffix=".ply")
    refused("facet 5 has no UV coordinates", corners=[*facets[:5], None, *facets[6:]])
    refused(
        "face 3 names texture", "but the file has 130", corners=[*facets[:3], (0, 1, 2, 999), *facets[4:]]
    )
    refused("leave 0.926 %", facets=facets[:50] + facets[51:])
    refused("all lie on a line", uvs=uvs * [1, 0])
    folded = uvs.copy()
    folded[45] = folded[65] + 0.01
    refused("turned over", uvs=folded)
    refused("lie apart but both have", uvs=np.column_stack([uvs[:, 0] * 2 % 1.0, uvs[:, 1]]))
    refused("not finite", uvs=np.where(np.arange(len(uvs))[:, None] == 7, np.inf, uvs))
    refused("has coordinates beyond 1e+60", uvs=uvs * 1e300)
    lines = tmp_path / "lines.obj"
    lines.write_text("v 0 0 0\nv 1 0 0\nvt 0 0\nl 1 2\n")
    net.File = str(lines)
    recompute(doc)
    assert_refused(net, "has no facets: a pattern is laid over facets")
    net.File = written(tmp_path / "last.obj", points, facets, uvs)
    net.Angle = 30
    recompute(doc)
    assert_refused(net, "on a mesh set them to 0")
    net.Angle = 0
    assert recompute(doc) == {}
