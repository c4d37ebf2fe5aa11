// SPDX-License-Identifier: BSL-1.0
#pragma once

// The parts of C++20 that the judge uses and libc++ 13 lacks. Each file of the WebAssembly build includes them first.
//
// The C++ standard leaves it undefined to add these declarations to namespace std. The sources use the names std::…,
// and the native build takes them from its library. A namespace of the project would change every such source. The
// folder serves one library only, in which all of these names are free: libc++ 13 of Debian 12's emscripten 3.1.6. For
// a newer library, delete what it has from this folder, run the tests of the WebAssembly build, and change the number
// below.
#include <algorithm>
#include <cctype>
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

#if !defined(__EMSCRIPTEN__) || !defined(_LIBCPP_VERSION) || _LIBCPP_VERSION != 13000
#error "src/web/old_library extends namespace std, and is tested with libc++ 13 of Debian 12's emscripten only"
#endif

namespace std {

template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>) [[nodiscard]] To
    bit_cast(const From& from) noexcept {
  To to;
  memcpy(&to, &from, sizeof to);
  return to;
}

/// Reads a decimal number, "inf" or "nan".
inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format = chars_format::general) {
  const string text(first, last);
  // strtod also reads white space, a plus sign and hexadecimal digits.
  if (text.empty() || isspace(static_cast<unsigned char>(text[0])) != 0 || text[0] == '+' ||
      text.find_first_of("xX") != string::npos) {
    return {first, errc::invalid_argument};
  }
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
