# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a gridshell looks like: bars, covering, source, ground and shadow, exaggeration, standpoints."""

from dataclasses import replace

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
from funicular.features.form_of import form_of
from funicular.gui import legend
from funicular.gui.drawing import net_drawing, shapes
from funicular.gui.drawing.ground import GROUND, SHADOW
from funicular.gui.drawing.look import DISPLAYS
from funicular.gui.drawing.net_drawing import NetDrawing
from funicular.gui.drawing.on_screen import OnScreen
from funicular.gui.drawing.standpoint import STANDPOINTS
from funicular.make import make_gridshell
from pivy import coin
from window import (
    QtCore,
    QtGui,
    QtWidgets,
    child,
    colours_of,
    edit_again,
    panel_box,
    press,
    press_key,
    send_key,
    session_of,
    settle,
    type_into,
    wait_for_rest,
    wait_until,
)


@pytest.fixture
def shell(roof):
    roof.Visibility = False
    shell = make_gridshell(
        roof.Document, source=(roof, ["Face1"]), StepU="500 mm", StepV="500 mm", SupportRecipe="Corners"
    )
    shell.Net.Visibility = False
    roof.Document.recompute()
    assert shell.Status == "converged", shell.Summary
    settle()
    return shell


def view():
    return Gui.ActiveDocument.ActiveView


def drawings(document):
    """The drawings below the view providers of a document, wherever in its 3D view."""
    search = coin.SoSearchAction()
    search.setName(net_drawing.NAME)
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    view = Gui.getDocument(document.Name).ActiveView
    search.apply(view.getSceneGraph())
    return [search.getPaths()[number].getTail() for number in range(search.getPaths().getLength())]


def kinds_below(node):
    """Names of the types of all coin nodes below one."""
    names = [node.getTypeId().getName().getString()]
    if node.isOfType(coin.SoGroup.getClassTypeId()):
        for number in range(node.getChildren().getLength()):
            names += kinds_below(node.getChildren().get(number))
    return names


def take(path, background="White", width=1200, height=800):
    settle()
    view().saveImage(str(path), width, height, background)
    return path


def look(shell, **properties):
    for name, value in properties.items():
        setattr(shell.ViewObject, name, value)
    settle()


def share(path, rgb):
    """Share of a picture that has this very colour, each channel between 0 and 1."""
    counts = colours_of(path)
    wanted = np.rint(255 * np.array(rgb))
    near = [count for colour, count in counts.items() if np.abs(np.array(colour) - wanted).max() <= 2]
    return sum(near) / sum(counts.values())


def test_plain_lines_are_the_shape_alone(shell):
    assert drawings(shell.Document) == []
    before = kinds_below(shell.ViewObject.RootNode)
    look(shell, Display="Rectangular bars and covering", ShowGround=True, ShowSource=True, Exaggeration=3.0)
    assert len(drawings(shell.Document)) == 1
    look(shell, Display="Lines", ShowGround=False, ShowSource=False, Exaggeration=1.0)
    assert drawings(shell.Document) == [] and kinds_below(shell.ViewObject.RootNode) == before


def test_there_are_coin_nodes_for_what_is_asked_alone(shell):
    shown = {}
    for display in DISPLAYS[1:]:
        look(shell, Display=display)
        shown[display] = kinds_below(drawings(shell.Document)[0])
    faces = {display: kinds.count("IndexedFaceSet") for display, kinds in shown.items()}
    lines = {display: kinds.count("IndexedLineSet") for display, kinds in shown.items()}
    assert faces["Round bars"] == faces["Covering"] == faces["Lines and covering"] == 1
    assert faces["Round bars and covering"] == faces["Rectangular bars and covering"] == 2
    assert set(lines.values()) == {0}, "lines are those of the shape"
    assert not any("MatrixTransform" in kinds or "FaceSet" in kinds for kinds in shown.values()), "no ground"
    bars = shown["Rectangular bars"]
    look(shell, Display="Rectangular bars", ShowGround=True)
    with_ground = kinds_below(drawings(shell.Document)[0])
    assert with_ground.count("Coordinate3") == 3 and with_ground.count("FaceSet") == 1
    look(shell, ShowGround=False)
    assert kinds_below(drawings(shell.Document)[0]) == bars


def test_pictures_of_members_and_covering(shell, pictures):
    view().viewIsometric()
    view().fitAll()
    blue = {}
    look(shell, BarWidth="60 mm", BarHeight="140 mm")
    for display in DISPLAYS:
        look(shell, Display=display)
        path = take(pictures / f"look_{display.lower().replace(' ', '_')}.png")
        colours = colours_of(path)
        total = sum(colours.values())
        blue[display] = sum(n for (r, g, b), n in colours.items() if b > r + 40) / total
        timber = sum(n for (r, g, b), n in colours.items() if r > b + 25 and r > g) / total
        assert (timber > 0.03) == ("overing" in display), display
    assert blue["Covering"] < 0.2 * blue["Lines"], "the legend alone"
    assert blue["Rectangular bars"] > 1.5 * blue["Lines"], "bars have a size"
    look(shell, Display="Round bars", BarWidth="250 mm")
    path = take(pictures / "look_round_bars_close.png")
    thick = colours_of(path)
    assert sum(n for (r, g, b), n in thick.items() if b > r + 40) > 2 * blue["Round bars"] * total


@pytest.mark.parametrize("display", ["Covering", "Round bars"])
def test_the_shape_stays_for_picking(shell, display):
    view().viewTop()
    view().fitAll()
    look(shell, Display=display)
    a, b = (np.array(shell.NodePositions[node]) for node in shell.Members[100:102])
    x, y = view().getPointOnScreen(App.Vector(*(0.5 * (a + b))))
    take(QtCore.QDir.temp().filePath("drawn.png"))
    found = view().getObjectInfo((int(x), int(y)))
    assert found and found["Object"] == "Gridshell" and found["Component"].startswith("Edge"), found
    look(shell, Exaggeration=4.0)
    assert view().getObjectInfo((int(x), int(y))) is None, "it is not where it is drawn"


def test_pictures_of_the_shadow_of_two_suns(shell, pictures):
    look(shell, Display="Covering", ShowGround=True)
    shell.ViewObject.ShowLegend = False
    middles = {}
    for name, azimuth, altitude in (("morning", 95.0, 25.0), ("noon", 180.0, 60.0)):
        look(shell, SunAzimuth=azimuth, SunAltitude=altitude)
        view().viewTop()
        Gui.SendMsgToActiveView("ViewFit")
        camera = view().getCameraNode()
        camera.height = 2.4 * camera.height.getValue()
        plan = QtGui.QImage(str(take(pictures / f"look_shadow_{name}_plan.png", width=600, height=400)))
        dark = np.array(
            [
                (x, y)
                for x in range(0, plan.width(), 2)
                for y in range(0, plan.height(), 2)
                if np.abs(np.array(plan.pixelColor(x, y).getRgb()[:3]) - 255 * np.array(SHADOW)).max() < 3
            ]
        )
        assert len(dark) > 100
        middles[name] = dark.mean(axis=0) - (plan.width() / 2, plan.height() / 2)
        view().viewIsometric()
        view().fitAll()
        take(pictures / f"look_shadow_{name}.png")
    assert (
        middles["morning"][0] < -20 and abs(middles["morning"][1]) < 10
    ), "the sun in the east, a shadow west"
    assert middles["noon"][1] < -10 and abs(middles["noon"][0]) < 5, "the sun in the south, a shadow north"


def test_the_shadow_of_many_bars_is_one_colour(shell, pictures):
    look(shell, Display="Round bars", BarWidth="120 mm", ShowGround=True, SunAzimuth=200, SunAltitude=15)
    shell.ViewObject.ShowLegend = False
    view().viewIsometric()
    view().fitAll()
    path = take(pictures / "look_shadow_of_bars.png", "Current")
    assert share(path, SHADOW) > 0.02 and share(path, GROUND) > 0.1
    darker = sum(n for (r, g, b), n in colours_of(path).items() if abs(r - g) < 8 and b < r + 12 and r < 115)
    assert darker < 0.02 * share(path, SHADOW) * sum(colours_of(path).values()), "no shadow upon a shadow"


def test_the_ground_lies_at_the_supports_and_turns_with_the_sun_alone(shell):
    look(shell, Display="Covering", ShowGround=True, SunAzimuth=180, SunAltitude=45)
    first = shadow_of_top(shell)
    shell.Placement = App.Placement(App.Vector(0, 0, 500), App.Rotation(App.Vector(0, 0, 1), 90))
    shell.Document.recompute()
    turned = shadow_of_top(shell)
    for way in (first, turned):
        assert way[0] == pytest.approx(0.0, abs=1.0) and way[1] > 500.0, "to the north in the document"
        assert way[1] == pytest.approx(-way[2], abs=1.0), "at 45 degrees as far as it is high"


def shadow_of_top(shell):
    """(3,) [mm] from the highest node to its shadow, in the document."""
    search = coin.SoSearchAction()
    search.setType(coin.SoMatrixTransform.getClassTypeId())
    search.setSearchingAll(True)
    search.apply(drawings(shell.Document)[0])
    matrix = np.array(search.getPath().getTail().matrix.getValue().getValue())
    top = np.array(max(shell.NodePositions, key=lambda node: node.z))
    shadow = (np.array([*top, 1.0]) @ matrix)[:3]
    place = shell.getGlobalPlacement()
    return np.array(place.multVec(App.Vector(*shadow))) - np.array(place.multVec(App.Vector(*top)))


def test_pictures_of_the_source_and_of_the_exaggeration(shell, pictures):
    look(shell, ShowSource=True)
    view().viewIsometric()
    view().fitAll()
    plain = colours_of(take(pictures / "look_source.png"))
    grey = sum(n for (r, g, b), n in plain.items() if 150 < r < 250 and abs(r - b) < 25)
    assert grey > 0.05 * sum(plain.values())
    look(shell, Exaggeration=5.0)
    view().fitAll()
    take(pictures / "look_exaggerated.png", "Current")
    drawing = shell.ViewObject.Proxy._drawing
    source = np.array([tuple(node) for node in shell.Net.SourceNodes])
    found = np.array([tuple(node) for node in shell.NodePositions])
    assert 1e3 * drawing.drawn_nodes == pytest.approx(source + 5.0 * (found - source), abs=1e-6)
    assert "Text2" in kinds_below(drawings(shell.Document)[0])


def test_it_comes_and_goes_with_the_gridshell(shell):
    document = shell.Document
    look(shell, Display="Round bars", ShowGround=True)
    shell.ViewObject.Visibility = False
    assert drawings(document) == []
    shell.ViewObject.Visibility = True
    assert len(drawings(document)) == 1
    shell.Net.StepU = "800 mm"
    document.recompute()
    assert len(shell.ViewObject.Proxy._drawing.drawn_nodes) == len(shell.NodePositions)
    document.openTransaction("Delete")
    document.removeObject(shell.Name)
    document.commitTransaction()
    settle()
    assert drawings(document) == []
    document.undo()
    settle()
    assert len(drawings(document)) == 1
    document.redo()
    settle()
    assert drawings(document) == []


def test_it_is_kept_in_files(shell, tmp_path):
    path = str(tmp_path / "seen.FCStd")
    look(shell, Display="Rectangular bars", BarHeight="200 mm", ShowGround=True, SunAzimuth=100.0)
    kinds = kinds_below(drawings(shell.Document)[0])
    shell.Document.saveAs(path)
    App.closeDocument(shell.Document.Name)
    document = App.openDocument(path)
    settle()
    try:
        vobj = document.getObject("Gridshell").ViewObject
        assert (vobj.Display, vobj.BarHeight.Value, vobj.ShowGround) == ("Rectangular bars", 200.0, True)
        assert vobj.SunAzimuth.Value == 100.0
        assert [kinds_below(each) for each in drawings(document)] == [kinds]
        assert not Gui.getDocument(document.Name).Modified, "opening a file changes nothing in it"
    finally:
        App.closeDocument(document.Name)


def open_view_section():
    button = child(QtWidgets.QToolButton, "SectionView")
    button.setChecked(True)
    settle()


def test_the_panel_shows_what_is_chosen_and_solves_nothing_for_it(opened, pictures):
    wait_for_rest(opened)
    open_view_section()
    (drawing,) = drawings(opened.Document)
    assert kinds_below(drawing).count("IndexedFaceSet") == 0
    form, moment = session_of(opened).form, session_of(opened).moment
    display = panel_box("Display")
    display.setFocus()
    send_key(display, QtCore.Qt.Key_Down)
    assert opened.ViewObject.Display == "Round bars" and panel_box("BarWidth").isVisible()
    assert child(QtWidgets.QWidget, "BarHeight") is None, "round bars have no height"
    assert kinds_below(drawing).count("IndexedFaceSet") == 1
    assert session_of(opened).form is form and session_of(opened).moment is moment
    send_key(display, QtCore.Qt.Key_Down)
    type_into(panel_box("BarHeight"), "25 cm")
    assert opened.ViewObject.BarHeight.Value == 250.0
    panel_box("ShowGround").click()
    panel_box("SunAzimuthSlider").setValue(90)
    assert opened.ViewObject.SunAzimuth.Value == 90.0
    panel_box("ShowSource").click()
    panel_box("ExaggerationSlider").setValue(6)
    assert opened.ViewObject.Exaggeration == 3.0
    said = child(QtWidgets.QLabel, "ExaggerationSaid")
    assert "3 times" in said.text()
    shown = session_of(opened).form
    assert shown.drawn_nodes == pytest.approx(shown.source_nodes + 3.0 * (form.nodes - form.source_nodes))
    assert (shown.nodes == form.nodes).all(), "figures are the true ones"
    view().viewIsometric()
    view().fitAll()
    Gui.getMainWindow().showMaximized()
    settle(20)
    scroll_to(panel_box("Exaggeration"))
    assert Gui.getMainWindow().screen().grabWindow(0).save(str(pictures / "look_panel.png"))
    press("Ok")
    settle()
    assert len(drawings(opened.Document)) == 1, "the panel's is gone, and the view provider's is there"
    opened.Document.undo()
    settle()
    assert drawings(opened.Document) == []


def scroll_to(widget):
    parent = widget.parentWidget()
    while parent is not None and not isinstance(parent, QtWidgets.QScrollArea):
        parent = parent.parentWidget()
    if parent is not None:
        parent.ensureWidgetVisible(widget)
    settle(20)


def test_cancel_takes_the_look_back(shell):
    look(shell, Display="Covering")
    edit_again(shell)
    wait_for_rest(shell)
    open_view_section()
    assert len(drawings(shell.Document)) == 1
    panel_box("Display").setCurrentIndex(DISPLAYS.index("Round bars and covering"))
    panel_box("ShowGround").click()
    assert shell.ViewObject.Display == "Round bars and covering"
    press("Cancel")
    assert shell.ViewObject.Display == "Covering" and not shell.ViewObject.ShowGround
    (drawing,) = drawings(shell.Document)
    assert kinds_below(drawing).count("IndexedFaceSet") == 1
    assert shell.ViewObject.SwitchNode.whichChild.getValue() != coin.SO_SWITCH_NONE


def test_the_views_fit_the_net(shell, pictures):
    look(shell, Display="Lines and covering", ShowGround=True)
    edit_again(shell)
    form = wait_for_rest(shell)
    open_view_section()
    for kind in ("Perspective", "Orthographic"):
        view().setCameraType(kind)
        for name in ("Plan", "Front", "Side", "Axonometric"):
            child(QtWidgets.QToolButton, f"Look{name}").click()
            width, height = view().getSize()
            take(pictures / f"look_{kind.lower()}_{name.lower()}.png", "White", width, height)
            places, _ = OnScreen(view()).of(form.drawn_nodes * 1e3)
            size = np.array(view().getSize()) / Gui.getMainWindow().devicePixelRatioF()
            beside_legend = (legend.room_in(view()) * size[0], 0.0)
            assert beside_legend[0] > legend.WIDTH
            assert (places > beside_legend).all() and (places < size).all(), f"{kind} {name} holds the net"
            share = np.ptp(places, axis=0) / (size - beside_legend)
            assert share.max() > 0.7, f"{kind} {name} is filled by it"
            forward = np.array(view().getViewDirection())
            assert forward == pytest.approx(
                np.array(STANDPOINTS[name][0]) / np.linalg.norm(STANDPOINTS[name][0])
            )
    # The keys of the view go on from there.
    Gui.runCommand("Std_ViewTop")
    settle()
    assert view().getViewDirection().z == pytest.approx(-1.0)
    press_key(panel_box("Display"), QtCore.Qt.Key_Escape)
    settle()
    assert not Gui.Control.activeDialog(), "Esc ends the panel as ever"


def test_undo_takes_the_look_back(shell):
    document = shell.Document
    document.clearUndos()
    document.openTransaction("Look")
    look(shell, Display="Round bars", ShowSource=True)
    document.commitTransaction()
    bars = kinds_below(drawings(document)[0])
    document.undo()
    settle()
    assert shell.ViewObject.Display == "Lines" and drawings(document) == []
    document.redo()
    settle()
    assert [kinds_below(each) for each in drawings(document)] == [bars]


def test_a_gridshell_without_panels_or_with_bars_of_no_size_is_still_seen(shell):
    look(shell, Display="Round bars", BarWidth=0)
    assert drawings(shell.Document) == [], "its lines are there"
    look(shell, Display="Covering", ShowSource=True)
    drawing = NetDrawing(shell.ViewObject, instead=False)
    drawing.show(replace(form_of(shell), panels=()), shell.ViewObject.Proxy.coloured)
    lines = kinds_below(drawings(shell.Document)[-1])
    assert lines.count("IndexedLineSet") == 1 and "IndexedFaceSet" not in lines, "the source, as pale lines"
    look(shell, Exaggeration=2.0)
    drawing.show(replace(form_of(shell, 2.0), panels=()), shell.ViewObject.Proxy.coloured)
    lines = kinds_below(drawings(shell.Document)[-1])
    assert lines.count("IndexedLineSet") == 2, "and the members, where nothing covers them"
    drawing.remove()
    assert len(drawings(shell.Document)) == 1


def test_lines_stand_in_for_many_bars_until_they_are_filled_in(shell, monkeypatch):
    monkeypatch.setattr(shapes, "BLOCK", 60)
    look(shell, Display="Round bars", ShowGround=True)
    edit_again(shell)
    form = wait_for_rest(shell)
    assert len(form.members) > 3 * 60
    (drawing,) = drawings(shell.Document)
    wait_until(lambda: "IndexedFaceSet" in kinds_below(drawing), "bars")
    blocks = kinds_below(drawing).count("IndexedFaceSet") // 2
    assert blocks == -(-len(form.members) // 60), "each block is drawn, and throws a shadow"
    assert "IndexedLineSet" not in kinds_below(drawing)
    type_into(panel_box("CoveringWeight"), "80 kg/m^2")
    wait_until(lambda: "IndexedLineSet" in kinds_below(drawing), "lines while it moves")
    wait_for_rest(shell)
    wait_until(lambda: "IndexedFaceSet" in kinds_below(drawing), "bars again")
    assert "IndexedLineSet" not in kinds_below(drawing)
    press("Cancel")
