// SPDX-License-Identifier: BSL-1.0
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <carom/collision/json/json.hpp>

#include "support/cases.hpp"
#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

using nlohmann::json;
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
  const RunResult run = run_program(
      "/bin/sh", {"-c", R"(exec 3>&- 4>&-; ulimit -n 5; exec "$0" "$@")", carom_program(), "gate",
                  "frictionless-double", "--families", "generic", "--cases", "20", "--out", out.path().string()});
  EXPECT_EQ(run.exit_status, 2);
  unit::expect_in(run.errors, {"files are short: at most 5 may be open (ulimit -n)"});
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
  for (const char* command : {"replay", "plan", "scene"}) {
    const TemporaryDirectory directory;
    const std::string pipe = (directory.path() / "pipe").string();
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
