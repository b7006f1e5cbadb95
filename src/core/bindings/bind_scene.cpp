// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coarser_scene.hpp"
#include "convert.hpp"
#include "effect_memory.hpp"
#include "length_matching.hpp"
#include "scene.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace funicular::bindings {

namespace {

constexpr double rigid = std::numeric_limits<double>::infinity();

/// An effect as Python holds it.
template <class Description>
auto bind_effect(py::module_ &module, const char *name, const char *doc) {
    return py::class_<Description>(module, name, doc);
}

CornerShare share_from(const std::string &name) {
    if (name == "angle")
        return CornerShare::angle;
    if (name == "equal")
        return CornerShare::equal;
    if (name == "voronoi")
        return CornerShare::voronoi;
    throw InvalidInput("CoveringWeight: share '" + name +
                       "' is not known; choose one of: angle, equal, voronoi");
}

const char *share_name(CornerShare share) {
    switch (share) {
    case CornerShare::equal:
        return "equal";
    case CornerShare::voronoi:
        return "voronoi";
    case CornerShare::angle:
        break;
    }
    return "angle";
}

/// Python's three names for a support; all of them are one kind of thing in the core.
struct Fixed : Support {};
struct OnLine : Support {};
struct OnPlane : Support {};

template <class Kind>
Kind make_support(SupportKind kind, const py::object &ids, const Vector3 &direction,
                  const py::object &stiffness) {
    Kind support;
    support.kind = kind;
    support.nodes = ids_from(ids, "ids");
    std::sort(support.nodes.begin(), support.nodes.end());
    support.nodes.erase(std::unique(support.nodes.begin(), support.nodes.end()), support.nodes.end());
    support.direction = direction;
    support.stiffness = number_from(stiffness, "stiffness");
    return support;
}

template <class Kind>
py::class_<Kind> bind_support(py::module_ &module, const char *name, const char *doc) {
    return py::class_<Kind>(module, name, doc)
        .def_property_readonly(
            "ids", [](const Kind &self) { return read_only(self.nodes); }, "Node numbers.")
        .def_property_readonly(
            "stiffness", [](const Kind &self) { return self.stiffness; }, "[N/m]; infinite is rigid.");
}

Support support_from(const py::handle &value, std::size_t at) {
    if (py::isinstance<Fixed>(value))
        return value.cast<Fixed>();
    if (py::isinstance<OnLine>(value))
        return value.cast<OnLine>();
    if (py::isinstance<OnPlane>(value))
        return value.cast<OnPlane>();
    throw InvalidInput("supports[" + std::to_string(at) + "] must be a Fixed, OnLine or OnPlane");
}

EffectDescription effect_from(const py::handle &value, std::size_t at) {
    if (py::isinstance<AxialStiffness>(value))
        return value.cast<AxialStiffness>();
    if (py::isinstance<MemberWeight>(value))
        return value.cast<MemberWeight>();
    if (py::isinstance<CoveringWeight>(value))
        return value.cast<CoveringWeight>();
    if (py::isinstance<PointLoad>(value))
        return value.cast<PointLoad>();
    if (py::isinstance<Snow>(value))
        return value.cast<Snow>();
    throw InvalidInput("effects[" + std::to_string(at) +
                       "] must be an AxialStiffness, MemberWeight, CoveringWeight, PointLoad or Snow");
}

template <class Part, class Convert>
std::vector<Part> parts_from(const py::object &values, const char *argument, Convert convert) {
    std::vector<Part> parts;
    if (!py::isinstance<py::iterable>(values))
        throw InvalidInput(std::string(argument) + " must be a list");
    for (const auto value : values)
        parts.push_back(convert(value, parts.size()));
    return parts;
}

py::object support_to_python(const Support &support) {
    const auto as = [&support](auto kind) {
        static_cast<Support &>(kind) = support;
        return py::cast(kind);
    };
    if (support.kind == SupportKind::on_line)
        return as(OnLine{});
    return support.kind == SupportKind::on_plane ? as(OnPlane{}) : as(Fixed{});
}

} // namespace

void bind_scene(py::module_ &module) {
    bind_support<Fixed>(module, "Fixed", R"(Nodes that stay where they are in the source net.

ids: node numbers. stiffness: [N/m]; finite lets the hanging model pull the node off its place, along its reaction: a way of letting go of a
support, not the settlement of a foundation.)")
        .def(py::init([](const py::object &ids, const py::object &stiffness) {
                 return make_support<Fixed>(SupportKind::fixed, ids, Vector3::UnitZ(), stiffness);
             }),
             py::arg("ids"), py::arg("stiffness") = rigid);
    bind_support<OnLine>(module, "OnLine", R"(Nodes that stay on a line through their place in the source net.

ids: node numbers. direction: of the line, vertical by default. stiffness: [N/m], against motion off the line.)")
        .def(py::init([](const py::object &ids, const py::object &direction, const py::object &stiffness) {
                 return make_support<OnLine>(SupportKind::on_line, ids, vector3_from(direction, "direction"),
                                             stiffness);
             }),
             py::arg("ids"), py::arg("direction") = py::make_tuple(0, 0, 1), py::arg("stiffness") = rigid)
        .def_property_readonly("direction", [](const OnLine &self) {
            return py::make_tuple(self.direction.x(), self.direction.y(), self.direction.z());
        });
    bind_support<OnPlane>(module, "OnPlane",
                          R"(Nodes that stay on a plane through their place in the source net.

ids: node numbers. normal: of the plane; horizontal for a vertical plane. stiffness: [N/m], against motion off the plane.)")
        .def(py::init([](const py::object &ids, const py::object &normal, const py::object &stiffness) {
                 return make_support<OnPlane>(SupportKind::on_plane, ids, vector3_from(normal, "normal"),
                                              stiffness);
             }),
             py::arg("ids"), py::arg("normal") = py::make_tuple(1, 0, 0), py::arg("stiffness") = rigid)
        .def_property_readonly("normal", [](const OnPlane &self) {
            return py::make_tuple(self.direction.x(), self.direction.y(), self.direction.z());
        });

    bind_effect<AxialStiffness>(module, "AxialStiffness",
                                R"(Members are springs: T = k (l - r) (Brivio et al. 2009, section 2).

stiffness: EA [N], so that k = EA / r; or k itself [N/m] with per_spring (the paper's constant). One number or (m,).
compression_only: members that would be pulled carry nothing, T = max(0, k (l - r)).)")
        .def(py::init([](const py::object &stiffness, bool compression_only, bool per_spring) {
                 return AxialStiffness{numbers_from(stiffness, "stiffness"), compression_only, per_spring};
             }),
             py::arg("stiffness"), py::arg("compression_only") = true, py::kw_only(),
             py::arg("per_spring") = false)
        .def_property_readonly("stiffness",
                               [](const AxialStiffness &self) {
                                   return self.stiffness.size() == 1
                                              ? py::object(py::float_(self.stiffness[0]))
                                              : py::object(read_only(self.stiffness, py::cast(self)));
                               })
        .def_readonly("compression_only", &AxialStiffness::compression_only)
        .def_readonly("per_spring", &AxialStiffness::per_spring);
    bind_effect<MemberWeight>(
        module, "MemberWeight",
        R"(Weight of the members by their present length [kg/m], one number for all (section 3.3).)")
        .def(py::init([](const py::object &weight) { return MemberWeight{number_from(weight, "weight")}; }),
             py::arg("weight"))
        .def_readonly("weight", &MemberWeight::per_length);
    bind_effect<CoveringWeight>(module, "CoveringWeight",
                                R"(Weight of the panels by their present area [kg/m²] (section 4.1).

share: how a panel's weight goes to its corners: "angle" (by interior angle, the paper's), "equal" or "voronoi" (the nearest area).
The area of a panel that is not plane is that of the triangles between its edges and the mean of its corners.)")
        .def(py::init([](const py::object &weight, const std::string &share) {
                 return CoveringWeight{number_from(weight, "weight"), share_from(share)};
             }),
             py::arg("weight"), py::arg("share") = "angle")
        .def_readonly("weight", &CoveringWeight::per_area)
        .def_property_readonly("share", [](const CoveringWeight &self) { return share_name(self.share); });
    bind_effect<PointLoad>(
        module, "PointLoad",
        R"(A force [N] on each of some nodes, as the built structure sees it: down is negative z.)")
        .def(py::init([](const py::object &ids, const py::object &force) {
                 return PointLoad{ids_from(ids, "ids"), vector3_from(force, "force")};
             }),
             py::arg("ids"), py::arg("force"))
        .def_property_readonly("ids", [](const PointLoad &self) { return read_only(self.nodes); })
        .def_property_readonly("force", [](const PointLoad &self) {
            return py::make_tuple(self.force.x(), self.force.y(), self.force.z());
        });
    bind_effect<Snow>(module, "Snow", R"(A load [N/m²] on the panels' area in plan.)")
        .def(py::init([](const py::object &pressure) { return Snow{number_from(pressure, "pressure")}; }),
             py::arg("pressure"))
        .def_readonly("pressure", &Snow::pressure);

    py::class_<Scene, std::shared_ptr<Scene>>(
        module, "Scene", R"(A net with its supports and effects. Checked once, then immutable.

net: a Net. supports: list of Fixed, OnLine, OnPlane. effects: list of AxialStiffness (one), MemberWeight, CoveringWeight, PointLoad,
Snow; one of zero weight is left out. rest_lengths: (m,) [m], the source lengths by default.
Raises InvalidInput, naming the part and the first offending index; so for a connected part of the net that has no support.)")
        .def(py::init([](const std::shared_ptr<Net> &net, const py::object &supports,
                         const py::object &effects, const py::object &rest_lengths) {
                 std::optional<Eigen::VectorXd> lengths;
                 if (!rest_lengths.is_none())
                     lengths = numbers_from(rest_lengths, "rest_lengths");
                 return std::make_shared<Scene>(
                     net, parts_from<Support>(supports, "supports", &support_from),
                     parts_from<EffectDescription>(effects, "effects", &effect_from), std::move(lengths));
             }),
             py::arg("net"), py::arg("supports"), py::arg("effects"), py::arg("rest_lengths") = py::none())
        .def_property_readonly(
            "net", [](const Scene &self) { return std::const_pointer_cast<Net>(self.shared_net()); })
        .def_property_readonly("supports",
                               [](const Scene &self) {
                                   py::list supports;
                                   for (const auto &support : self.supports())
                                       supports.append(support_to_python(support));
                                   return supports;
                               })
        .def_property_readonly(
            "effects",
            [](const Scene &self) {
                py::list effects;
                for (const auto &effect : self.effects())
                    effects.append(std::visit([](const auto &part) { return py::cast(part); }, effect));
                return effects;
            },
            "The effects present: those of zero weight have been left out.")
        .def_property_readonly(
            "rest_lengths",
            [](const py::object &self) { return read_only(self.cast<const Scene &>().rest_lengths(), self); },
            "(m,) float64, read-only [m].")
        .def(
            "match_lengths",
            [](const Scene &self, const Result &result) {
                return std::const_pointer_cast<Scene>(match_lengths(self, result));
            },
            py::arg("result"),
            R"(The scene with rest lengths r L / l', L the source length and l' the length in `result` (section 4.2).)")
        .def(
            "effect_memory", &effect_memory,
            R"({effect name: bytes}: what each holds, and the part of the tangent stiffness that is there for it alone.

Solvers that make no matrix, as on lattices of quads, take less.)")
        .def(
            "coarsened",
            [](const Scene &self) {
                auto [scene, kept] = coarser_scene(self);
                return py::make_tuple(std::const_pointer_cast<Scene>(scene), read_only(kept));
            },
            R"(The scene as it would be with twice the step, for `net_error`, and (k,) the nodes of this one that it keeps.

Every second line of a lattice of quads is left out, and every second node of ribs; members stand for those beside them.
Raises InvalidInput for another net, one too coarse, and a support that no kept node stands for.)")
        .def("length_deviation", &length_deviation, py::arg("result"),
             "Root mean square over the members of (l' - L) / L.");
}

} // namespace funicular::bindings
