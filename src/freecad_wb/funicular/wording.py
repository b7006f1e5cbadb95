# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that remarks and errors share: how many, which, whether that is one or several, how long."""

from dataclasses import dataclass

# Newtons in each.
FORCE_UNITS = {"N": 1.0, "kN": 1e3, "lbf": 4.4482216152605, "kip": 4448.2216152605}


@dataclass(frozen=True)
class Habits:
    """How numbers are written.

    force_units: names in FORCE_UNITS, from small to large. short_length: a name, and the metres in one, for
    what is small on a building.
    """

    force_units: tuple = ("N", "kN")
    short_length: tuple = ("mm", 1e-3)
    decimal_point: str = "."


def habits():
    """The Habits that hold now: a window puts a function in this one's place that knows its user's."""
    return Habits()


def number(value, spec):
    """format(value, spec) with the decimal point that is in use."""
    return format(value, spec).replace(".", habits().decimal_point)


def force_unit(newtons):
    """(name, newtons in one) of the unit that a force of this size is written in."""
    units = [(name, FORCE_UNITS[name]) for name in habits().force_units]
    return next((unit for unit in reversed(units) if abs(newtons) >= unit[1]), units[0])


def counted(number, one, several=None):
    return f"{number} {one if number == 1 else several or one + 's'}"


def is_or_are(things):
    return "is" if len(things) == 1 else "are"


def and_more(count):
    return f", and {count} more" if count else ""


def listed(numbers, last=", ", most=8):
    """The first of the numbers with commas, `last` before the last one."""
    words = [str(number) for number in numbers[:most]]
    if len(numbers) > most:
        words.append(f"{len(numbers) - most} more")
    return last.join([", ".join(words[:-1]), words[-1]]) if len(words) > 1 else "".join(words)


def length_text(metres):
    """1 mm, 10 µm, 1 nm."""
    for unit, size in (("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("µm", 1e-6), ("nm", 1e-9), ("pm", 1e-12)):
        if metres >= 0.9995 * size:
            return f"{number(metres / size, '.3g')} {unit}"
    return f"{metres:.0e} m"


def short_length_text(metres):
    """0.4 mm, 0.016 in: two digits, in the one unit in which small lengths are reckoned."""
    name, size = habits().short_length
    value = metres / size
    return number(value, ".0f" if value >= 99.5 else ".2g") + f" {name}"


def time_text(seconds):
    """12 s, 35 ms, 0.4 ms."""
    if seconds >= 0.9995:
        return number(seconds, ".0f" if seconds >= 9.95 else ".2g") + " s"
    return number(seconds * 1e3, ".0f" if seconds >= 0.00995 else ".2g") + " ms"


def force_text(newtons):
    """184 kN, 3.2 N."""
    name, size = force_unit(newtons)
    value = newtons / size
    return number(value, ".0f" if abs(value) >= 999.5 else ".3g") + f" {name}"
