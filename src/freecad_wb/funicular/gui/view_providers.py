# SPDX-License-Identifier: LGPL-2.1-or-later
"""How our objects stand in the tree and in the 3D view. Class names are saved in users' files."""

import FreeCAD
import FreeCADGui
import numpy as np

from funicular.features.form_of import form_of
from funicular.features.net import positions_of
from funicular.features.section import SECTION_PROPERTIES
from funicular.gui import legend, solving
from funicular.gui.colouring import NAMES as COLOURING
from funicular.gui.colouring import Coloured, add_colouring, colouring_of, is_complete, migrate_colouring
from funicular.gui.drawing.load_arrows import LONGEST, LoadArrows
from funicular.gui.drawing.reaction_arrows import ReactionArrows
from funicular.gui.drawing.look import NAMES as LOOK
from funicular.gui.drawing.look import add_look, exaggeration_of, look_of
from funicular.gui.drawing.net_drawing import NetDrawing
from funicular.gui.drawing.shapes import MILLIMETRES, longest_side
from funicular.gui.drawing.surfaces import TIMBER
from funicular.gui.icons import icon
from funicular.gui.picking import clicked_object

# What colours and legend go by: of the results those that are written last, after the shape, which resets
# FreeCAD's own line colours.
COLOURING_DATA = ("TensionMembers", "SlackMembers", "Label", *(each.name for each in SECTION_PROPERTIES))
LINE_WIDTH = 3.0

# Through a covering the members are seen.
TRANSPARENCY = 30


class ViewProvider:
    """What all have in common: nothing is kept beside the properties, so nothing is saved with the proxy."""

    icon_name = ""

    def __init__(self, vobj):
        # FreeCAD calls attach() only for the first proxy that an object gets.
        self.vobj = vobj
        self.add_properties(vobj)
        vobj.Proxy = self

    def add_properties(self, vobj):
        """Add the view properties that are not there yet, as in files of an older version."""

    def attach(self, vobj):
        self.vobj = vobj
        self.add_properties(vobj)

    def migrate(self, vobj):
        """Take over what a file of an older version says, once all of it is read."""

    def refresh(self, vobj):
        """Bring what is shown beside the shape up to the object's results; here there is nothing."""

    def getIcon(self):
        return icon(self.icon_name)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    # The names of the same two in FreeCAD 0.20.
    __getstate__ = dumps

    def __setstate__(self, state):
        return None


class ViewProviderNet(ViewProvider):
    """A net before relaxation; as FreeCAD's Part features do, it holds its source in the tree."""

    icon_name = "Funicular_Net"

    def claimChildren(self):
        # What is in a part or a body is the part's or the body's child.
        source = self._source()
        return [source] if source and source == self.vobj.Object.Source[0] else []

    def _source(self):
        """The object that shows the face that the net lies on."""
        return clicked_object(self.vobj.Object.Source)

    def doubleClicked(self, vobj):
        """The steps of a net are edited in the panel of the gridshell that it carries."""
        shells = [user for user in vobj.Object.InList if getattr(user, "FunicularType", "") == "Gridshell"]
        return shells[0].ViewObject.Proxy.doubleClicked(shells[0].ViewObject) if shells else False

    def onDelete(self, vobj, subelements):
        _show_unless_shared(self._source(), vobj.Object)
        return True


class ViewProviderSupport(ViewProvider):
    """The nodes that are held, as points larger than those of the net."""

    icon_name = "Funicular_Support"

    def __init__(self, vobj):
        super().__init__(vobj)
        vobj.PointSize = 9.0
        vobj.PointColor = (0.75, 0.2, 0.1)


class ViewProviderPointLoad(ViewProvider):
    """Arrows whose tips are on the nodes that bear the load, as the relaxed gridshell stands."""

    icon_name = "Funicular_PointLoad"
    ARROWS = "Arrows"

    _arrows = None
    # Whether the panel of its gridshell says where they are.
    is_led = False

    def __init__(self, vobj):
        super().__init__(vobj)
        self._hang(vobj)
        modes = vobj.getEnumerationsOfProperty("DisplayMode")
        if self.ARROWS not in modes:
            # FreeCAD asks the first proxy alone, and a file that was saved without a window has had none.
            vobj.DisplayMode = [*modes, self.ARROWS]
        vobj.DisplayMode = self.ARROWS

    def attach(self, vobj):
        super().attach(vobj)
        self._hang(vobj)

    def _hang(self, vobj):
        if self._arrows is None:
            self._arrows = LoadArrows()
            vobj.addDisplayMode(self._arrows.root, self.ARROWS)

    def getDisplayModes(self, vobj):
        return [self.ARROWS]

    def getDefaultDisplayMode(self):
        return self.ARROWS

    def setDisplayMode(self, mode):
        return mode

    def updateData(self, obj, prop):
        if prop in ("LoadedNodes", "Force", "Direction"):
            self.refresh(obj.ViewObject)

    def refresh(self, vobj):
        """Draw it on the last result of its gridshell; before there is one, on the net."""
        load = vobj.Object
        # Properties arrive one at a time while a file is restored.
        is_complete = all(name in load.PropertiesList for name in ("LoadedNodes", "Force", "Direction"))
        if self.is_led or not is_complete or load.Net is None:
            return
        shells = [user for user in load.InList if getattr(user, "FunicularType", "") == "Gridshell"]
        beside = [load, *(each for shell in shells for each in shell.PointLoads)]
        largest = max(each.Force.Value for each in beside)
        for shell in shells:
            form = form_of(shell, exaggeration_of(shell.ViewObject))
            if form is not None and len(form.nodes) == load.Net.NodeCount:
                nodes, place = form.drawn_nodes * MILLIMETRES, shell.Placement
                break
        else:
            nodes, place = positions_of(load.Net), FreeCAD.Placement()
        loaded = np.asarray(load.LoadedNodes, dtype=int)
        self.show(nodes[loaded[loaded < len(nodes)]], place, longest_side(nodes), largest)

    def show(self, points, place, size, largest):
        """Draw it at other points (k, 3) [mm].

        place: Placement of the points. size: of what bears it [mm]. largest: of all forces that are shown
        beside it, in FreeCAD's own unit.
        """
        load = self.vobj.Object
        length = LONGEST * size * load.Force.Value / largest if largest > 0.0 else 0.0
        matrix = np.array(load.Placement.inverse().multiply(place).toMatrix().A).reshape(4, 4)
        points = points @ matrix[:3, :3].T + matrix[:3, 3]
        direction = matrix[:3, :3] @ tuple(load.Direction)
        self._arrows.show(points, direction, length, load.Force.UserString)


class ViewProviderGridshell(ViewProvider):
    """A relaxed gridshell: members coloured by force, with a legend; a double click opens its panel."""

    icon_name = "Funicular_Gridshell"

    # While the panel is open, and on the way to it.
    _panel = None
    _transaction = None
    # What is drawn of the results beside the shape, None where nothing is asked for.
    _drawing = None
    # The Form that is shown, its colouring.Coloured, and the arrows beside it.
    _form = coloured = None
    _reactions = None

    def __init__(self, vobj):
        super().__init__(vobj)
        vobj.LineWidth = LINE_WIDTH

    def add_properties(self, vobj):
        add_colouring(vobj)
        add_look(vobj, "Gridshell")

    def migrate(self, vobj):
        migrate_colouring(vobj)

    def claimChildren(self):
        obj = self.vobj.Object
        return [*([obj.Net] if obj.Net else []), *obj.Supports, *obj.PointLoads]

    def updateData(self, obj, prop):
        if prop in COLOURING_DATA:
            self.refresh(obj.ViewObject)
        if prop == "Placement" or (prop in COLOURING_DATA and self._panel is None):
            self.draw(obj.ViewObject)
        if prop in ("Placement", "PointLoads"):
            refresh_loads(obj)

    def onChanged(self, vobj, prop):
        of_colours = prop in COLOURING or prop in ("Visibility", "LineColor", "Exaggeration")
        if of_colours:
            self.refresh(vobj)
        if (prop in LOOK or prop == "LineWidth" or of_colours) and not (of_colours and self._panel):
            self.draw(vobj)

    def refresh(self, vobj):
        """Colours, legend and arrows of the document's results; while the panel is open, of what it shows."""
        if not is_complete(vobj):
            return
        if self._panel is not None:
            self._panel.session.show_again()
            self.refresh_legend(vobj)
            return
        refresh_loads(vobj.Object)
        form = form_of(vobj.Object, exaggeration_of(vobj))
        if form is None:
            self.coloured = self._form = None
            self._show_reactions(vobj, None)
            legend.hide(vobj.Object)
            return
        # FreeCAD keeps the old array when the number of members changes, so it is set after each recompute.
        vobj.LineColorArray = self.colour(vobj, form).colours(vobj.LineColor)
        self.refresh_legend(vobj)

    def colour(self, vobj, form):
        """The Coloured of a form that is shown from now on, its reactions as arrows if they are wanted."""
        colouring = colouring_of(vobj)
        if self.coloured is None or not self.coloured.holds_for(form, colouring):
            self.coloured = Coloured(form, colouring)
        self._form = form
        self._show_reactions(vobj, form if vobj.ShowReactions and vobj.Visibility else None)
        return self.coloured

    def refresh_legend(self, vobj):
        """Bring the legend up to what is shown; this takes longer than a frame has."""
        wanted = self.coloured is not None and self.coloured.colouring.quantity is not None
        if wanted and vobj.ShowLegend and vobj.Visibility:
            legend.show(vobj.Object)
        else:
            legend.hide(vobj.Object)

    def _show_reactions(self, vobj, form):
        if form is None:
            arrows, self._reactions = self._reactions, None
            if arrows is not None:
                arrows.remove()
            return
        if self._reactions is None:
            self._reactions = ReactionArrows(vobj)
        self._reactions.show(form)

    def draw(self, vobj):
        """Draw what the view properties ask for beyond the shape; in the panel its session does."""
        if self._panel is not None:
            self._panel.session.show_again()
            return
        if self._form is None or not vobj.Visibility or look_of(vobj).is_plain:
            self.draw_nothing()
            return
        if self._drawing is None:
            self._drawing = NetDrawing(vobj, instead=False)
        self._drawing.show(self._form, self.coloured)
        self._drawing.rest(at_once=True)

    def draw_nothing(self):
        """Leave the gridshell to its shape, or to the panel."""
        drawing, self._drawing = self._drawing, None
        if drawing is not None:
            drawing.remove()

    def onDelete(self, vobj, subelements):
        legend.hide(vobj.Object)
        _show_unless_shared(vobj.Object.Net, vobj.Object)
        return True

    def doubleClicked(self, vobj):
        # A panel that is open keeps the window; FreeCAD would end its edit mode for ours.
        if not FreeCADGui.Control.activeDialog():
            self.edit(vobj)
        return True

    def edit(self, vobj, transaction=None):
        """Open the panel.

        transaction: id of the one that the caller has just opened for what the panel is to finish; without it
        the panel opens its own.
        """
        self._transaction = transaction
        FreeCADGui.getDocument(vobj.Object.Document.Name).setEdit(vobj.Object.Name)

    def fit_at_rest(self):
        """Let the panel that is open show all of the form once it has settled."""
        if self._panel is not None:
            self._panel.fit_at_rest()

    def setEdit(self, vobj, mode=0):
        if mode != 0:
            return None
        from funicular.gui import task_panel

        transaction, self._transaction = self._transaction, None
        self.draw_nothing()
        self._panel = task_panel.edit(vobj.Object, transaction)
        if self._panel is None:
            self.draw(vobj)
        return self._panel is not None

    def unsetEdit(self, vobj, mode=0):
        if mode != 0:
            return None
        panel, self._panel = self._panel, None
        # OK and Cancel have finished the panel by now; Esc in the 3D view has not.
        panel.dismiss()
        try:
            self.refresh(vobj)
            self.draw(vobj)
        except ReferenceError:
            pass  # the gridshell was made for this panel and went with it, or the whole document did
        return True


class ViewProviderCovering(ViewProvider):
    """The panels of a gridshell, which stays in sight below them, and in the tree beside them."""

    icon_name = "Funicular_Covering"

    def __init__(self, vobj):
        super().__init__(vobj)
        vobj.ShapeColor = TIMBER
        vobj.Transparency = TRANSPARENCY
        # Lines of its own would lie on the members and hide the colours of their forces.
        vobj.DisplayMode = "Shaded"


VIEW_PROVIDERS = {
    "Net": ViewProviderNet,
    "Gridshell": ViewProviderGridshell,
    "Support": ViewProviderSupport,
    "PointLoad": ViewProviderPointLoad,
    "Covering": ViewProviderCovering,
}


def _show_unless_shared(child, obj):
    """Show what stood aside for `obj`, which goes, unless it stands aside for another of the kind too."""
    if child and not any(
        user != obj and getattr(user, "FunicularType", "") == obj.FunicularType for user in child.InList
    ):
        child.Visibility = True


def refresh_loads(shell):
    """Bring the arrows of a gridshell's loads to where it now is."""
    for load in getattr(shell, "PointLoads", ()):
        # While a file is restored, some have no proxy yet.
        if isinstance(load.ViewObject.Proxy, ViewProviderPointLoad):
            load.ViewObject.Proxy.refresh(load.ViewObject)


def attach_view_provider(obj):
    """Give `obj` the view provider of its kind if it has none, as in a file that was saved without a window.

    obj: a document object whose FunicularType is a key of VIEW_PROVIDERS.
    """
    vobj = obj.ViewObject
    kind = VIEW_PROVIDERS[obj.FunicularType]
    if not isinstance(vobj.Proxy, kind):
        kind(vobj).refresh(vobj)
    vobj.Proxy.migrate(vobj)


class DocumentObserver:
    """What FreeCAD tells no view provider: removal by a script, and what undo and redo take or bring back."""

    def slotDeletedObject(self, obj):
        if getattr(obj, "FunicularType", "") == "Gridshell":
            legend.hide(obj)

    def slotUndoDocument(self, document):
        _refresh_gridshells(document)

    def slotRedoDocument(self, document):
        _refresh_gridshells(document)

    def slotFinishRestoreDocument(self, document):
        _refresh_gridshells(document)


def _refresh_gridshells(document):
    for obj in document.Objects:
        if getattr(obj, "FunicularType", "") == "Gridshell":
            attach_view_provider(obj)
            obj.ViewObject.Proxy.refresh(obj.ViewObject)
            obj.ViewObject.Proxy.draw(obj.ViewObject)


FreeCAD.addDocumentObserver(DocumentObserver())
solving.install()
