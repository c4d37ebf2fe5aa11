// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <carom/properties/trial/trial.hpp>

namespace carom::properties {

/// The subject of a test: a built-in solver in its precision, or the same solver in ℚ.
struct Examinee {
  std::string name;  // valid as a GoogleTest name
  Law law = Law::any;
  oracles::Yardstick yardstick;
  ExactSolve solve;
  bool shows_matrix = false;
};

inline void PrintTo(const Examinee& examinee, std::ostream* out) { *out << examinee.name; }

/// The sound built-in solvers, in float, double and long double (built_in_examinees.cpp).
[[nodiscard]] std::vector<Examinee> built_in_examinees();

/// The solvers in rational arithmetic, with an allowance of zero (exact_examinees.cpp).
[[nodiscard]] std::vector<Examinee> exact_examinees();

/// The same examinee, but its solver returns the input unchanged. This satisfies most laws, and tests none of them.
[[nodiscard]] Examinee idle(Examinee examinee);

/// The same examinee, but its solver obeys no law. It answers every collision, valid or not, with random velocities,
/// and reports twenty times K or −K. The same collision always gets the same answer.
[[nodiscard]] Examinee erratic(Examinee examinee);

/// The same examinee, but its answers are NaN or infinite.
[[nodiscard]] Examinee without_numbers(Examinee examinee);

}  // namespace carom::properties
