// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>

namespace carom::tool {

/// What the user asked for cannot be done; the text says what and why. Ends the program with exit_usage.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace carom::tool
