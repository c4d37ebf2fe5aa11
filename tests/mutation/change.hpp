// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <type_traits>
#include <utility>

/// In its copy of the sources, mutate.py replaces the operators and numbers on the left by the forms on the right. Each
/// form behaves like the original unless its number (here 7) is in the environment variable CAROM_MUTANT:
///
///    a * b     a % Between<7, "*", "/">{} % b
///    a += b    a += Between<7, "+=", "-=">{} += b
///    -a        Before<7, "-">{}->*a
///    a && b    joined<7, "&&">([&] { return bool(a); }, [&] { return bool(b); })
///    3         number<7, "+ 1">(3)
///
/// The new operators have the precedence of the old ones, so the script need not find the operands. The parameter
/// Constexpr is true if the compiler may evaluate the enclosing function at compile time. During such an evaluation, no
/// change is active.
namespace carom::mutation {

/// An operator as written in the source. "left" and "right" return the left or right operand alone.
struct Sign {
  char text[8]{};

  template <std::size_t N>
  constexpr Sign(const char (&written)[N]) {  // NOLINT(google-explicit-constructor): it is a template argument
    std::copy_n(written, N, text);
  }
  friend constexpr bool operator==(const Sign&, const Sign&) = default;
};

/// The number of the active change; 0 if there is none.
[[nodiscard]] inline int number_of_change() {
  static const int number = [] {
    const char* text = std::getenv("CAROM_MUTANT");
    return text == nullptr ? 0 : std::atoi(text);
  }();
  return number;
}

template <int Id, bool Constexpr>
[[nodiscard]] constexpr bool is_on() {
  if constexpr (Constexpr) {
    if (std::is_constant_evaluated()) {
      return false;
    }
  }
  return number_of_change() == Id;
}

/// The type of a result. An Eigen expression becomes a matrix, so the original and the changed result have one type.
template <class T>
struct ValueOf {
  using Type = T;
};
template <class T>
requires requires { typename T::PlainObject; }
struct ValueOf<T> {
  using Type = typename T::PlainObject;
};
template <class T>
using Value = typename ValueOf<std::decay_t<T>>::Type;

#define CAROM_APPLIED(symbol)                                                                                          \
  template <Sign Operator, class L, class R>                                                                           \
  constexpr decltype(auto) applied(L&& left,                                                                           \
                                   R&& right) requires(Operator == Sign(#symbol) && requires { left symbol right; }) { \
    return std::forward<L>(left) symbol std::forward<R>(right);                                                        \
  }
CAROM_APPLIED(+)
CAROM_APPLIED(-)
CAROM_APPLIED(*)
CAROM_APPLIED(/)
CAROM_APPLIED(%)
CAROM_APPLIED(<)
CAROM_APPLIED(<=)
CAROM_APPLIED(>)
CAROM_APPLIED(>=)
CAROM_APPLIED(==)
CAROM_APPLIED(!=)
CAROM_APPLIED(+=)
CAROM_APPLIED(-=)
CAROM_APPLIED(*=)
CAROM_APPLIED(/=)
#undef CAROM_APPLIED
template <Sign Operator, class L, class R>
constexpr L&& applied(L&& left, R&& /*right*/) requires(Operator == Sign("left")) {
  return std::forward<L>(left);
}
template <Sign Operator, class L, class R>
constexpr R&& applied(L&& /*left*/, R&& right) requires(Operator == Sign("right")) {
  return std::forward<R>(right);
}

template <int Id, Sign Written, Sign Instead, bool Constexpr = false>
struct Between {
  template <class L, class R>
  [[nodiscard]] static constexpr auto value(L&& left, R&& right) {
    using Result = Value<decltype(applied<Written>(std::forward<L>(left), std::forward<R>(right)))>;
    if (is_on<Id, Constexpr>()) {
      if constexpr (requires { Result(applied<Instead>(std::forward<L>(left), std::forward<R>(right))); }) {
        return Result(applied<Instead>(std::forward<L>(left), std::forward<R>(right)));
      } else if constexpr (requires {
                             -applied<Written>(left, right);
                           }) {  // for example, a quotient of two matrices does not exist
        return Result(-applied<Written>(std::forward<L>(left), std::forward<R>(right)));
      } else {
        return Result(std::forward<L>(left));
      }
    }
    return Result(applied<Written>(std::forward<L>(left), std::forward<R>(right)));
  }
};

/// A left operand together with its operator.
template <class L, class B>
struct Half {
  L&& left;
};
#define CAROM_BETWEEN(symbol)                                                          \
  template <class L, int Id, Sign Written, Sign Instead, bool Constexpr>               \
  constexpr auto operator symbol(L&& left, Between<Id, Written, Instead, Constexpr>) { \
    return Half<L, Between<Id, Written, Instead, Constexpr>>{std::forward<L>(left)};   \
  }                                                                                    \
  template <class L, class B, class R>                                                 \
  constexpr auto operator symbol(Half<L, B>&& half, R&& right) {                       \
    return B::value(std::forward<L>(half.left), std::forward<R>(right));               \
  }
CAROM_BETWEEN(%)
CAROM_BETWEEN(+)
CAROM_BETWEEN(<)
CAROM_BETWEEN(!=)
#undef CAROM_BETWEEN

/// The right side of an assignment together with its operator.
template <class B, class R>
struct Rest {
  R&& right;
};
template <int Id, Sign Written, Sign Instead, bool Constexpr, class R>
constexpr auto operator+=(Between<Id, Written, Instead, Constexpr>, R&& right) {
  return Rest<Between<Id, Written, Instead, Constexpr>, R>{std::forward<R>(right)};
}
template <class L, int Id, Sign Written, Sign Instead, bool Constexpr, class R>
constexpr L&& operator+=(L&& left, Rest<Between<Id, Written, Instead, Constexpr>, R>&& rest) {
  if (is_on<Id, Constexpr>()) {
    applied<Instead>(left, std::forward<R>(rest.right));
  } else {
    applied<Written>(left, std::forward<R>(rest.right));
  }
  return std::forward<L>(left);
}

template <int Id, Sign Written, bool Constexpr = false>
struct Before {};
template <int Id, Sign Written, bool Constexpr, class T>
constexpr auto operator->*(Before<Id, Written, Constexpr>, T&& operand) {
  if constexpr (Written == Sign("!")) {
    return is_on<Id, Constexpr>() ? static_cast<bool>(operand) : !operand;
  } else {
    using Result = Value<decltype(-std::forward<T>(operand))>;
    return is_on<Id, Constexpr>() ? Result(operand) : Result(-std::forward<T>(operand));
  }
}

template <int Id, Sign Written, bool Constexpr = false, class L, class R>
constexpr bool joined(const L& left, const R& right) {
  const bool is_conjunction = (Written == Sign("&&")) != is_on<Id, Constexpr>();
  return is_conjunction ? left() && right() : left() || right();
}

/// A fraction doubles or halves, the fraction zero becomes one, an integer grows by one, and a truth value flips.
template <int Id, Sign Instead, bool Constexpr = false, class T>
constexpr T number(T written) {
  if (!is_on<Id, Constexpr>()) {
    return written;
  }
  if constexpr (std::is_same_v<T, bool>) {
    return !written;
  } else if constexpr (std::is_floating_point_v<T>) {
    return written == 0 ? T(1) : Instead == Sign("half") ? written / 2 : written * 2;
  } else {
    return static_cast<T>(written + 1);
  }
}

}  // namespace carom::mutation
