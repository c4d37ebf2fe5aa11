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

TEST(Deviates, InOneFamilyIsJudgedInTheOthersAsBefore) {
  const json whole = report_of({});
  const json report = report_of({"--deviates", "restitution@head_on"});
  EXPECT_FALSE(invariants_in(report, 0).contains("restitution"));
  EXPECT_EQ(invariants_in(report, 1), invariants_in(whole, 1));
  json rest = invariants_in(whole, 0);
  rest.erase("restitution");
  EXPECT_EQ(invariants_in(report, 0), rest);
  EXPECT_EQ(report.at("deviates"), json::array({"restitution@head_on"}));
  EXPECT_EQ(report.at("subjects").at(0).at("deviates"), json::array({"restitution@head_on"}));
}

TEST(Deviates, AltogetherIsJudgedNowhere) {
  const json report = report_of({"--deviates", "restitution,memoryless"});
  for (const std::size_t family : {0U, 1U}) {
    EXPECT_FALSE(invariants_in(report, family).contains("restitution"));
    EXPECT_FALSE(invariants_in(report, family).contains("memoryless"));
  }
}

TEST(Deviates, StaysGreenUntilSomethingElseBreaks) {
  const json whole = report_of({});
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
  EXPECT_EQ(report_of({"--deviates", all_but_one}).at("exit_status"), 1);
}

TEST(Deviates, IsShownInEveryReport) {
  const TemporaryDirectory out;
  const RunResult result =
      run_carom({"gate", "frictionless-double", "--families", "head_on", "--cases", "5", "--deviates",
                 std::string("energy@head_on,") + few_families_judge_no, "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_NE(result.output.find("not judged because of --deviates: energy@head_on, "), std::string::npos)
      << result.output;
  EXPECT_NE(content_of(out.path() / "report.html").find("energy@head_on"), std::string::npos);
  EXPECT_NE(content_of(out.path() / "report.json").find("energy@head_on"), std::string::npos);
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

TEST(Deviates, OfNothingKnownNamesTheNearest) {
  const RunResult invariant = run_carom({"gate", "frictionless-double", "--deviates", "restitutoin"});
  EXPECT_EQ(invariant.exit_status, 2);
  EXPECT_NE(invariant.errors.find("did you mean 'restitution'?"), std::string::npos) << invariant.errors;
  const RunResult family = run_carom({"gate", "frictionless-double", "--deviates", "energy@hed_on"});
  EXPECT_EQ(family.exit_status, 2);
  EXPECT_NE(family.errors.find("did you mean 'head_on'?"), std::string::npos) << family.errors;
  EXPECT_EQ(run_carom({"gate", "frictionless-double", "--deviates", "energy@"}).exit_status, 2);
}

TEST(Deviates, MayBeSaidByAProgram) {
  const TemporaryDirectory directory;
  const auto introduced_with = [&](const std::string& deviates) {
    const std::string script = directory.write(
        "solver.py",
        "import json, sys\n"
        "for line in sys.stdin:\n"
        "  request = json.loads(line)\n"
        "  if request['cmd'] == 'start':\n"
        "    print(json.dumps({'protocol': 1, 'name': 'still', 'version': '1', 'precision': 'binary64', 'model': "
        "'any', "
        "'deviates': [" +
            deviates +
            "]}), flush=True)\n"
            "  elif request['cmd'] == 'solve':\n"
            "    still = lambda body: {'velocity': body['velocity'], 'angular_velocity': body['angular_velocity']}\n"
            "    c = request['collision']\n"
            "    print(json.dumps({'id': request['id'], 'a': still(c['a']), 'b': still(c['b'])}), flush=True)\n"
            "  else:\n"
            "    break\n");
    return json::parse(run_carom({"gate", "exec:/usr/bin/python3 " + script, "--families", "head_on,separating",
                                  "--cases", "5", "--format", "json"})
                           .output);
  };
  const json whole = introduced_with("");
  EXPECT_TRUE(invariants_in(whole, 1).contains("separating_untouched"));
  const json partly = introduced_with("'separating_untouched@separating'");
  EXPECT_FALSE(invariants_in(partly, 1).contains("separating_untouched"));
  const json unknown = introduced_with("'separating_untouched@seperating'");
  EXPECT_EQ(unknown.at("subjects").at(0).at("status"), "error");
  EXPECT_NE(unknown.at("subjects").at(0).at("error").get<std::string>().find("did you mean 'separating'?"),
            std::string::npos);
}

}  // namespace
}  // namespace carom::tests
