# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section of a Gridshell's members: properties, and the CrossSection that they describe.

It says how far members are used by the forces that were found, and has no part in finding them.
"""

import funicular as fn

from ..cross_section import CrossSection
from .feature import Property, amount

NONE, ROUND, RECTANGULAR = "None", "Round", "Rectangular"
METRES = 1e-3  # of a millimetre


def _of_section(kind, name, tooltip, default, unit=None, choices=()):
    return Property(kind, name, "Section", tooltip, default, choices, unit, is_input=False)


SECTION_PROPERTIES = (
    _of_section(
        "App::PropertyEnumeration",
        "SectionShape",
        "Shape of the solid members across, for their stress; it does not change the form",
        NONE,
        choices=(NONE, ROUND, RECTANGULAR),
    ),
    _of_section(
        "App::PropertyLength", "SectionWidth", "Diameter of round members, width of others", "80 mm", "mm"
    ),
    _of_section("App::PropertyLength", "SectionHeight", "Height of rectangular members", "120 mm", "mm"),
    _of_section(
        "App::PropertyPressure",
        "CompressiveStrength",
        "Stress that the members bear, for their utilisation; 0 for unknown",
        0.0,
        "N/mm^2",
    ),
    _of_section(
        "App::PropertyPressure",
        "YoungsModulus",
        "Young's modulus of the members, for their buckling between nodes; 0 for unknown",
        0.0,
        "N/mm^2",
    ),
)


def section_of(obj):
    """The CrossSection that a Gridshell's properties describe, None without one.

    Raises InvalidInput that names the property.
    """
    if obj.SectionShape == NONE:
        return None
    sizes = [_size(obj, "SectionWidth")]
    if obj.SectionShape == RECTANGULAR:
        sizes.append(_size(obj, "SectionHeight"))
    strength, modulus = (amount(obj, name, "Pa") or None for name in ("CompressiveStrength", "YoungsModulus"))
    return CrossSection(*sizes, strength=strength, modulus=modulus)


def _size(obj, name):
    size = amount(obj, name, "mm") * METRES
    if size == 0.0:
        raise fn.InvalidInput(
            f"{name} is 0 mm: give a length greater than zero, or choose {NONE} as SectionShape"
        )
    return size
