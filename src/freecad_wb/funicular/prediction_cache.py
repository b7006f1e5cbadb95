# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast this machine is next to the one that the exponents of `prediction` were fitted on: a user's cache.

A cache that cannot be read or written is no error: then the machine is measured anew in each session.
"""

import json
import os
import pathlib
import platform
import re
import sys
import zlib

import numpy as np

from . import _native

# What is in the file; one of another version is made anew.
VERSION = 1

# Each solve corrects a factor by a part of the way: one that was disturbed shall count for little.
PART_OF_WAY = 0.25

_factors = {}


def folder():
    """Where the cache is: FUNICULAR_CACHE if it is set, or the folder that the system has for such files."""
    if os.environ.get("FUNICULAR_CACHE"):
        return pathlib.Path(os.environ["FUNICULAR_CACHE"])
    home = pathlib.Path(os.path.expanduser("~"))
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local"
    elif sys.platform == "darwin":
        base = home / "Library" / "Caches"
    else:
        base = os.environ.get("XDG_CACHE_HOME") or home / ".cache"
    return pathlib.Path(base) / "funicular"


def is_calibrated():
    """Whether this machine was measured, by this version."""
    return bool(_factors or _read())


def factor(path):
    """Times that solves of this kind take here, as a multiple of those there."""
    return _factors.get(path, 1.0)


def keep(factors):
    """Takes over what was measured, for this session and the next."""
    _factors.clear()
    _factors.update(factors)
    content = {"version": VERSION, "machine": _machine(), "factors": _factors}
    try:
        folder().mkdir(parents=True, exist_ok=True)
        # Of this process alone: several may write at once, and the last one counts.
        whole = folder() / f"prediction.json.{os.getpid()}"
        whole.write_text(json.dumps(content), "utf-8")
        whole.replace(folder() / "prediction.json")
    except OSError:
        pass


def observe(path, ratio):
    """Corrects the factor of a kind of solves by what one really took, as a multiple of the prediction."""
    if is_calibrated() and 0.0 < ratio < np.inf:
        # As far as one solve can be trusted: it may have been disturbed, or an odd one.
        step = float(np.clip(np.log(ratio), -1.0, 1.0))
        keep({**_factors, path: factor(path) * float(np.exp(PART_OF_WAY * step))})


def forget():
    """The machine is to be measured anew at the next prediction."""
    _factors.clear()
    try:
        (folder() / "prediction.json").unlink()
    except OSError:
        pass


def _read():
    try:
        content = json.loads((folder() / "prediction.json").read_text("utf-8"))
        factors = {str(path): float(value) for path, value in content["factors"].items()}
        if (content["version"], content["machine"]) != (VERSION, _machine()):
            return False
    except (OSError, ValueError, TypeError, KeyError, AttributeError):
        return False
    if not factors or not all(0.0 < value < np.inf for value in factors.values()):
        return False
    _factors.update(factors)
    return True


def _machine():
    """What factors depend on: the processor, and the core that was built for it."""
    core = zlib.crc32(pathlib.Path(_native.load().__file__).read_bytes())
    return f"{_processor()}, {os.cpu_count()} cores, core {core:08x}"


def _processor():
    """Its name; on Linux `platform` does not tell it."""
    try:
        names = re.findall(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text("utf-8"))
    except OSError:
        names = []
    return names[0] if names else platform.processor() or platform.machine()
