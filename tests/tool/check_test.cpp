// SPDX-License-Identifier: BSL-1.0
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/expect_in.hpp"
#include "support/program.hpp"

/// `carom check`, the judge of recorded collisions.
namespace carom::tests {
namespace {

using nlohmann::json;
using unit::expect_in;

/// A ball that a wall reflects with ε = 0.8.
json wall_record() {
  return json::parse(R"({
    "a": {"mass": 0.17, "sphere": 0.0286, "position": [0, 0, 0.0286], "velocity": [2, 0, 0], "angular_velocity": [0, 0, 0]},
    "b": {"immovable": true, "position": [0.0286, 0, 0.0286], "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0]},
    "point": [0.0286, 0, 0.0286], "normal": [-1, 0, 0], "restitution": 0.8, "frame": 17,
    "after": {"a": {"velocity": [-1.6, 0, 0], "angular_velocity": [0, 0, 0]}}})");
}

json wrong_record() {
  json record = wall_record();
  record["after"]["a"]["velocity"] = {-1.7, 0, 0};
  return record;
}

/// The collision of a question on a forum (stackoverflow.com 894935), with the velocities that it prints.
json two_balls() {
  return json::parse(R"({
    "a": {"mass": 12.56637, "principal_inertia": [20.106192, 20.106192, 20.106192], "position": [0, 0, 0],
          "velocity": [1.73199439, -10.5695238, 0], "angular_velocity": [0, 0, 0]},
    "b": {"mass": 12.56637, "principal_inertia": [20.106192, 20.106192, 20.106192],
          "position": [-3.122715354855946, -2.499729747902141, 0], "velocity": [6.04341078, 14.2686739, 0],
          "angular_velocity": [0, 0, 0]},
    "point": [-1.561357677427973, -1.2498648739510705, 0], "normal": [0.7806788387139865, 0.6249324369755352, 0],
    "restitution": 0.75,
    "after": {"a": {"velocity": [110.004326, -10.5695238, 0.0], "angular_velocity": [0, 0, 0]},
              "b": {"velocity": [-102.22892, -72.4030228, 0.0], "angular_velocity": [0, 0, 0]}}})");
}

TEST(Check, SaysThatMomentumIsLost) {
  const TemporaryDirectory directory;
  const RunResult run =
      run_carom({"check", directory.write("balls.json", two_balls().dump(2)), "--law", "frictionless"});
  EXPECT_EQ(run.exit_status, 1) << run.output << run.errors;
  expect_in(run.output,
            {"VIOLATED: 0 of 1 records hold under the law frictionless",
             "linear momentum along y: 46.485 kg m/s before, -1042.7 after; A gains 0, and B loses 1089.1"});
}

TEST(Check, PutsTheVerdictFirstAndPrintsUnknownFieldsBack) {
  const TemporaryDirectory directory;
  json wrong = wrong_record();
  wrong["engine\x1b[31m"] = "my \x1b[31mengine";
  wrong["fricton"] = 0.5;
  const RunResult run =
      run_carom({"check", directory.write("log.jsonl", wall_record().dump() + '\n' + wrong.dump() + '\n')});
  EXPECT_EQ(run.exit_status, 1) << run.output << run.errors;
  expect_in(run.output, {"VIOLATED: 1 of 2 records hold", "(--digits N sets it)", "frame: 17", "log.jsonl:2",
                         "ε = 0.8 demands 1.6", "did you mean 'friction'?", "median", "frictionless"});
  EXPECT_LT(run.output.find("VIOLATED"), run.output.find("median"));
  EXPECT_EQ(run.output.find('\x1b'), std::string::npos);
}

/// A planar record, as docs/guide/check.md shows it.
json planar_record() {
  return json::parse(R"({
    "a": {"mass": 2, "moment": 0.5, "position": [0, 1], "velocity": [1, -2], "angular_velocity": 3},
    "b": {"immovable": true, "position": [0, 0], "velocity": [0, 0], "angular_velocity": 0},
    "point": [0, 0], "normal": [0, 1], "restitution": 0.5, "friction": 0,
    "after": {"a": {"velocity": [1, 1], "angular_velocity": 3}}})");
}

TEST(Check, SaysThatTheNormalIsReversed) {
  const TemporaryDirectory directory;
  json reversed = planar_record();
  reversed["normal"] = {0, -1};
  std::string lines = planar_record().dump() + '\n';
  EXPECT_EQ(run_carom({"check", directory.write("right.jsonl", lines)}).exit_status, 0);
  for (int i = 0; i < 3; ++i) {
    lines += reversed.dump() + '\n';
  }
  expect_in(run_carom({"check", directory.write("log.jsonl", lines)}).output,
            {"VIOLATED: 1 of 4 records hold", "; N points from B to", "with −N, 3 of 4 records hold\n"});
  reversed["after"]["a"]["velocity"] = {1, 1.5};
  expect_in(run_carom({"check", directory.write("one.json", reversed.dump())}).output,
            {"; N points from B to", "with −N, 1 of 1 records approach\n"});
}

TEST(Check, NamesThePlacesOfAllViolatedRecords) {
  const TemporaryDirectory directory;
  std::string lines = wall_record().dump() + "\n\n";
  for (int i = 0; i < 41; ++i) {
    lines += wrong_record().dump() + '\n';
  }
  const std::string file = directory.write("log.jsonl", lines);
  expect_in(run_carom({"check", file, "--digits", "6"}).output,
            {"violated records: 3, 4, 5, ", " 41, 42, … (41 in all"});
  const json report = json::parse(run_carom({"check", file, "--digits", "6", "--format", "json"}).output);
  ASSERT_EQ(report.at("violated_at").size(), 41U);
  EXPECT_EQ(report.at("violated_at").back(), 43);
  EXPECT_EQ(report.at("violated_left_out"), 0);
}

TEST(Check, NamesAllMissingFields) {
  const TemporaryDirectory directory;
  const auto expect = [&](const json& record, const std::string& said) {
    expect_error(run_carom({"check", directory.write("one.json", record.dump())}), {"one.json: " + said});
  };
  expect({{"bodyA", 1}}, "a, b, point, normal and after are missing; add these fields (docs/guide/check.md)");
  json other = planar_record();
  other["after"]["a"].erase("velocity");
  other["a"].erase("moment");
  other["a"]["circle"] = 1;
  expect(other,
         "a.moment and after.a.velocity are missing; add these fields; did you mean 'disc'? (docs/guide/check.md)");
  other["after"] = planar_record()["after"];
  other["a"]["inertia"] = other["a"]["circle"];
  other["a"].erase("circle");
  expect(other, "a.moment: is missing; add this field; did you mean 'moment'? (docs/guide/check.md)");
}

TEST(Check, ReadsPlanarColumns) {
  const TemporaryDirectory directory;
  const std::string head =
      "a.mass,a.disc,a.position.x,a.position.y,a.velocity.x,a.velocity.y,a.angular_velocity.z,b.immovable,b.position.x,"
      "b.position.y,b.velocity.x,b.velocity.y,b.angular_velocity,point.x,point.y,normal.x,normal.y,restitution,"
      "friction,"
      "after.a.velocity.x,after.a.velocity.y,after.a.angular_velocity.z\n";
  const std::string file = directory.write("log.csv", head + "2,1,0,1,1,-2,3,1,0,0,0,0,0,0,0,0,1,0.5,0,1,1,3\n");
  const RunResult run = run_carom({"check", file, "--law", "frictionless"});
  EXPECT_EQ(run.exit_status, 0) << run.output << run.errors;
}

TEST(Check, ReadsColumns) {
  const TemporaryDirectory directory;
  const std::string head =
      "frame,a.mass,a.sphere,a.position.x,a.position.y,a.position.z,a.velocity.x,a.velocity.y,a.velocity.z,"
      "a.angular_velocity.x,a.angular_velocity.y,a.angular_velocity.z,b.immovable,b.position.x,b.position.y,"
      "b.position.z,b.velocity.x,b.velocity.y,b.velocity.z,b.angular_velocity.x,b.angular_velocity.y,"
      "b.angular_velocity.z,point.x,point.y,point.z,normal.x,normal.y,normal.z,restitution,after.a.velocity.x,"
      "after.a.velocity.y,after.a.velocity.z,after.a.angular_velocity.x,after.a.angular_velocity.y,"
      "after.a.angular_velocity.z\n";
  const auto line = [](const std::string& frame, const std::string& after) {
    return frame + ",0.17,0.0286,0,0,0.0286,2,0,0,0,0,0,true,0.0286,0,0.0286,0,0,0,0,0,0,0.0286,0,0.0286,-1,0,0,0.8," +
           after + ",0,0,0,0,0\n";
  };
  const std::string right = directory.write("right.csv", head + line("1", "-1.6") + line("\"a \"\"b\"\", c\"", "-1.6"));
  EXPECT_EQ(run_carom({"check", right}).exit_status, 0);
  const RunResult wrong = run_carom({"check", directory.write("wrong.csv", head + line("\"a \"\"b\"\", c\"", "-1.7"))});
  EXPECT_EQ(wrong.exit_status, 1);
  expect_in(wrong.output, {"frame: \"a \\\"b\\\", c\"", "wrong.csv:2"});
  const std::string marked = directory.write("marked.csv", "\xEF\xBB\xBF" + head + line("1", "-1.6"));
  EXPECT_EQ(run_carom({"check", marked}).exit_status, 0);
  expect_error(run_carom({"check", directory.write("signs.csv", head + line("1", "+-2"))}),
               {"signs.csv:2: after.a.velocity.x: expected a number, found \"+-2\""});
  const std::string broken = head + line("1", "-1.6") + line("2", "x");
  expect_error(run_carom({"check", directory.write("broken.csv", broken)}),
               {"broken.csv:3: after.a.velocity.x: expected a number, found \"x\""});
}

TEST(Check, NamesTheColumnOfAnError) {
  const TemporaryDirectory directory;
  const auto expect = [&](const std::string& text, const std::vector<std::string>& parts) {
    expect_error(run_carom({"check", directory.write("one.csv", text)}), parts);
  };
  expect("a,after,a.mass\n", {"one.csv:1: the columns a and a.mass contradict each other"});
  expect("\na.angular_velocity.x,a.angular_velocity\n", {"one.csv:2: the columns a.angular_velocity and a.angular_v"});
  expect("point.x,a.mass,point\n", {"one.csv:1: the columns point and point.x contradict each other"});
  expect("a.mass,frame,frame\n", {"one.csv:1: the column frame occurs twice"});
  expect("a.mass,\"b\n", {"one.csv:1: a quotation mark is not closed"});
  expect("a.mass\n\n1e400\n", {"one.csv:3: a.mass: the number '1e400' overflows binary64"});
}

TEST(Check, EndsWith2IfMoreThanATenthIsNotJudged) {
  const TemporaryDirectory directory;
  json whole = wall_record();
  whole.update({{"friction", 0.5}, {"tangential_restitution", 0}});
  const std::string file = directory.write("log.jsonl", whole.dump() + '\n' + wall_record().dump() + '\n');
  const RunResult run = run_carom({"check", file, "--law", "rough"});
  EXPECT_EQ(run.exit_status, 2) << run.output << run.errors;
  expect_in(run.output, {"NOT JUDGED: 1 of 2 records, which is more than a tenth; 1 of 2 records hold",
                         "1 records: the record lacks restitution, friction or tangential_restitution"});
  expect_in(run_carom({"check", file, "--law", "rough", "--format", "junit"}).output, {"errors=\"1\""});
  EXPECT_EQ(run_carom({"check", file, "--law", "frictionless"}).exit_status, 0);
}

TEST(Check, CutsALongUnknownField) {
  const TemporaryDirectory directory;
  json wrong = wrong_record();
  wrong["a"]["velocities"] = std::string(100'000, 'x');
  wrong["b"]["mass"] = 0;
  const std::string file = directory.write("log.json", wrong.dump());
  const json report = json::parse(run_carom({"check", file, "--format", "json"}).output);
  EXPECT_LT(report.at("worst").at(0).at("others").at("a.velocities").get<std::string>().size(), 1100U);
  const std::string text = run_carom({"check", file}).output;
  expect_in(text, {"fields that no law reads: a.velocities, frame"});
}

TEST(Check, PrintsWhatItFoundBeforeABrokenRecord) {
  const TemporaryDirectory directory;
  json broken = wall_record();
  broken["after"]["a"]["velocity"] = {-1.6, "fast", 0};
  const std::string text = wall_record().dump() + '\n' + wrong_record().dump() + '\n' + broken.dump() + '\n';
  const RunResult run = run_carom({"check", directory.write("log.jsonl", text)});
  expect_error(run, {"log.jsonl:3: after.a.velocity.y: expected a number, found \"fast\""});
  expect_in(run.output, {"1 of 2 records hold"});
}

TEST(Check, NamesThePlaceOfAnError) {
  const TemporaryDirectory directory;
  const auto expect = [&](json record, const char* pointer, const json& value, const std::vector<std::string>& parts) {
    const json::json_pointer place(pointer);
    if (value.is_null()) {
      record.at(place.parent_pointer()).erase(place.back());
    } else {
      record[place] = value;
    }
    expect_error(run_carom({"check", directory.write("one.json", record.dump())}), parts);
  };
  expect(wall_record(), "/a/mass", -1, {"one.json: a.mass: expected greater than 0"});
  expect(wall_record(), "/after/a/velocity", json{1, 2}, {"after.a.velocity: expected an array of 3 numbers"});
  expect(wall_record(), "/after", {}, {"one.json: after: is missing"});
  expect(two_balls(), "/after/b", {}, {"one.json: after.b: is missing"});
  expect(two_balls(), "/b/principal_inertia", {}, {"b.principal_inertia: is missing", "sphere"});
  expect_error(run_carom({"check", directory.write("list.json", "[" + wall_record().dump() + ", {]")}), {"not JSON"});
  expect_error(run_carom({"check", directory.write("empty.csv", "")}), {"empty.csv: the file is empty"});
  expect_error(run_carom({"check", directory.write("other.csv", "x,y\n1,2\n")}), {"a.velocity.x"});
  expect_error(run_carom({"check", (directory.path() / "none.jsonl").string()}), {"does not exist"});
}

TEST(Check, WritesItsReports) {
  const TemporaryDirectory directory;
  const std::string file =
      directory.write("log.json", "[" + wall_record().dump() + ",\n" + wrong_record().dump() + "]");
  const std::filesystem::path out = directory.path() / "out";
  EXPECT_EQ(run_carom({"check", file, "--out", out.string(), "--law", "frictionless"}).exit_status, 1);
  const json report = json::parse(content_of(out / "report.json"));
  EXPECT_EQ(report.at("records"), 2);
  EXPECT_EQ(report.at("violated"), 1);
  EXPECT_EQ(report.at("violations").at("restitution"), 1);
  EXPECT_NEAR(report.at("implied").at("restitution").at("median").get<double>(), 0.825, 1e-9);
  EXPECT_EQ(report.at("worst").at(0).at("others").at("frame"), 17);
  EXPECT_EQ(report.at("worst").at(0).at("place"), file + ": element 1");
  expect_in(content_of(out / "junit.xml"), {"<failure message=\"1 of 2 records violate it\"", "failures=\"1\""});
  expect_in(content_of(out / "report.html"), {"Recorded collisions", "ε = 0.8 demands 1.6"});
  expect_in(run_carom({"check", file, "--format", "junit"}).output, {"<testsuites name=\"carom\""});
  EXPECT_EQ(json::parse(run_carom({"check", file, "--format", "json"}).output).at("hold"), 1);
}

TEST(Check, ReportsFitTheirSchemaAndASchemaErrorIsFound) {
  const std::string docs = std::string(CAROM_SOURCE_DIR) + "/docs/";
  const TemporaryDirectory directory;
  std::vector<std::string> files;
  const auto add = [&](const json& report) {
    files.push_back(directory.write(std::to_string(files.size()) + ".json", report.dump()));
  };
  const auto report_on = [&](const std::string& file, const std::vector<std::string>& more = {}) {
    return json::parse(run_carom({"check", file, "--format", "json"}, more).output);
  };
  const json example = report_on(docs + "examples/records.jsonl");
  add(example);
  add(report_on(directory.write("read_in_part.jsonl", two_balls().dump() + "\n{")));
  add(report_on(directory.write("not_judged.json", two_balls().dump()), {"--law", "rough"}));
  const std::vector<std::string> fitting = files;
  for (const auto& [pointer, value] : std::vector<std::pair<const char*, json>>{
           {"/mood", "good"},
           {"/exit_status", 3},
           {"/hold", "2"},
           {"/law", "friction"},
           {"/laws/coulomb/satisfied", -1},
           {"/implied/restitution/median", nullptr},
           {"/worst/0/violates", json::array()},
           {"/worst/0/mood", 1},
       }) {
    json changed = example;
    changed[json::json_pointer(pointer)] = value;
    add(changed);
  }
  EXPECT_EQ(accepted_by(docs + "reference/schemas/records.schema.json", files), fitting);
}

}  // namespace
}  // namespace carom::tests
