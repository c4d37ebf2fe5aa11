// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

using Subjects = std::vector<json>;

json subject(const std::string& status, std::size_t violated, bool counts = true) {
  return {{"counts", counts}, {"status", status}, {"violations", json(violated, json::object())}};
}

/// The badge of a report with these subjects, read again.
struct Badge {
  pugi::xml_document document;
  pugi::xml_node picture;
  std::string title;

  explicit Badge(const Subjects& subjects, bool interrupted = false) {
    const TemporaryDirectory directory;
    const std::string report =
        directory.write("report.json", json{{"interrupted", interrupted}, {"subjects", subjects}}.dump());
    const std::string file = (directory.path() / "carom.svg").string();
    const RunResult result = run_carom({"badge", report, "--out", file});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    EXPECT_TRUE(result.output.empty());
    EXPECT_EQ(run_carom({"badge", report}).output, content_of(file));
    EXPECT_TRUE(document.load_file(file.c_str(), pugi::parse_full));
    picture = document.child("svg");
    title = picture.child_value("title");
  }
};

TEST(Badge, SaysTheVerdictOnWhatCounts) {
  EXPECT_EQ(Badge(Subjects{subject("sound", 0), subject("violated", 5, false)}).title, "carom: sound");
  EXPECT_EQ(Badge(Subjects{subject("violated", 2), subject("sound", 0), subject("violated", 1)}).title,
            "carom: 3 violated");
  EXPECT_EQ(Badge(Subjects{subject("sound", 0), subject("error", 0)}).title, "carom: not judged");
  EXPECT_EQ(Badge(Subjects{subject("sound", 0), subject("not judged", 0)}).title, "carom: not judged");
  EXPECT_EQ(Badge(Subjects{subject("error", 1)}).title, "carom: 1 violated") << "what was found is said";
  EXPECT_EQ(Badge(Subjects{subject("sound", 0)}, true).title, "carom: not judged");
  EXPECT_EQ(Badge(Subjects{subject("sound", 0, false)}).title, "carom: not judged") << "nothing that counts";
}

/// Relative luminance (WCAG 2.1) of "#rrggbb".
double luminance(const std::string& colour) {
  double sum = 0;
  const double weights[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double channel = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum += weights[i] * (channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4));
  }
  return sum;
}

TEST(Badge, CanBeReadByEveryoneAndRefersToNothing) {
  for (const json& one : {subject("sound", 0), subject("violated", 12), subject("error", 0)}) {
    const Badge badge(Subjects{one});
    EXPECT_STREQ(badge.picture.attribute("role").value(), "img");
    EXPECT_EQ(badge.picture.attribute("aria-label").value(), badge.title);
    EXPECT_STREQ(badge.picture.attribute("xmlns").value(), "http://www.w3.org/2000/svg");
    int right = 0;
    std::string shown;
    for (const pugi::xml_node field : badge.picture.children("rect")) {
      EXPECT_EQ(field.attribute("x").as_int(), right);
      right += field.attribute("width").as_int();
      const double contrast = 1.05 / (luminance(field.attribute("fill").value()) + 0.05);
      EXPECT_GE(contrast, 4.5) << field.attribute("fill").value();
    }
    EXPECT_EQ(badge.picture.attribute("width").as_int(), right);
    for (const pugi::xml_node text : badge.picture.children("text")) {
      shown += (shown.empty() ? "" : ": ") + std::string(text.child_value());
    }
    EXPECT_EQ(shown, badge.title);
    EXPECT_TRUE(badge.picture.select_nodes("//*[@href or @style or self::script or self::image]").empty());
  }
}

TEST(Badge, OfTheGatesOwnReport) {
  const TemporaryDirectory out;
  static_cast<void>(run_carom(
      {"gate", "frictionless-double", "--families", "head_on", "--cases", "20", "--out", out.path().string()}));
  const RunResult result = run_carom({"badge", (out.path() / "report.json").string()});
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_NE(result.output.find("<title>carom: sound</title>"), std::string::npos) << result.output;
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
