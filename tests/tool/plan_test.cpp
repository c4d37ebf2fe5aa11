// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>

#include "support/cases.hpp"
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

std::string lines_of(const std::vector<json>& records) {
  std::string text;
  for (const json& record : records) {
    text += record.dump() + '\n';
  }
  return text;
}

std::string crates_and_spheres() {
  std::vector<json> records;
  for (int i = 0; i < 5; ++i) {
    json record = crate(i);
    record["class"] = "crates";
    records.push_back(record);
    records.push_back(collision_to_json(unit::case_of("collinear_spheres", static_cast<std::uint64_t>(i)).collision));
  }
  records.push_back({{"class", "crates"}, {"collision", crate(9)}});
  return lines_of(records);
}

/// Plans without timings, so that no test depends on a clock.
RunResult plan(const std::string& file, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"plan", file, "--repetitions", "0"});
  return run_carom(more);
}

RunResult validate(const std::string& record) {
  return run_program("/usr/bin/python3", {"-W", "ignore", "-m", "jsonschema", "-i", record,
                                          std::string(CAROM_SOURCE_DIR) + "/docs/reference/schemas/plan.schema.json"});
}

const json& part_named(const json& record, const std::string& beginning) {
  return *std::ranges::find_if(record.at("classes"), [&](const json& part) {
    return part.at("name").get<std::string>().starts_with(beginning);
  });
}

TEST(Plan, NamesTheLeastThatServesForEachClassAndTheWhole) {
  const TemporaryDirectory directory;
  const RunResult result =
      plan(directory.write("lines", crates_and_spheres()), {"--law", "reflection", "--format", "json"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  EXPECT_EQ(record.at("demand"), json({{"law", "reflection"}, {"limit_ulps", 32}, {"exact_law", false}}));
  EXPECT_EQ(part_named(record, "crates").at("contacts"), 6);
  const json& crates = part_named(record, "crates").at("one_at_a_time");
  EXPECT_EQ(crates.at("law"), "reflection");
  EXPECT_EQ(crates.at("precision"), "double");
  EXPECT_EQ(crates.at("certificate").at("failures"), 0);
  const json& spheres = part_named(record, "central");
  EXPECT_EQ(spheres.at("one_at_a_time").at("subject"), "frictionless-double");
  EXPECT_EQ(spheres.at("one_at_a_time").at("call"),
            "carom::impulse::frictionless(carom::impulse::make_contact<double>(collision))");
  EXPECT_EQ(spheres.at("one_at_a_time").at("headers"), json({"carom/impulse/frictionless.hpp"}));
  EXPECT_EQ(spheres.at("in_batches").at("subject"), "frictionless-batch-double");
  EXPECT_EQ(spheres.at("laws")[0].at("reasons"), json({{"N is an eigenvector of K", spheres.at("contacts")}}));
  EXPECT_EQ(spheres.at("torque_forms"), json({{"equal", spheres.at("contacts")}, {"plain", 0}, {"accurate", 0}}));
  EXPECT_EQ(part_named(record, "crates").at("torque_forms").at("plain"), 6);
  EXPECT_EQ(record.at("whole").at("contacts"), 11);
  EXPECT_EQ(record.at("whole").at("one_at_a_time").at("law"), "reflection");
  EXPECT_TRUE(record.at("whole").at("baseline_nanoseconds").is_null());
}

TEST(Plan, IsShownAsTextAndMarkdown) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("lines", crates_and_spheres());
  const std::string text = plan(file, {"--law", "reflection"}).output;
  const std::string markdown = plan(file, {"--law", "reflection", "--format", "markdown"}).output;
  for (const char* part : {"asked for: reflection, 32 ulps of binary64", "frictionless-double", "crates", "the whole",
                           "<carom/impulse/frictionless.hpp>", "N is an eigenvector of K",
                           "frictionless, however computed", "body frame (plain)", "body frame (equal/plain)"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    EXPECT_NE(markdown.find(part), std::string::npos) << part << '\n' << markdown;
  }
  EXPECT_NE(markdown.find("| --- |"), std::string::npos);
}

TEST(Plan, RefusesFloatForOneContactFarFromTheOriginAndNamesItsLine) {
  const TemporaryDirectory directory;
  std::vector<json> records{crate(0), crate(1), crate(2)};
  const auto planned = [&] {
    const RunResult result = plan(directory.write("lines", lines_of(records)),
                                  {"--law", "frictionless", "--digits", "5", "--format", "json"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return json::parse(result.output).at("whole");
  };
  EXPECT_EQ(planned().at("one_at_a_time").at("precision"), "float");
  records.insert(records.begin() + 1, crate(1e6));
  const json whole = planned();
  EXPECT_EQ(whole.at("one_at_a_time").at("precision"), "double");
  for (const json& candidate : whole.at("candidates")) {
    if (candidate.at("subject") == "frictionless-float") {
      EXPECT_FALSE(candidate.at("serves").get<bool>());
      EXPECT_EQ(candidate.at("certificate").at("worst_failure").at("place"),
                (directory.path() / "lines").string() + ":2");
    }
  }
}

TEST(Plan, FailsWhereNothingServes) {
  const TemporaryDirectory directory;
  // The change of velocity is small compared with the common velocity of both bodies. So an outcome in binary64 cannot
  // hold 18 digits of the change.
  json fast = crate(0);
  fast["a"]["velocity"] = {1e9 + 0.5, -1.25, 0};
  fast["b"]["velocity"] = {1e9, 0, 0};
  const RunResult result = plan(directory.write("one", fast.dump()), {"--law", "reflection", "--digits", "18"});
  EXPECT_EQ(result.exit_status, 1) << result.output << result.errors;
  EXPECT_NE(result.output.find("nothing serves"), std::string::npos) << result.output;
}

TEST(Plan, WarnsAndSucceeds) {
  const TemporaryDirectory directory;
  json wrong = crate(0);
  wrong["a"]["principal_inertia"] = {0.25, 0.25, 0.01};
  json out_of_range = crate(1);
  out_of_range["restitution"] = 1.5;
  json impossible = crate(2);
  impossible["a"]["principal_inertia"] = {0.25, 0.25, 0.75};
  const std::string file = directory.write("lines", lines_of({crate(0), wrong, out_of_range, impossible}));
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
  EXPECT_NE(text.find("ignored contacts, because no law is defined for their coefficients: 1\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("K exceeds 16 (1/m_A + 1/m_B)"), std::string::npos) << text;
}

TEST(Plan, SaysWhichPlaceAndWhichField) {
  const TemporaryDirectory directory;
  json massless = crate(0);
  massless["a"]["mass"] = 0;
  json named = crate(0);
  named["class"] = 3;
  struct Malformed {
    std::string text;
    std::vector<std::string> said;
  };
  for (const Malformed& malformed : std::vector<Malformed>{
           {"", {"empty"}},
           {lines_of({crate(0), massless}), {"lines:2", "a.mass", "greater than 0"}},
           {lines_of({crate(0), crate(1), named}), {"lines:3", "/class", "string"}},
           {lines_of({crate(0)}) + "{", {"lines:2", "not JSON"}},
           {lines_of({crate(0), {{"gravity", 1}}}), {"lines:2", "missing"}},
       }) {
    const RunResult result = plan(directory.write("lines", malformed.text));
    EXPECT_EQ(result.exit_status, 2) << malformed.text;
    for (const std::string& said : malformed.said) {
      EXPECT_NE(result.errors.find(said), std::string::npos) << said << '\n' << result.errors;
    }
  }
  EXPECT_EQ(plan("no/such/file").exit_status, 2);
  const std::string file = directory.write("lines", crate(0).dump());
  EXPECT_EQ(plan(file, {"--law", "any"}).exit_status, 2);
  EXPECT_EQ(plan(file, {"--digits", "0"}).exit_status, 2);
  EXPECT_EQ(plan(file, {"--limit-ulps", "nan"}).exit_status, 2);
}

TEST(Plan, IsOfTheExampleWhatItsPageSays) {
  const std::string file = std::string(CAROM_SOURCE_DIR) + "/docs/examples/contacts.jsonl";
  const RunResult result = plan(file, {"--law", "reflection", "--format", "json"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const json record = json::parse(result.output);
  EXPECT_EQ(
      part_named(record, "balls").at("laws")[0],
      json({{"law", "frictionless"}, {"served", 12}, {"exactly", 4}, {"reasons", {{"N is an eigenvector of K", 4}}}}));
  EXPECT_EQ(part_named(record, "balls").at("one_at_a_time").at("law"), "frictionless");
  EXPECT_EQ(part_named(record, "crate on floor").at("one_at_a_time").at("law"), "reflection");
  for (const json& candidate : part_named(record, "rod on floor").at("candidates")) {
    if (candidate.at("subject") == "reflection-world-double") {
      EXPECT_FALSE(candidate.at("serves").get<bool>());
    }
  }
  ASSERT_EQ(record.at("findings").size(), 1U);
  EXPECT_EQ(record.at("findings")[0].at("place"), file + ":19");
  EXPECT_EQ(record.at("findings")[0].at("lint"), "condition");
}

TEST(Plan, IsReadByReplayToo) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run_carom({"replay", directory.write("lines", crates_and_spheres())}).exit_status, 0);
}

TEST(PlanSchema, DescribesEveryPlan) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("lines", crates_and_spheres());
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--law", "reflection", "--exact-law"},
                                             {"--law", "coulomb"},
                                             {"--law", "coulomb", "--digits", "4"},
                                             {"--digits", "18"},
                                             {"--law", "sticking", "--limit-ulps", "1e12"}}) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--format", "json"});
    const RunResult valid = validate(directory.write("plan.json", plan(file, all).output));
    EXPECT_EQ(valid.exit_status, 0) << valid.output << valid.errors;
  }
  const RunResult timed = run_carom({"plan", file, "--law", "frictionless", "--repetitions", "1", "--format", "json"});
  const RunResult valid = validate(directory.write("plan.json", timed.output));
  EXPECT_EQ(valid.exit_status, 0) << valid.output << valid.errors;
  EXPECT_TRUE(json::parse(timed.output).at("whole").at("one_at_a_time").at("saving").is_number());
}

TEST(PlanSchema, RejectsWhatDiffers) {
  const TemporaryDirectory directory;
  const json record = json::parse(
      plan(directory.write("lines", crates_and_spheres()), {"--law", "reflection", "--format", "json"}).output);
  ASSERT_EQ(validate(directory.write("plan.json", record.dump())).exit_status, 0) << "else everything is rejected";
  const std::vector<std::pair<const char*, std::function<void(json&)>>> changes{
      {"no law", [](json& r) { r.at("demand").erase("law"); }},
      {"two accuracies", [](json& r) { r.at("demand")["digits"] = 3; }},
      {"an unknown field", [](json& r) { r["mood"] = "good"; }},
      {"an unknown field of a candidate", [](json& r) { r.at("whole").at("candidates").at(0)["mood"] = "good"; }},
      {"a choice that does not serve", [](json& r) { r.at("whole").at("one_at_a_time")["serves"] = false; }},
      {"a choice without a call", [](json& r) { r.at("whole").at("one_at_a_time").erase("call"); }},
      {"an exit status that there is not", [](json& r) { r["exit_status"] = 2; }},
      {"a frame that there is not", [](json& r) { r.at("whole").at("candidates").at(0)["frame"] = "moon"; }},
  };
  for (const auto& [name, change] : changes) {
    json changed = record;
    change(changed);
    EXPECT_EQ(validate(directory.write("plan.json", changed.dump())).exit_status, 1) << name;
  }
}

}  // namespace
}  // namespace carom::tests
