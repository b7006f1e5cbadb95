// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert.hpp"
#include "lattice.hpp"

namespace funicular::bindings {

namespace {

std::shared_ptr<const Lattice> make_lattice(Index cells_u, Index cells_v, const std::string &pattern,
                                            bool closed_u, bool closed_v,
                                            const std::vector<std::string> &poles) {
    LatticeRecipe recipe{pattern_from_name(pattern), cells_u, cells_v, closed_u, closed_v, {}};
    for (const auto &pole : poles)
        recipe.poles.push_back(side_from_name(pole));
    return std::make_shared<const Lattice>(std::move(recipe));
}

py::dict sides_of(const Lattice &lattice) {
    py::dict sides;
    for (const auto &[side, nodes] : lattice.sides())
        sides[py::str(side_name(side))] = read_only(nodes);
    return sides;
}

py::list poles_of(const Lattice &lattice) {
    py::list poles;
    for (const Side side : lattice.recipe().poles)
        poles.append(side_name(side));
    return poles;
}

} // namespace

void bind_net(py::module_ &module) {
    py::class_<Lattice, std::shared_ptr<Lattice>>(
        module, "Lattice",
        R"(Connectivity on the unit (u, v) square, without positions in space. Made by `lattice`.)")
        .def_property_readonly(
            "uv",
            [](const py::object &self) {
                const auto &uv = self.cast<const Lattice &>().uv();
                return read_only(uv.data(), {uv.rows(), 2}, self);
            },
            "(n, 2) float64: (u, v) of each node in [0, 1]; a closed direction never reaches 1.")
        .def_property_readonly(
            "members",
            [](const py::object &self) { return read_only(self.cast<const Lattice &>().members(), self); },
            "(m, 2) int32: the nodes of each member.")
        .def_property_readonly(
            "panels", [](const Lattice &self) { return to_tuple(self.panels()); },
            "Tuple of tuples: the nodes around each panel.")
        .def_property_readonly(
            "corners", [](const Lattice &self) { return read_only(self.corners()); },
            "Nodes at the corners of the (u, v) square; none where a direction is closed.")
        .def_property_readonly("sides", &sides_of,
                               "Nodes along each open side, by name: u_min, u_max, v_min, v_max.")
        .def_property_readonly("pattern",
                               [](const Lattice &self) { return pattern_name(self.recipe().pattern); })
        .def_property_readonly(
            "cells",
            [](const Lattice &self) { return py::make_tuple(self.recipe().cells_u, self.recipe().cells_v); },
            "(cells_u, cells_v).")
        .def_property_readonly(
            "closed",
            [](const Lattice &self) {
                return py::make_tuple(self.recipe().closed_u, self.recipe().closed_v);
            },
            "(closed_u, closed_v).")
        .def_property_readonly("poles", &poles_of, "Names of the sides that are one point.")
        .def(
            "net",
            [](const std::shared_ptr<Lattice> &self, const py::object &nodes) {
                return std::const_pointer_cast<Net>(make_net(self, points_from(nodes, "nodes")));
            },
            py::arg("nodes"), R"(The net with these node positions, which remembers this lattice.

nodes: (n, 3) positions [m], one for each row of `uv`. Raises InvalidInput for another number of rows.)")
        .def("__repr__", [](const Lattice &self) {
            return "<funicular.Lattice " + pattern_name(self.recipe().pattern) + ", " +
                   std::to_string(self.recipe().cells_u) + " x " + std::to_string(self.recipe().cells_v) +
                   " cells>";
        });

    module.def(
        "lattice",
        [](Index cells_u, Index cells_v, const std::string &pattern, bool closed_u, bool closed_v,
           const std::vector<std::string> &poles) {
            return std::const_pointer_cast<Lattice>(
                make_lattice(cells_u, cells_v, pattern, closed_u, closed_v, poles));
        },
        py::arg("cells_u"), py::arg("cells_v"), py::arg("pattern") = "quad", py::arg("closed_u") = false,
        py::arg("closed_v") = false, py::arg("poles") = std::vector<std::string>{},
        R"(A lattice of cells_u x cells_v cells with members and panels laid by a pattern (Brivio et al. 2009, section 5.1).

closed_u, closed_v: the last cell joins the first; the number of cells becomes a multiple of those after which the pattern
repeats, see `cells`. poles: names of the sides ("u_min", "u_max", "v_min", "v_max") that
are one point. Raises InvalidInput for too few cells, contradictory poles, or an unknown pattern; `patterns()` names
them all.)");

    module.def(
        "patterns", [] { return py::tuple(py::cast(pattern_names())); },
        "Names of the patterns that `lattice` lays, the plain one first.");
    module.def(
        "cell_extent", [](const std::string &pattern) { return cell_extent(pattern_from_name(pattern)); },
        py::arg("pattern"),
        R"(Extent of a pattern's cell along u and along v where its members are one unit long, diagonals of quads apart.

For a net with members of a given length: cells_u = width / (length * cell_extent(pattern)[0]), and likewise for v. Raises
InvalidInput for a pattern that is not known.)");

    py::class_<Net, std::shared_ptr<Net>>(
        module, "Net",
        R"(Nodes joined by straight members, with panels (the covering) between them. Immutable.

nodes: (n, 3) positions [m]. members: (m, 2) node numbers. panels: sequence of sequences of node numbers around each panel.
Raises InvalidInput, naming the argument and the first offending index, for data that are empty, not finite, out of range,
of zero length, or given twice.)")
        .def(py::init([](const py::object &nodes, const py::object &members, const py::object &panels) {
                 return std::make_shared<Net>(points_from(nodes, "nodes"), members_from(members),
                                              panels_from(panels));
             }),
             py::arg("nodes"), py::arg("members"), py::arg("panels") = py::none())
        .def_static(
            "grid",
            [](double width, double depth, double step, const std::string &pattern) {
                return std::const_pointer_cast<Net>(flat_sheet(width, depth, step, pattern.c_str()));
            },
            py::arg("width"), py::arg("depth"), py::arg("step"), py::arg("pattern") = "quad",
            R"(A flat sheet width x depth [m] in the plane z = 0, one corner at the origin, members of about `step` [m]
(Brivio et al. 2009, section 5.1). Raises InvalidInput unless 0 < step <= width, depth.)")
        .def_property_readonly(
            "nodes", [](const py::object &self) { return read_only(self.cast<const Net &>().nodes(), self); },
            "(n, 3) float64, read-only: positions [m].")
        .def_property_readonly(
            "members",
            [](const py::object &self) { return read_only(self.cast<const Net &>().members(), self); },
            "(m, 2) int32, read-only: the nodes of each member.")
        .def_property_readonly(
            "panels", [](const Net &self) { return to_tuple(self.panels()); },
            "Tuple of tuples: the nodes around each panel.")
        .def_property_readonly(
            "source_lengths",
            [](const py::object &self) { return read_only(self.cast<const Net &>().source_lengths(), self); },
            "(m,) float64, read-only: length of each member as given [m].")
        .def_property_readonly(
            "border", [](const Net &self) { return read_only(self.border()); },
            "Nodes on the open border (panel edges with one panel), ascending.")
        .def_property_readonly(
            "lattice", [](const Net &self) { return std::const_pointer_cast<Lattice>(self.lattice()); },
            "The lattice that the net was made on, or None.")
        .def_property_readonly("size", &Net::size, "Diagonal of the bounding box [m].")
        .def("__repr__", [](const Net &self) {
            return "<funicular.Net: " + std::to_string(self.node_count()) + " nodes, " +
                   std::to_string(self.member_count()) + " members, " + std::to_string(self.panels().size()) +
                   " panels>";
        });
}

} // namespace funicular::bindings
