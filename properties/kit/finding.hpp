// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/properties/kit/examination.hpp>
#include <carom/properties/kit/falsified.hpp>
#include <carom/rapidcheck.hpp>

namespace carom::conformance {

/// Tests a statement on cases that RapidCheck draws. `name` is the name of the test.
[[nodiscard]] inline Finding find(const Statement& statement, const std::string& name = {}) {
  if (const auto without_test = finding_without_test(statement)) {
    return *without_test;
  }
  Examination examination(statement);
  static_cast<void>(falsified(name, [&] { RC_ASSERT(examination.holds(*gen::cases(draw_of(statement)))); }));
  return examination.finding(name);
}

}  // namespace carom::conformance
