// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <carom/report/model/archive.hpp>
#include <carom/report/model/run.hpp>

/// report.json and the files of witnesses: written and read by the same functions.
namespace carom::report {

[[nodiscard]] nlohmann::json environment_record(const Environment& environment);

/// report.json, as docs/reference/schemas/report.schema.json has it.
[[nodiscard]] nlohmann::json report_record(const Run& run);

/// The run that report_record wrote, as far as a comparison needs it: fields of a subject's single families that it
/// does not need may be missing, and families and invariants may be unknown. Throws FormatError, which names the place,
/// if something is missing or of another type, or a subject or a family stands there twice.
[[nodiscard]] Run run_from(const nlohmann::json& record);

/// A shard as the gate's report that it was, but for its witnesses.
struct ReadShard {
  std::string file;
  Run run;                        // without `sampled`, and without the witnesses
  properties::GateReport report;  // without the witnesses of run.subjects[…].violations
};

/// Throws FormatError also if the report is of no shard or of another version of Carom, or the run was interrupted.
[[nodiscard]] ReadShard shard_from(const nlohmann::json& record, const std::string& file);

/// A witness as one file, with what replays it.
[[nodiscard]] nlohmann::json witness_record(const properties::Witness& witness, const Subject& subject,
                                            const Settings& settings, const std::string& witness_file);

/// What witness_record wrote. Throws FormatError, also if it is of another invariant.
[[nodiscard]] properties::Witness witness_from(const nlohmann::json& record, const std::string& invariant);

}  // namespace carom::report
