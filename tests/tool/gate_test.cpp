// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

TEST(GateCommand, EndsInZeroForSoundSubjects) {
  const RunResult result = run_carom({"gate", "frictionless-double", "reflection-float", "--cases", "20"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
  EXPECT_TRUE(result.errors.empty()) << "progress belongs on a terminal alone: " << result.errors;
}

TEST(GateCommand, JudgesOneSolverOfEachLawUnlessAllAreAskedFor) {
  const auto judges = [](const std::vector<std::string>& arguments, const std::string& name) {
    const json report =
        json::parse(run_carom(arguments, {"--cases", "1", "--families", "head_on", "--format", "json"}).output);
    return std::ranges::any_of(report.at("subjects"), [&](const json& one) { return one.at("name") == name; });
  };
  for (const char* name : {"frictionless-double", "reflection-double", "sticking-double", "rough-double",
                           "coulomb-double", "reflection-in-basis-double"}) {
    EXPECT_TRUE(judges({"gate"}, name)) << name;
  }
  EXPECT_FALSE(judges({"gate"}, "reflection-llt-float"));
  EXPECT_TRUE(judges({"gate", "--all"}, "reflection-llt-float"));
  EXPECT_FALSE(judges({"gate", "rough-float"}, "rough-double"));
  EXPECT_TRUE(judges({"gate", "rough-float", "--all"}, "rough-double"));
}

TEST(GateCommand, FindsTheNotesMethodFaultyNearHeadOnAndItsWitnessReplaysShrunkAndDrawn) {
  const TemporaryDirectory out;
  const RunResult result = run_carom({"gate", "reflection-in-basis-double", "--families", "near_head_on", "--cases",
                                      "200", "--out", out.path().string()});
  EXPECT_EQ(result.exit_status, 1);
  const auto file = out.path() / "witnesses" / "reflection-in-basis-double.restitution.json";
  ASSERT_TRUE(std::filesystem::exists(file)) << result.output;
  const json witness = json::parse(content_of(file));
  EXPECT_EQ(witness.at("family"), "near_head_on");

  // Every number of the shrunk collision is a multiple of 1/32.
  for (const char* body : {"a", "b"}) {
    for (const char* field : {"position", "velocity", "angular_velocity"}) {
      for (const json& number : witness.at("collision").at(body).at(field)) {
        const double scaled = number.get<double>() * 32;
        EXPECT_EQ(scaled, static_cast<double>(static_cast<int>(scaled))) << body << ' ' << field;
      }
    }
  }

  const RunResult replayed = run_carom({"replay", file.string(), "--format", "json"});
  EXPECT_EQ(replayed.exit_status, 1);
  EXPECT_EQ(json::parse(replayed.output).at("verdicts").at("restitution"), witness.at("verdict"));
  const RunResult other = run_carom({"replay", file.string(), "--subject", "reflection-double"});
  EXPECT_EQ(other.exit_status, 0) << other.output;
  const json drawn = json::parse(run_carom({"replay", file.string(), "--drawn", "--format", "json"}).output);
  EXPECT_EQ(drawn.at("collision"), witness.at("drawn"));
  EXPECT_EQ(drawn.at("verdicts").at("restitution"), witness.at("drawn_verdict"));
  const RunResult numbered =
      run_carom({"replay", "--family", "near_head_on", "--case", std::to_string(witness.at("case").get<int>()),
                 "--subject", "reflection-in-basis-double", "--format", "json"});
  EXPECT_EQ(numbered.exit_status, 1) << numbered.errors;
  EXPECT_EQ(json::parse(numbered.output).at("collision"), witness.at("drawn"));
}

TEST(GateCommand, GivesTheSameReportForTheSameSeedOnAnyNumberOfThreads) {
  const auto report = [](const std::string& seed, const std::string& jobs) {
    const RunResult result =
        run_carom({"gate", "frictionless-float", "reflection-in-basis-double", "--cases", "120", "--families",
                   "generic,head_on", "--format", "json", "--seed", seed, "--jobs", jobs});
    json parsed = json::parse(result.output);
    parsed.at("environment").erase("date");
    for (json& subject : parsed.at("subjects")) {
      subject.erase("nanoseconds_per_solve");
    }
    return parsed;
  };
  EXPECT_EQ(report("5", "1"), report("5", "3"));
  EXPECT_NE(report("5", "1").at("subjects"), report("6", "1").at("subjects"));
}

TEST(GateCommand, WithABudgetSaysHowManyCasesItWasEnoughFor) {
  const RunResult result = run_carom({"gate", "frictionless-double", "--families", "generic,separating", "--deviates",
                                      few_families_judge_no, "--budget", "0.2s"});
  EXPECT_EQ(result.exit_status, 0) << result.output;
  unit::expect_in(result.output, {"200 ms on 2 families in turn", "cases in 200 ms; the fewest cases are"});
}

TEST(GateCommand, WithDigitsJudgesByDigitsInPlaceOfUlps) {
  // The limit of a hundredth of an ulp is less than any rounding. Three digits are half of the digits of binary32.
  const std::vector<std::string> gate{"gate", "frictionless-float", "--families",         "elastic", "--cases",
                                      "40",   "--deviates",         few_families_judge_no};
  EXPECT_EQ(run_carom(gate, {"--limit-ulps", "0.01"}).exit_status, 1);
  EXPECT_EQ(run_carom(gate, {"--digits", "3"}).exit_status, 0);
}

/// tests/equality shows that the counts are the same.
TEST(GateCommand, WithExactSaysSo) {
  const auto with = [&](const std::vector<std::string>& more) {
    return run_carom({"gate", "reflection-in-basis-double", "--families", "near_head_on", "--cases", "10"}, more)
        .output;
  };
  EXPECT_EQ(json::parse(with({"--format", "json", "--exact"})).at("yardstick").at("exact"), true);
  unit::expect_in(with({"--exact", "--out", TemporaryDirectory().path()}),
                  {"judged only in exact arithmetic", " --exact\n"});  // the last stands in the command that replays
  EXPECT_EQ(with({}).find("exact arithmetic"), std::string::npos);
}

TEST(GateCommand, TakesOneWordForAnOptionOfNamesSoThatASubjectMayFollow) {
  const RunResult run = run_carom({"gate", "--families", "generic,head_on", "frictionless-double", "--families",
                                   "elastic", "--deviates", few_families_judge_no, "--cases", "2", "--format", "json"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  const json report = json::parse(run.output);
  EXPECT_EQ(report.at("subjects").size(), 1U);
  EXPECT_EQ(report.at("subjects").at(0).at("families").size(), 3U);
}

TEST(GateCommand, NamesAWorkingDirectoryThatDoesNotExistAnyMore) {
  const RunResult run = run_program(
      "/bin/sh", {"-c", R"(gone=$(mktemp -d); cd "$gone"; rmdir "$gone"; exec "$0" gate frictionless-double --out r)",
                  carom_program()});
  EXPECT_EQ(run.exit_status, 2);
  unit::expect_in(run.errors, {"the working directory does not exist any more"});
}

}  // namespace
}  // namespace carom::tests
