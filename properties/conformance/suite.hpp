// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/conformance/statement.hpp>

namespace carom::conformance {

/// The tests of one statement each; defined in suite.cpp, which every program of tests compiles once.
class Conformance : public testing::TestWithParam<Statement> {};

/// The statements of a suite that stands there. If `make` throws, there is one test, `options`, which
/// fails and says why.
[[nodiscard]] std::vector<Statement> suite(const char* file, int line,
                                           const std::function<std::vector<Statement>()>& make);

[[nodiscard]] inline std::string test_name(const testing::TestParamInfo<Statement>& test) {
  return name_of(test.param);
}

}  // namespace carom::conformance
