// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iostream>
#include <sstream>
#include <string>
#include <utility>

#include <rapidcheck.h>

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

}  // namespace carom::conformance
