// SPDX-License-Identifier: BSL-1.0
#include <cctype>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/properties/cases/family.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

const std::string pages = std::string(CAROM_SOURCE_DIR) + "/docs/";
const std::string proofs = std::string(CAROM_SOURCE_DIR) + "/properties/proofs/";

bool states(const std::string& text, std::string_view name) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, line.find_first_not_of(' '));
    for (const char* kind : {"Theorem ", "Lemma ", "Corollary "}) {
      const std::string statement = kind + std::string(name);
      const char next = line.size() > statement.size() ? line[statement.size()] : ' ';
      if (line.starts_with(statement) && std::isalnum(static_cast<unsigned char>(next)) == 0 && next != '_' &&
          next != '\'') {
        return true;
      }
    }
  }
  return false;
}

TEST(Documents, InvariantsPageIsWhatTheProgramPrints) {
  const RunResult result = run_carom({"invariants", "--format", "markdown"});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(result.output, content_of(pages + "reference/invariants.md"));
}

TEST(Documents, EveryInvariantSaysWhatItClaims) {
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    EXPECT_FALSE(invariant.statement.empty()) << invariant.name;
    EXPECT_FALSE(invariant.formula.empty()) << invariant.name;
    EXPECT_FALSE(invariant.source.empty()) << invariant.name;
    EXPECT_FALSE(invariant.applies_to.empty()) << invariant.name;
    EXPECT_FALSE(invariant.laws.empty()) << invariant.name;
    EXPECT_EQ(properties::invariant_named(invariant.name), &invariant) << "the name stands twice";
  }
}

TEST(Documents, TheoremsThatInvariantsNameAreProved) {
  // Another test compares the axioms in theorems.txt with the permitted axioms.
  const std::string listed = content_of(proofs + "theorems.txt");
  std::size_t count = 0;
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    for (const properties::Theorem& theorem : invariant.proof.theorems) {
      ++count;
      EXPECT_TRUE(states(content_of(proofs + std::string(theorem.file)), theorem.name)) << theorem.name;
      const std::string_view file = theorem.file.substr(0, theorem.file.rfind('.'));
      EXPECT_NE(listed.find(fmt::format("\n{} {}\n", file, theorem.name)), std::string::npos) << theorem.name;
    }
  }
  EXPECT_GT(count, properties::all_invariants().size());
}

TEST(Documents, ListsAreComplete) {
  const auto subjects = nlohmann::json::parse(run_carom({"subjects", "--format", "json"}).output);
  EXPECT_EQ(subjects.size(), subjects::known_subjects().size());
  const auto invariants = nlohmann::json::parse(run_carom({"invariants", "--format", "json"}).output);
  EXPECT_EQ(invariants.size(), properties::all_invariants().size());
  const auto families = nlohmann::json::parse(run_carom({"families", "--format", "json"}).output);
  EXPECT_EQ(families.size(), properties::all_families().size() + properties::families_beyond_domain().size());
  const std::string text = run_carom({"families"}).output;
  for (const auto kind : {properties::all_families(), properties::families_beyond_domain()}) {
    for (const properties::Family& family : kind) {
      EXPECT_NE(text.find(family.name), std::string::npos) << family.name;
    }
  }
}

}  // namespace
}  // namespace carom::tests
