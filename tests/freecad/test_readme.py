# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripts in the README do what it says, run by the commands that it gives."""

import os
import pathlib
import re
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text("utf-8"), flags=re.DOTALL)
INSIDE_FREECAD = ["/usr/bin/python3", "tools/freecad_run.py"]


def test_scripts_are_short():
    assert len(SCRIPTS) == 3 and all(len(script.strip().splitlines()) <= 6 for script in SCRIPTS)


@pytest.mark.parametrize(
    "script, command, path, said",
    [
        (SCRIPTS[0], INSIDE_FREECAD, None, "converged"),
        (SCRIPTS[1], ["/usr/bin/python3"], "src/freecad_wb", "Compression only"),
        # The third goes on from the second.
        (
            SCRIPTS[1] + SCRIPTS[2] + "print(len(study.rows), 'rows')",
            ["/usr/bin/python3"],
            "src/freecad_wb",
            "18 rows",
        ),
    ],
    ids=["freecad", "numeric", "accuracy"],
)
def test_script(script, command, path, said, tmp_path):
    file = tmp_path / "script.py"
    file.write_text(script, "utf-8")
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    if path:
        environment["PYTHONPATH"] = str(ROOT / path)
    # What it writes is not to lie in the checkout.
    command = [*command[:1], *(str(ROOT / part) for part in command[1:])]
    run = subprocess.run(
        [*command, str(file)], cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120
    )
    assert run.returncode == 0, run.stderr
    assert said in run.stdout
