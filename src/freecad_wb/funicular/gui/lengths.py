# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths as the user's unit schema writes them."""

import FreeCAD

from funicular.features.gridshell import METRES
from funicular.wording import number


def length_in_words(metres):
    """1 mm, 10 µm, 0.0394 in: three digits in the user's unit schema; FreeCAD itself would round to zero."""
    length = FreeCAD.Units.Quantity(metres / METRES, FreeCAD.Units.Length)
    _, size, unit = length.getUserPreferred()
    if unit in ("ft", "yd") and abs(length.Value) < size:
        size, unit = 25.4, "in"
    value = length.Value / size
    return number(value, ".0f" if abs(value) >= 999.5 else ".3g") + f" {unit}"
