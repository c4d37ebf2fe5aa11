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

/// A check of an examinee (a solver under test, examinee.hpp) on one case.
using Question = std::function<Verdict(const Examinee&, const JudgedCase&)>;

/// The check of one invariant. Outside the invariant's domain, its verdict is skipped.
[[nodiscard]] Question invariant_holds(const Invariant& invariant);

struct Examination {
  std::uint64_t cases = 0;  // for each family
  /// Whether to include the family `structured`. Its sizes underflow in binary32, so checks that compare bits leave it
  /// out.
  bool structured = true;
  std::span<const Family> families = all_families();
};

/// Checks an examinee on one head-on collision and on cases of every family. Returns a message if one of these is true:
/// - The verdict is violated on a case.
/// - The verdict is skipped on all cases of the families.
/// - All answers to colliding cases of the families keep the velocities.
[[nodiscard]] std::optional<std::string> find_violation(const Examinee& examinee, const Question& question,
                                                        const Examination& examination);

struct Claimant {
  Examinee examinee;
  std::vector<const Invariant*> invariants;
};

struct Seen {
  bool responded = false;                     // an answer to a colliding case of a family changed the velocities
  std::set<const Invariant*> in_domain = {};  // invariants that held for a case of a family
  std::set<const Invariant*> violated = {};   // invariants that were violated, and are not tested again
};

/// Draws the cases of `find_violation` once, for all claimants. The results are in the claimants' order.
[[nodiscard]] std::vector<Seen> examine(std::span<const Claimant> claimants, const Examination& examination);

/// Returns what `find_violation` returns for one invariant of a claimant, by the results of `examine`. To show a
/// violation, draws the cases again.
[[nodiscard]] std::optional<std::string> found_by(const Seen& seen, const Claimant& claimant,
                                                  const Invariant& invariant, const Examination& examination);

}  // namespace carom::properties
