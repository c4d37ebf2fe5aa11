// SPDX-License-Identifier: BSL-1.0
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const json& judged_report() {
  static const json report = json::parse(run_carom({"gate", "frictionless-double", "reflection-in-basis-double",
                                                    "--families", "head_on", "--cases", "20", "--format", "json"})
                                             .output);
  return report;
}

json dated(json report, const std::string& date) {
  report.at("environment")["date"] = date;
  return report;
}

/// As if the faulty subject kept restitution.
json with_restitution_held(json report) {
  report.at("subjects").at(1).at("families").at(0).at("invariants")["restitution"] = {
      {"holds", 20}, {"violated", 0}, {"skipped", 0}};
  return report;
}

class TrendsCommand : public testing::Test {
 protected:
  TrendsCommand() {
    // The names are not in the order of the dates.
    std::filesystem::create_directories(directory_.path() / "reports" / "a");
    std::filesystem::create_directories(directory_.path() / "reports" / "b");
    (void)directory_.write("reports/a/report.json", dated(judged_report(), "2026-03-01T00:00:00Z").dump());
    (void)directory_.write("reports/b/report.json",
                           dated(with_restitution_held(judged_report()), "2026-02-01T00:00:00Z").dump());
    (void)directory_.write("reports/c.json", dated(judged_report(), "2026-01-01T00:00:00Z").dump());
  }

  [[nodiscard]] std::string reports() const { return (directory_.path() / "reports").string(); }
  [[nodiscard]] std::string out() const { return (directory_.path() / "out").string(); }

  TemporaryDirectory directory_;
};

/// The cells of the rows of the last table: a row a report.
std::vector<std::vector<std::string>> rows_of_last_subject(const pugi::xml_document& page) {
  std::vector<std::vector<std::string>> rows;
  for (const pugi::xpath_node& row : page.select_nodes("//section[last()]//tbody/tr")) {
    std::vector<std::string> cells;
    for (const pugi::xml_node cell : row.node().children()) {
      cells.emplace_back(cell.text().get());
    }
    rows.push_back(cells);
  }
  return rows;
}

TEST_F(TrendsCommand, TellsAtWhichReportSomethingWasFixedOrBroken) {
  const RunResult result = run_carom({"trends", reports(), "--format", "html", "--out", out()});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(result.output, content_of(std::filesystem::path(out()) / "trends.html"));
  EXPECT_NE(content_of(std::filesystem::path(out()) / "trends.md").find("reflection-in-basis-double"),
            std::string::npos);
  pugi::xml_document page;
  ASSERT_TRUE(page.load_string(result.output.c_str()));
  const auto rows = rows_of_last_subject(page);
  ASSERT_EQ(rows.size(), 3U);
  constexpr std::size_t became_violated = 8;
  constexpr std::size_t fixed = 9;
  EXPECT_EQ(rows[0][0], "2026-01-01T00:00:00Z");
  EXPECT_EQ(rows[1][0], "2026-02-01T00:00:00Z");
  EXPECT_EQ(rows[2][0], "2026-03-01T00:00:00Z");
  EXPECT_EQ(rows[0][became_violated], "") << "there is nothing before the first";
  EXPECT_EQ(rows[1][fixed], "restitution in head_on");
  EXPECT_EQ(rows[2][became_violated], "restitution in head_on");
  EXPECT_EQ(page.select_nodes("//svg").size(), 4U) << "two lines a subject";
  EXPECT_EQ(page.select_nodes("//section[last()]//svg[1]/circle").size(), 6U);
  EXPECT_EQ(result.output.find("<script"), std::string::npos);
}

TEST_F(TrendsCommand, TakesFilesAndReadsEachOnce) {
  const RunResult result =
      run_carom({"trends", reports() + "/c.json", reports() + "/c.json", reports() + "/a/report.json"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_NE(result.output.find("# 2 subjects in 2 reports"), std::string::npos) << result.output;
}

TEST_F(TrendsCommand, NamesWhatCannotBeReadAfterTheRest) {
  (void)directory_.write("reports/d.json", R"({"carom": 3})");
  const RunResult result = run_carom({"trends", reports(), "--out", out()});
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_NE(result.errors.find("d.json: is not a report.json"), std::string::npos) << result.errors;
  const std::string page = content_of(std::filesystem::path(out()) / "trends.html");
  EXPECT_NE(page.find("Not read: "), std::string::npos);
  EXPECT_NE(page.find("reflection-in-basis-double"), std::string::npos) << "the rest was shown";
}

TEST_F(TrendsCommand, WantsSomethingToShow) {
  const TemporaryDirectory empty;
  EXPECT_EQ(run_carom({"trends", empty.path().string()}).exit_status, 2);
  EXPECT_EQ(run_carom({"trends"}).exit_status, 2);
}

}  // namespace
}  // namespace carom::tests
