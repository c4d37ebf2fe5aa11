// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include <carom/properties/diagnosis/known_case.hpp>

namespace carom::properties::diagnosis {

/// What a wrong solver may be doing: the right law on another collision than was asked, or the right impulse put to a
/// wrong use. It explains an outcome where that is the hypothesis's own.
struct Hypothesis {
  std::string as_if;    // "the lever arms of both bodies began at the world's origin"
  std::string look_at;  // the place in a solver that does this
  /// What it answers; none where it does not apply.
  std::function<std::optional<Outcome<double>>(const KnownCase&)> answer;
};

/// In the order in which they are preferred where several explain the same.
[[nodiscard]] std::span<const Hypothesis> all_hypotheses();

/// Whether the hypothesis answers as the subject did, to a thousandth of what that is off by.
[[nodiscard]] bool explains(const Hypothesis& hypothesis, const KnownCase& one);

}  // namespace carom::properties::diagnosis
