// SPDX-License-Identifier: GPL-3.0-or-later
#include <carom/properties/conformance/finding.hpp>
#include <carom/properties/conformance/suite.hpp>

namespace carom::conformance {
namespace {

std::string how_to_repeat() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  return std::string("  this test alone: --gtest_filter=") + test.test_suite_name() + '.' + test.name() + '\n';
}

TEST_P(Conformance, Holds) {
  const Statement& statement = GetParam();
  const Finding finding = find(statement);
  if (finding.status == properties::Status::violated) {
    ADD_FAILURE_AT(statement.file, statement.line) << finding.text << how_to_repeat();
  } else if (finding.status == properties::Status::skipped) {
    GTEST_SKIP() << finding.text;
  }
}

}  // namespace
}  // namespace carom::conformance
