// SPDX-License-Identifier: BSL-1.0
// Two reports: `carom compare`, and a gate with a baseline.
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const std::vector<std::string> of_a_faulty_subject{
    "gate", "reflection-in-basis-double", "--families", "head_on,generic", "--cases", "30"};

/// The report of a run that violates invariants, and reports that differ from it.
class TwoReports : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = new TemporaryDirectory;
    EXPECT_EQ(gate({"--out", old()}).exit_status, 1);
  }
  static void TearDownTestSuite() { delete shared_; }

  [[nodiscard]] static std::string old() { return (shared_->path() / "old").string(); }
  [[nodiscard]] static json report() { return json::parse(content_of(shared_->path() / "old" / "report.json")); }

  [[nodiscard]] static RunResult gate(const std::vector<std::string>& more) {
    return run_carom(of_a_faulty_subject, more);
  }

  [[nodiscard]] static json& count_of(json& report, std::size_t family, const std::string& invariant) {
    return report.at("subjects").at(0).at("families").at(family).at("invariants").at(invariant);
  }

  /// The report, as if `restitution` held in every family.
  [[nodiscard]] static json without_violation() {
    json changed = report();
    for (const std::size_t family : {0U, 1U}) {
      json& count = count_of(changed, family, "restitution");
      count["holds"] = count.at("holds").get<int>() + count.at("violated").get<int>();
      count["violated"] = 0;
    }
    return changed;
  }

  [[nodiscard]] RunResult compare(const json& before, const json& now) const {
    return run_carom(
        {"compare", directory_.write("before.json", before.dump()), directory_.write("now.json", now.dump())});
  }

  TemporaryDirectory directory_;

 private:
  static inline TemporaryDirectory* shared_ = nullptr;
};

TEST_F(TwoReports, ComparedGiveExitStatusOneOnlyIfAViolationIsNew) {
  const RunResult same = run_carom({"compare", old(), old()});
  EXPECT_EQ(same.exit_status, 0) << same.output << same.errors;
  EXPECT_EQ(same.output.find("Not comparable"), std::string::npos) << same.output;
  EXPECT_EQ(same.output.find("\n0 new, "), same.output.rfind('\n', same.output.size() - 2)) << same.output;
  EXPECT_EQ(compare(report(), without_violation()).exit_status, 0) << "what is fixed is no failure";
  const RunResult worse = compare(without_violation(), report());
  EXPECT_EQ(worse.exit_status, 1);
  EXPECT_TRUE(worse.errors.empty()) << worse.errors;
}

TEST_F(TwoReports, ComparedAreATableWithARowForEachChangedInvariant) {
  json now = report();
  count_of(now, 0, "restitution") = {{"holds", 29}, {"violated", 1}, {"skipped", 0}};
  count_of(now, 1, "restitution") = {{"holds", 0}, {"violated", 30}, {"skipped", 0}};
  const std::string of_new = compare(without_violation(), now).output;
  unit::expect_in(of_new, {"reflection-in-basis-double  new", "restitution", "head_on (1 of 30), generic (30 of 30)"});
  EXPECT_NE(of_new.find("\n2 new, "), std::string::npos) << "a row is an invariant, a count is one of a family";
  const std::string of_fixed = compare(now, without_violation()).output;
  unit::expect_in(of_fixed, {"head_on (1 of 30 before), generic (30 of 30 before)"});
  json other = report();
  other["seed"] = 2;
  other["cases_of_each_family"] = 20;
  const std::string of_other = compare(report(), other).output;
  unit::expect_in(of_other, {"Not comparable", "seed: 1 before, 2 now", "cases of each family: 30 before, 20 now"});
}

TEST_F(TwoReports, MayHaveFieldsThatThisVersionDoesNotKnow) {
  json newer = report();
  newer["more"] = {{"more", 1}};
  newer.at("subjects").at(0)["mood"] = "good";
  newer.at("subjects").at(0).at("families").at(0)["violated_cases"] = json::array({1, 2});
  EXPECT_EQ(compare(report(), newer).exit_status, 0);
}

TEST_F(TwoReports, ThatCannotBeReadAreAnErrorThatNamesFileAndPlace) {
  const std::vector<std::pair<std::string, std::function<void(json&)>>> changes{
      {"/seed: is missing", [](json& r) { r.erase("seed"); }},
      {"/seed: expected a count", [](json& r) { r["seed"] = -1; }},
      {"/cases_of_each_family: expected a count", [](json& r) { r["cases_of_each_family"] = true; }},
      {"/subjects: expected an array", [](json& r) { r["subjects"] = 3; }},
      {"/subjects/0: expected an object", [](json& r) { r["subjects"][0] = "text"; }},
      {"/subjects/0/name: expected a string", [](json& r) { r["subjects"][0]["name"] = 3; }},
      {"/subjects/1/name: 'reflection-in-basis-double' occurs twice",
       [](json& r) { r["subjects"].push_back(r["subjects"][0]); }},
      {"/subjects/0/families/1/family: expected the family \"generic\"",
       [](json& r) { r["subjects"][0]["families"][1]["family"] = "head_on"; }},
      {"/subjects/0/families/0/invariants/restitution/holds: expected a count",
       [](json& r) { count_of(r, 0, "restitution")["holds"] = 1.5; }},
      {"/environment/date: is missing", [](json& r) { r["environment"].erase("date"); }},
      {"/yardstick/limit_ulps: ", [](json& r) { r["yardstick"]["limit_ulps"] = "many"; }},
      {"/carom: is missing",
       [](json& r) {
         r = json::object({{"families", json::array()}});
       }},
      {"/families: expected an array", [](json& r) { r["families"] = "text"; }},
  };
  for (const auto& [place, change] : changes) {
    json bad = report();
    change(bad);
    const RunResult result = compare(bad, report());
    EXPECT_EQ(result.exit_status, 2) << place;
    unit::expect_in(result.errors, {"before.json: this is not a report.json", place});
    EXPECT_TRUE(result.output.empty());
  }
  EXPECT_EQ(run_carom({"compare", directory_.write("bad.json", "{"), old()}).exit_status, 2);
  EXPECT_EQ(run_carom({"compare", "/no/such", "/no/such"}).exit_status, 2);
}

TEST_F(TwoReports, AreABaselineWithWhichAGateOfKnownViolationsEndsInZero) {
  const std::filesystem::path out = directory_.path() / "second";
  const RunResult result = gate({"--baseline", old(), "--out", out.string(), "--summary",
                                 (directory_.path() / "summary.md").string(), "--annotations", "github"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
  unit::expect_in(result.output, {"Against the baseline " + old()});
  EXPECT_EQ(result.output.find("::error "), std::string::npos) << result.output;
  unit::expect_in(result.output, {"(known from the baseline)"});
  unit::expect_in(content_of(directory_.path() / "summary.md"), {"Against the baseline: nothing new, "});
  const json report = json::parse(content_of(out / "report.json"));
  EXPECT_EQ(report.at("exit_status"), 0);
  EXPECT_TRUE(report.at("baseline").at("new").empty());
  EXPECT_FALSE(report.at("baseline").at("known").empty());
  EXPECT_EQ(report.at("subjects").at(0).at("status"), "violated") << "the verdict stays what it is";
  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((out / "junit.xml").c_str()));
  EXPECT_EQ(junit.child("testsuites").attribute("failures").as_int(-1), 0);
  EXPECT_TRUE(junit.select_node("//skipped[contains(@message, 'known from the baseline')]"));
  unit::expect_in(content_of(out / "report.html"), {"Against the baseline"});
}

TEST_F(TwoReports, AreABaselineWithWhichAGateOfANewViolationEndsInOne) {
  const std::filesystem::path out = directory_.path() / "second";
  const RunResult result =
      gate({"--baseline", directory_.write("baseline.json", without_violation().dump()), "--out", out.string()});
  EXPECT_EQ(result.exit_status, 1);
  const json report = json::parse(content_of(out / "report.json"));
  EXPECT_EQ(report.at("exit_status"), 1);
  const json& added = report.at("baseline").at("new");
  ASSERT_FALSE(added.empty());
  EXPECT_EQ(added.at(0).at("invariant"), "restitution");
  EXPECT_EQ(added.at(0).at("family"), "head_on");
  EXPECT_EQ(added.at(0).at("judged_before"), true);
  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((out / "junit.xml").c_str()));
  EXPECT_TRUE(junit.select_node("//testcase[@name = 'restitution']/failure"));
  EXPECT_TRUE(junit.select_node("//testcase[@name = 'backward_error']/skipped"));
}

TEST_F(TwoReports, AreABaselineWithWhichASubjectThatCannotBeJudgedStillFails) {
  std::vector<std::string> arguments = of_a_faulty_subject;
  const std::string out = (directory_.path() / "second").string();
  arguments.insert(arguments.begin() + 1, "exec:/no/such");
  arguments.insert(arguments.end(), {"--out", out});
  EXPECT_EQ(run_carom(arguments).exit_status, 2);
  arguments.insert(arguments.end(), {"--baseline", out});
  EXPECT_EQ(run_carom(arguments).exit_status, 2) << "also where it could not before";
}

TEST_F(TwoReports, AreABaselineThatIsReadBeforeAnyProgramIsStarted) {
  const std::string started = (directory_.path() / "started").string();
  const std::string script = directory_.write("solver.sh", "touch " + started + "\n");
  const std::string bad = directory_.write("bad.json", R"({"carom": "0.1.0"})");
  const RunResult result = run_carom({"gate", "exec:/bin/sh " + script, "--baseline", bad});
  EXPECT_EQ(result.exit_status, 2);
  unit::expect_in(result.errors, {"bad.json"});
  EXPECT_FALSE(std::filesystem::exists(started));
  (void)run_carom({"gate", "exec:/bin/sh " + script, "--cases", "1"});
  EXPECT_TRUE(std::filesystem::exists(started)) << "else the test could not fail";
}

}  // namespace
}  // namespace carom::tests
