// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace carom::tool {

/// GitHub reads workflow commands from everything that a job prints. While an object of this class exists, GitHub reads
/// none.
class WorkflowCommandsStopped {
 public:
  WorkflowCommandsStopped();
  ~WorkflowCommandsStopped();
  WorkflowCommandsStopped(const WorkflowCommandsStopped&) = delete;
  WorkflowCommandsStopped& operator=(const WorkflowCommandsStopped&) = delete;

 private:
  std::string token_;  // lets commands be read again; it is random, so no program can print it
};

}  // namespace carom::tool
