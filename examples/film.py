# SPDX-License-Identifier: LGPL-2.1-or-later
"""A session in FreeCAD's window, filmed: a face, the gridshell that rises, heavier covering, bars and shadow.

    freecad examples/film.py        with FUNICULAR_FILM naming the folder for the frames
    python3 examples/film.py FOLDER film.gif        puts them together

`make gallery` does both.
"""

import os
import pathlib
import sys

FRAMES = "FUNICULAR_FILM"
WIDTH = 880  # [px] of the film
MS = 110  # a frame


def assemble(folder, path):
    """Frames of a folder into one GIF, with one palette for all: colours must not flicker."""
    from PIL import Image

    frames = [Image.open(name).convert("RGB") for name in sorted(pathlib.Path(folder).glob("*.png"))]
    if not frames:
        sys.exit(f"{folder} holds no frames: FreeCAD's window could not be filmed")
    height = round(frames[0].height * WIDTH / frames[0].width)
    frames = [frame.resize((WIDTH, height), Image.LANCZOS) for frame in frames]
    some = Image.new("RGB", (WIDTH, 4 * height))
    for place, at in enumerate((0, len(frames) // 4, len(frames) // 2, len(frames) - 1)):
        some.paste(frames[at], (0, place * height))
    palette = some.quantize(160)
    frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    frames[0].save(
        path,
        save_all=True,
        append_images=frames[1:],
        duration=[MS] * (len(frames) - 1) + [2500],
        loop=0,
        optimize=True,
    )
    print(f"{path}: {len(frames)} frames, {os.path.getsize(path) / 1e6:.1f} MB")


class Film:
    """Takes pictures of FreeCAD's window while its event loop runs."""

    def __init__(self, folder):
        self._folder, self._count = pathlib.Path(folder), 0
        self._folder.mkdir(parents=True, exist_ok=True)
        for old in self._folder.glob("*.png"):
            old.unlink()

    def roll(self, frames):
        import FreeCADGui
        from PySide import QtCore

        for _ in range(frames):
            loop = QtCore.QEventLoop()
            QtCore.QTimer.singleShot(MS, loop.quit)
            (getattr(loop, "exec", None) or loop.exec_)()
            # Of the screen, not of the window: the 3D view is not Qt's to draw.
            picture = FreeCADGui.getMainWindow().screen().grabWindow(0)
            picture.save(str(self._folder / f"{self._count:04}.png"))
            self._count += 1


def roof_face():
    import FreeCAD
    import Part

    poles = [
        [
            FreeCAD.Vector(
                16000 * i / 3, 12000 * j / 3, 5200 * (1 - (2 * i / 3 - 1) ** 2) * (1 - (2 * j / 3 - 1) ** 2)
            )
            for j in range(4)
        ]
        for i in range(4)
    ]
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(poles, [4, 4], [4, 4], [0, 1], [0, 1], False, False, 3, 3)
    return surface.toShape()


def play(film):
    import FreeCAD
    import FreeCADGui
    from PySide import QtCore

    try:
        from PySide import QtWidgets
    except ImportError:  # 0.20's PySide merges the widgets into QtGui
        from PySide import QtGui as QtWidgets

    def child(name):
        widgets = QtWidgets.QApplication.allWidgets()
        return next(each for each in widgets if each.objectName() == name and each.isVisible())

    window = FreeCADGui.getMainWindow()
    window.showMaximized()
    for dock in window.findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Python console", "Report view"):
            dock.hide()
    # The panel is what is filmed as well.
    combo = next(
        dock for dock in window.findChildren(QtWidgets.QDockWidget) if dock.objectName() == "Combo View"
    )
    window.resizeDocks([combo], [330], QtCore.Qt.Horizontal)
    view_settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    view_settings.SetBool("Gradient", False)
    view_settings.SetBool("Simple", True)
    view_settings.SetUnsigned("BackgroundColor", 0xF4F4F2FF)
    FreeCADGui.activateWorkbench("FunicularWorkbench")
    document = FreeCAD.newDocument("Pavilion")
    document.UndoMode = 1
    view = FreeCADGui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    face = document.addObject("Part::Feature", "Roof")
    face.Shape = roof_face()
    document.recompute()
    view.viewIsometric()
    view.fitAll()
    film.roll(4)
    FreeCADGui.Selection.addSelection(face, "Face1")
    film.roll(4)
    FreeCADGui.runCommand("Funicular_Gridshell")
    view.fitAll()
    film.roll(14)
    child("RecipeCorners").click()
    film.roll(12)
    view.fitAll()
    slider = child("CoveringWeightSlider")
    # The panel scrolls to what is being dragged.
    slider.setFocus()
    for value in range(slider.value(), slider.maximum(), 8):
        slider.setValue(value)
        film.roll(1)
    film.roll(6)
    shell = document.getObject("Gridshell")
    shell.ViewObject.ShowGround, shell.ViewObject.Display = True, "Round bars and covering"
    film.roll(8)
    boxes = [
        each for each in QtWidgets.QApplication.allWidgets() if isinstance(each, QtWidgets.QDialogButtonBox)
    ]
    next(box for box in boxes if box.isVisible()).button(QtWidgets.QDialogButtonBox.Ok).click()
    FreeCADGui.Selection.clearSelection()
    film.roll(6)


def in_freecad():
    import traceback

    code = 1
    try:
        play(Film(os.environ[FRAMES]))
        code = 0
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    # FreeCAD would ask whether to save.
    os._exit(code)


if FRAMES in os.environ:
    from PySide import QtCore

    QtCore.QTimer.singleShot(1500, in_freecad)
elif __name__ == "__main__":
    assemble(*sys.argv[1:])
