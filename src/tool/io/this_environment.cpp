// SPDX-License-Identifier: BSL-1.0
#include "io/this_environment.hpp"

#include <chrono>
#include <fstream>
#include <sstream>
#include <string_view>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include "io/compiled.hpp"

namespace carom::tool {
namespace {

std::string stripped(const std::string& text, const char* of) {
  const std::size_t first = text.find_first_not_of(of);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(of) - first + 1);
}

std::string single_spaced(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string spaced;
  for (std::string word; words >> word;) {
    spaced += (spaced.empty() ? "" : " ") + word;
  }
  return spaced;
}

/// The value of the first line "KEY SEPARATOR VALUE" of a file, without blanks and quotes around it; empty if there is
/// none.
std::string value_in(const char* file, const std::string& key, char separator) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(separator);
    if (at != std::string::npos && stripped(line.substr(0, at), " \t") == key) {
      return stripped(line.substr(at + 1), " \t\"");
    }
  }
  return {};
}

}  // namespace

report::Environment this_environment() {
  report::Environment environment;
  environment.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                                 fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
  environment.compiler = compiler;
  for (const auto& [library, flags] : compiler_flags) {
    environment.compiler_flags.emplace(library, single_spaced(flags));
  }
  environment.build_type = build_type;
  environment.operating_system = value_in("/etc/os-release", "PRETTY_NAME", '=');
  utsname system{};
  if (uname(&system) == 0) {
    environment.kernel = fmt::format("{} {} {}", system.sysname, system.release, system.machine);
  }
  environment.processor = value_in("/proc/cpuinfo", "model name", ':');
  environment.processor_threads = std::thread::hardware_concurrency();
  return environment;
}

}  // namespace carom::tool
