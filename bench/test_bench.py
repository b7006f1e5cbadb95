# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmarks run on tiny scenes, and what they write can be read. Nothing is timed.

test_bench.py core_bench
"""

import pathlib
import subprocess
import sys
import tempfile

import table

NEEDED = {
    "rise": {"rise", "rise_error", "target_rise_error"},
    "cold": {
        "backend",
        "seconds",
        "F_seconds",
        "ratio",
        "iterations",
        "residual",
        "position_error",
        "peak_megabytes",
    },
    "warm": {"seconds", "F_seconds", "ratio"},
    "factor": {"backend", "F_analyse", "F_factorise", "F_solve"},
    "forces": {"ns_per_node", "bytes_per_node"},
    "tangent": {"ns_per_node"},
}
SCENES = {"S", "C", "S100", "S_bare", "S_gap", "D", "T"}


def faults(rows):
    """What is wrong with the results, one sentence each."""
    found = [f"no row of kind {kind}" for kind in NEEDED if not any(row["kind"] == kind for row in rows)]
    found += [
        f"scene {name} was not solved" for name in SCENES - {r["scene"] for r in rows if r["kind"] == "cold"}
    ]
    for row in rows:
        name = f"{row['kind']}/{row['scene']}"
        if row["status"] not in ("converged", "measured"):
            found.append(f"{name} is {row['status']}")
        if row["kind"] == "rise" and row.get("met") != "yes":
            found.append(f"{name} rises {row.get('rise')} m, off by {row.get('rise_error')}")
        if row["kind"] == "cold" and not (row["residual"] <= 1e-6 and row["position_error"] <= 1e-4):
            found.append(f"{name} is not as accurate as was asked for")
        found += [f"{name} has no {column}" for column in NEEDED.get(row["kind"], set()) - set(row)]
    return found


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        results = pathlib.Path(folder) / "results.csv"
        command = [program, "--extent=tiny", f"--csv={results}", "--benchmark_min_time=0.001"]
        run = subprocess.run(command, check=False)
        found = faults(table.read(results))
    if run.returncode != 0:
        found.append(f"{program} ended with {run.returncode}")
    print("\n".join(found) or "every scene converged")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
