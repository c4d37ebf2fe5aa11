// SPDX-License-Identifier: BSL-1.0
#include "io/interrupt.hpp"

#include <chrono>
#include <csignal>
#include <ctime>
#include <thread>

#include <unistd.h>

namespace carom::tool {
namespace {

/// `timeout` and terminals signal both the program and its group. Signals within this time are one request.
constexpr std::chrono::seconds one_wish{1};

void drop_repeats(const sigset_t& signals) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + one_wish;
  for (auto now = Clock::now(); now < until; now = Clock::now()) {
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(until - now).count();
    constexpr long second = 1'000'000'000;
    const timespec patience{left / second, left % second};
    sigtimedwait(&signals, nullptr, &patience);
  }
}

/// The signals that ask for a stop. A signal that the parent left ignored, as nohup leaves SIGHUP, is none of them.
sigset_t awaited_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    struct sigaction inherited {};
    if (sigaction(signal, nullptr, &inherited) == 0 && inherited.sa_handler != SIG_IGN) {
      sigaddset(&signals, signal);
    }
  }
  return signals;
}

}  // namespace

std::stop_token stop_on_interrupt() {
  static std::stop_source source;
  static bool is_waiting = false;
  if (is_waiting) {
    return source.get_token();
  }
  is_waiting = true;
  const sigset_t signals = awaited_signals();
  // All later threads block the signals. One thread waits for the signals, so no code runs in a handler.
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    int signal = 0;
    if (sigwait(&signals, &signal) == 0) {
      source.request_stop();
    }
    drop_repeats(signals);
    // This thread receives the next signal, whose default action ends the program. SIGXCPU stays blocked, because the
    // system repeats it each second until the hard limit ends the program.
    sigset_t ending = signals;
    sigdelset(&ending, SIGXCPU);
    pthread_sigmask(SIG_UNBLOCK, &ending, nullptr);
    for (;;) {
      pause();
    }
  }).detach();
  return source.get_token();
}

}  // namespace carom::tool
