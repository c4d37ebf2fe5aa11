// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/laws/judge_error.hpp>

namespace carom::oracles {

/// Whether x and y certainly differ. T is exact, or a number with an error bound: `sign()` is its sign, or no value if
/// the bound does not decide it.
template <class T>
[[nodiscard]] bool certainly_differ(const T& x, const T& y) {
  if constexpr (requires { x.sign().has_value(); }) {
    return T(x - y).sign().value_or(0) != 0;
  } else {
    return x != y;
  }
}

/// Whether x is certainly less than y. T is as in `certainly_differ`.
template <class T>
[[nodiscard]] bool is_certainly_less(const T& x, const T& y) {
  if constexpr (requires { x.sign().has_value(); }) {
    return T(x - y).sign().value_or(0) < 0;
  } else {
    return x < y;
  }
}

/// The first equation that defines the law and that the outcome certainly violates; nullptr if there is none. T is
/// as in `certainly_differ`, and `c` is the collision in T. Precondition: the law is one of `laws_with_truth`.
template <class T>
[[nodiscard]] const char* first_refuted(const Collision& collision, const BasicCollision<T>& c, Law law,
                                        ContactState approach, const Outcome<T>& outcome) {
  const char* first = nullptr;
  for_each_defining_equation(collision, law, approach, [&](const char* name, const auto& equation) {
    const auto sides = equation(c, outcome);
    for (Eigen::Index i = 0; i < sides.left.size() && first == nullptr; ++i) {
      first = certainly_differ<T>(sides.left[i], sides.right[i]) ? name : nullptr;
    }
  });
  return first;
}

/// Throws a JudgeError if a check has refuted a truth. `refuted` is what the truth does not satisfy, or nullptr.
inline void throw_if_refuted(const char* refuted, const char* truth, const Collision& collision) {
  if (refuted != nullptr) {
    throw JudgeError(std::string(truth) + " does not satisfy " + refuted, collision);
  }
}

/// Checks exactly that an outcome satisfies the equations that define the law. Throws a JudgeError that names the first
/// equation whose sides differ. T is an exact field; `nearest_double` of a T gives the binary64 number that it was
/// lifted from. Precondition: that of `first_refuted`.
template <class T>
void certify(const BasicCollision<T>& c, Law law, ContactState approach, const Outcome<T>& outcome) {
  const Collision collision = map_numbers<double>(c, [](const T& x) { return nearest_double(x); });
  throw_if_refuted(first_refuted(collision, c, law, approach, outcome), "the truth", collision);
}

}  // namespace carom::oracles
