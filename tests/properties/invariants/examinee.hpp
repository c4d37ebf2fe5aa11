// SPDX-License-Identifier: GPL-3.0-or-later
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

/// The same claim by a subject that returns its input unchanged: what no test may pass.
[[nodiscard]] Examinee idle(Examinee examinee);

}  // namespace carom::properties
