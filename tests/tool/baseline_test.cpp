// SPDX-License-Identifier: BSL-1.0
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const std::vector<std::string> of_a_faulty_subject{
    "gate", "reflection-in-basis-double", "--families", "head_on,generic", "--cases", "30"};

class Baseline : public testing::Test {
 protected:
  Baseline() {
    out_ = (directory_.path() / "first").string();
    EXPECT_EQ(run({"--out", out_}).exit_status, 1);
    report_ = json::parse(content_of(std::filesystem::path(out_) / "report.json"));
  }

  [[nodiscard]] static RunResult run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = of_a_faulty_subject;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_carom(arguments);
  }

  [[nodiscard]] std::string baseline_where_held(const std::string& invariant) const {
    json report = report_;
    for (json& family : report.at("subjects").at(0).at("families")) {
      json& count = family.at("invariants").at(invariant);
      count["holds"] = count.at("holds").get<int>() + count.at("violated").get<int>();
      count["violated"] = 0;
    }
    return directory_.write("baseline.json", report.dump());
  }

  TemporaryDirectory directory_;
  std::string out_;
  json report_;
};

TEST_F(Baseline, WhatIsKnownIsNoFailure) {
  const std::string out = (directory_.path() / "second").string();
  const RunResult result = run({"--baseline", out_, "--out", out});
  EXPECT_EQ(result.exit_status, 0) << result.output;
  const std::string line = result.output.substr(result.output.rfind('\n', result.output.size() - 2) + 1);
  EXPECT_EQ(line.find("Against the baseline " + out_), 0U) << line;
  EXPECT_NE(line.find("nothing new"), std::string::npos) << line;

  const json report = json::parse(content_of(std::filesystem::path(out) / "report.json"));
  EXPECT_EQ(report.at("exit_status"), 0);
  EXPECT_TRUE(report.at("baseline").at("new").empty());
  EXPECT_FALSE(report.at("baseline").at("known").empty());
  EXPECT_EQ(report.at("subjects").at(0).at("status"), "violated") << "the verdict stays what it is";

  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((std::filesystem::path(out) / "junit.xml").c_str()));
  EXPECT_EQ(junit.child("testsuites").attribute("failures").as_int(-1), 0);
  EXPECT_GT(junit.child("testsuites").attribute("skipped").as_int(), 0);
  EXPECT_TRUE(junit.select_node("//skipped[contains(@message, 'known from the baseline')]"));

  const std::string page = content_of(std::filesystem::path(out) / "report.html");
  EXPECT_NE(page.find("Against the baseline"), std::string::npos);
  EXPECT_EQ(content_of(std::filesystem::path(out_) / "report.html").find("Against the baseline"), std::string::npos);
}

TEST_F(Baseline, WhatIsNewFails) {
  const std::string out = (directory_.path() / "second").string();
  const RunResult result = run({"--baseline", baseline_where_held("restitution"), "--out", out});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_NE(result.output.find("restitution  head_on ("), std::string::npos) << result.output;
  const json report = json::parse(content_of(std::filesystem::path(out) / "report.json"));
  EXPECT_EQ(report.at("exit_status"), 1);
  EXPECT_EQ(report.at("baseline").at("new").at(0).at("invariant"), "restitution");
  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((std::filesystem::path(out) / "junit.xml").c_str()));
  EXPECT_TRUE(junit.select_node("//testcase[@name = 'restitution']/failure"));
  EXPECT_TRUE(junit.select_node("//testcase[@name = 'backward_error']/skipped"));
}

TEST_F(Baseline, SaysTheSameAsACompareOfBothReports) {
  const std::string out = (directory_.path() / "second").string();
  const std::string baseline = baseline_where_held("restitution");
  (void)run({"--baseline", baseline, "--out", out});
  const json report = json::parse(content_of(std::filesystem::path(out) / "report.json"));
  const json compared = json::parse(run_carom({"compare", baseline, out, "--format", "json"}).output);
  for (const char* list : {"new", "known", "fixed", "no_longer_judged", "differences", "came", "went"}) {
    EXPECT_EQ(report.at("baseline").at(list), compared.at(list)) << list;
  }
}

TEST_F(Baseline, ASubjectThatCannotBeJudgedIsNoPass) {
  std::vector<std::string> arguments = of_a_faulty_subject;
  arguments.insert(arguments.begin() + 1, "exec:/no/such");
  arguments.insert(arguments.end(), {"--out", out_});
  EXPECT_EQ(run_carom(arguments).exit_status, 2);
  arguments.insert(arguments.end(), {"--baseline", out_});
  EXPECT_EQ(run_carom(arguments).exit_status, 2) << "also where it could not before";
}

TEST_F(Baseline, IsReadBeforeAnythingIsStarted) {
  const std::string started = (directory_.path() / "started").string();
  const std::string script = directory_.write("solver.sh", "touch " + started + "\n");
  const std::string bad = directory_.write("bad.json", R"({"carom": "0.1.0"})");
  const RunResult result = run_carom({"gate", "exec:/bin/sh " + script, "--baseline", bad});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_NE(result.errors.find("bad.json"), std::string::npos) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(started));
  (void)run_carom({"gate", "exec:/bin/sh " + script, "--cases", "1"});
  EXPECT_TRUE(std::filesystem::exists(started)) << "else the test could not fail";
}

TEST_F(Baseline, WantsAllThatIsViolated) {
  const RunResult result = run({"--baseline", out_, "--fail-fast"});
  EXPECT_EQ(result.exit_status, 2) << "the first violation may be a known one";
  EXPECT_NE(result.errors.find("--fail-fast"), std::string::npos) << result.errors;
}

}  // namespace
}  // namespace carom::tests
