# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lays the net that the properties of a Net ask for on what its Source says."""

from dataclasses import replace

import Part
import numpy as np

import funicular as fn

from ..chebyshev import equal_length_net
from ..laying import Division, Laid, chart_within_outline, lay_on_chart, lay_on_face
from ..mesh_source import mesh_of, net_of_mesh, read_mesh_file
from ..panels import areas
from ..several_faces import lay_on_faces
from ..uv_mesh import chart_of_uv, read_uv_mesh_file
from ..wireframe import net_of_edges
from .elements import nodes_on_elements, nodes_on_wires
from .feature import amount
from .net_properties import EQUAL_LENGTHS, FILE_UNITS, SPACINGS, pattern_of
from .source import Edges, File, Mesh

# In mm: more than a kilometre is rather a wrong unit than a roof.
LARGEST_LIKELY = 1e6

# What a net of equal lengths has no use for, and the values at which nobody expects it.
USED_ALONG_ISOLINES = {
    "Pattern": "Quad",
    "CountU": 0,
    "CountV": 0,
    "SwapUV": False,
    "OffsetU": 0,
    "OffsetV": 0,
}

# Less of a face than this is not what a net of whole cells leaves out along borders.
MOST_OF_FACE = 0.85


def lay(obj, source):
    """(Laid, {element of the source: its nodes}) on what a Net lies on."""
    if isinstance(source, Mesh):
        if obj.Resampled:
            raise fn.InvalidInput(
                f"Resampled: {source.name} holds no UV coordinates, as FreeCAD's meshes never do: name the "
                ".obj file as File instead, or set Resampled to False"
            )
        return _of(net_of_mesh(*mesh_of(source.obj, source.name, source.place), source.name, _weld(obj))), {}
    if isinstance(source, File):
        try:
            laid = _of_file(obj, source.path)
        except OSError as error:
            raise fn.InvalidInput(
                f"File {source.path} cannot be read ({error.strerror}): choose another"
            ) from None
        return replace(laid, remarks=(*laid.remarks, *_remarks_on_size(laid.nodes, obj.FileUnit))), {}
    if isinstance(source, Edges):
        chord = amount(obj, "Chord", "mm") or None
        wires = net_of_edges(source.shapes, source.name, chord)
        laid = _of(wires)
        if chord is None and _has_curves(source.shapes):
            laid = replace(
                laid, remarks=(*laid.remarks, "curved edges are one straight member each: set Chord")
            )
        return laid, nodes_on_wires(source, wires)
    division = _division(obj)
    if len(source.faces) > 1 and (division.angle or any(division.offset)):
        raise fn.InvalidInput(
            "Angle, OffsetU and OffsetV turn and shift the pattern on one face; on several set them to 0"
        )
    if obj.Laying == EQUAL_LENGTHS:
        laid = _of_equal_lengths(obj, source, division.step_u)
    elif len(source.faces) == 1:
        laid = lay_on_face(source.faces[0], source.names[0], division)
    else:
        laid = lay_on_faces(source, division)
    return laid, nodes_on_elements(source.body, source.faces, laid.nodes)


def _of_file(obj, path):
    name, to_mm = f"File {path}", FILE_UNITS[obj.FileUnit] / FILE_UNITS["m"]
    if not obj.Resampled:
        points, facets, lines = read_mesh_file(path)
        return _of(net_of_mesh(points * to_mm, facets, name, _weld(obj), lines))
    points, facets, uvs, corners = read_uv_mesh_file(path)
    chart, area = chart_of_uv(points * to_mm, facets, uvs, corners, name)
    division = _division(obj)
    if division.angle or any(division.offset):
        raise fn.InvalidInput(
            "Angle, OffsetU and OffsetV turn and shift the pattern on a face; on a mesh set them to 0"
        )
    if obj.Laying == EQUAL_LENGTHS:
        return _with_equal_lengths(obj, chart, None, division.step_u, area)
    return lay_on_chart(chart, name, division)


def _of_equal_lengths(obj, source, step):
    if len(source.faces) > 1:
        raise fn.InvalidInput(
            "Laying: a net of equal lengths lies on one face; pick a single one, or lay along isolines"
        )
    chart, inside = chart_within_outline(source.faces[0], source.names[0], step)
    return _with_equal_lengths(obj, chart, inside, step, source.faces[0].Area)


def _with_equal_lengths(obj, chart, inside, step, area):
    made = equal_length_net(
        chart,
        step,
        (obj.Start.x, obj.Start.y),
        obj.Angle.Value,
        obj.Crossing.Value,
        obj.MostShear.Value,
        inside,
    )
    panels = tuple(tuple(panel) for panel in made.panels.tolist())
    closed = chart.closed_u, chart.closed_v
    remarks = [remark.rstrip(".") for remark in made.remarks]
    ignored = [name for name, plain in USED_ALONG_ISOLINES.items() if getattr(obj, name) != plain]
    if ignored:
        remarks.append(f"Equal lengths takes StepU alone: {', '.join(ignored)} is not used")
    covered = float(areas(made.nodes, panels).sum()) / area
    if covered < MOST_OF_FACE:
        remarks.append(f"the net covers {100 * covered:.0f} % of the face")
    return Laid(made.nodes, made.members, panels, closed=closed, remarks=tuple(remarks), uv=made.uv)


def _remarks_on_size(nodes, unit):
    size = float(np.linalg.norm(np.ptp(nodes, axis=0)))
    if size > LARGEST_LIKELY:
        yield f"the file measures {size / 1e6:.3g} km in {unit}: if it is in another unit, set FileUnit"


def _has_curves(shapes):
    return any(
        not isinstance(edge.Curve, (Part.Line, Part.LineSegment)) for each in shapes for edge in each.Edges
    )


def _weld(obj):
    return amount(obj, "Weld", "mm") or None


def _of(made):
    """The Laid net of a MeshNet or a WireNet."""
    return Laid(
        made.nodes,
        made.members,
        made.panels,
        remarks=tuple(remark.rstrip(".") for remark in made.remarks),
    )


def _division(obj):
    for name in ("CountU", "CountV"):
        if getattr(obj, name) < 0:
            raise fn.InvalidInput(f"{name} is {getattr(obj, name)} cells: give 0 (none) or more")
    return Division(
        amount(obj, "StepU", "mm"),
        amount(obj, "StepV", "mm"),
        pattern_of(obj.Pattern),
        obj.CountU,
        obj.CountV,
        obj.SwapUV,
        obj.Spacing == SPACINGS[1],
        obj.Angle.Value,
        (obj.OffsetU, obj.OffsetV),
    )
