# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point loads in the panel: one row each, and a button that puts another on what is picked."""

import funicular as fn
from funicular.features.node_choice import is_used, nodes_of
from funicular.gui.drawing.shapes import MILLIMETRES, longest_side
from funicular.gui.live.load_row import LoadRow
from funicular.gui.picking import WrongSelection
from funicular.gui.qt import QtWidgets, translate
from funicular.gui.texts import WRONG, WrappedText


class LoadsPart(QtWidgets.QWidget):
    """The rows, and the arrows in the 3D view, which stand on the form as it moves.

    Parameters
    ----------
    session : live.session.Session
    where : callable() -> dict
        The properties of a PointLoad that say which nodes are picked. Raises WrongSelection.
    unreadable : dict
        {name: sentence} of what was written and cannot be read, shared by all boxes of a panel.
    on_edit : callable(is_typed)
        Called after each edit, as by live.inputs_part.InputsPart.
    """

    def __init__(self, session, where, unreadable, on_edit):
        super().__init__()
        self._session, self._where = session, where
        self._unreadable, self._on_edit = unreadable, on_edit
        # (PointLoad, (k,) its nodes) of the scene that is shown, and the largest of their forces.
        self._shown, self._largest, self._scene = [], 0.0, None
        # View providers whose arrows are led; Cancel brings back one that was taken away meanwhile.
        self._led = []
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        self._rows = QtWidgets.QVBoxLayout()
        self._rows.setSpacing(4)
        column.addLayout(self._rows)
        button = QtWidgets.QPushButton(translate("Add load on picked nodes"))
        button.setObjectName("AddLoad")
        button.setToolTip(
            translate(
                "Put 1 kN on each of the nodes that are picked, or on those of the edges and vertices of the "
                "source that are selected in FreeCAD"
            )
        )
        button.clicked.connect(lambda: self._add())
        column.addWidget(button)
        self._says = WrappedText("")
        self._says.setObjectName("LoadsSay")
        column.addWidget(self._says)
        self._say("")
        session.came.connect(self._came)
        session.moved.connect(self._draw)
        session.rested.connect(self._rested)
        self.show_all()

    def leave(self):
        """From now on the arrows are where the document says."""
        try:
            for load in self._session.shell.PointLoads:
                self._lead(load, False)
        except (ReferenceError, RuntimeError):
            pass  # the gridshell is gone, or the document
        for proxy in self._led:
            proxy.is_led = False
        self._session.came.disconnect(self._came)
        self._session.moved.disconnect(self._draw)
        self._session.rested.disconnect(self._rested)
        for row in self._all_rows():
            row.leave()
        self._session = self._where = self._on_edit = None
        self._unreadable, self._shown, self._led = {}, [], []

    def show_all(self):
        """Show the loads as they are in the document."""
        loads = list(self._session.shell.PointLoads)
        rows = [self._rows.itemAt(at).widget() for at in range(self._rows.count())]
        if [row.load for row in rows] == loads:
            for row in rows:
                row.show_load()
        else:
            for row in rows:
                self._unreadable.pop(row.load_name, None)
                row.leave()
                row.setParent(None)
                row.deleteLater()
            for load in loads:
                row = LoadRow(load, self._session, self._unreadable, self._on_edit, self._remove)
                self._rows.addWidget(row)
                self._lead(load, True)
        self._scene = None

    # What the buttons do

    def _add(self):
        from funicular.make import make_point_load

        shell = self._session.shell
        try:
            where = self._where()
        except WrongSelection as error:
            self._say(str(error))
            return
        self._say("")
        make_point_load(shell.Document, shell, **where)
        self.show_all()
        self._session.change()

    def _remove(self, load):
        # Cancel brings it back.
        self._lead(load, False)
        shell = self._session.shell
        shell.PointLoads = [each for each in shell.PointLoads if each != load]
        if not is_used(load):
            load.Document.removeObject(load.Name)
        self.show_all()
        self._session.change()

    def _say(self, sentence):
        self._says.setVisible(bool(sentence))
        self._says.set_colour(WRONG)
        self._says.setText(f"{WRONG[0]} {sentence}" if sentence else "")

    # What is seen

    def _came(self):
        """Look which nodes bear what in another scene."""
        moment = self._session.moment
        if moment.scene is self._scene:
            return
        self._scene, self._shown = moment.scene, []
        for row in self._all_rows():
            try:
                nodes = nodes_of(row.load, moment.scene.net)
            except (fn.InvalidInput, ReferenceError, RuntimeError):
                continue  # the state of the panel says it
            self._shown.append((row.load, nodes))
            row.show_count(len(nodes))
        self._largest = max((load.Force.Value for load, _ in self._shown), default=0.0)
        self._draw()

    def _draw(self):
        form = self._session.form
        if form is None or not self._shown:
            return
        nodes, place = form.drawn_nodes, self._session.shell.Placement
        size = longest_side(nodes)
        try:
            for load, loaded in self._shown:
                # Of another net, until it is said which of this one bear it.
                points = nodes[loaded[loaded < len(nodes)]]
                if self._session.is_looking_away:
                    # An alternative may bear others.
                    points = points[:0]
                load.ViewObject.Proxy.show(points * MILLIMETRES, place, size * MILLIMETRES, self._largest)
        except (ReferenceError, RuntimeError):
            self._shown = []  # one is gone; the next scene says which are left

    def _rested(self):
        for row in self._all_rows():
            try:
                row.follow()
            except (ReferenceError, RuntimeError):
                continue  # its load is gone; the next scene says which are left

    def _all_rows(self):
        return [self._rows.itemAt(at).widget() for at in range(self._rows.count())]

    def _lead(self, load, is_led):
        load.ViewObject.Proxy.is_led = is_led
        if is_led:
            self._led.append(load.ViewObject.Proxy)
        if not is_led:
            load.ViewObject.Proxy.refresh(load.ViewObject)
