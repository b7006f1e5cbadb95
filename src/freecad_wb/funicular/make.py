# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripting API: functions that put Funicular's objects into a document.

Properties are given by name. A value is a text with its unit ("500 mm", "30 kg/m^2"), a FreeCAD quantity, or
a plain number (of Python or numpy), which means mm for lengths, kg/m for MemberWeight, kg/m² for
CoveringWeight, N/m² for Snow, N for AxialStiffness and N/mm² for CompressiveStrength and YoungsModulus.

    from funicular.make import make_gridshell

    shell = make_gridshell(doc, source=(dome, ["Face1"]), StepU="1 m", StepV="1 m", Snow="1 kPa")
    doc.recompute()
"""

from contextlib import contextmanager
from math import isfinite
from numbers import Integral, Real

import FreeCAD as App

from .features.covering import Covering
from .features.feature import MARKER, reason
from .features.gridshell import Gridshell
from .features.net import Net
from .features.support import WHERE_BY, Support

FEATURES = {feature.TYPE: feature for feature in (Net, Gridshell, Support, Covering)}


def make_net(doc, source=None, **properties):
    """Add a Net on one or more faces, a mesh or edges and return it; doc.recompute() then lays it there.

    source: (object, ["Face1"]), (object, "Face1"), (object, ["Face1", "Face2"]) of neighbours, or an object
    that has a single face or is a shell; a face may be named by its path from a container or a link,
    (part, "Box.Face6"). A mesh object becomes a net as it is, and so do a mesh file (File="roof.obj", without
    source) and edges: a sketch, a wire, (object, ["Edge1", "Edge4"]). Width and Depth without source make a
    flat sheet. properties: see Net.
    Raises ValueError for a source that does not say one object, a name that is no property of a Net, a value
    that the property does not take; then the document is as before.
    """
    with _one_undo_step(doc, "Make net"):
        return _make_net(doc, source, properties)


def make_gridshell(doc, source=None, net=None, **properties):
    """Add a Gridshell, and a Net for it unless one is given, and return it; doc.recompute() then relaxes it.

    Give source (as for make_net) or net, a Net that other gridshells may use as well. properties: those of
    the Gridshell, and of the new Net. Raises ValueError as make_net does; then the document is as before.
    """
    if source is not None and net is not None:
        raise ValueError("give either source, what to make a net on, or net, a Net that is there already")
    if source is None and net is None and not {"File", "Width", "Depth"} & set(properties):
        raise ValueError(
            "give source, what to make a net on, or net, a Net that is there already, or File, or Width and "
            "Depth"
        )
    if net is not None and getattr(net, MARKER, "") != Net.TYPE:
        raise ValueError(f"net is {getattr(net, 'Label', net)!r}, which is not a Net")
    if net is not None and net.Document != doc:
        raise ValueError(
            f"net {net.Label} is in the document {net.Document.Label}: "
            f"copy it into {doc.Label}, with its source"
        )
    names_of_net = {each.name for each in _settable(Net)}
    of_net = {name: value for name, value in properties.items() if name in names_of_net}
    if net is not None and of_net:
        raise ValueError(
            f"{', '.join(of_net)}: these are properties of the net {net.Label}, which is there already and "
            "may be shared; set them on it"
        )
    of_gridshell = {name: value for name, value in properties.items() if name not in of_net}
    _check_names(Gridshell, of_gridshell, also=names_of_net if net is None else ())
    with _one_undo_step(doc, "Make gridshell"):
        if net is None:
            net = _make_net(doc, source, of_net)
            # The gridshell stands where its net lies.
            net.Visibility = False
        obj = _add(doc, Gridshell)
        obj.Net = net
        _set(obj, Gridshell, of_gridshell)
        return obj


def make_support(doc, gridshell, **properties):
    """Add a Support to a Gridshell and return it; doc.recompute() then finds its nodes and relaxes again.

    properties: see Support, such as Elements=["Edge3"], Kind="On its vertical plane"; Where follows from
    Elements, Points or Nodes. The gridshell's SupportRecipe goes on to hold all other nodes; Kind="Free"
    leaves nodes to no support. Raises ValueError for what is no gridshell, a name that is no property of a
    Support, a value that it does not take; then the document is as before.
    """
    if getattr(gridshell, MARKER, "") != Gridshell.TYPE or gridshell.Document != doc:
        raise ValueError(
            f"gridshell is {getattr(gridshell, 'Label', gridshell)!r}, which is no Gridshell of {doc.Label}"
        )
    _check_names(Support, properties)
    given = [where for name, where in WHERE_BY.items() if name in properties]
    if given and "Where" not in properties:
        properties = {"Where": given[0], **properties}
    with _one_undo_step(doc, "Make support"):
        obj = _add(doc, Support)
        _put_beside(obj, gridshell)
        obj.Net = gridshell.Net
        _set(obj, Support, properties)
        gridshell.Supports = [*gridshell.Supports, obj]
        return obj


def make_covering(doc, gridshell, **properties):
    """Add a Covering of a Gridshell's panels and return it; doc.recompute() then makes its faces.

    It is put into the container (App::Part) of the gridshell, if that lies in one. properties: see Covering.
    Raises ValueError for what is no Gridshell of this document, a name that is no property of a Covering, a
    value that the property does not take; then the document is as before.
    """
    if getattr(gridshell, MARKER, "") != Gridshell.TYPE:
        shown = getattr(gridshell, "Label", gridshell)
        raise ValueError(f"gridshell is {shown!r}, which is not a Gridshell: give one, or make it first")
    if gridshell.Document != doc:
        raise ValueError(
            f"gridshell {gridshell.Label} is in the document {gridshell.Document.Label}: make its covering "
            "there"
        )
    _check_names(Covering, properties)
    with _one_undo_step(doc, "Make covering"):
        obj = _add(doc, Covering)
        _put_beside(obj, gridshell)
        obj.Gridshell = gridshell
        _set(obj, Covering, properties)
        return obj


def _put_beside(obj, gridshell):
    """Into the container of a gridshell, so that it is seen where that is."""
    container = gridshell.getParentGeoFeatureGroup()
    if container is not None:
        container.addObject(obj)


def attach(obj):
    """Give an object that has lost them its proxy and, where there is a window, its view provider.

    obj: a document object with the marker property. An object that has both is left alone.
    """
    feature = FEATURES[getattr(obj, MARKER)]
    if not isinstance(obj.Proxy, feature):
        obj.Proxy = feature.__new__(feature)
        obj.Proxy.onDocumentRestored(obj)
    attach_view_provider(obj)


def attach_view_provider(obj):
    """Give an object its view provider where there is a window and it has none."""
    if App.GuiUp:
        from .gui import view_providers

        # FreeCAD puts a number where a view provider's proxy is missing.
        saved_without_window = isinstance(obj.ViewObject.Proxy, (int, type(None)))
        view_providers.attach_view_provider(obj)
        if saved_without_window and any(getattr(user, MARKER, "") == Gridshell.TYPE for user in obj.InList):
            # Such a file says nothing of what is shown; the gridshell stands where its net lies.
            obj.Visibility = False


def _make_net(doc, source, properties):
    _check_names(Net, properties)
    also = [name for name in ("File", "Width", "Depth") if name in properties]
    if source is not None and also:
        raise ValueError(f"give either source, or {' and '.join(also)}: a net lies on one of them")
    if source is not None:
        source, subs = _one_source(source)
        if source.Document != doc:
            raise ValueError(
                f"source {source.Label} is in the document {source.Document.Label}: bring it into "
                f"{doc.Label}, for instance as a link"
            )
    obj = _add(doc, Net)
    if source is not None:
        obj.Source = _from_the_root(source, subs)
    _set(obj, Net, properties)
    return obj


def _add(doc, feature):
    obj = doc.addObject("Part::FeaturePython", feature.TYPE)
    feature(obj)
    attach_view_provider(obj)
    return obj


def _one_source(source):
    """(object, [sub-element names, "" for all of it]) of the ways in which a source may be given."""
    if isinstance(source, (tuple, list)):
        if len(source) != 2:
            raise ValueError(
                f'source has {len(source)} entries: give (object, ["Face1"]) or an object with one face'
            )
        obj, subs = source
        subs = [subs] if isinstance(subs, str) else list(subs) or [""]
    else:
        obj, subs = source, [""]
    if not hasattr(obj, "getSubObject"):
        raise ValueError(f"source {obj!r} is not a document object")
    return obj, subs


def _from_the_root(obj, subs):
    """The same faces, named from the outermost container (App::Part, Body) of the object.

    So they stand where they are seen, and moving a container moves the net.
    """
    while (container := obj.getParentGeoFeatureGroup()) is not None:
        obj, subs = container, [f"{obj.Name}.{sub}" for sub in subs]
    return obj, subs


def _settable(feature):
    links = ("Source", "Net", "Supports", "Gridshell")
    return [each for each in feature.PROPERTIES if not each.mode and each.name not in links]


def _check_names(feature, properties, also=()):
    valid = {each.name for each in _settable(feature)} | set(also)
    for name in properties:
        if name not in valid:
            raise ValueError(
                f"{name} is not a property of a {feature.TYPE}: there are {', '.join(sorted(valid))}"
            )


def _set(obj, feature, properties):
    known = {each.name: each for each in feature.PROPERTIES}
    for name, value in properties.items():
        each = known[name]
        try:
            setattr(obj, name, _taken(each, value))
        except (ArithmeticError, TypeError, ValueError) as error:
            choices = f"; there are {', '.join(each.choices)}" if each.choices else ""
            example = f", such as '{each.default}'" if isinstance(each.default, str) and not choices else ""
            shown = f"{value} {each.unit}" if each.unit and isinstance(value, Real) else repr(value)[:60]
            raise ValueError(f"{name} = {shown} does not do: {reason(error)}{choices}{example}") from None


def _quantity(value, unit):
    """The App.Units.Quantity of a text, quantity or plain number; raises ValueError if it is not in unit."""
    if isinstance(value, Real):
        quantity = App.Units.Quantity(f"{float(value)!r} {unit}") if isfinite(value) else None
    else:
        # FreeCAD reads kg/m^2 only, and people write what they are shown.
        text = value.replace("²", "^2") if isinstance(value, str) else value
        quantity = App.Units.Quantity(text)
        if quantity.Unit != App.Units.Unit(unit):
            raise ValueError(f"it is not in {unit}, give it with that unit")
    if quantity is None or not isfinite(quantity.Value) or quantity.Value < 0.0:
        raise ValueError("give zero or more")
    return quantity


def _plain(value):
    """A number of numpy as one of Python, which is all that FreeCAD takes."""
    if isinstance(value, Integral):
        return value if isinstance(value, bool) else int(value)
    if isinstance(value, Real):
        if not isfinite(value):
            raise ValueError("give a finite number")
        return float(value)
    return value


def _vector(value):
    """A place (u, v) as FreeCAD's vector (u, v, 0); what is none is left for FreeCAD to refuse."""
    if isinstance(value, (tuple, list)) and len(value) == 2 and all(isinstance(at, Real) for at in value):
        return App.Vector(float(value[0]), float(value[1]), 0.0)
    return value


def _taken(each, value):
    """A value as its Property takes it."""
    if each.unit:
        return _quantity(value, each.unit)
    if each.kind == "App::PropertyVector":
        return _vector(value)
    if each.kind == "App::PropertyVectorList" and isinstance(value, (tuple, list)):
        return [_vector(at) for at in value]
    return _plain(value)


@contextmanager
def _one_undo_step(doc, name):
    """Everything inside is one undo step; an exception takes all of it back."""
    before = {obj.Name for obj in doc.Objects}
    # Opening a transaction would close one that the caller has opened.
    own = doc.UndoMode and App.getActiveTransaction() is None
    if own:
        doc.openTransaction(name)
    try:
        yield
    except BaseException:
        for added in reversed([obj.Name for obj in doc.Objects if obj.Name not in before]):
            doc.removeObject(added)
        if own:
            App.closeActiveTransaction(True)
        raise
    if own:
        App.closeActiveTransaction()
