# SPDX-License-Identifier: LGPL-2.1-or-later
"""One point load in the panel: on how many nodes, how large, where it points to, and how it goes."""

import FreeCAD

from funicular.gui.inputs import expression_of, make_input, show_value
from funicular.gui.live.slider import AmountSlider
from funicular.gui.qt import QT_TRANSLATE_NOOP, QtWidgets, translate

DIRECTIONS = (
    (QT_TRANSLATE_NOOP("Funicular", "down"), (0, 0, -1)),
    (QT_TRANSLATE_NOOP("Funicular", "up"), (0, 0, 1)),
    (QT_TRANSLATE_NOOP("Funicular", "along x"), (1, 0, 0)),
    (QT_TRANSLATE_NOOP("Funicular", "against x"), (-1, 0, 0)),
    (QT_TRANSLATE_NOOP("Funicular", "along y"), (0, 1, 0)),
    (QT_TRANSLATE_NOOP("Funicular", "against y"), (0, -1, 0)),
)


class LoadRow(QtWidgets.QWidget):
    """Its widgets are called after the load: PointLoadForce, PointLoadForceSlider, PointLoadDirection, ….

    Parameters
    ----------
    load : document object
        The PointLoad.
    session : live.session.Session
    unreadable : dict
    on_edit : callable(is_typed)
        Both as for LoadsPart.
    on_remove : callable(load)
    """

    def __init__(self, load, session, unreadable, on_edit, on_remove):
        super().__init__()
        self.load, self.load_name = load, load.Name
        self._session, self._unreadable, self._on_edit = session, unreadable, on_edit
        grid = QtWidgets.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(4)
        grid.setVerticalSpacing(1)
        grid.setColumnStretch(0, 1)
        grid.setColumnStretch(1, 1)
        self._label = QtWidgets.QLabel()
        self._label.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)
        grid.addWidget(self._label, 0, 0, 1, 2)
        remove = QtWidgets.QToolButton()
        remove.setObjectName(f"{load.Name}Remove")
        remove.setText("✕")
        remove.setAutoRaise(True)
        remove.setToolTip(translate("Take {} away").format(load.Label))
        remove.setAccessibleName(translate("Remove"))
        remove.clicked.connect(lambda: on_remove(self.load))
        grid.addWidget(remove, 0, 2)
        self._force = make_input(load, "Force", lambda value: self._set_force(value, False), self._unread)
        self._force.setObjectName(f"{load.Name}Force")
        self._label.setBuddy(self._force)
        grid.addWidget(self._force, 1, 0)
        self._direction = QtWidgets.QComboBox()
        self._direction.setObjectName(f"{load.Name}Direction")
        self._direction.setToolTip(translate("Where the force points to"))
        self._direction.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self._direction.setMinimumContentsLength(6)
        for words, direction in DIRECTIONS:
            self._direction.addItem(translate(words), direction)
        self._direction.currentIndexChanged.connect(self._set_direction)
        grid.addWidget(self._direction, 1, 1, 1, 2)
        self._slider = None
        if not expression_of(load, "Force"):
            self._slider = AmountSlider(
                "Force", load.Force, session, lambda value: self._set_force(value, True)
            )
            self._slider.setObjectName(f"{load.Name}ForceSlider")
            self._slider.setToolTip(self._force.toolTip())
            grid.addWidget(self._slider, 2, 0, 1, 3)
        self.show_count(len(load.LoadedNodes))
        self.show_load()

    def leave(self):
        """Hold nothing of the panel: PySide keeps what FreeCAD's own boxes were connected to."""
        self._session = self._on_edit = self._slider = None
        self._unreadable = {}

    def show_count(self, count):
        """Tell on how many nodes it is."""
        words = translate("{}, {} nodes") if count != 1 else translate("{}, {} node")
        self._label.setText(words.format(self.load.Label, count))

    def show_load(self):
        """Show what the load has become by other hands."""
        self._unreadable.pop(self.load_name, None)
        show_value(self._force, self.load, "Force")
        self.follow()
        wanted = tuple(self.load.Direction)
        blocked = self._direction.blockSignals(True)
        known = [self._direction.itemData(at) for at in range(self._direction.count())]
        at = next((at for at, each in enumerate(known) if tuple(each) == wanted), None)
        if at is None:
            self._direction.addItem("({:g}, {:g}, {:g})".format(*wanted), wanted)
            at = self._direction.count() - 1
        self._direction.setCurrentIndex(at)
        self._direction.blockSignals(blocked)

    def _set_force(self, quantity, at_once):
        if self._session is None:
            return
        self._unreadable.pop(self.load_name, None)
        try:
            if not expression_of(self.load, "Force") and self.load.Force != quantity:
                self.load.Force = quantity
                if at_once:
                    show_value(self._force, self.load, "Force")
                    self._session.change()
            self.follow()
        except ReferenceError:
            # The load is gone, and what depended on it says so when it is solved.
            self._session.change()
        self._on_edit(not at_once)

    def _set_direction(self, at):
        self.load.Direction = FreeCAD.Vector(*self._direction.itemData(at))
        self._session.change()

    def follow(self):
        """Let the slider stand where the force is, in the range that the scene has now."""
        if self._slider is not None and not self._slider.isSliderDown():
            self._slider.show_amount(self.load.Force.Value)

    def _unread(self, sentence):
        if self._session is None:
            return
        self._unreadable[self.load_name] = sentence
        self._on_edit(True)
