// SPDX-License-Identifier: BSL-1.0
#include "io/interrupt.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stop_token>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

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

TEST(InterruptDeathTest, SignalsAtOnceAreOneWish) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(be_signalled_at_once(), testing::ExitedWithCode(0), "");
}

TEST(InterruptDeathTest, ALaterSignalEndsTheProgram) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(be_signalled_for_long(), testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace carom::tool
