// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solves.hpp"

#include "measure.hpp"
#include "scenes.hpp"
#include "solve.hpp"
#include "yardstick.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace funicular::bench {

namespace {

constexpr double tolerance = 1e-6;
constexpr double accuracy = 1e-4;      // [m]
constexpr double drag_accuracy = 1e-3; // [m]
// Where the accuracy alone is asked for: every shape is this near to a balance.
constexpr double any_residual = 1;
constexpr std::size_t most_samples = 5;
constexpr std::size_t drag_steps = 20;
// No further sample is begun after so long [s], and no solve goes on for longer.
constexpr double patience = 120;
constexpr double longest_solve = 300;
// The factor of a larger net fills the memory of an ordinary machine.
constexpr Index most_nodes_to_factor = 110'000;

using Counters = benchmark::UserCounters;

SolveOptions options(double wished_accuracy = accuracy, double wished_tolerance = tolerance) {
    SolveOptions chosen;
    chosen.accuracy = wished_accuracy;
    chosen.tolerance = wished_tolerance;
    chosen.max_seconds = longest_solve;
    return chosen;
}

/// Nodes of a solution relative to the net's centre [m]; what was solved once is remembered. Where the solver
/// does not converge it is the shape it came to: a factorisation takes as long there.
const Points &solution(const std::string &scene, Index node_count) {
    static std::map<std::pair<std::string, Index>, Points> known;
    const auto place = std::pair{scene, node_count};
    if (known.count(place) == 0)
        known[place] = solve(make_scene(scene, make_net(scene, node_count)), options()).centred_nodes;
    return known[place];
}

/// Registers work that fills in its counters and returns its label. It measures itself, so that Google
/// Benchmark runs it once.
void add(const std::string &name, const std::function<std::string(Counters &)> &work) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [work](benchmark::State &state) {
                                     for ([[maybe_unused]] auto once : state) {
                                         std::string status;
                                         try {
                                             status = work(state.counters);
                                         } catch (const std::exception &error) {
                                             status = "error";
                                             state.counters.clear();
                                         }
                                         state.SetLabel(status);
                                         const auto seconds = state.counters.find("seconds");
                                         state.SetIterationTime(
                                             seconds == state.counters.end() ? 0 : seconds->second.value);
                                     }
                                 })
        ->Iterations(1)
        ->UseManualTime();
}

std::string name(const std::string &kind, const std::string &scene, Index node_count) {
    return kind + "/" + scene + "/" + std::to_string(node_count);
}

/// Solves of one scene, each followed by a run of the yardstick, so that both see the machine in one mood.
class Samples {
public:
    Samples(const ScenePtr &scene, const Points &centred_solution) {
        if (scene->net().node_count() > most_nodes_to_factor)
            return;
        yardstick_.emplace(scene, centred_solution);
        backend_ = yardstick_->best();
    }

    /// Takes a sample of work that returns a result.
    void take(const std::function<Result()> &work) {
        reset_peak_memory();
        const Time time = timed([&] { last_ = work(); });
        peak_ = std::max(peak_, peak_memory());
        cpu_.push_back(time.cpu);
        wall_.push_back(time.wall);
        if (last_.status != Status::converged)
            status_ = status_name(last_.status);
        if (yardstick_)
            factor_.push_back(yardstick_->run(backend_));
    }
    /// Whether the next sample would try one's patience.
    [[nodiscard]] bool is_enough(std::size_t wished) const {
        double spent = 0;
        for (const double seconds : wall_)
            spent += seconds;
        return cpu_.size() >= wished || spent > patience;
    }

    [[nodiscard]] const Result &last() const { return last_; }

    /// Fills in the counters and returns the label.
    std::string report(Counters &counters) const {
        const Spread cpu = spread(cpu_);
        counters["nodes"] = static_cast<double>(last_.nodes.rows());
        counters["samples"] = static_cast<double>(cpu_.size());
        counters["seconds"] = cpu.median;
        counters["seconds_min"] = cpu.least;
        counters["seconds_max"] = cpu.most;
        counters["wall_seconds"] = spread(wall_).median;
        counters["iterations"] = static_cast<double>(last_.iterations);
        counters["residual"] = last_.residual;
        counters["position_error"] = last_.position_error;
        counters["rise"] = rise(last_.nodes);
        counters["peak_megabytes"] = peak_;
        if (yardstick_) {
            const auto median = [this](auto part) {
                std::vector<double> values;
                for (const auto &times : factor_)
                    values.push_back(part(times));
                return spread(values).median;
            };
            counters["F_seconds"] = median([](const FactorTimes &times) { return times.total(); });
            counters["F_analyse"] = median([](const FactorTimes &times) { return times.analyse; });
            counters["F_factorise"] = median([](const FactorTimes &times) { return times.factorise; });
            counters["F_solve"] = median([](const FactorTimes &times) { return times.solve; });
            counters["ratio"] = cpu.median / counters["F_seconds"];
        }
        return status_ + " " + backend_;
    }

private:
    std::optional<Yardstick> yardstick_;
    std::string backend_;
    std::vector<double> cpu_, wall_;
    std::vector<FactorTimes> factor_;
    double peak_ = 0;
    Result last_;
    std::string status_ = "converged";
};

void add_cold(const std::string &scene_name, Index node_count, const std::map<std::string, double> &targets) {
    add(name("cold", scene_name, node_count), [=](Counters &counters) {
        ScenePtr scene;
        counters["setup_seconds"] =
            timed([&] { scene = make_scene(scene_name, make_net(scene_name, node_count)); }).cpu;
        const bool is_factored = node_count <= most_nodes_to_factor;
        Samples samples(scene, is_factored ? solution(scene_name, node_count) : Points());
        do
            samples.take([&] { return solve(scene, options()); });
        while (!samples.is_enough(most_samples));
        for (const auto &[target, value] : targets)
            counters[target] = value;
        return samples.report(counters);
    });
}

/// Goes on from a solution when weights change to and fro by a factor.
void add_warm(const std::string &kind, const std::string &scene_name, Index node_count, double factor,
              const SolveOptions &wished, std::size_t steps, const std::map<std::string, double> &targets) {
    add(name(kind, scene_name, node_count), [=](Counters &counters) {
        const auto net = make_net(scene_name, node_count);
        const auto lighter = make_scene(scene_name, net);
        ScenePtr heavier;
        counters["setup_seconds"] = timed([&] { heavier = make_scene(scene_name, net, factor); }).cpu;
        const Result cold = solve(lighter, options());
        Samples samples(lighter, cold.centred_nodes);
        SolveOptions going_on = wished;
        going_on.start = cold.nodes;
        Solver solver(lighter, going_on);
        solver.advance();
        bool is_heavier = false;
        do {
            is_heavier = !is_heavier;
            samples.take([&] {
                solver.replace(is_heavier ? heavier : lighter);
                solver.advance();
                return solver.result();
            });
        } while (!samples.is_enough(steps));
        for (const auto &[target, value] : targets)
            counters[target] = value;
        return samples.report(counters);
    });
}

/// The relaxation against the automatic choice, both to an accuracy at which their shapes must agree. The
/// ratio is that of their times.
void add_relaxation(Index node_count) {
    constexpr double fine_accuracy = 2e-9; // [m]
    constexpr double same_shape = 1e-8;    // [m]
    add(name("relaxation", "C", node_count), [=](Counters &counters) {
        const auto scene = make_scene("C", make_net("C", node_count));
        SolveOptions relaxed = options(fine_accuracy);
        relaxed.method = Method::relaxation;
        relaxed.max_seconds = 2 * longest_solve;
        Result result;
        Result slow;
        std::vector<double> seconds;
        for (std::size_t k = 0; k < most_samples; ++k)
            seconds.push_back(timed([&] { result = solve(scene, options(fine_accuracy)); }).cpu);
        const Time relaxation = timed([&] { slow = solve(scene, relaxed); });
        counters["nodes"] = scene->net().node_count();
        counters["samples"] = 1;
        counters["seconds"] = relaxation.cpu;
        counters["wall_seconds"] = relaxation.wall;
        counters["ratio"] = spread(seconds).median / relaxation.cpu;
        counters["target_ratio"] = 0.01;
        counters["iterations"] = static_cast<double>(slow.iterations);
        counters["residual"] = slow.residual;
        counters["position_error"] = slow.position_error;
        counters["rise"] = rise(slow.nodes);
        counters["shape_distance"] = (slow.nodes - result.nodes).rowwise().norm().maxCoeff();
        counters["target_shape_distance"] = same_shape;
        return std::string(status_name(result.status == Status::converged ? slow.status : result.status));
    });
}

/// Rises that another code has found, to the digits that it gives.
void add_rise(const std::string &scene_name, Index side, double reference) {
    constexpr double fine_accuracy = 1e-8;
    constexpr double last_digit = 5e-7;
    add(name("rise", scene_name, side * side), [=](Counters &counters) {
        const auto scene = make_scene(scene_name, make_net(scene_name, side * side));
        const Result result = solve(scene, options(fine_accuracy));
        counters["nodes"] = scene->net().node_count();
        counters["rise"] = rise(result.nodes);
        counters["rise_error"] = std::abs(rise(result.nodes) - reference);
        counters["target_rise_error"] = last_digit;
        counters["residual"] = result.residual;
        counters["position_error"] = result.position_error;
        counters["iterations"] = static_cast<double>(result.iterations);
        return std::string(status_name(result.status));
    });
}

void add_factorisations(const std::string &scene_name, Index node_count) {
    for (const auto &backend : Yardstick::backends())
        add(name("factor", scene_name, node_count) + "/" + backend, [=](Counters &counters) {
            const auto scene = make_scene(scene_name, make_net(scene_name, node_count));
            const Yardstick yardstick(scene, solution(scene_name, node_count));
            std::vector<double> totals, analyse, factorise, solve;
            reset_peak_memory();
            double residual = 0;
            for (std::size_t k = 0; k < most_samples; ++k) {
                const FactorTimes times = yardstick.run(backend);
                totals.push_back(times.total());
                analyse.push_back(times.analyse);
                factorise.push_back(times.factorise);
                solve.push_back(times.solve);
                residual = std::max(residual, times.residual);
            }
            const Spread total = spread(totals);
            counters["nodes"] = scene->net().node_count();
            counters["samples"] = static_cast<double>(totals.size());
            counters["seconds"] = total.median;
            counters["seconds_min"] = total.least;
            counters["seconds_max"] = total.most;
            counters["F_seconds"] = total.median;
            counters["F_analyse"] = spread(analyse).median;
            counters["F_factorise"] = spread(factorise).median;
            counters["F_solve"] = spread(solve).median;
            counters["residual"] = residual;
            counters["peak_megabytes"] = peak_memory();
            return (std::isfinite(residual) ? "measured " : "failed ") + backend;
        });
}

} // namespace

void register_solves(Extent extent) {
    const std::string ratio = "target_ratio";
    const SolveOptions position_only = options(accuracy, any_residual);
    const std::map<std::string, double> frame{{"target_seconds", 16e-3}};
    add_rise("S", 21, 1.486945);
    add_rise("C", 21, 5.529614);
    if (extent == Extent::tiny) {
        for (const char *scene : {"S", "C", "S100", "S_bare", "S_gap", "D", "T"})
            add_cold(scene, 101, {});
        add_warm("warm", "S", 121, 1.05, position_only, 2, {});
        add_factorisations("S", 121);
        return;
    }
    add_rise("S", 51, 1.487065);
    add_rise("C", 51, 5.887808);
    add_rise("S", 101, 1.487083);
    add_rise("C", 101, 6.131784);

    for (const Index side : {21, 51})
        for (const char *scene : {"S", "C", "S100", "S_bare", "S_gap", "D", "T"})
            add_cold(scene, side * side, {});
    const std::map<std::string, std::array<double, 2>> most_ratios{
        {"S", {0.7, 0.35}}, {"C", {0.7, 0.35}}, {"S100", {2, 2}}, {"S_bare", {4, 4}},
        {"S_gap", {4, 4}},  {"D", {4, 4}},      {"T", {4, 4}}};
    for (const auto &[scene, most] : most_ratios)
        add_cold(scene, 101 * 101, {{ratio, most[0]}});
    for (const char *scene : {"S", "C", "D"}) {
        add_warm("warm", scene, 101 * 101, 1.05, position_only, most_samples, {{ratio, 0.25}});
        add_warm("warm_balanced", scene, 101 * 101, 1.05, options(), most_samples, {{ratio, 0.25}});
    }
    add_warm("drag", "S", 50 * 50, 1.01, options(drag_accuracy, any_residual), drag_steps, frame);
    add_warm("drag_balanced", "S", 50 * 50, 1.01, options(drag_accuracy), drag_steps, frame);
    for (const char *scene : {"S", "C", "D", "T"})
        add_factorisations(scene, 101 * 101);
    if (extent == Extent::quick)
        return;

    for (const auto &[scene, most] : most_ratios)
        add_cold(scene, 201 * 201, {{ratio, most[1]}});
    for (const Index side : {317, 563})
        add_cold("S", side * side, {});
    add_cold("S", 1001 * 1001, {{"target_seconds", 30}, {"target_peak_megabytes", 3000}});
    for (const char *scene : {"S", "C", "D", "T"})
        add_factorisations(scene, 201 * 201);
    add_relaxation(51 * 51);
}

} // namespace funicular::bench
