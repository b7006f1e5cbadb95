// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure.hpp"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string>

namespace funicular::bench {

namespace {

double seconds_on(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

Time timed(const std::function<void()> &work) {
    const double wall = seconds_on(CLOCK_MONOTONIC);
    const double cpu = seconds_on(CLOCK_PROCESS_CPUTIME_ID);
    work();
    return {.cpu = seconds_on(CLOCK_PROCESS_CPUTIME_ID) - cpu, .wall = seconds_on(CLOCK_MONOTONIC) - wall};
}

Spread spread(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    return {.least = values.front(), .median = median, .most = values.back()};
}

void reset_peak_memory() {
    // Pages that the allocator merely keeps would count as this solve's.
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

double peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:") {
            double kibibytes = 0;
            status >> kibibytes;
            return kibibytes * 1024e-6;
        }
    return 0;
}

std::size_t live_heap() {
    // Large blocks are mapped and counted apart.
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

} // namespace funicular::bench
