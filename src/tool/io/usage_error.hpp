// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>

namespace carom::tool {

/// A request of the user that cannot be fulfilled, and why. It ends the program with exit_usage.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace carom::tool
