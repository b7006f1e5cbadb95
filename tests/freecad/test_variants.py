# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alternatives kept on a gridshell: they hold what went in and what came out, and cost no solve."""

import FreeCAD as App
import Part
import numpy as np
import pytest

import funicular as fn
from funicular.features.variants import (
    keep_variant,
    remove_variant,
    rename_variant,
    restore_variant,
    variants_of,
)
from funicular.make import make_gridshell, make_point_load, make_support


@pytest.fixture
def shell(doc):
    shell = make_gridshell(doc, Width="6 m", Depth="4 m", StepU="500 mm", StepV="500 mm")
    doc.recompute()
    return shell


def heights(shell):
    return np.array([node.z for node in shell.NodePositions])


def test_what_was_kept_can_be_taken_again(shell, doc):
    low = heights(shell)
    keep_variant(shell, "Low", thumbnail=b"\x89PNG")
    shell.CoveringWeight, shell.SupportRecipe, shell.Net.Pattern = "80 kg/m^2", "Corners", "Triangle"
    support = make_support(doc, shell, Points=[App.Vector(0.5, 0.0, 0)], Stiffness="2 kN/mm")
    doc.recompute()
    high = heights(shell)
    keep_variant(shell, "High")
    assert [variant.name for variant in variants_of(shell)] == ["Low", "High"]
    assert restore_variant(shell, "Low") == []
    assert shell.Supports == [] and support not in doc.Objects
    doc.recompute()
    assert shell.Net.Pattern == "Quad" and shell.SupportRecipe == "Boundary"
    assert heights(shell) == pytest.approx(low, abs=1e-9)
    restore_variant(shell, "High")
    doc.recompute()
    assert heights(shell) == pytest.approx(high, abs=1e-9)
    (support,) = shell.Supports
    assert support.Points == [App.Vector(0.5, 0.0, 0)] and support.Stiffness.Value == pytest.approx(2e6)


def test_what_another_gridshell_shares_is_not_taken_from_it(shell, doc):
    part = doc.addObject("App::Part", "Part")
    part.addObject(shell)
    keep_variant(shell, "Without")
    own, shared = make_support(doc, shell, Where="Corners"), make_support(doc, shell, Where="Corners")
    load = make_point_load(doc, shell, Points=[(0.5, 0.5)])
    other = make_gridshell(doc, net=shell.Net, SupportRecipe="None")
    other.Supports, other.PointLoads = [shared], [load]
    doc.recompute()
    names = own.Name, shared.Name, load.Name
    restore_variant(shell, "Without")
    doc.recompute()
    assert shell.Supports == shell.PointLoads == []
    assert [doc.getObject(name) is None for name in names] == [True, False, False]
    assert other.Supports == [shared] and other.PointLoads == [load] and other.Status == "converged"


def test_a_sheet_is_a_sheet_again_after_a_face(shell, doc):
    keep_variant(shell, "Sheet")
    face = doc.addObject("Part::Feature", "Face")
    face.Shape = Part.makePlane(9000, 9000, App.Vector(0, 0, 5000))
    shell.Net.Source = (face, ["Face1"])
    doc.recompute()
    assert restore_variant(shell, "Sheet") == []
    doc.recompute()
    assert shell.Net.Source is None and shell.Net.Width.Value == 6000.0
    assert max(heights(shell)) < 4000.0


def test_a_copy_stays_on_its_own_source(doc):
    roof = doc.addObject("Part::Feature", "Roof")
    roof.Shape = Part.makePlane(6000, 6000)
    shell = make_gridshell(doc, (roof, ["Face1"]))
    doc.recompute()
    keep_variant(shell, "Kept")
    copy = doc.copyObject(shell, True)
    assert copy.Net != shell.Net and copy.Net.Source[0] != roof
    assert restore_variant(copy, "Kept") == [f"{copy.Label} is a copy: its net stays on its own source"]
    assert copy.Net.Source[0] != roof
    assert restore_variant(shell, "Kept") == []


def test_a_variant_knows_its_numbers_and_its_form(shell):
    variant = keep_variant(shell, "Now", thumbnail=b"picture")
    (found,) = variants_of(shell)
    assert found.thumbnail == b"picture" and found.numbers == variant.numbers
    assert found.nodes[:, 2] * 1e3 == pytest.approx(heights(shell), abs=1e-3)
    assert found.numbers["weight"] == pytest.approx(shell.TotalWeight.getValueAs("N").Value, rel=1e-3)
    assert found.numbers["most_compression"] == pytest.approx(-min(shell.MemberForces))
    assert found.numbers["rise"] == pytest.approx(heights(shell).max() / 1e3)
    assert found.numbers["compression_only"] is True


def test_keeping_solves_nothing(shell, doc, monkeypatch):
    solves, solve = [], fn.solve
    monkeypatch.setattr(fn, "solve", lambda *args, **options: solves.append(1) or solve(*args, **options))
    keep_variant(shell, "One")
    rename_variant(shell, "One", "Other")
    assert "Touched" not in shell.State
    doc.recompute()
    remove_variant(shell, "Other")
    doc.recompute()
    assert not solves and variants_of(shell) == []
    shell.CoveringWeight = "31 kg/m^2"
    doc.recompute()
    assert solves == [1], "the count counts"


def test_they_are_saved_copied_and_undone(shell, doc, tmp_path):
    doc.UndoMode = 1
    doc.openTransaction("Keep")
    keep_variant(shell, "Kept")
    doc.commitTransaction()
    doc.saveAs(str(tmp_path / "kept.FCStd"))
    again = App.openDocument(doc.FileName) if doc.FileName not in App.listDocuments() else doc
    assert [variant.name for variant in variants_of(again.getObject(shell.Name))] == ["Kept"]
    copied = doc.copyObject(shell, True)
    assert [variant.name for variant in variants_of(copied)] == ["Kept"]
    doc.undo()
    assert variants_of(shell) == []


def test_names_are_checked(shell):
    keep_variant(shell, "One")
    keep_variant(shell, "Two")
    keep_variant(shell, "One")
    assert [variant.name for variant in variants_of(shell)] == ["Two", "One"], "the newer one takes its place"
    with pytest.raises(fn.InvalidInput, match="name is empty"):
        keep_variant(shell, "  ")
    with pytest.raises(fn.InvalidInput, match="no variant 'Three': there are 'Two', 'One'"):
        restore_variant(shell, "Three")
    with pytest.raises(fn.InvalidInput, match="taken"):
        rename_variant(shell, "One", "Two")
    with pytest.raises(fn.InvalidInput, match="no variant"):
        remove_variant(shell, "Three")


def test_without_a_result_there_is_nothing_to_keep(doc):
    shell = make_gridshell(doc, Width="6 m", Depth="4 m")
    with pytest.raises(fn.InvalidInput, match="no result to keep: recompute it first"):
        keep_variant(shell, "Early")
    shell.AxialStiffness = "1 N"
    doc.recompute()
    with pytest.raises(fn.InvalidInput, match="no result to keep"):
        keep_variant(shell, "Failed")


def test_what_cannot_be_restored_is_told(doc):
    plane = doc.addObject("Part::Plane", "Plane")
    plane.Length, plane.Width = 6000, 4000
    shell = make_gridshell(doc, source=(plane, ["Face1"]), StepU="500 mm", StepV="500 mm")
    doc.recompute()
    keep_variant(shell, "On the plane")
    shell.setExpression("Snow", "0.5 kPa")
    doc.recompute()
    doc.removeObject("Plane")
    remarks = " ".join(restore_variant(shell, "On the plane"))
    assert "Snow follows an expression" in remarks and "Plane, which the net lay on, is gone" in remarks


def test_what_a_later_version_kept_is_left_alone(shell):
    later = '{"schema": 99, "name": "Later"}'
    shell.Variants = [later, "damaged"]
    assert variants_of(shell) == []
    keep_variant(shell, "Mine")
    assert [variant.name for variant in variants_of(shell)] == ["Mine"]
    assert shell.Variants[1:] == [later, "damaged"]
