# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs in time: one scene solved to several accuracies by several methods, and measured.

How far a shape is from equilibrium is told by the solver (`position_error`) and measured here against a shape
that is solved as far as numbers go. Lengths are metres. Needs numpy; matplotlib for the picture alone.
"""

import csv
from dataclasses import dataclass, field

import numpy as np

import funicular as fn

ACCURACIES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)  # [m]
METHODS = ("auto", "newton", "relaxation")

# Loose, so that it is the accuracy that decides when a solve ends: at 1e-2 of the nodal loads the distance
# that the solver tells holds.
TOLERANCE = 1e-2

# Of the shape that the others are measured against: accuracy relative to the net's size, and residual.
REFERENCE_ACCURACY, REFERENCE_TOLERANCE = 1e-12, 1e-10

# Columns of a row, in the order of the file; seconds are those in the solver.
COLUMNS = (
    "method",
    "accuracy",
    "seconds",
    "iterations",
    "status",
    "estimated_error",
    "true_error",
    "residual",
    "compression_only",
)


@dataclass
class Study:
    """What was measured so far.

    rows: list of dicts with the keys of COLUMNS: accuracy asked for, estimated and true error in metres, the
    true one being the largest distance of a node from where it is in equilibrium. reference: the shape that
    stands for that, (n, 3) [m], without rows if it was cancelled before. cancelled: whether some rows are
    missing.
    """

    reference: np.ndarray
    rows: list = field(default_factory=list)
    cancelled: bool = False

    def write(self, path):
        """The rows as a CSV file; lengths in metres, times in seconds."""
        with open(path, "w", newline="", encoding="utf-8") as file:
            table = csv.DictWriter(file, COLUMNS)
            table.writeheader()
            table.writerows(self.rows)

    def plot(self, path, chosen=None):
        """Draws time against true error, and against the estimate, into a picture file.

        chosen: an accuracy [m] to be marked. The suffix of the path says what kind of picture.
        """
        from .accuracy_picture import draw

        draw(self, path, chosen)


def accuracy_study(
    scene, accuracies=ACCURACIES, methods=METHODS, on_progress=None, max_seconds=60.0, on_report=None
):
    """The Study of a scene: each accuracy by each method.

    scene: a Scene. accuracies: [m]. methods: of fn.solve. on_progress(row) is called with each row as it is
    measured; returning False ends the study there. max_seconds: for each solve; what takes longer has its
    status say so, and the method is not asked for more. on_report(method, accuracy, report) is called within
    each solve as fn.solve calls its on_progress, with None and None while the shape to measure against is
    sought; returning False ends the study there, without the row that is being measured.

    Raises InvalidInput for accuracies that cannot be meant, and where the scene has no equilibrium that is
    found: there is nothing to measure against then.
    """
    wanted = sorted({_checked(accuracy) for accuracy in accuracies}, reverse=True)
    reference = _reference(scene, _within(on_report, None, None))
    study = Study(reference, cancelled=not len(reference))
    if study.cancelled:
        return study
    for method in methods:
        for accuracy in wanted:
            watch = _within(on_report, method, accuracy)
            row = _measured(scene, method, accuracy, study.reference, max_seconds, watch)
            study.cancelled = row["status"] == "cancelled"
            if not study.cancelled:
                study.rows.append(row)
                study.cancelled = on_progress is not None and on_progress(row) is False
            if study.cancelled:
                return study
            if row["status"] != "converged":
                break
    return study


def _checked(accuracy):
    if not (np.isreal(accuracy) and 0.0 < accuracy < np.inf):
        raise fn.InvalidInput(f"accuracies holds {accuracy!r}: give lengths in metres, such as 1e-3")
    return float(accuracy)


def _within(on_report, method, accuracy):
    """What fn.solve is to call while it measures this."""
    return None if on_report is None else lambda report: on_report(method, accuracy, report)


def _reference(scene, watch):
    """The shape in equilibrium, as far as rounding lets one tell; no node where it was cancelled."""
    result = fn.solve(
        scene,
        accuracy=REFERENCE_ACCURACY * scene.net.size,
        tolerance=REFERENCE_TOLERANCE,
        max_seconds=600.0,
        on_progress=watch,
    )
    if result.status == "cancelled":
        return np.empty((0, 3))
    if result.status != "converged" and not result.residual <= 1e-8:
        raise fn.InvalidInput(f"there is nothing to measure against: {result.message}")
    return np.array(result.nodes)


def _measured(scene, method, accuracy, reference, max_seconds, watch):
    result = fn.solve(
        scene,
        accuracy=accuracy,
        tolerance=TOLERANCE,
        method=method,
        max_seconds=max_seconds,
        on_progress=watch,
    )
    certificate = fn.certify(scene, result)
    return {
        "method": method,
        "accuracy": accuracy,
        "seconds": result.seconds,
        "iterations": result.iterations,
        "status": result.status,
        "estimated_error": result.position_error,
        "true_error": float(np.linalg.norm(result.nodes - reference, axis=1).max()),
        "residual": result.residual,
        "compression_only": certificate.compression_only,
    }
