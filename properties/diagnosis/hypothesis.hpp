// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {

/// A possible fault of a solver: it applies the law to another collision, or misuses the right impulse.
struct Hypothesis {
  std::string as_if;    // "the lever arms of both bodies began at the world's origin"
  std::string look_at;  // the place in a solver to check
  /// The outcome of a solver with this fault. No value if the hypothesis does not apply.
  std::function<std::optional<Outcome<double>>(const KnownCase&)> answer;
};

/// All hypotheses. If several explain an outcome, the first one is preferred.
[[nodiscard]] std::span<const Hypothesis> all_hypotheses();

/// Whether the hypothesis gives the subject's answer, within a thousandth of the subject's error.
[[nodiscard]] bool explains(const Hypothesis& hypothesis, const KnownCase& one);

}  // namespace carom::properties::diagnosis
