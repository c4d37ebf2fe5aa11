// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace carom::bounds {

/// The unit roundoff of binary64.
inline constexpr double u = 0x1p-53;

/// Whether needed ≤ constant ≤ slack · needed, so that the constant is sufficient and not vacuous. Records `constant`
/// and `needed` for --gtest_output=json:FILE.
[[nodiscard]] inline testing::AssertionResult covers(double constant, double needed, double slack) {
  const testing::TestResult& so_far = *testing::UnitTest::GetInstance()->current_test_info()->result();
  std::ostringstream both;
  both << constant << " covers " << needed << " = 2^" << std::log2(std::abs(needed)) << " = " << needed / u << " u";
  testing::Test::RecordProperty("bound_" + std::to_string(so_far.test_property_count()), both.str());
  if (!(constant >= needed)) {
    return testing::AssertionFailure() << constant << " is less than the " << needed << " that are needed";
  }
  if (!(constant <= slack * needed)) {
    return testing::AssertionFailure() << constant << " is more than " << slack << " times the " << needed
                                       << " that are needed";
  }
  return testing::AssertionSuccess();
}

/// Whether `power`, a power of two, is the least one that is at least 2^`needed`.
[[nodiscard]] inline testing::AssertionResult is_least_that_covers(double power, double needed) {
  return covers(std::log2(power), needed, 1 + 1 / std::abs(needed));
}

}  // namespace carom::bounds
