# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an architect may not want of a form that was found, in plain words, each with what can be done."""

import numpy as np

from funicular.features.result_words import slack_of
from funicular.gui.qt import QtWidgets, translate
from funicular.gui.texts import DOUBTFUL, WrappedText

# Of the largest force: what pulls less is rounding.
ROUNDING = 1e-6


class WarningsList(QtWidgets.QWidget):
    """A sentence and its buttons for each warning; empty, and without height, where all is well.

    Parameters
    ----------
    session : live.session.Session
    show_these : callable(nodes, members)
        Shows nodes and members, by their numbers, in the 3D view.
    do : callable(change)
        Makes a step that can be taken back of what change() does.
    """

    def __init__(self, session, show_these, do):
        super().__init__()
        self._session, self._show_these, self._do_step = session, show_these, do
        # What the Net said of members taken out before some were left out here.
        self._before = None
        self._column = QtWidgets.QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(2)
        # What is warned of, and the moment that it is of: a solve that goes on has none yet.
        self._told = self._moment = None

    def forget(self):
        """Others have changed the net: what was left out here cannot be taken back by itself."""
        self._before = None

    def clear(self):
        self._tell(())

    def show_moment(self, moment):
        """Warn of what there is to warn of in a moment that has ended."""
        self._moment = moment
        self._tell(tuple(self._of(moment)))

    def _of(self, moment):
        """(sentence, ((button, what it does), …)) of each warning."""
        result, certificate, shell = moment.result, moment.certificate, self._session.shell
        show, no_nodes = translate("Show"), ()
        if result.status == "no_equilibrium":
            yield (
                translate("The members cannot carry these loads."),
                ((translate("Ten times as stiff"), "stiffen"),),
            )
            return
        if self._left_out() is not None:
            yield (
                translate("Slack members were left out of the net."),
                ((translate("Take them back"), "take_back"),),
            )
        slack, tension = slack_of(moment.scene, certificate), list(certificate.tension_members)
        if slack:
            yield (
                translate("{} members are slack: they carry nothing.").format(len(slack)),
                ((show, ("show", no_nodes, tuple(slack))), (translate("Leave them out"), "leave_out")),
            )
        if tension:
            only = ((translate("Compression only"), "compression"),) if shell.AllowTension else ()
            yield (
                translate("{} members are in tension.").format(len(tension)),
                ((show, ("show", no_nodes, tuple(tension))), *only),
            )
        up = np.asarray(result.reactions)[:, 2]
        pulling = np.flatnonzero(up < -ROUNDING * max(np.abs(up).max(initial=0.0), 1e-300))
        if len(pulling):
            yield (
                translate("{} supports pull the shell down, so it pulls upward there.").format(len(pulling)),
                ((show, ("show", tuple(pulling.tolist()), ())),),
            )

    def _tell(self, warnings):
        if warnings == self._told:
            return
        self._told = warnings
        while self._column.count():
            widget = self._column.takeAt(0).widget()
            widget.setParent(None)
            widget.deleteLater()
        for number, (sentence, buttons) in enumerate(warnings):
            self._column.addWidget(self._row(number, sentence, buttons))

    def _row(self, number, sentence, buttons):
        row = QtWidgets.QWidget()
        grid = QtWidgets.QGridLayout(row)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(2)
        text = WrappedText(f"{DOUBTFUL[0]} {sentence}")
        text.set_colour(DOUBTFUL)
        text.setObjectName(f"Warning{number}")
        grid.addWidget(text, 0, 0, 1, len(buttons))
        for column, (words, action) in enumerate(buttons):
            button = QtWidgets.QPushButton(words)
            name = action if isinstance(action, str) else action[0]
            button.setObjectName(f"Warning{number}_{name}")
            button.clicked.connect(lambda _=False, action=action: self._do(action))
            grid.addWidget(button, 1, column)
        return row

    def _do(self, action):
        session, shell = self._session, self._session.shell
        if action == "stiffen":
            shell.AxialStiffness = 10.0 * shell.AxialStiffness
        elif action == "compression":
            shell.AllowTension = False
        elif action == "leave_out":
            self._leave_out()
        elif action == "take_back":
            self._set_taken_out(self._before)
        else:
            self._show_these(*action[1:])
            return
        session.change()

    def _leave_out(self):
        from funicular.features.picked_edits import taken_out_of_net

        members, net = self._moment.scene.net.members, self._session.source_net
        if net is None or not np.array_equal(members, net.members):
            # Of another net than it now is, and what that comes to is not known yet.
            return
        pairs = members[slack_of(self._moment.scene, self._moment.certificate)]
        before = self._left_out() or self._taken_out()
        self._set_taken_out(taken_out_of_net(self._session.net, pairs))
        self._before = before

    def _taken_out(self):
        net = self._session.net
        return {name: getattr(net, name) for name in ("RemovedMembers", "RemovedMemberNumbers")}

    def _left_out(self):
        """What the Net said before members were left out here; None where that is what it says."""
        if self._before is None or self._session.net is None or self._before == self._taken_out():
            return None
        return self._before

    def _set_taken_out(self, values):
        def change():
            for name, value in values.items():
                setattr(self._session.net, name, value)

        self._do_step(change)
