# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD inside pytest: the system's python3 imports it, with the addon on the path."""

import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# FreeCAD itself, then the modules that it would put on the path (PartDesign).
LIBRARIES = ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/Mod")

sys.path[:0] = [str(ROOT), str(ROOT / "src" / "freecad_wb"), str(ROOT / "examples")]
sys.path += LIBRARIES

import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
import dome as dome_example  # noqa: E402
import roof as roof_example  # noqa: E402

from documents import recompute  # noqa: E402
from funicular import observer  # noqa: E402

observer.start()

EXAMPLES = {"dome": dome_example, "roof": roof_example}


@pytest.fixture
def doc():
    """An empty document; every document is closed afterwards."""
    yield App.newDocument("Test")
    for name in App.listDocuments():
        App.closeDocument(name)


@pytest.fixture
def dome(doc):
    """A spherical cap of 10 m radius above 40 degrees of latitude: closed along u, a pole at v_max."""
    cap = doc.addObject("Part::Feature", "Dome")
    cap.Shape = Part.makeSphere(10000, App.Vector(), App.Vector(0, 0, 1), 40, 90, 360).Faces[0]
    return cap


@pytest.fixture
def box(doc):
    """A box 8 m x 6 m x 3 m; Face6 is its top."""
    made = doc.addObject("Part::Box", "Box")
    made.Length, made.Width, made.Height = 8000, 6000, 3000
    doc.recompute()
    return made


@pytest.fixture(params=EXAMPLES)
def example(request, doc):
    """The gridshell of each shipped example."""
    shell = EXAMPLES[request.param].build(doc)
    assert recompute(doc) == {}
    return shell
