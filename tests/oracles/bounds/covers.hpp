// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

namespace carom::bounds {

/// Whether a constant is at least what the code was found to need, and not so much more that it says nothing: at most
/// `slack` times that.
[[nodiscard]] inline testing::AssertionResult covers(double constant, double needed, double slack) {
  if (!(constant >= needed)) {
    return testing::AssertionFailure() << constant << " is less than the " << needed << " that are needed";
  }
  if (!(constant <= slack * needed)) {
    return testing::AssertionFailure() << constant << " is more than " << slack << " times the " << needed
                                       << " that are needed";
  }
  return testing::AssertionSuccess();
}

/// u of binary64.
inline constexpr double u = 0x1p-53;

}  // namespace carom::bounds
