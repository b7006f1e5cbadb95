// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert.hpp"

#include <limits>

namespace funicular::bindings {

namespace {

template <class Scalar>
using Array = py::array_t<Scalar, py::array::c_style | py::array::forcecast>;

std::string shape_of(const py::array &array) {
    return py::str(array.attr("shape")).cast<std::string>();
}

Array<double> doubles_from(const py::handle &value, const std::string &argument) {
    const auto raw = py::array::ensure(value);
    if (!raw || (raw.dtype().kind() != 'f' && raw.dtype().kind() != 'i' && raw.dtype().kind() != 'u' &&
                 raw.size() > 0)) {
        PyErr_Clear();
        throw InvalidInput(argument + " must be an array of real numbers");
    }
    return Array<double>(raw);
}

/// Integers only: a float would be cut off without a word.
Array<std::int64_t> integers_from(const py::handle &value, const std::string &argument) {
    const auto raw = py::array::ensure(value);
    if (!raw || (raw.dtype().kind() != 'i' && raw.dtype().kind() != 'u' && raw.size() > 0)) {
        PyErr_Clear();
        throw InvalidInput(argument +
                           " must hold integers (node numbers; of a mask, numpy.flatnonzero gives them)");
    }
    if (raw.dtype().kind() == 'u' && raw.size() > 0 &&
        raw.attr("max")().cast<std::uint64_t>() > std::numeric_limits<Index>::max())
        throw InvalidInput(argument + " holds " + py::str(raw.attr("max")()).cast<std::string>() +
                           ", which is no node number");
    return Array<std::int64_t>(raw);
}

Index index_from(std::int64_t value, const std::string &where) {
    if (value < 0 || value > std::numeric_limits<Index>::max())
        throw InvalidInput(where + " is " + std::to_string(value) + ": node numbers count from 0 to " +
                           std::to_string(std::numeric_limits<Index>::max()));
    return static_cast<Index>(value);
}

} // namespace

Points points_from(const py::handle &value, const std::string &argument) {
    const auto array = doubles_from(value, argument);
    if (array.size() == 0)
        return Points(0, 3);
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw InvalidInput(argument + " must have shape (n, 3), not " + shape_of(array));
    return Eigen::Map<const Points>(array.data(), array.shape(0), 3);
}

std::vector<Member> members_from(const py::handle &value) {
    const auto array = integers_from(value, "members");
    if (array.size() == 0)
        return {};
    if (array.ndim() != 2 || array.shape(1) != 2)
        throw InvalidInput("members must have shape (m, 2), not " + shape_of(array));
    std::vector<Member> members(array.shape(0));
    for (py::ssize_t e = 0; e < array.shape(0); ++e)
        for (int end = 0; end < 2; ++end)
            members[e][end] = index_from(array.at(e, end), "members[" + std::to_string(e) + "]");
    return members;
}

Panels panels_from(const py::handle &value) {
    Panels panels;
    if (value.is_none())
        return panels;
    if (!py::isinstance<py::iterable>(value))
        throw InvalidInput("panels must be a sequence of sequences of node numbers");
    Index at = 0;
    for (const auto corners : value)
        panels.add(ids_from(corners, "panels[" + std::to_string(at++) + "]"));
    return panels;
}

std::vector<Index> ids_from(const py::handle &value, const std::string &argument) {
    const auto array = integers_from(value, argument);
    if (array.ndim() > 1)
        throw InvalidInput(argument + " must be one node number or a flat sequence of them, not of shape " +
                           shape_of(array));
    std::vector<Index> ids(array.size());
    for (py::ssize_t k = 0; k < array.size(); ++k)
        ids[k] = index_from(array.data()[k], argument + "[" + std::to_string(k) + "]");
    return ids;
}

Vector3 vector3_from(const py::handle &value, const std::string &argument) {
    const auto array = doubles_from(value, argument);
    if (array.ndim() != 1 || array.size() != 3)
        throw InvalidInput(argument + " must be three numbers, not of shape " + shape_of(array));
    return {array.data()[0], array.data()[1], array.data()[2]};
}

Eigen::VectorXd numbers_from(const py::handle &value, const std::string &argument) {
    const auto array = doubles_from(value, argument);
    if (array.ndim() > 1)
        throw InvalidInput(argument + " must be one number or a flat array, not of shape " + shape_of(array));
    return Eigen::Map<const Eigen::VectorXd>(array.data(), array.size());
}

namespace {

/// Of an array, its beginning says what it is.
std::string short_repr(const py::handle &value) {
    constexpr std::size_t longest = 60;
    const auto text = py::repr(value).cast<std::string>();
    return text.size() <= longest ? text : text.substr(0, longest) + "…";
}

} // namespace

double number_from(const py::handle &value, const std::string &argument) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        throw InvalidInput(argument + " must be a number, not " + short_repr(value));
    }
    return number;
}

long count_from(const py::handle &value, const std::string &argument) {
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    const long count = index ? PyLong_AsLong(index.ptr()) : -1;
    if (PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        throw InvalidInput(argument + " must be a whole number, not " + short_repr(value));
    }
    return count;
}

py::array read_only(const std::vector<Index> &ids) {
    py::array_t<Index> array(static_cast<py::ssize_t>(ids.size()), ids.data());
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

py::array read_only(const Points &points, const py::object &owner) {
    return read_only(points.data(), {points.rows(), 3}, owner);
}

py::array read_only(const Eigen::VectorXd &numbers, const py::object &owner) {
    return read_only(numbers.data(), {numbers.size()}, owner);
}

py::array read_only(const std::vector<Member> &members, const py::object &owner) {
    static_assert(sizeof(Member) == 2 * sizeof(Index));
    return read_only(members.front().data(), {static_cast<py::ssize_t>(members.size()), 2}, owner);
}

py::tuple to_tuple(const Panels &panels) {
    py::tuple result(panels.size());
    for (Index f = 0; f < panels.size(); ++f) {
        const auto corners = panels[f];
        py::tuple panel(corners.size());
        for (std::size_t k = 0; k < corners.size(); ++k)
            panel[k] = corners[k];
        result[f] = panel;
    }
    return result;
}

} // namespace funicular::bindings
