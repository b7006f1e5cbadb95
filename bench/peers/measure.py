# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times one package on every size of the problem, and measures what it found: adds rows to a CSV file.

    measure.py PACKAGE results.csv FOLDER quick|full

FOLDER keeps the shapes that were found for given force densities, which Funicular's springs are made from.
"""

import importlib
import importlib.metadata
import pathlib
import sys

import numpy as np
from problem import flat_net, residual

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))

from measuring import Rows, repeated, timed  # noqa: E402

COLUMNS = (
    "peer",
    "version",
    "model",
    "status",
    "nodes",
    "tolerance",
    "seconds",
    "first_seconds",
    "setup_seconds",
    "runs",
    "residual",
    "shape_distance",
    "reason",
)
TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8)
GOAL = 1e-6
# (nodes a side, the longest solve [s])
EXTENTS = {"quick": ((11, 23), 10.0), "full": ((11, 23, 45, 101), 60.0)}


def rows_of(peer, adapter, folder, sides, most_seconds):
    """A dict for each size and tolerance, as it is measured. It ends where a solve takes too long."""
    for model in adapter.MODELS:
        for side in sides:
            problem = flat_net(side)
            kept = folder / f"{model.replace(' ', '-')}-{side}.npy"
            found = np.load(kept) if kept.exists() else None
            if peer == "funicular" and model == "force densities" and found is None:
                # Nobody has solved it, so there are no springs to make of it.
                continue
            given = {"found": found} if peer == "funicular" else {}
            solve, setup = timed(lambda: adapter.prepare(problem, model, **given))
            late = False
            for tolerance in TOLERANCES if adapter.ITERATES else (GOAL,):
                shape, first, seconds, runs = repeated(lambda: solve(tolerance, most_seconds))
                shape = np.asarray(shape)
                left_over = residual(problem, model, shape)
                late = seconds >= most_seconds and not left_over <= tolerance
                if found is None and left_over <= GOAL:
                    np.save(kept, shape)
                    found = shape
                yield {
                    "peer": peer,
                    "version": "" if peer == "funicular" else importlib.metadata.version(peer),
                    "model": model,
                    "status": "time_limit" if late else "measured",
                    "nodes": side * side,
                    "tolerance": tolerance,
                    "seconds": seconds,
                    "first_seconds": first,
                    "setup_seconds": setup,
                    "runs": runs,
                    "residual": left_over,
                    "shape_distance": (
                        float(np.linalg.norm(shape - found, axis=1).max()) if found is not None else ""
                    ),
                }
                if late:
                    break
            if late:
                break


def main(peer, results, folder, extent):
    adapter = importlib.import_module(f"with_{peer}")
    sides, most_seconds = EXTENTS[extent]
    rows = Rows(results, COLUMNS, "a")
    for row in rows_of(peer, adapter, pathlib.Path(folder), sides, most_seconds):
        rows.add(row)


if __name__ == "__main__":
    main(*sys.argv[1:])
