# SPDX-License-Identifier: LGPL-2.1-or-later
"""Put the built workbench into the Mod folder. Run by tools/freecad_run.py: only FreeCAD knows where that is.

    install.py           copy what the workbench needs at run time: `make install`
    install.py --link    link this checkout and let FreeCAD start in the workbench: `make gui`
"""

import os
import shutil
import sys
import tempfile

import FreeCAD as App

CHECKOUT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PACKAGE = os.path.join("src", "freecad_wb", "funicular")
# 0.20 and 1.0 answer …/FreeCAD, 1.1 …/FreeCAD/v1-1: asking spares a table of versions.
TARGET = os.path.join(App.getUserAppDataDir(), "Mod", "Funicular")


def parts():
    """What to copy, relative to the checkout."""
    modules = sorted(name for name in os.listdir(CHECKOUT) if name.endswith(".py"))
    guide = [os.path.join("docs", name) for name in ("guide.md", "guide")]
    return modules + [
        "package.xml",
        "LICENSE",
        "README.md",
        "Resources",
        *guide,
        os.path.join("src", "freecad_wb"),
    ]


def check_target():
    """Refuse to replace anything but an earlier copy."""
    if os.path.islink(TARGET):
        sys.exit(f"{TARGET} is a link to {os.readlink(TARGET)}: remove it first, then install again.")
    if not os.path.exists(TARGET):
        return
    try:
        with open(os.path.join(TARGET, "package.xml"), encoding="utf-8") as description:
            ours = "<name>Funicular</name>" in description.read()
    except FileNotFoundError:
        ours = False
    if not ours:
        sys.exit(f"{TARGET} holds something else than this workbench: move it away, then install again.")


def copy_addon():
    if not any(name.startswith("_core.") for name in os.listdir(os.path.join(CHECKOUT, PACKAGE))):
        sys.exit("The compiled module is missing: run `make build` first.")
    check_target()
    # An interrupted copy must not leave half a workbench behind.
    os.makedirs(os.path.dirname(TARGET), exist_ok=True)
    with tempfile.TemporaryDirectory(dir=App.getUserAppDataDir()) as staging:
        for part in parts():
            source, target = os.path.join(CHECKOUT, part), os.path.join(staging, "new", part)
            if os.path.isdir(source):
                shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                os.makedirs(os.path.dirname(target), exist_ok=True)
                shutil.copy2(source, target)
        if os.path.exists(TARGET):
            os.rename(TARGET, os.path.join(staging, "old"))
        os.rename(os.path.join(staging, "new"), TARGET)
    print(f"Installed in {TARGET}; FreeCAD shows the workbench after its next start.")


def link_addon():
    os.makedirs(os.path.dirname(TARGET), exist_ok=True)
    if os.path.islink(TARGET):
        os.remove(TARGET)
    os.symlink(CHECKOUT, TARGET)
    general = App.ParamGet("User parameter:BaseApp/Preferences/General")
    general.SetString("AutoloadModule", "FunicularWorkbench")
    App.saveParameter()


if sys.argv[1:] == ["--link"]:
    link_addon()
else:
    copy_addon()
