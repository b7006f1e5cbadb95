# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Gridshell in the document: a Net, its loads and supports; its shape is the relaxed lattice."""

import FreeCAD as App
import numpy as np

import funicular as fn

from .feature import Feature, Property, amount, checked, reason
from .net import edges_of, flat_panels, net_of, panels_of, to_vectors
from .progress import Progress
from .result_words import complaint, sentence_of
from .section import SECTION_PROPERTIES
from .support import RECIPES, supports_of_gridshell

SHARES = ("Angle", "Equal", "Voronoi")
METHODS = ("Auto", "Newton", "Relaxation")

# FreeCAD's internal units are mm, kg and s: the factors to SI.
METRES = 1e-3
GRAVITY = 9.80665
NEWTONS = 1e-3

# How far a placement may turn the vertical, in radians: more than rounding, less than can be set.
UPRIGHT = 1e-9


def _result(kind, name, tooltip):
    return Property(kind, name, "Results", tooltip, mode=("ReadOnly",))


class Gridshell(Feature):
    """Proxy of a Gridshell: solves the scene that its properties describe and writes what was found.

    Positions are in mm and in the numbering of the net, forces in N and of the built structure; both are
    given as they are before the gridshell's own Placement.
    """

    TYPE = "Gridshell"
    PROPERTIES = (
        Property(
            "App::PropertyLink", "Net", "Net", "The net that is relaxed; several gridshells may share one"
        ),
        Property(
            "App::PropertyQuantity",
            "MemberWeight",
            "Weights",
            "Weight of the members per length; 0 for none",
            "12 kg/m",
            unit="kg/m",
        ),
        Property(
            "App::PropertyQuantity",
            "CoveringWeight",
            "Weights",
            "Weight of the covering per area; 0 for none",
            "30 kg/m^2",
            unit="kg/m^2",
        ),
        Property(
            "App::PropertyEnumeration",
            "CoveringShare",
            "Weights",
            "How a panel's weight goes to its corners: by their angles, equally, by the area nearest to each",
            "Angle",
            SHARES,
        ),
        Property(
            "App::PropertyPressure", "Snow", "Weights", "Snow load on plan; 0 for none", 0.0, unit="N/m^2"
        ),
        Property(
            "App::PropertyForce",
            "AxialStiffness",
            "Stiffness",
            "EA of the members, the force that would double their length: the lower, the higher the shell",
            "100 kN",
            unit="N",
        ),
        Property(
            "App::PropertyBool",
            "AllowTension",
            "Stiffness",
            "Let members carry tension too; otherwise those that would go slack",
            False,
        ),
        Property(
            "App::PropertyEnumeration",
            "SupportRecipe",
            "Supports",
            "Where the shell stands",
            "Boundary",
            RECIPES,
        ),
        Property(
            "App::PropertyLinkList",
            "Supports",
            "Supports",
            "Supports of their own, besides those of the recipe",
        ),
        Property(
            "App::PropertyLength",
            "Accuracy",
            "Solution",
            "How far from equilibrium the nodes may lie",
            "1 mm",
            unit="mm",
        ),
        Property(
            "App::PropertyEnumeration",
            "Method",
            "Solution",
            "Newton is fast; relaxation is the method of Brivio et al. (2009); auto chooses",
            "Auto",
            METHODS,
        ),
        Property(
            "App::PropertyFloat", "MaxSeconds", "Solution", "Give up after this time; 0 for never", 60.0
        ),
        Property(
            "App::PropertyInteger",
            "LengthMatching",
            "Solution",
            "Rounds that bring the members back to their lengths on the source; 0 for none",
            0,
        ),
        *SECTION_PROPERTIES,
        Property(
            "App::PropertyStringList",
            "Variants",
            "Variants",
            "What was kept of this gridshell under a name, see funicular.features.variants",
            mode=("Hidden",),
            is_input=False,
        ),
        _result(
            "App::PropertyString",
            "Status",
            "How the last recompute ended: converged; failed; or the limit that the solver met",
        ),
        _result("App::PropertyString", "Summary", "The result in a sentence"),
        _result("App::PropertyString", "MethodUsed", "The method that found the result"),
        _result(
            "App::PropertyVectorList", "NodePositions", "Relaxed position of each node [mm], before Placement"
        ),
        Property(
            "App::PropertyIntegerList",
            "Members",
            "Results",
            "The nodes of each member: two numbers a member, counted from 0",
            mode=("ReadOnly", "Hidden"),
        ),
        Property(
            "App::PropertyIntegerList",
            "Panels",
            "Results",
            "The nodes around each panel: of each panel how many, then their numbers",
            mode=("ReadOnly", "Hidden"),
        ),
        _result("App::PropertyFloatList", "MemberForces", "Force in each member [N], compression negative"),
        _result(
            "App::PropertyVectorList",
            "Reactions",
            "Reaction at each node [N], before Placement; zero where unsupported",
        ),
        _result("App::PropertyFloat", "Residual", "Largest unbalanced force at a node, in mean nodal loads"),
        _result("App::PropertyLength", "PositionError", "How far the nodes still are from equilibrium"),
        _result(
            "App::PropertyBool", "CompressionOnly", "No member is in tension: recomputed from the result"
        ),
        _result("App::PropertyIntegerList", "TensionMembers", "Members in tension, counted from 0"),
        _result("App::PropertyIntegerList", "SlackMembers", "Members without force: they can be left out"),
        _result("App::PropertyForce", "WorstTension", "Largest tension in a member"),
        _result("App::PropertyForce", "TotalWeight", "Sum of all loads, downwards"),
        _result("App::PropertyForce", "ReactionSum", "Sum of all reactions, upwards"),
        _result("App::PropertyInteger", "Iterations", "Iterations of the solver"),
        _result("App::PropertyFloat", "Seconds", "Time in the solver"),
        _result(
            "App::PropertyFloat",
            "LengthDeviation",
            "Root mean square of the members' relative difference from their lengths on the source",
        ),
    )

    def compute(self, obj):
        scene, result = _solve(obj, scene_of(obj))
        if result.status != "converged":
            raise Unsolved(result.status, result.message)
        _write(obj, scene, result, fn.certify(scene, result))

    def failed(self, obj, error):
        # The last good shape and numbers stay, but nothing may take them for those of this scene.
        obj.Status = getattr(error, "status", "failed")
        obj.Summary = str(reason(error))
        obj.CompressionOnly = False


class Unsolved(ValueError):
    """The solver did not arrive. status: how it ended, such as "time_limit"; message: its own words."""

    def __init__(self, status, message=""):
        super().__init__(complaint(status, message))
        self.status = status


def scene_of(obj, net=None):
    """The fn.Scene that a Gridshell's properties describe. Raises InvalidInput naming the property.

    net: what net_of(obj.Net) gives, for who has it already.
    """
    if obj.Net is None:
        raise fn.InvalidInput(
            "Net is empty (none was given, or it was deleted): set it to a Net of this document"
        )
    if getattr(obj.Net, "FunicularType", "") != "Net":
        raise fn.InvalidInput(f"Net is {obj.Net.Label}, which is not a Net: set it to a Net of this document")
    refuse_tilt(obj)
    _refuse_tilted_container(obj.Net)
    member_weight = amount(obj, "MemberWeight", "kg/m")
    covering_weight = amount(obj, "CoveringWeight", "kg/m^2")
    snow = amount(obj, "Snow", "N/m^2")
    stiffness = amount(obj, "AxialStiffness", "N")
    if stiffness == 0.0:
        raise fn.InvalidInput("AxialStiffness is 0 N: give a force greater than zero")
    if not (member_weight or covering_weight or snow):
        raise fn.InvalidInput(
            "MemberWeight, CoveringWeight and Snow are all zero: without a load no form "
            "is found; give one of them"
        )
    effects = [fn.AxialStiffness(stiffness, compression_only=not obj.AllowTension)]
    if member_weight:
        effects.append(fn.MemberWeight(member_weight))
    if covering_weight:
        effects.append(fn.CoveringWeight(covering_weight, share=obj.CoveringShare.lower()))
    if snow:
        effects.append(fn.Snow(snow))
    net = net_of(obj.Net) if net is None else net
    effects += _on_rims(obj.Net, covering_weight)
    return fn.Scene(net, supports=supports_of_gridshell(obj, net), effects=effects)


def _on_rims(net, covering_weight):
    """What covers openings weighs as much as it would there, and stands on the nodes around them."""
    if not covering_weight:
        return []
    return [
        fn.PointLoad(nodes, (0.0, 0.0, -GRAVITY * covering_weight * area * METRES**2 / len(nodes)))
        for nodes, area in zip(panels_of(net.OpeningNodes), net.OpeningAreas)
        if nodes
    ]


def refuse_tilt(obj):
    """Raises InvalidInput if a Gridshell is placed so that it does not stand as it was found."""
    if _tilts(obj.Placement):
        raise fn.InvalidInput(
            "Placement tilts the gridshell, which is in equilibrium only as it was found, upright: "
            f"let it turn about z alone; to relax a tilted net, set Placement of {obj.Net.Label} instead"
        )
    _refuse_tilted_container(obj)


def _refuse_tilted_container(obj):
    container = obj.getParentGeoFeatureGroup()
    if container is not None and _tilts(container.getGlobalPlacement()):
        raise fn.InvalidInput(
            f"{obj.Label} lies inside {container.Label}, which is placed at a tilt, but a shell is found for "
            f"the vertical: move it out of {container.Label}, or let that turn about z alone"
        )


def _tilts(placement):
    up = App.Vector(0, 0, 1)
    return (placement.Rotation.multVec(up) - up).Length > UPRIGHT


def solver_options(obj):
    """The arguments of fn.solve that a Gridshell's properties give. Raises InvalidInput naming one."""
    accuracy = amount(obj, "Accuracy", "mm") * METRES
    if accuracy == 0.0:
        raise fn.InvalidInput("Accuracy is 0 mm: give a length greater than zero, such as 1 mm")
    return {
        "accuracy": accuracy,
        "method": obj.Method.lower(),
        "max_seconds": checked("MaxSeconds", obj.MaxSeconds, "s") or None,
    }


def result_line(obj):
    """The sentence that tells a Gridshell's last result; empty before the first recompute."""
    return obj.Summary


def _solve(obj, scene):
    """(scene, result), the scene being the one of the best round where lengths are matched."""
    options = solver_options(obj)
    if obj.LengthMatching < 0:
        raise fn.InvalidInput(f"LengthMatching is {obj.LengthMatching} rounds: give 0 (none) or more")
    with Progress(f"Relaxing {obj.Label}", options["accuracy"]) as progress:
        if not obj.LengthMatching:
            return scene, fn.solve(scene, on_progress=progress, **options)
        matched = fn.solve_matching_lengths(scene, rounds=obj.LengthMatching, on_progress=progress, **options)
        if matched.status == "cancelled":
            raise Unsolved(matched.status)
        # A later round that met a limit only means that the best before it is what there is.
        return matched.scene, matched.result


def _write(obj, scene, result, certificate):
    net = scene.net
    deviation = result.member_lengths / net.source_lengths - 1.0
    nodes = result.nodes / METRES
    # The shape first: it is what may fail, and then no number has changed.
    obj.Shape = edges_of(nodes, net.members)
    obj.NodePositions = to_vectors(nodes)
    obj.Members = net.members.ravel().tolist()
    obj.Panels = flat_panels(net.panels)
    obj.MemberForces = result.member_forces.tolist()
    obj.Reactions = to_vectors(result.reactions)
    obj.Residual = result.residual
    obj.PositionError = result.position_error / METRES
    obj.MethodUsed = result.method
    obj.Iterations = result.iterations
    obj.Seconds = result.seconds
    obj.LengthDeviation = float(np.sqrt(np.mean(deviation**2)))
    obj.CompressionOnly = certificate.compression_only
    obj.TensionMembers = [int(member) for member in certificate.tension_members]
    obj.SlackMembers = [int(member) for member in certificate.slack_members]
    obj.WorstTension = certificate.worst_tension / NEWTONS
    obj.TotalWeight = -certificate.total_load[2] / NEWTONS
    obj.ReactionSum = certificate.reaction_sum[2] / NEWTONS
    obj.Status = result.status
    obj.Summary = sentence_of(scene, result, certificate)
