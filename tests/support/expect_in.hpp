// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace carom::unit {

/// Expects each part somewhere in the text.
inline void expect_in(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "expected: " << part << "\nin: " << text;
  }
}

}  // namespace carom::unit
