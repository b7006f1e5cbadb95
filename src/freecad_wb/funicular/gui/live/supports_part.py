# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports by hand: nodes are picked in the 3D view, held in one way or another, weakened, lifted, raised."""

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

import funicular as fn
from funicular.features.picked_edits import raised_of_net
from funicular.features.node_choice import NODE_RECIPES, at_nodes
from funicular.features.support import FIXED, FREE, LINE, PLANE, held_by_each
from funicular.gui.drawing.mark_shapes import DOT, HOVER, RING
from funicular.gui.drawing.on_screen import OnScreen
from funicular.gui.drawing.support_marks import SupportMarks
from funicular.gui.live.directions import direction_of
from funicular.gui.live.pick_tools import OFF, PickTools
from funicular.gui.live.picks import Picks
from funicular.gui.live.stiffness_row import NONE, RIGID
from funicular.gui.live.support_list import stiffness_of, words_of
from funicular.gui.live.support_steps import SupportSteps
from funicular.gui.live.supports_form import SupportsForm
from funicular.gui.picking import WrongSelection
from funicular.gui.qt import translate
from funicular.gui.texts import WRONG
from funicular.held import held_of
from funicular.live import are_numbered_alike

MILLIMETRE = 1e-3  # [m]
CLOSE = 18.0  # [px] from node to node


class SupportsPart(SupportsForm):
    """The section of the panel that is about supports, and what of it is in the 3D view.

    Parameters
    ----------
    session : live.session.Session
    pointer : live.pointer.Pointer
    """

    def __init__(self, session, pointer):
        super().__init__(session.shell)
        self._session, self._shell, self._pointer = session, session.shell, pointer
        # As held_by_each(), the fn.Net that it is of, and the fn.Scene; (SwitchNode, what it showed) of
        # supports by their names.
        self._held, self._net, self._scene, self._hidden = [], None, None, {}
        # What a support was before it was freed by the slider.
        self._kinds_before = {}
        # Whether the words say why nothing can be held as the properties are.
        self._fails = False
        self._hovered, self._are_close = (), False
        self.marks = SupportMarks(self._shell.ViewObject)
        self.picks = Picks(self._picked)
        self.steps = SupportSteps(self._shell, self._show_shape)
        self.tools = PickTools(session, self.picks, self._all_held, self._shell.ViewObject)
        self.tools.hovered.connect(self._hover)
        self.tools.clicked_mark.connect(self._choose_mark)
        self.tools.raised.connect(self._raise)
        self.tools.changed.connect(lambda: self.show_tool(self.tools.tool))
        pointer.add(self.tools)
        session.came.connect(self._came)
        session.moved.connect(self._draw)
        self.list.chosen.connect(self._chosen)
        self.list.chosen.connect(self._say_what_is_picked)
        self._hide_shapes()
        self._say_what_is_picked()
        self.show_steps(self.steps)

    def leave(self):
        """Take everything out of the 3D view."""
        self.tools.leave()
        self._pointer.remove(self.tools)
        self.marks.remove()
        self._pointer.tip.say(self.tools, "")
        for switch, was in self._hidden.values():
            try:
                switch.whichChild = was
            except (ReferenceError, RuntimeError):
                pass  # it is gone
        self._hidden = {}
        # PySide keeps some of what widgets were connected to: that holds nothing of the panel.
        self._session = self._pointer = None
        self.tools.deleteLater()

    # What follows the session

    def _came(self):
        net = self._session.source_net
        if net is not self._net:
            if self._net is None or not are_numbered_alike(self._net, net):
                self.picks.clear()
            self._net = net
        self.stiffness.set_mean_load(self._session.load_and_size[0] / len(net.nodes))
        view = FreeCADGui.getDocument(self._shell.Document.Name).activeView()
        if hasattr(view, "getCameraNode"):
            self._fit(OnScreen(view, self._shell.getGlobalPlacement()))
        if self._session.moment.scene is not self._scene:
            # What holds it is another only with another scene.
            self._scene = self._session.moment.scene
            self._take_held()

    def _take_held(self, after_step=False):
        """Mark and list what holds the form as the properties now are."""
        if self._net is None or self._shell.Net is None:
            return
        wrong = ""
        try:
            self._held = held_by_each(self._shell, self._net)
        except fn.InvalidInput as error:
            # Said here too: the line on top may be out of sight. Nothing is held until it is mended.
            wrong = str(error)
            self._held = [(support, np.zeros(0, dtype=int), []) for support in self._shell.Supports]
        supports = [each for _, _, made in self._held for each in made]
        free = [nodes for support, nodes, _ in self._held if support is not None and support.Kind == FREE]
        self.marks.hold(held_of(supports), np.concatenate(free) if free else np.zeros(0, dtype=int))
        self.list.show_held(self._shell, self._held)
        self.recipes.show_recipe()
        self._hide_shapes()
        self._chosen()
        self._draw()
        if wrong:
            self.say_what_is_wrong(wrong)
        elif after_step or self._fails:
            self._say_what_is_picked()
        self._fails = bool(wrong)

    def _draw(self, only=None):
        # What holds an alternative is not what holds the present form.
        self.marks.set_shown(not self._session.is_looking_away)
        if self._session.form is not None:
            self.marks.show(self._session.form, self._are_close, only)

    def _fit(self, screen):
        """Let marks be small where members are short on the screen, an OnScreen."""
        form = self._session.form
        if form is None:
            return
        are_close = screen.length_of(form.drawn_nodes / MILLIMETRE, form.members) < CLOSE
        if are_close != self._are_close:
            self._are_close = are_close
            self._draw()

    def _all_held(self):
        """(k,) nodes with a mark."""
        return np.concatenate([np.zeros(0, dtype=int), *(nodes for _, nodes, _ in self._held)])

    # The list and the view

    def _chosen(self):
        """Something else is chosen in the list."""
        names = self.list.names()
        nodes = [nodes for support, nodes, _ in self._held if _name(support) in names]
        self.marks.choose(np.concatenate(nodes) if nodes else ())
        supports = [support for support, _, _ in self._held if _name(support) in names]
        self.stiffness.show_stiffness(stiffness_of(supports[0]) if supports else None)
        self.enable_changes(bool(names), bool(len(self.picks)))
        self._draw(RING)

    def _choose_mark(self, node):
        name = self._name_at(node)
        if name is not None:
            self.list.choose([name])
            self.list.setFocus()

    def _entry_at(self, node):
        """The entry of held_by_each() of what holds a node; the latest, for it was there last."""
        return next((each for each in reversed(self._held) if node in each[1]), None)

    def _name_at(self, node):
        entry = self._entry_at(node)
        return None if entry is None else _name(entry[0])

    def _hover(self, nodes, at):
        if at is not None:
            self._fit(at.screen())
        if tuple(nodes) == self._hovered:
            return
        self._hovered = tuple(nodes)
        entry = self._entry_at(nodes[0]) if len(nodes) else None
        shown, words = nodes, ""
        if entry is not None and self.tools.tool == OFF:
            shown = entry[1]
        if entry is not None:
            words = words_of(self._shell, entry[0], len(entry[1]))
        self.marks.hover(shown)
        self.list.mark(None if entry is None else _name(entry[0]))
        self._pointer.tip.say(self.tools, words, at)
        self._draw(HOVER)

    def _picked(self):
        self.marks.pick(self.picks.nodes)
        self._say_what_is_picked()
        self.enable_changes(bool(self.list.names()), bool(len(self.picks)))
        self._draw(DOT)

    def _say_what_is_picked(self):
        count, elements, chosen = len(self.picks), self.picks.elements, len(self.list.names())
        if not count and chosen:
            self.words.setText(
                translate("Chosen in the list: {}. Hold it in another way, soften or lift it.").format(chosen)
            )
        elif not count:
            self.words.setText(
                translate("Pick nodes in the 3D view with one of the tools, or choose a support.")
            )
        elif elements:
            self.words.setText(translate("Picked: {}, {} nodes").format(", ".join(elements), count))
        else:
            self.words.setText(translate("Nodes picked: {}").format(count))
        self.words.set_colour(None)

    def say_what_is_wrong(self, sentence):
        self.words.set_colour(WRONG)
        self.words.setText(f"{WRONG[0]} {sentence}")

    # Steps

    def do(self, change, merge=None):
        """Whether a step could be made of what change() does; if not, why not is said."""
        if self._shell.Net is None:
            self.say_what_is_wrong(translate("The gridshell has no Net any more."))
            return False
        try:
            self.steps.do(change, merge)
        except (ValueError, WrongSelection) as error:
            self.say_what_is_wrong(str(error))
            return False
        self._changed()
        return True

    def _changed(self):
        self.show_steps(self.steps)
        self._take_held(after_step=True)
        self._session.change()

    def forget_steps(self):
        """Others have changed the supports: what was done by hand before cannot be taken back by itself."""
        for name in set(self._hidden) - {support.Name for support in self._shell.Supports}:
            # Another may come to have its name.
            switch, was = self._hidden.pop(name)
            switch.whichChild = was
        self.steps = SupportSteps(self._shell, self._show_shape)
        self._kinds_before = {}
        self.show_steps(self.steps)

    def _back_or_on(self, can, do):
        can = can and self._shell.Net is not None
        if can:
            do()
            self._changed()
        return can

    def lay_down_tool(self):
        """Whether there was a tool to lay down."""
        if self.tools.tool == OFF:
            return False
        self.tools.use(OFF)
        return True

    # What the form's buttons do

    def use_tool(self, tool):
        self.tools.use(tool)

    def clear_picks(self):
        self.picks.clear()

    def choose_recipe(self, recipe):
        if recipe != self._shell.SupportRecipe:
            self.do(lambda: setattr(self._shell, "SupportRecipe", recipe))

    def undo(self):
        """Whether there was a step to take back."""
        return self._back_or_on(self.steps.can_undo, self.steps.undo)

    def redo(self):
        """Whether there was a step to make again."""
        return self._back_or_on(self.steps.can_redo, self.steps.redo)

    def hold(self, kind):
        """Hold in this way what is picked, else what is chosen in the list."""
        if self._net is None:
            return

        def change():
            values = {"Kind": kind}
            if kind in (LINE, PLANE):
                values["Direction"] = direction_of(self.direction.currentData(), self._shell)
            if len(self.picks):
                added.append(self.steps.add(self._net, **self.picks.where(self._shell.Net), **values))
                return
            for support in self._chosen_supports(added):
                for name, value in values.items():
                    setattr(support, name, value)
            held_by_each(self._shell, self._net)

        added = []
        if self.do(change) and added:
            self.picks.clear()
            self.list.choose([support.Name for support in added])

    def lift(self):
        """Free what is picked, else let go what is chosen in the list."""
        if len(self.picks):
            self.hold(FREE)
            return
        names = self.list.names()

        def change():
            for support in [each for each in self._shell.Supports if each.Name in names]:
                self.steps.lift(support)
            if "" in names:
                self._shell.SupportRecipe = "None"
                held_by_each(self._shell, self._net)

        self.do(change)

    def weaken(self, stiffness):
        """Give what is chosen this stiffness [N/m], NONE or RIGID."""

        def change():
            for support in self._chosen_supports(added):
                if stiffness == NONE:
                    self._kinds_before.setdefault(support.Name, support.Kind)
                    support.Kind = FREE
                    continue
                if support.Kind == FREE:
                    support.Kind = self._kinds_before.get(support.Name, FIXED)
                self._kinds_before.pop(support.Name, None)
                support.Stiffness = FreeCAD.Units.Quantity(
                    "0 N/m" if stiffness == RIGID else f"{stiffness!r} N/m"
                )

        added = []
        if self.do(change, merge="stiffness") and added:
            self.list.choose([support.Name for support in added])

    def end_weakening(self):
        self.steps.end_merging()

    def _raise(self, node, height):
        def change():
            for name, value in raised_of_net(self._shell.Net, [node], height / MILLIMETRE).items():
                setattr(self._shell.Net, name, value)

        self.do(change)

    def _chosen_supports(self, added):
        """The Supports that are chosen in the list; for the recipe a Support in its place, `added` too."""
        names = self.list.names()
        found = [support for support in self._shell.Supports if support.Name in names]
        if "" in names:
            recipe = self._shell.SupportRecipe
            where = {"Where": recipe}
            if recipe not in NODE_RECIPES or len(self._held) > 1:
                # Of the recipe's nodes only those of which no support speaks.
                where = at_nodes(self._shell.Net, self._held[0][1].tolist())
            added.append(self.steps.add(self._net, first=True, **where))
            found.append(added[-1])
        return found

    # The supports' own shapes, which are on the net as it was laid

    def _hide_shapes(self):
        for support in self._shell.Supports:
            if support.Name not in self._hidden and support.ViewObject is not None:
                switch = support.ViewObject.SwitchNode
                self._hidden[support.Name] = switch, switch.whichChild.getValue()
                switch.whichChild = coin.SO_SWITCH_NONE

    def _show_shape(self, support):
        switch, was = self._hidden.pop(support.Name, (None, None))
        if switch is not None:
            switch.whichChild = was


def _name(support):
    """By which the list knows a Support; None is the recipe."""
    return "" if support is None else support.Name
