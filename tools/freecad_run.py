# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a Python script inside headless FreeCAD, as `python3 script.py arguments…` would run it.

    /usr/bin/python3 tools/freecad_run.py script.py [argument …]

`freecadcmd script.py` exits 0 after an uncaught exception, runs the body twice then, takes further
arguments for files to open and, from 1.0 on, drops buffered output on `sys.exit`. So freecadcmd is given this
file, which finds script and arguments in the environment, runs it once and leaves with its exit code.

FREECADCMD names the program when it is not on the PATH as `freecadcmd` or `FreeCADCmd`.
"""

import ctypes
import json
import os
import runpy
import shutil
import sys
import traceback

COMMAND_LINE = "FUNICULAR_RUN"
STDOUT = "FUNICULAR_STDOUT"


def start_freecad(command_line):
    """Replace this process by freecadcmd, which will run `command_line` (script, arguments…)."""
    program = os.environ.get("FREECADCMD") or shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if not program:
        sys.exit("freecadcmd is not on the PATH: install FreeCAD or set FREECADCMD to the program.")
    os.environ[COMMAND_LINE] = json.dumps(command_line)
    # FreeCAD greets and shows progress on standard output, where only what the script prints is wanted.
    # Warnings and errors are on standard error and stay.
    stdout = os.dup(1)
    os.set_inheritable(stdout, True)
    os.environ[STDOUT] = str(stdout)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    os.execv(program, [program, os.path.abspath(__file__)])


def run_script():
    """Inside FreeCAD: run the script named in the environment; never returns."""
    sys.stdout = open(int(os.environ.pop(STDOUT)), "w", encoding="utf-8", buffering=1)
    sys.argv = json.loads(os.environ.pop(COMMAND_LINE))
    code = 0
    try:
        checkout = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
        # As python3 does, the script's own folder first; then this checkout's package, installed or not.
        sys.path[:0] = [
            os.path.dirname(os.path.abspath(sys.argv[0])),
            os.path.join(checkout, "src", "freecad_wb"),
        ]
        runpy.run_path(sys.argv[0], run_name="__main__")
    except SystemExit as leaving:
        code = leaving.code
        if isinstance(code, str):
            print(code, file=sys.stderr)
        code = code if isinstance(code, int) else int(code is not None)
    except BaseException:
        traceback.print_exc()
        code = 1
    sys.stdout.flush()
    sys.stderr.flush()
    # FreeCAD.Console writes its errors through C's stdio, which os._exit does not flush.
    ctypes.CDLL(None).fflush(None)
    # FreeCAD would go on to its console, or turn the exit code to 0.
    os._exit(code)


if "FreeCAD" in sys.modules:
    run_script()
elif len(sys.argv) < 2:
    sys.exit(__doc__)
else:
    start_freecad(sys.argv[1:])
