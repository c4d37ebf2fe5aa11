// SPDX-License-Identifier: BSL-1.0
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const json& real_report() {
  static const json report = json::parse(
      run_carom({"gate", "frictionless-double", "reflection-in-basis-double", "--families", "head_on,generic",
                 "--deviates", few_families_judge_no, "--cases", "30", "--format", "json"})
          .output);
  return report;
}

json& count_of(json& report, const char* invariant) {
  return report.at("subjects").at(0).at("families").at(0).at("invariants").at(invariant);
}

json with_a_violation(json report) {
  count_of(report, "restitution") = {{"holds", 29}, {"violated", 1}, {"skipped", 0}};
  report.at("subjects").at(0)["status"] = "violated";
  report.at("subjects").at(0)["violations"] = {{{"invariant", "restitution"},
                                                {"count", 1},
                                                {"family", "head_on"},
                                                {"case", 3},
                                                {"witness", "witnesses/frictionless-double.restitution.json"}}};
  return report;
}

class CompareCommand : public testing::Test {
 protected:
  [[nodiscard]] RunResult compare(const json& before, const json& now, const std::string& format = "text") const {
    return run_carom({"compare", directory_.write("old.json", before.dump()), directory_.write("new.json", now.dump()),
                      "--format", format});
  }

  TemporaryDirectory directory_;
};

TEST_F(CompareCommand, EndsInZeroWhereNothingIsNew) {
  const RunResult same = compare(real_report(), real_report());
  EXPECT_EQ(same.exit_status, 0) << same.output << same.errors;
  EXPECT_NE(same.output.find("0 new, "), std::string::npos) << same.output;
  EXPECT_EQ(same.output.find("Not comparable"), std::string::npos) << same.output;
  EXPECT_EQ(compare(with_a_violation(real_report()), real_report()).exit_status, 0) << "what is fixed is no failure";
}

TEST_F(CompareCommand, EndsInOneWhereSomethingIsNew) {
  for (const char* format : {"text", "markdown", "html", "json"}) {
    const RunResult result = compare(real_report(), with_a_violation(real_report()), format);
    EXPECT_EQ(result.exit_status, 1) << format;
    EXPECT_NE(result.output.find("restitution"), std::string::npos) << format;
    EXPECT_TRUE(result.errors.empty()) << result.errors;
  }
}

TEST_F(CompareCommand, HasTheSameInEachForm) {
  const json now = with_a_violation(real_report());
  const json record = json::parse(compare(real_report(), now, "json").output);
  ASSERT_EQ(record.at("new").size(), 1U);
  EXPECT_EQ(record.at("new").at(0).at("subject"), "frictionless-double");
  EXPECT_EQ(record.at("new").at(0).at("family"), "head_on");
  EXPECT_EQ(record.at("new").at(0).at("judged_before"), true);
  EXPECT_GT(record.at("known").size(), 0U);
  EXPECT_TRUE(record.at("comparable").get<bool>());
  const std::string known = std::to_string(record.at("known").size()) + " known";
  for (const char* format : {"text", "markdown", "html"}) {
    const std::string output = compare(real_report(), now, format).output;
    EXPECT_NE(output.find("1 new, " + known), std::string::npos) << output;
  }
}

TEST_F(CompareCommand, HasALineAnInvariant) {
  json now = with_a_violation(real_report());
  now.at("subjects").at(0).at("families").at(1).at("invariants")["restitution"] = {
      {"holds", 0}, {"violated", 30}, {"skipped", 0}};
  for (const char* format : {"text", "html"}) {
    const std::string output = compare(real_report(), now, format).output;
    EXPECT_NE(output.find("head_on (1 of 30), generic (30 of 30)"), std::string::npos) << output;
  }
  const std::string back = compare(now, real_report()).output;
  EXPECT_NE(back.find("head_on (1 of 30 before), generic (30 of 30 before)"), std::string::npos) << back;
}

TEST_F(CompareCommand, TakesDirectories) {
  (void)directory_.write("report.json", real_report().dump());
  const RunResult result = run_carom({"compare", directory_.path().string(), directory_.path().string()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
}

TEST_F(CompareCommand, SaysWhereTheRunsAreNotComparable) {
  json other = real_report();
  other["seed"] = 2;
  other["cases_of_each_family"] = 20;
  const RunResult result = compare(real_report(), other);
  EXPECT_NE(result.output.find("Not comparable"), std::string::npos);
  EXPECT_NE(result.output.find("seed: 1 before, 2 now"), std::string::npos);
  EXPECT_NE(result.output.find("cases of each family: 30 before, 20 now"), std::string::npos);
}

TEST_F(CompareCommand, MakesAPageThatIsWellFormedAndRunsNothing) {
  json hostile = real_report();
  hostile.at("subjects").at(0)["name"] = "<script>alert(1)</script>\x1b[31m|`&";
  const std::string page = compare(real_report(), hostile, "html").output;
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(page.c_str())) << page;
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("Content-Security-Policy"), std::string::npos);
  for (const char* format : {"text", "markdown", "html", "json"}) {
    EXPECT_EQ(compare(real_report(), hostile, format).output.find('\x1b'), std::string::npos) << format;
  }
  const std::string markdown = compare(real_report(), hostile, "markdown").output;
  EXPECT_NE(markdown.find("| `<script>alert(1)</script>"), std::string::npos) << "as code:\n" << markdown;
}

TEST_F(CompareCommand, PassesOverFieldsThatItDoesNotKnow) {
  json newer = real_report();
  newer["diagnosis"] = {{"more", 1}};
  newer.at("subjects").at(0)["mood"] = "good";
  newer.at("subjects").at(0).at("families").at(0)["violated_cases"] = json::array({1, 2});
  EXPECT_EQ(compare(real_report(), newer).exit_status, 0);
}

TEST_F(CompareCommand, NamesFileAndPlaceOfWhatIsWrong) {
  const std::vector<std::pair<std::string, std::function<void(json&)>>> changes{
      {"/seed: is missing", [](json& r) { r.erase("seed"); }},
      {"/seed: expected a count", [](json& r) { r["seed"] = -1; }},
      {"/subjects: expected an array", [](json& r) { r["subjects"] = 3; }},
      {"/subjects/0/name: expected a string", [](json& r) { r["subjects"][0]["name"] = 3; }},
      {"/subjects/1/name: 'frictionless-double' occurs twice",
       [](json& r) { r["subjects"][1]["name"] = "frictionless-double"; }},
      {"/subjects/0/families/1/family: expected the family \"generic\"",
       [](json& r) { r["subjects"][0]["families"][1]["family"] = "head_on"; }},
      {"/subjects/0/families/0/invariants/restitution/holds: expected a count",
       [](json& r) { count_of(r, "restitution")["holds"] = 1.5; }},
      {"/environment/date: is missing", [](json& r) { r["environment"].erase("date"); }},
      {"/yardstick/limit_ulps: ", [](json& r) { r["yardstick"]["limit_ulps"] = "many"; }},
  };
  for (const auto& [place, change] : changes) {
    json bad = real_report();
    change(bad);
    const RunResult result = compare(bad, real_report());
    EXPECT_EQ(result.exit_status, 2) << place;
    EXPECT_NE(result.errors.find("old.json: this is not a report.json"), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find(place), std::string::npos) << place << '\n' << result.errors;
    EXPECT_TRUE(result.output.empty());
  }
  for (const std::string& text : {std::string(), std::string("{"), std::string("[]"), std::string("3")}) {
    const RunResult result =
        run_carom({"compare", directory_.write("old.json", text), directory_.write("new.json", real_report().dump())});
    EXPECT_EQ(result.exit_status, 2) << text;
    EXPECT_NE(result.errors.find("old.json"), std::string::npos) << result.errors;
  }
  EXPECT_EQ(run_carom({"compare", "/no/such", "/no/such"}).exit_status, 2);
  EXPECT_EQ(run_carom({"compare", "/no/such"}).exit_status, 2);
}

}  // namespace
}  // namespace carom::tests
