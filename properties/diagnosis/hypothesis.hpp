// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <carom/properties/diagnosis/known_case.hpp>
#include <carom/properties/diagnosis/steps.hpp>

namespace carom::properties::diagnosis {

/// A possible fault of a solver: it applies the law to another collision, or misuses the right impulse.
struct Hypothesis {
  std::string as_if;    // "the lever arms of both bodies began at the world's origin"
  std::string look_at;  // the place in a solver to check
  /// A solver with this fault makes one of these mistakes. Without any, the fault changes only the size of the impulse.
  std::vector<Mistake> mistakes;
  /// The size of the impulse with this fault; empty if the mistakes alone determine it.
  std::optional<FittedSize> size = {};
};

/// All hypotheses without a fitted size. If several explain an outcome, the first one is preferred.
[[nodiscard]] std::span<const Hypothesis> all_hypotheses();

/// The outcome of a solver that makes the first mistake of the hypothesis. No value if the mistake does not apply.
/// Precondition: the hypothesis has a mistake and no fitted size.
[[nodiscard]] std::optional<Outcome<double>> answer_of(const Hypothesis& hypothesis, const KnownCase& one);

/// Whether the hypotheses together give the subject's answer, within a thousandth of the subject's error. A solver with
/// several faults makes a mistake of each.
[[nodiscard]] bool explains(std::span<const Hypothesis* const> together, const KnownCase& one);
[[nodiscard]] bool explains(const Hypothesis& hypothesis, const KnownCase& one);

// The groups of the hypotheses, one file each.
[[nodiscard]] std::vector<Hypothesis> misused_impulses();
[[nodiscard]] std::vector<Hypothesis> misread_contacts();
[[nodiscard]] std::vector<Hypothesis> misread_bodies();

}  // namespace carom::properties::diagnosis
