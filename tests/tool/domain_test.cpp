// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

RunResult domain(std::vector<std::string> more) {
  more.insert(more.begin(), "domain");
  more.insert(more.end(), {"--cases", "2"});
  return run_carom(more);
}

/// J⁻¹ in world axes loses the angular momentum of slender bodies.
TEST(DomainCommand, MeasuresWhereASolverFailsAndWritesTheDomain) {
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
  EXPECT_EQ(run_carom({"gate", "reflection-world-double", "--within", file, "--cases", "2"}).exit_status, 0);
}

TEST(DomainCommand, SaysInWordsWhatItFound) {
  const RunResult result = domain({"frictionless-double"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  for (const char* said :
       {"the domain of frictionless-double, seed 1, limit 32 ulps", "The search starts from size=0.5:2",
        "moment_ratio            most      1e+08          1e+08  the search ends here", "fresh cases of this domain"}) {
    EXPECT_NE(result.output.find(said), std::string::npos) << said << '\n' << result.output;
  }
}

TEST(DomainCommand, ShowsAViolationWhereTheSearchStarts) {
  const RunResult result = domain({"reflection-in-basis-double", "--core", "speed=1:2,spin=0:0"});
  EXPECT_EQ(result.exit_status, 1) << result.output << result.errors;
  EXPECT_NE(result.output.find(" there, so it has no domain around these values. Choose other values by --core."),
            std::string::npos)
      << result.output;
}

TEST(DomainCommand, NeedsASubjectThatRuns) {
  EXPECT_EQ(domain({"exec:/no/such/program"}).exit_status, 2);
  EXPECT_EQ(domain({"no-such-subject"}).exit_status, 2);
  const RunResult empty = domain({"frictionless-double", "--core", "size=1:2,size_ratio=3:"});
  EXPECT_EQ(empty.exit_status, 2);
  EXPECT_NE(empty.errors.find("--core: no case of generic lies within size=1:2,size_ratio=3:"), std::string::npos)
      << empty.errors;
}

}  // namespace
}  // namespace carom::tests
