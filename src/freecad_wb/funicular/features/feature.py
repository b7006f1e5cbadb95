# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every document object of Funicular has in common: properties, a version, how it reports an error."""

from dataclasses import dataclass

import FreeCAD as App


@dataclass(frozen=True)
class Property:
    """One property of a document object: what it is, not its value.

    default: the value of a new object, as FreeCAD takes it ("500 mm"). choices: of an enumeration.
    unit: of an App::PropertyQuantity. mode: "ReadOnly", "Hidden" or both.
    """

    kind: str
    name: str
    group: str
    tooltip: str
    default: object = None
    choices: tuple = ()
    unit: str = None
    mode: tuple = ()

    def ensure(self, obj):
        """Give the object this property if it lacks it, and what FreeCAD does not save of it."""
        new = self.name not in obj.PropertiesList
        if new:
            obj.addProperty(self.kind, self.name, self.group, self.tooltip)
            obj.setEditorMode(self.name, list(self.mode))
        if self.choices and obj.getEnumerationsOfProperty(self.name) != list(self.choices):
            value = getattr(obj, self.name) if not new else None
            setattr(obj, self.name, list(self.choices))
            if value in self.choices:
                setattr(obj, self.name, value)
        if self.unit and getattr(obj, self.name).Unit != App.Units.Unit(self.unit):
            # A PropertyQuantity saves its number only.
            setattr(obj, self.name, App.Units.Unit(self.unit))
        if new and self.default is not None:
            setattr(obj, self.name, self.default)


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

    def execute(self, obj):
        try:
            self.compute(obj)
        except (ValueError, ImportError) as error:
            # FreeCAD would skip what depends on this object and call it up to date.
            for dependent in obj.InList:
                dependent.touch()
            # FreeCAD marks the object Invalid, keeps the sentence as its status and shows it in the report
            # view, where the chain behind it would only bury it.
            raise RuntimeError(f"{obj.Label}: {error}") from None

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
