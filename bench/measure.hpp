// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Time and memory of this process.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace funicular::bench {

struct Time {
    double cpu = 0;  ///< [s] of all threads: what other processes take does not count
    double wall = 0; ///< [s]
};
[[nodiscard]] Time timed(const std::function<void()> &work);

/// Of a few values the smallest, the middle one and the largest.
struct Spread {
    double least = 0, median = 0, most = 0;
};
/// \pre values is not empty
[[nodiscard]] Spread spread(std::vector<double> values);

/// Forgets the largest memory so far, where the system lets us.
void reset_peak_memory();
/// The most memory that was resident since it was last forgotten [MB of 10⁶ bytes]; VmHWM.
[[nodiscard]] double peak_memory();
/// Bytes of the heap that are in use.
[[nodiscard]] std::size_t live_heap();

} // namespace funicular::bench
