// SPDX-License-Identifier: LGPL-2.1-or-later
#include "report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace funicular::bench {

namespace {

constexpr std::array columns{"nodes",
                             "samples",
                             "seconds",
                             "seconds_min",
                             "seconds_max",
                             "wall_seconds",
                             "setup_seconds",
                             "F_seconds",
                             "F_analyse",
                             "F_factorise",
                             "F_solve",
                             "ratio",
                             "iterations",
                             "residual",
                             "position_error",
                             "peak_megabytes",
                             "rise",
                             "rise_error",
                             "shape_distance",
                             "growth",
                             "ns_per_node",
                             "bytes_per_node",
                             "target_seconds",
                             "target_ratio",
                             "target_peak_megabytes",
                             "target_growth",
                             "target_rise_error",
                             "target_shape_distance"};
constexpr std::string_view target = "target_";

// The growth is asked for from 10⁴ nodes on and to 10⁶.
constexpr double least_nodes_of_growth = 9'500;
constexpr double nodes_to_grow_to = 950'000;
constexpr double most_growth = 1.15;

/// Whether a benchmark came to its end: a solve to convergence, any other to its numbers.
bool is_well(const std::string &status) {
    return status == "converged" || status == "measured";
}

/// "yes" or "no" where there is something to meet, else nothing.
std::string is_met(const std::string &status, const std::map<std::string, double> &numbers) {
    bool has_target = false;
    bool met = is_well(status);
    for (const auto &[name, most] : numbers)
        if (name.starts_with(target)) {
            has_target = true;
            const auto measured = numbers.find(name.substr(target.size()));
            met = met && measured != numbers.end() && measured->second <= most;
        }
    return !has_target ? "" : met ? "yes" : "no";
}

/// Least squares through (log x, log y).
double slope_of_logarithms(const std::map<double, double> &points) {
    double x_mean = 0;
    double y_mean = 0;
    for (const auto &[x, y] : points) {
        x_mean += std::log(x) / static_cast<double>(points.size());
        y_mean += std::log(y) / static_cast<double>(points.size());
    }
    double xy = 0;
    double xx = 0;
    for (const auto &[x, y] : points) {
        xy += (std::log(x) - x_mean) * (std::log(y) - y_mean);
        xx += (std::log(x) - x_mean) * (std::log(x) - x_mean);
    }
    return xy / xx;
}

} // namespace

CsvReporter::CsvReporter(std::ostream &csv, std::ostream &progress) : csv_(csv), progress_(progress) {
    SetErrorStream(&progress);
    csv_ << "kind,scene,backend,status,met";
    for (const char *column : columns)
        csv_ << ',' << column;
    csv_ << std::endl;
}

bool CsvReporter::ReportContext(const Context &context) {
    PrintBasicContext(&progress_, context);
    return true;
}

void CsvReporter::write(const std::string &name, const std::string &label, const Numbers &numbers) {
    for (const auto &[counter, value] : numbers)
        if (std::find(columns.begin(), columns.end(), counter) == columns.end())
            throw std::logic_error("no column is named after the counter '" + counter + "'");

    std::string kind, scene, status, backend;
    std::istringstream words(name);
    std::getline(words, kind, '/');
    std::getline(words, scene, '/');
    std::istringstream(label) >> status >> backend;
    all_well_ = all_well_ && is_well(status);
    const std::string met = is_met(status, numbers);
    // Everything is written at once and flushed, so that a run that is broken off leaves what it has.
    csv_ << kind << ',' << scene << ',' << backend << ',' << status << ',' << met << std::setprecision(10);
    for (const char *column : columns) {
        csv_ << ',';
        if (const auto found = numbers.find(column); found != numbers.end())
            csv_ << found->second;
    }
    csv_ << std::endl;

    progress_ << name << ": " << label << std::setprecision(4);
    for (const char *told : {"seconds", "F_seconds", "ratio", "growth", "ns_per_node", "bytes_per_node"})
        if (const auto found = numbers.find(told); found != numbers.end())
            progress_ << ", " << told << ' ' << found->second;
    progress_ << (met.empty() ? "" : met == "yes" ? " (target met)" : " (target missed)") << std::endl;
}

void CsvReporter::ReportRuns(const std::vector<Run> &runs) {
    for (const Run &run : runs) {
        if (run.run_type != Run::RT_Iteration)
            continue;
        Numbers numbers;
        for (const auto &[name, counter] : run.counters)
            numbers[name] = counter.value;
        const std::string name = run.run_name.function_name;
        write(name, run.report_label, numbers);
        if (name.starts_with("cold/S/") && numbers.at("nodes") >= least_nodes_of_growth)
            seconds_of_large_sheets_[numbers.at("nodes")] = run.report_label.starts_with("converged")
                                                                ? numbers.at("seconds")
                                                                : std::numeric_limits<double>::quiet_NaN();
    }
}

void CsvReporter::Finalize() {
    if (seconds_of_large_sheets_.size() < 2)
        return;
    const double largest = seconds_of_large_sheets_.rbegin()->first;
    const double growth = slope_of_logarithms(seconds_of_large_sheets_);
    Numbers numbers{{"nodes", largest}, {"growth", growth}};
    if (largest >= nodes_to_grow_to)
        numbers["target_growth"] = most_growth;
    write("growth/S/", std::isfinite(growth) ? "measured" : "incomplete", numbers);
}

} // namespace funicular::bench
