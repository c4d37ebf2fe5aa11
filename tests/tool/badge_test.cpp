// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

TEST(Badge, OfTheGatesOwnReport) {
  const TemporaryDirectory out;
  static_cast<void>(run_carom({"gate", "frictionless-double", "--families", "head_on", "--deviates",
                               few_families_judge_no, "--cases", "20", "--out", out.path().string()}));
  const std::string report = (out.path() / "report.json").string();
  const std::string file = (out.path() / "badge.json").string();
  const RunResult printed = run_carom({"badge", report});
  EXPECT_EQ(printed.exit_status, 0);
  EXPECT_EQ(nlohmann::json::parse(printed.output).at("message"), "1 sound");
  EXPECT_EQ(run_carom({"badge", report, "--out", file}).exit_status, 0);
  EXPECT_EQ(content_of(file), printed.output);
}

TEST(Badge, OfWhatIsNoReportIsAnErrorThatNamesTheFile) {
  const TemporaryDirectory directory;
  for (const char* text : {"", "[]", "{}", "{\"interrupted\": false, \"subjects\": [{}]}", "no JSON"}) {
    const std::string file = directory.write("report.json", text);
    const RunResult result = run_carom({"badge", file});
    EXPECT_EQ(result.exit_status, 2) << text;
    EXPECT_TRUE(result.errors.starts_with("carom: " + file + ": ")) << result.errors;
  }
  EXPECT_EQ(run_carom({"badge", "/no/such/report.json"}).exit_status, 2);
}

}  // namespace
}  // namespace carom::tests
