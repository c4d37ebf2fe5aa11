// SPDX-License-Identifier: BSL-1.0
#include "io/report_file.hpp"

#include <filesystem>

#include <fmt/format.h>

#include <carom/report/results/words.hpp>

#include "io/json_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

namespace fs = std::filesystem;

/// The result of `read` for the content of the file. An error message about the format starts with the file's name and
/// `is_no`.
template <class Read>
auto read_from(const std::string& file, const char* is_no, const Read& read) {
  const std::string content = content_of_file(file);
  nlohmann::json record;
  try {
    record = parse_json(content);
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", report::shown(file), report::shown(error.what())));
  }
  try {
    return read(record);
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}{}", report::shown(file), is_no, report::shown(error.what())));
  }
}

}  // namespace

report::RecordedRun read_report(const std::string& file_or_directory) {
  std::error_code ignored;
  const std::string file = fs::is_directory(file_or_directory, ignored)
                               ? (fs::path(file_or_directory) / "report.json").string()
                               : file_or_directory;
  return read_from(file, "this is not a report.json of `carom gate --out`: ", [&](const nlohmann::json& record) {
    return report::recorded_run(record, file);
  });
}

report::ReadShard read_shard(const std::string& directory) {
  const std::string file = (fs::path(directory) / "report.json").string();
  report::ReadShard shard =
      read_from(file, "", [&](const nlohmann::json& record) { return report::shard_from(record, file); });
  for (properties::SubjectResult& result : shard.run.results) {
    for (properties::Witness& witness : result.witnesses) {
      // The path in the report is not used, because it could lead to any file.
      const fs::path path = report::witness_path(directory, result.subject, *witness.invariant);
      witness = read_from(path.string(), "", [&](const nlohmann::json& record) {
        return report::witness_from(record, *witness.invariant);
      });
    }
  }
  return shard;
}

}  // namespace carom::tool
