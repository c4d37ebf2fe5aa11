// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iostream>
#include <sstream>
#include <string>
#include <utility>

#include <rapidcheck.h>

#include <carom/properties/kit/examination.hpp>
#include <carom/rapidcheck.hpp>

namespace carom::conformance {

/// Whether RapidCheck falsifies `property`. Discards RapidCheck's text about this property.
template <class Property>
[[nodiscard]] bool falsified(const std::string& name, Property&& property) {
  // The first check makes RapidCheck read RC_PARAMS and print the seed, or end the program if RC_PARAMS is wrong.
  static const bool has_read_parameters = rc::check([] {});
  std::ostringstream kept_back;
  struct Usual {
    std::streambuf* const buffer;
    ~Usual() { std::cerr.rdbuf(buffer); }
  } const usual{std::cerr.rdbuf(kept_back.rdbuf())};
  return has_read_parameters && !rc::check(name, std::forward<Property>(property));
}

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
