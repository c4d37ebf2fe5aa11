// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::tool {

/// While it exists, this process becomes the parent of processes that the subjects' programs started and left behind,
/// in any group or session. The destructor ends the processes that the subjects' programs started, and waits for them.
/// This is so on Linux; elsewhere the class does nothing.
///
/// A process may have children before its program begins: the background jobs of a shell that did `exec carom`. These,
/// and the processes that they leave behind, are not ended. If there are no such children, every child at the end was
/// started by a subject. Otherwise, only processes with the mark of the subjects' programs (subjects/protocol/mark.hpp)
/// are ended. A process that hides the mark and has left its group lives on.
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
