// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/oracles/laws/equations.hpp>
#include <carom/oracles/laws/judge_error.hpp>

namespace carom::oracles {

/// The first equation that defines the law and whose sides differ exactly; nullptr if the outcome satisfies all. T is
/// an exact field. Precondition: the law is one of `laws_with_truth`.
template <class T>
[[nodiscard]] const char* first_unsatisfied(const BasicCollision<T>& collision, Law law, ContactState approach,
                                            const Outcome<T>& outcome) {
  const char* first = nullptr;
  for_each_defining_equation(collision, law, approach, [&](const char* name, const auto& equation) {
    const auto sides = equation(collision, outcome);
    for (Eigen::Index i = 0; i < sides.left.size() && first == nullptr; ++i) {
      first = sides.left[i] != sides.right[i] ? name : nullptr;
    }
  });
  return first;
}

/// The first equation that defines the law and that the outcome certainly violates; nullptr if there is none. T is a
/// number with an error bound: `sign()` is its sign, or no value if the bound does not decide it. `enclosed` is the
/// collision in T. Precondition: that of `first_unsatisfied`.
template <class T>
[[nodiscard]] const char* first_refuted(const Collision& collision, const BasicCollision<T>& enclosed, Law law,
                                        ContactState approach, const Outcome<T>& outcome) {
  const char* first = nullptr;
  for_each_defining_equation(collision, law, approach, [&](const char* name, const auto& equation) {
    const auto sides = equation(enclosed, outcome);
    for (Eigen::Index i = 0; i < sides.left.size() && first == nullptr; ++i) {
      first = T(sides.left[i] - sides.right[i]).sign().value_or(0) != 0 ? name : nullptr;
    }
  });
  return first;
}

/// Throws the JudgeError of a truth that does not satisfy `what`. `nearest_double` of a T gives the binary64 number
/// that it was lifted from.
template <class T>
[[noreturn]] void fail_to_certify(const BasicCollision<T>& collision, const std::string& truth, const char* what) {
  throw JudgeError(truth + " does not satisfy " + what,
                   map_numbers<double>(collision, [](const T& x) { return nearest_double(x); }));
}

/// Checks exactly that an outcome satisfies the equations that define the law. Throws a JudgeError that names the first
/// equation whose sides differ. Precondition: that of `first_unsatisfied`.
template <class T>
void certify(const BasicCollision<T>& collision, Law law, ContactState approach, const Outcome<T>& outcome) {
  if (const char* const name = first_unsatisfied(collision, law, approach, outcome)) {
    fail_to_certify(collision, "the truth", name);
  }
}

}  // namespace carom::oracles
