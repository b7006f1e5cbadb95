# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alternatives of a gridshell, kept under a name on the object itself: what went in, and what came of it.

    keep_variant(shell, "Low, on its corners")
    [variant.name for variant in variants_of(shell)]
    restore_variant(shell, "Low, on its corners"); doc.recompute()

A variant holds the inputs of the Gridshell, of its Net, its Supports and its PointLoads as plain values, the
numbers that variants are compared by, the form itself to be shown at once, and a picture if one was given.
"""

import base64
import json
import zlib
from dataclasses import dataclass, field

import FreeCAD as App
import numpy as np

import funicular as fn

from ..form import numbers_of
from .form_of import form_of
from .node_choice import is_used

SCHEMA_VERSION = 1

# Links are to objects, which a variant does not hold.
LINKS = ("App::PropertyLink", "App::PropertyLinkList", "App::PropertyLinkSub")
VECTORS = ("App::PropertyVector", "App::PropertyVectorList")


@dataclass(frozen=True)
class Variant:
    """A kept alternative.

    numbers: as funicular.form.numbers_of(), with compression_only. nodes: (n, 3) [m]. member_forces: (m,) and
    reactions: (n, 3) [N], both empty where they were not kept. thumbnail: a PNG picture, empty without one.
    inputs: {"Gridshell": {property: value}, "Net": …, "Supports": [{…}, …],
    "PointLoads": [{…}, …]}.
    source: [name, faces, name of the gridshell] of what its net lay on, empty without a source.
    """

    name: str
    numbers: dict
    nodes: np.ndarray
    member_forces: np.ndarray = field(default_factory=lambda: np.zeros(0))
    reactions: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    thumbnail: bytes = b""
    inputs: dict = field(default_factory=dict)
    source: tuple = ()

    def to_text(self):
        return json.dumps(
            {
                "schema": SCHEMA_VERSION,
                "name": self.name,
                "numbers": self.numbers,
                "nodes": _packed(self.nodes),
                "member_forces": _packed(self.member_forces),
                "reactions": _packed(self.reactions),
                "thumbnail": base64.b64encode(self.thumbnail).decode("ascii"),
                "inputs": self.inputs,
                "source": self.source,
            }
        )


def _packed(numbers):
    """An array as a text."""
    packed = zlib.compress(np.ascontiguousarray(numbers, dtype="<f4").tobytes(), 6)
    return base64.b64encode(packed).decode("ascii")


def _unpacked(text):
    """The numbers of _packed(), in a row."""
    packed = base64.b64decode(text)
    return np.frombuffer(zlib.decompress(packed) if packed else b"", dtype="<f4").astype(float)


def _from_text(text):
    """The Variant that a text holds; None for one of a later version, or that is damaged."""
    try:
        told = json.loads(text)
        if told["schema"] > SCHEMA_VERSION:
            return None
        return Variant(
            told["name"],
            told["numbers"],
            _unpacked(told["nodes"]).reshape(-1, 3),
            # Not kept at first.
            _unpacked(told.get("member_forces", "")),
            _unpacked(told.get("reactions", "")).reshape(-1, 3),
            base64.b64decode(told["thumbnail"]),
            told["inputs"],
            tuple(told["source"]),
        )
    except (ValueError, KeyError, TypeError, zlib.error):
        return None


def variants_of(shell):
    """The Variants of a Gridshell, in the order in which they were kept."""
    return [variant for variant in map(_from_text, shell.Variants) if variant is not None]


def keep_variant(shell, name, form=None, compression_only=None, thumbnail=b""):
    """Keep the present state of a Gridshell as a Variant, and return it; one of the same name is replaced.

    form, compression_only: what its inputs have come to, where that is not in the document yet. thumbnail: a
    PNG picture. Raises InvalidInput without a name, or before there is a result.
    """
    name = str(name).strip()
    if not name:
        raise fn.InvalidInput("name is empty: give the variant a name to find it by")
    if form is None:
        form, compression_only = form_of(shell), shell.CompressionOnly
        if shell.Status != "converged":
            form = None
    if form is None:
        raise fn.InvalidInput(f"{shell.Label} has no result to keep: recompute it first")
    numbers = {**numbers_of(form), "compression_only": bool(compression_only)}
    source = shell.Net.Source if shell.Net else None
    variant = Variant(
        name,
        numbers,
        form.nodes,
        form.member_forces,
        form.reactions,
        bytes(thumbnail),
        _inputs_of(shell),
        (source[0].Name, list(source[1]), shell.Name) if source else (),
    )
    _write(shell, [*(each for each in variants_of(shell) if each.name != name), variant])
    return variant


def rename_variant(shell, name, new_name):
    """Raises InvalidInput for a name that is empty or taken."""
    new_name = new_name.strip()
    names = [variant.name for variant in variants_of(shell)]
    if not new_name or (new_name in names and new_name != name):
        raise fn.InvalidInput(f"'{new_name}' is empty or taken: give the variant another name")
    _find(shell, name)
    _write(
        shell,
        [
            Variant(**{**vars(each), "name": new_name}) if each.name == name else each
            for each in variants_of(shell)
        ],
    )


def remove_variant(shell, name):
    """Raises InvalidInput for a name that there is not."""
    _find(shell, name)
    _write(shell, [each for each in variants_of(shell) if each.name != name])


def restore_variant(shell, name):
    """Give a Gridshell, its Net, Supports and PointLoads a Variant's inputs; doc.recompute() finds its form.

    Returns a list of sentences on what could not be restored. Raises InvalidInput for a name that there is
    not, before anything has changed.
    """
    from ..make import make_point_load, make_support

    variant = _find(shell, name)
    remarks = _set_inputs(shell, variant.inputs["Gridshell"])
    if shell.Net is not None:
        if variant.inputs["Net"]:
            remarks += _restore_source(shell, variant.source)
        remarks += _set_inputs(shell.Net, variant.inputs["Net"])
    for link, make in (("Supports", make_support), ("PointLoads", make_point_load)):
        # One that was kept before there were point loads has none.
        remarks += _restore_listed(shell, link, make, variant.inputs.get(link, []))
    return remarks


def _restore_listed(shell, link, make, wanted):
    """Make or remove objects of a list of a Gridshell until there are as many as wanted, and set those."""
    there = list(getattr(shell, link))
    there += [make(shell.Document, shell) for _ in wanted[len(there) :]]
    setattr(shell, link, there[: len(wanted)])
    for obj in there[len(wanted) :]:
        # Another gridshell may share it.
        if not is_used(obj):
            shell.Document.removeObject(obj.Name)
    return [remark for obj, inputs in zip(there, wanted) for remark in _set_inputs(obj, inputs)]


def _find(shell, name):
    variants = variants_of(shell)
    found = next((variant for variant in variants if variant.name == name), None)
    if found is None:
        there = ", ".join(f"'{variant.name}'" for variant in variants) or "none"
        raise fn.InvalidInput(f"{shell.Label} has no variant '{name}': there are {there}")
    return found


def _write(shell, variants):
    """What this version cannot read stays as it is."""
    unknown = [text for text in shell.Variants if _from_text(text) is None]
    shell.Variants = [variant.to_text() for variant in variants] + unknown


def _input_properties(obj):
    return [
        each
        for each in obj.Proxy.PROPERTIES
        if "ReadOnly" not in each.mode and each.is_input and each.kind not in LINKS
    ]


def _inputs_of(shell):
    return {
        "Gridshell": _values_of(shell),
        "Net": _values_of(shell.Net) if shell.Net else {},
        **{
            link: [{**_values_of(obj), "Label": obj.Label} for obj in getattr(shell, link)]
            for link in ("Supports", "PointLoads")
        },
    }


def _values_of(obj):
    return {each.name: _plain(getattr(obj, each.name)) for each in _input_properties(obj)}


def _plain(value):
    """As JSON has it; quantities in FreeCAD's own units."""
    if hasattr(value, "Unit"):
        return value.Value
    if isinstance(value, App.Vector):
        return list(value)
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    return value


def _set_inputs(obj, values):
    """Sets what differs; returns sentences on what did not go."""
    remarks, driven = [], {path.lstrip(".") for path, _ in obj.ExpressionEngine}
    kinds = {each.name: each.kind for each in _input_properties(obj)}
    for name, value in values.items():
        if name == "Label":
            obj.Label = value
        if name not in kinds or _plain(getattr(obj, name)) == value:
            continue
        if name in driven:
            remarks.append(f"{obj.Label}.{name} follows an expression and was left as it is")
            continue
        if kinds[name] in VECTORS:
            value = App.Vector(*value) if kinds[name] == VECTORS[0] else [App.Vector(*each) for each in value]
        elif hasattr(getattr(obj, name), "Unit"):
            value = App.Units.Quantity(value, getattr(obj, name).Unit)
        try:
            setattr(obj, name, value)
        except (TypeError, ValueError) as error:
            remarks.append(f"{obj.Label}.{name}: {error}")
    return remarks


def _restore_source(shell, source):
    net = shell.Net
    if not source:
        # It was a flat sheet, or a mesh file.
        if net.Source is not None:
            net.Source = None
        return []
    name, faces, *owner = source
    if owner and owner[0] != shell.Name:
        # What the original lies on is no business of a copy.
        return [f"{shell.Label} is a copy: its net stays on its own source"]
    obj = net.Document.getObject(name)
    if obj is None:
        return [f"{name}, which the net lay on, is gone: the net stays where it is"]
    if net.Source is None or (net.Source[0].Name, list(net.Source[1])) != (name, list(faces)):
        net.Source = (obj, list(faces))
    return []
