// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <carom/properties/families/family.hpp>

#include "examinee.hpp"

namespace carom::properties {

/// A test on one case: the verdict on an examinee.
using Question = std::function<Verdict(const Examinee&, const JudgedCase&)>;

/// The verdict of one invariant. It is skipped outside the invariant's domain.
[[nodiscard]] Question invariant_holds(const Invariant& invariant);

struct Examination {
  std::uint64_t cases = 0;  // for each family
  /// Whether `structured` is among the families. Its sizes underflow in binary32, so questions about bits have no
  /// meaning there.
  bool structured = true;
  std::span<const Family> families = all_families();
};

/// Asks an examinee about cases of every family, and about one head-on collision. Returns an objection in words in
/// three cases:
/// - A case violates the question.
/// - No family's case is in the question's domain.
/// - No answer to a family's colliding case changes the velocities.
[[nodiscard]] std::optional<std::string> find_violation(const Examinee& examinee, const Question& question,
                                                        const Examination& examination);

struct Claimant {
  Examinee examinee;
  std::vector<const Invariant*> invariants;
};

/// The results of a claimant on all cases.
struct Seen {
  bool responded = false;                     // in a colliding case of a family, the answer changed the velocities
  std::set<const Invariant*> in_domain = {};  // these held in some case of a family
  std::set<const Invariant*> violated = {};   // these were violated in some case, and are not tested again
};

/// Draws the cases of `find_violation` once, for all claimants. The results are in the claimants' order.
[[nodiscard]] std::vector<Seen> examine(std::span<const Claimant> claimants, const Examination& examination);

/// The return value of `find_violation` for one invariant of a claimant, from the results of `examine`. Draws the cases
/// again to show a violation.
[[nodiscard]] std::optional<std::string> found_by(const Seen& seen, const Claimant& claimant,
                                                  const Invariant& invariant, const Examination& examination);

}  // namespace carom::properties
