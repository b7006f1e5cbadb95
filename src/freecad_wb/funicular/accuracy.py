# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs in time: one scene solved to several accuracies by several methods, and measured.

Two errors are told apart. How far a shape is from equilibrium is told by the solver (`position_error`) and
measured here against a shape that is solved as far as numbers go. How far the net is from the smooth surface
that it stands for is estimated on lattices, by nets of larger steps (`net_error`). Lengths are metres. Needs
numpy; matplotlib for the picture alone.
"""

import csv
from dataclasses import dataclass, field

import numpy as np

import funicular as fn

from .discretisation import Cancelled, from_shapes, is_length, solved_far
from .discretisation import coarser as nets_coarser_than

ACCURACIES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)  # [m]
METHODS = ("auto", "newton", "relaxation")

# Loose, so that it is the accuracy that decides when a solve ends: at 1e-2 of the nodal loads the distance
# that the solver tells holds.
TOLERANCE = 1e-2

# Columns of a row, in the order of the file; seconds are those in the solver.
COLUMNS = (
    "method",
    "step",
    "accuracy",
    "seconds",
    "iterations",
    "status",
    "estimated_error",
    "true_error",
    "net_error",
    "residual",
    "compression_only",
)


@dataclass
class Study:
    """What was measured so far.

    rows: list of dicts with the keys of COLUMNS: step, the mean length of members on the source, accuracy
    asked for, estimated and true error in metres, the true one being the largest distance of a node from
    where it is in equilibrium; net_error, the estimated distance of that equilibrium from the smooth surface,
    None where there is no coarser net to tell it by. reference: the scene's own shape in equilibrium,
    (n, 3) [m], without rows if the study was cancelled before. of_net: the NetError of the scene's own net,
    or None. cancelled: whether some rows are
    missing.
    """

    reference: np.ndarray
    of_net: object = None
    rows: list = field(default_factory=list)
    cancelled: bool = False

    def rows_of_own_step(self):
        """The rows of the scene's own net."""
        return [row for row in self.rows if row["step"] == self.rows[0]["step"]]

    def write(self, path):
        """The rows as a CSV file; lengths in metres, times in seconds."""
        write_rows(path, COLUMNS, self.rows)

    def plot(self, path, chosen=None, method=None):
        """Draws time against true error, and against the estimate, into a picture file.

        chosen: an accuracy [m] to be marked, by that method or, without, by each. The suffix of the path says
        what kind of picture.
        """
        from .accuracy_picture import draw

        draw(self, path, chosen, method)


def write_rows(path, columns, rows):
    """Rows of a study, dicts with the keys `columns`, as a CSV file with these as its header."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, columns)
        table.writeheader()
        table.writerows(rows)


def accuracy_study(
    scene,
    accuracies=ACCURACIES,
    methods=METHODS,
    on_progress=None,
    max_seconds=60.0,
    on_report=None,
    coarser=2,
):
    """The Study of a scene: each accuracy by each method, and on lattices the same on coarser nets.

    scene: a Scene. accuracies: [m]. methods: of fn.solve. on_progress(row) is called with each row as it is
    measured; returning False ends the study there. max_seconds: for each solve; what takes longer has its
    status say so, and the method is not asked for more. on_report(method, accuracy, report) is called within
    each solve as fn.solve calls its on_progress, with None and None while a shape to measure against is
    sought; returning False ends the study there, without the row that is being measured. coarser: nets of
    twice, four times, … the step that are studied as well, as many as the lattice has; 0 for none, when there
    is no net_error either.

    Raises InvalidInput for accuracies that cannot be meant, and where the scene has no equilibrium that is
    found: there is nothing to measure against then.
    """
    if isinstance(methods, str) or not hasattr(accuracies, "__iter__") or isinstance(accuracies, str):
        raise fn.InvalidInput(
            'accuracies and methods are lists: give [1e-3] and ["auto"], of one as of several'
        )
    wanted = sorted({_checked(accuracy) for accuracy in accuracies}, reverse=True)
    study = Study(np.empty((0, 3)))
    try:
        for row in _rows(scene, wanted, methods, max_seconds, on_report, coarser, study):
            study.rows.append(row)
            if on_progress is not None and on_progress(row) is False:
                raise Cancelled
    except Cancelled:
        study.cancelled = True
    return study


def _coarser_nets(scene, most):
    """CoarserNets, none where the net has none."""
    try:
        return nets_coarser_than(scene, most) if most else []
    except fn.InvalidInput:
        return []


def _checked(accuracy):
    if not (is_length(accuracy) and accuracy > 0.0):
        raise fn.InvalidInput(f"accuracies holds {accuracy!r}: give lengths in metres, such as 1e-3")
    return float(accuracy)


def _within(on_report, method, accuracy):
    """What fn.solve is to call while it measures this."""
    return None if on_report is None else lambda report: on_report(method, accuracy, report)


def _rows(scene, accuracies, methods, max_seconds, on_report, coarser, study):
    """Measures row by row; the study is given what the rows are measured against. May raise Cancelled."""
    nets = _coarser_nets(scene, coarser)
    scenes = [scene, *(net.scene for net in nets)]
    references = [solved_far(each, on_progress=_within(on_report, None, None)) for each in scenes]
    study.reference = references[0]
    study.of_net = from_shapes(references[:3], nets[:2]) if nets else None
    for level, (each, reference) in enumerate(zip(scenes, references)):
        step = float(np.mean(each.net.source_lengths))
        net_error = study.of_net.at(2.0**level) if study.of_net else None
        for method in methods:
            for accuracy in accuracies:
                watch = _within(on_report, method, accuracy)
                row = _measured(each, method, accuracy, reference, max_seconds, watch)
                row |= {"step": step, "net_error": net_error}
                yield {column: row[column] for column in COLUMNS}
                if row["status"] != "converged":
                    break


def _measured(scene, method, accuracy, reference, max_seconds, watch):
    result = fn.solve(
        scene,
        accuracy=accuracy,
        tolerance=TOLERANCE,
        method=method,
        max_seconds=max_seconds,
        on_progress=watch,
    )
    if result.status == "cancelled":
        raise Cancelled
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
