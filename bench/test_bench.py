# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmarks run on tiny scenes, what they write can be read, and becomes a page. Nothing is timed.

test_bench.py core_bench
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import machine
import page
import table

sys.path.append(str(pathlib.Path(__file__).resolve().parent / "peers"))

from run import last_words  # noqa: E402

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


# The files of a run as a page is made from: one target met and one missed, a time limit, a package left out.
FILES = {
    "results": """\
kind,scene,status,nodes,seconds,F_seconds,ratio,peak_megabytes,target_ratio,target_seconds
cold,S,converged,10201,0.0574,0.061,0.941,45,0.7,
cold,D,converged,10001,0.432,0.108,4,62,4,
cold,T,iteration_limit,10201,3.2,0.078,41,98,4,
warm,S,converged,10201,0.0156,0.061,0.256,45,,0.016
""",
    "accuracy": """\
scene,nodes,method,accuracy,seconds,status,estimated_error,true_error
flat,121,auto,0.01,0.0021,converged,2e-5,3e-5
flat,121,auto,0.001,0.0023,converged,2e-5,3e-5
flat,121,relaxation,0.01,5.01,time_limit,inf,0.04
""",
    "costs": """\
nodes,effect,seconds,share,evaluations,bytes,seconds_without,saved,moved,dispensable,sentence
961,axial,0.0012,0.08,50,46128,,,,False,
961,snow,0.0035,0.234,41,32,0.0052,0.31,0.0021,False,without snow
""",
    "documents": """\
nodes,net_seconds,gridshell_seconds,solver_seconds,save_seconds,open_seconds,covering_seconds,megabytes
1089,0.0131,0.0336,0.0187,0.083,0.0841,0.147,0.36
""",
    "frames": """\
what,nodes,frames,median,longest
rising,2500,24,0.0115,0.0155
""",
    "peers": """\
peer,version,model,status,nodes,tolerance,seconds,first_seconds,setup_seconds,residual,shape_distance,reason
compas_fd,0.50,force densities,measured,121,1e-6,0.0038,0.0057,0.0002,5e-14,0,
compas_dr,,,not installed,,,,,,,,No matching distribution
funicular,,force densities,measured,121,1e-4,0.0013,0.0018,0.0139,7e-6,7e-7,
funicular,,force densities,measured,121,1e-6,0.0014,0.0018,0.0139,2e-8,9e-10,
funicular,,springs,time_limit,121,1e-2,60.2,60.2,0.0139,0.2,,
""",
}
# What the page must say of them.
SAID = (
    "2 of 4 targets",
    "| S, cold | 10,201 | 0.94 F | 0.7 F | missed |",
    "| D, cold | 10,001 | 4 F | 4 F | met |",
    "| T, cold | 10,201 | 41 F | 4 F | missed |",
    "| S, weights + 5 % | 10,201 | 16 ms | 16 ms | met |",
    "| 10,201 | 57 ms (0.94 F) | 432 ms (4 F) | iteration limit |",
    "was at most 1.5 times the one",
    "| flat, 121 nodes | relaxation | time limit after 5 s | not asked |",
    "| snow | 41 | 3.5 ms | 23 % | 32 | 31 % | 2.1 mm |",
    "| 1,089 | 13 ms | 34 ms | 19 ms | 83 ms | 84 ms | 147 ms | 0.4 MB |",
    "| rising | 2,500 | 24 | 12 ms | 16 ms |",
    "| compas_fd 0.50 | 3.8 ms |",
    "| **Funicular** | 1.4 ms |",
    "| **Funicular** | 2·10⁻¹ after 60 s |",
    "| **Funicular** | 121 | 14 ms | 1.8 ms | 2·10⁻⁸ | 900 pm |",
    "compas_dr was left out, not installed: No matching distribution",
)
COMPLAINT = """\
Looking in links: /home/somebody/wheels
ERROR: Could not find a version of compas_dr in https://pypi.example.org/simple/ or /home/somebody/wheels
"""


def page_faults(folder, program):
    """What is wrong with the page of these files, one sentence each."""
    for name, text in FILES.items():
        (folder / f"{name}.csv").write_text(text, "utf-8")
    told = {"extent": "quick", **machine.facts(program)}
    (folder / "machine.json").write_text(json.dumps(told), "utf-8")
    page.main(folder)
    if not (folder / "performance.md").exists():
        return ["the page of a quick run is not where its results are"]
    text = (folder / "performance.md").read_text("utf-8")
    found = [f"the page does not say: {sentence}" for sentence in SAID if sentence not in text]
    found += [f"the page names {path}" for path in (str(folder), str(page.ROOT), "nan") if path in text]
    for name in ("solver", "accuracy", "documents", "peers"):
        picture = folder / f"performance-{name}.png"
        if picture.name not in text or picture.stat().st_size < 10_000:
            found.append(f"the page has no {picture.name}")
    (folder / "machine.json").write_text(json.dumps({**told, "extent": "full"}), "utf-8")
    if page.place_of(folder) != page.ROOT / "docs" / "performance.md":
        found.append("the page of a full run does not go into docs/")
    (folder / "peers.json").write_text(json.dumps({**told, "extent": "quick"}), "utf-8")
    if page.place_of(folder).parent != folder:
        found.append("packages that were timed in a quick run go into docs/")
    if last_words(COMPLAINT) != "ERROR: Could not find a version of compas_dr in … or …":
        found.append(f"why a package is missing reads: {last_words(COMPLAINT)}")
    return found


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        results = pathlib.Path(folder) / "results.csv"
        command = [program, "--extent=tiny", f"--csv={results}", "--benchmark_min_time=0.001"]
        run = subprocess.run(command, check=False)
        found = faults(table.read(results))
        found += page_faults(pathlib.Path(folder), program)
    if run.returncode != 0:
        found.append(f"{program} ended with {run.returncode}")
    print("\n".join(found) or "every scene converged, and the page says so")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
