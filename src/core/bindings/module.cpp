// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert.hpp"

PYBIND11_MODULE(_core, module) {
    namespace py = pybind11;
    module.doc() = "Form finding of compression-only gridshells: the native core of the funicular package.";
    py::register_exception<funicular::InvalidInput>(module, "InvalidInput", PyExc_ValueError);
    funicular::bindings::bind_net(module);
    funicular::bindings::bind_scene(module);
    funicular::bindings::bind_solve(module);
}
