// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::tool {

/// While an object exists, this process becomes the parent of processes that the subjects' programs started and left
/// behind, in any group or session. The destructor ends the processes that the subjects' programs started, and waits
/// for them. On systems other than Linux the class does nothing.
///
/// A process may have children before its program begins: the background jobs of a shell that did `exec carom`. The
/// class does not end these jobs, nor processes that they leave behind. If there are no such jobs, a subject started
/// every child at the end. Otherwise, only processes with the mark of the subjects' programs
/// (subjects/protocol/mark.hpp) are ended. A process that hides the mark and has left its group lives on.
class Orphanage {
 public:
  Orphanage();
  /// Precondition: no program that this process started is still in use.
  ~Orphanage();
  Orphanage(const Orphanage&) = delete;
  Orphanage& operator=(const Orphanage&) = delete;

 private:
  [[maybe_unused]] bool has_foreign_children_ = false;
};

}  // namespace carom::tool
