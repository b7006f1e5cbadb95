# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits the exponents of funicular/prediction.json to random scenes, and tries them on others.

    prediction.py measure rows.json --seed 1 --minutes 10     solves scenes and keeps what they took
    prediction.py fit train.json … --held-out held.json       writes the exponents, tells how often they held
    prediction.py try --seed 7 --count 60                     predicts new scenes, solves them, compares
"""

import argparse
import json
import pathlib
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "src" / "freecad_wb"))

import funicular as fn  # noqa: E402
from funicular import prediction  # noqa: E402
from random_scenes import random_scene  # noqa: E402

MAX_SECONDS = 20.0
# Weight of the exponents themselves in the fit, and the error [log] from which a row counts less.
RIDGE, RIDGE_OF_WAY, FAR = 0.3, 30.0, 0.15


def seconds_of(scene, accuracy):
    """CPU seconds of a solve, of short ones the least of three; None if it did not converge."""
    best = np.inf
    for _ in range(3):
        begun = time.process_time()
        result = fn.solve(scene, accuracy=accuracy, max_seconds=MAX_SECONDS)
        best = min(best, time.process_time() - begun)
        if result.status != "converged":
            return None
        if best > 0.3:
            break
    return best


def scenes_of(seed, count):
    rng = np.random.default_rng(seed)
    made = 0
    while made < count:
        try:
            yield random_scene(rng)
        except fn.InvalidInput:
            continue
        made += 1


def measure(path, seed, minutes):
    rows, end = [], time.monotonic() + 60.0 * minutes
    for scene, accuracy in scenes_of(seed, 10**6):
        kind, features = prediction.features_of(scene, accuracy)
        seconds = seconds_of(scene, accuracy)
        if seconds is not None:
            rows.append({"way": " ".join(kind), "features": features.tolist(), "seconds": seconds})
        if time.monotonic() > end:
            break
    path.write_text(json.dumps(rows), "utf-8")
    print(f"{path}: {len(rows)} scenes")


def fitted(features, seconds, near=0.0, ridge=RIDGE):
    """Least absolute errors of logarithms, by weighted least squares, not far from the exponents `near`."""
    near = np.broadcast_to(near, features.shape[1])
    seconds = seconds - features @ near
    weights, ridge = np.ones(len(seconds)), ridge * np.diag(0.01 + features.var(axis=0))
    ridge[0, 0] = 1e-3
    for _ in range(30):
        exponents = np.linalg.solve(
            (features.T * weights) @ features + ridge, (features.T * weights) @ seconds
        )
        weights = 1.0 / np.maximum(np.abs(features @ exponents - seconds), FAR)
    return near + exponents


def table(rows, way):
    rows = [row for row in rows if way in (row["way"], row["way"].split()[0])]
    seconds = np.log([max(row["seconds"], prediction.SHORTEST) for row in rows])
    return np.array([row["features"] for row in rows]), seconds


def told(name, ratios):
    within = np.mean((ratios < 2.0) & (ratios > 0.5))
    print(f"{name}: {len(ratios)} scenes, {100 * within:.0f} % within a factor of 2")


def fit(train, held_out):
    rows = [row for path in train for row in json.loads(path.read_text("utf-8"))]
    held = json.loads(held_out.read_text("utf-8")) if held_out else []
    exponents, all_ratios = {}, []
    for way in sorted({row["way"] for row in rows}):
        features, seconds = table(rows, way)
        # Some ways are few scenes': what all nets of the kind have in common stands for what they do not say.
        exponents[way] = fitted(features, seconds, fitted(*table(rows, way.split()[0])), RIDGE_OF_WAY)
        told(f"{way}, fitted to", np.exp(features @ exponents[way] - seconds))
        features, seconds = table(held, way)
        if len(seconds):
            ratios = np.exp(features @ exponents[way] - seconds)
            told(f"{way}, held out", ratios)
            all_ratios.append(ratios)
    if held:
        told("all held out", np.concatenate(all_ratios))
    content = {name: [round(value, 4) for value in each.tolist()] for name, each in exponents.items()}
    target = pathlib.Path(prediction.__file__).with_suffix(".json")
    target.write_text(json.dumps(content, indent=1) + "\n", "utf-8")
    print(f"written: {target.relative_to(ROOT)}")


def try_out(seed, count):
    ratios = []
    for scene, accuracy in scenes_of(seed, count):
        price = fn.predict(scene, accuracy)
        seconds = seconds_of(scene, accuracy)
        if seconds is None:
            continue
        ratios.append(price.seconds / max(seconds, prediction.SHORTEST))
        print(
            f"{len(scene.net.nodes):6} nodes, {price.way[0]:10} {price} told, {seconds:.3g} s: "
            f"{ratios[-1]:.2g}"
        )
    told("new scenes", np.array(ratios))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    measuring = commands.add_parser("measure")
    measuring.add_argument("path", type=pathlib.Path)
    measuring.add_argument("--seed", type=int, default=1)
    measuring.add_argument("--minutes", type=float, default=10.0)
    fitting = commands.add_parser("fit")
    fitting.add_argument("train", type=pathlib.Path, nargs="+")
    fitting.add_argument("--held-out", type=pathlib.Path)
    trying = commands.add_parser("try")
    trying.add_argument("--seed", type=int, default=7)
    trying.add_argument("--count", type=int, default=60)
    given = parser.parse_args()
    if given.command == "measure":
        measure(given.path, given.seed, given.minutes)
    elif given.command == "fit":
        fit(given.train, given.held_out)
    else:
        try_out(given.seed, given.count)


if __name__ == "__main__":
    main()
