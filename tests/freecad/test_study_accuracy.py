# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs a Gridshell: the files of it, its own accuracy among them, and what is refused."""

import csv
import itertools

import matplotlib.image
import numpy as np
import pytest

import funicular as fn
from documents import array, recompute
from funicular.accuracy import ACCURACIES, METHODS
from funicular.export import study_accuracy
from funicular.make import make_gridshell, make_support


@pytest.fixture
def shell(doc):
    made = make_gridshell(doc, Width="4 m", Depth="3 m", StepU="500 mm", StepV="500 mm", Accuracy="0.7 mm")
    assert recompute(doc) == {}
    return made


def test_files_hold_what_the_study_says(shell, tmp_path):
    study = study_accuracy(shell, tmp_path / "roof")
    with open(tmp_path / "roof.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    wanted = sorted((7e-4, *ACCURACIES), reverse=True)
    own = rows[: len(study.rows_of_own_step())]
    asked = [(row["method"], float(row["accuracy"])) for row in own]
    assert asked == list(itertools.product(METHODS, wanted))
    assert sorted({row["step"] for row in rows})[:2] == ["0.5", "1.0"]
    assert len(rows) == len(study.rows)
    for row, measured in zip(rows, study.rows):
        assert row == {name: str(value) for name, value in measured.items()}
        assert measured["status"] == "converged" and measured["true_error"] <= measured["accuracy"]
    picture = matplotlib.image.imread(tmp_path / "roof.png")
    ink = (np.abs(picture[..., :3] - picture[0, 0, :3]) > 0.3).any(axis=2)
    assert 0.01 < ink.mean() < 0.5, "something is drawn, and not everywhere"


def test_it_is_the_gridshell_that_is_measured(shell, tmp_path):
    study = study_accuracy(shell, tmp_path / "roof", accuracies=[1e-6], methods=["auto"], coarser=0)
    away = np.linalg.norm(array(shell.NodePositions) * 1e-3 - study.reference, axis=1).max()
    assert len(study.rows) == 1 and away <= 0.7e-3
    assert shell.Status == "converged" and "Touched" not in shell.State


def test_a_study_that_is_ended_writes_what_it_has(shell, tmp_path):
    study = study_accuracy(shell, tmp_path / "roof", on_progress=lambda row: row["method"] == "auto")
    assert study.cancelled and len(study.rows) == 7
    with open(tmp_path / "roof.csv", encoding="utf-8") as file:
        assert len(list(csv.DictReader(file))) == 7


def refused(shell, words, folder):
    with pytest.raises(fn.InvalidInput, match=words):
        study_accuracy(shell, folder / "roof")
    assert list(folder.iterdir()) == []


def test_what_cannot_be_measured_is_refused(shell, doc, tmp_path):
    refused(shell.Net, "Net is no Gridshell", tmp_path)
    refused(None, "None is no Gridshell", tmp_path)
    shell.Accuracy = 0
    refused(shell, "Accuracy is 0 mm", tmp_path)
    shell.Accuracy = 1
    support = make_support(doc, shell, Points=[(0.5, 0.5)])
    refused(shell, "Support has changed since it was computed: recompute it first", tmp_path)
    doc.removeObject(support.Name)
    doc.recompute()
    shell.Net.StepU = 0
    doc.recompute()
    refused(shell, "Net: StepU", tmp_path)


def test_without_equilibrium_there_is_nothing_to_measure_against(shell, tmp_path):
    shell.SupportRecipe, shell.AxialStiffness = "Boundary", "10 N"
    shell.Document.recompute()
    assert shell.Status == "no_equilibrium"
    refused(shell, "nothing to measure against", tmp_path)
