// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::tool {

/// While it lives, a process that this one's programs started and left behind is handed to this one, whatever group or
/// session it is in; at the end what the subjects' programs started is ended, and waited for. On Linux; elsewhere it
/// does nothing.
///
/// A process may have children before its program begins: the background jobs of a shell that did `exec carom`. They,
/// and what they leave behind meanwhile, are not ended. Where there is none of them, everything that is a child at the
/// end was started by a subject. Where there is one, only what bears the mark of the subjects' programs
/// (subjects/protocol/mark.hpp) is ended: a process that hides it, and has left its group as well, lives on.
class Orphanage {
 public:
  Orphanage();
  /// Precondition: no program that this process started itself is in use any more.
  ~Orphanage();
  Orphanage(const Orphanage&) = delete;
  Orphanage& operator=(const Orphanage&) = delete;

 private:
  [[maybe_unused]] bool has_foreign_children_ = false;
};

}  // namespace carom::tool
