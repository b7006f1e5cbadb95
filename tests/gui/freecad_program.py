# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start the freecad program, with a home of its own, and let it run test cases."""

import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys

CHECKOUT = pathlib.Path(__file__).parents[2]
INSIDE = pathlib.Path(__file__).parent / "inside"
PICTURES = CHECKOUT / "build" / "gui"
ADDON_PARTS = ("Init.py", "InitGui.py", "funicular_locate.py", "package.xml", "Resources", "src/freecad_wb")

DISPLAY = ("xvfb-run", "--auto-servernum", "--server-args=-screen 0 1600x1000x24")

# Files with cases that are longer than most.
LONG_CASES = {"cases_session.py": 15, "cases_live.py": 2, "cases_held_by_hand.py": 2}

# A hung window must end the run; no case measures time.
LONGEST_RUN = 900


def environment(home):
    """The environment in which FreeCAD keeps settings and addons below `home` and touches nothing of the
    user's."""
    mine = {name: value for name, value in os.environ.items() if not name.startswith(("XDG_", "PYTEST_"))}
    # The addon must be found as FreeCAD finds it, not because the tests were started with a path to it.
    mine.pop("PYTHONPATH", None)
    mine.update(
        FREECAD_USER_HOME=str(home), HOME=str(home), QTWEBENGINE_DISABLE_SANDBOX="1", LC_ALL="C.UTF-8"
    )
    return mine


def link_addon(home):
    """Make this checkout the one addon below `home`, by the installer that users run."""
    command = [
        sys.executable,
        CHECKOUT / "tools" / "freecad_run.py",
        CHECKOUT / "tools" / "install.py",
        "--link",
    ]
    subprocess.run(command, check=True, env=environment(home), timeout=LONGEST_RUN)


def copy_addon_without_core(home):
    """Put the addon below `home` without its native module. Returns the folder the module would be in."""
    link_addon(home)
    (link,) = pathlib.Path(home).rglob("Mod/Funicular")
    link.unlink()
    for part in ADDON_PARTS:
        source, target = CHECKOUT / part, link / part
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__", "_core.*"))
        else:
            shutil.copy2(source, target)
    return link / "src" / "freecad_wb" / "funicular"


def run_cases_side_by_side(homes, names):
    """As run_cases(), by as many FreeCADs as there are homes, each on a display of its own.

    Cases of one file stay together: some of them are quicker after others.
    """
    shares = [[] for _ in homes]
    for names_of_file in sorted(_by_file(names), key=_weight, reverse=True):
        min(shares, key=_weight).extend(names_of_file)
    with concurrent.futures.ThreadPoolExecutor() as pool:
        runs = [pool.submit(run_cases, home, share, DISPLAY) for home, share in zip(homes, shares) if share]
        outcomes = {}
        for run, share in zip(runs, filter(None, shares)):
            of_run = run.result()
            ended = of_run.pop(None)
            outcomes.update(of_run)
            # How the program ended matters for those that it did not come to.
            outcomes.update({(None, name): ended for name in share})
    return outcomes


def _by_file(names):
    files = {}
    for name in names:
        files.setdefault(name.partition("::")[0], []).append(name)
    return files.values()


def _weight(names):
    """About how long these take, in cases of common length."""
    return sum(LONG_CASES.get(name.partition("::")[0], 1) for name in names)


def run_cases(home, names, display=()):
    """Run cases of inside/ within FreeCAD. display: what to start it by, for a screen of its own.

    Returns
    -------
    dict
        {name: (outcome, report)}; a case that FreeCAD never came to, because it crashed, is missing, and the
        key None holds how the program ended and what it printed.
    """
    results = pathlib.Path(home) / "results.jsonl"
    PICTURES.mkdir(parents=True, exist_ok=True)
    order = dict(cases=names, results=str(results), pictures=str(PICTURES), inside=str(INSIDE))
    program = os.environ.get("FREECAD") or shutil.which("freecad") or shutil.which("FreeCAD")
    run = subprocess.run(
        [*display, program, INSIDE / "run_cases.py"],
        env=dict(environment(home), FUNICULAR_GUI_CASES=json.dumps(order)),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        timeout=LONGEST_RUN,
    )
    outcomes = {None: (f"exit code {run.returncode}", run.stdout)}
    if results.exists():
        for line in results.read_text(encoding="utf-8").splitlines():
            record = json.loads(line)
            # A case with parameters is one case, and its worst is its outcome.
            name = record["case"].partition("[")[0]
            if outcomes.get(name, ("passed", ""))[0] == "passed":
                outcomes[name] = (record["outcome"], record["report"])
    return outcomes
