# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solve that can be watched and changed as it goes: paused, led step by step, begun anew, loaded anew.

It runs in a thread of its own, which ends whenever there is nothing to do. Needs numpy only; whoever watches
reads `latest` as often as it likes.
"""

import threading
import time
from dataclasses import dataclass

import numpy as np

import funicular as fn

from .panels import Cover

SLICE = 0.02  # [s] that the solver goes on for before it looks whether something else is wanted
WATCHED_FRAME = 1.0 / 30.0  # [s] between two looks at a relaxation that is meant to be watched
# Each look at it is this much more steps than the one before: the first steps can be seen one by one, and the
# many small ones at the end do not make anyone wait.
WATCHED_GROWTH = 1.03
MANY = 100  # steps, from which on they are as many as a look has time for


# Of two nets whose members lie along each other it is 1, of others about 0.
ALIKE = 0.8


def are_numbered_alike(net, other):
    """Whether the nodes of two Nets are about the same places, so that a shape of one may become the other's.

    As many nodes may well lie in other rows.
    """
    if net is other:
        return True
    if len(net.nodes) != len(other.nodes):
        return False
    begin, end = net.members.T
    here, there = (each.nodes[end] - each.nodes[begin] for each in (net, other))
    return bool(np.vdot(here, there) > ALIKE * np.linalg.norm(here) * np.linalg.norm(there))


@dataclass(frozen=True)
class Moment:
    """What a live solve has come to.

    scene: the Scene that it is about. result: the Result so far; its status is that of the solver once
    `ended`. certificate: of the result, once it has ended, and covered: the area of its panels over that on
    the source. panels: as net.panels, made once for each net. error: why there is no result, else "".
    """

    scene: object
    result: object
    ended: bool
    certificate: object = None
    covered: float = 1.0
    panels: tuple = ()
    error: str = ""


class LiveSolve:
    """A solve in a thread of its own.

    Parameters
    ----------
    scene : fn.Scene
    accuracy : float
        [m]
    method : str
        As for fn.solve.
    watched : bool
        Go at a pace that can be watched: for the relaxation, which shows how the net comes to hang.
    start : (n, 3) array, optional
        Nodes [m] to begin from, else those of the net.
    """

    def __init__(self, scene, accuracy=1e-3, method="auto", watched=False, start=None):
        self._lock = threading.Lock()
        self._thread = None
        self._order = _Order(scene, accuracy, method, watched, start)
        self._steps, self._paused = 0, False
        self._latest, self._chart, self._begun = None, [], time.monotonic()
        self._solver = self._doing = self._cover = self._covers = None
        with self._lock:
            self._wake()

    @property
    def latest(self):
        """The latest Moment, None before the first."""
        return self._latest

    @property
    def chart(self):
        """[(seconds, residual [mean nodal loads], position error [m])] of each look at the solve since the
        last change; not a number where nothing is known."""
        return list(self._chart)

    @property
    def is_paused(self):
        return self._paused

    @property
    def is_running(self):
        """Whether a thread is at work."""
        return self._thread is not None

    def change(self, scene, accuracy=1e-3, method="auto", watched=False):
        """Go on from the present shape with another scene; a net of other numbers begins as it was laid."""
        self._put(_Order(scene, accuracy, method, watched, None), goes_on=True)

    def restart(self, start=None):
        """Begin again, from the net as it was laid or from `start`."""
        with self._lock:
            last = self._order or self._doing
        self._put(_Order(last.scene, last.accuracy, last.method, last.watched, start), goes_on=False)

    def pause(self):
        self._paused = True

    def resume(self):
        with self._lock:
            self._paused = False
            self._wake()

    def step(self):
        """One iteration more, and a pause."""
        with self._lock:
            self._paused = True
            self._steps += 1
            self._wake()

    def stop(self, wait=False):
        """End the thread, after the iteration that it is in. wait: return only when it has ended."""
        with self._lock:
            self._paused, self._steps, self._order = True, 0, None
            thread = self._thread
        if wait and thread is not None:
            thread.join()

    def _put(self, order, goes_on):
        with self._lock:
            order.goes_on = goes_on
            self._order = order
            self._wake()

    def _wake(self):
        """Have a thread, if there is something to do. The lock is held."""
        if self._thread is None:
            # No daemon: Python waits for it when FreeCAD ends, and so it never runs into what is gone.
            self._thread = threading.Thread(target=self._work, name="Funicular live")
            self._thread.start()

    def _work(self):
        pace = _Pace()
        while True:
            with self._lock:
                order, self._order = self._order, None
                before = self._doing
                if order is not None:
                    self._doing = order
                single = order is None and self._steps > 0
                self._steps -= single
                ended = self._solver is None or (self._latest is not None and self._latest.ended)
                if order is None and ((self._paused and not single) or ended):
                    # Under the lock: an order that comes now finds no thread and makes one.
                    self._thread, self._steps = None, 0
                    return
            try:
                if order is not None:
                    self._begin(order, before)
                    pace = _Pace()
                    if self._paused:
                        continue
                self._advance(single, pace)
            except Exception as error:  # whatever it is, whoever watches is told, and the thread ends
                self._solver = None
                self._latest = Moment(self._doing.scene, None, True, error=str(error))

    def _begin(self, order, before):
        nodes = None if self._solver is None else self._solver.nodes
        self._chart, self._begun = [], time.monotonic()
        if order.scene.net is not self._covers:
            self._cover, self._covers = Cover(order.scene.net), order.scene.net
        if order.goes_on and nodes is not None and are_numbered_alike(before.scene.net, order.scene.net):
            if (order.accuracy, order.method) == (before.accuracy, before.method):
                self._solver.replace(order.scene)
                self._look(False)
                return
            order.start = nodes
        self._solver = None
        self._solver = fn.Solver(order.scene, accuracy=order.accuracy, method=order.method, start=order.start)
        self._look(False)

    def _advance(self, single, pace):
        if single:
            ended = self._solver.advance(0.0)
        elif self._doing.watched:
            ended = pace.advance(self._solver)
        else:
            ended = self._solver.advance(SLICE)
        self._look(ended)
        if self._doing.watched and not single and not ended:
            pace.wait()

    def _look(self, ended):
        result = self._solver.result()
        error = result.position_error if np.isfinite(result.position_error) else np.nan
        self._chart.append((time.monotonic() - self._begun, result.residual, error))
        scene = self._doing.scene
        if not ended:
            self._latest = Moment(scene, result, False, panels=self._cover.panels)
        else:
            certificate, left = fn.certify(scene, result), self._cover.left(result.nodes)
            self._latest = Moment(scene, result, True, certificate, left, self._cover.panels)


@dataclass
class _Order:
    """What is to be solved, and from where."""

    scene: object
    accuracy: float
    method: str
    watched: bool
    start: object
    goes_on: bool = False


class _Pace:
    """Ever more steps of a relaxation between two looks at it."""

    def __init__(self):
        self._share, self._due = 1.0, time.monotonic() + WATCHED_FRAME

    def advance(self, solver):
        """Whether the solve ended."""
        if self._share > MANY:
            return solver.advance(WATCHED_FRAME)
        self._share *= WATCHED_GROWTH
        return any(solver.advance(0.0) for _ in range(int(self._share)))

    def wait(self):
        time.sleep(max(0.0, self._due - time.monotonic()))
        self._due = time.monotonic() + WATCHED_FRAME
