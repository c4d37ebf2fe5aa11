// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <carom/report/results/time_run.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

/// An engine in which nothing moves. Its spins count the steps. Arguments are its fault and its claims.
const char* const unmoving = R"(
import json, os, sys, time
fault, claims = sys.argv[1], sys.argv[2:]
for line in sys.stdin:
    request = json.loads(line)
    reply = {"id": request.get("id")}
    if request["cmd"] == "stop":
        break
    if request["cmd"] == "start":
        reply = {"protocol": 1, "name": "unmoving", "precision": "binary64", "time": True, "time_claims": claims,
                 "restores": True, "planar": fault == "planar"}
    elif request["cmd"] == "save":
        saved = done
    elif request["cmd"] == "restore":
        done = done if fault == "forget" else saved
    else:
        if "scene" in request:
            scene, done = request["scene"], 0
        if fault == "hang":
            time.sleep(1000)
        if fault == "crash under gravity" and any(scene["gravity"]):
            sys.exit("planted")
        still = {"orientation": [1, 0, 0, 0], "velocity": [0, 0, 0]}
        wrong = {"velocity": [0, "fast", 0]} if fault == "text" else {}
        reply["states"] = [[{**still, **body, "angular_velocity": [done + after, 0, 0], **wrong}
                            for body in scene["bodies"]] for after in request["report"]]
        reply["seconds"] = 1e-6 * request["steps"]
        done += request["steps"]
        if fault == "text" and not any(scene["gravity"]):  # what carom has written so far
            reply = {"id": request["id"], "skipped": open(f"/proc/{os.getppid()}/fd/2").read()}
    print(json.dumps(reply), flush=True)
)";

class TimeCommand : public testing::Test {
 protected:
  /// Runs `carom time` on an unmoving engine, quickly.
  [[nodiscard]] RunResult measured(const std::string& fault, const std::vector<std::string>& more,
                                   const std::vector<std::string>& claims = {}) const {
    std::string subject = "exec:/usr/bin/python3 '" + directory_.write("unmoving.py", unmoving) + "' '" + fault + '\'';
    for (const std::string& claim : claims) {
      subject += " '" + claim + '\'';
    }
    return run_carom({"time", subject, "--quick"}, more);
  }

  TemporaryDirectory directory_;
};

TEST_F(TimeCommand, MeasuresAnEngineAndWritesItsReports) {
  const std::string out = directory_.path() / "time";
  const std::string pages = directory_.path() / "pages";
  const RunResult run = measured("none", {"--phenomena", "bounce", "--out", out, "--pages", pages});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  unit::expect_in(run.output, {"unmoving", "bounce: height of bounce"});
  for (const char* const file : {"report.html", "time.json", "junit.xml", "bounce-step.svg", "bounce-time.svg",
                                 "first-bounce.svg", "../pages/bounce.md"}) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(out) / file)) << file << '\n' << run.errors;
  }
}

TEST_F(TimeCommand, FindsTheEventsOfTheSimulationExact) {
  const json record = json::parse(run_carom({"time", "scene", "--quick", "--phenomena",
                                             "bounce,slow-bounce,spin,slide-to-roll", "--format", "json"})
                                      .output);
  std::size_t judged = 0;
  for (const json& measurement : record.at("engines").at(0).at("measurements")) {
    for (const json& reading : measurement.at("readings")) {
      for (const json& rung : reading.at("rungs")) {
        ++judged;
        EXPECT_LE(rung.at("greatest").get<double>(), rung.at("rounding").get<double>()) << reading.at("what");
      }
    }
  }
  EXPECT_EQ(judged, 123U) << "at two steps: 25 or 26 readings of bounces, 7, 24 and 5";
}

// An engine in which nothing moves is 300 % off a rebound at half the speed.
TEST_F(TimeCommand, EndsInOneIfAClaimIsNotKept) {
  const std::vector<std::string> one{"--phenomena", "slow-bounce"};
  const RunResult kept = measured("none", one, {"slow-bounce within 301% at 1/60 s"});
  EXPECT_EQ(kept.exit_status, 0) << kept.output;
  unit::expect_in(kept.output, {"claims slow-bounce within 301% at 1/60 s: kept"});
  const std::string out = directory_.path() / "time";
  const RunResult broken = measured("none", {"--phenomena", "slow-bounce", "--out", out},
                                    {"slow-bounce within 5% at 1/60 s", "slow-bounce within 301% at 1/61 s"});
  EXPECT_EQ(broken.exit_status, 1);
  unit::expect_in(broken.output, {"within 5% at 1/60 s: NOT KEPT: speed after the impact, v = 0.1 m/s is off by",
                                  "within 301% at 1/61 s: NOT KEPT: the step was not measured"});
  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((out + "/junit.xml").c_str()));
  EXPECT_EQ(junit.select_nodes("//failure").size(), 2U);
  EXPECT_TRUE(junit.select_node("/testsuites[@tests = 3 and @failures = 2 and @errors = 0]"));
  const RunResult unreadable = measured("none", one, {"bonce within 5% at 1/60 s"});
  expect_error(unreadable, {"unmoving: time_claims: ", "bonce", "did you mean 'bounce'?"});
}

TEST_F(TimeCommand, EndsInTwoIfNoClaimWasJudged) {
  const std::string out = directory_.path() / "time";
  const RunResult run = measured("none", {"--phenomena", "slow-bounce", "--out", out}, {"slide within 5% at 1/60 s"});
  EXPECT_EQ(run.exit_status, 2);
  unit::expect_in(run.output, {"claims slide within 5% at 1/60 s: not judged: slide was not measured"});
  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((out + "/junit.xml").c_str()));
  EXPECT_TRUE(junit.select_node("//testcase[@name = 'claim: slide within 5% at 1/60 s']/skipped"));
}

TEST_F(TimeCommand, PrintsARecordThatItsSchemaAccepts) {
  const RunResult named =
      measured("crash under gravity", {"--steps", "1/60", "--format", "json"}, {"stack within 1% at 1/60 s"});
  const RunResult absent = run_carom({"time", "exec:/no/such", "--quick", "--format", "json"});
  json unknown = json::parse(named.output);
  EXPECT_EQ(unknown.at("exit_status"), 1);
  EXPECT_TRUE(unknown.at("engines").at(0).at("specification").get<std::string>().starts_with("exec:/usr/bin/python3"));
  unknown["engines"][0]["colour"] = "red";
  std::vector<std::string> files{directory_.write("named.json", named.output),
                                 directory_.write("absent.json", absent.output)};
  const std::vector<std::string> accepted = files;
  files.push_back(directory_.write("unknown.json", unknown.dump()));
  EXPECT_EQ(accepted_by(std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/time.schema.json", files), accepted);
}

TEST_F(TimeCommand, TellsAnEngineThatForgetsASavedState) {
  unit::expect_in(measured("forget", {"--phenomena", "heap"}).output,
                  {"saved at 1 s, run to the end, and restored: same places, other velocities until 2 s"});
}

TEST_F(TimeCommand, MeasuresTheHeapAlone) {
  const std::string out = directory_.path() / "time";
  const RunResult run = measured("none", {"--phenomena", "heap", "--out", out});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  unit::expect_in(run.output, {"run twice: same bits", "saved at 1 s, run to the end, and restored: same bits"});
  EXPECT_EQ(run.output.find("Median error"), std::string::npos) << "the table has no columns";
  EXPECT_TRUE(std::filesystem::exists(out + "/report.html"));
  EXPECT_EQ(measured("crash under gravity", {"--phenomena", "heap"}).exit_status, 1) << "the row of balls is answered";
  EXPECT_EQ(measured("text", {"--phenomena", "heap"}).exit_status, 2);
}

TEST_F(TimeCommand, SaysOnceWhyATableLacksNumbers) {
  const std::string reason = "free-rotation, 2 of 2 runs not posed: it has no set-up in the plane";
  const std::string output = measured("planar", {"--phenomena", "free-rotation,slow-bounce"}).output;
  EXPECT_EQ(output.find(reason), output.rfind(reason));
  unit::expect_in(output, {reason + " (unmoving)"});
  unit::expect_in(run_carom({"time", "scene", "--phenomena", "pass-through", "--steps", "1/60,1/120,1/240"}).output,
                  {"runs not posed: it is measured at longer steps alone (scene)"});
}

TEST_F(TimeCommand, EndsInOneIfANamedEngineFailsInPart) {
  const std::string out = directory_.path() / "time";
  const RunResult run = measured("crash under gravity", {"--phenomena", "bounce,slow-bounce", "--out", out});
  EXPECT_EQ(run.exit_status, 1);
  unit::expect_in(run.output, {"bounce, 3 of 60 runs failed: ", "status 1"});
  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((out + "/junit.xml").c_str()));
  EXPECT_TRUE(junit.select_node("//testcase[@name = 'bounce']/error"));
  EXPECT_FALSE(junit.select_node("//testcase[@name = 'slow-bounce']/error"));
}

TEST_F(TimeCommand, EndsInTwoIfNoReplyComes) {
  const RunResult hung = measured("hang", {"--phenomena", "bounce", "--timeout", "1"});
  EXPECT_EQ(hung.exit_status, 2);
  unit::expect_in(hung.output, {"bounce, 3 of 60 runs failed: ", "within 1 s"});
}

// The engine quotes standard error before the end.
TEST_F(TimeCommand, ShowsTheFirstFailureAtOnce) {
  const std::string first = "carom: unmoving, bounce: /states/0/0/velocity/1: expected";
  const RunResult run = measured("text", {"--phenomena", "bounce,slow-bounce"});
  unit::expect_in(run.output, {"bounce, 3 of 60 runs failed: /states/0/0/velocity/1: expected a number",
                               "slow-bounce, 84 of 84 runs not posed: " + first});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_EQ(run.errors.find(first), run.errors.rfind("carom: ")) << run.errors;
}

TEST_F(TimeCommand, SaysWhatAProgramSaidThatDoesNotStart) {
  const std::string out = directory_.path() / "time";
  const RunResult run = run_carom({"time", "exec:python3 -c 'import no_such_module'", "--quick", "--out", out});
  EXPECT_EQ(run.exit_status, 2);
  unit::expect_in(run.output, {"ended with status 1; standard error: ", "ModuleNotFoundError: "});
  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((out + "/junit.xml").c_str()));
  EXPECT_TRUE(junit.select_node("/testsuites[@errors = 1 and @skipped = 0]"));
}

// The engine hangs, so the errors come before the measurement.
TEST_F(TimeCommand, RefusesDirectoriesThatCannotBeMade) {
  for (const std::string option : {"--out", "--pages"}) {
    const RunResult run = measured("hang", {option, "/proc/no-such", "--timeout", "20"});
    expect_error(run, {option + ": the directory /proc/no-such cannot be created"});
  }
}

// The errors of the reading with the greater median are rounding.
TEST(WorstReading, IsNotOneThatRoundingExplains) {
  properties::Measurement measurement;
  for (const double error : {1e-5, 2e-5}) {
    properties::Rung rung;
    rung.step = 0.01;
    rung.median = error;
    rung.rounding = error > 1e-5 ? 1e-4 : 1e-6;
    measurement.readings.push_back({error > 1e-5 ? "rounded" : "wrong", "", {rung}, {}});
  }
  EXPECT_EQ(report::worst_reading(measurement, 0.01)->what, "wrong");
}

TEST_F(TimeCommand, RefusesNamesAndStepsThatAreNone) {
  expect_error(run_carom({"time", "no-such-engine"}), {"no engine in time is named no-such-engine"});
  expect_error(run_carom({"time", "scene", "--phenomena", "bonce"}),
               {"no phenomenon is named bonce; there are bounce,", "pass-through, heap"});
  expect_error(run_carom({"time", "scene", "scene"}), {"the engine scene is named twice"});
  for (const char* const step : {"1/0", "0.5", "1e-300"}) {
    expect_error(run_carom({"time", "scene", "--steps", step}), {"--steps: expected a number of seconds"});
  }
}

}  // namespace
}  // namespace carom::tests
