// SPDX-License-Identifier: BSL-1.0
#include <exception>
#include <string>
#include <utility>

#include <carom/properties/conformance/closing_lines.hpp>
#include <carom/properties/conformance/finding.hpp>
#include <carom/properties/conformance/suite.hpp>

namespace carom::conformance {
namespace {

std::string name_of_this_test() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test.test_suite_name()) + '.' + test.name();
}

TEST_P(Conformance, Holds) {
  const Statement& statement = GetParam();
  if (!statement.error.empty()) {
    ADD_FAILURE_AT(statement.file, statement.line) << statement.error;
    return;
  }
  const Finding finding = find(statement, name_of_this_test());
  if (finding.status == properties::Status::violated) {
    ADD_FAILURE_AT(statement.file, statement.line)
        << finding.text << "  this test alone: --gtest_filter=" << name_of_this_test();
  } else if (finding.status == properties::Status::skipped) {
    GTEST_SKIP() << finding.text;
  }
}

[[maybe_unused]] const testing::Environment* const closing_lines =
    testing::AddGlobalTestEnvironment(new ClosingLinesInPlace);

}  // namespace

std::vector<Statement> suite(const char* file, int line, const std::function<std::vector<Statement>()>& make) {
  std::vector<Statement> all;
  try {
    all = make();
  } catch (const std::exception& error) {
    all = {Statement{nullptr, nullptr, nullptr, {}, file, line, error.what()}};
  }
  for (Statement& statement : all) {
    statement.file = file;
    statement.line = line;
  }
  return all;
}

}  // namespace carom::conformance
