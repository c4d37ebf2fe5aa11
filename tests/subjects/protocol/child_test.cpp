// SPDX-License-Identifier: BSL-1.0
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/child.hpp>
#include <carom/subjects/protocol/exec.hpp>

#include "support/program.hpp"

namespace carom::subjects::protocol {
namespace {

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
  try {
    program.exchange("", 1, [](std::string_view) {});
    ADD_FAILURE();
  } catch (const ChildError& error) {
    EXPECT_STREQ(error.what(), "ended, and another part of this process took its status");
  }
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
  std::string what;
  try {
    const ChildProcess program({"true"}, {}, {});
  } catch (const ChildError& error) {
    what = error.what();
  }
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
