// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace carom::benchmarks {

/// Repeated measurements of one quantity. Repetitions of different benchmarks alternate. So the median tolerates a
/// machine that is busy during less than half of the repetitions.
struct Measurement {
  std::vector<double> nanoseconds;  // per iteration

  [[nodiscard]] double median() const;
  /// Half the interquartile range divided by the median.
  [[nodiscard]] double spread() const;
};

/// Keeps Google Benchmark's measurements by name, and shows progress as dots.
class Recorder : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  [[nodiscard]] bool has(const std::string& name) const { return measurements_.contains(name); }
  /// Precondition: has(name).
  [[nodiscard]] const Measurement& at(const std::string& name) const { return measurements_.at(name); }

 private:
  std::map<std::string, Measurement> measurements_;
};

}  // namespace carom::benchmarks
