// SPDX-License-Identifier: BSL-1.0
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

/// Reports of earlier runs: `carom compare`, a gate with a baseline, and `carom merge`.
namespace carom::tests {
namespace {

using nlohmann::json;

const std::vector<std::string> of_a_faulty_subject{
    "gate", "reflection-in-basis-double", "--families", "head_on,generic", "--cases", "30"};

/// The report of a run that violates invariants, and reports that differ from it.
class TwoReports : public testing::Test {
 protected:
  /// The directory that all tests share.
  [[nodiscard]] static std::filesystem::path shared() {
    static const TemporaryDirectory directory;
    static const RunResult run = gate({"--out", (directory.path() / "old").string()});
    EXPECT_EQ(run.exit_status, 1);
    return directory.path();
  }

  [[nodiscard]] static std::string old() { return (shared() / "old").string(); }
  [[nodiscard]] static json report() { return json::parse(content_of(shared() / "old" / "report.json")); }

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
    expect_error(result, {"before.json: this is not a report.json", place});
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
  expect_error(run_carom({"gate", "exec:/bin/sh " + script, "--baseline", bad}), {"bad.json"});
  EXPECT_FALSE(std::filesystem::exists(started));
  (void)run_carom({"gate", "exec:/bin/sh " + script, "--cases", "1"});
  EXPECT_TRUE(std::filesystem::exists(started)) << "else the test could not fail";
}

namespace fs = std::filesystem;

/// A run and its three shards. Each shard has every third case. The subjects are sound and faulty, in each precision.
class Merge : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = new TemporaryDirectory();
    EXPECT_EQ(gate({"--out", path("whole")}).exit_status, 1);
    for (const std::string number : {"1", "2", "3"}) {
      const RunResult result = gate({"--shard", number + "/3", "--out", path("shard" + number)});
      EXPECT_EQ(result.exit_status, 1) << result.output << result.errors;
    }
  }

  static void TearDownTestSuite() { delete directory_; }

  [[nodiscard]] static std::string path(const std::string& name) { return (directory_->path() / name).string(); }

  [[nodiscard]] static json report_in(const std::string& name) {
    return json::parse(content_of(directory_->path() / name / "report.json"));
  }

  [[nodiscard]] static RunResult gate(const std::vector<std::string>& more) {
    return run_carom({"gate", "frictionless-float", "reflection-in-basis-double", "frictionless-long-double",
                      "coulomb-double", "--families", "head_on,invalid,structured,elastic", "--cases", "20", "--seed",
                      "3", "--deviates", std::string("energy@elastic,") + few_families_judge_no},
                     more);
  }

  /// `arguments` are the directories, and any options.
  [[nodiscard]] static RunResult merge(const std::vector<std::string>& arguments) {
    return run_carom({"merge", "--out", path("merged")}, arguments);
  }

  [[nodiscard]] static std::vector<std::string> all_shards() {
    return {path("shard2"), path("shard1"), path("shard3")};
  }

  [[nodiscard]] static std::string changed_shard(const std::function<void(json&)>& change) {
    const fs::path changed = directory_->path() / "changed";
    fs::remove_all(changed);
    fs::copy(directory_->path() / "shard2", changed, fs::copy_options::recursive);
    json report = report_in("shard2");
    change(report);
    (void)directory_->write("changed/report.json", report.dump());
    return changed.string();
  }

 private:
  static inline TemporaryDirectory* directory_ = nullptr;
};

/// Each shard chooses its own witnesses, so their cases may differ from those of the whole run.
json without_what_may_differ(json report) {
  report.at("environment").erase("date");
  for (json& subject : report.at("subjects")) {
    subject.erase("nanoseconds_per_solve");
    for (json& violation : subject.at("violations")) {
      violation.erase("case");
      violation.erase("family");
    }
  }
  return report;
}

TEST_F(Merge, OfAllShardsIsTheReportOfTheWholeRun) {
  const RunResult result = merge(all_shards());
  EXPECT_EQ(result.exit_status, 1) << result.errors;
  const json whole = report_in("whole");
  const json merged = report_in("merged");
  EXPECT_EQ(without_what_may_differ(merged), without_what_may_differ(whole))
      << json::diff(without_what_may_differ(whole), without_what_may_differ(merged)).dump(1);
  EXPECT_FALSE(merged.contains("shard"));
  EXPECT_FALSE(merged.at("subjects").at(1).at("diagnosis").at("faults").at(0).at("what").get<std::string>().empty());
  EXPECT_GT(whole.at("subjects").at(0).at("digits").at("p50").get<double>(), 0);
}

TEST_F(Merge, WritesWitnessesThatReplayAndEveryFormOfTheReport) {
  (void)merge(all_shards());
  const json merged = report_in("merged");
  std::size_t witnesses = 0;
  for (const json& subject : merged.at("subjects")) {
    for (const json& violation : subject.at("violations")) {
      const std::string file = path("merged") + '/' + violation.at("witness").get<std::string>();
      const json witness = json::parse(content_of(file));
      EXPECT_EQ(witness.at("case"), violation.at("case"));
      EXPECT_EQ(witness.at("family"), violation.at("family"));
      const RunResult replayed = run_carom({"replay", file, "--exact", "--format", "json"});
      EXPECT_EQ(json::parse(replayed.output).at("verdicts").at(witness.at("invariant").get<std::string>()),
                witness.at("verdict"));
      ++witnesses;
    }
  }
  EXPECT_GT(witnesses, 3U);
  pugi::xml_document junit;
  pugi::xml_document whole;
  ASSERT_TRUE(junit.load_file((path("merged") + "/junit.xml").c_str()));
  ASSERT_TRUE(whole.load_file((path("whole") + "/junit.xml").c_str()));
  for (const char* total : {"tests", "failures", "errors", "skipped"}) {
    EXPECT_EQ(junit.child("testsuites").attribute(total).as_int(-1),
              whole.child("testsuites").attribute(total).as_int(-2))
        << total;
  }
  pugi::xml_document page;
  EXPECT_TRUE(page.load_file((path("merged") + "/report.html").c_str()));
}

TEST_F(Merge, WithTheWholeRunAsItsBaselineFindsNothingNew) {
  std::vector<std::string> arguments = all_shards();
  arguments.insert(arguments.end(), {"--baseline", path("whole")});
  const RunResult result = merge(arguments);
  EXPECT_EQ(result.exit_status, 0) << result.output;
  unit::expect_in(result.output, {"nothing new"});
  EXPECT_TRUE(report_in("merged").at("baseline").at("comparable").get<bool>())
      << report_in("merged").at("baseline").at("differences");
}

TEST_F(Merge, RefusesAMissingShardARepeatedShardAndAWholeRun) {
  expect_error(merge({path("shard1"), path("shard3")}),
               {"shard 2 of 3 is missing; give the directories of all shards"});
  expect_error(merge({path("shard1"), path("shard1"), path("shard2"), path("shard3")}), {"shard 1 of 3 occurs twice"});
  expect_error(merge({path("whole")}), {"this report is not of a shard"});
  EXPECT_EQ(merge({}).exit_status, 2);
}

TEST_F(Merge, RefusesShardsOfDifferentRunsAndNamesTheField) {
  const std::vector<std::pair<std::string, std::function<void(json&)>>> changes{
      {"seed: 3 in", [](json& r) { r["seed"] = 4; }},
      {"cases of each family: 20 in", [](json& r) { r["cases_of_each_family"] = 21; }},
      {"yardstick: ", [](json& r) { r["yardstick"]["limit_ulps"] = 64; }},
      {"relations_every: ", [](json& r) { r["relations_every"] = 2; }},
      {"deviates: ", [](json& r) { r["deviates"] = {"push"}; }},
      {"number of shards: 3 in", [](json& r) { r["shard"]["of"] = 4; }},
      {"families: ",
       [](json& r) {
         r["families"].erase(3);
         for (json& subject : r["subjects"]) {
           subject["families"].erase(3);
         }
       }},
      {"subjects: ", [](json& r) { r["subjects"].erase(3); }},
      {"version of frictionless-float: ", [](json& r) { r["subjects"][0]["version"] = "7"; }},
      {"claims of frictionless-float: ",
       [](json& r) {
         r["subjects"][0]["claims"] = {{"slop", 1}};
       }},
  };
  for (const auto& [field, change] : changes) {
    expect_error(merge({path("shard1"), changed_shard(change), path("shard3")}),
                 {"do not belong to one run: " + field});
  }
}

TEST_F(Merge, RefusesAWrongShardAndNamesFileAndPlace) {
  const std::vector<std::pair<std::string, std::function<void(json&)>>> changes{
      {"/carom: expected", [](json& r) { r["carom"] = "9.9.9"; }},
      {"/interrupted: expected", [](json& r) { r["interrupted"] = true; }},
      {"/shard/number: expected", [](json& r) { r["shard"]["number"] = 4; }},
      {"/shard/digits: expected", [](json& r) { r["shard"]["digits"].erase(3); }},
      {"/shard/findings/1/structured/worst/restitution/case: expected the number of a case, less than ",
       [](json& r) { r["shard"]["findings"][1]["structured"]["worst"]["restitution"]["case"] = 1'000'000; }},
      {"/shard/findings/1/structured/violated_cases/no_such: expected the name of an invariant",
       [](json& r) { r["shard"]["findings"][1]["structured"]["violated_cases"]["no_such"] = {0}; }},
      {"/shard/findings/1/structured/answers/0/answer: expected twelve numbers",
       [](json& r) { r["shard"]["findings"][1]["structured"]["answers"][0]["answer"] = {1}; }},
      {"/shard/digits/0/bins/0: expected",
       [](json& r) {
         r["shard"]["digits"][0]["bins"][0] = {1'000'000'000, 1};
       }},
      {"/subjects/1/families/0/cases: expected at least the sum",
       [](json& r) { r["subjects"][1]["families"][0]["skipped"] = r["subjects"][1]["families"][0]["cases"]; }},
      {"/subjects/1/violations/0/invariant: expected",
       [](json& r) { r["subjects"][1]["violations"][0]["invariant"] = "../../etc"; }},
  };
  for (const auto& [place, change] : changes) {
    expect_error(merge({path("shard1"), changed_shard(change), path("shard3")}), {"changed/report.json: " + place});
  }
  const std::string without_witnesses = changed_shard([](json&) {});
  fs::remove_all(fs::path(without_witnesses) / "witnesses");
  expect_error(merge({path("shard1"), without_witnesses, path("shard3")}), {"this file does not exist"});
}

TEST_F(Merge, RefusesTheDirectoryOfAShardAsItsOutput) {
  const std::string before = content_of(path("shard1") + "/report.json");
  EXPECT_EQ(run_carom({"merge", "--out", path("shard1")}, all_shards()).exit_status, 2);
  EXPECT_EQ(content_of(path("shard1") + "/report.json"), before);
}

TEST(Shard, OfABatchSystemIsWrittenToAFolderOfItsOwn) {
  const TemporaryDirectory out;
  const RunResult result =
      run_program("/usr/bin/env",
                  {"OMPI_COMM_WORLD_RANK=1", "OMPI_COMM_WORLD_SIZE=3", carom_program(), "gate", "frictionless-double",
                   "--families", "head_on", "--cases", "30", "--shard", "auto", "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const json shard = json::parse(content_of(out.path() / "shard-2-of-3" / "report.json")).at("shard");
  EXPECT_EQ(shard.at("number"), 2);
  EXPECT_EQ(shard.at("of"), 3);
  EXPECT_FALSE(fs::exists(out.path() / "report.json"));
}

}  // namespace
}  // namespace carom::tests
