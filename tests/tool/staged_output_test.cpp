// SPDX-License-Identifier: BSL-1.0
#include <array>
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

#include "support/program.hpp"

namespace carom::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<std::string> finding_gate(const fs::path& out) {
  return {"gate",      "reflection-in-basis-double", "--families", "head_on,near_head_on", "--cases", "40", "--out",
          out.string()};
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
  for (const std::string& witness : listed_witnesses(out)) {
    EXPECT_FALSE(json::parse(content_of(out / witness), nullptr, false).is_discarded()) << witness;
  }
}

/// Runs a shell script that refers to `carom ARG…` as "$@".
RunResult in_shell(const std::string& script, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"-c", script, "sh", carom_program()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/bin/sh", words);
}

TEST(StagedOutput, ReportsStandWhereStandardOutputBreaks) {
  struct Broken {
    const char* script;
    const char* errors;
  };
  for (const auto& [script, errors] :
       {Broken{R"({ "$@"; echo "status $?" >&2; } | true)", "status 141\n"},
        Broken{R"({ "$@" --format json; echo "status $?" >&2; } | true)", "status 141\n"},
        Broken{R"("$@" > /dev/full; echo "status $?" >&2)",
               "carom: standard output: cannot write to file: No space left on device\nstatus 2\n"}}) {
    const TemporaryDirectory out;
    const RunResult run = in_shell(script, finding_gate(out.path()));
    EXPECT_EQ(run.errors, errors) << script;
    ASSERT_TRUE(fs::exists(out.path() / "report.json")) << script;
    EXPECT_FALSE(listed_witnesses(out.path()).empty());
    expect_all_listed_witnesses_stand(out.path());
  }
}

TEST(StagedOutput, OldReportsStandWhereNewOnesCannotBeWritten) {
  const TemporaryDirectory out;
  ASSERT_EQ(run_carom(finding_gate(out.path())).exit_status, 1);
  const std::string old = content_of(out.path() / "report.json");
  const std::string old_page = content_of(out.path() / "report.html");
  for (const char* blocks : {"0", "1", "8", "20"}) {
    const RunResult run =
        in_shell(std::string("{ ulimit -f ") + blocks + R"(; "$@"; } 2>&1 | cat)", finding_gate(out.path()));
    EXPECT_NE(run.output.find("cannot be written: File too large"), std::string::npos) << run.output << run.errors;
    EXPECT_NE(run.output.find("It violates "), std::string::npos) << "what was found is printed";
    EXPECT_EQ(content_of(out.path() / "report.json"), old);
    EXPECT_EQ(content_of(out.path() / "report.html"), old_page);
    expect_all_listed_witnesses_stand(out.path());
    EXPECT_TRUE(hidden(out.path()).empty());
  }
}

TEST(StagedOutput, OldReportsStandOnAFullDisk) {
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
  EXPECT_NE(run.errors.find("No space left"), std::string::npos) << run.errors;
}

TEST(StagedOutput, AReportStandsWithItsWitnessesWheneverTheRunIsKilled) {
  const TemporaryDirectory out;
  ASSERT_EQ(run_carom(finding_gate(out.path())).exit_status, 1);
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  ASSERT_EQ(run_carom(finding_gate(out.path())).exit_status, 1);
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start);
  std::mt19937 random(7);
  for (int round = 0; round < 12; ++round) {
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
  EXPECT_TRUE(hidden(out.path()).empty()) << "what a killed run left behind is cleared away";
  std::set<std::string> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(out.path() / "witnesses")) {
    found.insert("witnesses/" + entry.path().filename().string());
  }
  EXPECT_EQ(found, listed_witnesses(out.path()));
}

TEST(StagedOutput, ClearsAwayAbandonedStagesAndTheirWitnessesAlone) {
  const TemporaryDirectory out;
  const std::string listed = R"({"carom": "0.1.0", "subjects": [{"violations": [{"witness": "WITNESS"}]}]})";
  const auto report_of = [&](const std::string& witness) {
    return std::string(listed).replace(listed.find("WITNESS"), 7, witness);
  };
  const fs::path dead = out.path() / ".carom-stage-0123456789abcdef";
  const fs::path other = out.path() / ".carom-stage-of-somebody-else";
  fs::create_directories(out.path() / "witnesses");
  for (const fs::path& stage : {dead, other}) {
    fs::create_directories(stage);
    const std::string witness = "witnesses/" + stage.filename().string().substr(13) + ".restitution.json";
    (void)out.write((stage.filename() / "report.json").string(), report_of(witness));
    (void)out.write(witness, "{}");
  }
  const RunResult run = run_carom({"gate", "frictionless-double", "--families", "generic", "--deviates",
                                   few_families_judge_no, "--cases", "5", "--out", out.path().string()});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(other / "report.json"));
  EXPECT_FALSE(fs::exists(out.path() / "witnesses" / "0123456789abcdef.restitution.json"));
  EXPECT_TRUE(fs::exists(out.path() / "witnesses" / "of-somebody-else.restitution.json"));
}

TEST(StagedOutput, ADirectoryThatAnotherRunWritesToIsRefused) {
  const TemporaryDirectory out;
  const int lock = open((out.path() / ".carom-lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_EQ(flock(lock, LOCK_EX), 0);
  const std::string scene = std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/cradle.json";
  for (const std::vector<std::string>& arguments :
       {finding_gate(out.path()),
        std::vector<std::string>{"scene", scene, "--events", "5", "--out", out.path().string()}}) {
    const RunResult run = run_carom(arguments);
    EXPECT_EQ(run.exit_status, 2);
    EXPECT_NE(run.errors.find("--out: another run writes to the directory " + out.path().string()), std::string::npos)
        << run.errors;
  }
  EXPECT_FALSE(fs::exists(out.path() / "report.json"));
  close(lock);
  EXPECT_EQ(run_carom(finding_gate(out.path())).exit_status, 1) << "nobody holds the lock, so its file is no matter";
  EXPECT_TRUE(hidden(out.path()).empty());
}

/// Two runs at once find different witnesses, because their families differ. One of them may be refused.
TEST(StagedOutput, RunsAtOnceLoseNoWitness) {
  const TemporaryDirectory out;
  for (int round = 0; round < 8; ++round) {
    std::vector<pid_t> gates;
    for (const char* family : {"slow", "elastic"}) {
      std::vector<std::string> arguments = finding_gate(out.path());
      arguments[3] = family;
      gates.push_back(start_carom(arguments));
    }
    int refused = 0;
    for (const pid_t gate : gates) {
      const int status = wait_for(gate);
      EXPECT_TRUE(status == 1 || status == 2) << status;
      refused += status == 2 ? 1 : 0;
    }
    EXPECT_LE(refused, 1);
    EXPECT_FALSE(listed_witnesses(out.path()).empty());
    expect_all_listed_witnesses_stand(out.path());
  }
  EXPECT_TRUE(hidden(out.path()).empty());
}

TEST(StagedOutput, AForeignFileWithTheNameOfTheLockStays) {
  const TemporaryDirectory out;
  const std::string foreign = out.write(".carom-lock", "mine");
  const RunResult run = run_carom(finding_gate(out.path()));
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_NE(run.errors.find(foreign + " is not Carom's"), std::string::npos) << run.errors;
  EXPECT_EQ(content_of(foreign), "mine");
}

std::string text_of_lock(pid_t process) {
  std::array<char, 256> host{};
  EXPECT_EQ(gethostname(host.data(), host.size() - 1), 0);
  return std::to_string(process) + " native " + host.data() + '\n';
}

pid_t killed_run() {
  const pid_t run = start_carom({"--version"});
  (void)wait_for(run);
  return run;
}

/// tests/web/npm/output_folder.test.mjs tests the other order.
TEST(StagedOutput, ADirectoryThatARunOfTheNpmPackageWritesToIsRefused) {
  const TemporaryDirectory out;
  for (const std::string& text : {text_of_lock(getpid()), std::string("1 x another machine\n"), std::string("mine")}) {
    const std::string lock = out.write(".carom-lock-npm", text);
    const RunResult run = run_carom(finding_gate(out.path()));
    EXPECT_EQ(run.exit_status, 2);
    EXPECT_NE(run.errors.find("another run writes to the directory " + out.path().string()), std::string::npos);
    EXPECT_NE(run.errors.find("If there is no such run, remove " + lock), std::string::npos) << run.errors;
    EXPECT_EQ(content_of(lock), text);
    EXPECT_EQ(hidden(out.path()), std::vector<std::string>{".carom-lock-npm"});
    EXPECT_FALSE(fs::exists(out.path() / "report.json"));
  }
  (void)out.write(".carom-lock-npm", text_of_lock(killed_run()));
  EXPECT_EQ(run_carom(finding_gate(out.path())).exit_status, 1) << "a killed run locks nothing";
}

TEST(StagedOutput, TheLockNamesTheRun) {
  const TemporaryDirectory out;
  const std::string lock = out.write(".carom-lock", text_of_lock(killed_run()));
  const pid_t gate = start_carom(
      {"gate", "frictionless-double", "--families", "generic", "--cases", "1000000000", "--out", out.path().string()});
  const std::string expected = text_of_lock(gate);
  for (int tries = 0; tries < 1000 && content_of(lock) != expected; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(content_of(lock), expected);
  kill(gate, SIGKILL);
  (void)wait_for(gate);
  EXPECT_EQ(run_carom(finding_gate(out.path())).exit_status, 1) << "the file of a killed run is no matter";
  EXPECT_TRUE(hidden(out.path()).empty());
}

TEST(StagedOutput, NothingIsPutInPlaceWhereADirectoryIsInTheWay) {
  const TemporaryDirectory out;
  fs::create_directories(out.path() / "report.json");
  const RunResult run = run_carom(finding_gate(out.path()));
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_NE(run.errors.find("report.json cannot be written: Is a directory"), std::string::npos) << run.errors;
  EXPECT_FALSE(fs::exists(out.path() / "report.html"));
  EXPECT_TRUE(fs::is_empty(out.path() / "witnesses"));
}

TEST(StagedOutput, WitnessesMayLieOnAnotherFileSystem) {
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
  fs::remove_all(other);
}

TEST(StagedOutput, FilesOfASceneComeTogetherOrNotAtAll) {
  const TemporaryDirectory out;
  const std::string scene = std::string(CAROM_SOURCE_DIR) + "/docs/examples/scenes/cradle.json";
  const std::vector<std::string> arguments{"scene", scene, "--events", "5", "--out", out.path().string()};
  ASSERT_NE(run_carom(arguments).exit_status, 2);
  const std::string old = content_of(out.path() / "scene.json");
  ASSERT_FALSE(old.empty());
  std::vector<std::string> longer = arguments;
  longer[3] = "50";
  const RunResult run = in_shell(R"({ ulimit -f 8; "$@"; } 2>&1 | cat)", longer);
  EXPECT_NE(run.output.find("cannot be written: File too large"), std::string::npos) << run.output;
  EXPECT_EQ(content_of(out.path() / "scene.json"), old);
  EXPECT_TRUE(hidden(out.path()).empty());
  EXPECT_NE(in_shell(R"("$@" > /dev/full)", longer).errors.find("standard output"), std::string::npos);
  EXPECT_NE(content_of(out.path() / "scene.json"), old) << "the files are there";
}

}  // namespace
}  // namespace carom::tests
