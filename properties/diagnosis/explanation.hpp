// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {

/// The hypotheses that explain the wrong outcomes of a subject. A subject with several faults makes some mistakes alone
/// and some together.
struct Explanation {
  std::vector<Hypothesis> found;
  /// For each case, the indices in `found` of the fewest hypotheses that together explain the answer. Empty if none do.
  std::vector<std::vector<std::size_t>> by;
  /// For each case, those hypotheses of `by` without which no other hypotheses, as few, explain the answer.
  std::vector<std::vector<std::size_t>> needed;
};

/// Finds a hypothesis that explains many answers, takes out the answers that it explains, and explains the others anew.
/// An answer that one hypothesis does not explain may have several of the mistakes. Precondition: the answers are
/// visibly off. `known` are hypotheses about the subject that other evidence shows; they are the first of the found
/// ones. After the first hypothesis, the next ones explain an answer only within rounding (`rounding_distance`).
/// `right` are cases with right answers. Of two hypotheses that explain as many answers, the one wins that is wrong in
/// fewer of them.
[[nodiscard]] Explanation explanation_of(std::span<const KnownCase> wrong, double unit_roundoff,
                                         std::vector<Hypothesis> known = {}, std::span<const KnownCase> right = {});

/// The size of the impulse is wrong in each answer, and its direction is right.
[[nodiscard]] Hypothesis impulses_of_any_size();

}  // namespace carom::properties::diagnosis
