// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>

#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/gate/gate_report.hpp>
#include <carom/report/model/archive.hpp>

/// Answers, truths and verdicts as JSON.
namespace carom::report {

/// An outcome is written as numbers. A number that binary64 cannot represent is a string with 21 digits. Any other
/// answer is {"refused": why}, {"skipped": why} or {"failed": why, "said": …}.
template <>
struct Json<Answer> {
  static nlohmann::json write(const Answer& answer);
  static Answer read(const Field& field, Reading reading);
};

/// "holds", "violated" or "skipped". A violation has both sides of the formula. `read` takes only violations.
template <>
struct Json<properties::Verdict> {
  static nlohmann::json write(const properties::Verdict& verdict);
  static properties::Verdict read(const Field& field, Reading reading);
};

template <>
struct Json<oracles::Limits> {
  static nlohmann::json write(const oracles::Limits& limits);
  static oracles::Limits read(const Field& field, Reading reading);
};

template <>
struct Json<properties::UnjudgedCounts> {
  static nlohmann::json write(const properties::UnjudgedCounts& counts);
  static properties::UnjudgedCounts read(const Field& field, Reading reading);
};

/// The exact outcome under one law: velocities and impulse as strings "p/q", and the velocities as binary64 under
/// `nearest`.
[[nodiscard]] nlohmann::json truth_record(const oracles::ExactCase& exact_case, Law law);

/// All answers of the law `coulomb`: the kind of each, whether it is exact, and its velocities as binary64 under
/// `nearest`. An exact answer also has the other fields of truth_record.
[[nodiscard]] nlohmann::json answers_record(std::span<const oracles::CoulombAnswer> answers);

}  // namespace carom::report
