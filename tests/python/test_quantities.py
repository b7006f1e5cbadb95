# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is read of members, the colours that stand for it, and arrows of forces, against numbers by hand."""

import dataclasses
import math

import numpy as np
import pytest

import funicular as fn
from funicular import quantities
from funicular.arrows import POINTS, arrow_lines, arrow_points
from funicular.colours import ON_PAPER, ON_SCREEN, packed, ramp_colours
from funicular.cross_section import CrossSection
from funicular.form import Form
from funicular.scale import Scale

# Two members of 3 m and 5 m that met at the origin before the net moved up by 2 m and 4 m at their far ends.
FORM = Form(
    nodes=np.array([[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 4.0]]),
    source_nodes=np.array([[0.0, 0.0, 0.0], [3.0, 0.0, -2.0], [0.0, 3.0, 0.0]]),
    members=np.array([[0, 1], [0, 2]]),
    panels=(),
    member_forces=np.array([-6000.0, 1000.0]),
    reactions=np.zeros((3, 3)),
    tension_members=np.array([1]),
    is_certified=True,
)
PIPE = CrossSection(0.1, strength=10e6, modulus=11e9)


def test_numbers_of_members_are_those_by_hand():
    area = math.pi * 0.05**2
    euler = math.pi**2 * 11e9 * (math.pi * 0.1**4 / 64) / 3.0**2
    expected = {
        "Force": [-6000.0, 1000.0],
        "Stress": [-6000.0 / area, 1000.0 / area],
        # Buckling counts for the first, which is long for its thickness; the second is in tension.
        "Utilisation": [6000.0 / euler, 1000.0 / area / 10e6],
        "Length": [3.0, 5.0],
        "Deviation": [1.0, 2.0],
        "Slack": [0.0, 0.0],
    }
    assert 6000.0 / euler > 6000.0 / area / 10e6
    assert set(expected) == set(quantities.QUANTITIES)
    for name, values in expected.items():
        assert quantities.QUANTITIES[name].of(FORM, PIPE) == pytest.approx(values), name


def test_utilisation_is_of_what_is_known():
    short = np.array([0.1])
    assert CrossSection(0.1, 0.2, strength=5e6).utilisation([-50e3], short) == pytest.approx([0.5])
    # About the weak axis, whichever way the section is turned.
    euler = math.pi**2 * 11e9 * 0.2 * 0.1**3 / 12 / 2.0**2
    for width, height in ((0.1, 0.2), (0.2, 0.1)):
        section = CrossSection(width, height, modulus=11e9)
        assert section.utilisation([-1000.0, 1000.0], np.array([2.0, 2.0])) == pytest.approx(
            [1000 / euler, 0.0]
        )


def test_without_a_section_there_is_no_stress():
    unknown = [name for name, each in quantities.QUANTITIES.items() if each.of(FORM) is None]
    assert unknown == ["Stress", "Utilisation"]
    assert quantities.STRESS.of(FORM, CrossSection(0.1)) is not None
    assert quantities.UTILISATION.of(FORM, CrossSection(0.1)) is None


@pytest.mark.parametrize(
    "wrong", [{"width": 0.0}, {"height": -1.0}, {"strength": math.nan}, {"modulus": math.inf}]
)
def test_a_section_that_is_none_is_refused_by_name(wrong):
    (name,) = wrong
    with pytest.raises(fn.InvalidInput, match=f"^{name} is "):
        CrossSection(**{"width": 0.1, "height": 0.1, **wrong})


def test_only_the_certificate_says_what_is_tension_and_slack():
    rounding = np.array([-6000.0, 1e-6])
    assert quantities.are_in_tension(FORM).tolist() == [False, True]
    with_rounding = dataclasses.replace(
        FORM, member_forces=rounding, tension_members=np.array([], dtype=int), slack_members=np.array([1])
    )
    assert quantities.SLACK.of(with_rounding).tolist() == [0.0, 1.0]
    assert quantities.are_in_tension(with_rounding).tolist() == [False, False]
    # Before there is one, what is more than rounding shows.
    under_way = dataclasses.replace(FORM, tension_members=np.array([], dtype=int), is_certified=False)
    assert quantities.are_in_tension(under_way).tolist() == [False, True]
    assert quantities.are_slack(dataclasses.replace(with_rounding, is_certified=False)).tolist() == [
        False,
        True,
    ]


def test_a_fixed_range_clamps_and_says_so():
    scale = Scale([-12e3, -4e3], quantities.FORCE, limits=(-8e3, 0.0))
    assert scale.colours()[0] == pytest.approx(ON_PAPER.compression[-1])
    assert scale.colours()[1] == pytest.approx(ramp_colours(ON_PAPER.compression, [0.5])[0])
    assert scale.is_beyond_low and not scale.is_beyond_high
    texts = [scale.mark_text(value) for _, value in scale.marks()]
    assert texts[0] == "0" and texts[-1] == "≤ −8.00"
    assert "≤" not in "".join(texts[:-1])
    lengths = Scale([0.4, 0.5, 0.7], quantities.LENGTH, limits=(0.45, 0.6))
    assert lengths.is_beyond_low and lengths.is_beyond_high
    assert [lengths.mark_text(value) for _, value in lengths.marks()][0] == "≥ 600"


def test_a_fixed_range_does_not_hide_tension_nor_what_is_too_much():
    tension = Scale([-5e3, 300.0], quantities.FORCE, above=[False, True], limits=(-10e3, 0.0))
    assert tension.has_upper and tension.colours()[1] == pytest.approx(ON_PAPER.tension[-1])
    too_much = Scale([0.2, 1.3], quantities.UTILISATION, limits=(0.0, 0.5))
    assert too_much.colours()[1] == pytest.approx(ON_PAPER.tension[-1])
    assert not Scale([0.2, 0.9], quantities.UTILISATION).has_upper


def test_utilisation_turns_at_one_hundred_per_cent():
    scale = Scale([0.0, 1.0, 3.0], quantities.UTILISATION)
    assert scale.unit == "%" and (scale.low, scale.high) == (0.0, 3.0)
    colours = scale.colours()
    assert colours[0] == pytest.approx(ON_PAPER.amount[0]) and colours[1] == pytest.approx(
        ON_PAPER.amount[-1]
    )
    assert colours[2] == pytest.approx(ON_PAPER.tension[-1])
    assert "100" in [scale.text(value) for _, value in scale.marks()]


@pytest.mark.parametrize("quantity", quantities.QUANTITIES.values(), ids=list(quantities.QUANTITIES))
@pytest.mark.parametrize("values", [[], [0.0, 0.0], [1.0, np.nan, -np.inf], [np.nan] * 2, [1e-300, 0.0]])
def test_no_colour_and_no_mark_is_not_a_number(quantity, values):
    values = np.array(values)
    scale = Scale(values, quantity, above=values > 0.0)
    colours = scale.colours()
    assert colours.shape == (len(values), 3) and ((colours >= 0.0) & (colours <= 1.0)).all()
    assert (colours[~np.isfinite(values)] == ON_PAPER.unknown).all()
    assert all(math.isfinite(position) and math.isfinite(value) for position, value in scale.marks())
    assert packed(colours).shape == (len(values),)


def test_a_value_where_two_stretches_meet_is_marked_once():
    forces = np.array([135.9614085173888, -6771.906721552654])
    scale = Scale(forces, quantities.FORCE, above=forces > 0.0)
    texts = [scale.mark_text(value) for _, value in scale.marks()]
    assert texts == ["0.14", "0", "−2.00", "−4.00", "−6.77"]


def test_lengths_that_differ_by_little_are_told_apart_by_their_marks():
    scale = Scale([0.49998, 0.50002], quantities.LENGTH)
    texts = [scale.text(value) for _, value in scale.marks()]
    assert len(set(texts)) == len(texts) > 3
    same = Scale([0.5, 0.5 + 1e-9], quantities.LENGTH)
    assert [same.text(value) for _, value in same.marks()] == ["500"]


def test_packed_colours_are_red_green_blue_and_opaque():
    assert packed([(1.0, 0.5, 0.0)])[0] == 0xFF8000FF


@pytest.mark.parametrize("ramps", [ON_PAPER, ON_SCREEN])
def test_the_bar_has_the_colours_of_the_members(ramps):
    forces = np.array([-800.0, -300.0, -0.0, 40.0, 100.0])
    scale = Scale(forces, quantities.FORCE, above=forces > 0.0, ramps=ramps)
    for colour, force in zip(scale.colours(), forces):
        stretch = scale.stretches[int(force > 0.0)]
        assert scale.bar_colours([stretch.position(force)])[0] == pytest.approx(colour)


def test_arrows_end_where_their_forces_act_and_are_as_long_as_those_are_large():
    tips = np.array([[0.0, 0.0, 0.0], [1.0, 2.0, 3.0], [5.0, 5.0, 0.0], [4.0, 4.0, 4.0]])
    forces = np.array([[0.0, 0.0, 500.0], [-1000.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.001, 0.0]])
    arrows = arrow_points(tips, forces, 2.0).reshape(-1, POINTS, 3)
    # What is nothing beside the others has none.
    assert len(arrows) == 2
    for arrow, tip, force, length in zip(arrows, tips, forces, (1.0, 2.0)):
        assert arrow[1] == pytest.approx(tip)
        assert arrow[1] - arrow[0] == pytest.approx(length * force / np.linalg.norm(force))
        barbs = arrow[2:] - tip
        assert np.linalg.norm(barbs, axis=1) == pytest.approx(np.linalg.norm(barbs[0]))
        assert (barbs @ force < 0.0).all() and barbs.sum(axis=0) @ force < 0.0
        assert np.cross(barbs.sum(axis=0), force) == pytest.approx(np.zeros(3), abs=1e-9)
    assert arrow_lines(2).tolist()[5:] == [[6, 7], [7, 8], [7, 9], [7, 10], [7, 11]]
    assert arrow_points(tips, 0.0 * forces, 2.0).shape == (0, 3)
