// SPDX-License-Identifier: BSL-1.0
#include "commands/plan.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

json crate(double x) {
  return {
      {"a",
       {{"mass", 1},
        {"principal_inertia", {0.25, 0.25, 0.1875}},
        {"orientation", {1, 0, 0, 0}},
        {"position", {x + 0.3, 0.5, 0.4}},
        {"velocity", {0.7, -1.3, 0.2}},
        {"angular_velocity", {0, 0, 0}}}},
      {"b", {{"immovable", true}, {"position", {0, 0, 0}}, {"velocity", {0, 0, 0}}, {"angular_velocity", {0, 0, 0}}}},
      {"point", {x, 0, 0}},
      {"normal", {0, 1, 0}},
      {"restitution", 0.5},
      {"friction", 0.4}};
}

const std::string example = std::string(CAROM_SOURCE_DIR) + "/docs/examples/contacts.jsonl";

/// Plans without timings unless a test asks for them, so that no other test depends on a clock.
RunResult plan(const std::string& file, std::vector<std::string> more = {}) {
  if (std::ranges::count(more, "--repetitions") == 0) {
    more.insert(more.end(), {"--repetitions", "0"});
  }
  return run_carom({"plan", file}, more);
}

const json& part_named(const json& record, const std::string& beginning) {
  return *std::ranges::find_if(record.at("classes"), [&](const json& part) {
    return part.at("name").get<std::string>().starts_with(beginning);
  });
}

TEST(Plan, EndsInOneIfNoMethodServesEveryContact) {
  const TemporaryDirectory directory;
  // The change of velocity is small compared with the common velocity of both bodies. So an outcome in binary64 cannot
  // hold 18 digits of the change.
  json fast = crate(0);
  fast["a"]["velocity"] = {1e9 + 0.5, -1.25, 0};
  fast["b"]["velocity"] = {1e9, 0, 0};
  const RunResult result = plan(directory.write("one", fast.dump()), {"--law", "reflection", "--digits", "18"});
  EXPECT_EQ(result.exit_status, 1) << result.output << result.errors;
  unit::expect_in(result.output, {"nothing serves"});
}

TEST(Plan, ListsTheFindingsOfTheLintAndLeavesOutContactsWithoutALaw) {
  const TemporaryDirectory directory;
  json wrong = crate(0);
  wrong["a"]["principal_inertia"] = {0.25, 0.25, 0.01};
  json out_of_range = crate(1);
  out_of_range["restitution"] = 1.5;
  json impossible = crate(2);
  impossible["a"]["principal_inertia"] = {0.25, 0.25, 0.75};
  const std::string file = directory.write(
      "lines", crate(0).dump() + '\n' + wrong.dump() + '\n' + out_of_range.dump() + '\n' + impossible.dump() + '\n');
  const RunResult result = plan(file, {"--format", "json"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  EXPECT_EQ(record.at("left_out"), 1);
  std::vector<std::string> found;
  for (const json& finding : record.at("findings")) {
    EXPECT_EQ(finding.at("severity"), "warning");
    const std::string place = finding.at("place");
    found.push_back(finding.at("lint").get<std::string>() + place.substr(place.rfind(':')) + ' ' +
                    finding.at("field").get<std::string>());
  }
  EXPECT_EQ(found, (std::vector<std::string>{"condition:2 a", "coefficient:3 restitution",
                                             "moments:4 a.principal_inertia[2]"}));
  const std::string text = plan(file).output;
  unit::expect_in(
      text, {"ignored contacts, because no law is defined for their coefficients: 1\n", "K exceeds 16 (1/m_A + 1/m_B)",
             "carom/impulse/", "body frame (plain)", "frictionless, however computed"});
}

TEST(Plan, NamesTheCheapestMethodAndItsHeaderForEachClassAndForAllContacts) {
  const RunResult result = plan(example, {"--law", "reflection", "--format", "json"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  EXPECT_EQ(record.at("demand"), json({{"law", "reflection"}, {"limit_ulps", 32}, {"exact_law", false}}));
  const json& balls = part_named(record, "balls");
  EXPECT_EQ(
      balls.at("laws")[0],
      json({{"law", "frictionless"}, {"served", 12}, {"exactly", 4}, {"reasons", {{"N is an eigenvector of K", 4}}}}));
  EXPECT_EQ(balls.at("torque_forms"), json({{"equal", 12}, {"plain", 0}, {"accurate", 0}}));
  EXPECT_EQ(balls.at("one_at_a_time").at("subject"), "frictionless-double");
  EXPECT_EQ(balls.at("one_at_a_time").at("header"), "carom/impulse/frictionless.hpp");
  EXPECT_EQ(balls.at("in_batches").at("subject"), "frictionless-batch-double");
  EXPECT_EQ(balls.at("in_batches").at("header"), "carom/impulse/batch/solve.hpp");
  const json& crates = part_named(record, "crate on floor").at("one_at_a_time");
  EXPECT_EQ(crates.at("law"), "reflection");
  EXPECT_EQ(crates.at("precision"), "double");
  EXPECT_EQ(crates.at("certificate").at("failures"), 0);
  for (const json& candidate : part_named(record, "rod on floor").at("candidates")) {
    if (candidate.at("subject") == "reflection-world-double") {
      EXPECT_FALSE(candidate.at("serves").get<bool>());
    }
  }
  EXPECT_EQ(record.at("whole").at("contacts"), 30);
  EXPECT_EQ(record.at("whole").at("one_at_a_time").at("law"), "reflection");
  EXPECT_TRUE(record.at("whole").at("baseline_nanoseconds").is_null());
  ASSERT_EQ(record.at("findings").size(), 1U);
  EXPECT_EQ(record.at("findings")[0].at("place"), example + ":19");
  EXPECT_EQ(record.at("findings")[0].at("lint"), "condition");
  EXPECT_EQ(run_carom({"replay", example}).exit_status, 0) << "the field `class` is no error for replay";
}

TEST(Plan, NamesAHeaderThatExistsForEveryCandidate) {
  const std::vector<properties::plan::Candidate> candidates = tool::plan::candidates();
  EXPECT_GT(candidates.size(), 50U);
  for (const properties::plan::Candidate& candidate : candidates) {
    const std::string& name = candidate.subject.name;
    const std::string header = tool::plan::header_of(name);
    EXPECT_TRUE(std::filesystem::exists(CAROM_SOURCE_DIR + ("/src" + header.substr(std::string("carom").size()))))
        << header;
    EXPECT_EQ(name.find("in-basis"), std::string::npos) << "that basis fails near head-on collisions";
    EXPECT_EQ(name.find("-batch-") != std::string::npos, candidate.is_batch) << name;
    EXPECT_EQ(name.find("-world-") != std::string::npos, candidate.frame == properties::plan::Frame::world) << name;
  }
}

TEST(PlanSchema, DescribesEveryPlanAndRejectsWhatDiffers) {
  const TemporaryDirectory directory;
  std::vector<std::string> files;
  const auto planned = [&](const std::vector<std::string>& arguments) {
    const std::string text = plan(example, arguments).output;
    files.push_back(directory.write("plan" + std::to_string(files.size()) + ".json", text));
    return json::parse(text);
  };
  const json record = planned({"--law", "reflection", "--exact-law", "--format", "json"});
  (void)planned({"--law", "coulomb", "--digits", "4", "--format", "json"});
  (void)planned({"--digits", "18", "--format", "json"});
  const json timed = planned({"--law", "frictionless", "--repetitions", "1", "--format", "json"});
  EXPECT_TRUE(timed.at("whole").at("one_at_a_time").at("saving").is_number());
  const std::vector<std::string> accepted = files;
  const std::vector<std::pair<const char*, std::function<void(json&)>>> changes{
      {"no law", [](json& r) { r.at("demand").erase("law"); }},
      {"two accuracies", [](json& r) { r.at("demand")["digits"] = 3; }},
      {"an unknown field", [](json& r) { r["mood"] = "good"; }},
      {"an unknown field of a candidate", [](json& r) { r.at("whole").at("candidates").at(0)["mood"] = "good"; }},
      {"a choice that does not serve", [](json& r) { r.at("whole").at("one_at_a_time")["serves"] = false; }},
      {"a choice without a header", [](json& r) { r.at("whole").at("one_at_a_time").erase("header"); }},
      {"an exit status that there is not", [](json& r) { r["exit_status"] = 2; }},
      {"a frame that there is not", [](json& r) { r.at("whole").at("candidates").at(0)["frame"] = "moon"; }},
  };
  for (const auto& [name, change] : changes) {
    json changed = record;
    change(changed);
    files.push_back(directory.write(name, changed.dump()));
  }
  EXPECT_EQ(accepted_by(std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/plan.schema.json", files), accepted);
}

}  // namespace
}  // namespace carom::tests
