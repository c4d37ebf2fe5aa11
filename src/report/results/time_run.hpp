// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/collision/stepper.hpp>
#include <carom/properties/phenomena/claims.hpp>
#include <carom/properties/phenomena/measure.hpp>
#include <carom/properties/phenomena/relations.hpp>
#include <carom/report/results/run.hpp>

/// The results of `carom time` as one value.
namespace carom::report {

struct JudgedClaim {
  std::string claim;  // as the engine says it
  properties::ClaimVerdict verdict;
  bool is_judged = true;  // otherwise `why` says why not
};

struct TimedEngine {
  std::string name;
  std::string version;
  Precision precision = Precision::binary64;
  std::string absent = {};  // why it could not run; empty if it could
  std::vector<properties::Measurement> measurements = {};
  std::vector<properties::RelationResult> relations = {};
  std::vector<JudgedClaim> claims = {};
  double seconds = 0;              // of wall time
  std::string specification = {};  // "exec:PROGRAM ARG…"; empty for a built-in engine

  /// Whether it answered a run.
  [[nodiscard]] bool is_measured() const;
  /// Whether it crashed, hung or wrote no reply.
  [[nodiscard]] bool has_failed() const;
};

struct TimeRun {
  Environment environment;
  properties::Ladder ladder;
  std::vector<TimedEngine> engines;
  bool are_named = false;  // whether the user named the engines, so that each has to answer
  bool interrupted = false;

  /// 2 if no engine was measured, if an engine that was named was not, if an engine has claims and none was judged, or
  /// if the run was interrupted. Otherwise 1 if a claim is not kept, or if a run of an engine that was named failed.
  /// Otherwise 0.
  [[nodiscard]] int exit_status() const;
};

/// The measurement of a phenomenon; nullptr if there is none.
[[nodiscard]] const properties::Measurement* measurement_of(const TimedEngine& engine, std::string_view phenomenon);

/// The rung at this step; nullptr if the reading has none.
[[nodiscard]] const properties::Rung* rung_at(const properties::MeasuredReading& reading, double step);

/// The reading whose median error at this step is the greatest, of those that were read at the most steps; nullptr if
/// there is none. An error that rounding explains is less than one that it does not.
[[nodiscard]] const properties::MeasuredReading* worst_reading(const properties::Measurement& measurement, double step);

/// The step of the ladder that is nearest to 1/60 s, at which engines are compared.
[[nodiscard]] double compared_step(const properties::Ladder& ladder);

/// time.json (docs/reference/schemas/time.schema.json).
[[nodiscard]] nlohmann::json time_record(const TimeRun& run);

}  // namespace carom::report
