# SPDX-License-Identifier: LGPL-2.1-or-later
"""What several tests ask of a document or an object."""

import FreeCAD as App
import numpy as np


def array(vectors):
    """(n, 3) array of a list of vectors."""
    return np.array([tuple(vector) for vector in vectors])


def edge_ends(shape):
    """(m, 2, 3) end points of the edges of a shape, in their order."""
    return np.array([[tuple(vertex.Point) for vertex in edge.Vertexes] for edge in shape.Edges])


def recompute(doc):
    """Recompute; {name: status} of the objects that failed."""
    doc.recompute()
    return {obj.Name: obj.getStatusString() for obj in doc.Objects if "Invalid" in obj.State}


def assert_refused(obj, *sentences):
    """The object is Invalid and its status holds its label and every one of the sentences."""
    assert "Invalid" in obj.State and not obj.isValid()
    for sentence in (f"{obj.Label}: ", *sentences):
        assert sentence in obj.getStatusString(), obj.getStatusString()


def reopened(doc, path):
    """The document after it was saved, closed and opened again."""
    doc.saveAs(str(path))
    App.closeDocument(doc.Name)
    return App.openDocument(str(path))
