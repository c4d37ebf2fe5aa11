// SPDX-License-Identifier: BSL-1.0
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

/// The text that `carom gate ARG… --summary FILE` appends to a file.
std::string summary_of(std::vector<std::string> arguments, int expected_status) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("summary.md", "what was there\n");
  arguments.insert(arguments.end(), {"--summary", file});
  const RunResult result = run_carom(arguments);
  EXPECT_EQ(result.exit_status, expected_status) << result.errors;
  const std::string text = content_of(file);
  EXPECT_TRUE(text.starts_with("what was there\n## Carom: ")) << text;
  return text;
}

void expect_in(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "expected: " << part << "\nin: " << text;
  }
}

TEST(Summary, OfASoundSubjectIsALineOfATable) {
  const std::string text = summary_of(
      {"gate", "frictionless-double", "--families", "head_on", "--deviates", few_families_judge_no, "--cases", "20"},
      0);
  expect_in(text, {"## Carom: sound\n\n1 of 1 subjects that count are sound; 20 cases of each of 1 "
                   "families, seed 1, ",
                   "| `frictionless-double` | sound | "});
  EXPECT_EQ(text.find("###"), std::string::npos) << text;
}

TEST(Summary, HasTheFirstWitnessOfAViolatedSubjectInWordsAndItsReplay) {
  const TemporaryDirectory out;
  const std::string text = summary_of({"gate", "reflection-in-basis-double", "--families", "near_head_on,slow",
                                       "--cases", "100", "--out", out.path().string()},
                                      1);
  const auto report = nlohmann::json::parse(content_of(out.path() / "report.json"));
  const auto& violations = report.at("subjects").at(0).at("violations");
  ASSERT_GE(violations.size(), 2U);
  expect_in(text, {"| " + std::to_string(violations.size()) + " violated |", "### `reflection-in-basis-double`",
                   "\n      answered\n        A: velocity ", ", apart by ", ", allowed "});
  for (const auto& violation : violations) {
    expect_in(text, {"| " + violation.at("invariant").get<std::string>() + " | " +
                     std::to_string(violation.at("count").get<int>()) + " of "});
  }
  const std::string telling = report.at("subjects").at(0).at("diagnosis").at("telling");
  const std::string witness = "witnesses/reflection-in-basis-double." + telling + ".json";
  expect_in(text, {"    carom replay " + (out.path() / witness).string() + " --subject reflection-in-basis-double\n"});
}

TEST(Summary, LeavesOutWhatIsExpectedToFail) {
  const std::string text =
      summary_of({"gate", "--families", "near_head_on", "--deviates", few_families_judge_no, "--cases", "20"}, 0);
  expect_in(text, {"`frictionless-double`"});
  EXPECT_EQ(text.find("reflection-in-basis-double"), std::string::npos) << text;
}

// A subject's text does not end a cell by |, does not end code by `, and begins no line with a heading or a tag.
TEST(Summary, IsNotWhatASubjectWrites) {
  const std::string text =
      summary_of({"gate", "exec:/no/such '|`<b>@who\n## planted\x1b[31m'", "--families", "head_on", "--cases", "2"}, 2);
  expect_in(text, {"## Carom: not judged", "\\|'<b>@who ## planted?[31m"});
  EXPECT_EQ(text.find("\n## planted"), std::string::npos) << text;
}

TEST(Summary, ThatCannotBeWrittenIsAnErrorBeforeAnythingIsJudged) {
  const RunResult result = run_carom({"gate", "frictionless-double", "--summary", "/no/such/summary.md"});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_TRUE(result.output.empty()) << result.output;
  EXPECT_EQ(result.errors,
            "carom: --summary: the file /no/such/summary.md cannot be written; check the path and its permissions\n");
}

}  // namespace
}  // namespace carom::tests
