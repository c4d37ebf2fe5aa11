// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace carom::tool {

/// While an object exists, this process becomes the parent of processes that the subjects' programs started and left
/// behind, in any group or session. The destructor ends these processes and waits for them. On systems other than Linux
/// the class does nothing.
///
/// A shell that does `exec carom` leaves its background jobs as children of this process. The class ends neither these
/// jobs nor the processes that they leave behind. If there are such jobs, the class ends only processes with the mark
/// of the subjects' programs (subjects/protocol/mark.hpp). In this case, a process that hides the mark and has left its
/// group lives on.
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
