// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <carom/report/results/archive.hpp>
#include <carom/report/results/run.hpp>

/// Writes and reads report.json and the files of witnesses, with the same functions for both.
namespace carom::report {

[[nodiscard]] nlohmann::json environment_record(const Environment& environment);

/// The report.json that docs/reference/schemas/report.schema.json describes.
[[nodiscard]] nlohmann::json report_record(const Run& run);

/// Reads a report. Fields that it does not need may be missing. Throws FormatError that names the place if a field is
/// missing or has another type, or if a subject or a family occurs twice.
[[nodiscard]] RecordedRun recorded_run(const nlohmann::json& record, const std::string& file);

/// A shard that was read, without samples and diagnoses. Each witness has only its invariant, family and number.
struct ReadShard {
  std::string file;
  Run run;
};

/// Throws FormatError, also if the report is no shard, is of another version of Carom, or was interrupted.
[[nodiscard]] ReadShard shard_from(const nlohmann::json& record, const std::string& file);

/// A witness as one file, with the command that replays it.
[[nodiscard]] nlohmann::json witness_record(const properties::Witness& witness, const Subject& subject,
                                            const properties::GateOptions& options, const std::string& witness_file);

/// Reads what witness_record wrote. Throws FormatError, also if the witness violates another invariant than
/// `invariant`.
[[nodiscard]] properties::Witness witness_from(const nlohmann::json& record, const properties::Invariant& invariant);

}  // namespace carom::report
