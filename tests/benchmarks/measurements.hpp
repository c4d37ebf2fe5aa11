// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace carom::benchmarks {

/// Repeated measurements of one thing, of which the median stands for it: interleaved with all others, it forgives a
/// machine that is busy for less than half of the repetitions.
struct Measurement {
  std::vector<double> nanoseconds;  // an iteration of any thread

  [[nodiscard]] double median() const;
  /// Half the distance between the quartiles over the median.
  [[nodiscard]] double spread() const;
};

/// Keeps what Google Benchmark measures, by name, and shows its progress as dots.
class Recorder : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  /// Whether this was measured at all: --benchmark_filter may have left it out.
  [[nodiscard]] bool has(const std::string& name) const { return measurements_.contains(name); }
  /// Precondition: has(name).
  [[nodiscard]] const Measurement& at(const std::string& name) const { return measurements_.at(name); }

 private:
  std::map<std::string, Measurement> measurements_;
};

}  // namespace carom::benchmarks
