# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done by hand to supports, raised nodes and members left out, with a way back step by step.

The steps are the panel's own. FreeCAD's undo knows one step, which is all that the panel did.
"""

from dataclasses import dataclass

from funicular.features.node_choice import is_used
from funicular.features.support import Support, held_by_each
from funicular.make import make_support

OF_SUPPORT = ("Label", *(each.name for each in Support.PROPERTIES if not each.mode and each.name != "Net"))
OF_NET = ("Raised", "RaisedNodes", "RaisedHeights", "RemovedMembers", "RemovedMemberNumbers")


@dataclass(frozen=True)
class _State:
    """recipe: of the gridshell. supports: ((key, {property: value}), …). of_net: {property: value}."""

    recipe: str
    supports: tuple
    of_net: dict


class SupportSteps:
    """The steps that were made since the panel came.

    Parameters
    ----------
    shell : document object
        The gridshell, inside the open transaction of its panel.
    before_removal : callable(support)
        Called before a Support is taken out of the document.
    """

    def __init__(self, shell, before_removal):
        self._shell, self._before_removal = shell, before_removal
        # (state before, state after, what may be merged into it)
        self._done, self._undone = [], []
        # A support that is brought back is another object: by key, which object it is now.
        self._names, self._next = {}, 0

    @property
    def can_undo(self):
        return bool(self._done)

    @property
    def can_redo(self):
        return bool(self._undone)

    def do(self, change, merge=None):
        """Make a step of what change() does to properties. What it raises is raised, and nothing has changed.

        merge: with the step before it one step, if that was given the same; None for a step of its own.
        """
        before = self._state()
        try:
            change()
        except Exception:
            self._restore(before)
            raise
        after = self._state()
        if after == before:
            return
        self._undone.clear()
        if merge is not None and self._done and self._done[-1][2] == merge:
            before = self._done.pop()[0]
        self._done.append((before, after, merge))

    def undo(self):
        step = self._done.pop()
        self._undone.append(step)
        self._restore(step[0])

    def redo(self):
        step = self._undone.pop()
        self._done.append(step)
        self._restore(step[1])

    def end_merging(self):
        """The next step is a step of its own."""
        if self._done:
            self._done[-1] = (*self._done[-1][:2], None)

    # Changes, to be made within do()

    def add(self, net, first=False, **properties):
        """A new Support that takes its nodes over from the others; those that are left without any go.

        net: the fn.Net as it lies. first: before the others, so that these keep what they hold.
        Raises InvalidInput, as for a kind that its nodes cannot have.
        """
        shell = self._shell
        support = make_support(shell.Document, shell, TakesOver=True, **properties)
        if first:
            shell.Supports = [support, *shell.Supports[:-1]]
        for other, nodes, _ in held_by_each(shell, net)[1:]:
            if other != support and not len(nodes):
                self.lift(other)
        return support

    def lift(self, support):
        """Let a Support go: out of the document, unless something else has use for it."""
        key = self._key(support)
        self._shell.Supports = [each for each in self._shell.Supports if each != support]
        if not is_used(support):
            self._before_removal(support)
            # Another may come to have its name.
            self._names[key] = ""
            self._shell.Document.removeObject(support.Name)

    # States

    def _state(self):
        shell = self._shell
        supports = tuple(
            (self._key(support), {name: getattr(support, name) for name in OF_SUPPORT})
            for support in shell.Supports
        )
        return _State(shell.SupportRecipe, supports, {name: getattr(shell.Net, name) for name in OF_NET})

    def _key(self, support):
        for key, name in self._names.items():
            if name == support.Name:
                return key
        self._next += 1
        self._names[self._next] = support.Name
        return self._next

    def _restore(self, state):
        shell = self._shell
        if shell.SupportRecipe != state.recipe:
            shell.SupportRecipe = state.recipe
        wanted = dict(state.supports)
        for support in shell.Supports:
            if self._key(support) not in wanted:
                self.lift(support)
        objects = [self._brought_to(key, values) for key, values in state.supports]
        if shell.Supports != objects:
            shell.Supports = objects
        _set(shell.Net, state.of_net)

    def _brought_to(self, key, values):
        """The Support of a key, made again if it is gone, with these values."""
        shell = self._shell
        name = self._names[key]
        support = shell.Document.getObject(name) if name else None
        if support is None:
            support = make_support(shell.Document, shell)
            self._names[key] = support.Name
        _set(support, values)
        return support


def _set(obj, values):
    for name, value in values.items():
        if getattr(obj, name) != value:
            setattr(obj, name, value)
