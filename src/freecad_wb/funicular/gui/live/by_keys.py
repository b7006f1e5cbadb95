# SPDX-License-Identifier: LGPL-2.1-or-later
"""A panel for those who do not use a mouse: what the Tab key comes to, and what Shift+F1 says."""

from funicular.gui.qt import QtCore, QtWidgets


def order_tabs(form):
    """Let the Tab key go through a widget as its layouts lay it out: by rows, from left to right.

    Qt goes by the order in which widgets were made.
    """
    before = None
    for widget in _in_order(form):
        if before is not None:
            QtWidgets.QWidget.setTabOrder(before, widget)
        before = widget


def explain_all(form):
    """Let Shift+F1 say of each widget at least what its tooltip does."""
    for widget in form.findChildren(QtWidgets.QWidget):
        if widget.toolTip() and not widget.whatsThis():
            widget.setWhatsThis(widget.toolTip())


def _in_order(widget):
    """Widgets that take the keyboard, by their places in layouts."""
    if widget.focusPolicy() & QtCore.Qt.TabFocus and widget.focusProxy() is None:
        yield widget
    if isinstance(widget, QtWidgets.QScrollArea):
        yield from _in_order(widget.widget())
    layout = widget.layout()
    if layout is not None:
        yield from _in_layout(layout)


def _in_layout(layout):
    for place in sorted(range(layout.count()), key=lambda place: _row_and_column(layout, place)):
        item = layout.itemAt(place)
        if item.widget() is not None:
            yield from _in_order(item.widget())
        elif item.layout() is not None:
            yield from _in_layout(item.layout())


def _row_and_column(layout, place):
    if isinstance(layout, QtWidgets.QFormLayout):
        row, role = layout.getItemPosition(place)
        return row, int(role)
    if isinstance(layout, QtWidgets.QGridLayout):
        return layout.getItemPosition(place)[:2]
    return place, 0
