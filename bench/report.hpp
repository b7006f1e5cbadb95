// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace funicular::bench {

/// Writes one line of CSV for every benchmark, and says on `progress` how far it has come.
///
/// A benchmark is named kind/scene/nodes. Its label is its status, "converged" or "measured" if all is well,
/// and the factorisation that made F where there is one. Its numbers are its counters, under the names of the
/// columns; one called target_X is the most that X may be.
class CsvReporter : public benchmark::BenchmarkReporter {
public:
    CsvReporter(std::ostream &csv, std::ostream &progress);

    bool ReportContext(const Context &context) override;
    /// \throws std::logic_error for a counter that no column is named after.
    void ReportRuns(const std::vector<Run> &runs) override;
    /// Adds the growth of cost with the number of nodes, fitted to what was measured.
    void Finalize() override;

    /// Whether every solve converged and every factorisation was made.
    [[nodiscard]] bool all_well() const { return all_well_; }

private:
    using Numbers = std::map<std::string, double>;
    void write(const std::string &name, const std::string &label, const Numbers &numbers);

    std::ostream &csv_;
    std::ostream &progress_;
    bool all_well_ = true;
    std::map<double, double> seconds_of_large_sheets_; ///< by number of nodes
};

} // namespace funicular::bench
