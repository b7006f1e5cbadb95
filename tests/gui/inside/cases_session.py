# SPDX-License-Identifier: LGPL-2.1-or-later
"""A long session of random actions: whatever a user does next, nothing breaks and nothing is left behind."""

import gc
import random
import sys
import threading

import FreeCAD as App
import FreeCADGui as Gui
import Part
import hand
from funicular.make import make_gridshell
from PySide import QtCore
from window import (
    QtWidgets,
    child,
    clear_report_view,
    close_panel,
    names,
    press,
    press_key,
    report_view,
    select_faces,
    settle,
    type_into,
    wait_until,
)

ACTIONS = 500
SEED = 20
# What a panel is made of, and what must be gone when it is.
OF_PANELS = ("GridshellPanel", "Session", "Pointer", "LiveSolve", "NetDrawing", "SupportsPart", "Keys")


def roof_in(document):
    box = document.addObject("Part::Feature", "Roof")
    points = [App.Vector(x, y, 0) for x, y in ((0, 0), (6000, 0), (6000, 4000), (0, 4000))]
    box.Shape = Part.Face(Part.makePolygon([*points, points[0]]))
    document.recompute()
    return box


class User:
    """Does one thing after another, as the dice say; what cannot be done just now is left."""

    def __init__(self, dice):
        self.dice = dice
        self.documents = []
        self.done = {}
        self.new_document()

    # What there is

    def document(self):
        active = App.ActiveDocument
        return active if active is not None and active.Name in self.documents else None

    def shells(self):
        document = self.document()
        objects = document.Objects if document else []
        return [obj for obj in objects if getattr(obj, "FunicularType", "") == "Gridshell"]

    def is_open(self):
        return bool(Gui.Control.activeDialog())

    def act(self):
        name = self.dice.choice(self.ACTIONS)
        print(name, flush=True)  # seen where FreeCAD itself ends
        getattr(self, name)()
        self.done[name] = self.done.get(name, 0) + 1
        settle(self.dice.choice((1, 1, 1, 3)))

    # Documents

    def new_document(self):
        if len(self.documents) >= 2:
            return
        document = App.newDocument("Session")
        document.UndoMode = 1
        Gui.ActiveDocument.ActiveView.setAnimationEnabled(False)
        self.documents.append(document.Name)
        roof_in(document)

    def switch_document(self):
        if self.documents:
            App.setActiveDocument(self.dice.choice(self.documents))
            Gui.ActiveDocument = Gui.getDocument(App.ActiveDocument.Name)

    def close_document(self):
        if self.documents and self.dice.random() < 0.3:
            name = self.dice.choice(self.documents)
            self.documents.remove(name)
            App.closeDocument(name)
            settle()
            if not self.documents:
                self.new_document()
            else:
                self.switch_document()

    def undo(self):
        Gui.runCommand("Std_Undo")

    def redo(self):
        Gui.runCommand("Std_Redo")

    def recompute(self):
        if self.document():
            self.document().recompute()

    def delete_something(self):
        document = self.document()
        if document and document.Objects and self.dice.random() < 0.4:
            obj = self.dice.choice(document.Objects)
            alone = self.dice.random() < 0.5
            # As FreeCAD's own command does it, which would ask about what depends on it.
            document.openTransaction("Delete")
            for each in [] if alone else obj.InListRecursive:
                document.removeObject(each.Name)
            document.removeObject(obj.Name)
            document.commitTransaction()

    def change_the_roof(self):
        document = self.document()
        roof = document.getObject("Roof") if document else None
        if roof is not None:
            roof.Placement.Base.z = self.dice.choice((0.0, 500.0, 1000.0))
        elif document and not self.is_open():
            document.openTransaction("Roof")
            roof_in(document)
            document.commitTransaction()

    # Panels

    def gridshell(self):
        document = self.document()
        roof = document.getObject("Roof") if document else None
        if roof is not None and not self.is_open() and len(self.shells()) < 3:
            select_faces(roof, "Face1")
            if Gui.isCommandActive("Funicular_Gridshell"):
                Gui.runCommand("Funicular_Gridshell")

    def edit(self):
        shells = self.shells()
        if shells:
            shell = self.dice.choice(shells)
            shell.ViewObject.Proxy.doubleClicked(shell.ViewObject)

    def ok(self):
        if self.is_open():
            press("Ok") if self.has_buttons("Ok") else close_panel()

    def cancel(self):
        if self.is_open():
            press("Cancel") if self.has_buttons("Cancel") else close_panel()

    def has_buttons(self, name):
        widgets = QtWidgets.QApplication.allWidgets()
        boxes = [box for box in widgets if isinstance(box, QtWidgets.QDialogButtonBox) and box.isVisible()]
        button = getattr(QtWidgets.QDialogButtonBox, name)
        return len(boxes) == 1 and boxes[0].button(button) is not None

    def escape(self):
        focus = QtWidgets.QApplication.focusWidget()
        if focus is not None and self.is_open():
            press_key(focus, QtCore.Qt.Key_Escape)

    def slide(self):
        name = self.dice.choice(("MemberWeight", "CoveringWeight", "Snow", "AxialStiffness", "Accuracy"))
        slider = child(QtWidgets.QSlider, f"{name}Slider")
        if slider is not None:
            # Not what would take minutes.
            low, high = (60, 180) if name == "AxialStiffness" else (0, 200)
            for _ in range(self.dice.choice((1, 5))):
                slider.setValue(self.dice.randint(low, high))
                settle(1)

    def type_something(self):
        name, texts = self.dice.choice(
            (
                ("StepU", ("400 mm", "0 mm", "wide", "700 mm")),
                ("StepV", ("500 mm", "300 mm")),
                ("CoveringWeight", ("20", "-5", "heavy", "45 kg/m²")),
                ("MemberWeight", ("0", "15", "12 kg/m")),
            )
        )
        box = child(QtWidgets.QWidget, name)
        if box is not None:
            type_into(box, self.dice.choice(texts))

    def choose(self):
        name, choices = self.dice.choice(
            (
                ("Pattern", ("Quad", "Triangle", "Diagrid", "Hexagon")),
                ("CoveringShare", ("Angle", "Equal")),
            )
        )
        box = child(QtWidgets.QComboBox, name)
        if box is not None:
            box.setCurrentIndex(max(0, box.findText(self.dice.choice(choices))))

    def press_a_button(self):
        names_of_buttons = (
            "Pause",
            "Step",
            "Restart",
            "RelaxSlowly",
            "KeepThis",
            "RestoreVariant",
            "DeleteVariant",
            "MatchLengths",
            "UndoMatching",
            "EffectCosts",
            "Warning0_show",
            "Warning0_leave_out",
            "CoveringWeightReset",
            "SectionNet",
            "SectionAlternatives",
            "RecipeBoundary",
            "RecipeCorners",
            "RecipeNone",
            "HoldFixed",
            "HoldUprightLine",
            "HoldUprightPlane",
            "HoldFree",
            "SupportLift",
            "SupportUndo",
            "SupportRedo",
        )
        button = child(QtWidgets.QAbstractButton, self.dice.choice(names_of_buttons))
        if button is not None and button.isEnabled():
            button.click()

    def use_the_mouse(self):
        tool = child(
            QtWidgets.QAbstractButton, "Tool" + self.dice.choice(("Off", "Nodes", "Lasso", "Edges", "Raise"))
        )
        if (
            tool is None
            or Gui.ActiveDocument is None
            or not hasattr(Gui.ActiveDocument.ActiveView, "getSize")
        ):
            return
        tool.click()
        width, height = Gui.ActiveDocument.ActiveView.getSize()
        way = [(self.dice.uniform(0, width), self.dice.uniform(0, height)) for _ in range(3)]
        hand.move(way[0])
        hand.drag(way) if self.dice.random() < 0.7 else hand.click(way[0])

    def choose_a_support(self):
        listed = child(QtWidgets.QTreeWidget, "SupportList")
        if listed is not None and listed.topLevelItemCount():
            listed.topLevelItem(self.dice.randrange(listed.topLevelItemCount())).setSelected(True)
            slider = child(QtWidgets.QSlider, "SupportStiffnessSlider")
            slider.setValue(self.dice.choice((0, 60, 150, 200)))

    def choose_variants(self):
        strip = child(QtWidgets.QListWidget, "Variants")
        if strip is not None and strip.count():
            strip.item(self.dice.randrange(strip.count())).setSelected(self.dice.random() < 0.7)

    def turn_the_view(self):
        active = Gui.ActiveDocument
        if active is not None and hasattr(active.ActiveView, "viewIsometric"):
            view = active.ActiveView
            self.dice.choice((view.viewTop, view.viewIsometric, view.viewFront, view.fitAll))()

    def wait(self):
        QtCore.QThread.msleep(self.dice.choice((10, 60, 200)))
        settle(3)

    ACTIONS = (
        *(
            "new_document",
            "switch_document",
            "close_document",
            "undo",
            "redo",
            "recompute",
            "delete_something",
        ),
        *("change_the_roof", "escape", "turn_the_view"),
        *("gridshell", "edit", "ok", "cancel") * 2,
        *("slide", "type_something", "choose", "press_a_button", "choose_variants", "wait") * 3,
        *("use_the_mouse", "choose_a_support") * 2,
    )


def panels_alive():
    """Of each object of the classes OF_PANELS its class."""
    gc.collect()
    ours = [type(obj) for obj in gc.get_objects() if type(obj).__module__.startswith("funicular")]
    return sorted(kind.__name__ for kind in ours if kind.__name__ in OF_PANELS)


def forget_the_last_error():
    """Python keeps the last error that it printed, FreeCAD the last that an object raised, and both with them
    whatever called: a panel whose Cancel recomputed an object that cannot be computed."""
    sys.last_type = sys.last_value = sys.last_traceback = None
    document = App.newDocument("Error")
    shell = make_gridshell(document, Width="1 m", Depth="1 m")
    shell.Net.Width = 0
    document.recompute()
    assert "Invalid" in shell.Net.State
    App.closeDocument(document.Name)
    settle()


def coin_nodes_of_ours(document):
    """Names of what of ours is in the scene graphs of a document, legends of gridshells not counted."""
    found = []
    for view in Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor"):
        stack = [view.getSceneGraph()]
        while stack:
            node = stack.pop()
            name = node.getName().getString()
            found += [name] if name.startswith("Funicular") and "legend" not in name else []
            children = node.getChildren()
            stack += [children[k] for k in range(children.getLength())] if children else []
    return found


def test_five_hundred_random_actions_leave_nothing_behind(workbench):
    # Cases that failed before it hold what they had.
    before, threads = panels_alive(), threading.active_count()
    clear_report_view()
    user = User(random.Random(SEED))
    for number in range(ACTIONS):
        user.act()
        # That an object cannot be computed FreeCAD tells with all that it knows; more is a fault of ours.
        wrong = [line for line in report_view().split("\n") if "Error" in line and "RuntimeError" not in line]
        assert not wrong, f"action {number} of {user.done}: {wrong}"
        clear_report_view()
    assert sum(user.done.values()) == ACTIONS and len(user.done) == len(set(User.ACTIONS))
    close_panel()
    settle()
    for name in user.documents:
        document = App.getDocument(name)
        assert document.HasPendingTransaction is False and names(document) is not None
        assert coin_nodes_of_ours(document) == [], "no panel is open"
        App.closeDocument(name)
    settle()
    wait_until(lambda: threading.active_count() <= threads, "the end of all threads")
    forget_the_last_error()
    wait_until(lambda: panels_alive() == before, f"the end of all panels: {panels_alive()}, before {before}")
