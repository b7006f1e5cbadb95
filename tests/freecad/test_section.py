# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section of a gridshell's members: what its properties mean, and that nothing is solved for it."""

import math

import FreeCAD as App
import pytest

import funicular as fn
from funicular.features import gridshell
from funicular.features.form_of import form_of
from funicular.features.section import section_of
from funicular.make import make_gridshell
from funicular.quantities import STRESS


@pytest.fixture
def shell(doc):
    shell = make_gridshell(doc, Width="4 m", Depth="3 m", StepU="1 m", StepV="1 m")
    doc.recompute()
    assert shell.Status == "converged", shell.Summary
    return shell


def test_properties_make_a_section(shell):
    assert section_of(shell) is None
    shell.SectionShape, shell.SectionWidth = "Round", "60 mm"
    assert section_of(shell).area == pytest.approx(math.pi * 0.03**2)
    assert not section_of(shell).measures_utilisation
    shell.SectionShape, shell.SectionHeight, shell.YoungsModulus = "Rectangular", "100 mm", "11 GPa"
    section = section_of(shell)
    assert (section.area, section.modulus, section.strength) == (
        pytest.approx(0.006),
        pytest.approx(11e9),
        None,
    )
    shell.CompressiveStrength = App.Units.Quantity("20 MPa")
    assert section_of(shell).strength == pytest.approx(20e6)
    # kN over mm² by hand.
    stress = STRESS.of(form_of(shell), section)
    assert stress == pytest.approx([force / 0.006 for force in shell.MemberForces])


@pytest.mark.parametrize(
    "name, value",
    [("SectionWidth", 0.0), ("SectionHeight", 0.0), ("CompressiveStrength", -1.0), ("YoungsModulus", -1.0)],
)
def test_what_is_no_section_is_refused_by_name(shell, name, value):
    shell.SectionShape = "Rectangular"
    setattr(shell, name, value)
    with pytest.raises(fn.InvalidInput, match=f"^{name} is "):
        section_of(shell)


def test_nothing_is_solved_for_a_section(shell, monkeypatch):
    solves = []
    solve = fn.solve
    monkeypatch.setattr(
        gridshell.fn, "solve", lambda *args, **kwargs: solves.append(1) or solve(*args, **kwargs)
    )
    shell.SectionShape, shell.SectionWidth, shell.YoungsModulus = "Round", "50 mm", "210 GPa"
    assert "Touched" not in shell.State
    shell.Document.recompute()
    assert not solves
    shell.MemberWeight = "13 kg/m"
    shell.Document.recompute()
    assert solves == [1]
