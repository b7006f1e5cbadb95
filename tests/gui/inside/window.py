# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's window as a user meets it: keys, clicks, panels, pictures."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    from PySide import QtGui as QtWidgets

GRIDSHELL = "Funicular_Gridshell"
COVERING = "Funicular_Covering"


def settle(rounds=5):
    """Let the window handle what is waiting, deferred deletions too."""
    for _ in range(rounds):
        Gui.updateGui()
        QtWidgets.QApplication.sendPostedEvents(None, QtCore.QEvent.DeferredDelete)


def wait_until(condition, what):
    """Run the event loop until `condition()`; FreeCAD's own clocks decide when that is."""
    loop = QtCore.QEventLoop()
    poll, limit = QtCore.QTimer(), QtCore.QTimer()
    poll.timeout.connect(lambda: condition() and loop.quit())
    limit.setSingleShot(True)
    limit.timeout.connect(loop.quit)
    poll.start(20)
    # A safety net for a window that hangs; nothing passes or fails by being slow.
    limit.start(30_000)
    (getattr(loop, "exec", None) or loop.exec_)()
    poll.stop()
    assert condition(), f"never came: {what}; the line says {result_line()!r}, the report {report_view()!r}"


def report_view():
    view = Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view")
    settle()
    return view.toPlainText()


def clear_report_view():
    settle()
    Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view").clear()


def child(kind, name):
    """The one visible widget of this name, or None.

    Not by findChildren of the window: PySide would then keep what it found for as long as the window lives,
    and take the dead wrapper for the next widget at the same address.
    """
    widgets = QtWidgets.QApplication.allWidgets()
    found = [widget for widget in widgets if isinstance(widget, kind) and widget.objectName() == name]
    found = [widget for widget in found if widget.isVisible()]
    assert len(found) <= 1, f"{len(found)} widgets are called {name}"
    return found[0] if found else None


def panel_box(name):
    box = child(QtWidgets.QWidget, name)
    assert box is not None, f"the panel has no input {name}"
    return box


def result_line():
    line = child(QtWidgets.QLabel, "ResultLine")
    return line.text() if line else ""


def wait_for_result(previous=""):
    """The result line, once it says something else than `previous` and is no longer solving."""
    wait_until(
        lambda: result_line() not in ("", previous) and not result_line().startswith("…"), "a result line"
    )
    return result_line()


def session_of(shell):
    """The live session of the panel of a gridshell."""
    return shell.ViewObject.Proxy._panel.session


def wait_for_rest(shell):
    """The form that is shown once it moves no more."""
    wait_until(lambda: session_of(shell).is_settled, "a form at rest")
    return session_of(shell).form


def press(button):
    """Press OK, Cancel or Close of the open panel."""
    widgets = QtWidgets.QApplication.allWidgets()
    boxes = [box for box in widgets if isinstance(box, QtWidgets.QDialogButtonBox) and box.isVisible()]
    assert len(boxes) == 1, f"{len(boxes)} rows of buttons are visible"
    boxes[0].button(getattr(QtWidgets.QDialogButtonBox, button)).click()
    settle()


def close_panel():
    if Gui.Control.activeDialog():
        Gui.Control.closeDialog()
    settle()


def select_faces(obj, *names):
    Gui.Selection.clearSelection()
    for name in names:
        Gui.Selection.addSelection(obj, name)
    settle()


def run_command(name=GRIDSHELL):
    Gui.runCommand(name)
    settle()


def command_action(name="Gridshell"):
    """The action of the command of this name as the toolbar shows it, brought up to date."""
    settle()
    toolbar = Gui.getMainWindow().findChild(QtWidgets.QToolBar, "Funicular")
    (action,) = [action for action in toolbar.actions() if action.text().replace("&", "") == name]
    return action


def press_key(widget, key, text=""):
    """Press a key, which may be the last that `widget` sees."""
    event = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, key, QtCore.Qt.NoModifier, text)
    QtWidgets.QApplication.sendEvent(widget, event)


def send_key(widget, key, text=""):
    """Press a key and let it go."""
    press_key(widget, key, text)
    event = QtGui.QKeyEvent(QtCore.QEvent.KeyRelease, key, QtCore.Qt.NoModifier, text)
    QtWidgets.QApplication.sendEvent(widget, event)


def type_into(widget, text):
    """Replace what stands in a line edit or a spin box, key by key."""
    line = widget if isinstance(widget, QtWidgets.QLineEdit) else widget.findChild(QtWidgets.QLineEdit)
    line.setFocus()
    line.selectAll()
    for character in text:
        send_key(line, 0, character)
    settle()


def double_click_in_tree(label):
    """Double-click an object where the model tree shows it."""
    found = [
        (tree, item)
        for tree in Gui.getMainWindow().findChildren(QtWidgets.QTreeWidget)
        for item in tree.findItems(label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, 0)
    ]
    assert len(found) == 1, f"{len(found)} items are called {label}"
    tree, item = found[0]
    tree.scrollToItem(item)
    settle()
    place = QtCore.QPointF(tree.visualItemRect(item).center())
    for kind in (
        QtCore.QEvent.MouseButtonPress,
        QtCore.QEvent.MouseButtonRelease,
        QtCore.QEvent.MouseButtonDblClick,
        QtCore.QEvent.MouseButtonRelease,
    ):
        buttons = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseButtonRelease else QtCore.Qt.LeftButton
        event = QtGui.QMouseEvent(kind, place, QtCore.Qt.LeftButton, buttons, QtCore.Qt.NoModifier)
        QtWidgets.QApplication.sendEvent(tree.viewport(), event)
    settle()


def names(document):
    return [obj.Name for obj in document.Objects]


def edit_again(shell):
    """What a double click on the object in the tree does."""
    shell.ViewObject.Proxy.doubleClicked(shell.ViewObject)
    settle()
    return wait_for_result()


def legends(document):
    """Names of the legends in the document's 3D view."""
    names = []
    for view in Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor"):
        graph = view.getSceneGraph()
        children = [graph.getChild(index).getName().getString() for index in range(graph.getNumChildren())]
        names += [name for name in children if "legend" in name]
    return names


def colours_of(path):
    """{(r, g, b): number of pixels} of a picture."""
    picture = QtGui.QImage(str(path)).convertToFormat(QtGui.QImage.Format_RGB888)
    assert not picture.isNull(), f"{path} is no picture"
    data, stride = bytes(picture.constBits()), picture.bytesPerLine()
    counts = {}
    for row in range(0, picture.height(), 2):
        line = data[row * stride : row * stride + 3 * picture.width()]
        for start in range(0, len(line), 6):
            colour = tuple(line[start : start + 3])
            counts[colour] = counts.get(colour, 0) + 1
    return counts
