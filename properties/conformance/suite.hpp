// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <gtest/gtest.h>

#include <carom/properties/conformance/statement.hpp>

namespace carom::conformance {

/// The tests of one statement each; defined in suite.cpp, which every program of tests compiles once.
class Conformance : public testing::TestWithParam<Statement> {};

[[nodiscard]] inline std::string test_name(const testing::TestParamInfo<Statement>& test) {
  return name_of(test.param);
}

}  // namespace carom::conformance
