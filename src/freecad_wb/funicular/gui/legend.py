# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend of a gridshell: a colour bar with numbers, laid over every 3D view of its document.

The views themselves are the only record of what is shown: a legend is found by the name of its node, so
nothing has to be kept in step with views that come and go.
"""

import FreeCADGui
import numpy as np
from pivy import coin

from funicular.gui.qt import QT_TRANSLATE_NOOP, QtCore, QtGui, QtWidgets, translate
from funicular.gui.units import localised
from funicular.quantities import CATEGORY, SHARE, SIGNED

NODE_PREFIX = "Funicular_legend_"
WATCHED = "funicular_legends"

WIDTH, HEIGHT, GAP = 164, 262, 8
# Left of it, in halves of the window's width; and what of the width it may ask to be left free.
EDGE, MOST_ROOM = 0.02, 0.4
ROWS = 256
BAR = QtCore.QRect(14, 46, 22, 182)
# Taken from the bar for a word above it, and for each line below it but one.
WORD = 14
# How much lower the paper is where there is no bar.
SHORT = 166
PAPER, INK = QtGui.QColor(255, 255, 255, 225), QtGui.QColor(25, 30, 40)

# Above the bar and below it, by the kind of the quantity; the same where that stretch is enlarged.
WORDS = {
    SIGNED: (
        (
            QT_TRANSLATE_NOOP("Funicular", "tension +"),
            QT_TRANSLATE_NOOP("Funicular", "tension + (own scale)"),
        ),
        (
            QT_TRANSLATE_NOOP("Funicular", "compression −"),
            QT_TRANSLATE_NOOP("Funicular", "compression − (own scale)"),
        ),
    ),
    SHARE: (
        (
            QT_TRANSLATE_NOOP("Funicular", "too much"),
            QT_TRANSLATE_NOOP("Funicular", "too much (own scale)"),
        ),
        (
            QT_TRANSLATE_NOOP("Funicular", "borne"),
            QT_TRANSLATE_NOOP("Funicular", "borne (own scale)"),
        ),
    ),
}
FIXED = QT_TRANSLATE_NOOP("Funicular", "range is fixed")
CARRIES, SLACK = QT_TRANSLATE_NOOP("Funicular", "carries"), QT_TRANSLATE_NOOP("Funicular", "slack")


def _coloured(obj):
    """The colouring.Coloured that is shown of a gridshell, None for none."""
    return getattr(obj.ViewObject.Proxy, "coloured", None)


def show(obj):
    """Show or refresh the legend of `obj`, a gridshell, of the colours that its view provider shows now."""
    _watch_views()
    for graph in _scene_graphs(obj.Document):
        legend = _find(graph, obj)
        if legend is None:
            legend = _new_legend(obj)
            graph.addChild(legend)
        _draw(legend, obj, _legends(graph).index(legend))


def room_in(view):
    """Share of the width of a 3D view, from the left, that is taken by legends: none, or up to MOST_ROOM."""
    count = len(_legends(view.getSceneGraph()))
    width = view.getSize()[0] / FreeCADGui.getMainWindow().devicePixelRatioF()
    return min(0.5 * EDGE + count * (WIDTH + GAP) / width, MOST_ROOM) if count else 0.0


def hide(obj):
    """Remove the legend of `obj` from each 3D view of its document; nothing happens where there is none."""
    for graph in _scene_graphs(obj.Document):
        legend = _find(graph, obj)
        if legend is None:
            continue
        graph.removeChild(legend)
        # The others move up.
        for place, other in enumerate(_legends(graph)):
            _draw(other, _object_of(other, obj.Document), place)


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


def _object_of(legend, document):
    return document.getObject(legend.getName().getString()[len(NODE_PREFIX) :])


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
    corner.translation = (-1.0 + EDGE, -0.97, 0.999)
    image = coin.SoImage()
    image.horAlignment, image.vertAlignment = coin.SoImage.LEFT, coin.SoImage.BOTTOM
    separator = coin.SoSeparator()
    for node in (unpickable, camera, corner, image):
        separator.addChild(node)
    legend.addChild(separator)
    return legend


def _draw(legend, obj, place):
    coloured = _coloured(obj)
    if coloured is None:
        return
    picture = _picture(obj.Label, coloured, place, FreeCADGui.getMainWindow().devicePixelRatioF())
    # By position, not by name: coin's names are global, and each view has an image of its own.
    image = legend.getChild(0).getChild(3)
    size = coin.SbVec2s(picture.width(), picture.height())
    image.image.setValue(size, 4, _bottom_up_rgba(picture))


def _picture(title, coloured, place, pixel_ratio):
    # Several legends stand side by side. What keeps them apart is in the picture, for it is in pixels: the
    # scene graph knows only shares of a window whose size changes.
    before = place * (WIDTH + GAP)
    picture = QtGui.QImage(
        round((before + WIDTH) * pixel_ratio), round(HEIGHT * pixel_ratio), QtGui.QImage.Format_RGBA8888
    )
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    painter.scale(pixel_ratio, pixel_ratio)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    scale = coloured.scale
    # What needs less room is a smaller paper, at the same corner.
    is_short = scale is None or scale.quantity.kind == CATEGORY
    top = SHORT if is_short else 0
    painter.translate(before, top)
    painter.setPen(QtGui.QPen(QtGui.QColor(25, 30, 40, 90), 1.0))
    painter.setBrush(PAPER)
    painter.drawRoundedRect(QtCore.QRectF(0.5, 0.5, WIDTH - 1, HEIGHT - top - 1), 5, 5)
    _draw_titles(painter, title, coloured)
    if scale is None:
        room = QtCore.QRect(12, 44, WIDTH - 24, HEIGHT - top - 50)
        painter.drawText(room, QtCore.Qt.AlignLeft | QtCore.Qt.TextWordWrap, coloured.missing)
    elif is_short:
        _draw_entries(painter, scale)
    else:
        _draw_words(painter, scale)
        _draw_bar(painter, scale)
    painter.end()
    return picture


def _font(pixels, bold=False):
    font = QtGui.QFont(FreeCADGui.getMainWindow().font())
    font.setPixelSize(pixels)
    font.setBold(bold)
    return font


def _write(painter, left, top, words, after=""):
    """Write words, shortened if need be, and what comes after them in any case."""
    metrics = QtGui.QFontMetrics(painter.font())
    room = WIDTH - left - 8 - metrics.boundingRect(after).width()
    words = metrics.elidedText(words, QtCore.Qt.ElideRight, room) + after
    painter.drawText(
        QtCore.QRect(left, top, WIDTH - left - 6, 16), QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, words
    )


def _draw_titles(painter, title, coloured):
    painter.setPen(INK)
    painter.setFont(_font(12, bold=True))
    _write(painter, 12, 6, title)
    painter.setFont(_font(11))
    with_unit = coloured.scale is not None and coloured.scale.quantity.kind != CATEGORY
    _write(painter, 12, 22, coloured.title, f" [{coloured.scale.unit}]" if with_unit else "")


def _words(scale):
    """(above the bar, below it), "" for none."""
    above, below = WORDS.get(scale.quantity.kind, ((), ()))
    # Where all is borne, there is nothing to be told apart.
    has_below = scale.has_lower and (scale.has_upper or scale.quantity.kind == SIGNED) and below
    return (
        translate(above[scale.enlarged == "upper"]) if scale.has_upper else "",
        translate(below[scale.enlarged == "lower"]) if has_below else "",
    )


def _draw_words(painter, scale):
    painter.setFont(_font(10))
    bar = _bar(scale)
    above, below = _words(scale)
    if above:
        _write(painter, 12, bar.top() - 21, above)
    if below:
        _write(painter, 12, bar.bottom() + 7, below)
    if scale.is_fixed:
        _write(painter, 12, HEIGHT - 20, translate(FIXED))


def _bar(scale):
    above, below = _words(scale)
    lines = bool(below) + scale.is_fixed
    return BAR.adjusted(0, WORD if above else 0, 0, (1 - lines) * WORD)


def _draw_entries(painter, scale):
    for row, ((colour, _), words) in enumerate(zip(scale.entries, (CARRIES, SLACK))):
        top = 46 + 18 * row
        painter.fillRect(QtCore.QRect(14, top, 22, 12), QtGui.QColor.fromRgbF(*colour))
        _write(painter, 46, top - 2, translate(words))


def _draw_bar(painter, scale):
    bar = _bar(scale)
    # One strip, scaled: rows drawn one by one leave seams on screens with a fractional scale.
    shares = (np.arange(ROWS)[::-1] + 0.5) / ROWS
    rgbx = np.full((ROWS, 4), 255, dtype=np.uint8)
    rgbx[:, :3] = np.rint(255 * scale.bar_colours(shares))
    strip = QtGui.QImage(rgbx.tobytes(), 1, ROWS, 4, QtGui.QImage.Format_RGBX8888)
    painter.drawImage(QtCore.QRectF(bar), strip)
    painter.setPen(INK)
    painter.setBrush(QtCore.Qt.NoBrush)
    painter.drawRect(bar.adjusted(0, 0, -1, -1))
    painter.setFont(_font(11))
    for position, value in scale.marks():
        height = bar.top() + round((1.0 - position) * (bar.height() - 1))
        painter.drawLine(bar.right() + 1, height, bar.right() + 6, height)
        _write(painter, bar.right() + 11, height - 8, localised(scale.mark_text(value)))


def _bottom_up_rgba(picture):
    # RGBA8888 rows are whole multiples of four bytes, so the buffer has no padding to strip.
    return bytes(picture.mirrored(False, True).constBits())
