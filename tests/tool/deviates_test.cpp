// SPDX-License-Identifier: BSL-1.0
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

json report_of(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{
      "gate", "reflection-in-basis-double", "--families", "head_on,near_head_on", "--cases", "30", "--format", "json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return json::parse(run_carom(arguments).output);
}

const json& invariants_in(const json& report, std::size_t family) {
  return report.at("subjects").at(0).at("families").at(family).at("invariants");
}

TEST(Deviates, LeaveOutAnInvariantInOneFamilyOrAltogether) {
  const json whole = report_of({});
  const json report = report_of({"--deviates", "restitution@head_on,memoryless"});
  const json expected = json::array({"restitution@head_on", "memoryless"});
  EXPECT_EQ(report.at("deviates"), expected);
  EXPECT_EQ(report.at("subjects").at(0).at("deviates"), expected);
  for (const std::size_t family : {0U, 1U}) {
    json rest = invariants_in(whole, family);
    rest.erase("memoryless");
    if (family == 0) {
      rest.erase("restitution");
    }
    EXPECT_EQ(invariants_in(report, family), rest) << family;
  }

  const std::string unjudged = few_families_judge_no;
  std::string all = unjudged;
  std::string all_but_one = unjudged;
  for (const json& violation : whole.at("subjects").at(0).at("violations")) {
    const std::string name = violation.at("invariant");
    for (const char* family : {"head_on", "near_head_on"}) {
      const std::string deviation = name + "@" + family;
      all += ',' + deviation;
      if (deviation != "restitution@near_head_on") {
        all_but_one += ',' + deviation;
      }
    }
  }
  const json green = report_of({"--deviates", all});
  EXPECT_EQ(green.at("exit_status"), 0) << green.at("subjects").at(0).at("violations");
  EXPECT_EQ(green.at("subjects").at(0).at("status"), "sound");
  EXPECT_EQ(report_of({"--deviates", all_but_one}).at("exit_status"), 1) << "one violation is not left out";
}

TEST(Deviates, AreInTheTextAndThePage) {
  const TemporaryDirectory out;
  const RunResult result =
      run_carom({"gate", "frictionless-double", "--families", "head_on", "--cases", "5", "--deviates",
                 std::string("energy@head_on,") + few_families_judge_no, "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_NE(result.output.find("not judged because of --deviates: energy@head_on, "), std::string::npos)
      << result.output;
  EXPECT_NE(content_of(out.path() / "report.html").find("energy@head_on"), std::string::npos);
}

/// Only a method that forms the collision matrix claims the invariants about this matrix.
TEST(NotClaimed, IsWhatIsSaidOfAMatrixThatIsNotShown) {
  const TemporaryDirectory out;
  const RunResult result = run_carom({"gate", "frictionless-double", "reflection-double", "reflection-batch-double",
                                      "--cases", "5", "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_NE(result.output.find("  frictionless-double, reflection-batch-double: not claimed, because it shows no "
                               "collision matrix: definite, well_conditioned, matrix_used\n"),
            std::string::npos)
      << result.output;
  const std::string html = content_of(out.path() / "report.html");
  EXPECT_NE(html.find("because it shows no collision matrix"), std::string::npos);
  const json report = json::parse(content_of(out.path() / "report.json"));
  for (const auto& [subject, shows] : {std::pair{0, false}, std::pair{1, true}, std::pair{2, false}}) {
    const json& record = report.at("subjects").at(static_cast<std::size_t>(subject));
    const json& invariants = record.at("families").at(0).at("invariants");
    EXPECT_EQ(record.at("shows_collision_matrix"), shows);
    EXPECT_EQ(record.at("not_claimed"),
              shows ? json::array() : json::array({"definite", "well_conditioned", "matrix_used"}));
    for (const char* name : {"definite", "matrix_used"}) {
      EXPECT_EQ(invariants.contains(name), shows) << name;
      EXPECT_TRUE(!shows || invariants.at(name).at("holds") > 0) << name;
    }
  }
}

TEST(Deviates, MayBeSaidByAProgram) {
  const auto introduced_with = [](const std::string& deviates) {
    return json::parse(run_carom({"gate", std::string("exec:") + CAROM_MISBEHAVING + " 'deviates=" + deviates + "' x",
                                  "--families", "head_on,separating", "--cases", "5", "--format", "json"})
                           .output);
  };
  EXPECT_TRUE(invariants_in(introduced_with("[]"), 1).contains("separating_untouched"));
  const json partly = introduced_with(R"(["separating_untouched@separating"])");
  EXPECT_FALSE(invariants_in(partly, 1).contains("separating_untouched"));
  const json unknown = introduced_with(R"(["separating_untouched@seperating"])");
  EXPECT_EQ(unknown.at("subjects").at(0).at("status"), "error");
  EXPECT_NE(unknown.at("subjects").at(0).at("error").get<std::string>().find("did you mean 'separating'?"),
            std::string::npos);
}

}  // namespace
}  // namespace carom::tests
