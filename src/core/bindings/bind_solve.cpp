// SPDX-License-Identifier: LGPL-2.1-or-later
#include "certificate.hpp"
#include "convert.hpp"
#include "length_matching.hpp"
#include "solve.hpp"
#include "text.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace funicular::bindings {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

Method method_from(const std::string &name) {
    if (name == "auto")
        return Method::automatic;
    if (name == "newton")
        return Method::newton;
    if (name == "relaxation")
        return Method::relaxation;
    throw InvalidInput("method '" + name + "' is not known; choose one of: auto, newton, relaxation");
}

/// Calls Python from the solving thread, which has let go of the GIL. Ctrl-C ends the solve too.
std::function<bool(const Report &)> progress_from(const py::object &callback) {
    if (!callback.is_none() && !PyCallable_Check(callback.ptr()))
        throw InvalidInput("on_progress must be callable: on_progress(report) -> False cancels");
    return [callback = callback.is_none() ? py::handle() : py::handle(callback)](const Report &report) {
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!callback)
            return true;
        const py::object answer = callback(report);
        const int goes_on = answer.is_none() ? 1 : PyObject_IsTrue(answer.ptr());
        if (goes_on < 0)
            throw py::error_already_set();
        return goes_on == 1;
    };
}

SolveOptions options_from(const py::object &accuracy, const py::object &tolerance, const std::string &method,
                          const py::object &max_seconds, const py::object &max_iterations,
                          const py::object &on_progress, const py::object &start) {
    SolveOptions options;
    options.accuracy = number_from(accuracy, "accuracy");
    options.tolerance = number_from(tolerance, "tolerance");
    options.method = method_from(method);
    options.max_seconds = max_seconds.is_none() ? no_limit : number_from(max_seconds, "max_seconds");
    if (!max_iterations.is_none())
        options.max_iterations = count_from(max_iterations, "max_iterations");
    options.on_progress = progress_from(on_progress);
    if (!start.is_none())
        options.start = points_from(start, "start");
    return options;
}

/// Arrays of a result keep it alive and cannot be written.
template <class Member>
auto array_of(Member member) {
    return [member](const py::object &self) { return read_only(self.cast<const Result &>().*member, self); };
}

py::list history_of(const Result &result) {
    py::list history;
    for (const Report &report : result.history)
        history.append(report);
    return history;
}

py::dict costs_of(const Result &result) {
    py::dict costs;
    for (const auto &[name, cost] : result.costs)
        costs[py::str(name)] = py::make_tuple(cost.evaluations, cost.seconds);
    return costs;
}

py::array vector_of(const Vector3 &vector) {
    return py::array_t<double>(3, vector.data());
}

Certificate certify_any(const Scene &scene, const py::object &shape, const py::object &tolerance) {
    const auto allowed_or = [&tolerance](double otherwise) {
        const double allowed = tolerance.is_none() ? otherwise : number_from(tolerance, "tolerance");
        if (!(allowed > 0))
            throw InvalidInput("tolerance must be positive (a residual relative to the mean nodal load)");
        return allowed;
    };
    if (py::isinstance<Result>(shape)) {
        const auto &result = shape.cast<const Result &>();
        // A residual that met its tolerance by a hair may miss it by rounding here.
        return certify(scene, result.centred_nodes, &result.reactions, allowed_or(1.001 * result.tolerance));
    }
    const Points nodes = points_from(shape, "result");
    for (Index i = 0; i < nodes.rows(); ++i)
        if (!nodes.row(i).allFinite())
            throw InvalidInput("result[" + std::to_string(i) + "] is not finite");
    return certify(scene, nodes.rowwise() - scene.net().centre().transpose(), nullptr, allowed_or(1e-6));
}

} // namespace

void bind_solve(py::module_ &module) {
    py::class_<Report>(module, "Report", "Where a solve stands after an iteration.")
        .def_readonly("iteration", &Report::iteration)
        .def_readonly("seconds", &Report::seconds)
        .def_readonly("residual", &Report::residual, "max |r_i| / mean nodal load")
        .def_readonly("position_error", &Report::position_error, "[m]; infinite while it is not known")
        .def("__repr__", [](const Report &self) {
            return "<funicular.Report " + std::to_string(self.iteration) + ": residual " +
                   to_text(self.residual) + ">";
        });

    py::class_<Result, std::shared_ptr<Result>>(
        module, "Result",
        R"(A shape and what is known of it. Arrays are read-only; SI units; forces of the built structure.)")
        .def_property_readonly("nodes", array_of(&Result::nodes), "(n, 3) [m]")
        .def_property_readonly(
            "centred_nodes", array_of(&Result::centred_nodes),
            "(n, 3) [m] relative to the centre of the net's bounding box: exact also far from the origin")
        .def_property_readonly("member_forces", array_of(&Result::member_forces),
                               "(m,) [N], compression negative")
        .def_property_readonly("member_lengths", array_of(&Result::member_lengths), "(m,) [m]")
        .def_property_readonly("reactions", array_of(&Result::reactions),
                               "(n, 3) [N], zero where unsupported")
        .def_readonly("residual", &Result::residual, "max |r_i| / mean nodal load")
        .def_readonly("position_error", &Result::position_error,
                      "[m]: the largest |K⁻¹ r|; infinite if not known")
        .def_readonly("iterations", &Result::iterations)
        .def_readonly("seconds", &Result::seconds)
        .def_property_readonly(
            "status", [](const Result &self) { return status_name(self.status); },
            "converged, iteration_limit, time_limit, cancelled or no_equilibrium. The shape is an "
            "equilibrium if converged, else the last there was: after no_equilibrium that may be many times "
            "the "
            "net's size")
        .def_property_readonly(
            "method",
            [](const Result &self) { return self.method == Method::relaxation ? "relaxation" : "newton"; },
            "The method that was used last: newton, which includes the interior-point path and coarser nets "
            "of auto, or relaxation")
        .def_readonly("message", &Result::message, "Why it ended, and what to do if that is not convergence")
        .def_property_readonly("history", &history_of,
                               "One Report per iteration; of very many, evenly spaced ones")
        .def_property_readonly("costs", &costs_of,
                               "{effect name: (evaluations, seconds)}, only effects in the scene")
        .def("__repr__", [](const Result &self) {
            return std::string("<funicular.Result: ") + status_name(self.status) + " after " +
                   std::to_string(self.iterations) + " iterations>";
        });

    module.def(
        "solve",
        [](const std::shared_ptr<Scene> &scene, const py::object &accuracy, const py::object &tolerance,
           const std::string &method, const py::object &max_seconds, const py::object &on_progress,
           const py::object &start, const py::object &max_iterations) {
            auto options =
                options_from(accuracy, tolerance, method, max_seconds, max_iterations, on_progress, start);
            const py::gil_scoped_release no_gil;
            return std::make_shared<Result>(solve(scene, std::move(options)));
        },
        py::arg("scene"), py::arg("accuracy") = 1e-3, py::arg("tolerance") = 1e-6, py::arg("method") = "auto",
        py::arg("max_seconds") = py::none(), py::arg("on_progress") = py::none(),
        py::arg("start") = py::none(), py::kw_only(), py::arg("max_iterations") = py::none(),
        R"(The shape in which the scene stands in equilibrium.

accuracy: largest position error [m]. tolerance: largest relative residual; both are met, or the status says otherwise.
method: "auto", "newton" (line search on the work of the residual) or "relaxation" (Brivio et al. 2009, section 2.2).
max_seconds, max_iterations: limits, which are neither success nor an exception. on_progress(report) -> False cancels; it is called
after every Newton step, every 10 ms of relaxation. start: (n, 3) shape [m] to begin with.
Other Python threads run meanwhile. Raises InvalidInput for arguments that cannot be meant.)");

    py::class_<LengthMatching>(module, "LengthMatching",
                               "The best of several rounds of solving and matching lengths.")
        .def_property_readonly(
            "scene", [](const LengthMatching &self) { return std::const_pointer_cast<Scene>(self.scene); })
        .def_property_readonly(
            "result", [](const LengthMatching &self) { return std::make_shared<Result>(self.result); })
        .def_readonly("deviations", &LengthMatching::deviations,
                      "Root mean square of (l' - L) / L after each round; first without matching")
        .def_readonly("best_round", &LengthMatching::best_round)
        .def_property_readonly(
            "status", [](const LengthMatching &self) { return status_name(self.status); },
            "How the last round ended; `result` is the best of those that converged")
        .def_readonly("stopped_improving", &LengthMatching::stopped_improving);
    module.def(
        "solve_matching_lengths",
        [](const std::shared_ptr<Scene> &scene, const py::object &rounds, const py::object &accuracy,
           const py::object &tolerance, const std::string &method, const py::object &max_seconds,
           const py::object &on_progress, const py::object &start, const py::object &max_iterations) {
            auto options =
                options_from(accuracy, tolerance, method, max_seconds, max_iterations, on_progress, start);
            const auto count = static_cast<Index>(std::clamp(count_from(rounds, "rounds"), -1L, 1'000'000L));
            const py::gil_scoped_release no_gil;
            return solve_matching_lengths(scene, count, std::move(options));
        },
        py::arg("scene"), py::arg("rounds") = 5, py::arg("accuracy") = 1e-3, py::arg("tolerance") = 1e-6,
        py::arg("method") = "auto", py::arg("max_seconds") = py::none(), py::arg("on_progress") = py::none(),
        py::arg("start") = py::none(), py::arg("max_iterations") = py::none(),
        R"(Solves, sets rest lengths r ← r L / l' and solves again, `rounds` times, keeping the best (Brivio et al. 2009, section 4.2).

The time limit is for all rounds together. Ends early when three rounds in a row have not lowered the deviation.)");

    py::class_<Certificate>(module, "Certificate",
                            "What an independent recomputation says of a shape. Made by `certify`.")
        .def_readonly("compression_only", &Certificate::compression_only,
                      "In equilibrium, no member in tension, and some in compression")
        .def_readonly("in_equilibrium", &Certificate::in_equilibrium)
        .def_property_readonly("tension_members",
                               [](const Certificate &self) { return read_only(self.tension_members); })
        .def_readonly("worst_tension", &Certificate::worst_tension, "[N]; zero if there is none")
        .def_property_readonly(
            "slack_members", [](const Certificate &self) { return read_only(self.slack_members); },
            "Members that carry nothing")
        .def_readonly("max_residual", &Certificate::max_residual, "max |r_i| / mean nodal load")
        .def_readonly("support_error", &Certificate::support_error,
                      "[m]: largest distance of a node from where its rigid supports hold it")
        .def_readonly("tolerance", &Certificate::tolerance)
        .def_readonly("balance", &Certificate::balance, "|sum of reactions + sum of loads| / sum of |loads|")
        .def_readonly("moment_balance", &Certificate::moment_balance, "The same of moments, over size")
        .def_property_readonly(
            "total_load", [](const Certificate &self) { return vector_of(self.total_load); }, "(3,) [N]")
        .def_property_readonly(
            "reaction_sum", [](const Certificate &self) { return vector_of(self.reaction_sum); }, "(3,) [N]")
        .def("summary", &Certificate::summary, "One sentence for a person.")
        .def("__repr__",
             [](const Certificate &self) { return "<funicular.Certificate: " + self.summary() + ">"; });
    module.def(
        "certify", &certify_any, py::arg("scene"), py::arg("result"), py::arg("tolerance") = py::none(),
        R"(Recomputes forces, residual and balance of a result, by code that shares nothing with the solver.

result: a Result, or (n, 3) node positions [m]. tolerance: relative residual up to which it counts as equilibrium; by default the one
that the result was solved to. Raises InvalidInput if the shape does not fit the scene's net.)");

    py::class_<Solver>(
        module, "Solver",
        R"(The interactive loop: goes on for a while, can be read at any time, and takes changed scenes as it goes.)")
        .def(py::init([](const std::shared_ptr<Scene> &scene, const py::object &accuracy,
                         const py::object &tolerance, const std::string &method, const py::object &start) {
                 return std::make_unique<Solver>(scene, options_from(accuracy, tolerance, method, py::none(),
                                                                     py::none(), py::none(), start));
             }),
             py::arg("scene"), py::arg("accuracy") = 1e-3, py::arg("tolerance") = 1e-6,
             py::arg("method") = "auto", py::arg("start") = py::none())
        .def("advance", &Solver::advance, py::arg("max_seconds") = no_limit,
             py::call_guard<py::gil_scoped_release>(),
             "Goes on for at most max_seconds, give or take an iteration. Returns whether the solve has "
             "ended. Cancel by not calling it again; the shape can be gone on from at any time.")
        .def(
            "replace", [](Solver &self, const std::shared_ptr<Scene> &scene) { self.replace(scene); },
            py::arg("scene"), py::call_guard<py::gil_scoped_release>(),
            "Goes on from the present shape with another scene of as many nodes; where that is far from "
            "rest, by way of coarser nets.")
        .def(
            "result", [](const Solver &self) { return std::make_shared<Result>(self.result()); },
            py::call_guard<py::gil_scoped_release>(),
            "What is known of the present shape; waits for an advance in another thread to return. Before "
            "the solve has ended, status is iteration_limit and message says that it has not finished.")
        .def_property_readonly(
            "nodes",
            [](const Solver &self) {
                const py::object owner = py::cast(self.nodes());
                owner.attr("setflags")(py::arg("write") = false);
                return owner;
            },
            "(n, 3) [m]: the latest shape, a copy.");
}

} // namespace funicular::bindings
