# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two hundred edits in a row: each gives a certified shell, or a named error that keeps the last shape."""

import random

import FreeCAD as App
import numpy as np
import Part

from documents import array, reopened
from funicular.features.gridshell import RECIPES, scene_of
from funicular.features.net import PATTERNS, net_of
from funicular.features.node_choice import PLACES
from funicular.features.support import KINDS
from funicular.make import make_covering, make_gridshell, make_support

V = App.Vector
EDITS = 200


def block(doc):
    obj = doc.addObject("Part::Box", "Block")
    obj.Length, obj.Width, obj.Height = 8000, 6000, 3000
    return obj


def vault(doc):
    """A half cylinder that can change its radius and length."""
    obj = doc.addObject("Part::Feature", "Vault")
    obj.Shape = Part.makeCylinder(3000, 8000, V(), V(0, 1, 0), 180).Faces[0]
    return obj


def holed_vault(rng):
    """The half cylinder with a hole in its side, wherever that falls."""
    whole = Part.makeCylinder(3000, 8000, V(), V(0, 1, 0), 180)
    at, radius = V(0, rng.choice([2500, 4000, 5500]), -4000), rng.choice([700, 1100, 1600])
    cut = whole.cut(Part.makeCylinder(radius, 8000, at, V(0.2, 0, 1)))
    return max(cut.Faces, key=lambda face: face.Area if isinstance(face.Surface, Part.Cylinder) else 0)


def edits_of(rng, shell, support, block_, vault_):
    """(what it is, function) of one random edit."""
    net = shell.Net
    place = V(rng.random(), rng.random(), 0)

    def sources():
        net.Source = rng.choice([(block_, ["Face6"]), (vault_, ["Face1"]), (block_, ["Face2", "Face6"])])

    return rng.choice(
        [
            ("pattern", lambda: setattr(net, "Pattern", rng.choice(PATTERNS))),
            (
                "step",
                lambda: setattr(net, rng.choice(["StepU", "StepV"]), rng.choice([700, 1000, 1300, 2900])),
            ),
            ("count", lambda: setattr(net, rng.choice(["CountU", "CountV"]), rng.choice([0, 1, 4, 9]))),
            ("turn", lambda: setattr(net, "SwapUV", not net.SwapUV)),
            ("spacing", lambda: setattr(net, "Spacing", rng.choice(["Length", "Parameter"]))),
            ("size", lambda: setattr(block_, "Length", rng.choice([5000, 8000, 11000]))),
            (
                "radius",
                lambda: setattr(
                    vault_,
                    "Shape",
                    Part.makeCylinder(rng.choice([2000, 3000, 4500]), 8000, V(), V(0, 1, 0), 180).Faces[0],
                ),
            ),
            ("trim", lambda: setattr(vault_, "Shape", holed_vault(rng))),
            ("turn by an angle", lambda: setattr(net, "Angle", rng.choice([0, 0, 25, 45]))),
            ("source", sources),
            ("recipe", lambda: setattr(shell, "SupportRecipe", rng.choice(RECIPES))),
            ("weight", lambda: setattr(shell, "CoveringWeight", f"{rng.choice([0, 10, 60])} kg/m^2")),
            ("stiffness", lambda: setattr(shell, "AxialStiffness", f"{rng.choice([20, 200, 90000])} kN")),
            ("raise", lambda: setattr(net, "Raised", [place + V(0, 0, 400)] if rng.random() < 0.6 else [])),
            ("opening", lambda: setattr(net, "RemovedPanels", [place] if rng.random() < 0.6 else [])),
            ("member", lambda: setattr(net, "RemovedMembers", [place] if rng.random() < 0.6 else [])),
            ("where", lambda: setattr(support, "Where", rng.choice(PLACES))),
            ("kind", lambda: setattr(support, "Kind", rng.choice(KINDS))),
            ("points", lambda: setattr(support, "Points", [place])),
            ("elements", lambda: setattr(support, "Elements", [f"Edge{rng.randint(1, 13)}"])),
            ("tension", lambda: setattr(shell, "AllowTension", not shell.AllowTension)),
        ]
    )


def test_two_hundred_edits_in_a_row_never_break_the_document(doc, tmp_path):
    rng = random.Random(20090904)
    block_, vault_ = block(doc), vault(doc)
    doc.recompute()
    shell = make_gridshell(doc, source=(block_, ["Face6"]), MaxSeconds=20.0)
    support = make_support(doc, shell, Where="Points", Points=[V(0.5, 0.5, 0)], Kind="On its vertical line")
    support.Nodes = [5]
    doc.UndoMode = 1
    covering = make_covering(doc, shell)
    doc.recompute()
    assert shell.Status == "converged"
    good, refused = 0, {}
    for number in range(EDITS):
        before = array(shell.NodePositions)
        was_good = shell.Status == "converged"
        what, edit = edits_of(rng, shell, support, block_, vault_)
        doc.openTransaction(what)
        edit()
        doc.recompute()
        doc.commitTransaction()
        if shell.Status == "converged":
            assert shell.isValid() and shell.Net.isValid() and support.isValid(), (number, what)
            good += 1
            net = net_of(shell.Net)
            assert len(shell.NodePositions) == len(net.nodes) == shell.Net.NodeCount
            assert len(shell.Shape.Edges) == len(net.members)
            assert scene_of(shell).net.nodes.shape == net.nodes.shape
            if not shell.AllowTension:
                assert shell.CompressionOnly or "Nothing carries" in shell.Summary, (
                    number,
                    what,
                    shell.Summary,
                )
            assert covering.isValid() or "panel" in covering.getStatusString(), covering.getStatusString()
        else:
            # The last good shape stays, and one object says why in a sentence.
            assert np.array_equal(array(shell.NodePositions), before), (number, what)
            invalid = [obj for obj in (shell.Net, support, shell) if "Invalid" in obj.State]
            assert invalid and ": " in invalid[0].getStatusString(), (number, what, shell.Status)
            sentence = invalid[0].getStatusString().split(": ", 1)[1]
            refused[sentence[:30]] = refused.get(sentence[:30], 0) + 1
            if was_good or rng.random() < 0.5:
                doc.undo()
                doc.recompute()
                assert shell.Status == "converged" or not was_good, (number, what, shell.Summary)
    assert good > EDITS // 2, refused
    assert len(refused) >= 3, "the edits were to ask for what cannot be too"

    net = shell.Net
    net.Raised, net.RemovedPanels, net.RemovedMembers = [], [], []
    net.Source, net.Pattern, net.SwapUV, net.CountU, net.CountV = (block_, ["Face6"]), "Quad", False, 0, 0
    net.StepU = net.StepV = 1000
    block_.Length = 8000
    shell.SupportRecipe, shell.AxialStiffness, shell.CoveringWeight = "Boundary", "100 kN", "30 kg/m^2"
    support.Where, support.Kind = "Corners", "Fixed"
    doc.recompute()
    assert shell.Status == "converged" and net.NodeCount == 63, shell.Summary
    again = reopened(doc, tmp_path / "edited.FCStd")
    again.Net.StepU = 2000
    again.recompute()
    assert again.Gridshell.Status == "converged" and again.Net.NodeCount == 35
