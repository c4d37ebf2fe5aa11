// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>

#include <carom/oracles/judge/coulomb_case.hpp>
#include <carom/properties/gate/gate_result.hpp>
#include <carom/report/model/archive.hpp>

/// Answers, truths and verdicts as JSON.
namespace carom::report {

/// An outcome has numbers; a number that binary64 cannot hold is a string with 21 digits. Any other answer is
/// {"refused": why}, {"skipped": why} or {"failed": why, "said": …}.
template <>
struct Json<Answer> {
  static nlohmann::json write(const Answer& answer);
  static Answer read(const Field& field, Reading reading);
};

/// "holds", "violated" or "skipped", with both sides of the formula if violated. Only violations are read.
template <>
struct Json<properties::Verdict> {
  static nlohmann::json write(const properties::Verdict& verdict);
  static properties::Verdict read(const Field& field, Reading reading);
};

/// The limit that outcomes are judged by.
template <>
struct Json<oracles::Yardstick> {
  static nlohmann::json write(const oracles::Yardstick& yardstick);
  static oracles::Yardstick read(const Field& field, Reading reading);
};

/// By reason.
template <>
struct Json<properties::UnjudgedCounts> {
  static nlohmann::json write(const properties::UnjudgedCounts& counts);
  static properties::UnjudgedCounts read(const Field& field, Reading reading);
};

/// The exact truth of one model: velocities, impulse and energy change as strings "p/q", and under `nearest` the
/// velocities as binary64.
[[nodiscard]] nlohmann::json truth_record(const oracles::ExactCase& exact_case, Model model);

/// All answers of the law `coulomb`: how each ends, whether it is exact, and under `nearest` its velocities as
/// binary64; the exact ones as those of a truth besides.
[[nodiscard]] nlohmann::json answers_record(std::span<const oracles::CoulombAnswer> answers);

}  // namespace carom::report
