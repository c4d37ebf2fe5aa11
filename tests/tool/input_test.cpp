// SPDX-License-Identifier: BSL-1.0
#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <carom/collision/json/json.hpp>
#include <carom/subjects/protocol/command_line.hpp>

#include "support/cases.hpp"
#include "support/expect_in.hpp"
#include "support/program.hpp"

/// Input that is wrong, endless, huge or malicious.
namespace carom::tests {
namespace {

using nlohmann::json;

/// A command line, and the parts of its error message in any order.
struct UserError {
  std::string command;
  std::vector<std::string> parts;
};

/// A word that begins with @ is a file of the directory.
void expect_messages(const std::vector<UserError>& table, const std::string& directory = "") {
  for (const auto& [command, parts] : table) {
    std::vector<std::string> words = subjects::protocol::split_words(command);
    for (std::string& word : words) {
      word = word.starts_with('@') ? directory + '/' + word.substr(1) : word;
    }
    const RunResult result = run_carom(words);
    EXPECT_EQ(result.exit_status, 2) << command << ": " << result.output << result.errors;
    const std::string text = result.output + result.errors;
    for (const std::string& part : parts) {
      EXPECT_NE(text.find(part), std::string::npos) << command << ": expected '" << part << "' in: " << text;
    }
  }
}

json example(const char* name) {
  return json::parse(content_of(std::string(CAROM_SOURCE_DIR) + "/docs/examples/" + name));
}

/// The example, changed at one place. Null removes the field.
std::string changed(json record, const char* pointer, const json& value) {
  const json::json_pointer place(pointer);
  if (value.is_null()) {
    record.at(place.parent_pointer()).erase(place.back());
  } else {
    record[place] = value;
  }
  return record.dump();
}

TEST(Messages, OnTheCommandLineNameTheOptionTheErrorAndTheRemedy) {
  const std::string cradle = std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/cradle.json";
  expect_messages({
      {"", {"no command is given", "expected one of the subcommands", "gate"}},
      {"gat", {"not expected: gat", "Did you mean 'gate'?", "--help"}},
      {"gate --famlies=generic", {"--famlies", "Did you mean '--families'?"}},
      {"gate frictionles-double", {"'frictionles-double'", "carom subjects", "did you mean"}},
      {"gate --families head_no", {"--families", "'head_no'", "expected one of structured"}},
      {"gate frictionless-double --deviates restitutoin", {"--deviates", "did you mean 'restitution'?"}},
      {"gate frictionless-double --deviates energy@hed_on", {"--deviates", "did you mean 'head_on'?"}},
      {"plan x --law smooth", {"--law", "smooth not in", "frictionless"}},
      {"scene " + cradle + " --laws any", {"--laws", "'any'", "expected one of frictionless"}},
      {"chart --out /dev/null/x frictionless", {"'frictionless'", "`carom subjects` lists the subjects"}},
      {"gate --seed -1", {"--seed", "expected an integer from 0 to 2^64 - 1"}},
      {"gate --cases x", {"--cases", "x not in range 1 to 1000000000"}},
      {"gate --digits 19", {"--digits", "19 not in range 1 to 18"}},
      {"plan x --digits 0", {"--digits", "0 not in range 1 to 18"}},
      {"gate --limit-ulps nan", {"--limit-ulps", "expected a number from 0.001"}},
      {"gate --shard 3/2", {"--shard", "expected I/N with I from 1 to N"}},
      {"gate --cases 2 --shard 1/5", {"--shard", "2 cases", "use fewer shards"}},
      {"gate --shard 1/3 --budget 1s", {"--budget excludes --shard"}},
      {"gate --shard 1/3 --fail-fast", {"--fail-fast excludes --shard"}},
      {"gate --shard auto", {"--shard auto", "SLURM_ARRAY_TASK_ID", "use --shard I/N"}},
      {"gate --budget 10", {"--budget", "expected a number and a unit, for example 500ms"}},
      {"gate --budget 1s --cases 5", {"--cases excludes --budget"}},
      {"gate --digits 3 --limit-ulps 32", {"--limit-ulps excludes --digits"}},
      {"gate --baseline x --fail-fast", {"--fail-fast excludes --baseline"}},
      {"gate frictionless-double --baseline /no/report.json", {"/no/report.json", "does not exist", "check the path"}},
      {"gate --format xml", {"--format", "xml not in"}},
      {"gate --timeout 0", {"--timeout", "expected a number from 0.001"}},
      {"gate --annotations nobody", {"--annotations", "nobody not in"}},
      {"gate frictionless-double --annotations github --format json", {"--annotations", "found --format json"}},
      {"gate --within colour=1:2", {"--within", "'colour=1:2' names no quantity", "one of size"}},
      {"gate --within size=2:1", {"--within", "size", "the lesser first", "2:1"}},
      {"gate --within /no/domain.json", {"/no/domain.json", "does not exist", "check the path"}},
      {"gate --within size=1:2,size_ratio=3:", {"--within", "no case of generic lies within", "use wider ranges"}},
      {"gate --within restitution=0.5 --families elastic", {"--families", "no case of elastic lies within"}},
      {"replay --family head_on --case 0 --subject exec:/no/such/program", {"cannot be run: No such file"}},
      {"replay", {"FILE, or --family and --case", "required"}},
      {"replay x.json --family head_on --case 1", {"FILE excludes --family"}},
      {"replay --family haed_on --case 1", {"--family", "did you mean 'head_on'?"}},
      {"replay --family head_on", {"--family requires --case"}},
      {"gate frictionless-double --cases 1 --out ''", {"--out: expected a value", "is a variable not set?"}},
      {"gate --cases 1 --out= frictionless-double", {"--out: expected a value, found an empty text"}},
      {"gate ''", {"SUBJECT: expected a value"}},
      {"compare '' x", {"OLD: expected a value"}},
      {"gate frictionless-double --out /dev/null/out", {"--out", "/dev/null/out", "choose another directory"}},
      {"gate frictionless-double --summary /dev/null/x", {"--summary", "/dev/null/x cannot be written"}},
      {"domain frictionless-double --out /no/such/domain.json", {"--out: the file /no/such/domain.json cannot be"}},
      {"domain frictionless-double --picture /no/such/it.svg", {"--picture: the file /no/such/it.svg cannot be"}},
      {"domain exec:/no/such/program", {"/no/such/program", "cannot be run"}},
      {"domain frictionless-double --core size=1:2,size_ratio=3:", {"--core: no case of generic lies within"}},
      {"domain frictionless-double --beside nowhere", {"--beside: "}},
  });
}

TEST(Messages, OnAFileNameTheFileThePlaceAndTheExpectedValue) {
  const TemporaryDirectory directory;
  const json good = example("head_on.json");
  const std::string line = good.dump() + '\n';
  const std::string light = changed(good, "/a/mass", -1);
  const auto witness = [&](const char* field, const json& value) {
    return changed({{"collision", good}, {"subject", {{"name", "x"}}}}, field, value);
  };
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"cut", R"({"a": )"},
           {"empty", ""},
           {"none", "[]"},
           {"number", "3"},
           {"deep", std::string(100000, '[') + std::string(100000, ']')},
           {"lines", "{\"a\": 1}\n{\"b\": 2}\n"},
           {"second", line + light + '\n'},
           {"second_cut", line + line.substr(0, 40) + '\n'},
           {"element", "[" + good.dump() + "," + light + "]"},
           {"no_mass", changed(good, "/a/mass", nullptr)},
           {"text", changed(good, "/a/mass", "heavy")},
           {"short", changed(good, "/point", {1, 2})},
           {"nan", changed(good, "/a/mass", "nan")},
           {"restitution", changed(good, "/restitution", 1.5)},
           {"unknown", changed(good, "/speed", 1)},
           {"class", changed(good, "/class", 3)},
           {"huge", R"({"a": 1e999})"},
           {"twice", R"({"a": 1, "a": 2})"},
           {"no_invariant", witness("/invariant", "no_such")},
           {"invariant", witness("/invariant", 3)},
           {"subject", witness("/subject", 3)},
           {"model", witness("/subject/model", "smooth")},
           {"no_quantity", R"({"colour": [1, 2]})"},
           {"no_pair", R"({"size": [1]})"},
           {"reversed", R"({"size": [2, 1]})"},
       }) {
    (void)directory.write(name + ".json", text);
  }
  expect_messages(
      {
          {"gate frictionless-double --within @cut.json", {"--within", "cut.json", "not JSON", "line 1"}},
          {"gate frictionless-double --within @no_quantity.json", {"no_quantity.json", "/colour"}},
          {"gate frictionless-double --within @no_pair.json", {"no_pair.json", "/size", "the least and the greatest"}},
          {"gate frictionless-double --within @reversed.json", {"reversed.json", "/size", "the lesser first"}},
          {"replay @cut.json", {"cut.json", "not JSON", "line 1", "expected"}},
          {"replay @empty.json", {"empty.json", "the file is empty", "expected a collision"}},
          {"plan @empty.json", {"empty.json", "the file is empty", "expected a collision"}},
          {"replay @none.json", {"none.json", "the array is empty", "expected at least one collision"}},
          {"replay @number.json", {"number.json", "expected an object"}},
          {"replay @deep.json", {"deep.json", "nested levels"}},
          {"replay @lines.json", {"lines.json:1", "/a", "expected an object, found 1"}},
          {"replay @second.json", {"second.json:2", "a.mass", "greater than 0"}},
          {"plan @second.json", {"second.json:2", "a.mass", "greater than 0"}},
          {"replay @second_cut.json", {"second_cut.json:2", "not JSON"}},
          {"replay @element.json", {"element.json: element 1", "a.mass"}},
          {"replay @no_mass.json", {"no_mass.json", "/a/mass", "is missing", "add this field"}},
          {"replay @text.json", {"text.json", "/a/mass", "expected a number, found \"heavy\""}},
          {"replay @short.json", {"short.json", "/point", "expected an array of 3 numbers"}},
          {"replay @nan.json", {"nan.json", "a.mass", "expected a finite number"}},
          {"replay @restitution.json", {"restitution.json", "restitution", "expected a number from 0 to 1"}},
          {"replay @unknown.json", {"unknown.json", "/speed", "unknown field", "expected one of a, b"}},
          {"plan @class.json", {"class.json", "/class", "expected a string"}},
          {"replay @huge.json", {"huge.json", "'1e999'", "overflows binary64"}},
          {"replay @twice.json", {"twice.json", "\"a\" occurs twice", "keep one of them"}},
          {"replay @no.json", {"/no.json", "does not exist", "check the path"}},
          {"replay @", {"expected a file, found a directory"}},
          {"replay /proc/self/mem", {"/proc/self/mem", "the file cannot be read", "error"}},
          {"replay @nan.json --drawn", {"nan.json", "/drawn", "only a witness", "use --drawn with a witness"}},
          {"replay @no_invariant.json", {"no_invariant.json", "/invariant", "no_such"}},
          {"replay @invariant.json", {"invariant.json", "/invariant", "expected a string"}},
          {"replay @subject.json", {"subject.json", "/subject", "expected an object"}},
          {"replay @model.json", {"model.json", "/subject/model", "'smooth'", "expected one of frictionless"}},
      },
      directory.path().string());
}

TEST(Messages, OnASceneNameTheFileThePlaceAndTheExpectedValue) {
  const TemporaryDirectory directory;
  const json scene = example("scenes/cradle.json");
  (void)directory.write("no_duration.json", changed(scene, "/duration", nullptr));
  (void)directory.write("law.json", changed(scene, "/law", "smooth"));
  (void)directory.write("alone.json", changed(scene, "/spheres", json::array()));
  (void)directory.write("radius.json", changed(scene, "/spheres/1/radius", -1));
  (void)directory.write("overlap.json", changed(scene, "/spheres/1/position", scene.at("spheres")[0].at("position")));
  (void)directory.write("polyhedra.json", R"({"duration": 1, "polyhedra": [
      {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "density": 1, "position": [0,0,0]},
      {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "density": 1, "position": [0.125,0,0]}]})");
  expect_messages(
      {
          {"scene @no_duration.json", {"no_duration.json", "/duration", "is missing", "add this field"}},
          {"scene @law.json", {"law.json", "/law", "expected frictionless, reflection", "found \"smooth\""}},
          {"scene @radius.json", {"radius.json", "/spheres/1/radius"}},
          {"scene @overlap.json", {"overlap.json", "overlap"}},
          {"scene @polyhedra.json", {"/polyhedra/1: polyhedron 1 (polyhedron 1) may overlap polyhedron 0"}},
          {"scene @no.json", {"/no.json", "does not exist"}},
          {"plan @alone.json", {"alone.json", "has no collisions", "needs at least one"}},
      },
      directory.path().string());
}

namespace fs = std::filesystem;

/// Characters that may hide text: ESC, the control characters C1, and characters that reverse the writing direction.
constexpr const char* controls = "\x1b[31m\u009b31m\u202e\u2066\u200f";

void expect_harmless(const RunResult& run) {
  for (const std::string& text : {run.output, run.errors}) {
    for (const char* control : {"\x1b", "\u009b", "\u202e", "\u2066", "\u200f", "\r"}) {
      EXPECT_EQ(text.find(control), std::string::npos) << text;
    }
  }
}

json ball() { return collision_to_json(unit::ball_on_a_plane(0.5, 1)); }

json report_of_one_subject() {
  return json::parse(R"({"carom": "0.1.0", "environment": {"date": "2026-11-25"}, "seed": 1, "cases_of_each_family": 5,
    "yardstick": {"limit_ulps": 32}, "interrupted": false, "families": [], "subjects": [
    {"name": "mine", "version": "1", "precision": "binary64", "model": "reflection", "status": "violated",
     "deviates": [], "counts": true, "error": "", "worst_backward_error": {"ulps": "inf", "family": ""},
     "digits": {"p50": 15.2, "p99": "-inf", "worst": "-inf"}, "violations": [], "families": [],
     "nanoseconds_per_solve": 12}]})");
}

RunResult compared(const TemporaryDirectory& directory, const std::string& report) {
  const std::string file = directory.write("report.json", report);
  return run_carom({"compare", file, file});
}

TEST(HostileInput, ReachesTheTerminalWithoutControlCharacters) {
  const TemporaryDirectory directory;
  json report = report_of_one_subject();
  for (const char* field : {"name", "version", "precision", "status"}) {
    report["subjects"][0][field] = controls;
  }
  expect_harmless(compared(directory, report.dump()));
  report["subjects"][0]["model"] = 3;
  expect_harmless(compared(directory, report.dump()));
  report["subjects"][0][controls] = json();
  expect_harmless(compared(directory, report.dump() + controls));

  json named = ball();
  named["class"] = std::string("crate\n") + controls;
  const std::string contacts = directory.write("contacts.json", named.dump());
  const RunResult planned = run_carom({"plan", contacts, "--repetitions", "0"});
  unit::expect_in(planned.output, {"crate ?[31m?31m???"});
  expect_harmless(planned);
  for (const char* field : {"name", "specification"}) {
    const json witness{{"collision", ball()}, {"subject", {{"name", "x"}, {field, std::string("exec:") + controls}}}};
    expect_harmless(run_carom({"replay", directory.write("witness.json", witness.dump())}));
  }
  for (const char* field : {"invariant", "class", "collision"}) {
    json witness{{"collision", ball()}};
    witness[field] = controls;
    expect_harmless(run_carom({"replay", directory.write(controls, witness.dump())}));
  }
  json scene = json::parse(content_of(std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/cradle.json"));
  scene["title"] = std::string("title\n") + controls;
  const RunResult run = run_carom({"scene", directory.write("scene.json", scene.dump()), "--events", "3"});
  EXPECT_TRUE(run.output.starts_with("title ?[31m")) << run.output << run.errors;
  expect_harmless(run);
  scene["law"] = controls;
  expect_harmless(run_carom({"scene", directory.write("scene.json", scene.dump())}));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // those sanitizers reserve the whole address space

/// Runs the script with much less memory than the size of the file.
RunResult in_bounded_memory(const std::string& script) {
  return run_program("/bin/sh", {"-c", "ulimit -v 1000000; exec 2>&1; " + script, carom_program()});
}

TEST(HostileInput, WithoutAnEndIsReadToALimitInLittleMemory) {
  for (const char* command : {"compare /dev/zero", "replay", "scene", "plan"}) {
    const RunResult run = in_bounded_memory(std::string(R"("$0" )") + command + " /dev/zero");
    EXPECT_EQ(run.exit_status, 2);
    unit::expect_in(run.output, {"/dev/zero: the file is larger than 256 MiB"});
  }
}

TEST(HostileInput, ThatTakesAllMemoryEndsInAMessageWithTheLimit) {
  const RunResult run =
      run_program("/bin/sh", {"-c", R"(ulimit -v 200000; exec "$0" replay /dev/zero)", carom_program()});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_EQ(run.errors, "carom: memory is short: at most 200000 KiB may be used (ulimit -v)\n");
}

TEST(ShortageOfOpenFiles, IsNamedWithItsLimit) {
  const TemporaryDirectory out;
  expect_error(run_program("/bin/sh", {"-c", R"(exec 3>&- 4>&-; ulimit -n 5; exec "$0" "$@")", carom_program(), "gate",
                                       "frictionless-double", "--families", "generic", "--cases", "20", "--out",
                                       out.path().string()}),
               {"files are short: at most 5 may be open (ulimit -n)"});
}

#endif

TEST(JsonLines, AreJudgedAsTheyComeAndAWrongLineIsNamed) {
  const TemporaryDirectory directory;
  const std::string line = directory.write("line.json", ball().dump() + '\n');
  const std::string invalid = directory.write("invalid.json", "{}\n");
  // Even if the file does not end, an error is reported, and earlier results are printed.
  const RunResult bad = run_program(
      "/bin/sh",
      {"-c",
       R"({ cat "$1" "$1"; echo; cat "$2"; while echo; do sleep 0.1; done; } | { "$0" replay /dev/stdin; echo "status $?"; })",
       carom_program(), line, invalid});
  unit::expect_in(bad.errors, {"/dev/stdin:4: /a: is missing"});
  unit::expect_in(bad.output, {"/dev/stdin:2\n"});
  const RunResult long_line =
      in_bounded_memory("{ cat " + line + " " + line + R"(; head -c 20000000 /dev/zero; } | "$0" replay /dev/stdin)");
  EXPECT_EQ(long_line.exit_status, 2);
  unit::expect_in(long_line.output, {"/dev/stdin:3: the line is longer than 16 MiB"});
}

TEST(HostileInput, OfOneLongLineIsReadAsAWhole) {
  const TemporaryDirectory directory;
  std::string text = "[" + ball().dump() + std::string(17 << 20, ' ') + "]\n";
  const RunResult run = run_carom({"replay", directory.write("long.json", text), "--format", "json"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  unit::expect_in(run.output, {"element 0"});
}

/// Each command waits for a pipe, first without a writer, then with a silent writer.
TEST(InputThatNeverComes, IsNotAwaitedAfterASignal) {
  for (const char* command : {"replay", "plan", "scene", "check"}) {
    const TemporaryDirectory directory;
    const std::string pipe = (directory.path() / "pipe.csv").string();  // `check` reads CSV
    ASSERT_EQ(mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR), 0);
    for (const char* script : {"sleep 0.3; kill -TERM $1", "exec 3> \"$0\"; sleep 0.3; kill -TERM $1; sleep 1"}) {
      const pid_t waiting = start_carom({command, pipe});
      EXPECT_EQ(run_program("/bin/sh", {"-c", script, pipe, std::to_string(waiting)}).exit_status, 0);
      EXPECT_EQ(wait_for(waiting), 2) << command;
    }
  }
}

}  // namespace
}  // namespace carom::tests
