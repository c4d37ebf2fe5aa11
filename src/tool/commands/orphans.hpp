// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace carom::tool {

/// While it lives, a process that this one's programs started and left behind is handed to this one, whatever group or
/// session it is in; at the end all of them are ended, and waited for. On Linux; elsewhere it does nothing.
class Orphanage {
 public:
  Orphanage();
  /// Precondition: no program that this process started itself is in use any more.
  ~Orphanage();
  Orphanage(const Orphanage&) = delete;
  Orphanage& operator=(const Orphanage&) = delete;
};

}  // namespace carom::tool
