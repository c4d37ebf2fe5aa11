// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/oracles/laws/judge_error.hpp>

#include "scene/replay_html.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_records.hpp"
#include "scene/scene_run.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string shipped(const std::string& name) {
  return std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/" + name + ".json";
}

json record_of(const std::string& name, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"scene", shipped(name), "--format", "json"});
  const RunResult result = run_carom(more);
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  return json::parse(result.output);
}

class ShippedScene : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScene, IsValidItsImpulsesPassAndItsLedgerCloses) {
  const json record = record_of(GetParam());
  EXPECT_TRUE(record["holds"].get<bool>());
  EXPECT_EQ(record["simulated"], record["duration"]);
  EXPECT_EQ(record["validity"]["invalid"], 0);
  EXPECT_GT(record["validity"]["pairs"], 0);
  EXPECT_GT(record["impulses"]["judged"], 0);
  EXPECT_EQ(record["impulses"]["judged"], record["impulses"]["all"]);
  EXPECT_LE(record["ledger"]["relative_rounding"].get<double>(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene,
                         testing::Values("bouncing_spheres", "spinning_floor", "break", "cradle", "tumbling_polyhedra",
                                         "dice"),
                         [](const auto& scene) { return scene.param; });

TEST(SceneCommand, GasKeepsItsEnergy) {
  const json record = record_of("gas", {"--events", "20000", "--judge-every", "20"});
  EXPECT_EQ(record["events"]["all"], 20000);
  EXPECT_LT(record["ledger"]["relative_rounding"].get<double>(), 1e-12);
  EXPECT_EQ(record["impulses"]["judged"], 1000);
  EXPECT_EQ(record["spins_changed"], 0);
}

TEST(SceneCommand, SaysTheSameHoweverManyLawsRunAtOnce) {
  const auto records_of = [](const std::string& jobs) {
    const RunResult result = run_carom({"scene", shipped("bouncing_spheres"), "--laws", "rough,frictionless,sticking",
                                        "--jobs", jobs, "--judge-every", "100", "--format", "json"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    json records = json::parse(result.output);
    for (json& record : records) {
      record.erase("seconds");
    }
    return records;
  };
  const json one_by_one = records_of("1");
  ASSERT_EQ(one_by_one.size(), 3U);
  EXPECT_EQ(one_by_one[1]["law"], "frictionless");
  EXPECT_EQ(records_of("3"), one_by_one);
}

TEST(SceneCommand, SpheresSpinUnderRoughAndNeverWithoutFriction) {
  const RunResult result =
      run_carom({"scene", shipped("bouncing_spheres"), "--laws", "frictionless,reflection,rough", "--format", "json"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const json records = json::parse(result.output);
  EXPECT_EQ(records[0]["spins_changed"], 0);
  EXPECT_EQ(records[1]["spins_changed"], 0);
  EXPECT_EQ(records[2]["spins_changed"], 64);
  // For spheres `reflection` equals `frictionless`, bit for bit.
  EXPECT_EQ(records[0]["events"], records[1]["events"]);
  EXPECT_EQ(records[0]["ledger"], records[1]["ledger"]);
}

TEST(SceneCommand, WritesWhatItPromises) {
  const TemporaryDirectory directory;
  const fs::path out = directory.path() / "out";
  const RunResult result = run_carom({"scene", shipped("spinning_floor"), "--out", out.string()});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  for (const char* name :
       {"events.csv", "series.csv", "scene.json", "report.html", "energy.svg", "momentum.svg", "spin.svg"}) {
    EXPECT_GT(fs::file_size(out / name), 0U) << name;
  }
  for (const auto& [name, unit] : {std::pair{"energy.svg", "energy [J]"}, std::pair{"momentum.svg", "momentum [N s]"},
                                   std::pair{"spin.svg", "[rad/s]"}}) {
    EXPECT_NE(content_of(out / name).find(unit), std::string::npos) << name;
  }
  const json record = json::parse(content_of(out / "scene.json"));
  const std::string events = content_of(out / "events.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(events.begin(), events.end(), '\n')),
            1 + record["events"]["all"].get<std::size_t>());
  EXPECT_EQ(fs::exists(out / "replay.html"), tool::has_replay());
  EXPECT_NE(content_of(out / "report.html").find("the ledger closes"), std::string::npos);
}

/// A replay that cannot hold all events ends just before the first event that does not fit. The output reports this.
TEST(SceneRun, ReplaysWhatFitsIn) {
  const auto replayed = [](std::uint64_t most) {
    tool::SceneOptions options;
    options.most_replayed = most;
    const auto run = std::make_unique<tool::SceneRun>(
        tool::scene_of(content_of(shipped("spinning_floor")), "spinning_floor"), options);
    run->run();
    EXPECT_EQ(run->is_replay_cut(), most < 56);
    EXPECT_EQ(tool::scene_text(*run).find("replay    of the first 20 events") != std::string::npos, most == 20);
    return tool::replay_record(*run);
  };
  const json whole = replayed(56);
  EXPECT_EQ(whole["duration"], 12);
  EXPECT_FALSE(whole.contains("of_duration"));
  const json cut = replayed(20);
  EXPECT_EQ(cut["of_duration"], 12);
  EXPECT_LT(cut["duration"], 12);
  std::size_t arcs = 0;
  double latest = 0;
  for (const json& of_body : cut["arcs"]) {
    arcs += of_body.size();
    latest = std::max(latest, of_body.back()[0].get<double>());
  }
  EXPECT_EQ(arcs, 9U + 20U);
  EXPECT_LE(latest, cut["duration"]);
  EXPECT_LE(cut["series"]["t"].back(), cut["duration"]);
  EXPECT_GT(cut["series"]["t"].size(), 1U);
}

/// The callback throws in place of the judge.
TEST(SceneRun, KeepsItsResultsIfTheJudgeFails) {
  tool::SceneOptions options;
  std::size_t events = 0;
  options.on_event = [&](const scene::Event& event) {
    if (++events == 20) {
      throw oracles::JudgeError("a wrong formula", event.collision);
    }
  };
  const auto run = std::make_unique<tool::SceneRun>(
      tool::scene_of(content_of(shipped("spinning_floor")), "spinning_floor"), options);
  run->run();
  EXPECT_TRUE(run->has_failed());
  EXPECT_EQ(run->simulation().counts().events, 20U);
  EXPECT_GT(run->judge().judged(), 0U);
  EXPECT_GT(run->samples().size(), 1U);
  const std::string text = tool::scene_text(*run);
  EXPECT_NE(text.find("NOT RUN TO ITS END; so far holds"), std::string::npos) << text;
  EXPECT_NE(text.find("a wrong formula\n  A: "), std::string::npos) << text;
  EXPECT_EQ(tool::scene_record(*run)["ended_early"], run->ended_early());
}

TEST(SceneCommand, IsTheSameTwice) {
  json first = record_of("break");
  json second = record_of("break");
  first.erase("seconds");
  second.erase("seconds");
  EXPECT_EQ(first, second);
}

TEST(SceneCommand, RefusesWithThePlace) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "scene.json").string();
  const auto refused = [&](const std::string& text) {
    static_cast<void>(directory.write("scene.json", text));
    const RunResult result = run_carom({"scene", file});
    EXPECT_EQ(result.exit_status, 2) << text;
    return result.errors;
  };
  EXPECT_NE(refused(R"({"duration": 1, "spheres": [{"radius": -1, "density": 1, "position": [0,0,0]}]})")
                .find("/spheres/0/radius"),
            std::string::npos);
  EXPECT_NE(refused(R"({"duration": 1, "spheres": [{"radius": 1, "density": 1, "position": [0,0,0]},
                                                    {"radius": 1, "density": 1, "position": [1,0,0]}]})")
                .find("overlap"),
            std::string::npos);
  EXPECT_NE(refused("{").find(file), std::string::npos);
  EXPECT_EQ(run_carom({"scene", file + ".absent"}).exit_status, 2);
  EXPECT_EQ(run_carom({"scene", shipped("cradle"), "--laws", "sliding"}).exit_status, 2);
}

TEST(SceneCommand, PlansTheScalarSolverForPairsOfSpheres) {
  const RunResult result =
      run_carom({"plan", shipped("bouncing_spheres"), "--law", "reflection", "--repetitions", "0"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_NE(result.output.find("spheres: "), std::string::npos);
  EXPECT_NE(result.output.find("N is an eigenvector of K"), std::string::npos);
  EXPECT_NE(result.output.find("frictionless-"), std::string::npos);
  EXPECT_EQ(result.output.find("normal_length"), std::string::npos);
}

}  // namespace
}  // namespace carom::tests
