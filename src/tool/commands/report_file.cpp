// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/report_file.hpp"

#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>

#include "commands/commands.hpp"

namespace carom::tool {

nlohmann::json report_from(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw UsageError(fmt::format("{}: cannot be read", file));
  }
  try {
    return parse_json(std::string(std::istreambuf_iterator<char>(stream), {}));
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace carom::tool
