// SPDX-License-Identifier: BSL-1.0
#include <cstdlib>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include <carom/collision/json/text.hpp>
#include <carom/subjects/engines/adapters.hpp>

namespace carom::subjects {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none);
}

bool is_on_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? std::string_view() : path;
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const fs::path candidate = fs::path(rest.substr(0, colon)) / program;
    if (access(candidate.c_str(), X_OK) == 0) {
      return true;
    }
    rest = colon == std::string_view::npos ? std::string_view() : rest.substr(colon + 1);
  }
  return false;
}

/// The command that installs the packages of the folder, or of a copy if the folder is not writable.
std::string how_to_install(const fs::path& directory) {
  const std::string quoted = carom::quoted(directory.string());
  if (access(directory.c_str(), W_OK) == 0) {
    return "npm ci --prefix " + quoted;
  }
  return "cp -r " + quoted + " ~/carom-engines && npm ci --prefix ~/carom-engines && export " + adapters_variable +
         "=~/carom-engines";
}

}  // namespace

fs::path program_directory() {
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none).parent_path();
}

Adapters find_adapters() {
  if (const char* const chosen = std::getenv(adapters_variable); chosen != nullptr && *chosen != '\0') {
    return {fs::absolute(chosen).lexically_normal(), true};
  }
  for (fs::path folder = program_directory(); !folder.empty(); folder = folder.parent_path()) {
    const fs::path candidate = folder / "share" / "carom" / "npm";
    if (is_there(candidate)) {
      std::error_code none;
      const fs::path real = fs::canonical(candidate, none);
      return {real.empty() ? candidate : real, false};
    }
    if (folder == folder.root_path()) {
      break;
    }
  }
  return {};
}

std::string why_absent(const Adapters& adapters, const std::string& adapter, const std::string& package) {
  if (adapters.directory.empty()) {
    return std::string("no folder above this program contains share/carom/npm with the adapters; set ") +
           adapters_variable + " to such a folder";
  }
  if (!is_there(adapters.directory / adapter)) {
    return (adapters.directory / adapter).string() + " does not exist" +
           (adapters.is_chosen ? std::string("; check ") + adapters_variable : "");
  }
  if (!is_there(adapters.directory / "node_modules" / package)) {
    return package + " is not installed: " + how_to_install(adapters.directory);
  }
  return is_on_path("node") ? "" : "node is not on PATH: install nodejs";
}

}  // namespace carom::subjects
