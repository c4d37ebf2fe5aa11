// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/conformance.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/kit/finding.hpp>

namespace carom::conformance {
namespace {

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

struct Place {
  const char* file;
  int line;
};

std::string name_of_this_test() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test.test_suite_name()) + '.' + test.name();
}

void show(const Finding& finding, const Place& place) {
  if (finding.status == properties::Status::violated) {
    ADD_FAILURE_AT(place.file, place.line)
        << finding.text << "  this test alone: --gtest_filter=" << name_of_this_test();
  } else if (finding.status == properties::Status::skipped) {
    GTEST_SKIP() << finding.text;
  }
}

/// Shows a fault of the judge as one, with its collision.
void show_finding(const Place& place, const std::function<Finding()>& finding) {
  try {
    show(finding(), place);
  } catch (const oracles::JudgeError& error) {
    ADD_FAILURE_AT(place.file, place.line) << properties::in_words(error);
  }
}

class Conformance : public testing::Test {
 public:
  explicit Conformance(std::function<void()> body) : body_(std::move(body)) {}
  void TestBody() override { body_(); }

 private:
  std::function<void()> body_;
};

void add_test(const std::string& suite, const std::string& name, const std::string& about, const Place& place,
              const std::function<void()>& body) {
  testing::RegisterTest(suite.c_str(), name.c_str(), nullptr, about.c_str(), place.file, place.line,
                        [body]() -> Conformance* { return new Conformance(body); });
}

}  // namespace

bool add_suite(const char* name, const char* file, int line, const std::function<std::vector<Statement>()>& make) {
  // GoogleTest owns the environment.
  [[maybe_unused]] static const testing::Environment* const closing_lines =
      testing::AddGlobalTestEnvironment(new ClosingLinesInPlace);
  const std::string tests = std::string(name) + "/Conformance";
  const Place place{file, line};
  try {
    const std::vector<Statement> all = make();
    for (const Statement& statement : all) {
      add_test(tests, "Holds/" + name_of(statement), in_words(statement), place,
               [statement, place] { show_finding(place, [&] { return find(statement, name_of_this_test()); }); });
    }
    // It comes last, because the other tests show which invariants are judged.
    add_test(tests, "JudgesEachInvariant", "", place,
             [all, place] { show_finding(place, [&] { return finding_of_judged(all, name_of_this_test()); }); });
  } catch (const std::exception& error) {
    add_test(tests, "Holds/options", "", place,
             [place, why = std::string(error.what())] { ADD_FAILURE_AT(place.file, place.line) << why; });
  }
  return true;
}

}  // namespace carom::conformance
