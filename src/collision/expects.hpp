// SPDX-License-Identifier: BSL-1.0
#pragma once

/// CAROM_EXPECTS(condition, values…) states a precondition. If the condition is false, a checked build prints the
/// place, the condition and the values, and aborts. Any other build does not evaluate the condition.
///
/// A build is checked if CAROM_CHECK_PRECONDITIONS is 1, or if neither this macro nor NDEBUG is defined. All units of a
/// program that share inline functions of Carom must agree, by the one-definition rule: an installed library of a
/// default build has 0. Only precondition_tests mixes, and relies on a linker that keeps the first copy.
#ifndef CAROM_CHECK_PRECONDITIONS
#ifdef NDEBUG
#define CAROM_CHECK_PRECONDITIONS 0
#else
#define CAROM_CHECK_PRECONDITIONS 1
#endif
#endif

#if CAROM_CHECK_PRECONDITIONS

#include <cstdlib>
#include <iostream>
#include <limits>
#include <type_traits>

namespace carom::detail {

/// Whether the condition holds. True for a comparison of SIMD packs, because lanes that do not collide may hold
/// meaningless numbers. Also true for a comparison of numbers with error bounds, because the bounds may not decide it.
template <class Condition>
[[nodiscard]] constexpr bool holds(const Condition& condition) {
  if constexpr (std::is_constructible_v<bool, const Condition&>) {
    return static_cast<bool>(condition);
  } else {
    return true;
  }
}

/// Prints a value by its name, its components or its operator<<, otherwise "?".
template <class T>
void print_value(std::ostream& out, const T& value) {
  if constexpr (requires { name_of(value); }) {
    out << name_of(value);
  } else if constexpr (requires {
                         typename T::Scalar;
                         value.coeff(0);
                       }) {
    out << '(';
    for (decltype(value.size()) i = 0; i < value.size(); ++i) {
      out << (i == 0 ? "" : ", ");
      print_value(out, value.coeff(i));
    }
    out << ')';
  } else if constexpr (requires { out << value; }) {
    out << value;
  } else {
    out << '?';
  }
}

template <class... Values>
[[noreturn, gnu::cold, gnu::noinline]] void end_at_precondition(const char* file, int line, const char* function,
                                                                const char* condition, const char* names,
                                                                const Values&... values) {
  std::ostream& out = std::cerr;
  out.precision(std::numeric_limits<long double>::max_digits10);
  out << file << ':' << line << ": " << function << ": violated precondition: " << condition;
  if constexpr (sizeof...(values) > 0) {
    out << "\n  " << names << ':';
    ((out << ' ', print_value(out, values)), ...);
  }
  out << std::endl;
  std::abort();
}

}  // namespace carom::detail

#define CAROM_EXPECTS(condition, ...)                                                                             \
  (::carom::detail::holds(condition)                                                                              \
       ? static_cast<void>(0)                                                                                     \
       : ::carom::detail::end_at_precondition(__FILE__, __LINE__, static_cast<const char*>(__func__), #condition, \
                                              #__VA_ARGS__ __VA_OPT__(, ) __VA_ARGS__))

#else

#define CAROM_EXPECTS(condition, ...) static_cast<void>(sizeof((condition)))

#endif
