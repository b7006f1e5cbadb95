// SPDX-License-Identifier: LGPL-2.1-or-later
//
// core_bench --versions
// core_bench [--extent=tiny|quick|full] [--csv=FILE] [Google Benchmark's own options, as
// --benchmark_filter=…]
#include "report.hpp"
#include "solves.hpp"

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#ifdef FUNICULAR_BENCH_CHOLMOD
#include <cholmod.h>
#endif

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

using funicular::bench::Extent;

/// A BLAS and OpenMP read how many threads to use before main begins, so that the process starts itself anew.
void run_on_one_thread(char **arguments) {
    if (std::getenv("FUNICULAR_BENCH_ONE_THREAD"))
        return;
    for (const char *variable : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "OMP_THREAD_LIMIT",
                                 "MKL_NUM_THREADS", "FUNICULAR_BENCH_ONE_THREAD"})
        setenv(variable, "1", 1);
    execv(std::filesystem::read_symlink("/proc/self/exe").c_str(), arguments);
    std::cerr << "core_bench: cannot start itself anew; a BLAS may use several threads\n";
}

/// The value of an option that is ours, which is taken from the arguments.
std::string taken(std::vector<char *> &arguments, const std::string &option, const std::string &otherwise) {
    std::string value = otherwise;
    const std::string prefix = "--" + option + "=";
    std::erase_if(arguments, [&](const char *argument) {
        const bool is_ours = std::string(argument).starts_with(prefix);
        if (is_ours)
            value = argument + prefix.size();
        return is_ours;
    });
    return value;
}

/// What this was compiled by and with, one a line: name, tabulator, version.
void print_versions() {
#ifdef __clang__
    std::cout << "compiler\tClang " << __clang_version__ << '\n';
#else
    std::cout << "compiler\tGCC " << __VERSION__ << '\n';
#endif
    std::cout << "Eigen\t" << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION
              << '\n';
#ifdef FUNICULAR_BENCH_CHOLMOD
    std::cout << "CHOLMOD\t" << CHOLMOD_MAIN_VERSION << '.' << CHOLMOD_SUB_VERSION << '.'
              << CHOLMOD_SUBSUB_VERSION << '\n';
#else
    std::cout << "CHOLMOD\tnot found\n";
#endif
}

} // namespace

int main(int argc, char **argv) {
    run_on_one_thread(argv);
    std::vector<char *> arguments(argv, argv + argc);
    if (arguments.size() == 2 && arguments[1] == std::string("--versions")) {
        print_versions();
        return 0;
    }
    const std::string extent = taken(arguments, "extent", "full");
    const std::string path = taken(arguments, "csv", "results.csv");
    const std::map<std::string, Extent> extents{
        {"tiny", Extent::tiny}, {"quick", Extent::quick}, {"full", Extent::full}};
    if (extents.count(extent) == 0) {
        std::cerr << "core_bench: --extent is '" << extent << "'; choose tiny, quick or full\n";
        return 2;
    }
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
        return 2;
    std::ofstream csv(path);
    if (!csv) {
        std::cerr << "core_bench: cannot write " << path << '\n';
        return 2;
    }
    funicular::bench::register_solves(extents.at(extent));
    funicular::bench::register_effects(extents.at(extent));
    funicular::bench::CsvReporter reporter(csv, std::cerr);
    if (benchmark::RunSpecifiedBenchmarks(&reporter) == 0)
        return 2;
    return reporter.all_well() ? 0 : 1;
}
