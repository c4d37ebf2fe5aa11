// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/report/results/run_json.hpp>
#include <carom/subjects/protocol/command_line.hpp>

#include "io/this_environment.hpp"
#include "support/program.hpp"

namespace carom::tool {
namespace {

/// Without the names of files, folders and definitions of the precompiled header.
std::multiset<std::string> flags_of(const std::vector<std::string>& words) {
  static const std::set<std::string> followed_by_a_name{"-o", "-c", "-isystem", "-include", "-Xclang"};
  std::multiset<std::string> flags;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (followed_by_a_name.contains(words[k])) {
      ++k;
    } else if (words[k].starts_with('-') && !words[k].starts_with("-I") && words[k] != "-Winvalid-pch") {
      flags.insert(words[k]);
    }
  }
  return flags;
}

/// Some files of a library have flags of their own, so one file must have the recorded ones.
TEST(Environment, RecordsTheFlagsThatEachLibraryWasCompiledWith) {
  if (!std::filesystem::exists(CAROM_COMPILE_COMMANDS)) {
    GTEST_SKIP() << "this generator writes no " << CAROM_COMPILE_COMMANDS;
  }
  const nlohmann::json commands = nlohmann::json::parse(tests::content_of(CAROM_COMPILE_COMMANDS));
  const report::Environment environment = this_environment();
  for (const auto& [library, flags] : environment.compiler_flags) {
    const std::multiset<std::string> recorded = flags_of(subjects::protocol::split_words(flags));
    const std::string folder = "/" + library + ".dir/";
    EXPECT_TRUE(std::any_of(commands.begin(), commands.end(),
                            [&](const nlohmann::json& entry) {
                              const auto command = entry.at("command").get<std::string>();
                              return command.find(folder) != std::string::npos &&
                                     flags_of(subjects::protocol::split_words(command)) == recorded;
                            }))
        << library << ": " << flags;
  }
  for (const char* library : {"carom_batch", "carom_collision_json", "carom_oracles", "carom_properties",
                              "carom_protocol", "carom_rational", "carom_subjects", "carom_tool"}) {
    EXPECT_TRUE(environment.compiler_flags.contains(library)) << library;
  }
}

}  // namespace
}  // namespace carom::tool
