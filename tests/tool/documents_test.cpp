// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/properties/families/family.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/subjects/catalogue.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

TEST(Documents, InvariantsPageIsWhatTheProgramPrints) {
  const RunResult result = run_carom({"invariants", "--format", "markdown"});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(result.output, content_of(std::string(CAROM_SOURCE_DIR) + "/docs/reference/invariants.md"));
}

TEST(Documents, EveryInvariantSaysWhatItClaims) {
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    EXPECT_FALSE(invariant.statement.empty()) << invariant.name;
    EXPECT_FALSE(invariant.formula.empty()) << invariant.name;
    EXPECT_FALSE(invariant.source.empty()) << invariant.name;
    EXPECT_FALSE(invariant.domain.empty()) << invariant.name;
    EXPECT_FALSE(invariant.models.empty()) << invariant.name;
    EXPECT_EQ(properties::invariant_named(invariant.name), &invariant) << "the name stands twice";
  }
}

TEST(Documents, ListsNameEverything) {
  const auto subjects = nlohmann::json::parse(run_carom({"subjects", "--format", "json"}).output);
  EXPECT_EQ(subjects.size(), subjects::known_subjects().size());
  const auto invariants = nlohmann::json::parse(run_carom({"invariants", "--format", "json"}).output);
  EXPECT_EQ(invariants.size(), properties::all_invariants().size());
  const auto families = nlohmann::json::parse(run_carom({"families", "--format", "json"}).output);
  EXPECT_EQ(families.size(), properties::all_families().size());
  const std::string text = run_carom({"families"}).output;
  for (const properties::Family& family : properties::all_families()) {
    EXPECT_NE(text.find(family.name), std::string::npos) << family.name;
  }
}

}  // namespace
}  // namespace carom::tests
