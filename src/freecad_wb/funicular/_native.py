# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loading the native module, with a sentence that helps when it cannot be loaded."""

import importlib
import os
import pathlib
import re
import sys
import sysconfig


def load():
    """The native module `funicular._core`.

    Raises ImportError that says whether it is missing, was built for another Python, or why it does not load.
    """
    try:
        return importlib.import_module("funicular._core")
    except ImportError as error:
        raise ImportError(_explanation(error)) from error


def _explanation(error):
    this = f"{sys.version_info.major}.{sys.version_info.minor}"
    files = pathlib.Path(__file__).parent.glob("_core.*")
    built = sorted(_python_of(path.name) for path in files if path.suffix in (".so", ".pyd"))
    if not built:
        return (
            "Funicular's native module is not built. "
            "Run 'make build' in the Funicular folder, then start again."
        )
    if this not in built:
        return (
            f"Funicular's native module was built for Python {', '.join(built)}, but this is Python {this}. "
            f"Run 'make build PYTHON={_this_python()}' in the Funicular folder, then start again."
        )
    return (
        f"Funicular's native module does not load: {error}. "
        "Run 'make clean build' in the Funicular folder, then start again."
    )


def _this_python():
    """The interpreter to build for. Within FreeCAD's window `sys.executable` is FreeCAD itself."""
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    return os.path.join(sysconfig.get_config_var("BINDIR") or "", f"python{version}")


def _python_of(file_name):
    """The Python version in `_core.cpython-311-x86_64-linux-gnu.so` or `_core.cp311-win_amd64.pyd`."""
    match = re.search(r"\.(?:cpython-|cp)(\d)(\d+)", file_name)
    return f"{match.group(1)}.{match.group(2)}" if match else "unknown"
