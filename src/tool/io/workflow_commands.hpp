// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace carom::tool {

/// GitHub reads commands from whatever a job prints, wherever it came from. As long as there is one of these, it reads
/// none: neither standard output nor what a program writes to standard error can give any.
class WorkflowCommandsStopped {
 public:
  WorkflowCommandsStopped();
  ~WorkflowCommandsStopped();
  WorkflowCommandsStopped(const WorkflowCommandsStopped&) = delete;
  WorkflowCommandsStopped& operator=(const WorkflowCommandsStopped&) = delete;

 private:
  std::string token_;  // that lets them be read again: what is printed cannot know it
};

}  // namespace carom::tool
