# SPDX-License-Identifier: LGPL-2.1-or-later
"""A gridshell while it is formed by hand: its properties make a scene, a solver goes on with it beside the
window, and what it has come to is shown at an even pace. The gridshell's own results stay as they are."""

import time
from collections import deque
from dataclasses import replace

import numpy as np

import funicular as fn
from funicular.features.feature import EXPECTED, reason
from funicular.features.gridshell import scene_of, solver_options
from funicular.features.net import net_of
from funicular.form import form_as_laid, form_of_moment
from funicular.live import LiveSolve, are_numbered_alike
from funicular.gui import preferences
from funicular.gui.drawing.look import exaggeration_of
from funicular.gui.qt import QtCore, translate
from funicular.pace import Pace

KEPT_FRAMES = 1000
# A net of more is laid once the user has been told: with 5 mm on the way to 500 the window would stand still.
MOST_NODES = 100_000


class Session(QtCore.QObject):
    """What all parts of the panel share.

    shell, net: the objects in the document. form: the funicular.form.Form that is shown, None before the
    first. own_form: that of the gridshell itself, while another one is looked at. moment: the
    funicular.live.Moment that it goes to. frame_seconds: what the latest frames took of the processor,
    that of whoever listens to `moved` included. accuracy: [m], as it was last taken up. problem: why the
    properties make no scene, else "".
    is_changed: whether a part has changed a property. awaited: set of who still has something to add to what
    the properties say, or to what came of it.

    A part that changes a property of the gridshell, its net or its supports calls change(); it may do so as
    often as it likes, for what has changed is taken up once a frame.
    """

    moved = QtCore.Signal()
    """Another form is shown: to be drawn, so this should take milliseconds."""

    rested = QtCore.Signal()
    """The form that was shown last stays, until something is changed: what takes longer can be drawn now."""

    came = QtCore.Signal()
    """There is another moment: numbers and sentences have changed; once more when it has ended."""

    failed = QtCore.Signal(str)
    """What the properties say makes no scene, or it cannot be solved: why. The last form stays."""

    def __init__(self, shell, parent=None):
        super().__init__(parent)
        self.shell = shell
        self.own_form = self.moment = self._other = self._goal = None
        self.frame_seconds = deque(maxlen=KEPT_FRAMES)
        self.watched, self.accuracy, self.problem, self.awaited = False, 1e-3, "", set()
        self._net = self._laid = self._live = self._pace = self._scene = None
        self._exaggeration, self._exaggerated = 1.0, None
        self._changed = self._stopped = self.is_changed = False
        # Steps of the net that was laid last, and of how many nodes the next may have.
        self._steps, self._allowed = [], 0
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(preferences.frame_ms())
        self._timer.timeout.connect(self._frame)

    @property
    def form(self):
        form = self._other if self._other is not None else self.own_form
        if form is None or form.exaggeration == self._exaggeration:
            return form
        before, exaggerated = self._exaggerated or (None, None)
        if before is not form or exaggerated.exaggeration != self._exaggeration:
            self._exaggerated = form, replace(form, exaggeration=self._exaggeration)
        return self._exaggerated[1]

    @property
    def is_looking_away(self):
        """Whether another form than the gridshell's own is shown."""
        return self._other is not None

    @property
    def net(self):
        """The Net of the gridshell, None where it was taken away."""
        return self.shell.Net

    # What the panel and its parts ask for

    def change(self):
        """A part has changed properties: take them up with the next frame."""
        self.is_changed = True
        self.follow()

    def follow(self):
        """Others have changed properties: take them up with the next frame."""
        self._changed = True
        self._timer.start()

    def lay_anyway(self):
        """Lay a net of however many nodes, having been told."""
        self._allowed = float("inf")
        self.change()

    def take_up(self):
        """Take up at once what has been changed."""
        self._take_up()
        self._timer.start()

    def restart(self):
        """Begin again from the net as it was laid."""
        if self._live is None or self._net is None:
            self.change()
            return
        self._live.restart()
        self._live.resume()
        self._pace.restart(self._net.nodes, time.monotonic())
        self._timer.start()

    def relax_slowly(self, watched):
        """Whether to watch the paper's relaxation, from the net as it was laid, instead of the fast solve."""
        if watched != self.watched:
            self.watched = watched
            self._take_up()
            if self._net is not None:
                self.restart()

    def look_at(self, form):
        """Show another Form of the same net in place of the gridshell's own; None shows that again."""
        if form is not self._other:
            self._other = form
            self.show_again()

    def show_again(self):
        """What is shown, or how it is to be seen, is another: draw it, and solve nothing."""
        if self._stopped:
            return
        self._exaggeration = exaggeration_of(self.shell.ViewObject)
        if self.form is not None:
            self.moved.emit()
            if not self._timer.isActive():
                self.rested.emit()

    def solve_scene(self, scene, of):
        """Go on with a scene that is more than what the properties say, until one of them changes.

        of: the scene of the properties that it was made of; False, and nothing else, comes of one that they
        say no more.
        """
        if of is not self._scene or self._changed or self.problem:
            return False
        self._live.change(scene, self.accuracy, self._method(), self.watched)
        self._pace.change(time.monotonic())
        self._timer.start()
        return True

    def pause(self):
        if self._live is not None:
            self._live.pause()

    def resume(self):
        if self._live is not None:
            self._live.resume()
            self._timer.start()

    def step(self):
        """One iteration more, then a pause."""
        if self._live is not None:
            self._live.step()
            self._timer.start()

    def end_solving(self):
        """Pause a solve that goes on: whether there was one."""
        is_solving = self._live is not None and self._live.is_running and not self.is_paused
        if is_solving:
            self.pause()
        return is_solving

    @property
    def is_paused(self):
        return self._live is not None and self._live.is_paused

    @property
    def is_settled(self):
        """Whether what is shown is the end of a solve of what the properties say."""
        return not (self._timer.isActive() or self.is_paused or self._changed) and self.moment is not None

    @property
    def is_result(self):
        """Whether what is shown has converged, and is what the properties say."""
        is_on_the_way = self._timer.isActive() or self._changed or self.problem or self.awaited
        return (
            not is_on_the_way
            and self.moment is not None
            and self.moment.ended
            and self.moment.result.status == "converged"
        )

    @property
    def chart(self):
        """As LiveSolve.chart."""
        return self._live.chart if self._live is not None else []

    @property
    def source_net(self):
        """The fn.Net as it was last laid, None before."""
        return self._net

    def scene_and_accuracy(self):
        """(fn.Scene, accuracy [m]) as the properties are. Raises InvalidInput."""
        return scene_of(self.shell, self._net), solver_options(self.shell)["accuracy"]

    @property
    def load_and_size(self):
        """(all loads [N], size of the net [m]) of the scene as it was last solved; zeros before."""
        if self.moment is None or self.moment.certificate is None:
            return 0.0, 0.0 if self._net is None else self._net.size
        return abs(self.moment.certificate.total_load[2]), self.moment.scene.net.size

    def stop(self):
        """Nothing more is wanted; the document may be about to go."""
        self._stopped = True
        self._timer.stop()
        if self._live is not None:
            self._live.stop()
        # With it go its connections, which hold whoever listens.
        self.deleteLater()

    # Frames

    def _frame(self):
        begun = time.thread_time()
        if self._changed:
            self._take_up()
        if self._live is None:
            self._timer.stop()
            return
        # In this order: a solve that ends after it was asked has one more frame.
        is_running = self._live.is_running
        self._look()
        arrived = True
        if self._goal is not None:
            target = self._goal.nodes
            if len(target) == len(self._pace.nodes):
                arrived = self._show_on_the_way(target, not is_running)
                self.own_form = replace(self._goal, nodes=self._pace.nodes)
                self._exaggeration = exaggeration_of(self.shell.ViewObject)
                if self._other is None:
                    self.moved.emit()
        if arrived and not is_running and not self._changed:
            self._timer.stop()
            self.rested.emit()
        self.frame_seconds.append(time.thread_time() - begun)

    def _show_on_the_way(self, target, is_final):
        """Whether what is shown is the target (n, 3) [m]."""
        now = time.monotonic()
        if preferences.animates():
            return self._pace.toward(target, now, is_final)
        self._pace.restart(target, now)
        return is_final

    def _look(self):
        moment = self._live.latest
        if moment is None or moment is self.moment:
            return
        self.moment = moment
        # The last of a solve before a change may come after it, and be of another net.
        is_of_net = moment.result is not None and are_numbered_alike(moment.scene.net, self._scene.net)
        self._goal = form_of_moment(moment) if is_of_net else None
        if moment.error:
            self._fail(moment.error)
        elif not self.problem:
            self.came.emit()

    def _method(self):
        return "relaxation" if self.watched else self.shell.Method.lower()

    def _fail(self, sentence):
        self.problem = sentence
        self.failed.emit(sentence)

    def _take_up(self):
        """Give the solver what the properties say now."""
        self._changed, self._other = False, None
        try:
            _follow_expressions(self.shell)
            self._lay_net()
            scene, self.accuracy = self.scene_and_accuracy()
        except (*EXPECTED, ReferenceError) as error:
            self._fail(str(reason(error)))
            return
        goes_on = self._scene is not None and are_numbered_alike(self._scene.net, scene.net)
        self.problem, self._scene = "", scene
        method, now = self._method(), time.monotonic()
        if self._live is None:
            self._live = LiveSolve(scene, self.accuracy, method, self.watched)
        else:
            self._live.change(scene, self.accuracy, method, self.watched)
        if not goes_on:
            self._pace, self._goal = Pace(scene.net.nodes, now), None
            # As it was laid, before it bears anything: there is something to see at once.
            self.own_form = form_as_laid(scene.net)
            self.moved.emit()
        else:
            self._pace.change(now)

    def _lay_net(self):
        """Compute the net where its properties have changed; the gridshell, and what holds it, wait."""
        net = self.net
        if net is None:
            raise fn.InvalidInput("Net is empty: close this panel and set it to a Net of this document")
        expected = self._expected_nodes(net)
        if expected > max(MOST_NODES, self._allowed):
            raise fn.InvalidInput(
                translate(
                    "These steps make about {} nodes: press Enter to lay them, or give longer ones"
                ).format(QtCore.QLocale().toString(int(float(f"{expected:.2g}"))))
            )
        # Another's recompute may have laid it anew, and then it is marked no more: its shape tells.
        if self._net is None or _is_to_compute(net) or not net.Shape.isSame(self._laid):
            self._net = None
            _compute(net)
            self._net, self._laid, self._steps = net_of(net), net.Shape, _steps_of(net)
            self._allowed = 2 * len(self._net.nodes)

    def _expected_nodes(self, net):
        """About how many nodes the steps of a Net make, from what they last made; 0 before."""
        if self._net is None:
            return 0.0
        ratios = [before / now for before, now in zip(self._steps, _steps_of(net)) if now > 0.0]
        return len(self._net.nodes) * float(np.prod(ratios))


def _steps_of(net):
    """[mm] along u and v; one that has no say is always the same."""
    counts = net.CountU, net.CountV
    return [1.0 if count else step.Value for step, count in zip((net.StepU, net.StepV), counts)]


def _follow_expressions(obj):
    """FreeCAD evaluates them when it computes an object, which here waits for OK."""
    for path, expression in obj.ExpressionEngine:
        name = path.lstrip(".")
        if name in obj.PropertiesList:
            setattr(obj, name, obj.evalExpression(expression))


def _is_to_compute(obj):
    return "Touched" in obj.State or "Invalid" in obj.State


def _compute(obj):
    """Raises InvalidInput with what the object says where it cannot be computed."""
    if not _is_to_compute(obj):
        return
    if "Invalid" in obj.State:
        # As it was before the panel came: only FreeCAD can say that it is so no more.
        try:
            obj.recompute()
        except EXPECTED:
            pass  # its state says it too, and better
        if "Invalid" in obj.State:
            raise fn.InvalidInput(obj.getStatusString())
    else:
        # Not by FreeCAD: it would open the report view with a traceback at each slip of typing.
        _follow_expressions(obj)
        try:
            obj.Proxy.execute(obj)
        except RuntimeError as error:
            raise fn.InvalidInput(str(error)) from None
    # Computed by itself an object stays marked, and the next change of anything would compute it again. What
    # depends on it still has to be.
    for user in obj.InList:
        user.touch()
    obj.purgeTouched()
