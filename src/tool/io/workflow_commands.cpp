// SPDX-License-Identifier: BSL-1.0
#include "io/workflow_commands.hpp"

#include <cstdio>
#include <random>

#include <fmt/format.h>

namespace carom::tool {

WorkflowCommandsStopped::WorkflowCommandsStopped() {
  std::random_device random;
  for (int word = 0; word < 4; ++word) {
    token_ += fmt::format("{:08x}", random());
  }
  std::fputs(("::stop-commands::" + token_ + '\n').c_str(), stdout);
  std::fflush(stdout);
}

WorkflowCommandsStopped::~WorkflowCommandsStopped() {
  std::fputs(("\n::" + token_ + "::\n").c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace carom::tool
