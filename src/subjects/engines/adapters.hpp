// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <string>

/// The programs that connect Carom to engines for Node.
namespace carom::subjects {

/// The environment variable that names a folder with the adapters and the packages that they import.
inline constexpr const char* adapters_variable = "CAROM_ENGINES";

struct Adapters {
  std::filesystem::path directory;  // empty if there is none
  bool is_chosen = false;           // by the environment variable
};

/// The folder that the environment variable names; otherwise the nearest `share/carom/npm` above this program.
[[nodiscard]] Adapters find_adapters();

/// Why this adapter of an npm package cannot run, and the command that helps; empty if it can run.
[[nodiscard]] std::string why_absent(const Adapters& adapters, const std::string& adapter, const std::string& package);

/// The folder of this program; empty if the system does not provide it.
[[nodiscard]] std::filesystem::path program_directory();

}  // namespace carom::subjects
