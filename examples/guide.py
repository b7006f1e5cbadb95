# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of docs/guide.md, taken in FreeCAD's window. `make guide`

    freecad examples/guide.py, with the folder to write to in FUNICULAR_GUIDE
"""

import os
import pathlib
import sys
import tempfile
import time
import traceback

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # 0.20's PySide merges the widgets into QtGui
    from PySide import QtGui as QtWidgets

sys.path.append(str(pathlib.Path(__file__).resolve().parent if "__file__" in globals() else "examples"))

FOLDER = pathlib.Path(os.environ["FUNICULAR_GUIDE"])
# The guide's column.
WIDTH = 680
VIEW = WIDTH // 2 - 4, 200
WINDOW = 1000, 800
PATIENCE = 60  # [s]


def until(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError(f"never came: {condition.__name__}")
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
    for _ in range(5):
        Gui.updateGui()


def settled(shell):
    def the_form_is_at_rest():
        panel = shell.ViewObject.Proxy._panel
        return panel is not None and panel.session.is_settled

    until(the_form_is_at_rest)


def from_the_same_place():
    view = Gui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.viewAxonometric()
    Gui.SendMsgToActiveView("ViewFit")
    Gui.updateGui()


def picture_of_view(width=VIEW[0], height=VIEW[1], times=2):
    """times: how much larger it is drawn, for thin lines; 1 for words that can be read."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "view.png")
        Gui.ActiveDocument.ActiveView.saveImage(path, times * width, times * height, "White")
        picture = QtGui.QImage(path)
    return picture.scaled(width, height, QtCore.Qt.IgnoreAspectRatio, QtCore.Qt.SmoothTransformation)


def beside_each_other(name, pictures, gap=8):
    height = max(picture.height() for picture in pictures)
    sheet = QtGui.QImage(
        sum(picture.width() + gap for picture in pictures) - gap, height, QtGui.QImage.Format_RGB32
    )
    sheet.fill(QtCore.Qt.white)
    painter = QtGui.QPainter(sheet)
    left = 0
    for picture in pictures:
        painter.drawImage(left, 0, picture)
        left += picture.width() + gap
    painter.end()
    sheet.save(str(FOLDER / f"{name}.png"))


def panel_part(shell, name):
    """A section of the panel, opened, as a picture."""
    form = shell.ViewObject.Proxy._panel.form
    button = form.findChild(QtWidgets.QToolButton, f"Section{name}")
    button.setChecked(True)
    until(lambda: button.parentWidget().isVisible())
    return button.parentWidget().grab().toImage()


def whole_window():
    """With the 3D view, which Qt's own grab leaves out."""
    window = Gui.getMainWindow()
    width, height = WINDOW
    window.setGeometry(0, 0, width, height)
    docks = window.findChildren(QtWidgets.QDockWidget)
    (combo,) = [dock for dock in docks if dock.isVisible() and dock.objectName() == "Combo View"]
    for dock in docks:
        if dock is not combo:
            dock.hide()
    window.resizeDocks([combo], [360], QtCore.Qt.Horizontal)
    until(lambda: window.width() == width)
    from_the_same_place()
    time.sleep(0.5)
    until(lambda: True)
    return window.screen().grabWindow(0, 0, 0, width, height)


def take():
    import roof

    document = App.newDocument("Roof")
    document.UndoMode = 1
    shell = roof.build(document)
    face = document.getObject("Surface")

    # From a face to a gridshell.
    shell.Visibility = shell.Net.Visibility = False
    face.Visibility = True
    from_the_same_place()
    before = picture_of_view()
    face.Visibility, shell.Visibility = False, True
    shell.ViewObject.ShowLegend = False
    from_the_same_place()
    beside_each_other("face", [before, picture_of_view()])

    # Held elsewhere.
    pictures = []
    for recipe in ("Corners", "Boundary"):
        shell.SupportRecipe = recipe
        document.recompute()
        from_the_same_place()
        pictures.append(picture_of_view())
    beside_each_other("supports", pictures)
    shell.SupportRecipe = "Corners and border planes"
    document.recompute()

    # Colours.
    shell.ViewObject.ShowLegend = True
    from_the_same_place()
    picture_of_view(WIDTH, 340, times=1).save(str(FOLDER / "colours.png"))

    # The panel, and alternatives.
    shell.ViewObject.Proxy.doubleClicked(shell.ViewObject)
    settled(shell)
    picture = whole_window()
    picture.scaledToWidth(WIDTH, QtCore.Qt.SmoothTransformation).save(str(FOLDER / "window.png"))
    panel = shell.ViewObject.Proxy._panel
    shell.ViewObject.ShowLegend = False
    keep = panel.form.findChild(QtWidgets.QPushButton, "KeepThis")
    keep.click()
    shell.AxialStiffness = "300 kN"
    panel.session.change()
    until(lambda: not panel.session.is_settled)
    settled(shell)
    keep.click()
    strip = panel.form.findChild(QtWidgets.QListWidget, "Variants")
    alternatives = panel_part(shell, "Alternatives")
    strip.selectAll()
    until(lambda: len(strip.selectedItems()) == 2)
    alternatives = panel_part(shell, "Alternatives")
    supports = panel_part(shell, "Supports")
    beside_each_other(
        "alternatives", [alternatives, supports], gap=WIDTH - alternatives.width() - supports.width()
    )
    panel.reject()


def run():
    code = 1
    try:
        FOLDER.mkdir(parents=True, exist_ok=True)
        Gui.activateWorkbench("FunicularWorkbench")
        take()
        code = 0
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        # FreeCAD would ask whether to save, and turn the exit code to 0.
        os._exit(code)


QtCore.QTimer.singleShot(0, run)
