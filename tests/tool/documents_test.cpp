// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/properties/families/family.hpp>
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
    EXPECT_FALSE(invariant.domain.empty()) << invariant.name;
    EXPECT_FALSE(invariant.laws.empty()) << invariant.name;
    EXPECT_EQ(properties::invariant_named(invariant.name), &invariant) << "the name stands twice";
  }
}

TEST(Documents, FindStatementsByTheirWholeName) {
  const std::string text = "  Theorem one (x : R) :\nLemma two_of_them: True.\nCorollary three\n(* Theorem four *)\n";
  for (const char* name : {"one", "two_of_them", "three"}) {
    EXPECT_TRUE(states(text, name)) << name;
  }
  for (const char* name : {"two", "two_of", "on", "four", "five"}) {
    EXPECT_FALSE(states(text, name)) << name;
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

std::string section(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  return at == std::string::npos ? "" : text.substr(at, text.find(end, at + begin.size()) - at);
}

std::string proved_of(std::string_view invariant) {
  static const std::map<std::string_view, std::string> some{
      {"restitution", " of frictionless, reflection, sticking, rough"},
      {"non_penetration", " of frictionless, reflection, sticking, rough"},
      {"push", " of frictionless, reflection, rough"},
      {"friction_cone", " of rough"},
  };
  const auto found = some.find(invariant);
  return found == some.end() ? "" : found->second;
}

TEST(Documents, SayOfEveryInvariantWhetherItIsProved) {
  const std::string page = content_of(pages + "reference/invariants.md");
  std::istringstream text(run_carom({"invariants"}).output);
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  const auto record = nlohmann::json::parse(run_carom({"invariants", "--format", "json"}).output);
  for (std::size_t i = 0; i < record.size(); ++i) {
    const auto name = record[i].at("name").get<std::string>();
    std::string in_text;
    std::string in_page;
    nlohmann::json in_record = nlohmann::json::array();
    for (const properties::Theorem& theorem : properties::invariant_named(name)->proof.theorems) {
      const char* comma = in_text.empty() ? "" : ", ";
      in_text += fmt::format("{}{} ({})", comma, theorem.name, theorem.file);
      in_page += fmt::format("{}[`{}`](../../properties/proofs/{})", comma, theorem.name, theorem.file);
      in_record.push_back({{"name", theorem.name}, {"file", theorem.file}});
    }
    const bool is_proved = !in_record.empty();
    const std::string of = proved_of(name);
    EXPECT_EQ(record[i].at("theorems"), in_record) << name;
    const nlohmann::json& proved = record[i].at("proved_models");
    EXPECT_EQ(proved.empty(), !is_proved) << name;
    EXPECT_EQ(is_proved && proved != record[i].at("models"), !of.empty()) << name;
    const auto laws = proved.get<std::vector<std::string>>();
    EXPECT_TRUE(of.empty() || of == fmt::format(" of {}", fmt::join(laws, ", "))) << name << of;
    ASSERT_LT(4 * i + 3, lines.size());
    EXPECT_EQ(lines[4 * i], name);
    EXPECT_EQ(lines[4 * i + 3], is_proved ? fmt::format("    proved{}: {}", of, in_text) : "    tested, not proved")
        << name;
    const std::string of_row = section(page, "| [`" + name + "`]", "\n");
    EXPECT_TRUE(of_row.ends_with(is_proved ? fmt::format("| proof{}, and test |", of) : "| test |")) << of_row;
    const std::string of_page = section(page, "\n## " + name + "\n", "\n## ") + '\n';
    EXPECT_NE(of_page.find(is_proved ? fmt::format("\n- Proved{}, and tested: {}.\n", of, in_page) : "\n- Tested.\n"),
              std::string::npos)
        << of_page;
  }
}

TEST(Documents, ListsNameEverything) {
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
