// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

RunResult domain(const std::vector<std::string>& more) { return run_carom({"domain", "--cases", "2"}, more); }

/// The schema accepts the record, and does not accept it with another field.
void expect_schema_accepts(json record) {
  const TemporaryDirectory directory;
  const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/domain.schema.json";
  const std::string file = directory.write("accepted.json", record.dump());
  record["mood"] = "good";
  const std::string rejected = directory.write("rejected.json", record.dump());
  EXPECT_EQ(accepted_by(schema, {file, rejected}), std::vector<std::string>{file});
}

/// J⁻¹ in world axes loses the angular momentum of slender bodies.
TEST(DomainCommand, MeasuresWhereASolverFailsAndTheDomainThatItWritesIsSound) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "domain.json").string();
  const RunResult result = domain({"reflection-world-double", "--out", file, "--format", "json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  EXPECT_EQ(record.at("subject"), "reflection-world-double");
  EXPECT_EQ(record.at("faces").size(), 18U);
  std::vector<std::string> failing;
  for (const json& face : record.at("faces")) {
    if (!face.at("beyond").is_null()) {
      failing.push_back(face.at("quantity"));
      EXPECT_TRUE(face.at("beyond").contains("collision")) << face;
      EXPECT_FALSE(face.at("beyond").at("invariant").get<std::string>().empty()) << face;
    }
  }
  EXPECT_EQ(failing, std::vector<std::string>{"moment_ratio"});
  EXPECT_EQ(json::parse(content_of(file)), record.at("domain"));
  EXPECT_GT(record.at("cases"), 0);
  EXPECT_EQ(record.at("not_judged").at("at_declared_limit"), 0);
  EXPECT_EQ(run_carom({"gate", "reflection-world-double", "--within", file, "--cases", "5"}).exit_status, 0);
}

TEST(DomainCommand, WithoutDigitsPrintsAndDrawsOnlyWhereASubjectHolds) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "domain.svg").string();
  const RunResult result = domain({"frictionless-double", "--picture", file, "--deviates", "backward_error"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output, {"moment_ratio            most      1e+08          1e+08  the search ends here",
                                  "\nNot judged: backward_error.\n"});
  const std::string picture = content_of(file);
  EXPECT_EQ(picture.find("loses digits"), std::string::npos);
  unit::expect_in(picture, {">games<"});
}

TEST(DomainCommand, EndsInOneIfTheSubjectFailsWhereTheSearchStarts) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "domain.json").string();
  const std::vector<std::string> subject{"reflection-in-basis-double", "--core", "speed=1:2,spin=0:0"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = subject;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return domain(arguments);
  };
  const RunResult result = with({"--out", file});
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(result.exit_status, 1) << result.output << result.errors;
  unit::expect_in(result.output, {" in these ranges, so it has no domain around them. Choose other ranges by --core."});

  const json before = json::parse(with({"--format", "json"}).output);
  const std::string invariant = before.at("in_core").at("invariant");
  const json after = json::parse(with({"--format", "json", "--deviates", invariant}).output);
  EXPECT_EQ(after.at("deviates"), json::array({invariant}));
  EXPECT_FALSE(before.contains("deviates"));
  ASSERT_TRUE(after.contains("in_core")) << after;
  EXPECT_NE(after.at("in_core").at("invariant"), invariant);
  expect_schema_accepts(after);
}

/// In binary32, rounding passes 32 ulps of itself long before it passes three digits.
TEST(DomainCommand, WithDigitsDrawsWhereASubjectHoldsLosesDigitsAndFails) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "domain.svg").string();
  const RunResult result = domain({"reflection-world-float", "--digits", "3", "--picture", file, "--beside",
                                   "size=0.1:10,restitution=:0.9", "--format", "json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  expect_schema_accepts(record);
  const auto end_of_moments = [](const json& ends) {
    for (const json& face : ends.at("faces")) {
      if (face.at("quantity") == "moment_ratio") {
        return face.at("value").get<double>();
      }
    }
    return 0.0;
  };
  const double end = end_of_moments(record);
  const double stricter_end = end_of_moments(record.at("stricter"));
  EXPECT_GT(end, 2 * stricter_end);
  EXPECT_GT(stricter_end, 2);

  pugi::xml_document picture;
  ASSERT_TRUE(picture.load_file(file.c_str()));
  EXPECT_EQ(picture.select_nodes("/svg/g[@class='bar']").size(), 12U);
  const auto bar = [&](const char* quantity) {
    return picture.select_node((std::string("/svg/g[@class='bar'][text='") + quantity + "']").c_str()).node();
  };
  const auto count = [](const pugi::xml_node& node, const char* colour) {
    return node.select_nodes((std::string("rect[@fill='") + colour + "']").c_str()).size();
  };
  constexpr const char* blue = "#0072b2";
  constexpr const char* orange = "#e69f00";
  constexpr const char* black = "#000000";
  EXPECT_EQ(count(bar("moment_ratio"), blue), 1U);
  EXPECT_EQ(count(bar("moment_ratio"), orange), 1U);
  for (const char* quantity : {"size", "restitution"}) {
    EXPECT_EQ(count(bar(quantity), black), 1U) << quantity;
  }
  EXPECT_EQ(count(bar("mass"), black), 0U);
  unit::expect_in(content_of(file), {"holds to 32 ulps", "loses digits, holds to 3 digits", "fails", "kg"});
}

}  // namespace
}  // namespace carom::tests
