// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/report/model/run_json.hpp>
#include <carom/subjects/protocol/command_line.hpp>

#include "io/this_environment.hpp"
#include "support/program.hpp"

namespace carom::tool {
namespace {

struct Flags {
  std::set<std::string> definitions;  // the target's compile definitions, in any order
  std::vector<std::string> others;    // the other flags, in the order of the compile line

  bool operator==(const Flags&) const = default;
};

std::ostream& operator<<(std::ostream& stream, const Flags& flags) {
  for (const std::string& word : flags.definitions) {
    stream << word << ' ';
  }
  stream << '|';
  for (const std::string& word : flags.others) {
    stream << ' ' << word;
  }
  return stream;
}

Flags flags_of(const std::vector<std::string>& words) {
  static const std::set<std::string> followed_by_a_name{"-o", "-c", "-isystem", "-include"};
  Flags flags;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (followed_by_a_name.contains(word) || word == "-Xclang") {
      ++k;
    } else if (word.starts_with("-D")) {
      flags.definitions.insert(word);
    } else if (!word.starts_with("-I") && word != "-Winvalid-pch") {
      flags.others.push_back(word);
    }
  }
  return flags;
}

/// "carom_tool" of "src/tool/CMakeFiles/carom_tool.dir/report/table.cpp.o".
std::string target_of(const std::vector<std::string>& words) {
  const auto option = std::find(words.begin(), words.end(), "-o");
  if (option == words.end() || option + 1 == words.end()) {
    return {};
  }
  const std::string folders = "CMakeFiles/";
  const std::string& object = *(option + 1);
  const std::size_t begin = object.find(folders) + folders.size();
  return object.substr(begin, object.find(".dir/", begin) - begin);
}

Flags common(const Flags& left, const Flags& right) {
  Flags both;
  std::set_intersection(left.definitions.begin(), left.definitions.end(), right.definitions.begin(),
                        right.definitions.end(), std::inserter(both.definitions, both.definitions.end()));
  std::copy_if(left.others.begin(), left.others.end(), std::back_inserter(both.others), [&](const std::string& word) {
    return std::find(right.others.begin(), right.others.end(), word) != right.others.end();
  });
  return both;
}

std::map<std::string, Flags> compiled_flags() {
  std::map<std::string, Flags> all;
  for (const nlohmann::json& entry : nlohmann::json::parse(tests::content_of(CAROM_COMPILE_COMMANDS))) {
    std::vector<std::string> words = subjects::protocol::split_words(entry.at("command").get<std::string>());
    const std::string target = target_of(words);
    // The compile line of a precompiled header has other flags.
    if (words.back().ends_with("cmake_pch.hxx.cxx")) {
      continue;
    }
    words.erase(words.begin());
    const Flags flags = flags_of(words);
    const auto [place, is_first] = all.emplace(target, flags);
    if (!is_first) {
      place->second = common(place->second, flags);
    }
  }
  return all;
}

TEST(Environment, RecordsTheFlagsThatEachLibraryWasCompiledWith) {
  if (!std::filesystem::exists(CAROM_COMPILE_COMMANDS)) {
    GTEST_SKIP() << "this generator writes no " << CAROM_COMPILE_COMMANDS;
  }
  const std::map<std::string, Flags> compiled = compiled_flags();
  const report::Environment environment = this_environment();
  for (const auto& [library, flags] : environment.compiler_flags) {
    const auto found = compiled.find(library);
    ASSERT_NE(found, compiled.end()) << library;
    EXPECT_EQ(flags_of(subjects::protocol::split_words(flags)), found->second) << library;
  }
  for (const char* library : {"carom_batch", "carom_collision_json", "carom_oracles", "carom_properties",
                              "carom_protocol", "carom_rational", "carom_subjects", "carom_tool"}) {
    EXPECT_TRUE(environment.compiler_flags.contains(library)) << library;
  }
}

}  // namespace
}  // namespace carom::tool
