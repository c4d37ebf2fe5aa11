// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>

/// The programs that stand between Carom and engines for Node.
namespace carom::subjects {

/// Names a folder that has the adapters, and the packages that they import.
inline constexpr const char* adapters_variable = "CAROM_ENGINES";

/// Where the adapters are.
struct Adapters {
  std::filesystem::path directory;  // empty where there is none
  bool is_chosen = false;           // by the environment
};

/// Those of the folder that the environment names; else the nearest `share/carom/npm` above this program, which is that
/// of its prefix, wherever that was moved to, or of its build.
[[nodiscard]] Adapters find_adapters();

/// Why the adapter of this name, which imports this npm package, cannot be run, and what to type; empty where it can.
[[nodiscard]] std::string why_absent(const Adapters& adapters, const std::string& adapter, const std::string& package);

/// Where this program stands; empty where the system does not tell.
[[nodiscard]] std::filesystem::path program_directory();

}  // namespace carom::subjects
