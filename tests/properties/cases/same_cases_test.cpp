// SPDX-License-Identifier: BSL-1.0
#include "same_cases.hpp"

#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace carom::properties {
namespace {

/// The lines of first_thousand.txt by name. If this file changes, the cases of every seed change: note it in
/// docs/CHANGELOG.md.
std::map<std::string, std::string> expected_lines() {
  std::map<std::string, std::string> lines;
  std::ifstream table(CAROM_FIRST_THOUSAND);
  for (std::string line; std::getline(table, line);) {
    lines[line.substr(0, line.rfind(' '))] = line;
  }
  return lines;
}

TEST(Families, GiveTheSameCasesOnEveryMachine) {
  constexpr std::uint64_t seed = 1;
  std::map<std::string, std::string> expected = expected_lines();
  for (const Checksum& checksum : checksums(seed, 1000)) {
    EXPECT_EQ(expected[checksum.name], line_of(checksum)) << "the second is the one now";
    expected.erase(checksum.name);
  }
  for (const auto& [name, line] : expected) {
    ADD_FAILURE() << "nothing is drawn of the name in: " << line;
  }
}

}  // namespace
}  // namespace carom::properties
