// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/properties/cases/domain.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const std::string small_bodies = "size=0.001:0.01,restitution=:0.5";
const std::string never_judged = std::string(few_families_judge_no) + ",unit_scaling";

RunResult gate(const TemporaryDirectory& directory, const std::string& name, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"gate",
                                     "reflection-in-basis-double",
                                     "frictionless-double",
                                     "--families",
                                     "head_on",
                                     "--deviates",
                                     never_judged,
                                     "--cases",
                                     "30",
                                     "--out",
                                     (directory.path() / name).string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_carom(arguments);
}

json report_in(const TemporaryDirectory& directory, const std::string& name) {
  return json::parse(content_of(directory.path() / name / "report.json"));
}

TEST(Within, LeavesOutFamiliesThatHaveNoCase) {
  const TemporaryDirectory directory;
  const std::vector<std::string> arguments{
      "gate",     "frictionless-double",  "--cases", "2",
      "--within", "restitution=0.25:0.5", "--out",   (directory.path() / "run").string()};
  const RunResult result = run_carom(arguments);
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_NE(result.output.find("The domain has no case of inelastic, elastic."), std::string::npos) << result.output;
  EXPECT_EQ(report_in(directory, "run").at("without_case"), json({"inelastic", "elastic"}));
}

TEST(Within, IsTheSameByNameTextAndFile) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("domain.json", R"({"size": [0.1, 10], "speed": [null, 500],
                                                             "distance": [null, 500], "friction": [null, 1]})");
  const std::vector<std::string> replay{"replay", "--family", "structured", "--case", "7", "--within"};
  const auto shown = [&](const std::string& domain) {
    std::vector<std::string> arguments = replay;
    arguments.push_back(domain);
    const RunResult result = run_carom(arguments);
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return result.output;
  };
  EXPECT_EQ(shown("games"), shown(file));
  EXPECT_EQ(shown("games"), shown("size=0.1:10,speed=:500,distance=:500,friction=:1"));
  EXPECT_NE(shown("games"), shown("everything"));
}

std::string declaring(const std::string& domain, const std::string& name) {
  return std::string("exec:") + CAROM_MISBEHAVING + " 'domain=" + domain + "' " + name;
}

TEST(Within, MayBeDeclaredByAProgram) {
  const std::vector<std::string> head_on{"--families", "head_on", "--deviates", never_judged, "--cases", "4"};
  const auto judged = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "gate");
    arguments.insert(arguments.end(), head_on.begin(), head_on.end());
    return run_carom(arguments);
  };
  const std::string small = declaring(R"({"size": [0.001, 0.01]})", "small");
  const std::string large = declaring(R"({"size": [10, null]})", "large");
  const RunResult declared = judged({small});
  EXPECT_EQ(declared.exit_status, 0) << declared.output << declared.errors;
  EXPECT_NE(declared.output.find(" within size=0.001:0.01,"), std::string::npos) << declared.output;
  EXPECT_NE(judged({small, "--within", "games"}).output.find(" within size=0.1:10,"), std::string::npos);
  const RunResult different = judged({small, large});
  EXPECT_EQ(different.exit_status, 2);
  EXPECT_NE(different.errors.find("small declares the domain size=0.001:0.01, and large declares size=10:"),
            std::string::npos)
      << different.errors;
  const RunResult unknown = judged({declaring(R"({"colour": [1, 2]})", "odd")});
  EXPECT_EQ(unknown.exit_status, 2);
  EXPECT_NE(unknown.errors.find("odd: the domain in the reply to start: 'colour=1:2' names no quantity"),
            std::string::npos)
      << unknown.errors;
}

TEST(Within, IsInTheReportHoldsTheWitnessesAndIsTheSameInShards) {
  const TemporaryDirectory directory;
  const RunResult result = gate(directory, "whole", {"--within", small_bodies});
  EXPECT_EQ(result.exit_status, 1) << result.errors;
  EXPECT_NE(result.output.substr(0, result.output.find('\n')).find(" within " + small_bodies), std::string::npos)
      << result.output.substr(0, 200);
  const json whole = report_in(directory, "whole");
  EXPECT_EQ(whole.at("within"), json::parse(R"({"size": [0.001, 0.01], "restitution": [null, 0.5]})"));
  const properties::Domain domain = properties::domain_from(small_bodies);
  const json violations = whole.at("subjects")[0].at("violations");
  EXPECT_FALSE(violations.empty());
  for (const json& violation : violations) {
    const json witness =
        json::parse(content_of(directory.path() / "whole" / violation.at("witness").get<std::string>()));
    for (const char* collision : {"collision", "drawn"}) {
      EXPECT_TRUE(contains(domain, collision_from_json(witness.at(collision)))) << witness.at(collision);
    }
  }

  (void)gate(directory, "first", {"--within", small_bodies, "--shard", "1/2"});
  (void)gate(directory, "second", {"--within", small_bodies, "--shard", "2/2"});
  (void)gate(directory, "other", {"--shard", "2/2"});
  const auto path = [&](const char* name) { return (directory.path() / name).string(); };
  const RunResult merged = run_carom({"merge", "--out", path("merged"), path("first"), path("second")});
  EXPECT_EQ(merged.exit_status, 1) << merged.errors;
  const json sum = report_in(directory, "merged");
  EXPECT_EQ(sum.at("within"), whole.at("within"));
  EXPECT_EQ(sum.at("families"), whole.at("families"));
  const RunResult different = run_carom({"merge", "--out", path("wrong"), path("first"), path("other")});
  EXPECT_EQ(different.exit_status, 2);
  EXPECT_NE(different.errors.find("within: " + small_bodies), std::string::npos) << different.errors;
}

/// Just below 1 : 8, the solvers compute torques by plain cross products (impulse/principal_inertia.hpp). A cheaper
/// form of J⁻¹, τ/I₃ + Σ (1/I_k − 1/I₃) e_k (e_k·τ), violates `sticks` here.
TEST(Within, BodiesThatAreAlmostSlenderAreSolvedSoundly) {
  const RunResult result =
      run_carom({"gate", "reflection-double", "frictionless-double", "sticking-double", "rough-double",
                 "coulomb-double", "sticking-float", "reflection-float", "--families", "needle_tip", "--deviates",
                 never_judged, "--within", "moment_ratio=4:8", "--cases", "2000"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
}

}  // namespace
}  // namespace carom::tests
