// SPDX-License-Identifier: BSL-1.0
#pragma once

// The parts of C++20 that the judge uses and libc++ 13 lacks. Each file of the WebAssembly build includes them first.
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
namespace std {

template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>) [[nodiscard]] To
    bit_cast(const From& from) noexcept {
  To to;
  memcpy(&to, &from, sizeof to);
  return to;
}

/// Reads what strtod reads. Precondition: the text begins neither with white space nor with '+'.
inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format = chars_format::general) {
  const string text(first, last);
  char* end = nullptr;
  errno = 0;
  const double number = strtod(text.c_str(), &end);
  if (end == text.c_str()) {
    return {first, errc::invalid_argument};
  }
  const char* const after = first + (end - text.c_str());
  if (errno == ERANGE && (number == 0 || isinf(number))) {
    return {after, errc::result_out_of_range};
  }
  value = number;
  return {after, errc()};
}

}  // namespace std

#include "range_algorithms.hpp"
#endif
