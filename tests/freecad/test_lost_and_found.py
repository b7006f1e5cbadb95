# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lost proxies, an addon without its native module, files of other versions, real freecadcmd."""

import os
import pathlib
import shutil
import subprocess
import sys

import FreeCAD as App
import pytest

from conftest import LIBRARIES
from documents import recompute, reopened
from funicular import make, observer
from funicular.features.net import Net
from funicular.make import make_gridshell

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "src" / "freecad_wb" / "funicular"


@pytest.fixture
def shell(doc, dome):
    made = make_gridshell(doc, source=dome, StepU="3 m", StepV="2 m")
    assert recompute(doc) == {}
    return made


def test_lost_proxies_are_found_again(doc, shell, tmp_path):
    """As after a save by a FreeCAD that lacked the addon."""
    App.removeDocumentObserver(observer._observer)
    try:
        shell.Proxy = shell.Net.Proxy = None
        again = reopened(doc, tmp_path / "lost.FCStd")
        assert again.Gridshell.Proxy is None and again.Net.Proxy is None
        again.saveAs(str(tmp_path / "lost.FCStd"))
        App.closeDocument(again.Name)
    finally:
        observer.start()
    found = App.openDocument(str(tmp_path / "lost.FCStd"))
    assert type(found.Gridshell.Proxy).__name__ == "Gridshell"
    assert type(found.Net.Proxy).__name__ == "Net"
    found.Net.StepV = "1 m"
    assert recompute(found) == {}
    assert len(found.Gridshell.NodePositions) == found.Net.NodeCount


def test_starting_the_observer_twice_is_starting_it_once(doc, shell, tmp_path, monkeypatch):
    seen = []
    monkeypatch.setattr(make, "attach", lambda obj: seen.append(obj.Name))
    observer.start()
    observer.start()
    reopened(doc, tmp_path / "twice.FCStd")
    assert sorted(seen) == ["Gridshell", "Net"]


def test_properties_that_an_older_version_lacked_are_added(doc, shell, tmp_path):
    shell.removeProperty("Snow")
    shell.removeProperty("MethodUsed")
    shell.SchemaVersion = 0
    again = reopened(doc, tmp_path / "older.FCStd")
    shell = again.Gridshell
    assert shell.Snow.Value == 0.0 and shell.SchemaVersion == 1
    assert shell.getEditorMode("MethodUsed") == ["ReadOnly"]
    shell.Snow = "1 kPa"
    assert recompute(again) == {}


def test_a_newer_version_is_left_as_it_is(doc, shell, tmp_path):
    shell.Net.removeProperty("PanelCount")
    shell.Net.SchemaVersion = Net.SCHEMA_VERSION + 1
    again = reopened(doc, tmp_path / "newer.FCStd")
    assert again.Net.SchemaVersion == Net.SCHEMA_VERSION + 1
    assert "PanelCount" not in again.Net.PropertiesList


START = """
import sys, runpy
sys.path += {libraries!r}
sys.path.insert(0, {root!r})
import FreeCAD as App
runpy.run_path({root!r} + "/Init.py")
App.newDocument("Empty").addObject("App::DocumentObjectGroup", "Group")
print("LOADED", [name for name in ("Part", "numpy", "funicular.features.net") if name in sys.modules])
"""


def test_the_start_of_freecad_waits_for_no_other_module():
    script = START.format(libraries=list(LIBRARIES), root=str(ROOT))
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
    assert "LOADED []" in run.stdout, run.stdout + run.stderr


SCRIPT = """
import sys
sys.path[:0] = [{package!r}]
import FreeCAD as App
from funicular import observer
observer.start()
doc = App.openDocument({document!r})
edges = len(doc.Gridshell.Shape.Edges)
doc.Net.StepU = "4 m"
doc.recompute()
print("NET", doc.Net.isValid(), doc.Net.getStatusString())
doc.Gridshell.touch()
doc.Net.purgeTouched()
doc.Gridshell.recompute()
print("SHELL", doc.Gridshell.isValid(), doc.Gridshell.getStatusString())
print("EDGES", edges == len(doc.Gridshell.Shape.Edges) > 0)
doc.save()
print("SAVED")
"""


def run_without_native_module(tmp_path, doc, doctor):
    """What a FreeCAD says that opens the document with a copy of the package, doctored."""
    package = tmp_path / "addon"
    shutil.copytree(PACKAGE, package / "funicular", ignore=shutil.ignore_patterns("__pycache__"))
    doctor(package / "funicular")
    document = tmp_path / "native.FCStd"
    doc.saveAs(str(document))
    script = tmp_path / "script.py"
    script.write_text(SCRIPT.format(package=str(package), document=str(document)))
    run = freecadcmd(script)
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout + run.stderr


def freecadcmd(*arguments):
    return subprocess.run(
        [sys.executable, str(ROOT / "tools" / "freecad_run.py"), *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )


def native_modules(package):
    modules = list(package.glob("_core.*.so"))
    assert modules
    return modules


def test_the_native_module_is_missing(doc, shell, tmp_path):
    def remove(package):
        for module in native_modules(package):
            module.unlink()

    said = run_without_native_module(tmp_path, doc, remove)
    sentence = "Funicular's native module is not built. Run 'make build'"
    assert f"NET False Net: {sentence}" in said
    assert f"SHELL False Gridshell: {sentence}" in said
    assert "EDGES True" in said and "SAVED" in said


def test_the_native_module_is_for_another_python(doc, shell, tmp_path):
    def rename(package):
        for module in native_modules(package):
            module.rename(package / "_core.cpython-399-x86_64-linux-gnu.so")

    said = run_without_native_module(tmp_path, doc, rename)
    assert "NET False Net: Funicular's native module was built for Python 3.99, but this is Python 3." in said
    assert "Run 'make build" in said
    assert "EDGES True" in said and "SAVED" in said


REAL_RUN = """
import os, sys
import FreeCAD as App, Part
import runpy
sys.path.insert(0, {root!r})
runpy.run_path({root!r} + "/Init.py")
from funicular.make import make_gridshell
doc = App.newDocument("Real")
cap = doc.addObject("Part::Feature", "Cap")
cap.Shape = Part.makeSphere(10000, App.Vector(), App.Vector(0, 0, 1), 40, 90, 360).Faces[0]
shell = make_gridshell(doc, source=cap, StepU="3 m", StepV="2 m")
doc.recompute()
print("RESULT", shell.Status, shell.CompressionOnly, len(shell.Shape.Edges), shell.Net.MemberCount)
doc.saveAs({document!r})
shell.Net.StepU = 0
doc.recompute()
print("STATUS", shell.Net.getStatusString())
"""


def test_real_freecadcmd(tmp_path):
    """Init.py, make, recompute and save in freecadcmd; the file opens here; a refusal is reported once."""
    script, document = tmp_path / "real.py", tmp_path / "real.FCStd"
    script.write_text(REAL_RUN.format(root=str(ROOT), document=str(document)))
    run = freecadcmd(script)
    assert run.returncode == 0, run.stderr
    members = App.openDocument(str(document)).Net.MemberCount
    assert f"RESULT converged True {members} {members}" in run.stdout
    sentence = "Net: StepU is 0 mm: give a length greater than zero"
    assert f"STATUS {sentence}" in run.stdout
    report = (run.stdout + run.stderr).replace(f"STATUS {sentence}", "")
    # FreeCAD itself repeats it from 1.0 on, in front of the object's name.
    assert report.count(sentence) == (1 if int(App.Version()[0]) < 1 else 2)


def test_the_launcher_passes_failures_on(tmp_path):
    script = tmp_path / "failing.py"
    script.write_text("print('once')\nraise ValueError('what went wrong')\n")
    run = freecadcmd(script)
    assert run.returncode == 1
    assert run.stdout.count("once") == 1 and "what went wrong" in run.stderr
