// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/report/pictures/measurement.hpp>
#include <carom/report/results/run_json.hpp>

/// The data files of `carom chart`.
namespace carom::report {

struct Measurements {
  Environment environment;
  std::uint64_t seed;
  std::size_t cases;  // of each family, and at each value of a sweep's quantity
  int repetitions;    // of each timing
  double limit_ulps;
  std::vector<MethodMeasurement> methods;
  std::vector<SweepMeasurement> sweeps;
};

/// One line for each method and family.
[[nodiscard]] std::string work_precision_csv(const Measurements& measurements);

/// One line for each method and each value of each sweep's quantity.
[[nodiscard]] std::string stability_csv(const Measurements& measurements);

/// One line for each step of each curve.
[[nodiscard]] std::string deadline_csv(const Measurements& measurements);

[[nodiscard]] nlohmann::json chart_record(const Measurements& measurements);

/// As Markdown: the methods over all families, and the value in each sweep at which each method exceeds the limit.
[[nodiscard]] std::string tables_markdown(const Measurements& measurements);

}  // namespace carom::report
