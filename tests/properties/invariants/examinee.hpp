// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <carom/properties/trial/trial.hpp>

namespace carom::properties {

/// What a test puts its questions to: a built-in solver in its precision, or the same solver text in ℚ.
struct Examinee {
  std::string name;  // fit for a GoogleTest name
  Model model = Model::any;
  oracles::Yardstick yardstick;
  ExactSolve solve;
  bool shows_matrix = false;
};

/// How GoogleTest prints it.
inline void PrintTo(const Examinee& examinee, std::ostream* out) { *out << examinee.name; }

/// The built-in solvers that claim to be right, in float, double and long double (built_in_examinees.cpp).
[[nodiscard]] std::vector<Examinee> built_in_examinees();

/// The solver texts in rational arithmetic, with no rounding allowed (exact_examinees.cpp).
[[nodiscard]] std::vector<Examinee> exact_examinees();

/// The same claim by a subject that returns its input unchanged. It keeps most laws, so it tests none of them.
[[nodiscard]] Examinee idle(Examinee examinee);

/// The same claim by a subject that obeys no law: it answers every collision, valid or not, with velocities drawn by
/// chance, and shows twenty times K or −K. The same collision has the same answer.
[[nodiscard]] Examinee erratic(Examinee examinee);

/// The same claim by a subject whose answers are no numbers.
[[nodiscard]] Examinee without_numbers(Examinee examinee);

}  // namespace carom::properties
