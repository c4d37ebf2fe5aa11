// SPDX-License-Identifier: BSL-1.0
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

using Subjects = std::vector<json>;

json subject(const std::string& status, std::size_t violated, bool counts = true) {
  return {{"counts", counts}, {"status", status}, {"violations", json(violated, json::object())}};
}

/// The badge of a report with these subjects. A file and standard output get the same.
json badge(const Subjects& subjects, bool interrupted = false) {
  const TemporaryDirectory directory;
  const std::string report =
      directory.write("report.json", json{{"interrupted", interrupted}, {"subjects", subjects}}.dump());
  const std::string file = (directory.path() / "badge.json").string();
  const RunResult result = run_carom({"badge", report, "--out", file});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_TRUE(result.output.empty());
  EXPECT_EQ(run_carom({"badge", report}).output, content_of(file));
  return json::parse(content_of(file));
}

json expected(const std::string& message, const std::string& colour) {
  return {{"schemaVersion", 1}, {"label", "carom"}, {"message", message}, {"color", colour}};
}

TEST(Badge, SaysTheVerdictOnWhatCounts) {
  EXPECT_EQ(badge({subject("sound", 0), subject("violated", 5, false)}), expected("1 sound", "brightgreen"));
  EXPECT_EQ(badge({subject("sound", 0), subject("sound", 0)}), expected("2 sound", "brightgreen"));
  EXPECT_EQ(badge({subject("violated", 2), subject("sound", 0), subject("violated", 1)}),
            expected("3 violated", "red"));
  EXPECT_EQ(badge({subject("error", 1)}), expected("1 violated", "red")) << "a violation comes first";
  const json not_judged = expected("not judged", "lightgrey");
  EXPECT_EQ(badge({subject("sound", 0), subject("error", 0)}), not_judged);
  EXPECT_EQ(badge({subject("sound", 0), subject("not judged", 0)}), not_judged);
  EXPECT_EQ(badge(Subjects{subject("sound", 0)}, true), not_judged) << "the run was interrupted";
  EXPECT_EQ(badge(Subjects{subject("sound", 0, false)}), not_judged) << "no subject counts";
}

TEST(Badge, OfTheGatesOwnReport) {
  const TemporaryDirectory out;
  static_cast<void>(run_carom(
      {"gate", "frictionless-double", "--families", "head_on", "--cases", "20", "--out", out.path().string()}));
  const RunResult result = run_carom({"badge", (out.path() / "report.json").string()});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(json::parse(result.output), expected("1 sound", "brightgreen"));
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
