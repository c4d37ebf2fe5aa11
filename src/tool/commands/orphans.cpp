// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/orphans.hpp"

#ifdef __linux__
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace carom::tool {
#ifdef __linux__
namespace {

using Clock = std::chrono::steady_clock;

/// The parent in /proc/PID/stat: "PID (NAME) STATE PARENT …", and a name may hold anything; 0 where it ended meanwhile.
pid_t parent_of(const std::filesystem::path& process) {
  std::ifstream file(process / "stat");
  std::string text;
  std::getline(file, text, '\0');
  const std::size_t name_end = text.rfind(')');
  constexpr std::size_t to_parent = 4;  // ") S "
  return name_end == std::string::npos ? 0 : std::atoi(text.c_str() + std::min(name_end + to_parent, text.size()));
}

void kill_children() {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    const pid_t process = std::atoi(entry.path().filename().c_str());
    if (process > 0 && parent_of(entry.path()) == getpid()) {
      kill(process, SIGKILL);
    }
  }
}

}  // namespace

Orphanage::Orphanage() { prctl(PR_SET_CHILD_SUBREAPER, 1); }

Orphanage::~Orphanage() {
  // Their own children are handed over as they end; a process that the system cannot end now is not waited for.
  constexpr std::chrono::seconds patience{2};
  constexpr std::chrono::milliseconds moment{1};
  for (const auto until = Clock::now() + patience; Clock::now() < until; std::this_thread::sleep_for(moment)) {
    pid_t ended = 0;
    do {
      ended = waitpid(-1, nullptr, WNOHANG);
    } while (ended > 0);
    if (ended < 0) {
      return;  // there is none
    }
    kill_children();
  }
}
#else
Orphanage::Orphanage() = default;
Orphanage::~Orphanage() = default;
#endif

}  // namespace carom::tool
