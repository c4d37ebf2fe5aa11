// SPDX-License-Identifier: BSL-1.0
#include "io/interrupt.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stop_token>
#include <system_error>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <carom/subjects/protocol/shortage.hpp>

namespace carom::tool {
namespace {

using namespace std::chrono_literals;

bool is_requested_soon(const std::stop_token& stop) {
  for (int tries = 0; tries < 500 && !stop.stop_requested(); ++tries) {
    std::this_thread::sleep_for(10ms);
  }
  return stop.stop_requested();
}

/// Sends the signals that `timeout` sends: one to the program, one to its group (here the program again), and at last
/// SIGCONT.
[[noreturn]] void be_signalled_at_once() {
  const std::stop_token stop = stop_on_interrupt();
  kill(getpid(), SIGTERM);
  kill(getpid(), SIGINT);
  const bool requested = is_requested_soon(stop);
  kill(getpid(), SIGTERM);
  kill(getpid(), SIGCONT);
  std::this_thread::sleep_for(100ms);
  std::_Exit(requested ? 0 : 3);
}

[[noreturn]] void be_signalled_for_long() {
  const std::stop_token stop = stop_on_interrupt();
  for (int tries = 0; tries < 100; ++tries) {
    kill(getpid(), SIGTERM);
    std::this_thread::sleep_for(300ms);
  }
  std::_Exit(3);
}

/// As under nohup, which leaves SIGHUP ignored, or in the background of a script, where SIGINT is ignored.
[[noreturn]] void be_signalled_where_that_is_ignored(int signal) {
  std::signal(signal, SIG_IGN);
  const std::stop_token stop = stop_on_interrupt();
  kill(getpid(), signal);
  std::this_thread::sleep_for(100ms);
  const bool is_ignored = !stop.stop_requested();
  kill(getpid(), SIGTERM);
  std::_Exit(is_ignored && is_requested_soon(stop) ? 0 : 3);
}

/// As a user of whom no other thread may be started. The limit does not bind root.
[[noreturn]] void start_where_no_thread_may() {
  constexpr uid_t nobody = 65534;
  const rlimit one{1, 1};
  if (setrlimit(RLIMIT_NPROC, &one) != 0 || (geteuid() == 0 && setuid(nobody) != 0)) {
    std::_Exit(4);
  }
  try {
    (void)stop_on_interrupt();
  } catch (const std::system_error& error) {
    std::cerr << subjects::protocol::shortage(error.code());
    std::_Exit(0);
  }
  std::_Exit(3);
}

/// Sends SIGXCPU again and again, as the system does, for longer than all signals are one wish.
[[noreturn]] void use_up_processor_time() {
  const std::stop_token stop = stop_on_interrupt();
  for (const auto until = std::chrono::steady_clock::now() + 1500ms; std::chrono::steady_clock::now() < until;) {
    kill(getpid(), SIGXCPU);
    std::this_thread::sleep_for(20ms);
  }
  std::_Exit(stop.stop_requested() ? 0 : 3);
}

class InterruptDeathTest : public testing::Test {
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(InterruptDeathTest, TheLimitOnProcessorTimeRequestsOneStop) {
  EXPECT_EXIT(use_up_processor_time(), testing::ExitedWithCode(0), "");
}

TEST_F(InterruptDeathTest, ASignalThatTheParentLeftIgnoredIsIgnored) {
  for (const int signal : {SIGHUP, SIGINT}) {
    EXPECT_EXIT(be_signalled_where_that_is_ignored(signal), testing::ExitedWithCode(0), "") << signal;
  }
}

TEST_F(InterruptDeathTest, AShortageOfThreadsIsNamedWithItsLimit) {
  EXPECT_EXIT(start_where_no_thread_may(), testing::ExitedWithCode(0),
              "processes and threads are short: this user may have at most 1 \\(ulimit -u\\)");
}

TEST_F(InterruptDeathTest, SignalsWithinASecondRequestOneStopAndALaterOneEndsTheProgram) {
  EXPECT_EXIT(be_signalled_at_once(), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(be_signalled_for_long(), testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace carom::tool
