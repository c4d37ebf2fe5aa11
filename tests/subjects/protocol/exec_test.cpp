// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <carom/collision/doubles.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/gate.hpp>
#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/child.hpp>
#include <carom/subjects/protocol/command_line.hpp>
#include <carom/subjects/protocol/exec.hpp>
#include <carom/subjects/protocol/spelling.hpp>

#include "io/threads.hpp"
#include "support/changed_subject.hpp"
#include "support/expect_in.hpp"
#include "support/message_of.hpp"
#include "support/program.hpp"

namespace carom::subjects::protocol {
namespace {

properties::GateReport gate_of(const std::vector<Subject>& subjects, unsigned jobs) {
  properties::GateOptions options = unit::gate_options(60);
  options.workers = tool::threads(jobs);
  options.relations_every = 1;
  return properties::run_gate(subjects, options);
}

void expect_the_same(const properties::SubjectResult& in_process, const properties::SubjectResult& over_the_line) {
  ASSERT_EQ(over_the_line.error, "");
  ASSERT_EQ(in_process.families.size(), over_the_line.families.size());
  for (std::size_t f = 0; f < in_process.families.size(); ++f) {
    const properties::FamilyResult& here = in_process.families[f];
    const properties::FamilyResult& there = over_the_line.families[f];
    EXPECT_EQ(here.cases, there.cases);
    EXPECT_EQ(here.worst_backward_error, there.worst_backward_error);
    ASSERT_EQ(here.counts.size(), there.counts.size());
    for (const auto& [invariant, count] : here.counts) {
      const properties::Count& other = there.counts.at(invariant);
      EXPECT_EQ(std::tie(count.holds, count.violated, count.skipped),
                std::tie(other.holds, other.violated, other.skipped))
          << invariant->name;
    }
  }
  ASSERT_EQ(in_process.witnesses.size(), over_the_line.witnesses.size());
  for (std::size_t w = 0; w < in_process.witnesses.size(); ++w) {
    const properties::Witness& here = in_process.witnesses[w];
    const properties::Witness& there = over_the_line.witnesses[w];
    EXPECT_EQ(here.invariant, there.invariant);
    EXPECT_EQ(doubles_of(here.shrunk.collision), doubles_of(there.shrunk.collision));
  }
}

/// Each subject with the forms of its numbers. Two subjects are wrong.
TEST(Exec, ChangesNoVerdictAndNoWitness) {
  int wrong = 0;
  for (const auto& [name, forms] :
       std::map<std::string, std::vector<std::string>>{{"frictionless-double", {"", " hex"}},
                                                       {"reflection-float", {""}},
                                                       {"reflection-llt-long-double", {""}},
                                                       {"sticking-world-double", {"", " hex"}},
                                                       {"reflection-adjugate-float", {"", " hex"}}}) {
    SCOPED_TRACE(name);
    const Subject here = *subject_named(name);
    std::vector<Subject> subjects{here};
    for (const std::string& numbers : forms) {
      const Subject there = exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED + ' ' + name + numbers, {});
      EXPECT_EQ(there.spellings, numbers.empty() ? spelling_count : 1);
      EXPECT_EQ(there.name, here.name);
      EXPECT_EQ(there.law, here.law);
      EXPECT_EQ(there.precision, here.precision);
      EXPECT_EQ(there.shows_collision_matrix, here.shows_collision_matrix);
      subjects.push_back(there);
    }
    const properties::GateReport report = gate_of(subjects, 2);
    EXPECT_EQ(report.results[0].witnesses.empty(), report.results[0].is_sound());
    wrong += report.results[0].is_sound() ? 0 : 1;
    for (std::size_t i = 1; i < subjects.size(); ++i) {
      SCOPED_TRACE(forms[i - 1]);
      expect_the_same(report.results[0], report.results[i]);
    }
  }
  EXPECT_EQ(wrong, 2);
}

/// For programs, each relation is judged on every fourth case.
TEST(Exec, IsAskedAboutRelatedCollisionsOnEveryFourthCase) {
  const Subject subject = exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED, {});
  const properties::GateReport report =
      properties::run_gate({subject, *subject_named("frictionless-double")}, unit::gate_options(80, {"generic"}));
  EXPECT_EQ(report.results[0].count(*properties::invariant_named("swap")).holds, 20U);
  EXPECT_EQ(report.results[0].count(*properties::invariant_named("rotation")).holds, 20U);
  EXPECT_EQ(report.results[0].count(*properties::invariant_named("backward_error")).holds, 80U);
  EXPECT_EQ(report.results[1].count(*properties::invariant_named("swap")).holds, 80U);
}

TEST(Exec, AnswersManyAtOnceAndNone) {
  for (const char* numbers : {"", " hex"}) {
    const Subject subject =
        exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED + " frictionless-double" + numbers, {});
    Session session = subject.open();
    EXPECT_TRUE(session({}).empty());
    // 5000 collisions exceed the buffers of the pipes.
    const std::vector<Collision> many(5000);
    EXPECT_EQ(session(many).size(), many.size());
    EXPECT_EQ(session(std::span(many).first(1)).size(), 1U);
    session.close();
  }
}

/// An extended number does not fit into 16 digits.
TEST(Exec, RefusesHexadecimalNumbersOfExtendedPrecision) {
  const Subject subject = exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED + " frictionless-long-double hex", {});
  unit::expect_in(unit::message_of<std::exception>(subject.open), {"/numbers: hex has the bits of binary64"});
}

using Words = std::vector<std::string>;

TEST(Words, AreSplitAndUnquotedAsAShellDoes) {
  EXPECT_EQ(split_words(""), Words{});
  EXPECT_EQ(split_words("  \t\n "), Words{});
  EXPECT_EQ(split_words("python3 solver.py"), (Words{"python3", "solver.py"}));
  EXPECT_EQ(split_words(" a  b\tc "), (Words{"a", "b", "c"}));
  EXPECT_EQ(split_words("'a b' \"c d\""), (Words{"a b", "c d"}));
  EXPECT_EQ(split_words("a'b'\"c\"d"), (Words{"abcd"}));
  EXPECT_EQ(split_words("'' \"\""), (Words{"", ""}));
  EXPECT_EQ(split_words(R"(a\ b \'c \\)"), (Words{"a b", "'c", R"(\)"}));
  EXPECT_EQ(split_words(R"("\"\\\$\`\n")"), (Words{R"("\$`\n)"}));
  EXPECT_EQ(split_words(R"('\n')"), (Words{R"(\n)"}));
  EXPECT_EQ(split_words("a\\\nb"), (Words{"ab"}));
}

TEST(Words, KeepWhatOnlyAShellWouldCarryOut) {
  EXPECT_EQ(split_words("a; rm -r $HOME | b > c & `d` $(e) *?[f] #g ~"),
            (Words{"a;", "rm", "-r", "$HOME", "|", "b", ">", "c", "&", "`d`", "$(e)", "*?[f]", "#g", "~"}));
}

TEST(Words, RefuseAQuotationThatIsNotClosed) {
  for (const char* text : {"'a", "\"a", "a\\", "\"a\\\""}) {
    EXPECT_THROW((void)split_words(text), std::invalid_argument) << text;
  }
}

TEST(Words, AreReadBackAsTheyWereQuoted) {
  for (const char* word : {"", "plain", "two words", "it's", "'", "\\", "\"$HOME\"", "a\nb", "ü"}) {
    EXPECT_EQ(split_words(quoted(word)), Words{word});
  }
}

/// Whether the system knows the process, which may have ended and not been waited for.
bool is_known(pid_t process) { return kill(process, 0) == 0 || errno != ESRCH; }

/// The process id that the program prints first.
pid_t first_line_of(ChildProcess& program) {
  pid_t number = 0;
  program.exchange("", 1, [&](std::string_view line) { number = std::stoi(std::string(line)); });
  return number;
}

/// Until its group is killed, an ended program stays a zombie. Otherwise the system could give its number to a foreign
/// process or group, which would be killed in its place.
TEST(Child, KeepsTheNumberOfAnEndedProgramUntilItsGroupIsKilled) {
  pid_t leader = 0;
  {
    ChildProcess program({"sh", "-c", "echo $$"}, {}, {});
    leader = first_line_of(program);
    EXPECT_THROW(program.exchange("", 1, [](std::string_view) {}), ChildError) << "it has ended";
    EXPECT_TRUE(is_known(leader));
  }
  EXPECT_FALSE(is_known(leader));
  {
    ChildProcess program({"sh", "-c", "echo $$"}, {}, {});
    leader = first_line_of(program);
    program.finish("");
    EXPECT_TRUE(is_known(leader));
  }
  EXPECT_FALSE(is_known(leader));
}

/// The member of the group outlives its leader, and is killed with the group.
TEST(Child, EndsTheGroupOfAnEndedProgram) {
  pid_t member = 0;
  {
    ChildProcess program({"sh", "-c", "sleep 1000 > /dev/null 2>&1 & echo $!"}, {}, {});
    member = first_line_of(program);
    program.finish("");
    EXPECT_TRUE(is_known(member));
  }
  // A killed process has no command line, even if nobody has waited for it.
  const std::string command = "/proc/" + std::to_string(member) + "/cmdline";
  for (int tries = 0; tries < 1000 && !tests::content_of(command).empty(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(tests::content_of(command), "");
}

/// A host that waits for any child takes the status, and perhaps the number is another process's already.
TEST(Child, OfWhichTheHostTookTheStatusIsNotKilled) {
  ChildProcess program({"sh", "-c", "echo $$"}, {}, {});
  const pid_t leader = first_line_of(program);
  ASSERT_EQ(waitpid(leader, nullptr, 0), leader);
  EXPECT_EQ(unit::message_of<ChildError>([&] { program.exchange("", 1, [](std::string_view) {}); }),
            "ended, and another part of this process took its status");
}

/// The program has closed its standard input when the text is written.
[[noreturn]] void write_to_a_closed_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  bool has_failed = false;
  try {
    ChildLimits limits;
    limits.timeout = std::chrono::milliseconds(50);
    ChildProcess program({"sh", "-c", "exec 0<&-; echo closed; sleep 1000"}, limits, {});
    program.exchange("", 1, [](std::string_view) {});
    program.finish(std::string(1 << 20, 'x'));
  } catch (const ChildError&) {
    has_failed = true;  // it did not end in time
  }
  struct sigaction now {};
  sigaction(SIGPIPE, nullptr, &now);
  sigset_t blocked;
  pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  sigset_t pending;
  sigpending(&pending);
  const bool as_before = now.sa_handler == SIG_DFL && sigismember(&blocked, SIGPIPE) == 0;
  std::_Exit(has_failed && as_before && sigismember(&pending, SIGPIPE) == 0 ? 0 : 3);
}

TEST(ChildDeathTest, LeavesTheHostItsHandlingOfBrokenPipes) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(write_to_a_closed_pipe(), testing::ExitedWithCode(0), "");
}

TEST(Child, WithoutAFileToOpenSaysSo) {
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  rlimit few = before;
  few.rlim_cur = 8;
  setrlimit(RLIMIT_NOFILE, &few);
  const std::string what = unit::message_of<ChildError>([] { const ChildProcess program({"true"}, {}, {}); });
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_EQ(what, "'true' cannot be run: Too many open files (files are short: at most 8 may be open (ulimit -n))");
}

TEST(Exec, AnswersNoCollisionsAfterAStop) {
  std::stop_source stop;
  const Subject subject =
      exec_subject(std::string("exec:") + CAROM_WELL_BEHAVED + " frictionless-double", {{}, stop.get_token()});
  Session session = subject.open();
  stop.request_stop();
  EXPECT_TRUE(session(std::span<const Collision>()).empty());
}

}  // namespace
}  // namespace carom::subjects::protocol
