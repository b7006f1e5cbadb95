# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every document object of Funicular has in common: properties, a version, how it reports an error."""

import math
from dataclasses import dataclass

import FreeCAD as App

import funicular as fn


NOT_TO_COMPUTE = 8  # FreeCAD's Prop_Output: it does not even mark the object as touched


@dataclass(frozen=True)
class Property:
    """One property of a document object: what it is, not its value.

    default: the value of a new object, as FreeCAD takes it ("500 mm"). choices: of an enumeration.
    unit: of a quantity; a plain number means it. mode: "ReadOnly", "Hidden" or both. is_input: whether the
    object is to be computed again when it changes.
    """

    kind: str
    name: str
    group: str
    tooltip: str
    default: object = None
    choices: tuple = ()
    unit: str = None
    mode: tuple = ()
    is_input: bool = True

    def ensure(self, obj):
        """Give the object this property if it lacks it, and what FreeCAD does not save of it."""
        new = self.name not in obj.PropertiesList
        if new:
            self._add(obj)
        if self.choices and obj.getEnumerationsOfProperty(self.name) != list(self.choices):
            value = getattr(obj, self.name) if not new else None
            setattr(obj, self.name, list(self.choices))
            if value in self.choices:
                setattr(obj, self.name, value)
        if self.kind == "App::PropertyQuantity" and not self.has_unit(obj):
            setattr(obj, self.name, App.Units.Unit(self.unit))
        if new and self.default is not None:
            setattr(obj, self.name, self.default)

    def has_unit(self, obj):
        """Whether the value is in the property's unit: FreeCAD lets an expression give it any other."""
        return getattr(obj, self.name).Unit == App.Units.Unit(self.unit)

    def restore_unit(self, obj):
        """Let the property take values of its own unit again; a value of another unit is lost (nan)."""
        # A PropertyQuantity that comes from a file or a copy has a number and no unit yet.
        of_another = getattr(obj, self.name).Unit != App.Units.Unit()
        if self.kind == "App::PropertyLength":
            # Unlike other quantities a length cannot be given a unit.
            obj.removeProperty(self.name)
            self._add(obj)
        else:
            setattr(obj, self.name, App.Units.Unit(self.unit))
        if of_another:
            setattr(obj, self.name, math.nan)

    def _add(self, obj):
        obj.addProperty(
            self.kind, self.name, self.group, self.tooltip, 0 if self.is_input else NOT_TO_COMPUTE
        )
        obj.setEditorMode(self.name, list(self.mode))


MARKER = "FunicularType"
"""The property that says what an object is, when the addon was absent and its proxy is lost."""

COMMON = (
    Property(
        "App::PropertyString", MARKER, "Base", "What this object is to Funicular", mode=("ReadOnly", "Hidden")
    ),
    Property(
        "App::PropertyInteger",
        "SchemaVersion",
        "Base",
        "Version of the set of properties of this object",
        mode=("ReadOnly", "Hidden"),
    ),
)


EXPECTED = (ValueError, ImportError, App.Base.FreeCADError)
"""What bad input, a missing native module and a shape that OCC refuses raise."""


class Feature:
    """Proxy of a Part::FeaturePython. All data are in the object's properties; the proxy holds none.

    A subclass gives TYPE (the value of the marker), SCHEMA_VERSION, PROPERTIES, and `compute(obj)`, which
    either sets results and shape or raises and leaves both as they are.
    """

    TYPE = None
    SCHEMA_VERSION = 1
    PROPERTIES = ()

    def __init__(self, obj):
        self._ensure_properties(obj)
        obj.FunicularType = self.TYPE
        obj.SchemaVersion = self.SCHEMA_VERSION
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        if obj.SchemaVersion > self.SCHEMA_VERSION:
            App.Console.PrintWarning(
                f"{obj.Label} was saved by a newer Funicular (version {obj.SchemaVersion} of its properties, "
                f"this one knows {self.SCHEMA_VERSION}): update the addon before changing it\n"
            )
            return
        self._ensure_properties(obj)
        self.migrate(obj, obj.SchemaVersion)
        obj.SchemaVersion = self.SCHEMA_VERSION

    def migrate(self, obj, version):
        """Bring the values of an object saved with an older version of its properties up to this one."""

    def onChanged(self, obj, name):
        if name == "ExpressionEngine" and "Restore" not in obj.State:
            self._restore_units(obj)

    def execute(self, obj):
        try:
            self.compute(obj)
        except BaseException as error:
            sentence = f"{obj.Label}: {reason(error)}"
            self.failed(obj, error)
            # FreeCAD would skip what depends on this object and call it up to date.
            for dependent in obj.InListRecursive:
                if isinstance(getattr(dependent, "Proxy", None), Feature):
                    dependent.Proxy.failed(dependent, ValueError(sentence))
                dependent.touch()
            self._restore_units(obj)
            if not isinstance(error, EXPECTED):
                raise
            # FreeCAD marks the object Invalid, keeps the sentence as its status and shows it in the report
            # view, where the chain behind it would only bury it.
            raise RuntimeError(sentence) from None

    def failed(self, obj, error):
        """Let nobody take the object's last results for those of its present input."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    # FreeCAD before 1.0 calls these.
    __getstate__ = dumps
    __setstate__ = loads

    def _ensure_properties(self, obj):
        for each in (*COMMON, *self.PROPERTIES):
            each.ensure(obj)

    def _restore_units(self, obj):
        driven = {path.lstrip(".") for path, _ in obj.ExpressionEngine}
        for each in self.PROPERTIES:
            # While an object is being made, it does not have all of them.
            if each.unit and each.name not in driven and each.name in obj.PropertiesList:
                if not each.has_unit(obj):
                    each.restore_unit(obj)


def amount(obj, name, unit):
    """The number of a quantity property in a unit. Raises InvalidInput unless it is of that unit, finite and
    not negative."""
    quantity = getattr(obj, name)
    expression = dict(obj.ExpressionEngine).get(name)
    # An expression without a unit would be in FreeCAD's internal one: 1 would mean 1 kg/mm². Only millimetres
    # are what people mean by a plain number.
    given = quantity if expression is None or unit == "mm" else obj.evalExpression(expression)
    by = "" if expression is None else f" by the expression '{expression}'"
    if getattr(given, "Unit", None) != App.Units.Unit(unit) or quantity.Unit != App.Units.Unit(unit):
        raise fn.InvalidInput(f"{name} is {_text(given)}{by}, which is not in {unit}: give it with that unit")
    return checked(name, quantity.getValueAs(unit).Value, unit)


def checked(name, number, unit):
    """The number itself. Raises InvalidInput unless it is finite and not negative."""
    if not math.isfinite(number) or number < 0.0:
        raise fn.InvalidInput(f"{name} is {number:g} {unit.replace('^2', '²')}: give zero or more")
    return number


def _text(value):
    """A quantity or number in full: FreeCAD's UserString would round a small one to zero."""
    if not hasattr(value, "Unit"):
        return str(value)
    return f"{value.Value:g} {str(value).partition(' ')[2]}".strip()


def reason(error):
    """What an exception says; FreeCAD's own ones carry a dictionary."""
    details = error.args[0] if error.args else error
    return details.get("sErrMsg", details) if isinstance(details, dict) else error
