// SPDX-License-Identifier: BSL-1.0
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include <carom/properties/conformance/closing_lines.hpp>
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
  if (!statement.error.empty()) {
    ADD_FAILURE_AT(statement.file, statement.line) << statement.error;
    return;
  }
  const Finding finding = find(statement);
  if (finding.status == properties::Status::violated) {
    ADD_FAILURE_AT(statement.file, statement.line) << finding.text << how_to_repeat();
  } else if (finding.status == properties::Status::skipped) {
    GTEST_SKIP() << finding.text;
  }
}

[[maybe_unused]] const testing::Environment* const closing_lines =
    testing::AddGlobalTestEnvironment(new ClosingLinesInPlace);

/// RapidCheck's reader says neither which variable it is nor what is expected.
void require_rapidcheck_parameters() {
  try {
    (void)properties::rapidcheck_parameters(1);
  } catch (const std::exception& error) {
    throw std::invalid_argument(std::string("RC_PARAMS: expected RapidCheck's parameters, as in seed=7: ") +
                                error.what());
  }
}

}  // namespace

std::vector<Statement> suite(const char* file, int line, const std::function<std::vector<Statement>()>& make) {
  std::vector<Statement> all;
  try {
    require_rapidcheck_parameters();
    all = make();
  } catch (const std::exception& error) {
    all = {Statement{nullptr, nullptr, nullptr, {}, 0, file, line, error.what()}};
  }
  for (Statement& statement : all) {
    statement.file = file;
    statement.line = line;
  }
  return all;
}

}  // namespace carom::conformance
