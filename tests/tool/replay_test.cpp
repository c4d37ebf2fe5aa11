// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>

#include "support/cases.hpp"
#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

/// The smallest collision in which reflection creates energy: a cube's corner hits the floor.
json cube_on_floor() {
  return json::parse(R"({
    "a": {"mass": 1, "principal_inertia": [0.5, 0.5, 0.5], "orientation": [2, 0, 0, 0],
          "position": [-0.5, 0.5, 0], "velocity": [-1, -1, 0], "angular_velocity": [0, 0, 0]},
    "b": {"immovable": true, "position": [0, 0, 0], "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0]},
    "point": [0, 0, 0], "normal": [0, 1, 0], "restitution": 1})");
}

/// Replays a file with this text.
RunResult replay_of(const std::string& text, const std::vector<std::string>& more = {}) {
  const TemporaryDirectory directory;
  return run_carom({"replay", directory.write("file.json", text)}, more);
}

TEST(Replay, ShowsTheExactOutcomeOfEachLaw) {
  const RunResult result = replay_of(cube_on_floor().dump(), {"--format", "json"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  // With r = (1/2, −1/2, 0) and J = I/2, the normal entry of the collision matrix is 1 + 1/2. So the impulse is 2/(3/2)
  // = 4/3, and v⁺ = −1 + 4/3.
  EXPECT_EQ(record.at("truth").at("frictionless").at("a").at("velocity"), json({"-1", "1/3", "0"}));
  EXPECT_EQ(record.at("truth").at("frictionless").at("impulse"), json({"0", "4/3", "0"}));
  EXPECT_EQ(record.at("truth").at("frictionless").at("nearest").at("a").at("velocity"), json({-1.0, 1.0 / 3, 0.0}));
  EXPECT_EQ(record.at("truth").at("reflection").at("b").at("velocity"), json({"0", "0", "0"}));
  EXPECT_EQ(record.at("approach"), "colliding");
}

TEST(Replay, JudgesASubjectInExactArithmeticAloneIfAskedAndSaysSo) {
  const auto replay = [](std::vector<std::string> more) {
    more.insert(more.end(), {"--subject", "frictionless-double"});
    return replay_of(cube_on_floor().dump(), more).output;
  };
  unit::expect_in(replay({}), {"restitution            holds"});
  unit::expect_in(replay({"--exact"}), {"restitution            holds", "judged only in exact arithmetic"});
  EXPECT_EQ(json::parse(replay({"--exact", "--format", "json"})).at("yardstick").at("exact"), true);
}

/// The laws whose exact outcomes a replay shows.
std::string laws_shown(const json& record, const std::vector<std::string>& more) {
  const std::string text = replay_of(record.dump(), more).output;
  std::string shown;
  for (const std::string law : {"frictionless", "reflection", "sticking", "rough", "coulomb"}) {
    const std::string heading = '\n' + law + (law == "coulomb" ? ", answer 1 of 1" : ", exactly");
    shown += text.find(heading) == std::string::npos ? "" : law + ' ';
  }
  return shown;
}

TEST(Replay, ShowsTheClaimedLawOrAllLawsIfAskedOrIfNoneIsClaimed) {
  const auto witness_of = [](const json& subject) {
    return json{{"collision", cube_on_floor()}, {"subject", subject}};
  };
  const std::string all = "frictionless reflection sticking rough coulomb ";
  EXPECT_EQ(laws_shown(witness_of({{"name", "frictionless-double"}}), {}), "frictionless ");
  EXPECT_EQ(laws_shown(witness_of({{"name", "frictionless-double"}}), {"--all-laws"}), all);
  EXPECT_EQ(laws_shown(witness_of({{"name", "exec:no-such"}, {"model", "rough"}}), {}), "rough ") << "not started";
  EXPECT_EQ(laws_shown(witness_of({{"name", "exec:no-such"}, {"model", "any"}}), {}), all);
  EXPECT_EQ(laws_shown(witness_of({{"name", "exec:no-such"}}), {}), all);
  EXPECT_EQ(laws_shown(cube_on_floor(), {}), all);
  EXPECT_EQ(laws_shown(cube_on_floor(), {"--subject", "coulomb-double"}), "coulomb ");
}

TEST(Replay, ReadsArraysAndJsonLines) {
  const json wrapped{{"collision", cube_on_floor()}};
  for (const std::string& text :
       {json::array({cube_on_floor(), wrapped}).dump(2), cube_on_floor().dump() + "\n" + wrapped.dump() + "\n\n"}) {
    const RunResult result = replay_of(text, {"--format", "json"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 2);
  }
}

TEST(Replay, FindsASoundSolverSoundAtTheEndsOfBinary64) {
  // A ball hits a floor. At every power of two, the frictionless answer is exact in binary64.
  std::string balls;
  for (const char* pointer : {"/a/mass", "/a/velocity/1", "/normal/1", "/a/orientation/0"}) {
    for (const double factor : {0x1p-500, 0x1p-1000, 0x1p+500, 0x1p+1000}) {
      json ball = cube_on_floor();
      ball["a"]["position"] = {0, 1, 0};
      ball[json::json_pointer(pointer)] = ball.at(json::json_pointer(pointer)).get<double>() * factor;
      balls += ball.dump() + '\n';
    }
  }
  const RunResult result = replay_of(balls, {"--subject", "frictionless-double"});
  EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
}

TEST(Replay, DecidesNoBackwardErrorIfTermsOverflowAndSaysSo) {
  // With this velocity, several terms overflow binary64, but the answer does not.
  json ball = cube_on_floor();
  ball["a"]["velocity"] = {0, -6e307, 0};
  const RunResult text = replay_of(ball.dump(), {"--subject", "frictionless-double"});
  EXPECT_EQ(text.output.find("40.0 digits"), std::string::npos) << text.output;
  unit::expect_in(text.output, {"backward error not decided"});
  const RunResult as_json = replay_of(ball.dump(), {"--subject", "frictionless-double", "--format", "json"});
  const json record = json::parse(as_json.output);
  EXPECT_TRUE(record.at("backward_error_ulps").is_null()) << record;
  EXPECT_EQ(record.at("verdicts").at("backward_error").at("status"), "skipped");
}

TEST(Replay, AcceptsAnInvalidCollisionIfItsWitnessIsAboutInvalidOnes) {
  json collision = cube_on_floor();
  collision["restitution"] = 2;
  const json witness{
      {"collision", collision}, {"invariant", "invalid_refused"}, {"subject", {{"name", "frictionless-double"}}}};
  const RunResult result = replay_of(witness.dump());
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output, {"refused"});
}

/// A file may name a program in any of its fields. Only the user may start programs.
TEST(Replay, StartsNoProgramThatAWitnessNames) {
  const TemporaryDirectory directory;
  const std::string touched = (directory.path() / "touched").string();
  const std::string command = "exec:touch " + touched;
  for (const json& subject : std::vector<json>{{{"name", command}},
                                               {{"name", "frictionless-double"}, {"specification", command}},
                                               {{"name", command}, {"specification", "exec:touch"}}}) {
    const json witness{{"collision", cube_on_floor()}, {"invariant", "restitution"}, {"subject", subject}};
    const std::string file = directory.write("witness.json", witness.dump());
    const RunResult result = run_carom({"replay", file});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(touched)) << subject;
    const std::string named = subject.value("specification", command);
    unit::expect_in(result.output, {"--subject '" + named + '\''});
    const json record = json::parse(run_carom({"replay", file, "--format", "json"}).output);
    unit::expect_in(record.at("not_judged").get<std::string>(), {"--subject"});
    EXPECT_FALSE(record.contains("verdicts"));
  }
  (void)replay_of(cube_on_floor().dump(), {"--subject", command});
  EXPECT_TRUE(std::filesystem::exists(touched)) << "the same words from the user start it";
}

/// The squares of the last velocities overflow, so the relative error has no value.
TEST(Replay, ShowsTheSpeedOfApproachIfTheNormalIsLongAndSaysIfNoDigitsAreKnown) {
  Collision collision;
  collision.a.position = {0, 1, 0};
  collision.b.position = {0, -1, 0};
  collision.a.velocity = {0, -3, 0};
  json lines = json::array();
  for (const double length : {1.0, 2.0}) {
    collision.normal = {0, length, 0};
    lines.push_back(collision_to_json(collision));
  }
  json huge = cube_on_floor();
  huge["a"]["velocity"] = {-1e200, -1e200, 3e199};
  huge["a"]["principal_inertia"] = {0.5, 0.4, 0.3};
  huge["normal"] = {0.1, 1, 0.7};
  lines.push_back(huge);
  const RunResult result = replay_of(lines.dump(), {"--subject", "reflection-double"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  unit::expect_in(result.output, {"  N·V⁻ = -3: colliding\n", "  N·V⁻ = -6: colliding, at 3 m/s along the normal\n",
                                  " ulps, no digits known: the exact change is zero or out of range"});
}

TEST(Replay, ShowsEveryAnswerOfTheLawCoulomb) {
  const Collision several = unit::case_with_three_answers();
  const auto replay = [](const Collision& collision, std::vector<std::string> more) {
    more.insert(more.end(), {"--subject", "coulomb-double"});
    const RunResult result = replay_of(collision_to_json(collision).dump(), more);
    EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
    return result.output;
  };
  const std::string text = replay(several, {});
  unit::expect_in(text, {"coulomb, answer 1 of 3, sticks, exactly", "coulomb, answer 3 of 3, slips, with 36 digits",
                         "  answer 1 of 3: "});
  EXPECT_TRUE(std::regex_search(text, std::regex("  answer [1-3] of 3: [0-9]+\\.[0-9] digits\n"))) << text;
  const json answers = json::parse(replay(several, {"--format", "json"})).at("answers").at("coulomb");
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].at("kind"), "sticks");
  EXPECT_TRUE(answers[0].at("exact").get<bool>());
  EXPECT_TRUE(answers[0].contains("impulse"));
  EXPECT_EQ(answers[1].at("kind"), "slips");
  EXPECT_FALSE(answers[1].contains("impulse"));
  Collision parting = unit::ball_on_a_plane(0.5, 1);
  parting.a.velocity = {1, 2, 0};
  unit::expect_in(replay(parting, {}), {"answer 1 of 1, untouched"});
}

TEST(Replay, StartsNoEngineThatAWitnessNames) {
  const TemporaryDirectory directory;
  // If any adapter starts, this fake `node` starts.
  const std::string started = (directory.path() / "started").string();
  const std::string node = directory.write("node", "#!/bin/sh\necho started >> " + started + '\n');
  std::filesystem::permissions(node, std::filesystem::perms::owner_all);
  std::string witnesses;
  const std::vector<std::string> engines{"rapier", "jolt", "physx", "mujoco", "bullet-float", "rapier-coulomb"};
  for (const std::string& engine : engines) {
    witnesses += json{{"collision", cube_on_floor()}, {"subject", {{"name", engine}}}}.dump() + '\n';
  }
  const RunResult result =
      run_program("/usr/bin/env", {"PATH=" + directory.path().string() + ":/usr/bin:/bin", carom_program(), "replay",
                                   directory.write("witnesses.jsonl", witnesses)});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  for (const std::string& engine : engines) {
    unit::expect_in(result.output, {"--subject " + engine});
  }
  EXPECT_EQ(result.output.find("judged\n"), std::string::npos) << result.output;
  EXPECT_FALSE(std::filesystem::exists(started));
}

}  // namespace
}  // namespace carom::tests
