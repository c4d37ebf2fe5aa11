// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

/// The gate finds programs that misread a permitted spelling (way to write a collision), and the witness replays.
namespace carom::tests {
namespace {

using nlohmann::json;

std::string misreading(const std::string& what) {
  return std::string("exec:") + CAROM_MISBEHAVING + ' ' + what + " misreading";
}

class Misreading : public testing::TestWithParam<const char*> {};

TEST_P(Misreading, IsAViolationWhoseWitnessReplays) {
  const TemporaryDirectory out;
  const RunResult run = run_carom({"gate", misreading(GetParam()), "--families", "generic,immovable_b,structured",
                                   "--cases", "6", "--jobs", "1", "--out", out.path().string()});
  EXPECT_EQ(run.exit_status, 1) << run.output << run.errors;
  const json subject = json::parse(content_of(out.path() / "report.json")).at("subjects").at(0);
  EXPECT_EQ(subject.at("status"), "violated");
  const json& violations = subject.at("violations");
  ASSERT_FALSE(violations.empty());
  const std::string witness = (out.path() / violations.at(0).at("witness").get<std::string>()).string();
  const RunResult replayed = run_carom({"replay", witness, "--subject", misreading(GetParam())});
  EXPECT_EQ(replayed.exit_status, 1) << replayed.output << replayed.errors;
}

INSTANTIATE_TEST_SUITE_P(Each, Misreading,
                         testing::Values("exponent-dropped", "capital-exponent-dropped", "integer-by-ten",
                                         "left-out-is-immovable", "written-is-immovable", "left-out-orientation",
                                         "left-out-friction", "first-is-a", "no-tabs"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Hexadecimal numbers have one spelling, so a replay does not count spellings.
TEST(WrongInHex, HasAWitnessThatReplays) {
  const std::string subject = std::string("exec:") + CAROM_WELL_BEHAVED + " reflection-adjugate-float hex";
  const TemporaryDirectory out;
  const RunResult run = run_carom({"gate", subject, "--families", "mass_scale", "--cases", "100", "--relations-every",
                                   "1", "--jobs", "1", "--out", out.path().string()});
  EXPECT_EQ(run.exit_status, 1) << run.output << run.errors;
  const json report = json::parse(content_of(out.path() / "report.json"));
  const json& violations = report.at("subjects").at(0).at("violations");
  ASSERT_FALSE(violations.empty());
  const std::string witness = (out.path() / violations.at(0).at("witness").get<std::string>()).string();
  const RunResult replayed = run_carom({"replay", witness, "--subject", subject, "--format", "json"});
  EXPECT_EQ(replayed.exit_status, 1) << replayed.output << replayed.errors;
  EXPECT_EQ(replayed.output.find("spellings"), std::string::npos) << replayed.output;
  unit::expect_in(replayed.output, {"memoryless"});
}

}  // namespace
}  // namespace carom::tests
