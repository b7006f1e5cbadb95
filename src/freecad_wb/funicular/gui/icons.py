# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths of this addon's icons."""

import os

import funicular_locate


def icon(name):
    """Path of Resources/icons/<name>.svg, as FreeCAD's Pixmap and getIcon() take it."""
    return os.path.join(funicular_locate.ICON_FOLDER, name + ".svg")
