// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdio>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

namespace carom::conformance {

/// Forwards to another printer, but writes the last lines itself. These lines count skipped tests, and list failed
/// tests last.
class ClosingLines : public testing::TestEventListener {
 public:
  explicit ClosingLines(testing::TestEventListener* printer) : printer_(printer) {}

  void OnTestProgramStart(const testing::UnitTest& program) override { printer_->OnTestProgramStart(program); }
  void OnTestIterationStart(const testing::UnitTest& program, int iteration) override {
    printer_->OnTestIterationStart(program, iteration);
  }
  void OnEnvironmentsSetUpStart(const testing::UnitTest& program) override {
    printer_->OnEnvironmentsSetUpStart(program);
  }
  void OnEnvironmentsSetUpEnd(const testing::UnitTest& program) override { printer_->OnEnvironmentsSetUpEnd(program); }
  void OnTestSuiteStart(const testing::TestSuite& suite) override { printer_->OnTestSuiteStart(suite); }
  void OnTestStart(const testing::TestInfo& test) override { printer_->OnTestStart(test); }
  void OnTestPartResult(const testing::TestPartResult& result) override { printer_->OnTestPartResult(result); }
  void OnTestEnd(const testing::TestInfo& test) override { printer_->OnTestEnd(test); }
  void OnTestSuiteEnd(const testing::TestSuite& suite) override { printer_->OnTestSuiteEnd(suite); }
  void OnEnvironmentsTearDownStart(const testing::UnitTest& program) override {
    printer_->OnEnvironmentsTearDownStart(program);
  }
  void OnEnvironmentsTearDownEnd(const testing::UnitTest& program) override {
    printer_->OnEnvironmentsTearDownEnd(program);
  }
  void OnTestIterationEnd(const testing::UnitTest& program, int /*iteration*/) override {
    std::printf("[==========] %d tests from %d test suites ran. (%lld ms total)\n", program.test_to_run_count(),
                program.test_suite_to_run_count(), static_cast<long long>(program.elapsed_time()));
    std::printf("[  PASSED  ] %d tests.\n", program.successful_test_count());
    if (program.skipped_test_count() > 0) {
      std::printf("[  SKIPPED ] %d tests, each with its reason above.\n", program.skipped_test_count());
    }
    if (program.reportable_disabled_test_count() > 0) {
      std::printf("[ DISABLED ] %d tests.\n", program.reportable_disabled_test_count());
    }
    if (program.failed_test_count() > 0) {
      std::printf("[  FAILED  ] %d tests, listed below:\n", program.failed_test_count());
      print_failed(program);
    }
    if (program.ad_hoc_test_result().Failed()) {
      std::printf("[  FAILED  ] a failure outside of all tests\n");
    }
    std::fflush(stdout);
  }
  void OnTestProgramEnd(const testing::UnitTest& program) override { printer_->OnTestProgramEnd(program); }

 private:
  static void print_failed(const testing::UnitTest& program) {
    for (int s = 0; s < program.total_test_suite_count(); ++s) {
      const testing::TestSuite& suite = *program.GetTestSuite(s);
      for (int t = 0; t < suite.total_test_count(); ++t) {
        const testing::TestInfo& test = *suite.GetTestInfo(t);
        if (test.should_run() && test.result()->Failed()) {
          std::printf("[  FAILED  ] %s.%s\n", test.test_suite_name(), test.name());
        }
      }
      if (suite.ad_hoc_test_result().Failed()) {
        std::printf("[  FAILED  ] %s: its SetUpTestSuite or TearDownTestSuite\n", suite.name());
      }
    }
  }

  std::unique_ptr<testing::TestEventListener> printer_;
};

/// Replaces GoogleTest's printer by ClosingLines, after the flags have chosen the printer. Does nothing if there is no
/// printer, or with the flag `brief`.
class ClosingLinesInPlace : public testing::Environment {
 public:
  void SetUp() override {
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    if (testing::TestEventListener* const printer = listeners.default_result_printer();
        printer != nullptr && !GTEST_FLAG_GET(brief)) {
      listeners.Append(new ClosingLines(listeners.Release(printer)));
    }
  }
};

}  // namespace carom::conformance
