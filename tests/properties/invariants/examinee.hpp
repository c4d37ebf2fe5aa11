// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <carom/properties/trial/trial.hpp>

namespace carom::properties {

/// A built-in solver in its precision, or the same solver in ℚ.
struct Examinee {
  std::string name;  // valid as a GoogleTest name
  Law law = Law::any;
  oracles::Yardstick yardstick = oracles::Yardstick::of_exact_arithmetic();
  ExactSolve solve;
  bool shows_matrix = false;
};

inline void PrintTo(const Examinee& examinee, std::ostream* out) { *out << examinee.name; }

/// The sound built-in solvers in float, double and long double.
[[nodiscard]] std::vector<Examinee> built_in_examinees();

/// The solvers in rational arithmetic. Their allowance is zero.
[[nodiscard]] std::vector<Examinee> exact_examinees();

/// The examinee, with a solver that keeps the velocities. Such outcomes satisfy most invariants, but test none of them.
[[nodiscard]] Examinee idle(Examinee examinee);

/// The examinee, with a solver that obeys no law. It answers every collision, even an invalid one, with random
/// velocities, and shows twenty times the collision matrix or its negative. Equal collisions get equal answers.
[[nodiscard]] Examinee erratic(Examinee examinee);

/// The examinee, with answers that are NaN or infinite.
[[nodiscard]] Examinee without_numbers(Examinee examinee);

}  // namespace carom::properties
