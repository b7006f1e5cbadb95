# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripts in the README do what it says, as they stand there."""

import contextlib
import io
import pathlib
import re

import FreeCAD as App
import pytest

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"
SCRIPTS = re.findall(r"```python\n(.*?)```", README.read_text("utf-8"), flags=re.DOTALL)


@pytest.mark.parametrize(
    "script, said", [(SCRIPTS[0], "converged"), (SCRIPTS[1], "Compression only")], ids=["freecad", "numeric"]
)
def test_script(script, said):
    before = set(App.listDocuments())
    printed = io.StringIO()
    try:
        with contextlib.redirect_stdout(printed):
            exec(compile(script, str(README), "exec"), {})
    finally:
        for name in set(App.listDocuments()) - before:
            App.closeDocument(name)
    assert said in printed.getvalue()
    assert len(script.strip().splitlines()) == 5
