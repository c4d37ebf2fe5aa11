// SPDX-License-Identifier: BSL-1.0
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "support/expect_in.hpp"
#include "support/program.hpp"

namespace carom::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string cradle = std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/cradle.json";

/// A run that writes a dozen witnesses. Its answers are within rounding, so the cause takes no time to find.
std::vector<std::string> finding_gate(const fs::path& out, const std::string& families = "head_on,near_head_on") {
  return {"gate",   "reflection-double", "--limit-ulps", "0.001", "--families",
          families, "--cases",           "40",           "--out", out.string()};
}

RunResult sound_gate(const fs::path& out) {
  return run_carom({"gate", "frictionless-double", "--families", "generic", "--deviates", few_families_judge_no,
                    "--cases", "5", "--out", out.string()});
}

std::vector<std::string> hidden(const fs::path& directory) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (entry.path().filename().string().starts_with(".")) {
      names.push_back(entry.path().filename().string());
    }
  }
  return names;
}

std::set<std::string> listed_witnesses(const fs::path& out) {
  std::set<std::string> listed;
  const json report = json::parse(content_of(out / "report.json"));
  for (const json& subject : report.at("subjects")) {
    for (const json& violation : subject.at("violations")) {
      listed.insert(violation.at("witness").get<std::string>());
    }
  }
  return listed;
}

void expect_all_listed_witnesses_stand(const fs::path& out) {
  const std::set<std::string> listed = listed_witnesses(out);
  EXPECT_FALSE(listed.empty());
  for (const std::string& witness : listed) {
    EXPECT_FALSE(json::parse(content_of(out / witness), nullptr, false).is_discarded()) << witness;
  }
}

/// Runs a shell script that refers to `carom ARG…` as "$@".
RunResult in_shell(const std::string& script, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"-c", script, "sh", carom_program()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/bin/sh", words);
}

const std::vector<std::vector<std::string>> printing_commands{
    {"--version"},
    {"--help"},
    {"features", "--format", "json"},
    {"replay", std::string(CAROM_SOURCE_DIR) + "/docs/examples/head_on.json"},
};

/// As with other programs, `carom … | head -1` prints no error. The loop waits until the reader is gone.
TEST(StandardOutput, EndsTheProgramSilentlyIfNobodyReadsItAndIsAnErrorIfItCannotBeWritten) {
  const std::string broken = R"({ trap '' PIPE; while echo 2> /dev/null; do :; done; trap - PIPE; "$@"; status=$?
    echo "status $status" >&2; } | true)";
  for (const std::vector<std::string>& command : printing_commands) {
    EXPECT_EQ(in_shell(broken, command).errors, "status 141\n") << command[0];
    const std::string said = in_shell(R"("$@" > /dev/full; echo "status $?" >&2)", command).errors;
    EXPECT_TRUE(said.starts_with("carom: standard output")) << command[0] << ": " << said;
    EXPECT_TRUE(said.ends_with(": No space left on device\nstatus 2\n")) << command[0] << ": " << said;
  }
}

TEST(Reports, AreWrittenIfStandardOutputBreaks) {
  struct Broken {
    const char* script;
    const char* errors;
  };
  for (const auto& [script, errors] :
       {Broken{R"({ "$@"; echo "status $?" >&2; } | true)", "status 141\n"},
        Broken{R"("$@" > /dev/full; echo "status $?" >&2)",
               "carom: standard output cannot be written: No space left on device\nstatus 2\n"}}) {
    const TemporaryDirectory out;
    EXPECT_EQ(in_shell(script, finding_gate(out.path())).errors, errors);
    ASSERT_TRUE(fs::exists(out.path() / "report.json")) << script;
    expect_all_listed_witnesses_stand(out.path());
  }
}

TEST(Reports, StayAsTheyWereIfNewOnesCannotBeWritten) {
  const TemporaryDirectory out;
  ASSERT_EQ(run_carom(finding_gate(out.path())).exit_status, 1);
  const std::string old = content_of(out.path() / "report.json");
  const std::string old_page = content_of(out.path() / "report.html");
  for (const char* blocks : {"0", "8", "20"}) {
    const RunResult run =
        in_shell(std::string("{ ulimit -f ") + blocks + R"(; "$@"; } 2>&1 | cat)", finding_gate(out.path()));
    unit::expect_in(run.output, {"cannot be written: File too large"});
    EXPECT_NE(run.output.find("It violates "), std::string::npos) << "the results are printed";
    EXPECT_EQ(content_of(out.path() / "report.json"), old);
    EXPECT_EQ(content_of(out.path() / "report.html"), old_page);
    expect_all_listed_witnesses_stand(out.path());
    EXPECT_TRUE(hidden(out.path()).empty());
  }
}

TEST(Reports, StayAsTheyWereOnAFullDisk) {
  const TemporaryDirectory directory;
  const std::string script = R"sh(mount -t tmpfs -o size=8m tmpfs "$OUT" || exit 77
"$@" > /dev/null; [ $? = 1 ] || exit 3
cp "$OUT/report.json" "$COPY"
head -c 8000000 /dev/zero > "$OUT/ballast" 2> /dev/null
"$@" > /dev/null; [ $? = 2 ] || exit 4
cmp "$OUT/report.json" "$COPY" || exit 5
[ -z "$(ls -d "$OUT"/.carom* 2> /dev/null)" ] || exit 6)sh";
  const fs::path out = directory.path() / "out";
  fs::create_directory(out);
  std::vector<std::string> words{"OUT=" + out.string(),
                                 "COPY=" + (directory.path() / "copy").string(),
                                 "unshare",
                                 "--mount",
                                 "/bin/sh",
                                 "-c",
                                 script,
                                 "sh",
                                 carom_program()};
  const std::vector<std::string> arguments = finding_gate(out);
  words.insert(words.end(), arguments.begin(), arguments.end());
  const RunResult run = run_program("/usr/bin/env", words);
  if (run.exit_status == 77 || run.errors.find("unshare") != std::string::npos) {
    GTEST_SKIP() << "no file system can be mounted here: " << run.errors;
  }
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  unit::expect_in(run.errors, {"No space left"});
}

TEST(Reports, HaveAllTheirWitnessesWheneverARunIsKilled) {
  const TemporaryDirectory out;
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  ASSERT_EQ(run_carom(finding_gate(out.path())).exit_status, 1);
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start);
  std::mt19937 random(7);
  for (int round = 0; round < 9; ++round) {
    // Two of three signals come towards the end, when the program writes files.
    const auto earliest = round % 3 == 0 ? 0 : 7 * whole.count() / 10;
    std::uniform_int_distribution<std::int64_t> moment(earliest, 11 * whole.count() / 10);
    const pid_t gate = start_carom(finding_gate(out.path()));
    std::this_thread::sleep_for(std::chrono::microseconds(moment(random)));
    kill(gate, SIGKILL);
    (void)wait_for(gate);
    expect_all_listed_witnesses_stand(out.path());
  }
  ASSERT_EQ(run_carom(finding_gate(out.path())).exit_status, 1);
  EXPECT_TRUE(hidden(out.path()).empty()) << "stages and locks of killed runs are removed";
}

/// The foreign report lists files that are no witnesses.
TEST(Reports, ReplaceTheWitnessesOfTheOldReportAndNothingElse) {
  const TemporaryDirectory out;
  ASSERT_EQ(run_carom(finding_gate(out.path())).exit_status, 1);
  const std::set<std::string> old = listed_witnesses(out.path());
  ASSERT_GT(old.size(), 2U);
  fs::create_directories(out.path() / ".carom-stage-0123456789abcdef");
  fs::create_directories(out.path() / ".carom-stage-of-somebody-else");
  fs::create_directories(out.path() / "witnesses" / "reflection-double.x");
  std::vector<std::string> foreign{
      out.write("witnesses/mine.json", "{}"), out.write("witnesses/reflection-in-basis-double.no_invariant.json", "{}"),
      out.write("witnesses/unlisted.restitution.json", "{}"), out.write("outside.json", "{}")};
  const fs::path linked = out.path() / *old.begin();
  fs::remove(linked);
  fs::create_symlink(out.path() / "outside.json", linked);
  json report = json::parse(content_of(out.path() / "report.json"));
  json& violations = report.at("subjects").at(0).at("violations");
  for (const char* name : {"x/../../outside", "no_invariant"}) {
    violations.push_back(violations.at(0));
    violations.back()["invariant"] = name;
    violations.back()["witness"] = "outside.json";
  }
  (void)out.write("report.json", report.dump());
  EXPECT_EQ(sound_gate(out.path()).exit_status, 0);
  for (const std::string& witness : old) {
    EXPECT_EQ(fs::exists(fs::symlink_status(out.path() / witness)), out.path() / witness == linked) << witness;
  }
  for (const std::string& file : foreign) {
    EXPECT_TRUE(fs::exists(file)) << file;
  }
  EXPECT_EQ(hidden(out.path()), std::vector<std::string>{".carom-stage-of-somebody-else"});
}

TEST(Reports, RemoveNothingIfTheOldReportIsNotCaroms) {
  for (const char* text : {"", "{", R"({"carom": "0.1.0", "subjects": 3})",
                           R"({"subjects": [{"name": "old", "violations": [{"invariant": "push"}]}]})"}) {
    const TemporaryDirectory out;
    fs::create_directories(out.path() / "witnesses");
    const std::string witness = out.write("witnesses/old.push.json", "{}");
    (void)out.write("report.json", text);
    EXPECT_EQ(sound_gate(out.path()).exit_status, 0) << text;
    EXPECT_TRUE(fs::exists(witness)) << text;
  }
}

TEST(Reports, AreNotPutInPlaceIfADirectoryHasTheNameOfOne) {
  const TemporaryDirectory out;
  fs::create_directories(out.path() / "report.json");
  expect_error(run_carom(finding_gate(out.path())), {"report.json cannot be written: Is a directory"});
  EXPECT_FALSE(fs::exists(out.path() / "report.html"));
  EXPECT_TRUE(fs::is_empty(out.path() / "witnesses"));
}

TEST(Reports, AreWrittenIfTheWitnessesAreOnAnotherFileSystem) {
  const fs::path other = fs::path("/dev/shm") / ("carom-test-" + std::to_string(getpid()));
  std::error_code error;
  fs::create_directories(other, error);
  if (error) {
    GTEST_SKIP() << "no /dev/shm to write to: " << error.message();
  }
  const TemporaryDirectory out;
  fs::create_directory_symlink(other, out.path() / "witnesses");
  EXPECT_EQ(run_carom(finding_gate(out.path())).exit_status, 1);
  expect_all_listed_witnesses_stand(out.path());
  EXPECT_TRUE(hidden(other).empty());
  const std::string witness = *listed_witnesses(out.path()).begin();
  EXPECT_EQ(sound_gate(out.path()).exit_status, 0);
  EXPECT_TRUE(fs::exists(out.path() / witness)) << "nothing is removed through a symbolic link";
  fs::remove_all(other);
}

/// tests/web/npm/output_folder.test.mjs tests that the npm package respects the lock of this program.
TEST(OutputLock, KeepsOtherRunsOutOfTheDirectory) {
  const TemporaryDirectory out;
  const auto expect_refused = [&](const std::vector<std::string>& arguments, const std::string& says) {
    const RunResult run = run_carom(arguments);
    expect_error(run, {says});
    EXPECT_EQ(hidden(out.path()).size(), 1U) << "only the lock of the other run";
  };
  const std::string another = "--out: another run writes to the directory " + out.path().string();
  const fs::path lock = out.path() / ".carom-lock";
  const int file = open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_EQ(flock(file, LOCK_EX), 0);
  expect_refused(finding_gate(out.path()), another);
  expect_refused({"scene", cradle, "--events", "5", "--out", out.path().string()}, another);
  close(file);
  EXPECT_EQ(run_carom(finding_gate(out.path())).exit_status, 1) << "nobody holds the lock that the file is for";
  EXPECT_TRUE(hidden(out.path()).empty());

  const std::string foreign = out.write(".carom-lock", "mine");
  expect_refused(finding_gate(out.path()), foreign + " is not Carom's");
  EXPECT_EQ(content_of(foreign), "mine");
  fs::remove(foreign);
  const std::string of_npm = out.write(".carom-lock-npm", "1 x another machine\n");
  expect_refused(finding_gate(out.path()), "If there is no such run, remove " + of_npm);
  EXPECT_EQ(content_of(of_npm), "1 x another machine\n");
}

/// Two runs at once find different witnesses, because their families differ. One of them may be refused.
TEST(OutputLock, KeepsEveryWitnessOfTwoRunsAtOnce) {
  const TemporaryDirectory out;
  for (int round = 0; round < 4; ++round) {
    std::vector<pid_t> gates;
    for (const char* family : {"slow", "elastic"}) {
      gates.push_back(start_carom(finding_gate(out.path(), family)));
    }
    int refused = 0;
    for (const pid_t gate : gates) {
      const int status = wait_for(gate);
      EXPECT_TRUE(status == 1 || status == 2) << status;
      refused += status == 2 ? 1 : 0;
    }
    EXPECT_LE(refused, 1);
    expect_all_listed_witnesses_stand(out.path());
  }
  EXPECT_TRUE(hidden(out.path()).empty());
}

TEST(FilesOfAScene, AppearTogetherOrNotAtAll) {
  const TemporaryDirectory out;
  const std::vector<std::string> arguments{"scene", cradle, "--events", "5", "--out", out.path().string()};
  EXPECT_EQ(run_carom(arguments).exit_status, 2) << "--events ends the run early";
  const std::string old = content_of(out.path() / "scene.json");
  ASSERT_FALSE(old.empty());
  std::vector<std::string> longer = arguments;
  longer[3] = "50";
  const RunResult run = in_shell(R"({ ulimit -f 8; "$@"; } 2>&1 | cat)", longer);
  unit::expect_in(run.output, {"cannot be written: File too large"});
  EXPECT_EQ(content_of(out.path() / "scene.json"), old);
  EXPECT_TRUE(hidden(out.path()).empty());
  unit::expect_in(in_shell(R"("$@" > /dev/full)", longer).errors, {"standard output"});
  EXPECT_NE(content_of(out.path() / "scene.json"), old) << "the files are there";
}

}  // namespace
}  // namespace carom::tests
