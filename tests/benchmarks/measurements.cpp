// SPDX-License-Identifier: BSL-1.0
#include "measurements.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace carom::benchmarks {
namespace {

/// Precondition: there is at least one number.
double quantile(std::vector<double> numbers, double share) {
  std::sort(numbers.begin(), numbers.end());
  const double place = share * static_cast<double>(numbers.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const auto above = std::min(below + 1, numbers.size() - 1);
  return std::lerp(numbers[below], numbers[above], place - std::floor(place));
}

}  // namespace

double Measurement::median() const { return quantile(nanoseconds, 0.5); }

double Measurement::spread() const {
  return (quantile(nanoseconds, 0.75) - quantile(nanoseconds, 0.25)) / 2 / median();
}

bool Recorder::ReportContext(const Context&) { return true; }

void Recorder::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
      // Benchmarks of threads ask for real time. Their iteration count is the sum over the threads.
      const bool by_the_wall = run.run_name.time_type == "real_time";
      const double seconds = by_the_wall ? run.real_accumulated_time : run.cpu_accumulated_time;
      // function_name omits suffixes that Google Benchmark adds.
      measurements_[run.run_name.function_name].nanoseconds.push_back(seconds * 1e9 /
                                                                      static_cast<double>(run.iterations));
    }
  }
  GetErrorStream() << '.' << std::flush;
}

}  // namespace carom::benchmarks
