// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/oracles/judge/coulomb_case.hpp>
#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/gate/gate.hpp>

#include "compare/comparison.hpp"
#include "report/environment.hpp"

/// The JSON records that the program writes.
namespace carom::tool {

/// An outcome as numbers; what is not a binary64 number as a string with 21 digits.
[[nodiscard]] nlohmann::json outcome_record(const ReportedOutcome& outcome);

/// An outcome, {"refused": why} or {"skipped": why}.
[[nodiscard]] nlohmann::json answer_record(const Answer& answer);

/// The exact truth of one model: velocities, impulse and energy change as strings "p/q", and under `nearest` the
/// velocities as binary64.
[[nodiscard]] nlohmann::json truth_record(const oracles::ExactCase& exact_case, Model model);

/// All answers of the law `coulomb`: how each ends, whether it is exact, and under `nearest` its velocities as
/// binary64; the exact ones as those of a truth besides.
[[nodiscard]] nlohmann::json answers_record(std::span<const oracles::CoulombAnswer> answers);

/// What outcomes were judged by.
[[nodiscard]] nlohmann::json yardstick_record(const oracles::Yardstick& yardstick);

/// How many valid cases were not judged, by reason.
[[nodiscard]] nlohmann::json unjudged_record(const properties::UnjudgedCounts& counts);

/// "holds", "violated" or "skipped", with both sides of the formula where violated.
[[nodiscard]] nlohmann::json verdict_record(const properties::Verdict& verdict);

/// A witness as one file.
[[nodiscard]] nlohmann::json witness_record(const properties::Witness& witness, const Subject& subject,
                                            const properties::GateOptions& options,
                                            const std::filesystem::path& witness_file);

/// "violated"; else "error" where it could not be judged to the end, "not judged" where too little could be posed to
/// it; else "sound".
[[nodiscard]] std::string status_of(const properties::SubjectResult& result);

/// report.json. `counts` says of each subject whether it counts towards the exit status.
struct GateRun {
  properties::GateReport report;
  std::vector<bool> counts;
  std::vector<Subject> absent;  // asked for, or part of the default, and not installed
  Environment environment;
  std::vector<properties::diagnosis::Diagnosis> diagnoses = {};  // of each result, as diagnose_all gives them; or none
  std::vector<std::string> deviates = {};                        // what the command line has no subject claim
  bool is_shard = false;                                         // of a run whose shards are to be merged
  std::optional<compare::Comparison> baseline = {};              // of this run with an earlier one
  /// 2 something that counts could not be judged at all, nothing counts, or the run was interrupted; else 1 something
  /// is violated or could not be judged to the end; 0 all hold. Where there is a baseline, what is known from it is not
  /// counted.
  [[nodiscard]] int exit_status() const;
};

[[nodiscard]] nlohmann::json report_record(const GateRun& run);

/// A subject's name as part of a file's.
[[nodiscard]] std::string file_name_of(std::string name);

/// Where a witness is written: DIRECTORY/witnesses/SUBJECT.INVARIANT.json.
[[nodiscard]] std::filesystem::path witness_path(const std::filesystem::path& directory, const Subject& subject,
                                                 const properties::Witness& witness);

/// What to type in a POSIX shell to replay the witness in that file with the same verdict.
[[nodiscard]] std::string replay_command(const std::filesystem::path& witness_file, const Subject& subject,
                                         const oracles::Yardstick& yardstick);

}  // namespace carom::tool
