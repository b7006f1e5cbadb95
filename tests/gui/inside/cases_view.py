# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gridshell in the 3D view and in the tree: colours, legend, pictures, files."""

import shutil
import subprocess

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from funicular.gui import legend
from funicular.make import make_gridshell
from window import (
    QtGui,
    QtWidgets,
    child,
    colours_of,
    legends,
    panel_box,
    press,
    run_command,
    select_faces,
    settle,
    wait_for_result,
)


@pytest.fixture
def shell(roof):
    roof.Visibility = False
    shell = make_gridshell(roof.Document, source=(roof, ["Face1"]), StepU="500 mm", StepV="500 mm")
    shell.Net.Visibility = False
    roof.Document.recompute()
    assert shell.Status == "converged", shell.Summary
    settle()
    return shell


def view():
    return Gui.ActiveDocument.ActiveView


def as_float(colours):
    return [tuple(round(channel, 2) for channel in colour[:3]) for colour in colours]


def test_each_member_has_the_colour_of_its_force(shell):
    colours = shell.ViewObject.LineColorArray
    assert len(colours) == len(shell.MemberForces) == shell.Net.MemberCount
    by_force = sorted(range(len(colours)), key=lambda member: shell.MemberForces[member])
    light = [0.3 * r + 0.59 * g + 0.11 * b for r, g, b in (colours[member][:3] for member in by_force)]
    # FreeCAD keeps each channel in eight bits.
    assert all(after > before - 0.004 for before, after in zip(light, light[1:])), "more force is darker"
    assert light[0] < light[-1] - 0.2


def test_colours_follow_a_new_number_of_members(shell):
    for step in ("1000 mm", "400 mm"):
        shell.Net.StepU = step
        shell.Document.recompute()
        assert len(shell.ViewObject.LineColorArray) == len(shell.MemberForces) == shell.Net.MemberCount


def test_colours_can_be_switched_off_and_on(shell):
    coloured = as_float(shell.ViewObject.LineColorArray)
    shell.ViewObject.Colours = "None"
    assert as_float(shell.ViewObject.LineColorArray) == as_float([shell.ViewObject.LineColor])
    assert legends(shell.Document) == []
    shell.ViewObject.Colours = "Force"
    assert as_float(shell.ViewObject.LineColorArray) == coloured


def test_there_is_one_legend_however_often_it_is_recomputed(shell):
    for weight in ("20 kg/m^2", "40 kg/m^2"):
        shell.CoveringWeight = weight
        shell.Document.recompute()
        assert legends(shell.Document) == ["Funicular_legend_Gridshell"]


def test_legend_goes_and_comes_with_the_gridshell(shell):
    document, vobj = shell.Document, shell.ViewObject
    vobj.Visibility = False
    assert legends(document) == []
    vobj.Visibility = True
    assert len(legends(document)) == 1
    vobj.ShowLegend = False
    assert legends(document) == []
    vobj.ShowLegend = True
    assert len(legends(document)) == 1


def test_legend_goes_with_a_deleted_gridshell_and_comes_back_with_undo(shell):
    document = shell.Document
    document.openTransaction("Delete")
    document.removeObject(shell.Name)
    document.commitTransaction()
    assert legends(document) == []
    document.undo()
    settle()
    assert legends(document) == ["Funicular_legend_Gridshell"]


def test_deleting_in_the_window_shows_the_net_again(shell):
    net = shell.Net
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(shell)
    Gui.runCommand("Std_Delete")
    settle()
    assert shell.Document.getObject("Gridshell") is None
    assert net.Visibility
    assert legends(net.Document) == []


def test_a_face_within_a_part_stays_the_parts_and_comes_back_with_the_net(roof):
    part = roof.Document.addObject("App::Part", "Building")
    part.addObject(roof)
    roof.Document.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(roof.Document.Name, "Building", "Roof.Face1")
    run_command()
    assert wait_for_result().startswith("✔")
    press("Ok")
    net = roof.Document.getObject("Net")
    assert net.ViewObject.claimChildren() == [] and not roof.Visibility
    for name in ("Gridshell", "Net"):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(roof.Document.getObject(name))
        Gui.runCommand("Std_Delete")
        settle()
    assert roof.Document.getObject("Net") is None and roof.Visibility


def papers_of_legends(path):
    """(first, last) column of each legend's paper, on a picture of the view with a black background."""
    view().saveImage(str(path), 500, 400, "Black")
    picture = QtGui.QImage(str(path))
    # Below the words, just above the lower edge.
    row = picture.height() - round(0.015 * picture.height()) - 7
    light = [QtGui.qGray(picture.pixel(x, row)) > 200 for x in range(picture.width())]
    edges = [x for x in range(1, len(light)) if light[x] != light[x - 1]]
    return list(zip(edges[0::2], edges[1::2]))


def test_the_others_legend_moves_up(shell, tmp_path):
    second = make_gridshell(shell.Document, net=shell.Net, CoveringWeight="90 kg/m^2")
    shell.Document.recompute()

    assert len(papers_of_legends(tmp_path / "both.png")) == 2
    shell.ViewObject.ShowLegend = False
    assert legends(second.Document) == [f"Funicular_legend_{second.Name}"]
    ((first, _),) = papers_of_legends(tmp_path / "one.png")
    assert first < 20


def test_a_second_view_shows_the_legend_too(shell):
    Gui.runCommand("Std_ViewCreate")
    settle()
    assert legends(shell.Document) == ["Funicular_legend_Gridshell"] * 2
    shell.ViewObject.ShowLegend = False
    assert legends(shell.Document) == []


def test_deleting_one_of_two_gridshells_leaves_the_net_hidden(shell):
    document, net = shell.Document, shell.Net
    second = make_gridshell(document, net=net, CoveringWeight="90 kg/m^2")
    document.recompute()
    for name, shown in ((second.Name, False), (shell.Name, True)):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(document.getObject(name))
        Gui.runCommand("Std_Delete")
        settle()
        assert document.getObject(name) is None
        assert net.Visibility == shown


def test_each_of_two_gridshells_has_its_legend_beside_the_other(shell, pictures):
    second = make_gridshell(shell.Document, net=shell.Net, CoveringWeight="90 kg/m^2")
    shell.Document.recompute()
    assert sorted(legends(shell.Document)) == ["Funicular_legend_Gridshell", "Funicular_legend_Gridshell001"]
    view().viewIsometric()
    # Legends are as wide as they are, in however narrow a view.
    (first, after) = papers_of_legends(pictures / "two_legends.png")
    assert first[1] < after[0]
    ratio = Gui.getMainWindow().devicePixelRatioF()
    for left, right in (first, after):
        assert right - left == pytest.approx(legend.WIDTH * ratio, abs=3)
    second.Document.removeObject(second.Name)
    assert legends(shell.Document) == ["Funicular_legend_Gridshell"]


def test_legend_does_not_count_as_part_of_the_model(shell):
    def camera_height():
        view().viewIsometric()
        view().fitAll()
        return view().getCameraNode().height.getValue()

    with_legend = camera_height()
    shell.ViewObject.ShowLegend = False
    assert camera_height() == pytest.approx(with_legend)


def test_a_copy_is_coloured_and_has_its_own_legend(shell):
    copy = shell.Document.copyObject(shell)
    shell.Document.recompute()
    assert type(copy.ViewObject.Proxy).__name__ == "ViewProviderGridshell"
    assert copy.ViewObject.Proxy is not shell.ViewObject.Proxy
    assert copy.ViewObject.claimChildren() == [shell.Net]
    assert len(copy.ViewObject.LineColorArray) == len(copy.MemberForces) == len(shell.MemberForces)
    assert sorted(legends(shell.Document)) == ["Funicular_legend_Gridshell", f"Funicular_legend_{copy.Name}"]


def test_a_file_comes_back_with_colours_legend_and_panel(shell, tmp_path):
    path = str(tmp_path / "roof.FCStd")
    forces = list(shell.MemberForces)
    shell.ViewObject.LineWidth = 5.0
    shell.Document.saveAs(path)
    App.closeDocument(shell.Document.Name)
    document = App.openDocument(path)
    settle()
    try:
        again = document.getObject("Gridshell")
        assert list(again.MemberForces) == forces
        assert type(again.ViewObject.Proxy).__name__ == "ViewProviderGridshell"
        assert len(again.ViewObject.LineColorArray) == len(forces)
        assert again.ViewObject.LineWidth == 5.0
        assert again.ViewObject.Icon is not None
        assert legends(document) == ["Funicular_legend_Gridshell"]
        assert not Gui.getDocument(document.Name).Modified, "opening a file changes nothing in it"
        again.ViewObject.Proxy.doubleClicked(again.ViewObject)
        assert wait_for_result().startswith("✔")
        press("Cancel")
    finally:
        App.closeDocument(document.Name)


def test_a_file_saved_without_a_window_gets_its_view_providers(document, tmp_path):
    path = tmp_path / "headless.FCStd"
    script = tmp_path / "headless.py"
    script.write_text(
        "import os, FreeCAD as App, Part\n"
        "from funicular.make import make_gridshell\n"
        "doc = App.newDocument('Headless')\n"
        "plane = doc.addObject('Part::Plane', 'Plane')\n"
        "plane.Length, plane.Width = 6000, 4000\n"
        "doc.recompute()\n"
        "make_gridshell(doc, source=(plane, ['Face1']), StepU='500 mm', StepV='500 mm')\n"
        "doc.recompute()\n"
        f"doc.saveAs({str(path)!r})\n"
        "os._exit(0)\n",
        encoding="utf-8",
    )
    headless = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    subprocess.run([headless, str(script)], check=True, timeout=300, stdout=subprocess.DEVNULL)
    opened = App.openDocument(str(path))
    settle()
    try:
        shell = opened.getObject("Gridshell")
        assert shell.Status == "converged"
        assert type(shell.ViewObject.Proxy).__name__ == "ViewProviderGridshell"
        assert type(shell.Net.ViewObject.Proxy).__name__ == "ViewProviderNet"
        assert shell.ViewObject.claimChildren() == [shell.Net]
        assert len(shell.ViewObject.LineColorArray) == len(shell.MemberForces)
        assert legends(opened) == ["Funicular_legend_Gridshell"]
    finally:
        App.closeDocument(opened.Name)


def test_closing_a_document_leaves_the_others_legend(shell):
    other = App.newDocument("Other")
    settle()
    App.closeDocument(other.Name)
    settle()
    assert legends(shell.Document) == ["Funicular_legend_Gridshell"]


def test_picture_shows_blue_members_and_the_legend(shell, pictures):
    view().viewIsometric()
    view().fitAll()
    settle()
    path = pictures / "gridshell.png"
    view().saveImage(str(path), 1200, 800, "White")
    colours = colours_of(path)
    total = sum(colours.values())
    blue = sum(count for (r, g, b), count in colours.items() if b > r + 40 and b > g)
    assert blue > 0.01 * total, "members are drawn in the blue of compression"
    assert len(colours) > 200, "many forces, many shades"
    dark = sum(count for colour, count in colours.items() if max(colour) < 90)
    assert dark > 0.0005 * total, "the legend is written in dark ink"
    shell.ViewObject.ShowLegend = False
    settle()
    bare = pictures / "without_legend.png"
    view().saveImage(str(bare), 1200, 800, "White")
    left_out = sum(count for colour, count in colours_of(bare).items() if max(colour) < 90)
    assert left_out < dark / 2


def test_picture_of_tension_shows_orange(document, pictures):
    # Two-way members: the hoops of a hemisphere pull below 52 degrees from its apex.
    dome = document.addObject("Part::Sphere", "Dome")
    dome.Radius, dome.Angle1 = 4000, 0
    document.recompute()
    shell = make_gridshell(
        document,
        source=(dome, ["Face1"]),
        StepU="800 mm",
        StepV="600 mm",
        AllowTension=True,
        CoveringWeight=0,
    )
    dome.Visibility = shell.Net.Visibility = False
    document.recompute()
    assert not shell.CompressionOnly and shell.TensionMembers, shell.Summary
    view().viewIsometric()
    view().fitAll()
    settle()
    path = pictures / "tension.png"
    view().saveImage(str(path), 1200, 800, "Current")
    orange = sum(count for (r, g, b), count in colours_of(path).items() if r > b + 80)
    assert orange > 500


def test_picture_of_an_error_in_the_panel(document, pictures):
    plate = document.addObject("Part::Feature", "Plate")
    hole = Part.makeCylinder(20, 10, App.Vector(1500, 900, -5))
    plate.Shape = Part.makePlane(3000, 2000).cut(hole).Faces[0]
    document.recompute()
    select_faces(plate, "Face1")
    run_command()
    assert wait_for_result().startswith("✖")
    settle(20)
    line = panel_box("ResultLine")
    assert (
        line.width() <= line.parentWidget().width() and line.heightForWidth(line.width()) <= line.height() + 2
    )
    path = pictures / "error.png"
    assert Gui.getMainWindow().screen().grabWindow(0).save(str(path))
    corner = line.mapToGlobal(line.rect().topLeft())
    written = QtGui.QImage(str(path)).copy(corner.x(), corner.y(), line.width(), line.height())
    pixels = [written.pixelColor(x, y) for x in range(written.width()) for y in range(written.height())]
    assert sum(pixel.red() > pixel.blue() + 60 for pixel in pixels) > 200, "the sentence is written in red"
    press("Cancel")


def test_picture_of_the_whole_window_with_its_panel(roof, pictures):
    window = Gui.getMainWindow()
    window.showMaximized()
    select_faces(roof, "Face1")
    run_command()
    wait_for_result()
    Gui.Selection.clearSelection()
    view().viewIsometric()
    view().fitAll()
    # What is asked below is in the part of the panel that is seen.
    child(QtWidgets.QToolButton, "SectionNet").click()
    child(QtWidgets.QToolButton, "SectionMoreOfTheNet").click()
    settle(20)
    path = pictures / "window.png"
    # Of the screen, not of the window: the 3D view is not Qt's to draw.
    assert window.screen().grabWindow(0).save(str(path))
    picture = QtGui.QImage(str(path))
    assert picture.width() >= 1000 and picture.height() >= 700
    colours = colours_of(path)
    total = sum(colours.values())
    assert len(colours) > 500
    assert max(colours.values()) < 0.7 * total, "no one colour fills the screen"
    assert sum(count for (r, g, b), count in colours.items() if b > r + 60 and b > g + 20) > 2000
    box = panel_box("CoveringWeight")
    corner = box.mapToGlobal(box.rect().topLeft())
    assert QtWidgets.QApplication.primaryScreen().geometry().contains(corner), "the panel is on the screen"
    written = picture.copy(corner.x(), corner.y(), box.width(), box.height())
    shades = {written.pixel(x, y) for x in range(written.width()) for y in range(written.height())}
    assert len(shades) > 5, "the box shows its value"
    press("Cancel")
