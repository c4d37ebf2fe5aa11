// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace carom::tool {

/// Where and with what a run was made: what a reader needs to run it again. Empty where the system does not say.
struct Environment {
  std::string date;  // UTC, as ISO 8601 writes it
  std::string compiler;
  std::map<std::string, std::string> compiler_flags;  // by library: what all of its compile lines have
  std::string build_type;
  std::string operating_system;
  std::string kernel;
  std::string processor;
  unsigned processor_threads = 0;
};

/// Of this program, on this machine, now.
[[nodiscard]] Environment this_environment();

[[nodiscard]] nlohmann::json environment_record(const Environment& environment);

}  // namespace carom::tool
