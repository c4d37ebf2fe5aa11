// SPDX-License-Identifier: BSL-1.0
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "commands/output_file.hpp"
#include "commands/report_file.hpp"
#include "report/badge.hpp"

namespace carom::tool {

int badge(const std::string& file, const std::string& out) {
  const nlohmann::json report = report_from(file);
  std::string record;
  try {
    record = badge_record(overall_of(report)).dump() + '\n';
  } catch (const nlohmann::json::exception& error) {
    throw UsageError(fmt::format("{}: is not a report.json of carom gate: {}", file, error.what()));
  }
  if (out.empty()) {
    fmt::print("{}", record);
  } else {
    write_file(out, record);
  }
  return exit_all_hold;
}

}  // namespace carom::tool
