// SPDX-License-Identifier: BSL-1.0
#include "io/orphans.hpp"

#ifdef __linux__
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <carom/subjects/protocol/mark.hpp>
#endif

namespace carom::tool {
#ifdef __linux__
namespace {

using Clock = std::chrono::steady_clock;

struct ProcessState {
  char state = ' ';  // 'Z' if the process has ended and was not yet waited for
  pid_t parent = 0;
};

/// Parses /proc/PID/stat: "PID (NAME) STATE PARENT …". NAME may contain any character. None if the process has ended.
std::optional<ProcessState> state_of(const std::filesystem::path& process) {
  std::ifstream file(process / "stat");
  std::string text;
  std::getline(file, text, '\0');
  const std::size_t name_end = text.rfind(')');
  constexpr std::size_t to_state = 2;   // ") "
  constexpr std::size_t to_parent = 4;  // ") S "
  if (name_end == std::string::npos || name_end + to_parent >= text.size()) {
    return std::nullopt;
  }
  return ProcessState{text[name_end + to_state], std::atoi(text.c_str() + name_end + to_parent)};
}

/// Kills the children of this process, or only those with the mark. Returns whether it killed a child, or found an
/// ended child that was not yet waited for. The caller must call again, because the children of an ended child become
/// children of this process.
bool end_children(bool marked_alone) {
  bool any = false;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    const pid_t process = std::atoi(entry.path().filename().c_str());
    const std::optional<ProcessState> state = process > 0 ? state_of(entry.path()) : std::nullopt;
    if (!state || state->parent != getpid()) {
      continue;
    }
    const bool has_ended = state->state == 'Z';
    const bool is_ours = !marked_alone || subjects::protocol::bears_mark_of_children(process);
    if (!has_ended && is_ours) {
      kill(process, SIGKILL);
    }
    any = any || has_ended || is_ours;
  }
  return any;
}

bool has_children() {
  siginfo_t unused{};
  return waitid(P_ALL, 0, &unused, WEXITED | WNOHANG | WNOWAIT | __WALL) == 0;
}

}  // namespace

Orphanage::Orphanage() : has_foreign_children_(has_children()) { prctl(PR_SET_CHILD_SUBREAPER, 1); }

Orphanage::~Orphanage() {
  // The loop ends after `patience`, because the system may be unable to end a process.
  constexpr std::chrono::seconds patience{2};
  constexpr std::chrono::milliseconds moment{1};
  for (const auto until = Clock::now() + patience; Clock::now() < until; std::this_thread::sleep_for(moment)) {
    pid_t ended = 0;
    do {
      ended = waitpid(-1, nullptr, WNOHANG);
    } while (ended > 0);
    if (ended < 0) {
      return;  // there is no child
    }
    if (!end_children(has_foreign_children_)) {
      return;
    }
  }
}
#else
Orphanage::Orphanage() = default;
Orphanage::~Orphanage() = default;
#endif

}  // namespace carom::tool
