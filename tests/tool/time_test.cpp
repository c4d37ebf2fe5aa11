// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

TEST(TimeCommand, MeasuresAnEngineAndWritesItsReports) {
  const TemporaryDirectory directory;
  const std::string out = directory.path() / "time";
  const RunResult run = run_carom({"time", "scene", "--quick", "--phenomena", "bounce", "--out", out});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  unit::expect_in(run.output, {"scene", "bounce", "height of bounce"});
  for (const char* const file : {"report.html", "time.json", "junit.xml", "bounce-step.svg", "bounce-time.svg"}) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(out) / file)) << file << '\n' << run.errors;
  }
}

TEST(TimeCommand, RefusesNamesAndStepsThatAreNone) {
  const RunResult engine = run_carom({"time", "no-such-engine"});
  EXPECT_EQ(engine.exit_status, 2);
  unit::expect_in(engine.errors, {"no engine in time is named no-such-engine"});
  const RunResult phenomenon = run_carom({"time", "scene", "--phenomena", "bonce"});
  EXPECT_EQ(phenomenon.exit_status, 2);
  unit::expect_in(phenomenon.errors, {"no phenomenon is named bonce"});
  const RunResult step = run_carom({"time", "scene", "--steps", "1/0"});
  EXPECT_EQ(step.exit_status, 2);
  unit::expect_in(step.errors, {"--steps: expected a number of seconds"});
}

}  // namespace
}  // namespace carom::tests
