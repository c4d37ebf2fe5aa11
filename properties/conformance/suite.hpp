// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/conformance/statement.hpp>

namespace carom::conformance {

/// The test of one statement. suite.cpp defines the test; every test program compiles suite.cpp once.
class Conformance : public testing::TestWithParam<Statement> {};

/// The statements that `make` returns, for the suite at this place in the source. If `make` throws, the suite has only
/// the test `options`, which fails and gives the reason.
[[nodiscard]] std::vector<Statement> suite(const char* file, int line,
                                           const std::function<std::vector<Statement>()>& make);

[[nodiscard]] inline std::string test_name(const testing::TestParamInfo<Statement>& test) {
  return name_of(test.param);
}

}  // namespace carom::conformance
