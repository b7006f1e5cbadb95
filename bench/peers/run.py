# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installs other packages into an environment of their own, and times them beside Funicular: run.py [quick]

What cannot be installed or run is left out, and the reason is printed and kept in the results.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from measure import COLUMNS, Rows

HERE = pathlib.Path(__file__).resolve().parent
BUILD = HERE.parents[1] / "build"
ENVIRONMENT, RESULTS, SHAPES = BUILD / "peers", BUILD / "bench" / "peers.csv", BUILD / "bench" / "peers"
PEERS = ("compas_fd", "compas_tna", "jax_fdm", "compas_dr", "compas_shapeop")
LONGEST_INSTALL, LONGEST_RUN = 900, 1200  # [s]
THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
ONE_THREAD = {
    **{name: "1" for name in THREADS},
    "XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false",
    "JAX_PLATFORMS": "cpu",
    # They say how a division by zero comes out, once a run.
    "PYTHONWARNINGS": "ignore::RuntimeWarning",
}


def main(extent="full"):
    make_environment()
    shutil.rmtree(SHAPES, ignore_errors=True)
    SHAPES.mkdir(parents=True)
    Rows(RESULTS, COLUMNS)
    python = str(ENVIRONMENT / "bin" / "python")
    for peer in PEERS:
        reason = failure([python, "-m", "pip", "install", "--quiet", peer], LONGEST_INSTALL)
        if reason:
            leave_out(peer, "not installed", reason)
        else:
            measure(python, peer, extent)
    # Last, as its springs are made of what others found.
    measure(sys.executable, "funicular", extent)


def make_environment():
    if (ENVIRONMENT / "bin" / "python").exists():
        return
    reason = failure([sys.executable, "-m", "venv", "--clear", str(ENVIRONMENT)], LONGEST_INSTALL)
    if reason:
        shutil.rmtree(ENVIRONMENT, ignore_errors=True)
        sys.exit(
            f"bench-peers: no virtual environment can be made ({reason}): on Debian, install python3-venv"
        )


def measure(python, peer, extent):
    command = [python, str(HERE / "measure.py"), peer, str(RESULTS), str(SHAPES), extent]
    reason = failure(command, LONGEST_RUN, {**os.environ, **ONE_THREAD}, shown=True)
    if reason:
        leave_out(peer, "failed", reason)


def failure(command, most_seconds, environment=None, shown=False):
    """Runs a command; why it failed in a sentence's length, and None where it did not."""
    try:
        run = subprocess.run(
            command,
            env=environment,
            stdout=None if shown else subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            timeout=most_seconds,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return f"it took longer than {most_seconds} s"
    if run.returncode == 0:
        return None
    return last_words(run.stderr) or f"it ended with {run.returncode}"


def last_words(errors):
    """The last line that says what is wrong, without the paths and addresses of this machine."""
    lines = [line.strip() for line in errors.splitlines() if line.strip()]
    telling = [line for line in lines if "rror" in line] or lines[-1:]
    return re.sub(r"(\w+://|/)[^\s'\"]*/[^\s'\"]*", "…", telling[-1])[:300] if telling else ""


def leave_out(peer, status, reason):
    Rows(RESULTS, COLUMNS, "a").add({"peer": peer, "status": status, "reason": reason})


if __name__ == "__main__":
    main(*sys.argv[1:])
