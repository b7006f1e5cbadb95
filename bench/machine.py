# SPDX-License-Identifier: LGPL-2.1-or-later
"""On what is measured, when, and how much, as JSON: machine.py file.json core_bench quick|full|part

Run it in FreeCAD (tools/freecad_run.py) to have FreeCAD's version as well.
"""

import datetime
import json
import os
import pathlib
import platform
import re
import subprocess
import sys

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[1]


def output(*command):
    """What a command prints; nothing where it cannot be run."""
    try:
        return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def commit():
    """The commit that is checked out, and whether a source differs from it."""
    changed = output("git", "status", "--porcelain", "--untracked-files=no", "--", ".", ":!docs")
    return output("git", "rev-parse", "--short", "HEAD") + (" with changes" if changed else "")


def processor():
    names = re.findall(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text("utf-8"))
    return names[0] if names else platform.machine()


def facts(core_bench):
    """{what: text}, in the order in which they are told."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    versions = dict(line.split("\t") for line in output(core_bench, "--versions").splitlines())
    freecad = sys.modules.get("FreeCAD")
    return {
        "date": datetime.date.today().isoformat(),
        "commit": commit(),
        "processor": f"{processor()}, {os.cpu_count()} cores",
        "load": f"{os.getloadavg()[0]:.1f}",
        "memory": f"{memory:.0f} GiB",
        **versions,
        "FreeCAD": ".".join(freecad.Version()[:3]).split(" ")[0] if freecad else "not asked",
        "Python": platform.python_version(),
        "numpy": numpy.__version__,
    }


def main(path, core_bench, extent):
    told = {"extent": extent, **facts(core_bench)}
    pathlib.Path(path).write_text(json.dumps(told, indent=1, ensure_ascii=False), "utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
