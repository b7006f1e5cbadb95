# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the Source of a Net says: faces of a body, a mesh, a mesh file, edges, or a flat sheet."""

from dataclasses import dataclass

import FreeCAD as App
import Part

import funicular as fn

from .feature import amount


@dataclass(frozen=True)
class Faces:
    """Faces of one body, placed as they stand in the document.

    faces: Part.Face each. names: how sentences call them. body: the Part.Shape that they belong to.
    described: what that body is, so that another one is noticed.
    """

    faces: tuple
    names: tuple
    body: object
    described: str


@dataclass(frozen=True)
class Mesh:
    """A Mesh::Feature, and how sentences call it."""

    obj: object
    name: str
    place: object  # App.Placement of where it is seen


@dataclass(frozen=True)
class File:
    """A mesh file."""

    path: str


@dataclass(frozen=True)
class Edges:
    """Part shapes of edges, placed as they stand, and how sentences call them.

    elements: the names of single edges of a body; empty where all of a shape is meant. body: the whole.
    """

    shapes: tuple
    name: str
    elements: tuple
    body: object


def read_source(obj):
    """The Faces, Mesh, File or Edges that a Net lies on; those of a flat sheet are Faces.

    Raises InvalidInput that says why there are none, and what to do.
    """
    if obj.Source is None:
        return _without_source(obj)
    source, subs = obj.Source
    if source in obj.InListRecursive:
        raise fn.InvalidInput(
            f"{obj.Label} lies inside {source.Label}, which holds its own face: move it out of {source.Label}"
        )
    path = subs[0] if subs else ""
    inner = (source.getSubObjectList(path) or [source])[-1].getLinkedObject(True)
    if inner.isDerivedFrom("Mesh::Feature"):
        # Along the path, through links and parts, as faces are read.
        return Mesh(inner, f"Source {inner.Label}", source.getSubObject(path, 3))
    paths, elements = zip(*(_split(sub) for sub in [sub for sub in subs if sub] or [""]))
    if len(set(paths)) > 1:
        raise fn.InvalidInput(
            f"Source names faces of {len(set(paths))} bodies ({', '.join(subs)}): a net lies on faces of "
            "one; fuse them first, or make a net on each"
        )
    path = paths[0]
    body = source.getSubObject(path)
    if body is None or not hasattr(body, "Faces") or body.isNull():
        raise fn.InvalidInput(
            f"Source {source.Label}{path and '.' + path[:-1]} has no shape: recompute or mend it, "
            "or pick another face"
        )
    count = len(body.Faces)
    if _are_edges(elements, body):
        shapes = [source.getSubObject(path + element) if element else body for element in elements]
        named = tuple(element for element in elements if element)
        return Edges(_edges(source, path, elements, shapes), f"Source {source.Label}", named, body)
    if not any(elements):
        if count != 1 and (count == 0 or body.Solids):
            raise fn.InvalidInput(f"Source {source.Label} has {count} faces: pick one of them")
        elements = [f"Face{number}" for number in range(1, count + 1)]
    names = tuple(f"Source {source.Label}.{path}{element}" for element in elements)
    faces = tuple(_face(source, body, element, name, count) for element, name in zip(elements, names))
    if len({element.lstrip("?") for element in elements}) < len(elements):
        raise fn.InvalidInput(f"Source names a face of {source.Label} twice ({', '.join(subs)})")
    described = "one face" if count == 1 else f"{count} faces"
    if count > 1:
        described += "".join(
            f", {element} a {type(face.Surface).__name__}" for element, face in zip(elements, faces)
        )
    if obj.SourceBody and obj.SourceBody != described and not _faces_keep_their_names():
        raise fn.InvalidInput(
            f"{names[0]} may be another face than the one that was picked, because {source.Label} has "
            f"changed (then: {obj.SourceBody}; now: {described}): pick the face again"
        )
    return Faces(faces, names, body, described)


def _without_source(obj):
    if obj.File:
        return File(obj.File)
    width, depth = amount(obj, "Width", "mm"), amount(obj, "Depth", "mm")
    if width and depth:
        sheet = Part.makePlane(width, depth)
        return Faces((sheet,), ("the sheet",), sheet, "one face")
    if width or depth:
        raise fn.InvalidInput(
            f"{'Depth' if width else 'Width'} is 0 mm: a flat sheet needs a Width and a Depth"
        )
    raise fn.InvalidInput(
        "Source is empty (nothing was picked, or its object was deleted): set it to one face, "
        'such as (object, ["Face1"]), to several, to a mesh or to edges; or give Width and Depth of a sheet'
    )


def _are_edges(elements, body):
    named = [element for element in elements if element]
    return all(element.startswith("Edge") for element in named) if named else not body.Faces and body.Edges


def _edges(source, path, elements, shapes):
    for element, shape in zip(elements, shapes):
        if shape is None or shape.isNull():
            raise fn.InvalidInput(
                f"Source {source.Label}.{path}{element} no longer exists: pick the edges again"
            )
    return tuple(shapes)


def _split(sub):
    path, _, element = sub.rpartition(".")
    return path and path + ".", element


def _face(source, body, element, name, count):
    if not element.lstrip("?").startswith("Face"):
        raise fn.InvalidInput(f"{name} is not a face: pick a face")
    # 1.0 and later write '?Face3' for a face that is gone.
    number = element[len("Face") :]
    # Taken from the body itself: asked for by name, its edges would not be the same as the body's.
    if not number.isdigit() or not 1 <= int(number) <= count:
        raise fn.InvalidInput(
            f"{name} no longer exists ({source.Label} has {count} face{'s' * (count != 1)} now): "
            "pick the face again"
        )
    return body.Faces[int(number) - 1]


def _faces_keep_their_names():
    """From 1.0 on FreeCAD follows a face through changes of its body; before, Face3 is just the third."""
    return int(App.Version()[0]) >= 1
