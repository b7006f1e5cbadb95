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
        `faces`: list of (root object, path of the face below it); the path of an object picked as a whole
        ends with a dot or is empty. `nets`: list of Net objects.
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
            elif not hasattr(obj, "FunicularType") and _can_carry_a_net(root, path, obj):
                faces.append((root, path))
    return faces, nets


def _can_carry_a_net(root, path, obj):
    """Whether a whole object has faces, or is a mesh, or nothing but edges as a sketch."""
    if obj.isDerivedFrom("Mesh::Feature"):
        return True
    shape = root.getSubObject(path)
    return hasattr(shape, "countElement") and bool(shape.countElement("Face") or shape.countElement("Edge"))


def picks_of(shell):
    """What is selected to say where a gridshell shall be held.

    Returns
    -------
    (elements, points)
        `elements`: names of edges and vertices of the source of its net, ["Edge3"]. `points`: App.Vector,
        where its own nodes were clicked.
    """
    elements, points = [], []
    source, paths = shell.Net.Source if shell.Net and shell.Net.Source else (None, ("",))
    body = paths[0].rpartition(".")[0] if paths else ""
    for selected in FreeCADGui.Selection.getSelectionEx("", 0):
        for path in selected.SubElementNames:
            obj = selected.Object.getSubObjectList(path)[-1]
            container, _, element = path.rpartition(".")
            if obj == shell and element.startswith("Vertex"):
                points.append(selected.Object.getSubObject(path).Point)
            elif element.startswith(("Edge", "Vertex")) and obj != shell:
                if (selected.Object, container) != (source, body):
                    raise WrongSelection(
                        translate("{} of {} is not what the net lies on: select edges of its source.").format(
                            element, obj.Label
                        )
                    )
                elements.append(element)
    if elements and points:
        raise WrongSelection(
            translate(
                "Select either nodes of the gridshell or edges of its source, and make one support of each."
            )
        )
    return elements, points


def picked_parts():
    """(gridshell, members, panels, points) of what is selected of one gridshell and of its coverings.

    members, panels: their numbers. points: App.Vector, where nodes were clicked. Raises WrongSelection for
    parts of several gridshells, or none.
    """
    from funicular.features.picked_edits import panels_of_faces

    shells, members, panels, points = [], [], [], []
    for selected in FreeCADGui.Selection.getSelectionEx("", 0):
        for path in selected.SubElementNames:
            obj = selected.Object.getSubObjectList(path)[-1]
            element = path.rpartition(".")[2]
            kind = getattr(obj, "FunicularType", "")
            shell = obj.Gridshell if kind == "Covering" else obj
            if kind not in ("Covering", "Gridshell") or shell is None:
                continue
            shells += [] if shell in shells else [shell]
            if kind == "Covering" and element.startswith("Face"):
                panels += panels_of_faces(obj, [int(element[4:])])
            elif kind == "Gridshell" and element.startswith("Edge"):
                members.append(int(element[4:]) - 1)
            elif kind == "Gridshell" and element.startswith("Vertex"):
                points.append(selected.Object.getSubObject(path).Point)
    if len(shells) != 1:
        raise WrongSelection(
            translate(
                "Parts of {} gridshells are selected: select nodes or members of one in the 3D view."
            ).format(len(shells))
        )
    return shells[0], sorted(set(members)), sorted(set(panels)), points


def _face_count(root, path):
    return getattr(root.getSubObject(path), "countElement", lambda kind: 0)("Face")


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
                "{} gridshells are selected, and this is done for one. "
                "Select a single Gridshell in the tree, then run the command again."
            ).format(len(shells))
        )
    return shells[0]


def _refuse_whole_solids(faces):
    """A shell is laid out as it is; of a solid nobody means the bottom too."""
    for root, path in faces:
        if not path.rpartition(".")[2] and _face_count(root, path) > 1 and root.getSubObject(path).Solids:
            raise WrongSelection(
                translate(
                    "{} is selected as a whole, with {} faces: select those that the gridshell shall follow, "
                    "in the 3D view."
                ).format(root.getSubObjectList(path)[-1].Label, _face_count(root, path))
            )


def the_source():
    """What is selected to build on: ((root object, [paths of faces of one body]), None) or (None, net).

    Raises WrongSelection when nothing fits, or more than one net or body does.
    """
    faces, nets = selected_sources()
    if not faces and not nets:
        raise WrongSelection(
            translate(
                "Nothing to build on is selected. Select a face in the 3D view, or several of one body, "
                "then run Gridshell again."
            )
        )
    if bodies_of(faces) + len(nets) > 1:
        raise WrongSelection(
            translate(
                "{} bodies or nets are selected, and a gridshell stands on one. "
                "Select faces of a single body in the 3D view, then run Gridshell again."
            ).format(bodies_of(faces) + len(nets))
        )
    if nets:
        return None, nets[0]
    _refuse_whole_solids(faces)
    return (faces[0][0], [path for _, path in faces]), None


def bodies_of(faces):
    """How many bodies the faces of selected_sources() belong to."""
    return len({(root.Name, path.rpartition(".")[0]) for root, path in faces})


def the_faces():
    """The faces that are selected, as a Net's Source takes them: (root object, [paths of faces]).

    Raises WrongSelection unless they are faces of one body.
    """
    faces, _ = selected_sources()
    if bodies_of(faces) != 1:
        raise WrongSelection(
            translate(
                "Faces of {} bodies are selected: select one or more of a single body in the 3D view, then "
                "press again."
            ).format(bodies_of(faces))
        )
    _refuse_whole_solids(faces)
    return faces[0][0], [path for _, path in faces]


def clicked_object(source):
    """The object that shows what a Net's Source names, to be hidden or shown; None without a source.

    Below a link it is the link: what lies further down is shown elsewhere too.
    """
    if not source:
        return None
    root, paths = source
    chain = root.getSubObjectList(paths[0] if paths else "") or [root]
    return next((obj for obj in chain if obj.TypeId.startswith("App::Link")), chain[-1])


def is_mesh_source(net):
    """Whether a Net lies on a mesh object."""
    obj = _inner_source(net)
    return obj is not None and obj.isDerivedFrom("Mesh::Feature")


def are_edges_source(net):
    """Whether a Net lies on edges: some that are named, or all of an object without faces."""
    obj = _inner_source(net)
    if obj is None or is_mesh_source(net):
        return False
    paths = [path for path in net.Source[1] if path.rpartition(".")[2]]
    if paths:
        return paths[0].rpartition(".")[2].startswith("Edge")
    shape = net.Source[0].getSubObject(net.Source[1][0] if net.Source[1] else "")
    return (
        hasattr(shape, "countElement") and not shape.countElement("Face") and bool(shape.countElement("Edge"))
    )


def _inner_source(net):
    """The object that a Net's Source names, below links; None without one."""
    if net is None or not net.Source:
        return None
    root, paths = net.Source
    return (root.getSubObjectList(paths[0] if paths else "") or [root])[-1].getLinkedObject(True)
