// SPDX-License-Identifier: BSL-1.0
#include "commands/report_file.hpp"

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>

#include "commands/commands.hpp"
#include "commands/json_file.hpp"

namespace carom::tool {

nlohmann::json report_from(const std::string& file) {
  try {
    return parse_json(content_of_file(file));
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace carom::tool
