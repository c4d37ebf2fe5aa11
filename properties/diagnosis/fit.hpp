// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>

#include <carom/properties/diagnosis/steps.hpp>

namespace carom::properties::diagnosis {

/// A quantity that a solver may replace by a constant, and that an answer shows.
enum class Fit {
  added_restitution,  // the number that is added to ε
  length_of_impulse,  // ‖F‖ [N s]
};

/// A fit, and its value in a solver. Without a value, the solver uses a new one for each collision.
struct FittedSize {
  Fit fit;
  std::optional<double> value;
};

/// The value with which the steps give the subject's answer, within a thousandth of the subject's error. No value if
/// there is none.
[[nodiscard]] std::optional<double> fitted(Fit fit, const Steps& steps, const KnownCase& one);

/// Whether the steps with this size give the subject's answer, within a thousandth of the subject's error.
[[nodiscard]] bool gives_answer(const FittedSize& size, const Steps& steps, const KnownCase& one);

/// Whether two fitted values are equal within a thousandth.
[[nodiscard]] bool agree(double x, double y);

}  // namespace carom::properties::diagnosis
