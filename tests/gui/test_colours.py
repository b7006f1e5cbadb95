# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours by force and the legend's marks: numbers only, so no FreeCAD."""

import pytest
from funicular import wording
from funicular.colours import ON_PAPER, ON_SCREEN, ONE_RAMP, ramp_colours
from funicular.quantities import FORCE
from funicular.scale import Scale

COMPRESSION_RAMP, TENSION_RAMP = ON_PAPER.compression, ON_PAPER.tension

# FreeCAD's default gradient from top to bottom, and white.
BACKGROUNDS = {"dark blue": (0.2, 0.2, 0.4), "white": (1.0, 1.0, 1.0)}


def force_scale(forces, tension_members=()):
    return Scale(forces, FORCE, above=[index in tension_members for index in range(len(forces))])


def ramp_colour(ramp, share):
    return tuple(ramp_colours(ramp, [share])[0])


def as_list(colours):
    return [tuple(colour) for colour in colours.tolist()]


def as_seen_without(cone, colour):
    """An sRGB colour as seen without "red" or "green" cones (Viénot, Brettel & Mollon 1999), linear RGB."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour]
    red, green, blue = linear
    if cone == "red":
        return (
            0.11238 * red + 0.88762 * green,
            0.11238 * red + 0.88762 * green,
            0.004 * (red - green) + blue,
        )
    return (0.29275 * red + 0.70725 * green, 0.29275 * red + 0.70725 * green, -0.02234 * (red - green) + blue)


def luminance(colour):
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_one_colour_per_member_in_member_order():
    scale = force_scale([-100.0, 0.0, 40.0], [2])
    assert as_list(scale.colours()) == [COMPRESSION_RAMP[-1], COMPRESSION_RAMP[0], TENSION_RAMP[-1]]


def test_ramp_passes_through_its_colours_and_stays_within_its_ends():
    assert [ramp_colour(COMPRESSION_RAMP, i / 3) for i in range(4)] == [
        pytest.approx(colour) for colour in COMPRESSION_RAMP
    ]
    assert ramp_colour(TENSION_RAMP, 7.0) == TENSION_RAMP[-1]
    assert ramp_colour(TENSION_RAMP, -7.0) == TENSION_RAMP[0]


@pytest.mark.parametrize("ramps", [ON_PAPER, ON_SCREEN])
def test_each_ramp_darkens_steadily(ramps):
    for ramp in (ramps.compression, ramps.tension, ramps.amount):
        light = [luminance(ramp_colour(ramp, i / 50)) for i in range(51)]
        assert all(after < before for before, after in zip(light, light[1:]))


def test_one_ramp_grows_lighter_from_most_compression_to_most_tension():
    ramp = [ramp_colour(ONE_RAMP.compression, 1 - i / 20) for i in range(21)]
    ramp += [ramp_colour(ONE_RAMP.tension, i / 20) for i in range(21)]
    light = [luminance(colour) for colour in ramp]
    assert all(before < after for before, after in zip(light, light[1:]))
    # Tension is set apart from what bears nothing.
    assert light[21] > 1.4 * light[20]


@pytest.mark.parametrize("ramps", [ON_SCREEN, ONE_RAMP])
@pytest.mark.parametrize("background", BACKGROUNDS)
def test_every_colour_on_the_screen_stands_out_from_what_is_behind_it(background, ramps):
    behind = luminance(BACKGROUNDS[background])
    for ramp in (ramps.compression, ramps.tension, ramps.amount):
        for i in range(21):
            light = luminance(ramp_colour(ramp, i / 20))
            # The contrast of WCAG 2, in which 1 is no contrast.
            assert (max(light, behind) + 0.05) / (min(light, behind) + 0.05) > 1.9


@pytest.mark.parametrize("ramps", [ON_PAPER, ON_SCREEN])
@pytest.mark.parametrize("cone", ["red", "green"])
def test_tension_is_told_from_compression_without_one_kind_of_cone(cone, ramps):
    compression = [as_seen_without(cone, ramp_colour(ramps.compression, i / 20)) for i in range(21)]
    tension = [as_seen_without(cone, ramp_colour(ramps.tension, i / 20)) for i in range(21)]
    # Compression is bluer than it is yellow, tension the other way round, at every force.
    assert all(blue > yellow for yellow, _, blue in compression)
    assert all(blue < yellow / 2 for yellow, _, blue in tension)


def test_only_the_certificate_says_what_is_tension():
    rounding = force_scale([-100.0, 1e-9])
    assert as_list(rounding.colours())[1] == COMPRESSION_RAMP[0]
    assert not rounding.has_upper


def test_unit_follows_the_largest_force():
    assert force_scale([-999.0]).unit == "N"
    assert force_scale([-1000.0]).unit == "kN"
    assert force_scale([-10.0, 2500.0], [1]).unit == "kN"


def test_numbers_have_three_digits_and_a_true_minus():
    scale = force_scale([-12345.0])
    assert [scale.text(force) for force in (-12345.0, -1234.5, -123450.0, 0.0)] == [
        "−12.3",
        "−1.23",
        "−123",
        "0",
    ]
    assert force_scale([-0.00012]).text(-0.00012) == "−1.2e-04"


def test_marks_name_the_extremes_and_zero_from_top_to_bottom():
    assert force_scale([-800.0, -100.0]).marks() == [
        (1.0, 0.0),
        (0.75, -200.0),
        (0.5, -400.0),
        (0.25, -600.0),
        (0.0, -800.0),
    ]
    marks = force_scale([-800.0, 100.0], [1]).marks()
    assert marks[0] == (1.0, 100.0) and (0.75, 0.0) in marks and marks[-1] == (0.0, -800.0)
    positions = [position for position, _ in marks]
    assert positions == sorted(positions, reverse=True)


def test_marks_between_the_extremes_are_round_and_keep_clear_of_them():
    marks = force_scale([-1140.0]).marks()
    assert [force for _, force in marks] == [0.0, -250.0, -500.0, -750.0, -1000.0, -1140.0]
    assert [position for position, _ in marks] == pytest.approx([1 + force / 1140 for _, force in marks])
    assert [force for _, force in force_scale([-1050.0]).marks()] == [0.0, -250.0, -500.0, -750.0, -1050.0]


def test_scale_says_what_is_enlarged_to_be_seen():
    for forces, in_tension in (([-800.0], []), ([-600.0, 400.0], [1]), ([400.0], [0])):
        assert force_scale(forces, in_tension).enlarged == ""
    assert force_scale([-800.0, 1.0], [1]).enlarged == "upper"
    assert force_scale([-1.0, 800.0], [1]).enlarged == "lower"


def test_bar_shows_the_colour_of_the_force_it_is_marked_with():
    scale = force_scale([-800.0, 100.0], [1])
    for position, force in scale.marks():
        if force < 0.0:
            assert tuple(scale.bar_colours([position])[0]) == pytest.approx(
                ramp_colour(COMPRESSION_RAMP, -force / 800.0)
            )
    assert tuple(scale.bar_colours([1.0])[0]) == pytest.approx(TENSION_RAMP[-1])


def test_no_forces_at_all_still_make_a_scale():
    for forces in ([], [0.0, 0.0]):
        scale = force_scale(forces)
        assert as_list(scale.colours()) == [COMPRESSION_RAMP[0]] * len(forces)
        assert scale.marks() == [(1.0, 0.0)]
        assert len(scale.bar_colours([0.5])) == 1


@pytest.fixture
def habits(monkeypatch):
    return lambda *values: monkeypatch.setattr(wording, "habits", lambda: wording.Habits(*values))


def test_words_are_written_as_the_user_reckons(habits):
    assert wording.force_text(1234.5) == "1.23 kN" and wording.force_text(12.0) == "12 N"
    assert wording.short_length_text(0.4e-3) == "0.4 mm"
    habits(("lbf", "kip"), ("in", 0.0254), ".")
    assert wording.force_text(4.4482216152605) == "1 lbf"
    assert wording.force_text(10 * 4448.2216152605) == "10 kip"
    assert wording.short_length_text(0.0254 / 16) == "0.062 in"
    habits(("kN",), ("mm", 1e-3), ",")
    assert wording.force_text(12.0) == "0,012 kN" and wording.time_text(0.0012) == "1,2 ms"
    assert wording.length_text(0.0015) == "1,5 mm"
