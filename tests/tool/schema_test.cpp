// SPDX-License-Identifier: BSL-1.0

#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/collision/law.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

constexpr const char* python = "/usr/bin/python3";
const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/report.schema.json";

RunResult validate(const std::string& report) {
  return run_program(python, {"-W", "ignore", "-m", "jsonschema", "-i", report, schema});
}

std::vector<std::string> absent_subject() {
  for (const json& subject : json::parse(run_carom({"subjects", "--format", "json"}).output)) {
    if (!subject.at("absent").get<std::string>().empty()) {
      return {subject.at("name")};
    }
  }
  return {};
}

json varied_report() {
  std::vector<std::string> arguments{"gate",
                                     "frictionless-double",
                                     "reflection-in-basis-double",
                                     "exec:/no/such",
                                     "--families",
                                     "head_on,invalid",
                                     "--cases",
                                     "30",
                                     "--deviates",
                                     few_families_judge_no,
                                     "--format",
                                     "json"};
  const std::vector<std::string> absent = absent_subject();
  arguments.insert(arguments.begin() + 1, absent.begin(), absent.end());
  json report = json::parse(run_carom(arguments).output);
  EXPECT_EQ(report.at("subjects").size(), 3 + absent.size());
  return report;
}

TEST(ReportSchema, DescribesTheReportOfADomain) {
  const TemporaryDirectory directory;
  const RunResult result = run_carom({"gate", "frictionless-double", "--cases", "2", "--format", "json", "--within",
                                      "restitution=0.25:0.5,size=0.1:10"});
  EXPECT_TRUE(json::parse(result.output).contains("without_case"));
  const RunResult validated = validate(directory.write("report.json", result.output));
  EXPECT_EQ(validated.exit_status, 0) << validated.output << validated.errors;
}

TEST(ReportSchema, DescribesARealReport) {
  const TemporaryDirectory directory;
  const json report = varied_report();
  std::vector<std::string> seen;
  for (const json& subject : report.at("subjects")) {
    seen.push_back(subject.at("status"));
  }
  seen.resize(3);
  EXPECT_EQ(seen, (std::vector<std::string>{"sound", "violated", "error"}));
  EXPECT_FALSE(report.at("interrupted").get<bool>());
  EXPECT_FALSE(report.at("environment").at("compiler").get<std::string>().empty());
  const RunResult result = validate(directory.write("report.json", report.dump()));
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
}

TEST(ReportSchema, KnowsEveryLaw) {
  const TemporaryDirectory directory;
  std::vector<std::string> arguments{"gate", "--families", "head_on", "--cases", "2", "--format", "json"};
  for (const Law law : all_laws) {
    if (law != Law::any) {
      arguments.push_back(std::string(name_of(law)) + "-double");
    }
  }
  const RunResult result = validate(directory.write("report.json", run_carom(arguments).output));
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
}

TEST(ReportSchema, DescribesReportsThatWereCutShort) {
  const TemporaryDirectory directory;
  const RunResult run = run_carom({"gate", "frictionless-double", "reflection-in-basis-double", "--families", "head_on",
                                   "--budget", "100ms", "--fail-fast", "--format", "json"});
  const json report = json::parse(run.output);
  EXPECT_EQ(report.at("budget_seconds"), 0.1);
  EXPECT_EQ(report.at("fail_fast"), true);
  EXPECT_TRUE(report.at("cases_of_each_family").is_null());
  const RunResult result = validate(directory.write("report.json", run.output));
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
  const std::string file = (directory.path() / "report.json").string();
  EXPECT_EQ(run_carom({"compare", file, file}).exit_status, 0);
}

TEST(ReportSchema, DescribesWhatABaselineAdds) {
  const TemporaryDirectory directory;
  const std::vector<std::string> arguments{"gate",
                                           "frictionless-double",
                                           "reflection-in-basis-double",
                                           "--families",
                                           "head_on,near_head_on",
                                           "--cases",
                                           "30",
                                           "--format",
                                           "json"};
  json before = json::parse(run_carom(arguments).output);
  json& count = before.at("subjects").at(1).at("families").at(0).at("invariants").at("restitution");
  count = {{"holds", 30}, {"violated", 0}, {"skipped", 0}};
  std::vector<std::string> later = arguments;
  later.insert(later.end(), {"--baseline", directory.write("before.json", before.dump()), "--relations-every", "2",
                             "--deviates", "restitution@near_head_on,energy"});
  const json report = json::parse(run_carom(later).output);
  for (const char* list : {"new", "known", "no_longer_judged", "differences"}) {
    EXPECT_FALSE(report.at("baseline").at(list).empty()) << list;
  }
  const RunResult result = validate(directory.write("report.json", report.dump()));
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
}

TEST(ReportSchema, DescribesAShard) {
  const TemporaryDirectory directory;
  const RunResult run = run_carom({"gate", "frictionless-double", "coulomb-double", "--families", "head_on,invalid",
                                   "--cases", "6", "--shard", "2/3", "--format", "json"});
  EXPECT_EQ(json::parse(run.output).at("shard").at("digits").size(), 2U);
  const RunResult result = validate(directory.write("report.json", run.output));
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
}

TEST(ReportSchema, RejectsWhatDiffers) {
  const TemporaryDirectory directory;
  const json report = varied_report();
  ASSERT_EQ(validate(directory.write("report.json", report.dump())).exit_status, 0) << "else everything is rejected";
  const std::vector<std::pair<const char*, std::function<void(json&)>>> changes{
      {"no environment", [](json& r) { r.erase("environment"); }},
      {"no date", [](json& r) { r.at("environment").erase("date"); }},
      {"flags of no library", [](json& r) { r.at("environment")["compiler_flags"] = json::object(); }},
      {"flags as one text", [](json& r) { r.at("environment")["compiler_flags"] = "-O3"; }},
      {"an unknown field", [](json& r) { r["mood"] = "good"; }},
      {"an unknown field of a subject", [](json& r) { r.at("subjects").at(0)["mood"] = "good"; }},
      {"an unknown status", [](json& r) { r.at("subjects").at(0)["status"] = "fine"; }},
      {"an error without a reason", [](json& r) { r.at("subjects").at(2)["error"] = ""; }},
      {"violated by nothing", [](json& r) { r.at("subjects").at(1)["violations"] = json::array(); }},
      {"a number as text", [](json& r) { r["seed"] = "1"; }},
      {"a negative count", [](json& r) { r.at("families").at(0).at("coverage")["cases"] = -1; }},
      {"an exit status that there is not", [](json& r) { r["exit_status"] = 3; }},
  };
  std::vector<std::string> files;
  for (const auto& [name, change] : changes) {
    json changed = report;
    change(changed);
    files.push_back(directory.write(name, changed.dump()));
  }
  EXPECT_EQ(accepted_by(schema, files), std::vector<std::string>{});
}

}  // namespace
}  // namespace carom::tests
