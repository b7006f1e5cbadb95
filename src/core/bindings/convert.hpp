// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Between numpy and the core: every shape error names the argument, and nothing is cast silently.
#pragma once

#include "errors.hpp"
#include "net.hpp"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace funicular::bindings {

namespace py = pybind11;

/// (n, 3) positions or forces from anything numpy can turn into float64, contiguous or not.
[[nodiscard]] Points points_from(const py::handle &value, const std::string &argument);
/// (m, 2) node numbers.
[[nodiscard]] std::vector<Member> members_from(const py::handle &value);
/// A sequence of sequences of node numbers, or None.
[[nodiscard]] Panels panels_from(const py::handle &value);
/// Node numbers: one integer or a sequence of them.
[[nodiscard]] std::vector<Index> ids_from(const py::handle &value, const std::string &argument);
/// Three finite numbers.
[[nodiscard]] Vector3 vector3_from(const py::handle &value, const std::string &argument);
/// One number, or an array of them.
[[nodiscard]] Eigen::VectorXd numbers_from(const py::handle &value, const std::string &argument);

/// One real number; a text or an array is none.
[[nodiscard]] double number_from(const py::handle &value, const std::string &argument);
/// One whole number.
[[nodiscard]] long count_from(const py::handle &value, const std::string &argument);

/// A read-only view on core data that lives as long as `owner`.
template <class Scalar>
py::array read_only(const Scalar *data, std::vector<py::ssize_t> shape, const py::object &owner) {
    py::array_t<Scalar> array(std::move(shape), data, owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}
[[nodiscard]] py::array read_only(const std::vector<Index> &ids);
[[nodiscard]] py::array read_only(const Points &points, const py::object &owner);
[[nodiscard]] py::array read_only(const Eigen::VectorXd &numbers, const py::object &owner);
[[nodiscard]] py::array read_only(const std::vector<Member> &members, const py::object &owner);
[[nodiscard]] py::tuple to_tuple(const Panels &panels);

void bind_net(py::module_ &module);
void bind_scene(py::module_ &module);
void bind_solve(py::module_ &module);

} // namespace funicular::bindings
