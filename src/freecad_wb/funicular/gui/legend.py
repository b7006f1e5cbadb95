# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend of a gridshell: a colour bar with forces, laid over every 3D view of its document.

The views themselves are the only record of what is shown: a legend is found by the name of its node, so
nothing has to be kept in step with views that come and go.
"""

import FreeCADGui
from pivy import coin

from funicular.colours import ForceScale
from funicular.gui import preferences
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtGui, QtWidgets, translate

NODE_PREFIX = "Funicular_legend_"
WATCHED = "funicular_legends"

WIDTH, HEIGHT, GAP = 164, 262, 8
BAR = QtCore.QRect(14, 46, 22, 182)
# Taken from the bar where a word stands above it.
WORD = 14
PAPER, INK = QtGui.QColor(255, 255, 255, 225), QtGui.QColor(25, 30, 40)

COMPRESSION = QT_TRANSLATE_NOOP("Funicular", "compression −")
TENSION = QT_TRANSLATE_NOOP("Funicular", "tension +")
TENSION_ENLARGED = QT_TRANSLATE_NOOP("Funicular", "tension + (own scale)")
COMPRESSION_ENLARGED = QT_TRANSLATE_NOOP("Funicular", "compression − (own scale)")
MEMBER_FORCE = QT_TRANSLATE_NOOP("Funicular", "Member force")


def scale_of(obj):
    """The colours of a gridshell's members in the 3D view, and the forces that they stand for."""
    return ForceScale(obj.MemberForces, obj.TensionMembers, preferences.ramps())


def show(obj):
    """Show or refresh the legend of `obj`, a gridshell, in each 3D view of its document."""
    _watch_views()
    for graph in _scene_graphs(obj.Document):
        legend = _find(graph, obj)
        if legend is None:
            legend = _new_legend(obj)
            graph.addChild(legend)
        _draw(legend, obj, _legends(graph).index(legend))


def hide(obj):
    """Remove the legend of `obj` from each 3D view of its document; nothing happens where there is none."""
    for graph in _scene_graphs(obj.Document):
        legend = _find(graph, obj)
        if legend is None:
            continue
        graph.removeChild(legend)
        # The others move up.
        for place, other in enumerate(_legends(graph)):
            _draw(other, obj.Document.getObject(other.getName().getString()[len(NODE_PREFIX) :]), place)


def _watch_views():
    """FreeCAD tells no one of a new 3D view; its window area does once the view is entered."""
    area = FreeCADGui.getMainWindow().findChild(QtWidgets.QMdiArea)
    if not area.property(WATCHED):
        area.setProperty(WATCHED, True)
        area.subWindowActivated.connect(_complete)


def _complete(_window):
    """Give a new view the legends that another view of its document shows."""
    active = FreeCADGui.activeDocument()
    if active is None:
        return
    shown = [_legends(graph) for graph in _scene_graphs(active.Document)]
    names = {legend.getName().getString() for legends in shown for legend in legends}
    if any(len(legends) < len(names) for legends in shown):
        for name in sorted(names):
            show(active.Document.getObject(name[len(NODE_PREFIX) :]))


def _scene_graphs(document):
    views = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")
    return [view.getSceneGraph() for view in views]


def _legends(graph):
    children = (graph.getChild(index) for index in range(graph.getNumChildren()))
    return [child for child in children if child.getName().getString().startswith(NODE_PREFIX)]


def _find(graph, obj):
    name = NODE_PREFIX + obj.Name
    return next((legend for legend in _legends(graph) if legend.getName().getString() == name), None)


def _new_legend(obj):
    # FreeCAD's own group: without it "fit all" would zoom to the legend too.
    legend = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    legend.setName(NODE_PREFIX + obj.Name)
    unpickable = coin.SoPickStyle()
    unpickable.style = coin.SoPickStyle.UNPICKABLE
    camera = coin.SoOrthographicCamera()
    # The window always spans [-1, 1] in both directions, so the corners need no knowledge of its size.
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.aspectRatio = 1.0
    camera.height = 2.0
    camera.position = (0.0, 0.0, 1.0)
    camera.nearDistance, camera.farDistance = 0.0, 2.0
    # At the near plane: in front of the model wherever in the graph the model is drawn.
    corner = coin.SoTranslation()
    corner.translation = (-0.98, -0.97, 0.999)
    image = coin.SoImage()
    image.horAlignment, image.vertAlignment = coin.SoImage.LEFT, coin.SoImage.BOTTOM
    separator = coin.SoSeparator()
    for node in (unpickable, camera, corner, image):
        separator.addChild(node)
    legend.addChild(separator)
    return legend


def _draw(legend, obj, place):
    picture = _picture(obj.Label, scale_of(obj), place, FreeCADGui.getMainWindow().devicePixelRatioF())
    # By position, not by name: coin's names are global, and each view has an image of its own.
    image = legend.getChild(0).getChild(3)
    size = coin.SbVec2s(picture.width(), picture.height())
    image.image.setValue(size, 4, _bottom_up_rgba(picture))


def _picture(title, scale, place, pixel_ratio):
    # Several legends stand side by side. What keeps them apart is in the picture, for it is in pixels: the
    # scene graph knows only shares of a window whose size changes.
    before = place * (WIDTH + GAP)
    picture = QtGui.QImage(
        round((before + WIDTH) * pixel_ratio), round(HEIGHT * pixel_ratio), QtGui.QImage.Format_RGBA8888
    )
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    painter.scale(pixel_ratio, pixel_ratio)
    painter.translate(before, 0)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtGui.QPen(QtGui.QColor(25, 30, 40, 90), 1.0))
    painter.setBrush(PAPER)
    painter.drawRoundedRect(QtCore.QRectF(0.5, 0.5, WIDTH - 1, HEIGHT - 1), 5, 5)
    _draw_words(painter, title, scale)
    _draw_bar(painter, scale)
    painter.end()
    return picture


def _font(pixels, bold=False):
    font = QtGui.QFont(FreeCADGui.getMainWindow().font())
    font.setPixelSize(pixels)
    font.setBold(bold)
    return font


def _draw_words(painter, title, scale):
    painter.setPen(INK)
    painter.setFont(_font(12, bold=True))
    room = WIDTH - 24
    title = QtGui.QFontMetrics(painter.font()).elidedText(title, QtCore.Qt.ElideRight, room)
    painter.drawText(QtCore.QRect(12, 6, room, 16), QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, title)
    painter.setFont(_font(11))
    quantity = f"{translate(MEMBER_FORCE)} [{scale.unit}]"
    painter.drawText(QtCore.QRect(12, 22, room, 16), QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, quantity)
    above, below = "", ""
    if scale.largest_tension > 0.0:
        small = not scale.one_scale and scale.largest_tension < scale.largest_compression
        above = translate(TENSION_ENLARGED if small else TENSION)
    if scale.largest_compression > 0.0:
        small = not scale.one_scale and scale.largest_compression < scale.largest_tension
        below = translate(COMPRESSION_ENLARGED if small else COMPRESSION)
    painter.setFont(_font(10))
    bar = _bar(scale)
    for top, words in ((bar.top() - 21, above), (bar.bottom() + 8, below)):
        painter.drawText(QtCore.QRect(12, top, room, 16), QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, words)


def _bar(scale):
    return BAR.adjusted(0, WORD, 0, 0) if scale.largest_tension > 0.0 else BAR


def _draw_bar(painter, scale):
    bar = _bar(scale)
    # One strip, scaled: rows drawn one by one leave seams on screens with a fractional scale.
    strip = QtGui.QImage(1, 256, QtGui.QImage.Format_RGBA8888)
    for row in range(strip.height()):
        colour = scale.bar_colour(1.0 - (row + 0.5) / strip.height())
        strip.setPixelColor(0, row, QtGui.QColor.fromRgbF(*colour))
    painter.drawImage(QtCore.QRectF(bar), strip)
    painter.setPen(INK)
    painter.setBrush(QtCore.Qt.NoBrush)
    painter.drawRect(bar.adjusted(0, 0, -1, -1))
    painter.setFont(_font(11))
    for position, force in scale.marks():
        height = bar.top() + round((1.0 - position) * (bar.height() - 1))
        painter.drawLine(bar.right() + 1, height, bar.right() + 6, height)
        room = QtCore.QRect(bar.right() + 11, height - 8, WIDTH - bar.right() - 16, 16)
        painter.drawText(room, QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, scale.text(force))


def _bottom_up_rgba(picture):
    # RGBA8888 rows are whole multiples of four bytes, so the buffer has no padding to strip.
    return bytes(picture.mirrored(False, True).constBits())
