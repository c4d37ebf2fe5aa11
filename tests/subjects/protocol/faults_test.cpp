// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <future>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "support/cases.hpp"
#include "support/expect_in.hpp"
#include "support/program.hpp"

/// The gate's reaction to programs that violate the protocol, or misread what it permits.
namespace carom::tests {
namespace {

using nlohmann::json;

std::string misbehaving(const std::string& fault, const std::string& name = "faulty") {
  return std::string("exec:") + CAROM_MISBEHAVING + ' ' + fault + ' ' + name;
}

/// The gate's report on these subjects. Most faults occur at the third collision after the start of the program.
struct Gate {
  RunResult run;
  json report;

  explicit Gate(std::vector<std::string> subjects, const char* timeout = "0.7") {
    const TemporaryDirectory directory;
    std::vector<std::string> arguments{"gate"};
    arguments.insert(arguments.end(), subjects.begin(), subjects.end());
    for (const char* argument : {"--families", "structured", "--deviates", few_families_judge_no, "--cases", "6",
                                 "--timeout", timeout, "--jobs", "1", "--out"}) {
      arguments.emplace_back(argument);
    }
    arguments.push_back(directory.path().string());
    run = run_carom(arguments);
    const std::string text = content_of(directory.path() / "report.json");
    report = text.empty() ? json() : json::parse(text);
  }

  [[nodiscard]] const json& subject(std::size_t index) const { return report.at("subjects").at(index); }
};

constexpr const char* no_line =
    "wrote no line within 0.7 s; it must write one line for each request and flush it (--timeout gives it more time)";

struct Fault {
  std::string fault;
  std::vector<std::string> says;  // parts of the error message
  bool hangs = false;
};

std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.fault; }

const std::vector<Fault>& all_faults() {
  static const std::vector<Fault> faults{
      Fault{"exit-at-once", {"start", "ended with status 7", "nothing to do here", "\"cmd\":\"start\""}},
      Fault{"hang-at-start", {"start", no_line}, true},
      Fault{"signal", {"solve 3", "signal 11", "request: {"}},
      Fault{"hang", {"solve 3", no_line}, true},
      Fault{"exit-in-the-middle", {"solve 3", "ended with status 0"}},
      Fault{"out-of-order", {"solve 3", "/id: expected 3, found 4"}},
      Fault{"twice", {"solve 4", "/id: expected 4, found 3"}},
      Fault{"not-json", {"solve 3", "not JSON"}},
      Fault{"matrix-missing", {"solve ", "/C: is missing, but the contact collides"}},
      Fault{"hex-wrong-id", {"solve 3", "/id: expected 3, found 4", "request: 3 0000000000000000 "}},
      Fault{"leave-group", {"solve 3", no_line}, true},
      Fault{"wide", {"solve 3", "/skipped: expected a string"}},
      Fault{"deep", {"solve 3", "nested levels"}},
      Fault{"gigabyte", {"solve 3", "a line of more than 1048576 bytes"}},
      Fault{"close-output", {"solve 3", "closed its standard output"}, true},
      Fault{"grandchild", {"solve 3", no_line}, true},
      Fault{"protocol-2", {"start", "/protocol: expected 1, found 2"}},
      Fault{"hang-after-stop", {"stop", "did not end within 0.7 s after the request to stop"}},
      Fault{"line-after-stop", {"stop", "more lines than there were requests: goodbye"}},
      Fault{"status-3", {"stop", "ended with status 3"}}};
  return faults;
}

bool is_there(pid_t process) { return kill(process, 0) == 0 || errno != ESRCH; }

/// The misbehaving programs that have `word` on their command line.
std::vector<pid_t> processes_with(const std::string& word) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) {
      continue;
    }
    const std::string command = content_of(entry.path() / "cmdline");
    if (command.starts_with(CAROM_MISBEHAVING) && command.find(word) != std::string::npos) {
      found.push_back(std::stoi(name));
    }
  }
  return found;
}

std::string name_of(const Fault& fault) {
  std::string name = fault.fault;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// For a subject that hangs, the gate waits ten times or more until the timeout. So the gates on all such subjects run
/// at the same time.
class Faults : public testing::TestWithParam<Fault> {
 protected:
  static void SetUpTestSuite() {
    for (const Fault& fault : all_faults()) {
      if (fault.hangs && unit::is_selected(name_of(fault))) {
        waiting[fault.fault] = std::async(std::launch::async, gate_on, fault.fault);
      }
    }
  }

  static std::string mark_of(const std::string& fault) { return fault + "-of-" + std::to_string(getpid()); }

  static Gate gate_on(const std::string& fault) {
    return Gate({misbehaving(fault, mark_of(fault)), "frictionless-double"});
  }

  static Gate result(const std::string& fault) {
    const auto found = waiting.find(fault);
    return found == waiting.end() ? gate_on(fault) : found->second.get();
  }

 private:
  static inline std::map<std::string, std::future<Gate>> waiting;
};

/// The report names the request and the reason. The second subject, which is sound, is judged to the end. If the faulty
/// program fails at the start, the gate does not judge it. If it fails on a collision, it violates the invariant
/// `finite`.
TEST_P(Faults, NameRequestAndReasonAndLeaveNoProcessBehind) {
  const Gate gate = result(GetParam().fault);
  const std::string request = GetParam().says.front();
  const json& faulty = gate.subject(0);
  EXPECT_EQ(gate.run.exit_status, request == "start" ? 2 : 1) << gate.run.errors;
  const bool is_of_a_collision = request.starts_with("solve");
  EXPECT_EQ(faulty.at("status"), is_of_a_collision ? "violated" : "error");
  if (is_of_a_collision) {
    EXPECT_EQ(faulty.at("diagnosis").at("telling"), "finite");
    EXPECT_GT(faulty.at("families").at(0).at("invariants").at("finite").at("violated"), 1) << "it is started again";
  }
  if (request == "stop") {
    EXPECT_EQ(faulty.at("cases"), 120) << "no verdict is lost";
    EXPECT_GT(faulty.at("families").at(0).at("invariants").at("restitution").at("holds"), 0);
  }
  if (GetParam().fault == "signal") {
    // After each start, the program answers two collisions before it fails. The gate keeps both answers.
    const json& finite = faulty.at("families").at(0).at("invariants").at("finite");
    EXPECT_GE(finite.at("holds"), 2 * finite.at("violated").get<int>());
    EXPECT_LT(faulty.at("cases"), 120) << "a subject that fails and fails is judged no further";
  }
  const std::string error = faulty.at("error");
  for (const std::string& part : GetParam().says) {
    EXPECT_NE(error.find(part), std::string::npos) << "'" << part << "' is not in: " << error;
  }
  unit::expect_in(gate.run.output, {request});
  EXPECT_EQ(gate.subject(1).at("status"), "sound");
  EXPECT_EQ(gate.subject(1).at("cases"), 120);
  EXPECT_TRUE(processes_with(mark_of(GetParam().fault)).empty()) << "the group of the program is ended";
}

INSTANTIATE_TEST_SUITE_P(Each, Faults, testing::ValuesIn(all_faults()),
                         [](const auto& each) { return name_of(each.param); });

TEST(Faults, WithoutOneTheSameProgramIsSound) {
  const Gate gate({misbehaving("none"), misbehaving("hex", "in-hex")});
  EXPECT_EQ(gate.run.exit_status, 0) << gate.run.output;
  EXPECT_EQ(gate.subject(0).at("status"), "sound");
  EXPECT_EQ(gate.subject(1).at("status"), "sound");
}

/// A crash has a witness, which the gate shrinks, and which replays.
TEST(Faults, ACrashIsFoundShrunkAndReplayed) {
  const TemporaryDirectory out;
  const RunResult run = run_carom({"gate", misbehaving("crash-where-bouncy"), "--families", "generic", "--cases", "40",
                                   "--jobs", "1", "--relations-every", "1000", "--out", out.path().string()});
  EXPECT_EQ(run.exit_status, 1) << run.errors;
  const json subject = json::parse(content_of(out.path() / "report.json")).at("subjects").at(0);
  EXPECT_EQ(subject.at("status"), "violated");
  EXPECT_EQ(subject.at("error"), "");
  EXPECT_EQ(subject.at("cases"), 40);
  const json& finite = subject.at("families").at(0).at("invariants").at("finite");
  EXPECT_GT(finite.at("violated"), 0);
  EXPECT_EQ(finite.at("violated").get<int>() + finite.at("holds").get<int>(), 40);
  unit::expect_in(run.output, {"signal 6", "assertion failed: restitution <= 0.7"});

  const std::string file = (out.path() / "witnesses" / "faulty.finite.json").string();
  const json witness = json::parse(content_of(file));
  EXPECT_GT(witness.at("collision").at("restitution"), 0.7);
  EXPECT_EQ(witness.at("collision").at("a").at("velocity"), json({0.0, 0.0, 0.0})) << "what has no part in it is gone";
  unit::expect_in(witness.at("outcome").at("failed").get<std::string>(), {"signal 6"});
  const RunResult replayed = run_carom({"replay", file, "--subject", misbehaving("crash-where-bouncy")});
  EXPECT_EQ(replayed.exit_status, 1) << replayed.errors;
  unit::expect_in(replayed.output, {"VIOLATED  no answer: the subject was ended by signal 6"});
  EXPECT_EQ(run_carom({"replay", file, "--subject", misbehaving("none")}).exit_status, 0);
}

TEST(Faults, NamesThatAreTakenAndNamesThatShareAFileNameAreNumbered) {
  const TemporaryDirectory out;
  const RunResult run = run_carom({"gate", misbehaving("nan-as-text", "'x y'"), misbehaving("nan-as-text", "x_y"),
                                   misbehaving("none", "reflection-adjugate-float"), "reflection-adjugate-float",
                                   "--families", "mass_scale", "--deviates", few_families_judge_no, "--cases", "100",
                                   "--jobs", "1", "--timeout", "60", "--out", out.path().string()});
  EXPECT_EQ(run.exit_status, 1) << "the built-in was named, and fails";
  const json report = json::parse(content_of(out.path() / "report.json"));
  EXPECT_EQ(report.at("subjects").at(2).at("name"), "reflection-adjugate-float #2");
  EXPECT_EQ(report.at("subjects").at(3).at("name"), "reflection-adjugate-float");
  EXPECT_TRUE(std::filesystem::exists(out.path() / "witnesses" / "x_y.memoryless.json")) << run.output;
  EXPECT_TRUE(std::filesystem::exists(out.path() / "witnesses" / "x_y__2.memoryless.json")) << run.output;
}

/// The protocol can express NaN. So NaN is a wrong outcome and does not violate the protocol. If only the matrix is not
/// finite, only the invariants about the matrix are violated.
TEST(Faults, NumbersThatAreNotFiniteAreAViolation) {
  const Gate gate({misbehaving("nan-as-text"), misbehaving("matrix-nan"), misbehaving("matrix", "sound")});
  EXPECT_EQ(gate.run.exit_status, 1);
  EXPECT_EQ(gate.subject(0).at("violations").at(0).at("invariant"), "finite");
  std::vector<std::string> violated;
  for (const json& violation : gate.subject(1).at("violations")) {
    violated.push_back(violation.at("invariant"));
  }
  EXPECT_EQ(violated, (std::vector<std::string>{"definite", "matrix_used"}));
  EXPECT_EQ(gate.subject(2).at("status"), "sound");
  EXPECT_GT(gate.subject(2).at("families").at(0).at("invariants").at("definite").at("holds"), 0);
}

TEST(Faults, AFloodOfErrorsIsCutAndDoesNoHarm) {
  const Gate gate({misbehaving("flood-of-errors")}, "30");  // a flood is slow under ThreadSanitizer
  EXPECT_EQ(gate.run.exit_status, 0) << gate.run.output.substr(0, 2000);
}

/// Largest resident set of any child [bytes].
long largest_child() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_maxrss * 1024;
}

[[noreturn]] void take_memory() {
  const Gate sound({misbehaving("none")});
  const long usual = largest_child();
  for (const char* fault : {"gigabyte", "flood-of-errors", "deep"}) {
    const Gate gate({misbehaving(fault)});
  }
#ifndef __SANITIZE_ADDRESS__
  // The program writes a GiB. The gate keeps a line, its copy, its JSON, and 64 KiB of standard error: tens of MiB.
  constexpr long most = 64L << 20U;
  EXPECT_LE(largest_child(), usual + most);
#else
  (void)usual;
#endif
  std::exit(testing::Test::HasFailure() ? 1 : 0);
}

/// Runs in a separate process, so that children of other tests do not count.
TEST(Faults, TakeNoMoreMemoryThanTheirBounds) { EXPECT_EXIT(take_memory(), testing::ExitedWithCode(0), ""); }

TEST(Faults, AProgramThatCannotBeRunIsAnError) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("text", "no program");
  for (const auto& [words, says] : std::vector<std::array<std::string, 2>>{
           {"exec:/no/such/program", "cannot be run: No such file or directory; check the path"},
           {"exec:no-such-program-on-path", "was not found on PATH; check the name"},
           {"exec:" + file, "cannot be run: Permission denied"},
           {"exec:" + directory.path().string(), "cannot be run: Permission denied"},
           {"exec:'unclosed", "a quote is not closed; add '"},
           {"exec:", "no program is given after exec:"}}) {
    const Gate gate({words, "frictionless-double"});
    EXPECT_EQ(gate.run.exit_status, 2);
    EXPECT_EQ(gate.subject(0).at("status"), "error");
    unit::expect_in(gate.subject(0).at("error").get<std::string>(), {says});
    EXPECT_EQ(gate.subject(1).at("status"), "sound");
  }
}

class Interrupted : public testing::TestWithParam<int> {};

TEST_P(Interrupted, GateReportsAndLeavesNoProcessBehind) {
  const TemporaryDirectory directory;
  const std::string mark = "mark-of-" + std::to_string(getpid());
  const pid_t gate = start_carom({"gate", "frictionless-double", misbehaving("none", mark), "--cases", "1000000",
                                  "--families", "generic", "--out", directory.path().string()});
  for (int tries = 0; tries < 500 && processes_with(mark).size() < 2; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  ASSERT_FALSE(processes_with(mark).empty());
  kill(gate, GetParam());
  EXPECT_EQ(wait_for(gate), GetParam() == SIGKILL ? -1 : 2);
  for (int tries = 0; tries < 100 && !processes_with(mark).empty(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(processes_with(mark).empty());
  EXPECT_FALSE(is_there(gate));
  if (GetParam() != SIGKILL) {
    const json report = json::parse(content_of(directory.path() / "report.json"));
    EXPECT_EQ(report.at("interrupted"), true);
    EXPECT_EQ(report.at("exit_status"), 2);
    for (const json& subject : report.at("subjects")) {
      EXPECT_GT(subject.at("cases"), 0);
      EXPECT_NE(subject.at("status"), "error");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(By, Interrupted, testing::Values(SIGTERM, SIGKILL),
                         [](const auto& each) { return "signal_" + std::to_string(each.param); });

TEST(Replay, StartsAProgramOnceForEachSpelling) {
  const TemporaryDirectory directory;
  const json collision = json::parse(content_of(std::string(CAROM_SOURCE_DIR) + "/docs/examples/head_on.json"));
  const std::string collisions = directory.write("two.json", json::array({collision, collision}).dump());
  const std::string starts = (directory.path() / "starts").string();
  const RunResult run = run_carom({"replay", collisions, "--subject",
                                   "exec:sh -c 'echo started >> \"$1\"; shift; exec \"$@\"' sh '" + starts + "' " +
                                       CAROM_MISBEHAVING + " none faulty"});
  EXPECT_EQ(run.exit_status, 0) << run.output << run.errors;
  EXPECT_EQ(content_of(starts), "started\nstarted\nstarted\nstarted\n");
}

TEST(Replay, EndsOnCtrlC) {
  const std::string mark = "mark-of-" + std::to_string(getpid());
  const pid_t replay = start_carom({"replay", "--family", "head_on", "--case", "0", "--subject",
                                    misbehaving("hang-at-start", mark), "--timeout", "1000"});
  for (int tries = 0; tries < 500 && processes_with(mark).empty(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  kill(replay, SIGINT);
  EXPECT_EQ(wait_for(replay), 2);
  EXPECT_TRUE(processes_with(mark).empty());
}

/// Expects that the gate finds a violation and that its first witness replays. Returns the output of the replay.
std::string replayed_violation(const std::string& subject, const std::vector<std::string>& options) {
  const TemporaryDirectory out;
  const RunResult run = run_carom({"gate", subject, "--jobs", "1", "--out", out.path().string()}, options);
  EXPECT_EQ(run.exit_status, 1) << run.output << run.errors;
  const json found = json::parse(content_of(out.path() / "report.json")).at("subjects").at(0);
  EXPECT_EQ(found.at("status"), "violated");
  const std::string witness = (out.path() / found.at("violations").at(0).at("witness").get<std::string>()).string();
  const RunResult replayed = run_carom({"replay", witness, "--subject", subject, "--format", "json"});
  EXPECT_EQ(replayed.exit_status, 1) << replayed.output << replayed.errors;
  return replayed.output;
}

/// A program that misreads a permitted spelling (way to write a collision).
class Misreading : public testing::TestWithParam<const char*> {};

TEST_P(Misreading, IsAViolationWhoseWitnessReplays) {
  (void)replayed_violation(misbehaving(GetParam()), {"--families", "generic,immovable_b,structured", "--cases", "6"});
}

INSTANTIATE_TEST_SUITE_P(Each, Misreading,
                         testing::Values("exponent-dropped", "capital-exponent-dropped", "integer-by-ten",
                                         "left-out-is-immovable", "written-is-immovable", "left-out-orientation",
                                         "left-out-friction", "first-is-a", "no-tabs"),
                         [](const auto& test) {
                           return name_of({test.param, {}});
                         });

/// Hexadecimal numbers have one spelling, so a replay does not count spellings.
TEST(WrongInHex, HasAWitnessThatReplays) {
  const std::string replayed =
      replayed_violation(std::string("exec:") + CAROM_WELL_BEHAVED + " reflection-adjugate-float hex",
                         {"--families", "mass_scale", "--cases", "100", "--relations-every", "1"});
  EXPECT_EQ(replayed.find("spellings"), std::string::npos) << replayed;
  unit::expect_in(replayed, {"memoryless"});
}

}  // namespace
}  // namespace carom::tests
