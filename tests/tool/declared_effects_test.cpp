// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

const std::string threshold = R"({"restitution_threshold": 0.5})";

/// A sound program that declares effects which it does not have.
std::string declaring(const std::string& claims) {
  return std::string("exec:") + CAROM_MISBEHAVING + " 'claims=" + claims + "' declaring";
}

/// A program that does nothing, and declares a slop that excuses this.
std::string idle() { return std::string("exec:") + CAROM_MISBEHAVING + R"( 'idle={"slop":1e300}' idle)"; }

RunResult gate(const std::string& claims, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"gate",       declaring(claims),     "--families", "generic",
                                     "--deviates", few_families_judge_no, "--cases",    "20"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_carom(arguments);
}

TEST(DeclaredEffects, AreInTheReportInAReplayAndInAComparison) {
  const TemporaryDirectory directory;
  const std::string out = (directory.path() / "run").string();
  const RunResult result = gate(threshold, {"--out", out});
  EXPECT_EQ(result.exit_status, 1) << result.errors;
  EXPECT_NE(result.output.find("judged without its declared effects: restitution_threshold 0.5 m/s"), std::string::npos)
      << result.output;
  const json report = json::parse(content_of(out + "/report.json"));
  EXPECT_EQ(report.at("subjects")[0].at("claims"), json::parse(threshold));
  const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/report.schema.json";
  EXPECT_EQ(accepted_by(schema, {out + "/report.json"}).size(), 1U);
  EXPECT_NE(content_of(out + "/report.html").find("The subject declares restitution_threshold 0.5 m/s."),
            std::string::npos);
  const std::string witness = report.at("subjects")[0].at("violations")[0].at("witness");
  const RunResult replayed = run_carom({"replay", out + "/" + witness, "--subject", declaring(threshold)});
  EXPECT_EQ(replayed.exit_status, 1) << replayed.errors;
  EXPECT_NE(replayed.output.find("declaring declares restitution_threshold 0.5 m/s"), std::string::npos)
      << replayed.output;
  const std::string before = (directory.path() / "before").string();
  EXPECT_EQ(gate("{}", {"--out", before}).exit_status, 0);
  const RunResult compared = run_carom({"compare", before, out});
  EXPECT_NE(compared.output.find("the law without restitution_threshold 0.5 m/s"), std::string::npos)
      << compared.output << "a new effect is claimed no longer";
}

TEST(DeclaredEffects, ThatDecideTooManyCasesAreNotJudged) {
  const TemporaryDirectory directory;
  const std::string out = (directory.path() / "run").string();
  const RunResult result =
      run_carom({"gate", idle(), "--families", "generic", "--cases", "20", "--out", out, "--summary", out + ".md"});
  EXPECT_EQ(result.exit_status, 2) << result.output << result.errors;
  const std::string why = "the declared slop 1e+300 m/s decides 20 of 20 colliding cases, which is more than a tenth";
  for (const std::string& text : {result.output, content_of(out + ".md"), content_of(out + "/report.html"),
                                  content_of(out + "/report.json"), content_of(out + "/junit.xml")}) {
    EXPECT_NE(text.find(why), std::string::npos) << text;
  }
  EXPECT_NE(result.output.find("decided by a declared effect: slop in 20 of 20 colliding cases"), std::string::npos);
  const json subject = json::parse(content_of(out + "/report.json")).at("subjects")[0];
  EXPECT_EQ(subject.at("status"), "not judged");
  EXPECT_EQ(subject.at("families")[0].at("decided_by"), json({{"slop", 20}}));
  const std::string schema = std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/report.schema.json";
  EXPECT_EQ(accepted_by(schema, {out + "/report.json"}).size(), 1U);
}

/// The shards add up what the effects decide.
TEST(DeclaredEffects, DecideTheSameCasesInShards) {
  const TemporaryDirectory directory;
  const auto path = [&](const char* name) { return (directory.path() / name).string(); };
  const std::vector<std::string> run{"gate", idle(), "--families", "generic", "--cases", "20"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), run.begin(), run.end());
    return run_carom(more);
  };
  (void)with({"--shard", "1/2", "--out", path("first")});
  (void)with({"--shard", "2/2", "--out", path("second")});
  const RunResult merged = run_carom({"merge", "--out", path("merged"), path("first"), path("second")});
  EXPECT_EQ(merged.exit_status, 2) << merged.errors;
  EXPECT_NE(merged.output.find("slop 1e+300 m/s decides 20 of 20 colliding cases"), std::string::npos) << merged.output;
}

}  // namespace
}  // namespace carom::tests
