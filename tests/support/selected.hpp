// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <gtest/gtest.h>

namespace carom::unit {

/// Whether GoogleTest's filter and shard select a test of the current suite with this parameter's name. SetUpTestSuite
/// calls this function, to compute only the shared results that the selected tests need.
[[nodiscard]] inline bool is_selected(std::string_view parameter) {
  const testing::TestSuite& suite = *testing::UnitTest::GetInstance()->current_test_suite();
  for (int i = 0; i < suite.total_test_count(); ++i) {
    const testing::TestInfo& test = *suite.GetTestInfo(i);
    const std::string_view name = test.name();
    if (test.should_run() && name.substr(name.rfind('/') + 1) == parameter) {
      return true;
    }
  }
  return false;
}

}  // namespace carom::unit
