# SPDX-License-Identifier: LGPL-2.1-or-later
"""What effects cost, and what they do: a scene solved with all of them, and without each.

So that a user can decide which effects a scene calls for: none is ever left out by itself. Lengths are
metres.
"""

from dataclasses import dataclass, field

import numpy as np

import funicular as fn

from .accuracy import write_rows
from .discretisation import Cancelled
from .wording import length_text

# Columns of a row, in the order of the file.
COLUMNS = (
    "effect",
    "seconds",
    "share",
    "evaluations",
    "bytes",
    "seconds_without",
    "saved",
    "moved",
    "dispensable",
    "sentence",
)

# In words, as they stand in sentences.
NAMES = {
    "axial": "the members' stiffness",
    "member_weight": "the members' weight",
    "covering_weight": "the covering",
    "snow": "snow",
    "point_load": "point loads",
}

_NAME_OF = {
    "AxialStiffness": "axial",
    "MemberWeight": "member_weight",
    "CoveringWeight": "covering_weight",
    "Snow": "snow",
    "PointLoad": "point_load",
}

# A solve this short [s] is measured several times, of which the shortest counts.
SHORT, REPEATS = 0.5, 3


@dataclass
class EffectStudy:
    """What was measured so far.

    rows: list of dicts with the keys of COLUMNS, one for each effect of the scene: its seconds and share of
    the solve's, evaluations and bytes; seconds_without, of the solve without it; saved, the part of the whole
    that is; moved, how far at most a node then is from where it is with it [m]; dispensable: whether that is
    less than the accuracy. seconds_without, saved and moved are None for the members' stiffness, and where
    nothing stands without the effect. seconds: of the solve with all effects. accuracy: [m]. cancelled:
    whether some rows are missing.
    """

    accuracy: float
    seconds: float = 0.0
    rows: list = field(default_factory=list)
    cancelled: bool = False

    def write(self, path):
        """The rows as a CSV file; lengths in metres, times in seconds."""
        write_rows(path, COLUMNS, self.rows)

    def suggestions(self):
        """Sentences on the effects that may be left out, and on whether all of them may be."""
        sentences = [row["sentence"] for row in self.rows if row["dispensable"]]
        if self.too_far_together is not None:
            sentences.append(
                f"together these may move it by {length_text(self.too_far_together)}: leave out one, then "
                "measure again"
            )
        return sentences

    @property
    def too_far_together(self):
        """How far the shape may move [m] without all dispensable effects; None if within the accuracy."""
        moved = [row["moved"] for row in self.rows if row["dispensable"]]
        return sum(moved) if len(moved) > 1 and sum(moved) > self.accuracy else None

    def __str__(self):
        lines = [f"{'effect':16} {'time':>9} {'share':>6} {'calls':>6} {'memory':>9}"]
        for row in self.rows:
            lines.append(
                f"{row['effect']:16} {1e3 * row['seconds']:6.1f} ms {100 * row['share']:4.0f} % "
                f"{row['evaluations']:6} {row['bytes'] / 1e3:6.1f} kB   {row['sentence']}".rstrip()
            )
        return "\n".join(lines)


def effect_study(scene, accuracy=1e-3, on_progress=None, max_seconds=60.0, on_report=None):
    """The EffectStudy of a scene: what each effect costs, and how far the shape moves without it.

    scene: a Scene. accuracy: [m], also of the solves. on_progress(row) is called with each row as it is
    measured; returning False ends the study there. max_seconds: for each solve. on_report(report) is called
    within each solve as fn.solve calls its on_progress; returning False ends the study there.

    Raises InvalidInput where the scene has no equilibrium that is found.
    """
    options = {"accuracy": accuracy, "max_seconds": max_seconds, "on_progress": on_report}
    study = EffectStudy(accuracy)
    try:
        for row in _rows(scene, options, study):
            study.rows.append(row)
            if on_progress is not None and on_progress(row) is False:
                raise Cancelled
    except Cancelled:
        study.cancelled = True
    return study


def _rows(scene, options, study):
    """Measures row by row; the study is given the seconds of the whole. May raise Cancelled."""
    whole = _solved(scene, options)
    if whole.status != "converged":
        raise fn.InvalidInput(f"the scene has no shape to measure against: {whole.message}")
    study.seconds = whole.seconds
    memory = scene.effect_memory()
    for name, (evaluations, seconds) in whole.costs.items():
        row = dict.fromkeys(COLUMNS)
        row |= {
            "effect": name,
            "seconds": seconds,
            "share": seconds / max(whole.seconds, seconds, 1e-9),
            "evaluations": evaluations,
            "bytes": memory[name],
            "dispensable": False,
        }
        yield row | _without(scene, name, whole, options)


def _without(scene, name, whole, options):
    """What a row says of the scene without the effects of that name."""
    if name == "axial":
        return {"sentence": ""}
    kept = [effect for effect in scene.effects if _NAME_OF[type(effect).__name__] != name]
    if all(isinstance(effect, fn.AxialStiffness) for effect in kept):
        return {"sentence": f"{NAMES[name]}: all the load there is"}
    bare = fn.Scene(scene.net, scene.supports, kept, scene.rest_lengths)
    result, accuracy = _solved(bare, options), options["accuracy"]
    if result.status != "converged":
        return {"sentence": f"without {NAMES[name]}: {result.message}"}
    saved = 1.0 - result.seconds / whole.seconds
    moved = float(np.linalg.norm(result.nodes - whole.nodes, axis=1).max())
    dispensable = moved < accuracy
    sentence = f"without {NAMES[name]}: {_faster(saved)}, {length_text(moved)}"
    if dispensable:
        sentence += f", less than the accuracy of {length_text(accuracy)}: it may be left out"
    return {
        "seconds_without": result.seconds,
        "saved": saved,
        "moved": moved,
        "dispensable": dispensable,
        "sentence": sentence,
    }


def _faster(saved):
    percent = round(100 * saved)
    if percent == 0:
        return "as fast"
    return f"{percent} % faster" if percent > 0 else f"{-percent} % slower"


def _solved(scene, options):
    """The Result of the shortest of some solves. May raise Cancelled."""
    best = None
    for _ in range(REPEATS):
        result = fn.solve(scene, **options)
        if result.status == "cancelled":
            raise Cancelled
        best = result if best is None or result.seconds < best.seconds else best
        if best.seconds >= SHORT or best.status != "converged":
            break
    return best
