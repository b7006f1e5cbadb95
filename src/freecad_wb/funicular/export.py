# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found, for other programs: mesh files, tables, pictures. FreeCAD's File > Export calls `export`.

Files are in metres and newtons and hold the gridshell as it stands in the document, with its Placement.
"""

import csv
import os

import numpy as np

import funicular as fn

from .features.covering import gridshell_of
from .features.feature import MARKER
from .features.gridshell import refuse_tilt, scene_of, solver_options
from .features.net import panels_of, to_vectors
from .files import write_mesh
from .panels import triangles


def lattice_of(shell):
    """(nodes, members, panels) of a Gridshell as it stands in the document.

    nodes: (n, 3) [m]; members: (m, 2) node numbers; panels: node numbers around each.
    Raises InvalidInput if the gridshell has no result, or none of its present input, or stands at a tilt.
    """
    if getattr(shell, MARKER, "") != "Gridshell":
        raise fn.InvalidInput(f"{getattr(shell, 'Label', shell)} is no Gridshell: give one")
    if shell.Status not in ("", "converged"):
        raise fn.InvalidInput(f"{shell.Label} has no result: {shell.Summary}")
    if not shell.Status or any(
        "Touched" in obj.State or not obj.isValid()
        for obj in (shell, shell.Net, *shell.Supports, *shell.PointLoads)
    ):
        raise fn.InvalidInput(f"{shell.Label} has no result for its net as it is now: recompute it first")
    refuse_tilt(shell)
    place = shell.getGlobalPlacement().Matrix
    nodes = np.array([tuple(place.multVec(node)) for node in shell.NodePositions]) * 1e-3
    return nodes, np.array(shell.Members).reshape(-1, 2), panels_of(shell.Panels)


def covering_of(obj):
    """(nodes, panels) of a Covering, or of all panels of a Gridshell, as they stand in the document.

    nodes: (n, 3) [m], those of the gridshell, and behind them the middles of panels that the Covering cuts
    into triangles; panels: node numbers around each. Raises InvalidInput as lattice_of does, for a Covering
    that is not up to date, for a Gridshell without panels and for any other object.
    """
    kind = getattr(obj, MARKER, "")
    if kind not in ("Covering", "Gridshell"):
        raise fn.InvalidInput(
            f"{getattr(obj, 'Label', repr(obj))} is neither a Covering nor a Gridshell: give one of them"
        )
    shell = gridshell_of(obj) if kind == "Covering" else obj
    nodes, _, panels = lattice_of(shell)
    if not panels:
        raise fn.InvalidInput(f"{shell.Label} has no panels: export its members instead, as .obj or .ply")
    if kind == "Gridshell":
        return nodes, panels
    if "Touched" in obj.State or not obj.isValid():
        raise fn.InvalidInput(f"{obj.Label} is not that of {shell.Label} as it is now: recompute it first")
    return triangles(nodes, panels) if obj.Kind == "Triangles" else (nodes, panels)


def mesh_of_covering(obj):
    """Mesh.Mesh [mm] of a Covering, or of all panels of a Gridshell, as they stand in the document.

    Panels of more than three corners are cut into triangles about the mean of their corners, so that the
    mesh has no gaps and the Area of the Covering. `Mesh.show(mesh_of_covering(covering))` puts it into the
    document. FreeCAD keeps a mesh's points in single precision. Raises InvalidInput as covering_of does.
    """
    import Mesh

    points, cut = triangles(*covering_of(obj))
    mesh = Mesh.Mesh()
    # Of numbers instead of vectors FreeCAD 0.20 dies.
    mesh.addFacets((to_vectors(points * 1e3), cut))
    return mesh


def export_gridshell(shell, path):
    """Write the relaxed lattice to a mesh file in metres; the suffix of the path chooses the format.

    .obj and .ply hold nodes, members and panels; .stl and .off hold panels. Raises InvalidInput if there is
    no result, ValueError for another suffix, OSError if the file cannot be written.
    """
    write_mesh(path, *lattice_of(shell))


def export_covering(obj, path):
    """Write the panels of a Covering, or of a Gridshell, to an .obj, .ply, .stl or .off file in metres.

    Nodes keep the gridshell's numbers but in .stl, which has none. A Covering of Kind Triangles is written
    as triangles. Raises InvalidInput as covering_of does, ValueError for another suffix, OSError if the file
    cannot be written.
    """
    nodes, panels = covering_of(obj)
    write_mesh(path, nodes, [], panels)


def export_tables(shell, stem):
    """Write members and nodes of a Gridshell as two CSV files and return their paths.

    `<stem>-members.csv`: member, its two nodes, length and source length, the one before relaxation [m],
    force [N] (compression negative), slack or not; `<stem>-nodes.csv`: node, position [m], support or not,
    reaction [N]. A member's rest length is its source length, unless lengths were matched. Numbers count
    from 0 and are written so that reading gives the same floats; units stand in the first row. Raises
    InvalidInput as lattice_of does, OSError if a file cannot be written.
    """
    nodes, members, _ = lattice_of(shell)
    scene = scene_of(shell)
    if not np.array_equal(scene.net.members, members):
        raise fn.InvalidInput(f"{shell.Label} has no result for its net as it is now: recompute it first")
    lengths = np.linalg.norm(nodes[members[:, 1]] - nodes[members[:, 0]], axis=1)
    slack = set(shell.SlackMembers)
    # A slack member's zero may have a sign, which means nothing.
    forces = [force + 0.0 for force in shell.MemberForces]
    turn = shell.getGlobalPlacement().Rotation
    reactions = [tuple(turn.multVec(reaction)) for reaction in shell.Reactions]
    supported = {int(node) for support in scene.supports for node in support.ids}

    of_members = [("member", "node a", "node b", "length [m]", "source length [m]", "force [N]", "slack")]
    columns = members.tolist(), lengths.tolist(), scene.net.source_lengths.tolist(), forces
    for member, ((a, b), length, source_length, force) in enumerate(zip(*columns)):
        of_members.append((member, a, b, length, source_length, force, _yes_or_no(member in slack)))
    of_nodes = [("node", "x [m]", "y [m]", "z [m]", "support")]
    of_nodes[0] += tuple(f"reaction {axis} [N]" for axis in "xyz")
    for node, (position, reaction) in enumerate(zip(nodes.tolist(), reactions)):
        of_nodes.append((node, *position, _yes_or_no(node in supported), *reaction))

    paths = f"{os.fspath(stem)}-members.csv", f"{os.fspath(stem)}-nodes.csv"
    for path, rows in zip(paths, (of_members, of_nodes)):
        with open(path, "w", newline="", encoding="utf-8") as file:
            # The csv module writes a float by its repr.
            csv.writer(file).writerows(rows)
    return paths


def _yes_or_no(value):
    return "yes" if value else "no"


def to_be_studied(shell):
    """(scene, options) with which fn.accuracy_study measures a Gridshell as its properties are now.

    options: accuracies, the gridshell's own among them, and max_seconds, its MaxSeconds. LengthMatching plays
    no part: lengths are those on the source. Raises InvalidInput for what is no Gridshell, for properties
    that describe no scene, and where its Net, a Support or a PointLoad has yet to be recomputed.
    """
    from .accuracy import ACCURACIES

    if getattr(shell, MARKER, "") != "Gridshell":
        raise fn.InvalidInput(f"{getattr(shell, 'Label', repr(shell))} is no Gridshell: give one")
    own = solver_options(shell)
    for obj in (shell.Net, *shell.Supports, *shell.PointLoads):
        if obj is not None and not obj.isValid():
            raise fn.InvalidInput(obj.getStatusString())
        if obj is not None and "Touched" in obj.State:
            raise fn.InvalidInput(f"{obj.Label} has changed since it was computed: recompute it first")
    # Millimetres turned into metres may miss the same length by a rounding.
    others = [accuracy for accuracy in ACCURACIES if not np.isclose(accuracy, own["accuracy"], 1e-9, 0.0)]
    return scene_of(shell), {"accuracies": [*others, own["accuracy"]], "max_seconds": own["max_seconds"]}


def study_accuracy(shell, stem, **options):
    """Measure what accuracy costs a Gridshell; write `<stem>.csv` and `<stem>.png`, and return the Study.

    The picture marks the gridshell's own Accuracy and Method. options: those of fn.accuracy_study, such as
    accuracies [m] and methods, in place of what to_be_studied() gives. Raises InvalidInput as that does and
    where there is no equilibrium to measure against, OSError if a file cannot be written.
    """
    scene, of_shell = to_be_studied(shell)
    study = fn.accuracy_study(scene, **{**of_shell, **options})
    study.write(f"{os.fspath(stem)}.csv")
    own = solver_options(shell)
    study.plot(f"{os.fspath(stem)}.png", chosen=own["accuracy"], method=own["method"])
    return study


def export(objects, filename):
    """Write the one Gridshell or Covering among objects, as FreeCAD's File > Export asks for it.

    A Gridshell goes to a mesh file (export_gridshell) or, for a name that ends in .csv, to the two tables of
    export_tables, named after it; a Covering to a mesh file (export_covering). Raises InvalidInput, naming
    the object, for any other and for more than one, and as those functions do.
    """
    stem, suffix = os.path.splitext(filename)
    name = os.path.basename(filename)
    for obj in objects:
        if getattr(obj, MARKER, "") not in ("Gridshell", "Covering"):
            raise fn.InvalidInput(
                f"{obj.Label} is neither a Gridshell nor a Covering, so {name} was not written: select one "
                "of them, or choose another file type"
            )
    if len(objects) != 1:
        labels = ", ".join(obj.Label for obj in objects) or "nothing"
        raise fn.InvalidInput(
            f"{name} takes one Gridshell or Covering, but {labels} is selected: export them one by one"
        )
    obj = objects[0]
    covering = getattr(obj, MARKER) == "Covering"
    if suffix.lower() == ".csv":
        if covering:
            raise fn.InvalidInput(f"{obj.Label} has no members that {name} could list: select its Gridshell")
        export_tables(obj, stem)
    elif covering:
        export_covering(obj, filename)
    else:
        export_gridshell(obj, filename)
