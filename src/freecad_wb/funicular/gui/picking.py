# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is selected, as something that a net can be made on."""

import FreeCADGui

from funicular.gui.qt import translate


class WrongSelection(Exception):
    """What is selected does not say what to build on; the text says what to select instead."""


def selected_sources():
    """What is selected that a gridshell can be built on.

    Returns
    -------
    (faces, nets)
        `faces`: list of (root object, path of the face below it); an object picked as a whole counts with
        each of its faces. `nets`: list of Net objects.
    """
    faces, nets = [], []
    # 0: not resolved to the inner object, so that a face seen through a link or within a part is taken where
    # it is seen.
    for selected in FreeCADGui.Selection.getSelectionEx("", 0):
        root = selected.Object
        for path in selected.SubElementNames or ("",):
            obj = root.getSubObjectList(path)[-1]
            container, _, element = path.rpartition(".")
            if getattr(obj, "FunicularType", "") == "Net":
                nets.append(obj)
            elif element:
                faces += [(root, path)] if element.startswith("Face") else []
            elif not hasattr(obj, "FunicularType"):
                count = getattr(root.getSubObject(path), "countElement", lambda kind: 0)("Face")
                faces += [(root, f"{path}Face{index + 1}") for index in range(count)]
    return faces, nets


def selected_gridshells():
    """The Gridshells that are selected, as a whole or by their members; each once."""
    shells = []
    for selected in FreeCADGui.Selection.getSelectionEx("", 0):
        for path in selected.SubElementNames or ("",):
            obj = selected.Object.getSubObjectList(path)[-1]
            if getattr(obj, "FunicularType", "") == "Gridshell" and obj not in shells:
                shells.append(obj)
    return shells


def the_gridshell():
    """The one Gridshell that is selected. Raises WrongSelection unless there is exactly one."""
    shells = selected_gridshells()
    if len(shells) != 1:
        raise WrongSelection(
            translate(
                "{} gridshells are selected, and a covering lies on one. "
                "Select a single Gridshell in the tree, then run Covering again."
            ).format(len(shells))
        )
    return shells[0]


def the_source():
    """The one thing that is selected: ((root object, [path of the face]), None) or (None, net).

    Raises WrongSelection when nothing fits, or more than one thing does.
    """
    faces, nets = selected_sources()
    if not faces and not nets:
        raise WrongSelection(
            translate(
                "Nothing to build on is selected. Select one face in the 3D view, then run Gridshell again."
            )
        )
    if len(faces) + len(nets) > 1:
        raise WrongSelection(
            translate(
                "{} faces or nets are selected, and a gridshell stands on one. "
                "Select a single face in the 3D view, then run Gridshell again."
            ).format(len(faces) + len(nets))
        )
    if nets:
        return None, nets[0]
    root, path = faces[0]
    return (root, [path]), None


def the_face():
    """The one face that is selected, as a Net's Source takes it: (root object, [path of the face]).

    Raises WrongSelection unless there is exactly one.
    """
    faces, _ = selected_sources()
    if len(faces) != 1:
        raise WrongSelection(
            translate("{} faces are selected: select a single one in the 3D view, then press again.").format(
                len(faces)
            )
        )
    root, path = faces[0]
    return root, [path]


def clicked_object(source):
    """The object that shows what a Net's Source names, to be hidden or shown; None without a source.

    Below a link it is the link: what lies further down is shown elsewhere too.
    """
    if not source:
        return None
    root, paths = source
    chain = root.getSubObjectList(paths[0] if paths else "") or [root]
    return next((obj for obj in chain if obj.TypeId.startswith("App::Link")), chain[-1])
