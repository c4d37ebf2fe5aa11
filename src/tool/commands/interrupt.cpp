// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/interrupt.hpp"

#include <csignal>
#include <thread>

#include <unistd.h>

namespace carom::tool {

std::stop_token stop_on_interrupt() {
  static std::stop_source source;
  static bool is_waiting = false;
  if (is_waiting) {
    return source.get_token();
  }
  is_waiting = true;
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGHUP);
  // Blocked in every thread that is started from here on, and waited for in one: no code runs in a signal handler.
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    int signal = 0;
    if (sigwait(&signals, &signal) == 0) {
      source.request_stop();
    }
    // This thread takes the next one, and the program ends as programs do.
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    for (;;) {
      pause();
    }
  }).detach();
  return source.get_token();
}

}  // namespace carom::tool
