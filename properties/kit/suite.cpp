// SPDX-License-Identifier: BSL-1.0
#include <exception>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/kit/closing_lines.hpp>
#include <carom/properties/kit/finding.hpp>
#include <carom/properties/kit/suite.hpp>

namespace carom::conformance {
namespace {

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
