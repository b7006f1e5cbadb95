# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where this addon lies: found by name from Init.py and InitGui.py, in which `__file__` is undefined."""

import os
import sys

# Not resolved: FreeCAD restores proxies only from modules under a Mod folder as it sees it, so a symlinked
# addon must keep the path of the link.
ROOT = os.path.dirname(os.path.abspath(__file__))
PACKAGE_FOLDER = os.path.join(ROOT, "src", "freecad_wb")
RESOURCE_FOLDER = os.path.join(ROOT, "Resources")
ICON_FOLDER = os.path.join(RESOURCE_FOLDER, "icons")
TRANSLATION_FOLDER = os.path.join(RESOURCE_FOLDER, "translations")
GUIDE = os.path.join(ROOT, "docs", "guide.md")


def add_package_to_path():
    """Make `import funicular` work; calling it again changes nothing."""
    if PACKAGE_FOLDER not in sys.path:
        sys.path.append(PACKAGE_FOLDER)
