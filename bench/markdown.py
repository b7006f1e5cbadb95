# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables and numbers as the page of results has them."""

import pathlib
import sys
import textwrap

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "src" / "freecad_wb"))

from funicular.accuracy_picture import length_text, time_text  # noqa: E402, F401


def grid(titles, lines):
    """A table: the first column to the left, the others to the right. No lines, no table."""
    if not lines:
        return []
    rule = "|---|" + "---:|" * (len(titles) - 1)
    return ["| " + " | ".join(titles) + " |", rule, *("| " + " | ".join(line) + " |" for line in lines), ""]


def paragraph(*sentences):
    """Sentences as lines of the page, and an empty one."""
    return [*textwrap.wrap(" ".join(sentences), 118, break_long_words=False, break_on_hyphens=False), ""]


def count(number):
    """10,201"""
    return f"{number:,.0f}"


def two_digits(number):
    """Two significant digits, three from a hundred on, without an exponent: 0.94, 13, 416, 1,420."""
    return f"{number:,.0f}" if number >= 99.5 else f"{float(f'{number:.2g}'):g}"


def power(number):
    """3e-07 as 3·10⁻⁷"""
    digits, exponent = f"{number:.0e}".split("e")
    raised = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"{digits}·10{raised}" if digits != "1" else f"10{raised}"
