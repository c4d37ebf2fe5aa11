// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;

struct UserError {
  std::string name;
  std::vector<std::string> arguments;
  std::vector<std::string> parts;  // of the message, in any order
};

void expect_messages(const std::vector<UserError>& table) {
  for (const UserError& error : table) {
    const RunResult result = run_carom(error.arguments);
    EXPECT_EQ(result.exit_status, 2) << error.name << ": " << result.output << result.errors;
    const std::string text = result.output + result.errors;
    for (const std::string& part : error.parts) {
      EXPECT_NE(text.find(part), std::string::npos) << error.name << ": expected '" << part << "' in: " << text;
    }
  }
}

template <class Change>
std::string collision_with(const Change& change) {
  json collision = json::parse(content_of(std::string(CAROM_SOURCE_DIR) + "/docs/examples/head_on.json"));
  change(collision);
  return collision.dump();
}

TEST(Messages, OnTheCommandLineNameTheOptionTheErrorAndTheRemedy) {
  const std::string scene = std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/cradle.json";
  expect_messages({
      {"no command", {}, {"no command is given", "expected one of the subcommands", "gate"}},
      {"unknown command", {"gat"}, {"not expected: gat", "Did you mean 'gate'?", "--help"}},
      {"unknown option", {"gate", "--famlies=generic"}, {"--famlies", "Did you mean '--families'?"}},
      {"unknown subject", {"gate", "frictionles-double"}, {"'frictionles-double'", "carom subjects", "did you mean"}},
      {"unknown family", {"gate", "--families", "head_no"}, {"--families", "'head_no'", "expected one of structured"}},
      {"unknown invariant",
       {"gate", "frictionless-double", "--deviates", "restitutoin"},
       {"--deviates", "\"restitutoin\"", "`carom invariants` lists them", "did you mean 'restitution'?"}},
      {"unknown family of a deviation",
       {"gate", "frictionless-double", "--deviates", "energy@hed_on"},
       {"--deviates", "did you mean 'head_on'?"}},
      {"unknown law of a plan", {"plan", "x", "--law", "smooth"}, {"--law", "smooth not in", "frictionless"}},
      {"unknown law of a scene",
       {"scene", scene, "--laws", "any"},
       {"--laws", "'any'", "expected one of frictionless"}},
      {"unknown subject of a chart",
       {"chart", "--out", "/dev/null/x", "frictionless"},
       {"'frictionless'", "`carom subjects` lists the subjects"}},
      {"bad seed", {"gate", "--seed", "-1"}, {"--seed", "expected an integer from 0 to 2^64 - 1"}},
      {"bad number of cases", {"gate", "--cases", "x"}, {"--cases", "x not in range 1 to 1000000000"}},
      {"bad digits", {"gate", "--digits", "19"}, {"--digits", "19 not in range 1 to 18"}},
      {"bad limit", {"gate", "--limit-ulps", "nan"}, {"--limit-ulps", "expected a number from 0.001"}},
      {"bad shard", {"gate", "--shard", "3/2"}, {"--shard", "expected I/N with I from 1 to N"}},
      {"too many shards", {"gate", "--cases", "2", "--shard", "1/5"}, {"--shard", "2 cases", "use fewer shards"}},
      {"a shard and a budget", {"gate", "--shard", "1/3", "--budget", "1s"}, {"--budget excludes --shard"}},
      {"a shard and a first violation", {"gate", "--shard", "1/3", "--fail-fast"}, {"--fail-fast excludes --shard"}},
      {"no batch system", {"gate", "--shard", "auto"}, {"--shard auto", "SLURM_ARRAY_TASK_ID", "use --shard I/N"}},
      {"bad budget", {"gate", "--budget", "10"}, {"--budget", "expected a number and a unit, for example 500ms"}},
      {"a budget and a number of cases", {"gate", "--budget", "1s", "--cases", "5"}, {"--cases excludes --budget"}},
      {"a limit and digits", {"gate", "--digits", "3", "--limit-ulps", "32"}, {"--limit-ulps excludes --digits"}},
      {"bad format", {"gate", "--format", "xml"}, {"--format", "xml not in"}},
      {"bad timeout", {"gate", "--timeout", "0"}, {"--timeout", "expected a number from 0.001"}},
      {"unknown service of annotations", {"gate", "--annotations", "nobody"}, {"--annotations", "nobody not in"}},
      {"a baseline and a first violation",
       {"gate", "--baseline", "x", "--fail-fast"},
       {"--baseline excludes --fail-fast"}},
      {"bad digits of a plan", {"plan", "x", "--digits", "0"}, {"--digits", "0 not in range 1 to 18"}},
      {"annotations in JSON",
       {"gate", "frictionless-double", "--annotations", "github", "--format", "json"},
       {"--annotations", "needs --format text", "found --format json"}},
      {"no quantity",
       {"gate", "--within", "colour=1:2"},
       {"--within", "'colour=1:2' names no quantity", "one of size"}},
      {"a range that is no range", {"gate", "--within", "size=2:1"}, {"--within", "size", "the lesser first", "2:1"}},
      {"no baseline",
       {"gate", "frictionless-double", "--baseline", "/no/report.json"},
       {"/no/report.json", "does not exist", "check the path"}},
      {"no domain", {"gate", "--within", "/no/domain.json"}, {"/no/domain.json", "does not exist", "check the path"}},
      {"an empty domain",
       {"gate", "--within", "size=1:2,size_ratio=3:"},
       {"--within", "no case of generic lies within size=1:2,size_ratio=3:", "use wider ranges"}},
      {"a family without cases in the domain",
       {"gate", "--within", "restitution=0.5", "--families", "elastic"},
       {"--families", "no case of elastic lies within restitution=0.5:0.5"}},
      {"a domain without a family", {"replay", "x.json", "--within", "games"}, {"--within requires --family"}},
      {"a program of a replay",
       {"replay", "--family", "head_on", "--case", "0", "--subject", "exec:/no/such/program"},
       {"exec:/no/such/program", "cannot be run: No such file", "check the path"}},
      {"nothing to replay", {"replay"}, {"FILE, or --family and --case", "required"}},
      {"a file and a family", {"replay", "x.json", "--family", "head_on", "--case", "1"}, {"FILE excludes --family"}},
      {"an unknown family of a case",
       {"replay", "--family", "haed_on", "--case", "1"},
       {"--family", "did you mean 'head_on'?"}},
      {"a family without a number", {"replay", "--family", "head_on"}, {"--family requires --case"}},
      {"an empty --out",
       {"gate", "frictionless-double", "--cases", "1", "--out", ""},
       {"--out: expected a value, found an empty text", "is a variable not set?"}},
      {"an --out that ends in =",
       {"gate", "--cases", "1", "--out=", "frictionless-double"},
       {"--out: expected a value, found an empty text"}},
      {"an empty subject", {"gate", ""}, {"SUBJECT: expected a value"}},
      {"an empty file", {"compare", "", "x"}, {"OLD: expected a value"}},
      {"unwritable --out",
       {"gate", "frictionless-double", "--cases", "1", "--out", "/dev/null/out"},
       {"--out", "/dev/null/out", "cannot be created", "choose another directory"}},
      {"unwritable file of a domain",
       {"domain", "frictionless-double", "--out", "/no/such/folder/domain.json"},
       {"--out: the file /no/such/folder/domain.json cannot be written"}},
      {"unwritable picture of a domain",
       {"domain", "frictionless-double", "--picture", "/no/such/folder/domain.svg"},
       {"--picture: the file /no/such/folder/domain.svg cannot be written"}},
      {"a program of a domain", {"domain", "exec:/no/such/program"}, {"/no/such/program", "cannot be run"}},
      {"a core without cases",
       {"domain", "frictionless-double", "--core", "size=1:2,size_ratio=3:"},
       {"--core: no case of generic lies within size=1:2,size_ratio=3:"}},
      {"nothing beside", {"domain", "frictionless-double", "--beside", "nowhere"}, {"--beside: "}},
      {"unwritable summary",
       {"gate", "frictionless-double", "--summary", "/dev/null/x"},
       {"--summary", "/dev/null/x cannot be written", "check the path"}},
  });
}

TEST(Messages, OnAFileNameTheFileThePlaceAndTheExpectedValue) {
  const TemporaryDirectory directory;
  const std::string cut = directory.write("cut.json", R"({"a": )");
  const std::string empty = directory.write("empty.json", "");
  const std::string none = directory.write("none.json", "[]");
  const std::string lines = directory.write("lines.jsonl", "{\"a\": 1}\n{\"b\": 2}\n");
  const std::string no_mass = directory.write("no_mass.json", collision_with([](json& c) { c["a"].erase("mass"); }));
  const std::string text = directory.write("text.json", collision_with([](json& c) { c["a"]["mass"] = "heavy"; }));
  const std::string short_vector = directory.write("short.json", collision_with([](json& c) { c["point"] = {1, 2}; }));
  const std::string nan = directory.write("nan.json", collision_with([](json& c) { c["a"]["mass"] = "nan"; }));
  const std::string restitution =
      directory.write("restitution.json", collision_with([](json& c) { c["restitution"] = 1.5; }));
  const std::string unknown = directory.write("unknown.json", collision_with([](json& c) { c["speed"] = 1; }));
  const std::string bad_class = directory.write("class.json", collision_with([](json& c) { c["class"] = 3; }));
  const std::string huge = directory.write("huge.json", R"({"a": 1e999})");
  const std::string twice = directory.write("twice.json", R"({"a": 1, "a": 2})");
  const std::string folder = directory.path().string();
  const std::string no_quantity = directory.write("no_quantity.json", R"({"colour": [1, 2]})");
  const std::string no_pair = directory.write("no_pair.json", R"({"size": [1]})");
  const std::string reversed = directory.write("reversed.json", R"({"size": [2, 1]})");
  const auto within = [](const std::string& file) {
    return std::vector<std::string>{"gate", "frictionless-double", "--within", file};
  };
  expect_messages({
      {"a domain that is not JSON", within(cut), {"--within", "cut.json", "not JSON", "line 1"}},
      {"a domain of no quantity", within(no_quantity), {"no_quantity.json", "/colour", "no quantity has it"}},
      {"a domain without both ends", within(no_pair), {"no_pair.json", "/size", "the least and the greatest value"}},
      {"a domain with reversed ends", within(reversed), {"reversed.json", "/size", "the lesser first"}},
      {"malformed JSON", {"replay", cut}, {"cut.json", "not JSON", "line 1", "expected"}},
      {"empty file", {"replay", empty}, {"empty.json", "the file is empty", "expected a collision"}},
      {"plan of an empty file", {"plan", empty}, {"empty.json", "the file is empty", "expected a collision"}},
      {"empty array", {"replay", none}, {"none.json", "the array is empty", "expected at least one collision"}},
      {"a wrong line", {"replay", lines}, {"lines.jsonl:1", "/a", "expected an object, found 1"}},
      {"missing field", {"replay", no_mass}, {"no_mass.json", "/a/mass", "is missing", "add this field"}},
      {"wrong type", {"replay", text}, {"text.json", "/a/mass", "expected a number, found \"heavy\""}},
      {"wrong length", {"replay", short_vector}, {"short.json", "/point", "expected an array of 3 numbers"}},
      {"NaN", {"replay", nan}, {"nan.json", "a.mass", "expected a finite number"}},
      {"out of range", {"replay", restitution}, {"restitution.json", "restitution", "expected a number from 0 to 1"}},
      {"unknown field", {"replay", unknown}, {"unknown.json", "/speed", "unknown field", "expected one of a, b"}},
      {"a number that overflows", {"replay", huge}, {"huge.json", "'1e999'", "overflows binary64"}},
      {"a repeated field", {"replay", twice}, {"twice.json", "\"a\" occurs twice", "keep one of them"}},
      {"missing file", {"replay", folder + "/no.json"}, {"/no.json", "does not exist", "check the path"}},
      {"a directory", {"replay", folder}, {folder, "expected a file, found a directory"}},
      {"unreadable file", {"replay", "/proc/self/mem"}, {"/proc/self/mem", "the file cannot be read", "error"}},
      {"a class that is no text", {"plan", bad_class}, {"class.json", "/class", "expected a string"}},
      {"no witness",
       {"replay", nan, "--drawn"},
       {"nan.json", "/drawn", "only a witness", "use --drawn with a witness"}},
  });
}

TEST(Messages, OnASceneNameTheFileThePlaceAndTheExpectedValue) {
  const TemporaryDirectory directory;
  const json valid = json::parse(content_of(std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/cradle.json"));
  json scene = valid;
  scene.erase("duration");
  const std::string no_duration = directory.write("no_duration.json", scene.dump());
  scene = valid;
  scene["law"] = "smooth";
  const std::string law = directory.write("law.json", scene.dump());
  scene = valid;
  scene["spheres"] = json::array();
  const std::string alone = directory.write("alone.json", scene.dump());
  scene = valid;
  scene["spheres"][1]["radius"] = -1;
  const std::string radius = directory.write("radius.json", scene.dump());
  scene = valid;
  scene["spheres"][1]["position"] = scene["spheres"][0]["position"];
  const std::string overlap = directory.write("overlap.json", scene.dump());
  const std::string polyhedra = directory.write("polyhedra.json", R"({"duration": 1, "polyhedra": [
      {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "density": 1, "position": [0,0,0]},
      {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "density": 1, "position": [0.125,0,0]}]})");
  expect_messages({
      {"missing field", {"scene", no_duration}, {"no_duration.json", "/duration", "is missing", "add this field"}},
      {"unknown law", {"scene", law}, {"law.json", "/law", "expected frictionless, reflection", "found \"smooth\""}},
      {"bad radius", {"scene", radius}, {"radius.json", "/spheres/1/radius"}},
      {"overlap", {"scene", overlap}, {"overlap.json", "overlap"}},
      {"polyhedra that overlap",
       {"scene", polyhedra},
       {"/polyhedra/1: polyhedron 1 (polyhedron 1) may overlap polyhedron 0 (polyhedron 0)"}},
      {"no scene", {"scene", directory.path().string() + "/no.json"}, {"/no.json", "does not exist"}},
      {"no collision", {"plan", alone}, {"alone.json", "has no collisions", "needs at least one"}},
  });
}

}  // namespace
}  // namespace carom::tests
