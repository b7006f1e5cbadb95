# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every pattern on every kind of face."""

import FreeCAD as App
import numpy as np
import pytest

import funicular as fn
from documents import assert_refused, edge_ends, recompute
from faces import FACES
from funicular.features.net import PATTERNS, net_of
from funicular.make import make_gridshell, make_net
from funicular.recipes import support_recipe

STANDING = ("plane", "cylinder", "torus", "spherical cap", "quarter of a spherical cap", "B-spline", "placed")


def test_the_document_knows_every_pattern():
    assert tuple(pattern.lower().replace(" ", "_") for pattern in PATTERNS) == fn.patterns()


def source_of(doc, kind):
    source = doc.addObject("Part::Feature", "Source")
    source.Shape = FACES[kind][0]()
    return source, source.Shape.Faces[0].BoundBox.DiagonalLength


def poles_beyond_ribs(pattern, kind):
    """Whether the ribs run beside the poles of the face and never into them."""
    poles = FACES[kind][3]
    return pattern.startswith("Ribs") and bool(poles) and poles[0][0] != pattern[-1]


def lone_parts(net, supports):
    """Whether a rib, which no other one holds, touches no support."""
    held = np.concatenate([support.ids for support in supports])
    part = np.arange(len(net.nodes))
    for _ in range(len(part)):
        lowest = part.copy()
        np.minimum.at(lowest, net.members.ravel(), part[net.members[:, ::-1]].ravel())
        if (lowest == part).all():
            break
        part = lowest
    return bool(set(part) - set(part[held]))


@pytest.mark.parametrize("pattern", PATTERNS)
@pytest.mark.parametrize("kind", FACES)
def test_a_net_of_each_pattern_on_each_kind_of_face(doc, kind, pattern):
    source, size = source_of(doc, kind)
    net = make_net(doc, source, Pattern=pattern, StepU=size / 8, StepV=size / 8)
    failed = recompute(doc)
    if poles_beyond_ribs(pattern, kind):
        assert_refused(net, "no rib reaches the pole", "other direction")
        return
    assert failed == {}
    numeric = net_of(net)
    nodes = numeric.nodes * 1000
    assert (net.CellsU, net.CellsV) == numeric.lattice.cells
    assert (net.NodeCount, net.MemberCount, net.PanelCount) == (
        len(nodes),
        len(numeric.members),
        len(numeric.panels),
    )
    np.testing.assert_allclose(edge_ends(net.Shape), nodes[numeric.members], atol=1e-9 * size)
    surface = source.Shape.Faces[0].Surface
    away = max(surface.projectPoint(App.Vector(*node), "LowerDistance") for node in nodes[::5])
    assert away < 1e-9 * size + 1e-9 * np.abs(nodes).max()


@pytest.mark.parametrize("pattern", PATTERNS)
@pytest.mark.parametrize("kind", STANDING)
def test_each_pattern_stands_on_each_kind_of_face(doc, kind, pattern):
    source, size = source_of(doc, kind)
    made = make_net(doc, source, Pattern=pattern, StepU=size / 8, StepV=size / 8)
    recompute(doc)
    if poles_beyond_ribs(pattern, kind):
        assert made.SourceNodes == []
        return
    net = net_of(made)
    supports = support_recipe(net, "boundary" if len(net.border) else "lowest points")
    loads = [fn.AxialStiffness(1e5), fn.MemberWeight(5.0), fn.CoveringWeight(20.0)]
    if pattern.startswith("Ribs") and lone_parts(net, supports):
        with pytest.raises(fn.InvalidInput, match="component of .* nodes has no support"):
            fn.Scene(net, supports, loads)
        return
    scene = fn.Scene(net, supports, loads)
    result = fn.solve(scene, accuracy=1e-6)
    assert result.status == "converged", result.message
    certificate = fn.certify(scene, result)
    assert certificate.compression_only and certificate.max_residual < 1e-6


@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_gridshell_of_each_pattern(doc, box, pattern):
    shell = make_gridshell(
        doc, source=(box, ["Face6"]), Pattern=pattern, StepU="1 m", StepV="1 m", CoveringWeight="30 kg/m^2"
    )
    assert recompute(doc) == {}
    assert shell.Status == "converged" and shell.CompressionOnly
    assert len(shell.Shape.Edges) == shell.Net.MemberCount


def test_members_have_the_length_of_the_step(doc, box):
    box.Length, box.Width = 10000, 10000
    made = make_net(doc, (box, ["Face6"]), StepU="500 mm", StepV="500 mm")
    for pattern in ("Quad", "Diagrid", "Triangle", "Hexagon", "Kagome"):
        made.Pattern = pattern
        assert recompute(doc) == {}
        lengths = np.array([edge.Length for edge in made.Shape.Edges])
        assert 470 < np.median(lengths) < 530, pattern
